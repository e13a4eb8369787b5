package org.cellgauge.internal.survey;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
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

/** A cell that turns as a whole keeps its distances, and looks the same to cameras that turn with it. */
class CommonMotionTest {
    private static final CheckSettings SETTINGS = CheckSettings.builder().build();

    private static SurveyFit fit() {
        List<Reference> placed = new ArrayList<>();
        for (int i = 0; i < 4; i++) {
            placed.add(new Reference(10 + i, 60, RigidTransform.ofEuler(i % 2 * 500, i / 2 * 300, i == 3 ? 80 : 0, 0,
                    0, 0.1 * i), new Placement(5, 5, 5, 0.02)));
        }
        Cell cell = new Cell(PinholeCamera.ideal(1280, 720, 900, 900, 640, 360), MarkerFamily.SQUARE_BINARY, placed,
                List.of(new ObjectMarker(1, 60, null)), OptionalDouble.of(0.1), OptionalDouble.empty(),
                new PrintPrecision(0, 0, 0));
        SurveyFit fit = SurveyProgress.start(cell, SETTINGS)
                .with(SimulatedSurvey.of(cell, SETTINGS, 3, 2, 0).photos()).fit;
        if (fit == null) {
            throw new IllegalStateException("there is a mode");
        }
        return fit;
    }

    private static double distance(SurveyFit fit, SurveyState state, int a, int b) {
        double[] p = fit.model.worldFromReference(state, a).translationMm();
        double[] q = fit.model.worldFromReference(state, b).translationMm();
        return Math.sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) + (p[2] - q[2]) * (p[2] - q[2]));
    }

    /** The tangent of a turn by 0.05 rad of everything about the centre, and of a shift: 500 mm grow by 0.6 mm. */
    @Test
    void aTurnOfEverythingKeepsDistancesAndPictures() {
        SurveyFit fit = fit();
        SurveyLayout layout = fit.model.layout;
        double[] w = {0.03, -0.02, 0.05};
        double[] a = {4, -3, 2};
        double[] step = new double[fit.unknowns()];
        for (int body = 0; body < 5; body++) {
            int at = body < 4 ? 6 * body : layout.firstObject;
            double[] t = body < 4 ? fit.model.worldFromReference(fit.mode, body).translationMm()
                    : SurveyState.get(fit.mode.objects, 0).translationMm();
            double x = t[0] - fit.model.centreMm[0];
            double y = t[1] - fit.model.centreMm[1];
            double z = t[2] - fit.model.centreMm[2];
            step[at] = a[0] + w[1] * z - w[2] * y;
            step[at + 1] = a[1] + w[2] * x - w[0] * z;
            step[at + 2] = a[2] + w[0] * y - w[1] * x;
            System.arraycopy(w, 0, step, at + 3, 3);
        }
        int first = layout.size;
        SurveyState state = new SurveyState(layout, fit.views());
        state.moveShared(fit.mode, step);
        for (int v = 0; v < fit.views().size(); v++) {
            double[] r = fit.mode.cameras[v];
            for (int i = 0; i < 3; i++) {
                step[first + i] = -(r[3 * i] * a[0] + r[3 * i + 1] * a[1] + r[3 * i + 2] * a[2]);
                step[first + 3 + i] = -(r[3 * i] * w[0] + r[3 * i + 1] * w[1] + r[3 * i + 2] * w[2]);
            }
            state.moveOwn(fit.mode, v, step, first);
            first += fit.views().get(v).locals();
        }
        double straight = Math.abs(distance(fit, state, 0, 1) - distance(fit, fit.mode, 0, 1));
        assertTrue(straight > 0.3, "straight on it is " + straight + " mm");
        new CommonMotion(fit, fit.model).bend(step, state);
        for (int i = 0; i < 4; i++) {
            for (int j = 0; j < i; j++) {
                assertEquals(distance(fit, fit.mode, i, j), distance(fit, state, i, j), 1e-6, i + " to " + j);
            }
        }
        for (int v = 0; v < fit.views().size(); v++) {
            RigidTransform before = fit.worldFromCamera(v).inverse()
                    .compose(SurveyState.get(fit.mode.objects, 0));
            RigidTransform after = fit.worldFromCamera(state, v).inverse().compose(SurveyState.get(state.objects, 0));
            for (int i = 0; i < 3; i++) {
                assertEquals(before.translationMm()[i], after.translationMm()[i], 1e-4, "view " + v);
            }
            assertEquals(0, before.angleRadTo(after), 1e-6);
        }
    }
}
