package org.cellgauge.desktop.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.junit.jupiter.api.Test;

class CellSimulationTest {
    private static final RigidTransform ABOVE = RigidTransform.ofEuler(0, 0, 1000, Math.PI, 0, 0);
    private static final RigidTransform NOMINAL = RigidTransform.ofEuler(100, 50, 0, 0.2, -0.1, 0.7);

    private static Cell cell(int widthPx, int heightPx) {
        // the markers lie outside the tiny image: drawing a thousand photos costs next to nothing
        return new Cell(PinholeCamera.ideal(widthPx, heightPx, 581, 581, widthPx / 2.0, heightPx / 2.0),
                MarkerFamily.SQUARE_BINARY,
                List.of(new Reference(944, 47, NOMINAL, new Placement(1, 2, 3, 0.01)),
                        new Reference(22, 100, RigidTransform.ofEuler(-300, 200, 150, 0, 0, 0),
                                new Placement(0, 0, 0, 0))),
                List.of(new ObjectMarker(5, 47, null), new ObjectMarker(20, 47, new double[] {0, 0, 100})),
                OptionalDouble.empty(), OptionalDouble.empty());
    }

    private static CellSimulation.Settings settings(boolean placementErrors, double jitterMm, double jitterRad) {
        return new CellSimulation.Settings(4, placementErrors, jitterMm, jitterRad, 0, 0.2);
    }

    @Test
    void placementErrorsHaveTheStatedDeviations() {
        CellSimulation simulation = new CellSimulation(cell(4, 4), ABOVE, Map.of(), settings(true, 0, 0));
        int photos = 1500;
        double[] squares = new double[6];
        for (int i = 0; i < photos; i++) {
            Map<Integer, RigidTransform> actual = simulation.photo(i, Sensor.IDEAL).worldFromReferences();
            double[] place = actual.get(944).translationMm();
            double[] nominal = NOMINAL.translationMm();
            double[] turn = actual.get(944).compose(NOMINAL.inverse()).rotationVectorRad();
            for (int axis = 0; axis < 3; axis++) {
                squares[axis] += Math.pow(place[axis] - nominal[axis], 2);
                squares[3 + axis] += turn[axis] * turn[axis];
            }
            // no deviation stated, none drawn
            assertArrayEquals(new double[] {-300, 200, 150}, actual.get(22).translationMm());
        }
        double[] std = {1, 2, 3, 0.01, 0.01, 0.01};
        for (int k = 0; k < 6; k++) {
            double expected = std[k] * std[k];
            // five standard errors of a variance with known mean from n draws: 5 sqrt(2 / n)
            assertEquals(expected, squares[k] / photos, expected * 5 * Math.sqrt(2.0 / photos), "component " + k);
        }
    }

    @Test
    void cameraJitterHasTheStatedDeviations() {
        CellSimulation simulation = new CellSimulation(cell(4, 4), ABOVE, Map.of(), settings(false, 2, 0.03));
        int photos = 1500;
        double[] squares = new double[6];
        for (int i = 0; i < photos; i++) {
            CellSimulation.Photo photo = simulation.photo(i, Sensor.IDEAL);
            double[] place = photo.scene().worldFromCamera().translationMm();
            double[] turn = photo.scene().worldFromCamera().compose(ABOVE.inverse()).rotationVectorRad();
            double[] mean = ABOVE.translationMm();
            for (int axis = 0; axis < 3; axis++) {
                squares[axis] += Math.pow(place[axis] - mean[axis], 2);
                squares[3 + axis] += turn[axis] * turn[axis];
            }
            assertArrayEquals(NOMINAL.translationMm(), photo.worldFromReferences().get(944).translationMm());
        }
        for (int k = 0; k < 6; k++) {
            double expected = k < 3 ? 4 : 0.03 * 0.03;
            assertEquals(expected, squares[k] / photos, expected * 5 * Math.sqrt(2.0 / photos), "component " + k);
        }
    }

    @Test
    void photoDoesNotDependOnTheOnesBefore() {
        CellSimulation simulation = new CellSimulation(cell(64, 48), ABOVE, Map.of(), settings(true, 1, 0.01));
        simulation.photo(0, Sensor.USUAL);
        byte[] second = simulation.photo(1, Sensor.USUAL).image().luminance();
        CellSimulation fresh = new CellSimulation(cell(64, 48), ABOVE, Map.of(), settings(true, 1, 0.01));
        assertArrayEquals(second, fresh.photo(1, Sensor.USUAL).image().luminance());
    }

    @Test
    void overviewHoldsAllMarkers() {
        Map<Integer, RigidTransform> objects = Map.of(5, RigidTransform.ofEuler(500, -100, 40, 0.1, 0, 0.5));
        Cell cell = cell(640, 480);
        RigidTransform camera = CellSimulation.overview(cell, objects);
        CellSimulation simulation = new CellSimulation(cell, camera, objects, settings(false, 0, 0));
        List<SceneTruth.MarkerInImage> truth = SceneTruth.of(simulation.photo(0, Sensor.IDEAL).scene());
        assertEquals(3, truth.size());
        for (SceneTruth.MarkerInImage marker : truth) {
            assertTrue(marker.whollyInside(), "marker " + marker.id());
            assertEquals(1, marker.visibleShare(), "marker " + marker.id());
        }
    }

    @Test
    void objectThatIsNotInTheCellIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> new CellSimulation(cell(4, 4), ABOVE,
                Map.of(944, NOMINAL), settings(false, 0, 0)));
    }
}
