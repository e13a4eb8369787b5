package org.cellgauge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.cellgauge.cell.CameraReader;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.cli.ImageFiles;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.pose.MarkerPoseFinder;
import org.cellgauge.vision.BoofMarkerDetector;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Real photos (P. Abeles, CC BY 4.0), read from {@code shared/data/boofcv} beside the checkout where they are there.
 */
class RealPhotosTest {
    private static final double SIZE_MM = 100;

    private static Path folder(String name) {
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

    /** Over the film these photos are from, the distance measured 135.0 mm with a spread of 0.36 mm. */
    @ParameterizedTest
    @ValueSource(strings = {"image0000.jpg", "image0001.jpg", "image0002.jpg"})
    void centresOfTwoMarkersLieAsFarApartAsMeasured(String name) {
        Path folder = folder("fiducial_binary");
        PinholeCamera camera = CameraReader.read(folder.resolve("intrinsic.yaml"));
        Detections found = detect(folder.resolve(name), camera, "square-binary", List.of(284, 643, 944, 22));
        assertEquals(2, found.markers().size(), "no marker that is not there");
        double[] a = centre(found.find(284), camera);
        double[] b = centre(found.find(643), camera);
        double distance = Math.sqrt(Math.pow(a[0] - b[0], 2) + Math.pow(a[1] - b[1], 2) + Math.pow(a[2] - b[2], 2));
        System.out.printf("%s: %.2f mm%n", name, distance);
        assertEquals(135.0, distance, 2);
    }

    private static double[] centre(MarkerObservation marker, PinholeCamera camera) {
        assertNotNull(marker);
        RigidTransform cameraFromMarker = MarkerPoseFinder.best(marker.cornersPx(), SIZE_MM, camera);
        return cameraFromMarker.translationMm();
    }

    @Test
    void hammingMarkersAreFound() {
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
        assertTrue(tilted.markers().stream().anyMatch(m -> m.shortestSidePx() < 25));
    }

    private static void assertCorner(MarkerObservation marker, double u, double v) {
        assertNotNull(marker);
        assertEquals(u, marker.cornersPx()[0], 3);
        assertEquals(v, marker.cornersPx()[1], 3);
    }
}
