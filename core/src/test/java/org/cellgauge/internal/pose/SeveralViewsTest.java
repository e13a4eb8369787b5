package org.cellgauge.internal.pose;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.apache.commons.math3.fitting.leastsquares.LeastSquaresBuilder;
import org.apache.commons.math3.fitting.leastsquares.LevenbergMarquardtOptimizer;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.util.Pair;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.sampling.RandomStreams;
import org.ejml.simple.SimpleMatrix;
import org.junit.jupiter.api.Test;

/**
 * Two photos of one cell with an unknown focal length: three markers, of which the first photo alone shows one, and a
 * plate of six points whose placement error is correlated; against a model written out here that has every placement
 * error as an unknown.
 */
class SeveralViewsTest {
    private static final double PIXEL_STD = 0.3;
    private static final PinholeCamera CAMERA = InitialPoseTest.STRONG;
    private static final double FOCAL_STD = 60;
    private static final double ASPECT_STD = 0.005;
    private static final IntrinsicsPrior PRIOR = IntrinsicsPrior.focalAndAspect(CAMERA, FOCAL_STD, ASPECT_STD);
    private static final List<RigidTransform> CAMERAS = List.of(ThesisScene.WORLD_FROM_CAMERA,
            RigidTransform.ofEuler(150, -350, 900, 2.6, 0.15, -0.1));
    private static final int[][] SEEN_IN = {{0, 1}, {0}, {0, 1}, {0, 1}};
    private static final RigidTransform PLATE = RigidTransform.ofEuler(250, 150, 40, 0.1, -0.2, 0.4);
    private static final double[] PLATE_POINTS = {-60, 0, 0, 60, 0, 0, 0, 50, 0, 0, -50, 10, 30, 30, 0, -30, 40, 20};
    /** Lower triangular; its third axis is exact. */
    private static final double[][] PLATE_ROOT = {{3, 0, 0, 0, 0, 0}, {1, 2, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0},
        {0.004, 0, 0, 0.01, 0, 0}, {0, -0.003, 0, 0.002, 0.008, 0}, {0, 0, 0, 0.001, -0.004, 0.02}};
    private static final List<Reference> MARKERS = List.of(
            new Reference(1234, 47, RigidTransform.ofEuler(0, 380, 0, 0, 0, 0), new Placement(4, 5, 6, 0.01)),
            new Reference(944, 47, RigidTransform.ofEuler(492, 380, 0, 0, 0, 0.2), new Placement(5, 5, 5, 0.02)),
            new Reference(22, 60, RigidTransform.ofEuler(0, -36, 165, 0.1, 0, 0), new Placement(2, 2, 2, 0.005)));
    private static final int[] POINTS = {4, 4, 4, 6};
    private static final int BODIES = 4;

    private static List<Body> bodies() {
        List<Body> bodies = new ArrayList<>();
        MARKERS.forEach(m -> bodies.add(Body.of(m)));
        SimpleMatrix root = new SimpleMatrix(PLATE_ROOT);
        bodies.add(Body.of(7, PLATE, PLATE_POINTS, root.mult(root.transpose()).getDDRM().data.clone()));
        return bodies;
    }

    private static double[][] root(int body) {
        if (body == 3) {
            return PLATE_ROOT;
        }
        Placement p = MARKERS.get(body).placement();
        double[][] root = new double[6][6];
        for (int i = 0; i < 6; i++) {
            root[i][i] = i < 3 ? p.stdMm(i) : p.stdRad();
        }
        return root;
    }

