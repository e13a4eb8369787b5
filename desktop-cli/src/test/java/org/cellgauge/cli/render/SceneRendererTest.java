package org.cellgauge.cli.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import boofcv.alg.distort.brown.LensDistortionBrown;
import boofcv.struct.calib.CameraPinholeBrown;
import boofcv.struct.distort.Point2Transform2_F64;
import georegression.struct.point.Point2D_F64;
import java.util.concurrent.ForkJoinPool;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.apache.commons.math3.special.Erf;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
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
        brown.fsetRadial(camera.get(PinholeCamera.K1), camera.get(PinholeCamera.K2));
        brown.fsetTangential(camera.get(PinholeCamera.P1), camera.get(PinholeCamera.P2));
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
        assertEquals(expected, sum / a.length, expected * 5 * Math.sqrt(2.0 / a.length));
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
}
