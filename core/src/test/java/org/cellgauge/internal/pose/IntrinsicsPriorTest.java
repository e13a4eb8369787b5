package org.cellgauge.internal.pose;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.apache.commons.math3.distribution.MultivariateNormalDistribution;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.Reference;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.KannalaBrandtLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Estimate;
import org.cellgauge.settings.ModelSettings;
import org.cellgauge.settings.SettingTable;
import org.cellgauge.warning.CheckRefusal;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

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
        assertThrows(IllegalArgumentException.class,
                () -> IntrinsicsPrior.focalAndAspect(CAMERA, 200, Double.POSITIVE_INFINITY));
        assertThrows(IllegalArgumentException.class, () -> IntrinsicsPrior.of(CAMERA, new int[] {PinholeCamera.CX},
                new double[] {Double.POSITIVE_INFINITY}));
        for (double bad : new double[] {0, -1, Double.NaN}) {
            assertThrows(IllegalArgumentException.class, () -> IntrinsicsPrior.focalAndAspect(CAMERA, bad, ASPECT_STD));
            assertThrows(IllegalArgumentException.class, () -> IntrinsicsPrior.focalAndAspect(CAMERA, 200, bad));
        }
    }

    @Test
    void aFlatPriorSaysNothingOfTheFocalLengthButOfTheAspectRatio() {
        IntrinsicsPrior flat = IntrinsicsPrior.focalAndAspect(CAMERA, Double.POSITIVE_INFINITY, ASPECT_STD);
        assertTrue(flat.isFlat());
        assertEquals(0, flat.information(0, 1) * FX + flat.information(1, 1) * FY, 1e-9);
        assertEquals(flat.logDensity(withFocal(FX, FY)), flat.logDensity(withFocal(10 * FX, 10 * FY)), 1e-9);
        assertEquals(-0.5, flat.logDensity(withFocal(FX, FY * (1 + ASPECT_STD))), 1e-9);
    }

    @Test
    void aFieldOfViewSaysWhatTheFocalLengthIsAbout() {
        Cell cell = ThesisScene.oneRaised(4).camera(CAMERA).cell();
        CheckSettings settings = CheckSettings.builder().estimate(Estimate.FOCAL)
                .set(SettingTable.FIELD_OF_VIEW_DEG, OptionalDouble.of(90))
                .set(SettingTable.FOCAL_PRIOR_SHARE, OptionalDouble.of(0.1)).build();
        IntrinsicsPrior prior = IntrinsicsPrior.stated(cell, settings.model());
        // half the width is seen under 45 degrees
        double half = CAMERA.widthPx() / 2.0;
        assertEquals(half, prior.mean(0), 1e-9);
        assertEquals(half * FY / FX, prior.mean(1), 1e-9);
        assertEquals(half / 10, prior.std(0), 1e-9);
        assertEquals(half, IntrinsicsPrior.start(CAMERA, settings).get(PinholeCamera.FX), 1e-9);
        PinholeCamera start = IntrinsicsPrior.start(CAMERA, settings.toBuilder()
                .set(SettingTable.INITIAL_FOCAL_PX, OptionalDouble.of(250)).build());
        assertEquals(250, start.get(PinholeCamera.FX), 0);
        assertEquals(250 * FY / FX, start.get(PinholeCamera.FY), 1e-9);
        assertEquals(CAMERA.get(PinholeCamera.CX), start.get(PinholeCamera.CX), 0);
        PinholeCamera known = IntrinsicsPrior.start(CAMERA, CheckSettings.builder()
                .set(SettingTable.INITIAL_FOCAL_PX, OptionalDouble.of(250)).build());
        assertEquals(FX, known.get(PinholeCamera.FX), 0, "a known focal length is not searched for");
    }

    @Test
    void furtherCoefficientsAreUnknownWhereSomethingIsStatedOfThem() {
        Cell cell = ThesisScene.oneRaised(4).cell();
        CheckSettings.Builder settings = CheckSettings.builder().estimate(Estimate.INTRINSICS)
                .set(SettingTable.HIGHER_RADIAL_PRIOR_STD, OptionalDouble.of(0.3))
                .set(SettingTable.TANGENTIAL_PRIOR_STD, OptionalDouble.of(0.002));
        assertEquals("fx_px fy_px cx_px cy_px k1 k2 k3 p1 p2", names(IntrinsicsPrior.stated(cell,
                settings.build().model()), cell));
        PinholeCamera wide = PinholeCamera.of(KannalaBrandtLens.MODEL, 1280, 720,
                new double[] {400, 400, 640, 360, 0, 0, 0, 0, 0});
        Cell fisheye = cell.withCamera(wide);
        InputRefusedException refused = assertThrows(InputRefusedException.class,
                () -> IntrinsicsPrior.stated(fisheye, settings.build().model()));
        assertEquals(CheckRefusal.NO_TANGENTIAL_COEFFICIENTS, refused.refusal().kind());
        IntrinsicsPrior all = IntrinsicsPrior.stated(fisheye,
                settings.set(SettingTable.TANGENTIAL_PRIOR_STD, OptionalDouble.empty()).build().model());
        assertEquals("fx_px fy_px cx_px cy_px k1 k2 k3 k4", names(all, fisheye));
        assertEquals(0.3, all.std(7), 0);
        assertEquals(8, all.estimatedCount());
    }

    private static String names(IntrinsicsPrior prior, Cell cell) {
        List<String> names = cell.camera().lens().parameterNames();
        return IntStream.range(0, prior.count()).mapToObj(i -> names.get(prior.index(i)))
                .collect(Collectors.joining(" "));
    }

    @ParameterizedTest
    @CsvSource({"0, true", "15, true", "40, false"})
    void aFlatPriorTakesReferencesOutOfOnePlane(double raisedMm, boolean refused) {
        // placed to 5 mm
        List<Reference> references = new ArrayList<>();
        for (Reference r : ThesisScene.inPlane(4).cell().references()) {
            boolean last = references.size() == 3;
            double[] t = r.worldFromMarker().translationMm();
            references.add(new Reference(r.id(), r.sizeMm(), RigidTransform.ofEuler(t[0], t[1],
                    last ? raisedMm : 0, 0, 0, 0), r.placement()));
        }
        Cell cell = ThesisScene.inPlane(4).cell().withReferences(references);
        ModelSettings model = CheckSettings.builder().estimate(Estimate.FOCAL).focalPriorStdPx(Double.POSITIVE_INFINITY)
                .build().model();
        if (refused) {
            InputRefusedException e = assertThrows(InputRefusedException.class,
                    () -> IntrinsicsPrior.stated(cell, model));
            assertEquals(CheckRefusal.FLAT_FOCAL_IN_PLANE, e.refusal().kind());
        } else {
            assertTrue(IntrinsicsPrior.stated(cell, model).isFlat());
        }
    }
}