    /** Image coordinates in the order of the blocks; errors are {@code root e}, six values of e per body. */
    private static double[] projected(List<RigidTransform> worldFromCameras, PinholeCamera camera, double[] e) {
        double[] out = new double[2 * (4 * 5 + 6 * 2)];
        int at = 0;
        for (int b = 0; b < BODIES; b++) {
            double[] d = new double[6];
            for (int i = 0; i < 6; i++) {
                for (int k = 0; k < 6; k++) {
                    d[i] += root(b)[i][k] * e[6 * b + k];
                }
            }
            RigidTransform nominal = b == 3 ? PLATE : MARKERS.get(b).worldFromMarker();
            double[] t = nominal.translationMm();
            RigidTransform stands = RigidTransform.ofRotationVector(new double[] {d[3], d[4], d[5]},
                    new double[] {t[0] + d[0], t[1] + d[1], t[2] + d[2]})
                    .compose(RigidTransform.of(nominal.rotation(), new double[3]));
            double[] points = b == 3 ? PLATE_POINTS : MarkerGeometry.cornersMm(MARKERS.get(b).sizeMm());
            for (int view : SEEN_IN[b]) {
                RigidTransform pose = worldFromCameras.get(view).inverse().compose(stands);
                for (int k = 0; k < points.length; k += 3) {
                    double[] p = pose.apply(points[k], points[k + 1], points[k + 2]);
                    System.arraycopy(camera.project(p[0], p[1], p[2]), 0, out, at, 2);
                    at += 2;
                }
            }
        }
        return out;
    }

    private static Observations observations(double[] observedPx) {
        return Observations.of(bodies(), BlockLayout.of(2, POINTS, SEEN_IN), observedPx);
    }

    private static Observations drawn(RandomGenerator random, PinholeCamera truth) {
        double[] e = new double[6 * BODIES];
        for (int i = 0; i < e.length; i++) {
            e[i] = random.nextGaussian();
        }
        double[] px = projected(CAMERAS, truth, e);
        for (int i = 0; i < px.length; i++) {
            px[i] += PIXEL_STD * random.nextGaussian();
        }
        return observations(px);
    }

    private static PinholeCamera lens(double dfx, double dfy) {
        double[] intrinsics = CAMERA.intrinsics();
        intrinsics[PinholeCamera.FX] += dfx;
        intrinsics[PinholeCamera.FY] += dfy;
        return PinholeCamera.of(CAMERA.widthPx(), CAMERA.heightPx(), intrinsics);
    }

    /**
     * Whitened residuals by steps of both poses from a state, changes of fx and fy from the prior's mean, and e of
     * every body.
     */
    private static double[] residuals(Observations seen, CameraState base, double[] x) {
        CameraState state = new CameraState(2);
        state.setMoved(base, x, 0);
        double[] e = Arrays.copyOfRange(x, 14, x.length);
        double[] px = projected(List.of(seen.worldFromCamera(state.cameraFromSet(0)),
                seen.worldFromCamera(state.cameraFromSet(1))), lens(x[12], x[13]), e);
        double[] out = Arrays.copyOf(px, px.length + 2 + e.length);
        for (int i = 0; i < px.length; i++) {
            out[i] = (px[i] - seen.observedPx()[i]) / PIXEL_STD;
        }
        double fx = CAMERA.get(PinholeCamera.FX);
        double fy = CAMERA.get(PinholeCamera.FY);
        out[px.length] = x[12] / FOCAL_STD;
        out[px.length + 1] = (x[13] - fy / fx * x[12]) / (fy * ASPECT_STD);
        System.arraycopy(e, 0, out, px.length + 2, e.length);
        return out;
    }

    private static double[][] jacobian(Observations seen, CameraState base, double[] x) {
        double[][] columns = new double[x.length][];
        for (int c = 0; c < x.length; c++) {
            double h = c >= 14 ? 1e-3 : c >= 12 ? 1e-2 : c % 6 < 3 ? 1e-2 : 1e-5;
            double[] plus = x.clone();
            double[] minus = x.clone();
            plus[c] += h;
            minus[c] -= h;
            double[] up = residuals(seen, base, plus);
            double[] down = residuals(seen, base, minus);
            columns[c] = new double[up.length];
            for (int r = 0; r < up.length; r++) {
                columns[c][r] = (up[r] - down[r]) / (2 * h);
            }
        }
        return new Array2DRowRealMatrix(columns, false).transpose().getData();
    }

