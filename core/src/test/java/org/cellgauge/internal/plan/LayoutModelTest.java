package org.cellgauge.internal.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.PrintPrecision;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CellEstimate;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.geometry.KannalaBrandtLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.vision.CornerForecast;
import org.cellgauge.laplace.LayoutPrediction;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.plan.Forecast;
import org.cellgauge.plan.Layout;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Estimate;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.cellgauge.vision.PhotoLight;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
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
                CornerForecast.USUAL, IntrinsicsPrior.stated(cell.camera(), kind.settings().model()));
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

    /** A photo whose corners are as precise as forecast: a whole check of them, learned noise and edges and all. */
    @Test
    void ofUnknownNoiseItIsWhatACheckOfSuchCornersFinds() {
        ThesisScene scene = ThesisScene.oneRaised(4).placement(1, 0.003).pixelStd(0.3).planeObjects();
        Cell stated = scene.cell();
        Cell cell = stated.withPixelStdPx(OptionalDouble.empty());
        CornerForecast forecast = new CornerForecast(ToneCurve.SRGB, 0.7, 40);
        Detections exact = scene.exactDetections();
        List<MarkerObservation> told = exact.markers().stream().map(m -> forecast.of(m.id(), m.cornersPx())).toList();
        PhotoLight light = new PhotoLight(ToneCurve.SRGB, true, 0.7, 40, 1000, CornerForecast.EDGE_SHIFT_STD_PX);
        CellEstimate check = CellCheck.quickLook(cell, new Detections("layout", 1280, 720, told, List.of(), light),
                CheckSettings.builder().build(), null).update().estimate();
        Forecast rows = new LayoutModel(layout(cell, scene.worldFromCamera(), scene.objects()), forecast,
                IntrinsicsPrior.KNOWN).forecast();
        for (ObjectEstimate object : check.objects()) {
            Forecast.Row row = rows.rows().stream().filter(r -> r.object() == object.marker().id()).findFirst()
                    .orElseThrow();
            for (int axis = 0; axis < 3; axis++) {
                double std = object.pose().std()[axis];
                assertEquals(std, row.axis(axis), 0.05 * std, row.object() + " axis " + axis);
            }
        }
        assertNotNull(rows);
    }
}
