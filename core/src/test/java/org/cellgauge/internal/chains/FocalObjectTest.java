package org.cellgauge.internal.chains;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.Rotations;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.sampling.Draws;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Estimate;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Where the focal length is unknown, an object's pose is drawn anew for every draw of the camera. Held against a random
 * walk that shares no code with it: for each camera draw the walk goes on until it has forgotten its start.
 */
class FocalObjectTest {
    private static final double SIZE_MM = ThesisScene.SIZE_MM;
    private static final int OBJECT = 5;
    private static final int WALK = 500;
    private static final double[] TILTS_RAD = {0.01, 0.05, 0.25};

    /** Half the sum of squares of a pose before the camera, by a projection of its own. */
    private static double half(double[] p, double[] r, double fx, double fy, double[] seenPx, double stdPx) {
        double h = SIZE_MM / 2;
        // top left, top right, bottom right, bottom left
        double[] xs = {-h, h, h, -h};
        double[] ys = {h, h, -h, -h};
        double sum = 0;
        for (int k = 0; k < 4; k++) {
            double x = p[0] + r[0] * xs[k] + r[1] * ys[k];
            double y = p[1] + r[3] * xs[k] + r[4] * ys[k];
            double z = p[2] + r[6] * xs[k] + r[7] * ys[k];
            double du = fx * x / z + 640 - seenPx[2 * k];
            double dv = fy * y / z + 360 - seenPx[2 * k + 1];
            sum += du * du + dv * dv;
        }
        return 0.5 * sum / (stdPx * stdPx);
    }

    private static double[] turned(double[] by, double[] rotation) {
        double[] turn = new double[9];
        double[] out = new double[9];
        Rotations.exp(by[0], by[1], by[2], turn);
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                for (int k = 0; k < 3; k++) {
                    out[3 * i + j] += turn[3 * i + k] * rotation[3 * k + j];
                }
            }
        }
        return out;
    }

    /**
     * One exact draw of the object's pose given the focal lengths, near enough: {@value #WALK} steps of Metropolis in
     * position along and across the line of sight, and turns from the left, which leave Haar measure alone.
     */
    private static void walk(double[] p, double[][] r, double fx, double fy, double[] seenPx, double stdPx,
            RandomGenerator random) {
        double now = half(p, r[0], fx, fy, seenPx, stdPx);
        double across = 1.2 * stdPx / 2 * p[2] / fx;
        double along = 1.2 * stdPx / 2 * p[2] / fx / SIZE_MM;
        for (int i = 0; i < WALK; i++) {
            double scale = Math.exp(along * random.nextGaussian());
            double[] to = {(p[0] + across * random.nextGaussian()) * scale,
                (p[1] + across * random.nextGaussian()) * scale, p[2] * scale};
            double tilt = TILTS_RAD[random.nextInt(TILTS_RAD.length)];
            double[] rotation = turned(new double[] {tilt * random.nextGaussian(), tilt * random.nextGaussian(),
                0.03 * stdPx * random.nextGaussian()}, r[0]);
            double then = half(to, rotation, fx, fy, seenPx, stdPx);
            // volume grows by scale³ under the step along the line of sight
            if (Math.log(1 - random.nextDouble()) <= now - then + 3 * Math.log(scale)) {
                System.arraycopy(to, 0, p, 0, 3);
                r[0] = rotation;
                now = then;
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"5, 1, 0.3", "25, 20, 0.05"})
    void anObjectFollowsTheFocalLengthAsAnIndependentWalkDoes(double tiltDeg, double placementMm, double stdPx) {
        RigidTransform truth = RigidTransform.ofEuler(418, 106, 0, Math.toRadians(-3), Math.toRadians(tiltDeg), 0.4);
        RandomGenerator random = RandomStreams.of(5);
        ThesisScene scene = ThesisScene.inPlane(4).noObjects().placement(placementMm, 0.003).pixelStd(stdPx)
                .object(OBJECT, truth);
        CheckResult result = CellCheck.run(scene.cell(), scene.exactDetections(), CheckSettings.builder().seed(3)
                .estimate(Estimate.FOCAL).targetMcseStdRel(0.02).build());
        double[] seenPx = result.detections().find(OBJECT).cornersPx();
        int camera = result.layout().indexOf(Quantity.camera(Quantity.Axis.X));
        int focal = result.layout().indexOf(Quantity.intrinsic("fx_px"));
        int object = result.layout().indexOf(Quantity.object(5, Quantity.Axis.X));
        int thin = Math.max(1, result.draws().size() * result.draws().get(0).count() / 1100);
        double sum = 0;
        double squares = 0;
        double sumOfOurs = 0;
        int n = 0;
        for (Draws chain : result.draws()) {
            double[] p = null;
            double[][] r = new double[1][];
            for (int i = 0; i < chain.count(); i += thin) {
                double fx = chain.get(focal, i);
                RigidTransform worldFromCamera = RigidTransform.ofEuler(chain.get(camera, i), chain.get(camera + 1, i),
                        chain.get(camera + 2, i), chain.get(camera + 3, i), chain.get(camera + 4, i),
                        chain.get(camera + 5, i));
                if (p == null) {
                    RigidTransform start = worldFromCamera.inverse().compose(truth);
                    p = start.translationMm();
                    r[0] = start.rotation();
                } else {
                    // starts at the depth that goes with the focal length
                    p[2] *= fx / chain.get(focal, i - thin);
                }
                walk(p, r, fx, chain.get(focal + 1, i), seenPx, stdPx, random);
                double z = worldFromCamera.apply(p)[2];
                sum += z;
                squares += z * z;
                sumOfOurs += chain.get(object + 2, i);
                n++;
            }
        }
        double std = Math.sqrt(squares / n - Math.pow(sum / n, 2));
        // both hang on the same camera draws; what is left is chance of the objects' part
        double chance = 1 / Math.sqrt(n);
        assertTrue(chance < 0.033, n + " draws");
        assertEquals(std, result.estimate().object(OBJECT).pose().std()[2], 2.5 * chance * std);
        assertEquals(sum / n, sumOfOurs / n, 3 * chance * std);
    }
}
