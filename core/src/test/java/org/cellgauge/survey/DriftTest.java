package org.cellgauge.survey;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.PrintPrecision;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.validation.SimulatedSurvey;
import org.cellgauge.settings.CheckSettings;
import org.junit.jupiter.api.Test;

/** Two surveys of one simulated cell, between which nothing has moved, or one thing. */
class DriftTest {
    private static final PinholeCamera CAMERA = PinholeCamera.ideal(1280, 720, 900, 900, 640, 360);
    private static final CheckSettings SETTINGS = CheckSettings.builder().build();
    private static final int MOVED = 101;

    private static Cell cell(double stdMm) {
        List<Reference> placed = new ArrayList<>();
        for (int i = 0; i < 5; i++) {
            double angle = 2 * Math.PI * i / 5;
            placed.add(new Reference(100 + i, 60, RigidTransform.ofEuler(350 * Math.cos(angle),
                    250 * Math.sin(angle), i % 3 == 0 ? 100 : 0, 0, 0, 0),
                    new Placement(stdMm, stdMm, stdMm, Math.toRadians(0.5))));
        }
        return new Cell(CAMERA, MarkerFamily.SQUARE_BINARY, placed,
                List.of(new ObjectMarker(1, 60, null), new ObjectMarker(2, 60, null)), OptionalDouble.of(0.3),
                OptionalDouble.of(1), new PrintPrecision(0, 0, 0));
    }

    private static Epoch before(SimulatedSurvey truth, Cell cell) {
        return Survey.of(cell, truth.photos(), SETTINGS).estimate().epoch();
    }

    private static Drift after(SimulatedSurvey truth, Cell cell, boolean stands, Map<Integer, double[]> shiftsMm,
            double[] cameraShiftMm, int seed) {
        SimulatedSurvey later = truth.again(4, seed, stands, shiftsMm, cameraShiftMm);
        return Survey.of(cell, later.photos(), SETTINGS).against(before(truth, cell), stands);
    }

    private static Drift.Displacement of(Drift drift, Epoch.Kind kind, int id) {
        return drift.bodies().stream().filter(d -> d.body().kind() == kind && d.body().id() == id).findFirst()
                .orElseThrow();
    }

    /**
     * Chi-square of unmoved bodies is that of six degrees of freedom: mean 6. Both surveys rest on the same placement,
     * whose error of 5 mm is a hundred times what the difference of the two is off by.
     */
    @Test
    void unmovedBodiesHaveChiSquareOfSixDegrees() {
        double sum = 0;
        double camera = 0;
        int count = 0;
        int photos = 0;
        for (int k = 0; k < 24; k++) {
            Cell cell = cell(5);
            SimulatedSurvey truth = SimulatedSurvey.of(cell, SETTINGS, 3, 11, k);
            Drift drift = after(truth, cell, true, Map.of(), new double[3], k);
            assertFalse(drift.any(), "cell " + k + ": " + drift.warnings());
            for (Drift.Displacement d : drift.bodies()) {
                sum += d.body().kind() == Epoch.Kind.CAMERA ? 0 : d.chiSquare();
                count += d.body().kind() == Epoch.Kind.CAMERA ? 0 : 1;
            }
            for (Drift.OfPhoto p : drift.photos()) {
                for (Drift.Displacement d : p.bodies()) {
                    camera += d.body().kind() == Epoch.Kind.CAMERA ? d.chiSquare() : 0;
                    photos += d.body().kind() == Epoch.Kind.CAMERA ? 1 : 0;
                }
            }
        }
        assertEquals(24 * 7, count);
        assertEquals(24 * 4, photos);
        // variance 12 each; bodies of a cell, and photos against one earlier camera, are not independent of each other
        assertEquals(6, sum / count, 4 * Math.sqrt(12.0 / 24 / 3));
        assertEquals(6, camera / photos, 4 * Math.sqrt(12.0 / 24 / 1.5));
    }

    @Test
    void aReferenceThatMovedIsNamedWithHowFar() {
        Cell cell = cell(5);
        for (int k = 0; k < 4; k++) {
            SimulatedSurvey truth = SimulatedSurvey.of(cell, SETTINGS, 4, 5, k);
            Drift drift = after(truth, cell, false, Map.of(MOVED, new double[] {3, -2, 0}), new double[3], k);
            Drift.Displacement found = of(drift, Epoch.Kind.REFERENCE, MOVED);
            assertTrue(found.moved());
            assertEquals(3, found.shiftMm().get(0), 4 * found.stdMm().get(0));
            assertEquals(-2, found.shiftMm().get(1), 4 * found.stdMm().get(1));
            assertTrue(found.stdMm().get(0) < 1, "std " + found.stdMm());
            assertEquals(1, drift.bodies().stream().filter(Drift.Displacement::moved).count(), drift.toString());
            assertTrue(drift.warnings().get(0).toString().startsWith("reference 101 has moved"));
        }
    }

    @Test
    void anObjectThatMovedIsNamed() {
        Cell cell = cell(5);
        SimulatedSurvey truth = SimulatedSurvey.of(cell, SETTINGS, 4, 6, 0);
        Drift drift = after(truth, cell, false, Map.of(2, new double[] {0, 4, 0}), new double[3], 0);
        assertTrue(of(drift, Epoch.Kind.OBJECT, 2).moved());
        assertFalse(of(drift, Epoch.Kind.OBJECT, 1).moved());
        assertEquals(4, of(drift, Epoch.Kind.OBJECT, 2).distanceMm(), 1);
    }

    /** The camera's height over the cell is known far better between two photos than in the world. */
    @Test
    void aCameraThatMovedIsNamedAndNothingElse() {
        Cell cell = cell(5);
        SimulatedSurvey truth = SimulatedSurvey.of(cell, SETTINGS, 4, 8, 0);
        Drift drift = after(truth, cell, true, Map.of(), new double[] {12, 0, 9}, 0);
        Drift.Displacement camera = of(drift, Epoch.Kind.CAMERA, 0);
        assertTrue(camera.moved(), drift.toString());
        assertEquals(12, camera.shiftMm().get(0), 4 * camera.stdMm().get(0));
        assertEquals(9, camera.shiftMm().get(2), 4 * camera.stdMm().get(2));
        assertEquals(1, drift.bodies().stream().filter(Drift.Displacement::moved).count(), drift.toString());
        // of a camera that is carried round nothing is said
        assertFalse(after(truth, cell, false, Map.of(), new double[] {12, 0, 9}, 0).any());
    }
}
