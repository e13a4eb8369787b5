package org.cellgauge.internal.pose;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.apache.commons.math3.distribution.MultivariateNormalDistribution;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.PinholeCamera;
import org.junit.jupiter.api.Test;

class IntrinsicsPriorTest {
    private static final double FX = 600;
    private static final double FY = 606;
    private static final PinholeCamera CAMERA = PinholeCamera.ideal(1280, 720, FX, FY, 640, 360);
    private static final double FOCAL_STD_PX = 200;
    private static final double ASPECT_STD = 0.005;

    /** Of fy = (fy0 / fx0) (fx - fx0) + fy0 t + fy0, fx and t independent. */
    private static double[][] covariance() {
        double ratio = FY / FX;
        double common = ratio * FOCAL_STD_PX * FOCAL_STD_PX;
        double own = FY * ASPECT_STD;
        return new double[][] {{FOCAL_STD_PX * FOCAL_STD_PX, common}, {common, ratio * common + own * own}};
    }

    private static double[] withFocal(double fx, double fy) {
        double[] intrinsics = CAMERA.intrinsics();
        intrinsics[PinholeCamera.FX] = fx;
        intrinsics[PinholeCamera.FY] = fy;
        return intrinsics;
    }

    @Test
    void focalLengthAndAspectAreTheGaussianOfTheirSum() {
        IntrinsicsPrior prior = IntrinsicsPrior.focalAndAspect(CAMERA, FOCAL_STD_PX, ASPECT_STD);
        MultivariateNormalDistribution normal = new MultivariateNormalDistribution(new double[] {FX, FY}, covariance());
        double atMean = Math.log(normal.density(new double[] {FX, FY}));
        for (double[] f : new double[][] {{610, 606}, {590, 610}, {800, 808}, {350, 352}}) {
            double expected = Math.log(normal.density(f)) - atMean;
            assertEquals(expected, prior.logDensity(withFocal(f[0], f[1])), 1e-9 * Math.abs(expected));
        }
        assertEquals(FOCAL_STD_PX, prior.std(0), 1e-12);
        assertEquals(Math.sqrt(covariance()[1][1]), prior.std(1), 1e-10);
    }

    @Test
    void informationIsTheInverseOfTheCovariance() {
        IntrinsicsPrior prior = IntrinsicsPrior.focalAndAspect(CAMERA, FOCAL_STD_PX, ASPECT_STD);
        double[][] c = covariance();
        for (int i = 0; i < 2; i++) {
            for (int j = 0; j < 2; j++) {
                double product = prior.information(i, 0) * c[0][j] + prior.information(i, 1) * c[1][j];
                assertEquals(i == j ? 1 : 0, product, 1e-8);
            }
        }
    }

    @Test
    void rowsAreUndoneAndTheirDerivativeIsTheirChange() {
        IntrinsicsPrior prior = IntrinsicsPrior.focalAndAspect(CAMERA, FOCAL_STD_PX, ASPECT_STD);
        double[] at = withFocal(520, 531);
        double[] rows = {prior.whitened(0, at), prior.whitened(1, at)};
        double[] back = CAMERA.intrinsics();
        prior.setWhitened(rows, back);
        assertEquals(520, back[PinholeCamera.FX], 1e-9);
        assertEquals(531, back[PinholeCamera.FY], 1e-9);
        double[] movedX = withFocal(521, 531);
        double[] movedY = withFocal(520, 532);
        for (int i = 0; i < 2; i++) {
            assertEquals(prior.whitened(i, movedX) - rows[i], prior.whitening(i, 0), 1e-9);
            assertEquals(prior.whitened(i, movedY) - rows[i], prior.whitening(i, 1), 1e-9);
        }
    }

    @Test
    void independentFocalLengthsKnowNothingOfEachOther() {
        IntrinsicsPrior prior = IntrinsicsPrior.focal(CAMERA, FOCAL_STD_PX);
        assertEquals(0, prior.whitening(1, 0), 1e-12);
        assertEquals(-0.5 * (0.25 + 1), prior.logDensity(withFocal(FX + 100, FY - 200)), 1e-12);
    }

    /** Focal lengths, a principal point and a distortion that hang together, as after a calibration. */
    @Test
    void aJointPriorIsTheGaussianOfItsCovariance() {
        double[][] c = {{9, 8, 1.5, -0.02}, {8, 10, 0.5, -0.01}, {1.5, 0.5, 4, 0.003}, {-0.02, -0.01, 0.003, 1e-4}};
        int[] indices = {PinholeCamera.FX, PinholeCamera.FY, PinholeCamera.CX, BrownLens.K1};
        double[] flat = new double[16];
        for (int i = 0; i < 16; i++) {
            flat[i] = c[i / 4][i % 4];
        }
        IntrinsicsPrior prior = IntrinsicsPrior.joint(CAMERA, indices, flat);
        MultivariateNormalDistribution normal = new MultivariateNormalDistribution(new double[] {FX, FY, 640, 0}, c);
        double[] at = CAMERA.intrinsics();
        double[] offsets = {2, -1, 3, 0.007};
        double[] values = new double[4];
        double[] rows = new double[4];
        for (int i = 0; i < 4; i++) {
            at[indices[i]] += offsets[i];
            values[i] = at[indices[i]];
            assertEquals(Math.sqrt(c[i][i]), prior.std(i), 1e-12);
        }
        double expected = Math.log(normal.density(values)) - Math.log(normal.density(new double[] {FX, FY, 640, 0}));
        assertEquals(expected, prior.logDensity(at), 1e-9 * Math.abs(expected));
        for (int i = 0; i < 4; i++) {
            rows[i] = prior.whitened(i, at);
            for (int j = 0; j < 4; j++) {
                double product = 0;
                for (int k = 0; k < 4; k++) {
                    product += prior.information(i, k) * c[k][j];
                }
                assertEquals(i == j ? 1 : 0, product, 1e-8);
            }
        }
        double[] back = CAMERA.intrinsics();
        prior.setWhitened(rows, back);
        for (int i = 0; i < 4; i++) {
            assertEquals(values[i], back[indices[i]], 1e-9);
        }
        flat[1] = 20;
        flat[4] = 20;
        assertThrows(IllegalArgumentException.class, () -> IntrinsicsPrior.joint(CAMERA, indices, flat));
        assertThrows(IllegalArgumentException.class, () -> IntrinsicsPrior.joint(CAMERA, indices, new double[4]));
    }

    @Test
    void noFocalLengthBelowZeroHasDensity() {
        assertEquals(Double.NEGATIVE_INFINITY, IntrinsicsPrior.focalAndAspect(CAMERA, FOCAL_STD_PX, ASPECT_STD)
                .logDensity(withFocal(-1, -1)));
    }

    @Test
    void deviationsMustBePositive() {
        for (double bad : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
            assertThrows(IllegalArgumentException.class, () -> IntrinsicsPrior.focalAndAspect(CAMERA, bad, ASPECT_STD));
            assertThrows(IllegalArgumentException.class, () -> IntrinsicsPrior.focalAndAspect(CAMERA, 200, bad));
        }
    }
}
