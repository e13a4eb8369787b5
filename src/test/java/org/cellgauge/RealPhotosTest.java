package org.cellgauge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.cellgauge.cell.CameraReader;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.cli.Main;
import org.cellgauge.desktop.ImageFiles;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.internal.pose.MarkerPoseFinder;
import org.cellgauge.vision.BoofMarkerDetector;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Real photos (P. Abeles, CC BY 4.0), read from {@code shared/data/boofcv} beside the checkout where they are there.
 */
class RealPhotosTest {
    private static final double SIZE_MM = 100;
    @TempDir
    private Path scratch;

    static Path folder(String name) {
        Path from = Path.of(System.getProperty("cellgauge.root", ".")).toAbsolutePath().normalize();
        for (Path p = from; p != null; p = p.getParent()) {
            Path folder = p.resolve("shared/data/boofcv").resolve(name);
            if (Files.isDirectory(folder)) {
                return folder;
            }
        }
        Assumptions.abort("no shared/data/boofcv/" + name + " beside the checkout");
        throw new IllegalStateException();
    }

    private static Detections detect(Path photo, PinholeCamera camera, String family, List<Integer> ids) {
        return new BoofMarkerDetector(camera, MarkerFamily.of(family), ids).detect(ImageFiles.read(photo),
                photo.getFileName().toString());
    }

