package org.cellgauge.android.probe;

import java.io.IOException;
import java.io.InputStream;
import java.util.Map;
import java.util.Properties;
import java.util.function.Function;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.internal.overlay.CellOverlay;
import org.cellgauge.internal.overlay.Shape;
import org.cellgauge.internal.vision.BoofThreads;
import org.cellgauge.output.ResultJson;
import org.cellgauge.output.ResultRecord;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Estimate;
import org.cellgauge.vision.BoofMarkerDetector;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.DetectionsFile;
import org.cellgauge.vision.GreyImage;

/**
 * A way into the library that shrinking leaves open: detection and a whole check behind types that every Java has, so
 * that shrunk and unshrunk code can be asked the same. It is kept in the class files made for tests and is no part of
 * an APK.
 */
public final class CheckProbe implements Function<Map<String, Object>, String> {

    /**
     * Detects, checks and draws.
     *
     * @param input {@code cell} and {@code camera}, the texts of the two files; {@code luminance}, the image's bytes,
     *     row by row; {@code width} and {@code height} in px; {@code preset}, {@code default}, {@code focal} or
     *     {@code thesis}
     * @return every figure in every digit: detections file, result file, overlay; or what was refused and why
     */
    @Override
    public String apply(Map<String, Object> input) {
        BoofThreads.useOne();
        StringBuilder out = new StringBuilder();
        try {
            Cell cell = CellReader.read((String) input.get("cell"), "cell.yaml", name -> (String) input.get("camera"));
            GreyImage image = GreyImage.packed((byte[]) input.get("luminance"), (Integer) input.get("width"),
                    (Integer) input.get("height"));
            Detections detections = BoofMarkerDetector.forCell(cell).detect(image, "photo.png");
            DetectionsFile.write(detections, out);
            CheckResult result = CellCheck.run(cell, detections, settings((String) input.get("preset")));
            out.append(ResultJson.of(result, ResultRecord.of("photo.png", null, version())));
            for (Shape shape : CellOverlay.of(result).shapes()) {
                out.append(shape.role()).append(' ').append(shape.status());
                for (double[] stroke : shape.strokes()) {
                    for (double coordinate : stroke) {
                        out.append(' ').append(coordinate);
                    }
                }
                out.append('\n');
            }
        } catch (InputRefusedException e) {
            out.append("refused: ").append(e.getMessage());
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
        return out.toString();
    }

    private static CheckSettings settings(String preset) {
        switch (preset) {
            case "default":
                return CheckSettings.builder().build();
            case "focal":
                return CheckSettings.builder().estimate(Estimate.FOCAL).build();
            case "thesis":
                return CheckSettings.thesis().build();
            default:
                throw new IllegalArgumentException(preset);
        }
    }

    private static String version() throws IOException {
        try (InputStream in = CheckProbe.class.getResourceAsStream("/org/cellgauge/version.properties")) {
            Properties properties = new Properties();
            properties.load(in);
            return properties.getProperty("version");
        }
    }
}
