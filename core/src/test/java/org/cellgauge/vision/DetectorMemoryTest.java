package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import boofcv.alg.fiducial.square.FoundFiducial;
import boofcv.struct.image.GrayU8;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import javax.imageio.ImageIO;
import org.cellgauge.Allocated;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.vision.BoofThreads;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** What a detector takes of the memory, behind a lens that distorts strongly. */
class DetectorMemoryTest {
    private static final Path SCENE = Path.of(System.getProperty("cellgauge.root")).resolve("fixtures/distorted-4");
    private static final long MB = 1_000_000;

    /** All on this thread, and what is loaded and made once for all detectors beforehand. */
    @BeforeAll
    static void prepare() throws IOException {
        BoofThreads.useOne();
        BoofMarkerDetector.forCell(cell()).detect(photo(), "first");
    }

    private static Cell cell() {
        return CellReader.read(SCENE.resolve("cell.yaml"));
    }

    private static GreyImage photo() throws IOException {
        BufferedImage picture = ImageIO.read(SCENE.resolve("photo.png").toFile());
        return GreyImage.packed(((DataBufferByte) picture.getRaster().getDataBuffer()).getData(), picture.getWidth(),
                picture.getHeight());
    }

    /** The photo in another size, and below it grey where it is not high enough. */
    private static GreyImage enlarged(GreyImage photo, int widthPx, int heightPx) {
        double scale = widthPx / (double) photo.widthPx();
        byte[] grey = new byte[widthPx * heightPx];
        Arrays.fill(grey, (byte) 128);
        for (int y = 0; (y + 0.5) / scale < photo.heightPx() && y < heightPx; y++) {
            for (int x = 0; x < widthPx; x++) {
                grey[y * widthPx + x] = (byte) Math.round(photo.interpolate((x + 0.5) / scale, (y + 0.5) / scale));
            }
        }
        return GreyImage.packed(grey, widthPx, heightPx);
    }

    /** The cell as a camera of more pixels sees it. */
    private static Cell seenBy(int widthPx, int heightPx) {
        PinholeCamera camera = cell().camera();
        int sameShapePx = widthPx * camera.heightPx() / camera.widthPx();
        return cell().withCamera(
                PinholeCamera.of(widthPx, heightPx, camera.resized(widthPx, sameShapePx).intrinsics()));
    }

    private static List<List<Double>> squares(GreyImage photo, Cell cell, boolean tables) {
        SquareSearch squares = BoofMarkerDetector.squares(cell.family());
        squares.configure(BoofMarkerDetector.boofLens(cell.camera()), photo.widthPx(), photo.heightPx(), tables);
        GrayU8 view = new GrayU8(photo.widthPx(), photo.heightPx());
        view.data = photo.luminance();
        squares.process(view);
        List<List<Double>> found = new ArrayList<>();
        for (int i = 0; i < squares.found().size(); i++) {
            FoundFiducial square = squares.found().get(i);
            List<Double> corners = new ArrayList<>(List.of((double) square.id));
            for (int k = 0; k < 4; k++) {
                corners.add(square.distortedPixels.get(k).x);
                corners.add(square.distortedPixels.get(k).y);
            }
            found.add(corners);
        }
        return found;
    }

    @Test
    void aTabulatedLensShowsTheSameSquares() throws IOException {
        List<List<Double>> found = squares(photo(), cell(), false);
        assertTrue(found.size() >= 7, "squares " + found.size());
        assertEquals(squares(photo(), cell(), true), found);
    }

    @Test
    void aFrameOfFullHdTakesFewBytesAPixel() throws IOException {
        GreyImage frame = enlarged(photo(), 1920, 1080);
        Cell cell = seenBy(1920, 1080);
        List<Detections> found = new ArrayList<>();
        long bytes = Allocated.bytes(() -> found.add(BoofMarkerDetector.forFrames(cell).detect(frame, "frame")));
        assertEquals(7, found.get(0).markers().size());
        // with tables of the lens 120
        assertTrue(bytes < 10 * MB, bytes + " bytes");
    }

    @Test
    void aPhotoOf12MegapixelsTakesFewBytesAPixel() throws IOException {
        GreyImage photo = enlarged(photo(), 4000, 3000);
        Cell cell = seenBy(4000, 3000);
        List<Detections> found = new ArrayList<>();
        long bytes = Allocated.bytes(() -> found.add(BoofMarkerDetector.forCell(cell).detect(photo, "photo")));
        assertEquals(7, found.get(0).markers().size());
        // with tables of the lens 690; dark pixels are kept as bits as well as bytes
        assertTrue(bytes < 45 * MB, bytes + " bytes");
    }
}
