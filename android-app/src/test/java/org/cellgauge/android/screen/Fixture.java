package org.cellgauge.android.screen;

import java.awt.image.BufferedImage;
import java.awt.image.Raster;
import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import javax.imageio.ImageIO;
import org.cellgauge.android.files.CellDocument;
import org.cellgauge.android.files.Photo;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.vision.GreyImage;

/** A rendered scene of the project's fixtures: its cell, and its photo read past Android. */
final class Fixture {
    static final Fixture LIFTED = new Fixture("lifted-4");

    private final File folder;
    private final String name;

    Fixture(String name) {
        this.name = name;
        this.folder = new File(System.getProperty("cellgauge.root"), "fixtures/" + name);
    }

    Cell cell() {
        return CellReader.read(new File(folder, "cell.yaml").toPath());
    }

    /** The cell as a document that states its camera. */
    CellDocument document() {
        return document(cell());
    }

    CellDocument document(Cell cell) {
        return new CellDocument(name + ".yaml", "content://cells/" + name, cell, cell.camera());
    }

    /** The same with corner noise of another size, and with another target. */
    static Cell with(Cell cell, double pixelStdPx, OptionalDouble targetStdMm) {
        return new Cell(cell.camera(), cell.family(), cell.references(), cell.objects(), OptionalDouble.of(pixelStdPx),
                targetStdMm);
    }

    /**
     * The same cell with reference 22 stated 25 mm off in y, without corner noise, and with an object 77 that is not
     * in the photo.
     */
    Cell doubtful() {
        Cell cell = cell();
        List<Reference> references = new ArrayList<>();
        for (Reference r : cell.references()) {
            double[] at = r.worldFromMarker().translationMm();
            at[1] += r.id() == 22 ? 25 : 0;
            references.add(new Reference(r.id(), r.sizeMm(), RigidTransform.of(r.worldFromMarker().rotation(), at),
                    r.placement()));
        }
        List<ObjectMarker> objects = new ArrayList<>(cell.objects());
        objects.add(new ObjectMarker(77, 47, null));
        return new Cell(cell.camera(), cell.family(), references, objects, OptionalDouble.empty(), cell.targetStdMm());
    }

    Photo photo() {
        return new Photo(name + ".png", image());
    }

    GreyImage image() {
        try {
            BufferedImage read = ImageIO.read(new File(folder, "photo.png"));
            Raster raster = read.getRaster();
            byte[] grey = new byte[read.getWidth() * read.getHeight()];
            for (int y = 0; y < read.getHeight(); y++) {
                for (int x = 0; x < read.getWidth(); x++) {
                    grey[y * read.getWidth() + x] = (byte) raster.getSample(x, y, 0);
                }
            }
            return GreyImage.packed(grey, read.getWidth(), read.getHeight());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** A picture of the same size that shows nothing. */
    GreyImage blank() {
        GreyImage image = image();
        byte[] grey = new byte[image.widthPx() * image.heightPx()];
        Arrays.fill(grey, (byte) 120);
        return GreyImage.packed(grey, image.widthPx(), image.heightPx());
    }
}
