package org.cellgauge.internal.posterior;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.pose.CameraModeFinder;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.internal.pose.ReferenceView;
import org.cellgauge.internal.pose.RigidMarkerNoise;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.vision.Detections;
import org.junit.jupiter.api.Test;

/**
 * Against Laplace's method over the placement errors of every reference at the very state, which the test works out for
 * itself: exact projection of rigidly moved markers, derivatives by differences, Newton steps until they settle.
 */
class MovingRigidLikelihoodTest {
    private static final double PIXEL_STD_PX = 0.05;

    private final ThesisScene scene = ThesisScene.inPlane(4).noObjects().placement(20, 0.035).pixelStd(PIXEL_STD_PX);
    private final Detections detections = scene.detections(PIXEL_STD_PX, RandomStreams.of(6), 20, 0.035);
    private final ReferenceView view = ReferenceView.of(scene.cell().references(), detections);
    private final RigidMarkerNoise noise = new RigidMarkerNoise(view, PIXEL_STD_PX);
    private final PoseMode mode = new CameraModeFinder(view, ThesisScene.CAMERA, noise,
            IntrinsicsPrior.focalAndAspect(ThesisScene.CAMERA, 60, 0.005), null).modes(scene.worldFromCamera()).get(0);

    private static double[] project(double[] k, RigidTransform cameraFromWorld, Reference r, double[] d) {
        double[] t = r.worldFromMarker().translationMm();
        for (int i = 0; i < 3; i++) {
            t[i] += d[i];
        }
        RigidTransform turn = RigidTransform.ofRotationVector(new double[] {d[3], d[4], d[5]}, new double[3])
                .compose(RigidTransform.of(r.worldFromMarker().rotation(), new double[3]));
        double[] c = MarkerGeometry.cornersMm(cameraFromWorld.compose(RigidTransform.of(turn.rotation(), t)),
                r.sizeMm());
        double[] px = new double[8];
        for (int i = 0; i < 4; i++) {
            px[2 * i] = k[PinholeCamera.FX] * c[3 * i] / c[3 * i + 2] + k[PinholeCamera.CX];
            px[2 * i + 1] = k[PinholeCamera.FY] * c[3 * i + 1] / c[3 * i + 2] + k[PinholeCamera.CY];
        }
        return px;
    }

    /** Log of the integral over one reference's errors, counted in their deviations, by Laplace's method. */
    private static double marginal(double[] k, RigidTransform cameraFromWorld, Reference r, double[] seenPx) {
        Placement p = r.placement();
        double[] s = {p.stdMm(0), p.stdMm(1), p.stdMm(2), p.stdRad(), p.stdRad(), p.stdRad()};
        double[] d = new double[6];
        double cost = 0;
        double[] h = new double[36];
        for (int round = 0; round < 8; round++) {
            double[] at = project(k, cameraFromWorld, r, d);
            double[][] j = new double[6][];
            double[] step = new double[6];
            cost = 0;
            for (int i = 0; i < 8; i++) {
                cost += 0.5 * Math.pow((at[i] - seenPx[i]) / PIXEL_STD_PX, 2);
            }
            for (int a = 0; a < 6; a++) {
                cost += 0.5 * Math.pow(d[a] / s[a], 2);
                double[] more = d.clone();
                double[] less = d.clone();
                more[a] += 1e-4 * s[a];
                less[a] -= 1e-4 * s[a];
                j[a] = project(k, cameraFromWorld, r, more);
                double[] below = project(k, cameraFromWorld, r, less);
                step[a] = -d[a] / s[a];
                for (int i = 0; i < 8; i++) {
                    j[a][i] = (j[a][i] - below[i]) / 2e-4 / PIXEL_STD_PX;
                    step[a] -= j[a][i] * (at[i] - seenPx[i]) / PIXEL_STD_PX;
                }
            }
            for (int a = 0; a < 6; a++) {
                for (int b = 0; b < 6; b++) {
                    h[6 * a + b] = a == b ? 1 : 0;
                    for (int i = 0; i < 8; i++) {
                        h[6 * a + b] += j[a][i] * j[b][i];
                    }
                }
            }
            Cholesky.factor(h, 6);
            Cholesky.solveLower(h, 6, step);
            Cholesky.solveUpper(h, 6, step);
            for (int a = 0; a < 6; a++) {
                d[a] += s[a] * step[a];
            }
        }
        return -cost - Cholesky.halfLogDeterminant(h, 6);
    }

    private double exact(CameraState state) {
        RigidTransform cameraFromWorld = view.worldFromCamera(state.cameraFromSet()).inverse();
        double sum = 0;
        for (Reference r : scene.cell().references()) {
            sum += marginal(state.intrinsics, cameraFromWorld, r, detections.find(r.id()).cornersPx());
        }
        return sum;
    }

    /** Camera and focal length so much farther and longer, which the image hardly tells. */
    private CameraState farther(double share) {
        CameraState state = mode.state();
        state.offset[2] *= 1 + share;
        state.intrinsics[PinholeCamera.FX] *= 1 + share;
        state.intrinsics[PinholeCamera.FY] *= 1 + share;
        return state;
    }

    @Test
    void farFromTheModeItIsThatOfErrorsIntegratedOutThere() {
        MovingRigidLikelihood moving = new MovingRigidLikelihood(view, mode, noise, null);
        RigidMarkerLikelihood frozen = new RigidMarkerLikelihood(view, mode);
        double apart = exact(mode.state()) - moving.at(mode.state());
        double off = 0;
        for (double share : new double[] {-0.15, -0.05, 0.05, 0.15}) {
            CameraState state = farther(share);
            double expected = exact(state) - apart;
            assertEquals(expected, moving.at(state), 0.15, share + " farther");
            off = Math.max(off, Math.abs(frozen.at(state) - frozen.at(mode.state()) + moving.at(mode.state())
                    - expected));
        }
        // what it is for: the frozen one is off by more than one there
        assertTrue(off > 1, "frozen off by " + off);
    }

    @Test
    void atTheModeItIsTheFrozenOne() {
        assertEquals(new RigidMarkerLikelihood(view, mode).at(mode.state()),
                new MovingRigidLikelihood(view, mode, noise, null).at(mode.state()), 1e-3);
    }

    @Test
    void nothingBehindTheCameraHasALikelihood() {
        CameraState behind = mode.state();
        behind.offset[2] = -behind.offset[2];
        assertEquals(Double.NEGATIVE_INFINITY, new MovingRigidLikelihood(view, mode, noise, null).at(behind));
    }
}