    @Test
    void modeAndCovarianceAreThoseWithEveryPlacementErrorAsAnUnknown() {
        Observations seen = drawn(RandomStreams.of(5), lens(25, 27));
        List<PoseMode> modes = new CameraModeFinder(seen, CAMERA, new RigidMarkerNoise(seen, PIXEL_STD), PRIOR, null)
                .modes(CAMERAS);
        assertEquals(1, modes.size());
        PoseMode mode = modes.get(0);
        CameraState base = mode.state();
        assertEquals(14, mode.layout().size());
        double[] start = new double[14 + 6 * BODIES];
        start[12] = base.intrinsics[PinholeCamera.FX] - CAMERA.get(PinholeCamera.FX);
        start[13] = base.intrinsics[PinholeCamera.FY] - CAMERA.get(PinholeCamera.FY);
        int rows = residuals(seen, base, start).length;
        var optimum = new LevenbergMarquardtOptimizer().withCostRelativeTolerance(1e-14)
                .withParameterRelativeTolerance(1e-14).optimize(new LeastSquaresBuilder().start(start)
                .target(new double[rows]).maxEvaluations(1000).maxIterations(1000)
                .model(point -> new Pair<>(new ArrayRealVector(residuals(seen, base, point.toArray()), false),
                        new Array2DRowRealMatrix(jacobian(seen, base, point.toArray()), false))).build());
        double[] x = optimum.getPoint().toArray();
        SimpleMatrix j = new SimpleMatrix(jacobian(seen, base, x));
        SimpleMatrix covariance = j.transpose().mult(j).invert();
        for (int i = 0; i < 14; i++) {
            double std = Math.sqrt(covariance.get(i, i));
            assertEquals(i < 12 ? 0 : start[i], x[i], 1e-4 * std, "coordinate " + i);
            for (int k = 0; k < 14; k++) {
                assertEquals(covariance.get(i, k), mode.covariance()[14 * i + k],
                        1e-4 * std * Math.sqrt(covariance.get(k, k)), i + ", " + k);
            }
        }
        assertEquals(Math.pow(optimum.getCost(), 2) / 2, mode.halfChiSquare(), 1e-5 * mode.halfChiSquare());
        for (int b = 0; b < BODIES; b++) {
            for (int i = 0; i < 6; i++) {
                double error = 0;
                double std = 0;
                for (int k = 0; k < 6; k++) {
                    error += root(b)[i][k] * x[14 + 6 * b + k];
                    std = Math.hypot(std, root(b)[i][k]);
                }
                assertEquals(error, mode.placed().errors()[6 * b + i], 1e-4 * std, "error " + i + " of body " + b);
            }
        }
    }

    @Test
    void gradientAndHessianAreThoseOfNumericalDifferentiation() {
        // without errors the Hessian of half the sum of squares is that of Gauss and Newton
        Observations seen = observations(projected(CAMERAS, CAMERA, new double[6 * BODIES]));
        CameraState truth = CameraState.of(List.of(seen.cameraFromSet(CAMERAS.get(0)),
                seen.cameraFromSet(CAMERAS.get(1))), CAMERA);
        ReprojectionFit fit = new ReprojectionFit(seen.blocks(), seen.points(), seen.observed(), new double[0], 0,
                PRIOR, new PosePrior(truth, 300, 0.4));
        assertTrue(fit.freeze(new RigidMarkerNoise(seen, PIXEL_STD), truth));
        fit.evaluate(truth, true);
        double[] information = fit.information().clone();
        double[] h = new double[14];
        for (int i = 0; i < 14; i++) {
            h[i] = 0.02 / Math.sqrt(information[15 * i]);
        }
        for (int i = 0; i < 14; i++) {
            for (int k = 0; k <= i; k++) {
                double second = (cost(fit, truth, h, i, 1, k, 1) - cost(fit, truth, h, i, 1, k, -1)
                        - cost(fit, truth, h, i, -1, k, 1) + cost(fit, truth, h, i, -1, k, -1)) / (4 * h[i] * h[k]);
                double scale = Math.sqrt(information[15 * i] * information[15 * k]);
                assertEquals(second, information[14 * i + k], 1e-4 * scale, i + ", " + k);
            }
        }
        // and the gradient anywhere, of all rows at once
        CameraState off = moved(truth, h, 4, 70, 9, -50);
        off.intrinsics[PinholeCamera.FX] += 11;
        double[] jacobian = fit.jacobianAt(off);
        double[] residuals = fit.residuals().clone();
        for (int i = 0; i < 14; i++) {
            double slope = (cost(fit, off, h, i, 0.1, i, 0) - cost(fit, off, h, i, -0.1, i, 0)) / (0.2 * h[i]);
            double gradient = 0;
            for (int r = 0; r < fit.rows(); r++) {
                gradient += jacobian[14 * r + i] * residuals[r];
            }
            assertEquals(slope, gradient, 1e-5 * Math.max(Math.abs(slope), 1 / h[i]), "coordinate " + i);
        }
    }