    /**
     * Over the film these photos are from, the distance measured 135.0 mm with a spread of 0.36 mm. One marker is taken
     * as a reference that stands exactly in the origin; where the other is then stated to be, and how precisely, rests
     * on nothing but the photo.
     */
    @ParameterizedTest
    @ValueSource(strings = {"image0000.jpg", "image0001.jpg", "image0002.jpg"})
    void centresOfTwoMarkersLieAsFarApartAsMeasured(String name) throws IOException {
        Path photos = folder("fiducial_binary");
        Files.copy(photos.resolve("intrinsic.yaml"), scratch.resolve("camera.yaml"));
        Path cell = Files.writeString(scratch.resolve("cell.yaml"), "cellgauge: 1\ncamera: camera.yaml\n"
                + "markers: {family: square-binary, size_mm: 100}\n"
                + "placement: {std_mm: [0.001, 0.001, 0.001], std_deg: 0.001}\n"
                + "references:\n  284: {position_mm: [0, 0, 0]}\nobjects:\n  643: {}\n");
        PinholeCamera camera = CameraReader.read(photos.resolve("intrinsic.yaml"));
        Detections found = detect(photos.resolve(name), camera, "square-binary", List.of(284, 643, 944, 22));
        assertEquals(2, found.markers().size(), "no marker that is not there");

        StringWriter out = new StringWriter();
        StringWriter err = new StringWriter();
        int code = Main.commandLine().setOut(new PrintWriter(out)).setErr(new PrintWriter(err))
                .execute("check", "--cell", cell.toString(), photos.resolve(name).toString(), "--json");
        assertEquals(0, code, out + "\n" + err);
        JsonObject result = JsonParser.parseString(out.toString()).getAsJsonObject();
        JsonObject pose = result.getAsJsonObject("objects").getAsJsonObject("643").getAsJsonObject("pose");
        double[] mean = new double[3];
        double distance = 0;
        for (int i = 0; i < 3; i++) {
            mean[i] = pose.getAsJsonArray("mean").get(i).getAsDouble();
            distance = Math.hypot(distance, mean[i]);
        }
        double variance = 0;
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                variance += mean[i] / distance * mean[j] / distance
                        * pose.getAsJsonArray("covariance").get(i).getAsJsonArray().get(j).getAsDouble();
            }
        }
        JsonObject noise = result.getAsJsonObject("noise");
        JsonObject edges = result.getAsJsonObject("edges");
        System.out.printf("%s: %.2f mm, std %.2f; edges %+.3f px, std %.3f; added noise %.3f px (%.3f to %.3f)%n",
                name, distance, Math.sqrt(variance), edges.get("shift_px").getAsDouble(),
                edges.get("shift_std_px").getAsDouble(), noise.get("added_std_px_q50").getAsDouble(),
                noise.get("added_std_px_q2_5").getAsDouble(), noise.get("added_std_px_q97_5").getAsDouble());
        printSquareness(name, found, camera, SIZE_MM, noise.get("added_std_px_q50").getAsDouble());
        assertEquals(135.0, distance, 0.5);
        assertEquals(135.0, distance, 2 * Math.sqrt(variance));
    }

    /** The three photos together, and a check of one of them by what they found. */
    @Test
    void surveyOfAllPhotosSaysHowFarTheyLieApart() throws IOException {
        Path photos = folder("fiducial_binary");
        Files.copy(photos.resolve("intrinsic.yaml"), scratch.resolve("camera.yaml"));
        Path cell = Files.writeString(scratch.resolve("cell.yaml"), "cellgauge: 1\ncamera: camera.yaml\n"
                + "markers: {family: square-binary, size_mm: 100}\n"
                + "placement: {std_mm: [0.001, 0.001, 0.001], std_deg: 0.001}\nreferences:\n"
                + "  284: {position_mm: [0, 0, 0]}\n"
                + "  643: {position_mm: [133, 24, 0], rotation_deg: [0, 0, -160], "
                + "placement: {std_mm: [20, 20, 20], std_deg: 20}}\n");
        Path surveyed = scratch.resolve("surveyed.yaml");
        JsonObject survey = run("survey", "--cell", cell.toString(), photos.resolve("image0000.jpg").toString(),
                photos.resolve("image0001.jpg").toString(), photos.resolve("image0002.jpg").toString(), "--out",
                surveyed.toString(), "--json");
        JsonObject distance = survey.getAsJsonArray("distances").get(0).getAsJsonObject();
        double mm = distance.get("mm").getAsDouble();
        double std = distance.get("std_mm").getAsDouble();
        assertEquals(135.0, mm, 2 * std);
        assertTrue(std < 0.2, "std " + std);
        double alone = run("check", "--cell", cell.toString(), photos.resolve("image0001.jpg").toString(), "--json")
                .getAsJsonObject("camera").getAsJsonArray("std").get(2).getAsDouble();
        double with = run("check", "--cell", surveyed.toString(), photos.resolve("image0001.jpg").toString(), "--json")
                .getAsJsonObject("camera").getAsJsonArray("std").get(2).getAsDouble();
        System.out.printf("survey: %.2f mm, std %.2f; a camera's z %.2f mm as stated, %.2f as surveyed%n", mm, std,
                alone, with);
        assertTrue(with < 0.9 * alone, with + " of " + alone);
    }

    private static JsonObject run(String... arguments) {
        StringWriter out = new StringWriter();
        StringWriter err = new StringWriter();
        int code = Main.commandLine().setOut(new PrintWriter(out)).setErr(new PrintWriter(err)).execute(arguments);
        assertEquals(0, code, out + "\n" + err);
        return JsonParser.parseString(out.toString()).getAsJsonObject();
    }

    /** What the markers of a photo say of themselves: apart from 6 numbers of a pose, 8 coordinates leave two. */
    private static void printSquareness(String name, Detections found, PinholeCamera camera, double sizeMm,
            double addedStdPx) {
        double alone = 0;
        double with = 0;
        StringBuilder rms = new StringBuilder();
        for (MarkerObservation marker : found.markers()) {
            double[] unit = new double[64];
            double[] covariance = marker.covariancePx2();
            double[] more = covariance.clone();
            double trace = 0;
            for (int i = 0; i < 8; i++) {
                unit[9 * i] = 1;
                trace += covariance[9 * i] / 8;
                more[9 * i] += addedStdPx * addedStdPx;
            }
            rms.append(String.format(" %d: %.3f (fit says %.3f)", marker.id(),
                    Math.sqrt(squareness(marker, camera, sizeMm, unit) / 2), Math.sqrt(trace)));
            alone += squareness(marker, camera, sizeMm, covariance) / 2 / found.markers().size();
            with += squareness(marker, camera, sizeMm, more) / 2 / found.markers().size();
        }
        System.out.printf("  %s %s, blur %.2f px, noise %.1f; off squares by px rms%s; chi-square per degree of "
                + "freedom %.1f by the fit, %.2f with %.3f px added%n", name, found.light().toneCurve().words(),
                found.light().blurPx(), found.light().noiseGrey(), rms, alone, with, addedStdPx);
    }

    /** Chi-square of what no pose explains of a marker's corners: 2 degrees of freedom (Gauss-Newton, two steps). */
    private static double squareness(MarkerObservation marker, PinholeCamera camera, double sizeMm,
            double[] covariance) {
        double[] lower = covariance.clone();
        assertTrue(Cholesky.factor(lower, 8), "the covariance is positive definite");
        RigidTransform pose = new MarkerPoseFinder().best(marker.cornersPx(), sizeMm, camera);
        double[] p = new double[6];
        double chiSquare = Double.NaN;
        for (int step = 0; step < 4; step++) {
            double[] r = whitened(lower, marker, camera, sizeMm, pose, p);
            chiSquare = 0;
            double[][] j = new double[6][];
            double[] normal = new double[36];
            double[] right = new double[6];
            for (int a = 0; a < 6; a++) {
                double h = a < 3 ? 1e-3 : 1e-6;
                double[] q = p.clone();
                q[a] += h;
                j[a] = whitened(lower, marker, camera, sizeMm, pose, q);
                for (int i = 0; i < 8; i++) {
                    j[a][i] = (j[a][i] - r[i]) / h;
                }
            }
            for (int i = 0; i < 8; i++) {
                chiSquare += r[i] * r[i];
                for (int a = 0; a < 6; a++) {
                    right[a] -= j[a][i] * r[i];
                    for (int b = 0; b < 6; b++) {
                        normal[6 * a + b] += j[a][i] * j[b][i];
                    }
                }
            }
            assertTrue(Cholesky.factor(normal, 6), "the pose is determined");
            solve(normal, 6, right);
            for (int a = 0; a < 6; a++) {
                p[a] += right[a];
            }
        }
        return chiSquare;
    }

    private static double[] whitened(double[] lower, MarkerObservation marker, PinholeCamera camera, double sizeMm,
            RigidTransform pose, double[] p) {
        RigidTransform moved = pose.compose(RigidTransform.ofEuler(p[0], p[1], p[2], p[3], p[4], p[5]));
        double[] at = MarkerGeometry.cornersMm(moved, sizeMm);
        double[] r = marker.cornersPx();
        for (int k = 0; k < 4; k++) {
            double[] uv = camera.project(at[3 * k], at[3 * k + 1], at[3 * k + 2]);
            r[2 * k] -= uv[0];
            r[2 * k + 1] -= uv[1];
        }
        for (int i = 0; i < 8; i++) {
            for (int k = 0; k < i; k++) {
                r[i] -= lower[8 * i + k] * r[k];
            }
            r[i] /= lower[9 * i];
        }
        return r;
    }

    /** Solves L L' x = b in place. */
    private static void solve(double[] lower, int n, double[] b) {
        for (int i = 0; i < n; i++) {
            for (int k = 0; k < i; k++) {
                b[i] -= lower[n * i + k] * b[k];
            }
            b[i] /= lower[n * i + i];
        }
        for (int i = n - 1; i >= 0; i--) {
            for (int k = i + 1; k < n; k++) {
                b[i] -= lower[n * k + i] * b[k];
            }
            b[i] /= lower[n * i + i];
        }
    }

    @Test
    void hammingMarkersAreFound() throws IOException {
        Path folder = folder("aruco_25h7");
        PinholeCamera camera = CameraReader.read(folder.resolve("intrinsic.yaml"));
        Detections near = detect(folder.resolve("image01.jpg"), camera, "aruco-mip-25h7", List.of(0, 4, 10, 1, 7));
        assertEquals(3, near.markers().size());
        // read off the photo by eye: the top-left corner of each marker in its own frame
        assertCorner(near.find(0), 430, 125);
        assertCorner(near.find(4), 279, 402);
        assertCorner(near.find(10), 219, 164);
        Detections tilted = detect(folder.resolve("image03.jpg"), camera, "aruco-mip-25h7", List.of(0, 4, 10));
        assertEquals(3, tilted.markers().size());
        Files.copy(folder.resolve("intrinsic.yaml"), scratch.resolve("camera.yaml"));
        Cell cell = CellReader.read(Files.writeString(scratch.resolve("cell.yaml"), "cellgauge: 1\n"
                + "camera: camera.yaml\nmarkers: {family: aruco-mip-25h7, size_mm: 100}\n"
                + "placement: {std_mm: [1, 1, 1], std_deg: 1}\n"
                + "references:\n  0: {position_mm: [0, 0, 0]}\nobjects:\n  4: {}\n  10: {}\n"));
        for (Detections found : List.of(near, tilted)) {
            double added = CornerErrors.of(cell, found).squarenessBelief().quantileStdPx(0.5);
            printSquareness(found.imageName(), found, camera, SIZE_MM, added);
        }
        assertTrue(tilted.markers().stream().anyMatch(m -> m.shortestSidePx() < 25));
    }

    private static void assertCorner(MarkerObservation marker, double u, double v) {
        assertNotNull(marker);
        assertEquals(u, marker.cornersPx()[0], 3);
        assertEquals(v, marker.cornersPx()[1], 3);
    }
}
