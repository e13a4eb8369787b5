package org.cellgauge.internal.geometry;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.cellgauge.geometry.PinholeCamera;
import org.junit.jupiter.api.Test;

/** The camera of a stream follows from the sensor's calibration as Camera2's reference defines it. */
class SensorCalibrationTest {
    private static final float[] CALIBRATION = {3100, 3090, 2020, 1500, 2};
    private static final float[] DISTORTION = {0.11f, -0.23f, 0.07f, 0.0012f, -0.0021f};
    private static final PixelArea BEFORE = new PixelArea(8, 16, 4048, 3036);
    private static final PixelArea AFTER = new PixelArea(16, 22, 4032, 3024);

    /** Where a direction falls in the raw pixel array, written out from the reference; lens as taken or corrected. */
    private static double[] onSensor(double x, double y, boolean corrected) {
        double r2 = x * x + y * y;
        double radial = corrected ? 1 : 1 + DISTORTION[0] * r2 + DISTORTION[1] * r2 * r2 + DISTORTION[2] * r2 * r2 * r2;
        double k4 = corrected ? 0 : DISTORTION[3];
        double k5 = corrected ? 0 : DISTORTION[4];
        double xc = x * radial + k4 * (2 * x * y) + k5 * (r2 + 2 * x * x);
        double yc = y * radial + k5 * (2 * x * y) + k4 * (r2 + 2 * y * y);
        // K relative to the upper left of the area before correction
        return new double[] {3100 * xc + 2 * yc + 2020 + 8, 3090 * yc + 1500 + 16};
    }

    private static void assertProjects(PinholeCamera camera, boolean corrected, double left, double top, double scale) {
        RandomGenerator random = new Well19937c(1);
        for (int i = 0; i < 200; i++) {
            double x = 1.2 * (random.nextDouble() - 0.5);
            double y = 0.9 * (random.nextDouble() - 0.5);
            double[] raw = onSensor(x, y, corrected);
            double[] uv = camera.project(x, y, 1);
            assertEquals(scale * (raw[0] - left), uv[0], 1e-3);
            assertEquals(scale * (raw[1] - top), uv[1], 1e-3);
        }
    }

    @Test
    void aStreamOfTheActiveAreasShapeIsScaled() {
        SensorCalibration sensor = SensorCalibration.of(CALIBRATION, DISTORTION, BEFORE, AFTER);
        assertProjects(sensor.toCamera(1440, 1080, true), true, 16, 22, 1440 / 4032.0);
        assertProjects(sensor.toCamera(2024, 1518, false), false, 8, 16, 0.5);
        assertEquals(1440, sensor.toCamera(1440, 1080, true).widthPx());
        assertFalse(sensor.toCamera(1440, 1080, true).isDistorting());
    }

    @Test
    void aStreamOfAnotherShapeIsTheMiddleOfTheActiveArea() {
        SensorCalibration sensor = SensorCalibration.of(CALIBRATION, DISTORTION, BEFORE, AFTER);
        // 16:9 of 4032 x 3024 is 4032 x 2268, 378 px below the upper edge
        assertProjects(sensor.toCamera(1280, 720, true), true, 16, 22 + 378, 1280 / 4032.0);
        // 1:1 of 4048 x 3036 is 3036 x 3036, 506 px from the left edge
        assertProjects(sensor.toCamera(1012, 1012, false), false, 8 + 506, 16, 1012 / 3036.0);
    }

    /** The reference's own example: raw (25, 25) is (5, 5) of the processed image. */
    @Test
    void theExampleOfTheReferenceHolds() {
        float[] calibration = {100, 100, 25 - 10, 25 - 10, 0};
        PinholeCamera camera = SensorCalibration.of(calibration, null, new PixelArea(10, 10, 90, 90),
                new PixelArea(20, 20, 60, 60)).toCamera(60, 60, true);
        assertArrayEquals(new double[] {5, 5}, camera.project(0, 0, 1), 1e-9);
    }

    /** A perfectly built camera of (10, 10) px has its optical centre at (5.0, 5.0): centres of pixels are at +0.5. */
    @Test
    void theOpticalCentreOfAPerfectCameraIsTheMiddleOfAnyStream() {
        float[] calibration = {12, 12, 5, 5, 0};
        PixelArea array = new PixelArea(0, 0, 10, 10);
        PinholeCamera camera = SensorCalibration.of(calibration, null, array, array).toCamera(640, 480, false);
        assertEquals(320, camera.get(PinholeCamera.CX), 1e-9);
        assertEquals(240, camera.get(PinholeCamera.CY), 1e-9);
    }

    @Test
    void aDataSheetGivesTheFieldOfViewOfTheSensor() {
        // 4.4 mm lens before 5.6 x 4.2 mm: the edges of the full array are seen at atan(2.8 / 4.4)
        PixelArea active = new PixelArea(0, 0, 4000, 3000);
        SensorCalibration sensor = SensorCalibration.ofDataSheet(4.4, 5.6, 4.2, 4000, 3000, active);
        PinholeCamera camera = sensor.toCamera(640, 480, true);
        assertArrayEquals(new double[] {640, 480}, camera.project(2.8, 2.1, 4.4), 1e-9);
        assertEquals(2 * Math.atan(2.8 / 4.4), camera.horizontalFieldOfViewRad(), 1e-12);
        // a stream that shows less in height keeps the angle of its width
        assertEquals(2 * Math.atan(2.8 / 4.4), sensor.toCamera(1280, 720, true).horizontalFieldOfViewRad(), 1e-12);
    }

    @Test
    void whatIsNoCalibrationIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> SensorCalibration.of(new float[5], null, BEFORE, AFTER));
        assertThrows(IllegalArgumentException.class, () -> SensorCalibration.of(new float[4], null, BEFORE, AFTER));
        assertThrows(IllegalArgumentException.class,
                () -> SensorCalibration.of(CALIBRATION, new float[6], BEFORE, AFTER));
        assertThrows(IllegalArgumentException.class,
                () -> SensorCalibration.of(CALIBRATION, DISTORTION, BEFORE, AFTER).toCamera(0, 480, true));
        assertThrows(IllegalArgumentException.class,
                () -> SensorCalibration.ofDataSheet(0, 5.6, 4.2, 4000, 3000, BEFORE));
        assertThrows(IllegalArgumentException.class, () -> new PixelArea(0, 0, 0, 5));
        assertThrows(IllegalArgumentException.class, () -> new PixelArea(Double.NaN, 0, 5, 5));
    }
}
