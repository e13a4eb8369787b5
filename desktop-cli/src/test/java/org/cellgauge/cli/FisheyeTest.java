package org.cellgauge.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.desktop.render.CellSimulation;
import org.cellgauge.desktop.render.SceneTruth;
import org.cellgauge.desktop.render.Sensor;
import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.estimate.PoseEstimate;
import org.cellgauge.geometry.KannalaBrandtLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.geometry.Rotations;
import org.cellgauge.internal.overlay.CellOverlay;
import org.cellgauge.internal.overlay.Overlay;
import org.cellgauge.internal.overlay.Polyline;
import org.cellgauge.internal.overlay.Role;
import org.cellgauge.internal.overlay.Shape;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.BoofMarkerDetector;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A cell under a fisheye, from rendering to the picture over the photo; one reference stands beyond a right angle. */
class FisheyeTest {
    private static final String YAML = "cellgauge: 1\n"
            + "camera:\n"
            + "  model: kannala_brandt\n"
            + "  pinhole: {fx: 210, fy: 211, cx: 402, cy: 299, width: 800, height: 600}\n"
            + "  symmetric: [1, -0.012, 0.006, -0.004, 0.0005]\n"
            + "markers: {family: square-binary, size_mm: 120}\n"
            + "placement: {std_mm: [1, 1, 1], std_deg: 0.2}\n"
            + "references:\n"
            + "  944: {position_mm: [1000, 700, 0]}\n"
            + "  1234: {position_mm: [0, 700, 0]}\n"
            + "  911: {position_mm: [1000, 0, 0]}\n"
            + "  22: {position_mm: [0, 0, 0]}\n"
            + "  77: {position_mm: [1150, 350, 450], rotation_deg: [0, -90, 0], size_mm: 150}\n"
            + "objects:\n"
            + "  5: {size_mm: 250}\n"
            + "  30: {}\n";
    private static final RigidTransform WORLD_FROM_CAMERA = RigidTransform.ofEuler(520, 330, 450, 3.08, 0.10, 0.02);
    private static final Map<Integer, RigidTransform> OBJECTS = Map.of(
            5, RigidTransform.ofEuler(480, 400, 0, 0, 0, 0.4),
            30, RigidTransform.ofEuler(1150, 620, 300, 0, -1.2, 0.7));
    /** 99.9 % of chi-square with 6 degrees of freedom. */
    private static final double CHI_SQUARE_6 = 22.46;

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2})
    void truthIsWhereTheCheckSaysAndThePictureLiesOnThePixels(int index) {
        Cell cell = CellReader.read(YAML, "cell.yaml", name -> {
            throw new IllegalStateException();
        });
        PinholeCamera camera = cell.camera();
        CellSimulation.Photo photo = new CellSimulation(cell, WORLD_FROM_CAMERA, OBJECTS,
                new CellSimulation.Settings(21, true, 0, 0, 0, 0.2)).photo(index, Sensor.USUAL);
        RigidTransform cameraFromWorld = WORLD_FROM_CAMERA.inverse();
        double[] far = cameraFromWorld.apply(1150, 350, 450);
        assertTrue(far[2] < 0, "a reference is behind the plane of the camera");

        Detections found = BoofMarkerDetector.forCell(cell).detect(photo.image(), "fisheye.png");
        double squares = 0;
        int coordinates = 0;
        for (SceneTruth.MarkerInImage truth : SceneTruth.of(photo.scene())) {
            MarkerObservation marker = found.find(truth.id());
            assertNotNull(marker, "marker " + truth.id() + " was not found: " + found.warnings());
            for (int i = 0; i < 8; i++) {
                squares += Math.pow(marker.cornersPx()[i] - truth.cornersPx()[i / 2][i % 2], 2);
                coordinates++;
            }
        }
        assertEquals(56, coordinates);
        double rms = Math.sqrt(squares / coordinates);
        assertTrue(rms < 0.04, "corners are off by " + rms + " px rms");

        CheckResult result = CellCheck.run(cell, found, CheckSettings.builder().iterations(700).seed(index).build());
        assertInRegion("camera", WORLD_FROM_CAMERA, result.estimate().camera());
        for (ObjectEstimate object : result.estimate().objects()) {
            assertInRegion("object " + object.id(), OBJECTS.get(object.id()), object.pose());
        }

        Overlay overlay = CellOverlay.of(result);
        double[] origin = cameraFromWorld.apply(0, 0, 0);
        Polyline axis = (Polyline) overlay.shapes(Role.WORLD_AXIS_X).get(0);
        double[] start = {axis.pointsPx()[0], axis.pointsPx()[1]};
        assertArrayEquals(camera.project(origin[0], origin[1], origin[2]), start, 2);
        double sag = 0;
        for (Shape shape : overlay.shapes(Role.WORLD_GRID)) {
            sag = Math.max(sag, sag(((Polyline) shape).pointsPx()));
        }
        assertTrue(sag > 20, "lines of the wall bend with the lens, not by " + sag + " px");
        assertEquals(KannalaBrandtLens.MODEL, camera.lens());
    }

    /** How far the points of a line are off the straight one between its ends. */
    private static double sag(double[] p) {
        int end = p.length - 2;
        double du = p[end] - p[0];
        double dv = p[end + 1] - p[1];
        double length = Math.hypot(du, dv);
        double largest = 0;
        for (int i = 0; i < p.length && length > 0; i += 2) {
            largest = Math.max(largest, Math.abs((p[i] - p[0]) * dv - (p[i + 1] - p[1]) * du) / length);
        }
        return largest;
    }

    private static void assertInRegion(String name, RigidTransform truth, PoseEstimate found) {
        double[] error = new double[6];
        double[] turn = new double[9];
        Rotations.multiplyTransposed(truth.rotation(), found.meanTransform().rotation(), turn);
        Rotations.log(turn, error, 3);
        for (int i = 0; i < 3; i++) {
            error[i] = truth.translationMm()[i] - found.mean()[i];
        }
        double[] factor = new double[36];
        for (int i = 0; i < 36; i++) {
            factor[i] = found.tangentCovariance()[i / 6][i % 6];
        }
        assertTrue(Cholesky.factor(factor, 6), name);
        Cholesky.solveLower(factor, 6, error);
        double squares = 0;
        for (double e : error) {
            squares += e * e;
        }
        assertTrue(squares < CHI_SQUARE_6, name + " is off by chi-square " + squares);
        for (int i = 0; i < 3; i++) {
            assertTrue(found.std()[i] < 3, name + " is known to " + found.std()[i] + " mm");
        }
    }
}
