package org.cellgauge.internal.posterior;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.apache.commons.math3.fitting.leastsquares.LeastSquaresBuilder;
import org.apache.commons.math3.fitting.leastsquares.LevenbergMarquardtOptimizer;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.util.Pair;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.pose.CameraModeFinder;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.internal.pose.ReferenceView;
import org.cellgauge.internal.pose.RigidMarkerNoise;
import org.cellgauge.internal.sampling.RandomStreams;
import org.ejml.simple.SimpleMatrix;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Placement errors integrated out of the residuals against placement errors fitted as unknowns of their own. */
class RigidMarginalisationTest {
    private static final double PIXEL_STD = 0.3;

    /** Whitened residuals by 6 values of the centred chart and 6 of each reference's placement error. */
    private static double[] residuals(ReferenceView view, CameraState base, double[] x) {
        CameraState state = new CameraState();
        state.setMoved(base, x, 0);
        RigidTransform cameraFromWorld = view.worldFromCamera(state.cameraFromSet()).inverse();
        int n = view.size();
        double[] out = new double[14 * n];
        for (int m = 0; m < n; m++) {
            Reference reference = view.references().get(m);
            Placement p = reference.placement();
            double[] t = reference.worldFromMarker().translationMm();
            double[] w = new double[3];
            for (int i = 0; i < 3; i++) {
                double dt = x[6 + 6 * m + i];
                w[i] = x[9 + 6 * m + i];
                out[8 * n + 6 * m + i] = dt / p.stdMm(i);
                out[8 * n + 6 * m + 3 + i] = w[i] / p.stdRad();
                t[i] += dt;
            }
            RigidTransform placed = RigidTransform.ofRotationVector(w, t)
                    .compose(RigidTransform.of(reference.worldFromMarker().rotation(), new double[3]));
            double[] c = MarkerGeometry.cornersMm(cameraFromWorld.compose(placed), reference.sizeMm());
            for (int k = 0; k < 4; k++) {
                double[] uv = ThesisScene.CAMERA.project(c[3 * k], c[3 * k + 1], c[3 * k + 2]);
                for (int i = 0; i < 2; i++) {
                    out[8 * m + 2 * k + i] = (uv[i] - view.observedPx()[8 * m + 2 * k + i]) / PIXEL_STD;
                }
            }
        }
        return out;
    }

    private static double[][] jacobian(ReferenceView view, CameraState base, double[] x) {
        double[][] j = new double[14 * view.size()][x.length];
        for (int c = 0; c < x.length; c++) {
            double h = c % 6 < 3 ? 0.01 : 1e-5;
            double[] plus = x.clone();
            double[] minus = x.clone();
            plus[c] += h;
            minus[c] -= h;
            double[] up = residuals(view, base, plus);
            double[] down = residuals(view, base, minus);
            for (int r = 0; r < up.length; r++) {
                j[r][c] = (up[r] - down[r]) / (2 * h);
            }
        }
        return j;
    }

    @ParameterizedTest
    @CsvSource({"3, false", "4, false", "3, true", "4, true"})
    void deviationsAgreeWithExplicitPlacementErrors(int references, boolean raised) {
        ThesisScene scene = (raised ? ThesisScene.oneRaised(references) : ThesisScene.inPlane(references))
                .placement(5, 0.01);
        ReferenceView view = ReferenceView.of(scene.cell().references(), scene.exactDetections());
        PoseMode mode = new CameraModeFinder(view, ThesisScene.CAMERA, new RigidMarkerNoise(view, PIXEL_STD),
                IntrinsicsPrior.KNOWN, null).modes(scene.worldFromCamera()).get(0);
        SimpleMatrix j = new SimpleMatrix(jacobian(view, mode.state(), new double[6 + 6 * references]));
        SimpleMatrix covariance = j.transpose().mult(j).invert();
        // at the same point and linearised both are the same Gaussian, whatever the size of the errors
        for (int i = 0; i < 6; i++) {
            for (int k = 0; k < 6; k++) {
                double scale = Math.sqrt(covariance.get(i, i) * covariance.get(k, k));
                assertEquals(covariance.get(i, k), mode.covariance()[6 * i + k], 1e-5 * scale);
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"3, false, 5, 0.01", "4, true, 5, 0.01", "3, true, 5, 0.01", "4, true, 20, 0.05"})
    void fitsWithExplicitPlacementErrorsHaveTheSameModeAndDeviations(int references, boolean raised, double stdMm,
            double stdRad) {
        ThesisScene scene = (raised ? ThesisScene.oneRaised(references) : ThesisScene.inPlane(references))
                .placement(stdMm, stdRad);
        for (int photo = 0; photo < 6; photo++) {
            ReferenceView view = ReferenceView.of(scene.cell().references(),
                    scene.detections(PIXEL_STD, RandomStreams.of(21, photo), stdMm, stdRad));
            PoseMode mode = new CameraModeFinder(view, ThesisScene.CAMERA, new RigidMarkerNoise(view, PIXEL_STD),
                    IntrinsicsPrior.KNOWN, null).modes(scene.worldFromCamera()).get(0);
            CameraState base = mode.state();
            int rows = 14 * references;
            var optimum = new LevenbergMarquardtOptimizer().optimize(new LeastSquaresBuilder()
                    .start(new double[6 + 6 * references]).target(new double[rows]).maxEvaluations(1000)
                    .maxIterations(1000)
                    .model(point -> new Pair<>(new ArrayRealVector(residuals(view, base, point.toArray()), false),
                            new Array2DRowRealMatrix(jacobian(view, base, point.toArray()), false))).build());
            SimpleMatrix j = new SimpleMatrix(jacobian(view, base, optimum.getPoint().toArray()));
            SimpleMatrix covariance = j.transpose().mult(j).invert();
            for (int i = 0; i < 6; i++) {
                double std = Math.sqrt(covariance.get(i, i));
                // linearised where the references are found to stand, both are the same Gaussian
                assertEquals(1, Math.sqrt(mode.covariance()[7 * i]) / std, 1e-4, "photo " + photo + " coordinate " + i);
                assertEquals(0, optimum.getPoint().getEntry(i), 1e-3 * std, "photo " + photo + " coordinate " + i);
            }
        }
    }
}
