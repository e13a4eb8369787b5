package org.cellgauge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.cellgauge.cell.CameraReader;
import org.cellgauge.cli.Main;
import org.cellgauge.geometry.PinholeCamera;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** Calibrations from real photos (P. Abeles, CC BY 4.0), where they are beside the checkout. */
class CalibrationPhotosTest {
    @TempDir
    private Path scratch;

    private PinholeCamera calibrated(String target, List<String> photos, StringWriter out, String... more) {
        Path camera = scratch.resolve("made").resolve("camera.yaml");
        List<String> words = new ArrayList<>(List.of("calibrate", "--target", target, "--out", camera.toString()));
        words.addAll(List.of(more));
        words.addAll(photos);
        StringWriter err = new StringWriter();
        CommandLine command = Main.commandLine().setOut(new PrintWriter(out)).setErr(new PrintWriter(err));
        assertEquals(0, command.execute(words.toArray(String[]::new)), err.toString());
        return CameraReader.read(camera);
    }

    /** The focal lengths published with these photos, by BoofCV with two radial coefficients. */
    @Test
    void chessboardGivesThePublishedFocalLength() throws IOException {
        Path photos = RealPhotosTest.folder("calibration_sony_chess");
        Path target = Files.writeString(scratch.resolve("target.yaml"),
                "cellgauge_target: 1\nchessboard: {rows: 7, columns: 5, square_mm: 30}\n");
        StringWriter out = new StringWriter();
        PinholeCamera camera = calibrated(target.toString(), List.of(photos.toString()), out);
        PinholeCamera published = CameraReader.read(photos.resolve("intrinsic.yaml"));
        assertEquals(published.get(PinholeCamera.FX), camera.get(PinholeCamera.FX), 0.005 * 701);
        assertEquals(published.get(PinholeCamera.FY), camera.get(PinholeCamera.FY), 0.005 * 699);
        assertTrue(out.toString().contains("13 photos, 312 corners"), out.toString());
        assertTrue(Files.readString(scratch.resolve("made").resolve("camera.yaml")).contains("cellgauge_calibration:"));
        assertTrue(Files.readString(scratch.resolve("made").resolve("camera.html")).contains("<svg"));
    }

    /**
     * OpenCV 5.0's calibrateCamera on the same corners with k1, k2, p1, p2 (outliers in), positions of pixels
     * half a pixel apart: 348.69, 349.46, 306.11, 184.91.
     */
    @Test
    void ecoCheckAgreesWithOpenCv() throws IOException {
        Path photos = RealPhotosTest.folder("calibration_zed_ecocheck");
        List<String> some;
        try (Stream<Path> files = Files.list(photos)) {
            some = files.map(Path::toString).filter(n -> n.endsWith(".jpg")).sorted().toList();
        }
        PinholeCamera camera = calibrated(photos.resolve("calibration_target.yaml").toString(), some,
                new StringWriter(), "--lens", "brown-4", "--warp", "0", "--aspect", "stated");
        double[] openCv = {348.69, 349.46, 306.11, 184.91};
        for (int k = 0; k < openCv.length; k++) {
            assertEquals(openCv[k], camera.get(k), 0.3);
        }
    }
}
