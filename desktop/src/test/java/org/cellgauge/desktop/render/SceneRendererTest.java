package org.cellgauge.desktop.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import boofcv.alg.distort.brown.LensDistortionBrown;
import boofcv.struct.calib.CameraPinholeBrown;
import boofcv.struct.distort.Point2Transform2_F64;
import georegression.struct.point.Point2D_F64;
import java.util.List;
import java.util.concurrent.ForkJoinPool;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.apache.commons.math3.special.Erf;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.vision.MarkerPattern;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.vision.GreyImage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SceneRendererTest {
    private static final double WALL = Backdrop.MEAN_REFLECTANCE;
    private static final double CONTRAST = WALL - PlanarMarker.BLACK;
    /** Above the world's origin, image x along world x, image y against world y. */
    private static final RigidTransform FROM_ABOVE = RigidTransform.ofEuler(0, 0, 1000, Math.PI, 0, 0);

    /**
     * Light that a black square takes away is its area in the image, and the centre of that light its centre of area;
     * both are closed forms of its outline, here projected by BoofCV's lens model in 400 pieces per edge.
     */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5, 6})
    void darknessHasAreaAndCentreOfTheProjectedSquare(int seed) {
        RandomGenerator random = new Well19937c(seed);
        boolean distorted = seed % 2 == 0;
        double k1 = distorted ? -0.3 : 0;
        double k2 = distorted ? 0.1 : 0;
        double p1 = distorted ? 0.001 : 0;
        double p2 = distorted ? -0.0015 : 0;
        PinholeCamera camera = PinholeCamera.of(320, 240,
                new double[] {150, 155, 161.3, 118.7, 0, k1, k2, 0, p1, p2});
        RigidTransform worldFromCamera = RigidTransform.ofEuler(30 * random.nextGaussian(), 20 * random.nextGaussian(),
                300, Math.PI + 0.25 * random.nextGaussian(), 0.25 * random.nextGaussian(), random.nextGaussian());
        RigidTransform worldFromMarker = RigidTransform.ofEuler(40 * random.nextGaussian(), 30 * random.nextGaussian(),
                0, 0, 0, random.nextGaussian());
        double size = 60;
        Scene scene = Scene.of(camera, worldFromCamera).quietZone(0)
                .marker(new SceneMarker(1, size, MarkerPattern.solidBlack(), worldFromMarker)).build();

        float[] light = SceneRenderer.light(scene, Sensor.IDEAL.withBlurPx(seed < 4 ? 0 : 0.8));
        double dark = 0;
        double darkU = 0;
        double darkV = 0;
        for (int i = 0; i < light.length; i++) {
            double share = (WALL - light[i]) / CONTRAST;
            dark += share;
            darkU += share * (i % camera.widthPx() + 0.5);
            darkV += share * (i / camera.widthPx() + 0.5);
        }

        double[][] outline = outlineByBoof(camera, worldFromCamera.inverse().compose(worldFromMarker), size);
        double area = 0;
        double areaU = 0;
        double areaV = 0;
        for (int i = 0; i < outline.length; i++) {
            double[] a = outline[i];
            double[] b = outline[(i + 1) % outline.length];
            double cross = a[0] * b[1] - b[0] * a[1];
            area += cross / 2;
            areaU += cross * (a[0] + b[0]) / 6;
            areaV += cross * (a[1] + b[1]) / 6;
        }
        // a shift of all four edges by 0.002 px would change the area by 0.2 px² here
        double edge = Math.sqrt(Math.abs(area));
        assertTrue(edge > 15, "the square must be in the image");
        assertEquals(Math.abs(area), dark, 0.002 * 4 * edge);
        assertEquals(areaU / area, darkU / dark, 0.002);
        assertEquals(areaV / area, darkV / dark, 0.002);
    }

    private static double[][] outlineByBoof(PinholeCamera camera, RigidTransform cameraFromMarker, double size) {
        CameraPinholeBrown brown = new CameraPinholeBrown();
        brown.fsetK(camera.get(PinholeCamera.FX), camera.get(PinholeCamera.FY), 0, camera.get(PinholeCamera.CX),
                camera.get(PinholeCamera.CY), camera.widthPx(), camera.heightPx());
        brown.fsetRadial(camera.get(BrownLens.K1), camera.get(BrownLens.K2));
        brown.fsetTangential(camera.get(BrownLens.P1), camera.get(BrownLens.P2));
        Point2Transform2_F64 toPixel = new LensDistortionBrown(brown).distort_F64(false, true);
        int pieces = 400;
        double[][] cornerSigns = {{-1, 1}, {1, 1}, {1, -1}, {-1, -1}, {-1, 1}};
        double[][] outline = new double[4 * pieces][2];
        Point2D_F64 uv = new Point2D_F64();
        for (int i = 0; i < outline.length; i++) {
            double[] a = cornerSigns[i / pieces];
            double[] b = cornerSigns[i / pieces + 1];
            double share = i % pieces / (double) pieces;
            double[] p = cameraFromMarker.apply((a[0] + share * (b[0] - a[0])) * size / 2,
                    (a[1] + share * (b[1] - a[1])) * size / 2, 0);
            toPixel.compute(p[0] / p[2], p[1] / p[2], uv);
            outline[i][0] = uv.x;
            outline[i][1] = uv.y;
        }
        return outline;
    }

    /** An edge along the pixel grid is the hardest case for a lattice of rays; its place follows from the row's sum. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.1, 0.25, 1.0 / 3, 0.4142, 0.5, 0.77, 0.9999})
    void edgeAlongThePixelGridLiesInItsPlace(double shiftPx) {
        // 1 px is 1 mm: the left edge falls at 30 + shift
        PinholeCamera camera = PinholeCamera.ideal(100, 80, 1000, 1000, 50, 40);
        Scene scene = Scene.of(camera, FROM_ABOVE).quietZone(0).marker(new SceneMarker(1, 40,
                MarkerPattern.solidBlack(), RigidTransform.ofEuler(shiftPx, 0, 0, 0, 0, 0))).build();
        float[] light = SceneRenderer.light(scene, Sensor.IDEAL);
        double left = 50;
        for (int column = 0; column < 50; column++) {
            left -= (WALL - light[40 * 100 + column]) / CONTRAST;
        }
        assertEquals(30 + shiftPx, left, 0.0024);
    }

    /** A blurred edge is the Gaussian's integral averaged over each pixel, wherever it falls within a pixel. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.2, 0.5, 0.8})
    void blurredEdgeHasTheGaussianProfileOfItsWidth(double shiftPx) {
        double blur = 0.7;
        PinholeCamera camera = PinholeCamera.ideal(100, 80, 1000, 1000, 50, 40);
        Scene scene = Scene.of(camera, FROM_ABOVE).quietZone(0).marker(new SceneMarker(1, 40,
                MarkerPattern.solidBlack(), RigidTransform.ofEuler(shiftPx, 0, 0, 0, 0, 0))).build();
        float[] light = SceneRenderer.light(scene, Sensor.IDEAL.withBlurPx(blur));
        for (int column = 25; column < 36; column++) {
            double edge = 30 + shiftPx;
            double dark = integralOfNormal((column + 1 - edge) / blur) - integralOfNormal((column - edge) / blur);
            double expected = WALL - CONTRAST * blur * dark;
            // 0.003 of the contrast: the tail cut off at four deviations and the parts' own width
            assertEquals(expected, light[40 * 100 + column], 0.003 * CONTRAST, "column " + column);
        }
    }

    /** Antiderivative of the standard normal distribution function: z F(z) + f(z). */
    private static double integralOfNormal(double z) {
        double cumulative = 0.5 * (1 + Erf.erf(z / Math.sqrt(2)));
        return z * cumulative + Math.exp(-z * z / 2) / Math.sqrt(2 * Math.PI);
    }

    @Test
    void nearerMarkerHidesTheFartherInWhicheverOrder() {
        PinholeCamera camera = PinholeCamera.ideal(100, 100, 500, 500, 50, 50);
        SceneMarker wall = new SceneMarker(1, 60, MarkerPattern.solidBlack(), RigidTransform.ofEuler(0, 0, 0, 0, 0, 0));
        // half as far from the camera and a third as wide, in front of the right half
        SceneMarker raised = new SceneMarker(2, 10, MarkerPattern.solidBlack(),
                RigidTransform.ofEuler(5, 0, 500, 0, 0, 0));
        Scene.Builder one = Scene.of(camera, FROM_ABOVE).quietZone(0.5).marker(wall).marker(raised);
        Scene.Builder other = Scene.of(camera, FROM_ABOVE).quietZone(0.5).marker(raised).marker(wall);
        float[] light = SceneRenderer.light(one.build(), Sensor.IDEAL);
        assertArrayEquals(light, SceneRenderer.light(other.build(), Sensor.IDEAL));
        // the raised one: ink over u 50..60, paper over 45..65; the one on the wall: ink over 35..65
        assertEquals(PlanarMarker.BLACK, light[50 * 100 + 40], 1e-6);
        assertEquals(PlanarMarker.WHITE, light[50 * 100 + 47], 1e-6);
        assertEquals(PlanarMarker.BLACK, light[50 * 100 + 55], 1e-6);
        assertEquals(PlanarMarker.WHITE, light[50 * 100 + 62], 1e-6);
        // its paper hides 20 x 20 of 30 x 30 px
        assertEquals(1 - 400.0 / 900, SceneTruth.of(one.build()).get(0).visibleShare(), 1e-9);
        assertEquals(1, SceneTruth.of(one.build()).get(1).visibleShare());
    }

    @Test
    void backOfAMarkerIsBlankPaper() {
        PinholeCamera camera = PinholeCamera.ideal(100, 100, 500, 500, 50, 50);
        Scene scene = Scene.of(camera, FROM_ABOVE).marker(new SceneMarker(1, 60, MarkerPattern.solidBlack(),
                RigidTransform.ofEuler(0, 0, 0, Math.PI, 0, 0))).build();
        assertEquals(PlanarMarker.WHITE, SceneRenderer.light(scene, Sensor.IDEAL)[50 * 100 + 50], 1e-6);
        assertFalse(SceneTruth.of(scene).get(0).whollyInside());
        assertEquals(0, SceneTruth.of(scene).get(0).visibleShare());
    }

    @Test
    void markerBehindTheCameraIsNotSeen() {
        PinholeCamera camera = PinholeCamera.ideal(64, 64, 500, 500, 32, 32);
        Scene scene = Scene.of(camera, FROM_ABOVE).marker(new SceneMarker(1, 60, MarkerPattern.solidBlack(),
                RigidTransform.ofEuler(0, 0, 1500, 0, 0, 0))).build();
        for (float value : SceneRenderer.light(scene, Sensor.IDEAL)) {
            assertEquals(WALL, value, 1e-6);
        }
        assertFalse(SceneTruth.of(scene).get(0).whollyInside());
    }

    @Test
    void markerAcrossTheImageBorderIsNotWhollyInside() {
        PinholeCamera camera = PinholeCamera.ideal(100, 100, 500, 500, 50, 50);
        Scene scene = Scene.of(camera, FROM_ABOVE).marker(new SceneMarker(1, 60, MarkerPattern.solidBlack(),
                RigidTransform.ofEuler(100, 0, 0, 0, 0, 0))).build();
        SceneTruth.MarkerInImage marker = SceneTruth.of(scene).get(0);
        assertFalse(marker.whollyInside());
        // its ink spans u 85 to 115, of which the image has one half
        assertEquals(0.5, marker.visibleShare(), 1e-9);
        assertArrayEquals(new double[] {85, 35}, marker.cornersPx()[0], 1e-9);
        assertArrayEquals(new double[] {115, 65}, marker.cornersPx()[2], 1e-9);
    }

    @Test
    void sameSeedSameBytesOnAnyNumberOfThreads() throws Exception {
        Scene scene = busyScene();
        GreyImage many = SceneRenderer.render(scene, Sensor.USUAL, new Well19937c(5));
        ForkJoinPool alone = new ForkJoinPool(1);
        try {
            GreyImage one = alone.submit(() -> SceneRenderer.render(scene, Sensor.USUAL, new Well19937c(5))).get();
            assertArrayEquals(many.luminance(), one.luminance());
        } finally {
            alone.shutdown();
        }
        int different = 0;
        GreyImage other = SceneRenderer.render(scene, Sensor.USUAL, new Well19937c(6));
        for (int i = 0; i < other.luminance().length; i++) {
            different += other.luminance()[i] == many.luminance()[i] ? 0 : 1;
        }
        // two draws of noise of 2 grey levels round to one value with probability 0.14
        assertTrue(different > 0.8 * other.luminance().length);
    }

    private static Scene busyScene() {
        return Scene.of(PinholeCamera.ideal(200, 150, 300, 300, 100, 75), FROM_ABOVE)
                .backdrop(Backdrop.textured(0.1, 3)).marker("square-binary", 5, 90,
                        RigidTransform.ofEuler(20, -10, 0, 0.2, 0.1, 0.4)).build();
    }

    /** Difference of two pictures of one scene: noise of both, and the rounding of both (1/12 each). */
    @Test
    void additiveNoiseHasItsDeviation() {
        Sensor sensor = Sensor.IDEAL.withNoiseGrey(3);
        assertNoise(3 * 3, sensor);
    }

    /** At full scale times WALL the electrons are WALL times the full well; their deviation is its square root. */
    @Test
    void shotNoiseIsThatOfTheElectrons() {
        double fullWell = 2000;
        double electrons = WALL * fullWell;
        double grey = 255 * Math.sqrt(electrons) / fullWell;
        assertNoise(grey * grey, Sensor.IDEAL.withFullWellElectrons(fullWell));
    }

    private static void assertNoise(double variance, Sensor sensor) {
        assertNoise(variance, sensor, 1);
    }

    /** @param correlation by what the error of the variance grows as pixels share noise */
    private static void assertNoise(double variance, Sensor sensor, double correlation) {
        Scene plain = Scene.of(PinholeCamera.ideal(200, 200, 300, 300, 100, 100), FROM_ABOVE).build();
        RandomGenerator random = new Well19937c(9);
        byte[] a = SceneRenderer.render(plain, sensor, random).luminance();
        byte[] b = SceneRenderer.render(plain, sensor, random).luminance();
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            double difference = (a[i] & 0xFF) - (b[i] & 0xFF);
            sum += difference * difference;
        }
        double expected = 2 * (variance + 1.0 / 12);
        // five standard errors of a variance from n values: 5 sqrt(2 / n)
        assertEquals(expected, sum / a.length, correlation * expected * 5 * Math.sqrt(2.0 / a.length));
    }

    @Test
    void toneCurveActsAfterTheLight() {
        Scene plain = Scene.of(PinholeCamera.ideal(8, 8, 300, 300, 4, 4), FROM_ABOVE).build();
        int linear = SceneRenderer.render(plain, Sensor.IDEAL, new Well19937c(1)).get(3, 3);
        int curved = SceneRenderer.render(plain, Sensor.IDEAL.withGamma(2.2), new Well19937c(1)).get(3, 3);
        assertEquals(Math.round(255 * WALL), linear);
        assertEquals(Math.round(255 * Math.pow(WALL, 1 / 2.2)), curved);
    }

    @Test
    void wallIsTheSameWhetherAMarkerIsNearOrNot() {
        // tiles near paper are rendered in parts and blurred, the others once per pixel: no seam may show
        PinholeCamera camera = PinholeCamera.ideal(96, 96, 581, 581, 48, 48);
        Scene.Builder bare = Scene.of(camera, FROM_ABOVE).backdrop(Backdrop.textured(0.2, 1));
        Scene.Builder with = Scene.of(camera, FROM_ABOVE).backdrop(Backdrop.textured(0.2, 1))
                .marker(new SceneMarker(1, 4, MarkerPattern.solidBlack(), RigidTransform.ofEuler(0, 0, 0, 0, 0, 0)));
        Sensor sensor = Sensor.USUAL;
        float[] alone = SceneRenderer.light(bare.build(), sensor);
        float[] near = SceneRenderer.light(with.build(), sensor);
        double largest = 0;
        for (int row = 0; row < 96; row++) {
            for (int column = 0; column < 96; column++) {
                if (Math.hypot(row - 47.5, column - 47.5) > 8) {
                    largest = Math.max(largest, Math.abs(alone[row * 96 + column] - near[row * 96 + column]));
                }
            }
        }
        // half a grey level
        assertTrue(largest < 0.5 / 255, "largest step " + 255 * largest + " grey levels");
    }

    // ---- what cameras and prints do

    /** A black square of 40 mm at 1 px per mm, its left edge at column 30, before a plain wall. */
    private static Scene square(double printGainMm) {
        return Scene.of(PinholeCamera.ideal(100, 80, 1000, 1000, 50, 40), FROM_ABOVE).quietZone(0.4)
                .printGainMm(printGainMm).marker(new SceneMarker(1, 40, MarkerPattern.solidBlack(),
                        RigidTransform.ofEuler(0, 0, 0, 0, 0, 0))).build();
    }

    /**
     * Blurring in light and the curve after it: the grey of a blurred edge is that of the light's Gaussian profile. At
     * gamma 2.2 the pixels beside the edge so lie far from half of the grey.
     */
    @ParameterizedTest
    @ValueSource(strings = {"linear", "srgb", "gamma 1.8", "gamma 2.2"})
    void greyOfABlurredEdgeIsTheCurveOfItsLight(String words) {
        ToneCurve curve = ToneCurve.of(words);
        double blur = 1.2;
        GreyImage image = SceneRenderer.render(square(0), Sensor.IDEAL.withBlurPx(blur).withToneCurve(curve),
                new Well19937c(1));
        for (int column = 26; column < 34; column++) {
            double dark = integralOfNormal((column + 1 - 30) / blur) - integralOfNormal((column - 30) / blur);
            double light = PlanarMarker.WHITE - (PlanarMarker.WHITE - PlanarMarker.BLACK) * blur * dark;
            // 0.003 of the contrast as for the light, the slope of the curves is at most 6 there; and rounding
            assertEquals(255 * curve.grey(light), image.get(column, 40), 0.5 + 255 * 0.003 * 6, "column " + column);
        }
    }

    @Test
    void lightBeyondFullScaleIsWhite() {
        Sensor sensor = Sensor.IDEAL.withToneCurve(ToneCurve.SRGB);
        GreyImage bright = SceneRenderer.render(square(0), sensor.withExposure(1.95), new Well19937c(1));
        GreyImage dark = SceneRenderer.render(square(0), sensor.withExposure(0.1), new Well19937c(1));
        assertEquals(255, bright.get(25, 40));
        assertEquals(Math.round(255 * ToneCurve.SRGB.grey(1.95 * PlanarMarker.BLACK)), bright.get(50, 40));
        assertEquals(Math.round(255 * ToneCurve.SRGB.grey(0.1 * PlanarMarker.WHITE)), dark.get(25, 40));
        assertEquals(Math.round(255 * ToneCurve.SRGB.grey(0.1 * PlanarMarker.BLACK)), dark.get(50, 40));
    }

    /** Beside a sharp edge of height h the blurred copy differs by h times the Gaussian's share on the other side. */
    @Test
    void unsharpMaskOvershootsByItsShareOfTheGaussian() {
        double amount = 0.5;
        double radius = 1.3;
        int far = 6;
        double[] weight = new double[far + 1];
        double total = 0;
        for (int k = -far; k <= far; k++) {
            total += Math.exp(-k * k / (2 * radius * radius));
        }
        for (int k = 0; k <= far; k++) {
            weight[k] = Math.exp(-k * k / (2 * radius * radius)) / total;
        }
        Sensor sensor = Sensor.IDEAL.withUnsharp(amount, radius);
        GreyImage image = SceneRenderer.render(square(0), sensor, new Well19937c(1));
        double white = 255 * PlanarMarker.WHITE;
        double black = 255 * PlanarMarker.BLACK;
        for (int away = 0; away < 5; away++) {
            double share = 0;
            for (int k = away + 1; k <= far; k++) {
                share += weight[k];
            }
            double overshoot = amount * (white - black) * share;
            assertEquals(Math.min(255, white + overshoot), image.get(29 - away, 40), 0.6, away + " px before the edge");
            assertEquals(Math.max(0, black - overshoot), image.get(30 + away, 40), 0.6, away + " px behind the edge");
        }
    }

    /** A mask of amount 1 doubles noise nearly, more exactly by the norm of its kernel. */
    @Test
    void unsharpMaskAmplifiesNoiseByTheNormOfItsKernel() {
        double amount = 1;
        double radius = 1;
        double norm = 0;
        double total = 0;
        for (int k = -4; k <= 4; k++) {
            total += Math.exp(-k * k / 2.0);
        }
        for (int x = -4; x <= 4; x++) {
            for (int y = -4; y <= 4; y++) {
                double kernel = (x == 0 && y == 0 ? 1 + amount : 0)
                        - amount * Math.exp(-(x * x + y * y) / 2.0) / (total * total);
                norm += kernel * kernel;
            }
        }
        assertNoise(norm * 4, Sensor.IDEAL.withNoiseGrey(2).withUnsharp(amount, radius), 1.5);
    }

    /** Ink that spreads adds a rim: 4 s g + 4 g² of a square of side s; where it shrinks, the same with -g. */
    @ParameterizedTest
    @ValueSource(doubles = {-1.3, -0.2, 0, 0.2, 0.75, 2})
    void printGainChangesTheAreaOfBlack(double gainMm) {
        float[] light = SceneRenderer.light(square(gainMm), Sensor.IDEAL);
        double dark = 0;
        for (int row = 12; row < 68; row++) {
            for (int column = 22; column < 78; column++) {
                dark += (PlanarMarker.WHITE - light[row * 100 + column]) / (PlanarMarker.WHITE - PlanarMarker.BLACK);
            }
        }
        double side = 40 + 2 * gainMm;
        // each edge within 0.0024 px
        assertEquals(side * side, dark, 0.0024 * 4 * side + 1e-3);
    }

    /** White cells shrink by the gain on all four sides: their area in the middle of a marker tells it. */
    @ParameterizedTest
    @ValueSource(doubles = {-0.4, 0.4})
    void printGainShrinksWhiteCells(double gainMm) {
        double area = 0;
        MarkerPattern pattern = MarkerPattern.of(MarkerFamily.of("square-binary"), 22);
        double cellMm = 5;
        // the area of all places farther than the gain from black, on a grid of a twentieth of a millimetre
        int fine = 100;
        for (int i = -fine; i < 9 * fine; i++) {
            for (int j = -fine; j < 9 * fine; j++) {
                double x = (i + 0.5) / fine * cellMm;
                double y = (j + 0.5) / fine * cellMm;
                boolean anyDark = false;
                boolean allDark = true;
                for (int corner = 0; corner < 4; corner++) {
                    double reach = Math.abs(gainMm);
                    int column = (int) Math.floor((x + (corner % 2 == 0 ? -reach : reach)) / cellMm);
                    int row = (int) Math.floor((y + (corner < 2 ? -reach : reach)) / cellMm);
                    boolean dark = row >= 0 && column >= 0 && row < 8 && column < 8 && !pattern.isWhite(row, column);
                    anyDark |= dark;
                    allDark &= dark;
                }
                area += (gainMm > 0 ? anyDark : allDark) ? cellMm * cellMm / fine / fine : 0;
            }
        }
        // 4 px per mm
        Scene scene = Scene.of(PinholeCamera.ideal(240, 240, 4000, 4000, 120, 120), FROM_ABOVE).quietZone(0.2)
                .printGainMm(gainMm).marker("square-binary", 22, 8 * cellMm, RigidTransform.ofEuler(0, 0, 0, 0, 0, 0))
                .build();
        float[] light = SceneRenderer.light(scene, Sensor.IDEAL);
        double dark = 0;
        for (int row = 20; row < 220; row++) {
            for (int column = 20; column < 220; column++) {
                dark += (PlanarMarker.WHITE - light[row * 240 + column]) / (PlanarMarker.WHITE - PlanarMarker.BLACK);
            }
        }
        assertEquals(area, dark / 16, 0.005 * area);
    }

    @Test
    void printGainOfHalfACellIsRefused() {
        Scene.Builder scene = Scene.of(PinholeCamera.ideal(8, 8, 300, 300, 4, 4), FROM_ABOVE)
                .marker("square-binary", 5, 40, RigidTransform.ofEuler(0, 0, 0, 0, 0, 0)).printGainMm(2.5);
        assertThrows(IllegalArgumentException.class, scene::build);
    }

    /** The quick picture is the whole one where a detector looks closely, and the wall's mean elsewhere. */
    @ParameterizedTest
    @ValueSource(doubles = {0, -0.25})
    void quickPictureIsTheWholeOneAroundMarkers(double k1) {
        double[] lens = PinholeCamera.ideal(200, 150, 300, 300, 100, 75).intrinsics();
        lens[BrownLens.K1] = k1;
        PinholeCamera camera = PinholeCamera.of(200, 150, lens);
        Scene scene = Scene.of(camera, FROM_ABOVE).marker("square-binary", 5, 90,
                RigidTransform.ofEuler(20, -10, 0, 0.2, 0.1, 0.4)).marker("square-binary", 9, 60,
                RigidTransform.ofEuler(-200, 100, 0, 0, 0, 0)).build();
        Sensor sensor = Sensor.USUAL.withNoiseGrey(0).withToneCurve(ToneCurve.SRGB).withUnsharp(0.6, 1);
        GreyImage whole = SceneRenderer.render(scene, sensor, new Well19937c(1));
        GreyImage quick = SceneRenderer.renderNearMarkers(scene, sensor, new Well19937c(1));
        List<SceneTruth.MarkerInImage> truth = SceneTruth.of(scene);
        int near = 0;
        int other = 0;
        for (int row = 0; row < 150; row++) {
            for (int column = 0; column < 200; column++) {
                boolean ofMarker = false;
                for (SceneTruth.MarkerInImage marker : truth) {
                    double u = 0;
                    double v = 0;
                    for (double[] corner : marker.cornersPx()) {
                        u += corner[0] / 4;
                        v += corner[1] / 4;
                    }
                    ofMarker |= Math.hypot(u - column - 0.5, v - row - 0.5) < 25;
                }
                near += ofMarker ? 1 : 0;
                // the wall's light is that of blocks of 8 px, and falls by 0.5 a grey level in 4 px here; a border is
                // within 0.0023 px where rays average it, which rounding to whole grey levels seldom shows
                assertEquals(whole.get(column, row), quick.get(column, row), ofMarker ? 1 : 2);
                other += ofMarker && whole.get(column, row) != quick.get(column, row) ? 1 : 0;
            }
        }
        assertTrue(near > 1500, "two markers are looked at closely");
        assertTrue(other < 0.03 * near, other + " of " + near);
    }

    @Test
    void quickPictureHasTheNoiseOfTheWholeOne() {
        Scene plain = Scene.of(PinholeCamera.ideal(200, 200, 300, 300, 100, 100), FROM_ABOVE).build();
        Sensor sensor = Sensor.IDEAL.withNoiseGrey(3).withFullWellElectrons(4000).withGamma(2.2);
        GreyImage whole = SceneRenderer.render(plain, sensor, new Well19937c(2));
        GreyImage quick = SceneRenderer.renderNearMarkers(plain, sensor, new Well19937c(2));
        // the table's 4096 draws have a deviation good to 1.1 %, that of the pixels to 0.35 %: four standard errors
        assertEquals(1, deviation(quick) / deviation(whole), 0.05);
        assertEquals(mean(whole), mean(quick), 4 * 5 / Math.sqrt(4096));
    }

    /** A mask makes neighbours of a wall differ by more, along rows and columns, near markers or not. */
    @Test
    void quickPictureHasTheBlueNoiseOfTheWholeOne() {
        Scene plain = Scene.of(PinholeCamera.ideal(400, 300, 300, 300, 200, 150), FROM_ABOVE).build();
        Sensor sensor = Sensor.IDEAL.withNoiseGrey(4).withUnsharp(0.8, 0.9);
        GreyImage whole = SceneRenderer.render(plain, sensor, new Well19937c(2));
        GreyImage quick = SceneRenderer.renderNearMarkers(plain, sensor, new Well19937c(3));
        // a patch of 192 x 192 draws stands for them: four standard errors
        double tolerance = 4 / Math.sqrt(192 * 192);
        assertEquals(1, deviation(quick) / deviation(whole), 4 / Math.sqrt(2 * 192 * 192));
        for (int[] lag : new int[][] {{1, 0}, {0, 1}, {1, 1}, {2, 0}}) {
            assertEquals(correlation(whole, lag[0], lag[1]), correlation(quick, lag[0], lag[1]), tolerance);
        }
        assertTrue(correlation(whole, 1, 0) < -3 * tolerance, "neighbours hang together");
    }

    private static double correlation(GreyImage image, int byX, int byY) {
        double mean = mean(image);
        double sum = 0;
        int count = 0;
        for (int row = byY; row < image.heightPx(); row++) {
            for (int column = byX; column < image.widthPx(); column++) {
                sum += (image.get(column, row) - mean) * (image.get(column - byX, row - byY) - mean);
                count++;
            }
        }
        return sum / count / (deviation(image) * deviation(image));
    }

    private static double mean(GreyImage image) {
        double sum = 0;
        for (byte b : image.luminance()) {
            sum += b & 0xFF;
        }
        return sum / image.luminance().length;
    }

    private static double deviation(GreyImage image) {
        double mean = mean(image);
        double sum = 0;
        for (byte b : image.luminance()) {
            sum += ((b & 0xFF) - mean) * ((b & 0xFF) - mean);
        }
        return Math.sqrt(sum / image.luminance().length);
    }
}
