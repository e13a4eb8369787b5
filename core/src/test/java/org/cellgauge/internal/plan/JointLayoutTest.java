package org.cellgauge.internal.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.Requirement;
import org.cellgauge.cell.Requirement.Axes;
import org.cellgauge.cell.Target;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.vision.CornerForecast;
import org.cellgauge.plan.Forecast;
import org.cellgauge.plan.Layout;
import org.cellgauge.plan.MeasuredDistance;
import org.junit.jupiter.api.Test;

/** Layouts whose references do not err independently, and several photos. */
class JointLayoutTest {
    private static final double INFINITE = Double.POSITIVE_INFINITY;

    private static ThesisScene scene(double stdMm, double stdRad, double pixelStdPx) {
        return ThesisScene.oneRaised(4).placement(stdMm, stdRad).pixelStd(pixelStdPx).planeObjects()
                .grip(20, 10, -20, 100);
    }

    private static Layout layout(ThesisScene scene) {
        Map<Integer, List<RigidTransform>> places = new LinkedHashMap<>();
        scene.objects().forEach((id, pose) -> places.put(id, List.of(pose)));
        return new Layout(scene.cell(), List.of(scene.worldFromCamera()), places);
    }

    private static Forecast forecast(Layout layout) {
        return new LayoutModel(layout, CornerForecast.USUAL, IntrinsicsPrior.KNOWN).forecast();
    }

    private static void assertSame(Forecast expected, Forecast actual, double tolerance) {
        assertEquals(expected.rows().size(), actual.rows().size());
        for (int i = 0; i < expected.rows().size(); i++) {
            Forecast.Row e = expected.rows().get(i);
            Forecast.Row a = actual.rows().get(i);
            for (int axis = 0; axis < 3; axis++) {
                assertEquals(e.axis(axis), a.axis(axis), tolerance * e.axis(axis));
            }
            assertEquals(e.ownStdMm(), a.ownStdMm(), tolerance * e.ownStdMm());
            if (!e.grip()) {
                assertEquals(e.turnStdDeg(), a.turnStdDeg(), tolerance * e.turnStdDeg());
            }
            assertEquals(e.ratio(), a.ratio(), tolerance * e.ratio());
        }
    }

    /** A distance measured so badly that it says nothing: all unknowns at once give what sums of markers give. */
    @Test
    void allUnknownsAtOnceSayWhatSumsOfMarkersSay() {
        Layout one = layout(scene(2, 0.005, 0.2));
        assertSame(forecast(one), forecast(one.withDistance(new MeasuredDistance(944, 22, 1e9))), 1e-6);
        Layout learned = one.with(one.cell().withPixelStdPx(OptionalDouble.empty()));
        assertSame(forecast(learned), forecast(learned.withDistance(new MeasuredDistance(944, 22, 1e9))), 1e-6);
    }

    /** Two photos from one place, each with a pose of its own: their mean has half of the variance of corners. */
    @Test
    void photosFromOnePlaceAverageTheirNoise() {
        Layout one = layout(scene(2, 0.005, 0.2));
        Layout half = layout(scene(2, 0.005, 0.2 / Math.sqrt(2)));
        assertSame(forecast(half), forecast(one.withOtherPhotos(List.of(RigidTransform.IDENTITY))), 1e-6);
    }

    /** The placement is the plate's: it does not average out over its references. */
    @Test
    void whatStandsOnOnePlateIsOffTogether() {
        Layout apart = layout(scene(2, 1e-7, 1e-4));
        Layout plate = apart.withPlate(List.of(944, 1234, 911, 22));
        for (Forecast.Row row : forecast(plate).rows()) {
            for (int axis = 0; axis < 3; axis++) {
                assertEquals(2, row.axis(axis), 0.01);
            }
        }
        assertTrue(forecast(apart).rows().get(0).xStdMm() < 1.5);
        assertThrows(IllegalArgumentException.class, () -> plate.withPlate(List.of(22, 944)));
    }

    /** References that may be off along x alone, 492 mm apart along it: the photo's scale rests on their distance. */
    @Test
    void aMeasuredDistanceHoldsReferencesTogether() {
        Layout one = layout(scene(2, 0.005, 0.05));
        double last = forecast(one).worstStdMm();
        for (double std : new double[] {2, 0.5, 0.01}) {
            double now = forecast(one.withDistance(new MeasuredDistance(944, 1234, std))).worstStdMm();
            assertTrue(now < last, now + " and " + last);
            last = now;
        }
    }

    /** Each of what a target asks for is a limit: along an axis, of a distance, of a turn; of single objects. */
    @Test
    void targetsAreLimitsOfDeviations() {
        Layout one = layout(scene(2, 0.005, 0.2));
        Forecast mm = forecast(one);
        Forecast.Row of5 = mm.rows().get(0);
        Forecast z = forecast(asked(one, new Requirement(new Axes(1, 1, 2), Axes.NONE, INFINITE, INFINITE, 0.95)));
        assertEquals(Math.max(of5.xStdMm(), Math.max(of5.yStdMm(), of5.zStdMm() / 2)), z.rows().get(0).ratio(),
                1e-9);
        // 95 % of a normal distribution are within 1.96 deviations
        Forecast within = forecast(asked(one, new Requirement(Axes.NONE, Axes.all(1.959964 * of5.zStdMm()), INFINITE,
                INFINITE, 0.95)));
        assertEquals(of5.worstStdMm() / of5.zStdMm(), within.rows().get(0).ratio(), 1e-6);
        assertEquals(0.95, within.rows().get(0).probability(), 1e-6);
        // where it is just met, the probability is the one asked for; the search counts it as more, never as less
        Forecast distance = forecast(asked(one, new Requirement(Axes.NONE, Axes.NONE, 6, INFINITE, 0.9)));
        Layout met = asked(one, new Requirement(Axes.NONE, Axes.NONE, 6 * distance.rows().get(0).ratio(), INFINITE,
                0.9));
        assertEquals(1, forecast(met).rows().get(0).ratio(), 1e-6);
        assertEquals(0.9, forecast(met).rows().get(0).probability(), 1e-6);
        double counted = Math.sqrt(new LayoutModel(met, CornerForecast.USUAL, IntrinsicsPrior.KNOWN).worst());
        assertTrue(counted > forecast(met).ratio() && counted < 1.3 * forecast(met).ratio());
        Forecast turn = forecast(asked(one, new Requirement(Axes.NONE, Axes.NONE, INFINITE, 1, 0.95)));
        assertTrue(turn.rows().get(0).ratio() > 1.96 * of5.turnStdDeg(), turn.toString());
        assertTrue(turn.rows().get(0).ratio() < 2.8 * of5.turnStdDeg(), turn.toString());
        // nothing is asked of the others
        Cell cell = one.cell().withTarget(new Target(Requirement.NONE, Map.of(5, Requirement.ofStdMm(1))));
        Forecast alone = forecast(one.with(cell));
        assertEquals(of5.worstStdMm(), alone.ratio(), 1e-9);
        assertEquals(0, alone.rows().get(1).ratio());
    }

    private static Layout asked(Layout layout, Requirement requirement) {
        return layout.with(layout.cell().withTarget(new Target(requirement, Map.of())));
    }
}
