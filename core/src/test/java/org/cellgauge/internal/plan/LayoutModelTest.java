package org.cellgauge.internal.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.apache.commons.math3.random.Well19937c;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.PrintPrecision;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CellEstimate;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.geometry.KannalaBrandtLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.vision.CornerForecast;
import org.cellgauge.laplace.LayoutPrediction;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.plan.Forecast;
import org.cellgauge.plan.Layout;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Estimate;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.EdgeShift;
import org.cellgauge.vision.MarkerObservation;
import org.cellgauge.vision.PhotoLight;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Information summed marker by marker says what the whole cell's Laplace approximation says. */
class LayoutModelTest {
    private enum Kind {
        DISTORTED, FISHEYE, FOCAL, TWO, PRINTS;

        ThesisScene scene() {
            ThesisScene scene = this == TWO ? ThesisScene.inPlane(2)
                    : this == FOCAL ? ThesisScene.oneRaised(4) : ThesisScene.inPlane(4);
            return scene.camera(this == FISHEYE
                    ? PinholeCamera.of(KannalaBrandtLens.MODEL, 1280, 720,
                            new double[] {560, 565, 640, 360, 0, 0.02, -0.01, 0.003, -0.001})
                    : PinholeCamera.of(1280, 720,
                            new double[] {581, 590, 640, 360, 0, -0.2, 0.05, 0, 0.001, -0.001}))
                    .placement(5, 0.01).pixelStd(0.3).planeObjects().grip(20, 10, -20, 100);
        }

        Cell cell() {
            Cell cell = scene().cell();
            return this != PRINTS ? cell : new Cell(cell.camera(), cell.family(), cell.references(), cell.objects(),
                    cell.pixelStdPx(), cell.targetStdMm(), new PrintPrecision(0.1, 0.2, 0));
        }

        CheckSettings settings() {
            return this != FOCAL ? CheckSettings.builder().build()
                    : CheckSettings.builder().estimate(Estimate.FOCAL).focalPriorStdPx(50).build();
        }
    }

    private static Layout layout(Cell cell, RigidTransform worldFromCamera, Map<Integer, RigidTransform> objects) {
        Map<Integer, List<RigidTransform>> places = new LinkedHashMap<>();
        objects.forEach((id, pose) -> places.put(id, List.of(pose)));
        return new Layout(cell, List.of(worldFromCamera), places);
    }

    @ParameterizedTest
    @EnumSource
    void sumsOfMarkersAreTheApproximationOfTheWhole(Kind kind) {
        ThesisScene scene = kind.scene();
        Cell cell = kind.cell();
        LayoutPrediction expected = LayoutPrediction.of(cell, scene.worldFromCamera(), scene.objects(),
                kind.settings());
        LayoutModel model = new LayoutModel(layout(cell, scene.worldFromCamera(), scene.objects()),
                CornerForecast.USUAL, IntrinsicsPrior.stated(cell, kind.settings().model()));
        Forecast forecast = model.forecast();
        assertEquals(4, forecast.rows().size());
        // squares of objects tell a little of prints and lens, too, which the approximation of the camera leaves out
        double tolerance = kind == Kind.PRINTS ? 0.02 : kind == Kind.FOCAL ? 1e-4 : 1e-6;
        double worst = 0;
        for (Forecast.Row row : forecast.rows()) {
            for (int axis = 0; axis < 3; axis++) {
                double std = row.grip()
                        ? Math.sqrt(expected.grip(row.object()).covarianceMm2()[axis][axis])
                        : expected.object(row.object()).std()[axis];
                assertEquals(std, row.axis(axis), tolerance * std, row.object() + " axis " + axis);
                worst = Math.max(worst, std);
            }
            assertTrue(row.ownStdMm() < row.worstStdMm());
        }
        assertEquals(worst, Math.sqrt(model.worst()), tolerance * worst);
    }