    private static CameraState moved(CameraState from, double[] h, int i, double a, int k, double b) {
        double[] step = new double[14];
        step[i] += a * h[i];
        step[k] += b * h[k];
        CameraState state = new CameraState(2);
        state.setMoved(from, step, 0);
        state.intrinsics[PinholeCamera.FX] += step[12];
        state.intrinsics[PinholeCamera.FY] += step[13];
        return state;
    }

    private static double cost(ReprojectionFit fit, CameraState from, double[] h, int i, double a, int k, double b) {
        return fit.evaluate(moved(from, h, i, a, k, b), false);
    }

    /** With hardly any corner noise placement is all that errs: alike in both photos, and as in one of them alone. */
    @Test
    void twoPhotosFromOnePoseErrTogether() {
        ThesisScene scene = ThesisScene.inPlane(4).placement(5, 0.01);
        ReferenceView one = InitialPoseTest.view(scene, scene.exactDetections());
        Observations two = Observations.of(scene.cell().references(),
                List.of(scene.exactDetections(), scene.exactDetections()));
        PoseMode single = new CameraModeFinder(one, ThesisScene.CAMERA, new RigidMarkerNoise(one, 0.001),
                IntrinsicsPrior.KNOWN, null).modes(scene.worldFromCamera()).get(0);
        PoseMode both = new CameraModeFinder(two, ThesisScene.CAMERA, new RigidMarkerNoise(two, 0.001),
                IntrinsicsPrior.KNOWN, null).modes(List.of(scene.worldFromCamera(), scene.worldFromCamera())).get(0);
        for (int i = 0; i < 6; i++) {
            double variance = single.covariance()[7 * i];
            assertEquals(variance, both.covariance()[13 * i], 1e-3 * variance, "coordinate " + i);
            assertEquals(variance, both.covariance()[12 * i + 6 + i], 1e-3 * variance, "in common, " + i);
        }
    }

    @Test
    void whatDoesNotBelongTogetherIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> BlockLayout.of(2, new int[] {4}, new int[][] {{1, 0}}));
        assertThrows(IllegalArgumentException.class, () -> BlockLayout.of(2, new int[] {4}, new int[][] {{2}}));
        assertThrows(IllegalArgumentException.class, () -> BlockLayout.of(2, new int[] {4}, new int[][] {{}}));
        assertThrows(IllegalArgumentException.class, () -> observations(new double[8]));
        double[] indefinite = new double[36];
        indefinite[0] = 1;
        indefinite[7] = 1;
        indefinite[1] = 2;
        indefinite[6] = 2;
        assertThrows(IllegalArgumentException.class, () -> Body.of(1, PLATE, PLATE_POINTS, indefinite));
        assertArrayEquals(new double[] {3, 0}, new double[] {bodies().get(3).placementRoot(0, 0),
            bodies().get(3).placementRoot(2, 2)}, 1e-12);
    }
}
