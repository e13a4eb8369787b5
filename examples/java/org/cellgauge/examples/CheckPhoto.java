package org.cellgauge.examples;

import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ColorConvertOp;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import javax.imageio.ImageIO;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.BoofMarkerDetector;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.GreyImage;

/** Checks one photo and prints where its objects are, how certain that is, and the verdict. */
public final class CheckPhoto {
    private CheckPhoto() {
    }

    /**
     * Runs the example.
     *
     * @param args the cell file and the photo
     * @throws IOException if the photo cannot be read
     */
    public static void main(String... args) throws IOException {
        BufferedImage photo = ImageIO.read(Path.of(args[1]).toFile());
        byte[] luminance = luminance(photo);

        // README: from here
        Cell cell = CellReader.read(Path.of(args[0]));
        GreyImage image = GreyImage.packed(luminance, photo.getWidth(), photo.getHeight());
        Detections detections = BoofMarkerDetector.forCell(cell).detect(image, "photo");
        CheckResult result = CellCheck.run(cell, detections, CheckSettings.builder().seed(1).build());

        System.out.println(result.verdict() + ": " + result.reason());
        for (ObjectEstimate object : result.estimate().objects()) {
            double[] mean = object.pose().mean();       // x, y, z in mm in the world, then angles in rad
            double[] std = object.pose().std();
            System.out.printf(Locale.ROOT, "object %d: x %.2f y %.2f z %.2f mm, std %.2f %.2f %.2f mm%n", object.id(),
                    mean[0], mean[1], mean[2], std[0], std[1], std[2]);
        }
        // README: to here
    }

    /** Grey values row by row; of a grey photo its own, without a detour through colours. */
    private static byte[] luminance(BufferedImage photo) {
        BufferedImage grey = photo;
        if (photo.getRaster().getNumBands() != 1) {
            grey = new BufferedImage(photo.getWidth(), photo.getHeight(), BufferedImage.TYPE_BYTE_GRAY);
            new ColorConvertOp(ColorSpace.getInstance(ColorSpace.CS_GRAY), null).filter(photo, grey);
        }
        int[] samples = grey.getRaster().getSamples(0, 0, grey.getWidth(), grey.getHeight(), 0, (int[]) null);
        byte[] luminance = new byte[samples.length];
        for (int i = 0; i < samples.length; i++) {
            luminance[i] = (byte) samples[i];
        }
        return luminance;
    }
}