    /**
     * Worst axis and worst lateral axis of the root mean square over the three objects in the plane, mm, without the
     * noise of their own corners: converged chains of an independent implementation (method notes, "What the numbers
     * should be", rigid-marker), which have two digits.
     */
    @ParameterizedTest
    @CsvSource({"1, false, 3, 4.2, 0.8", "1, false, 4, 2.5, 0.7", "1, true, 4, 2.3, 0.7", "1, true, 6, 2.1, 0.6",
        "5, false, 3, 7.4, 3.2", "5, false, 4, 5.6, 2.8", "5, false, 6, 4.8, 2.2", "5, true, 3, 6.3, 3.3",
        "5, true, 5, 4.9, 2.5", "20, false, 4, 12, 10", "20, true, 6, 9.5, 8.2"})
    void figuresOfAnIndependentSamplerAreForetold(double stdMm, boolean raised, int references, double worst,
            double lateral) {
        ThesisScene scene = (raised ? ThesisScene.oneRaised(references) : ThesisScene.inPlane(references))
                .placement(stdMm, 0.01).pixelStd(0.3).planeObjects();
        Forecast forecast = new LayoutModel(layout(scene.cell(), scene.worldFromCamera(), scene.objects()),
                CornerForecast.USUAL, IntrinsicsPrior.KNOWN).forecast();
        double[] squares = new double[3];
        PlannedView view = new LayoutModel(layout(scene.cell(), scene.worldFromCamera(), scene.objects()),
                CornerForecast.USUAL, IntrinsicsPrior.KNOWN).view(0);
        for (Forecast.Row row : forecast.rows()) {
            double[] own = view.object(scene.objects().get(row.object()), 47).point(new double[3]).ownMm2();
            for (int axis = 0; axis < 3; axis++) {
                squares[axis] += (row.axis(axis) * row.axis(axis) - own[4 * axis]) / 3;
            }
        }
        double ofBoth = Math.sqrt(Math.max(squares[0], squares[1]));
        assertEquals(worst, Math.max(ofBoth, Math.sqrt(squares[2])), 0.05 * worst);
        // one digit of some leaves no more
        assertEquals(lateral, ofBoth, Math.max(0.05 * lateral, 0.051));
    }

    /** Photos whose corners are as precise as forecast: whole checks of them, learned noise and edges and all. */
    @Test
    void ofUnknownNoiseItIsWhatChecksOfSuchCornersFind() {
        ThesisScene scene = ThesisScene.oneRaised(4).placement(1, 0.003).pixelStd(0.3).planeObjects();
        Cell cell = scene.cell().withPixelStdPx(OptionalDouble.empty());
        CornerForecast forecast = new CornerForecast(ToneCurve.SRGB, 0.7, 10);
        PhotoLight light = new PhotoLight(ToneCurve.SRGB, true, 0.7, 10, 1000, CornerForecast.EDGE_SHIFT_STD_PX);
        Well19937c random = new Well19937c(11);
        Map<Integer, double[]> variances = new LinkedHashMap<>();
        int photos = 60;
        for (int k = 0; k < photos; k++) {
            List<MarkerObservation> told = new ArrayList<>();
            for (MarkerObservation m : scene.exactDetections().markers()) {
                told.add(drawn(forecast.of(m.id(), m.cornersPx()), random));
            }
            CellEstimate check = CellCheck.quickLook(cell, new Detections("layout", 1280, 720, told, List.of(), light),
                    CheckSettings.builder().build(), null).update().estimate();
            for (ObjectEstimate object : check.objects()) {
                double[] sum = variances.computeIfAbsent(object.marker().id(), id -> new double[3]);
                for (int axis = 0; axis < 3; axis++) {
                    sum[axis] += Math.pow(object.pose().std()[axis], 2) / photos;
                }
            }
        }
        Forecast rows = new LayoutModel(layout(cell, scene.worldFromCamera(), scene.objects()), forecast,
                IntrinsicsPrior.KNOWN).forecast();
        for (Forecast.Row row : rows.rows()) {
            for (int axis = 0; axis < 3; axis++) {
                double std = Math.sqrt(variances.get(row.object())[axis]);
                assertEquals(std, row.axis(axis), 0.05 * std, row.object() + " axis " + axis);
            }
        }
    }

    /** Corners and shift off by a draw from what they are said to be good for. */
    private static MarkerObservation drawn(MarkerObservation exact, Well19937c random) {
        EdgeShift shift = exact.edgeShift();
        double[] joint = new double[81];
        for (int i = 0; i < 8; i++) {
            for (int j = 0; j < 8; j++) {
                joint[9 * i + j] = exact.covariancePx2()[8 * i + j];
            }
            joint[9 * i + 8] = shift.covarianceWithCornersPx2()[i];
            joint[72 + i] = shift.covarianceWithCornersPx2()[i];
        }
        joint[80] = shift.variancePx2();
        assertTrue(Cholesky.factor(joint, 9));
        double[] z = new double[9];
        for (int i = 0; i < 9; i++) {
            z[i] = random.nextGaussian();
        }
        double[] corners = exact.cornersPx();
        double moved = 0;
        for (int i = 0; i < 9; i++) {
            double sum = 0;
            for (int j = 0; j <= i; j++) {
                sum += joint[9 * i + j] * z[j];
            }
            if (i < 8) {
                corners[i] += sum;
            } else {
                moved = sum;
            }
        }
        return new MarkerObservation(exact.id(), corners, exact.covariancePx2(),
                new EdgeShift(moved, shift.variancePx2(), shift.covarianceWithCornersPx2()));
    }
}
