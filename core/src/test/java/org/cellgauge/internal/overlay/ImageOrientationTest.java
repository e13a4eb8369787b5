package org.cellgauge.internal.overlay;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.statistics.Ellipse;
import org.junit.jupiter.api.Test;

class ImageOrientationTest {
    private static final int WIDTH = 7;
    private static final int HEIGHT = 4;

    private static List<ImageOrientation> all() {
        List<ImageOrientation> all = new ArrayList<>();
        for (int q = 0; q < 4; q++) {
            all.add(ImageOrientation.of(q, false));
            all.add(ImageOrientation.of(q, true));
        }
        return all;
    }

    /** An image turned clockwise once: what was the left column, read upwards, is the first row. */
    private static int[][] turned(int[][] image) {
        int[][] out = new int[image[0].length][image.length];
        for (int row = 0; row < out.length; row++) {
            for (int column = 0; column < image.length; column++) {
                out[row][column] = image[image.length - 1 - column][row];
            }
        }
        return out;
    }

    private static int[][] mirrored(int[][] image) {
        int[][] out = new int[image.length][image[0].length];
        for (int row = 0; row < out.length; row++) {
            for (int column = 0; column < out[0].length; column++) {
                out[row][column] = image[row][image[0].length - 1 - column];
            }
        }
        return out;
    }

    @Test
    void everyPixelLandsWhereTurningAndMirroringTheImagePutsIt() {
        int[][] image = new int[HEIGHT][WIDTH];
        for (int i = 0; i < HEIGHT * WIDTH; i++) {
            image[i / WIDTH][i % WIDTH] = i;
        }
        // turning once, by hand: the upper left corner goes to the upper right
        assertEquals(0, turned(image)[0][HEIGHT - 1]);
        assertEquals(WIDTH * (HEIGHT - 1), turned(image)[0][0]);
        for (ImageOrientation orientation : all()) {
            int[][] upright = image;
            for (int q = 0; q < orientation.quarterTurnsClockwise(); q++) {
                upright = turned(upright);
            }
            upright = orientation.mirrored() ? mirrored(upright) : upright;
            assertEquals(upright.length, orientation.uprightHeightPx(WIDTH, HEIGHT));
            assertEquals(upright[0].length, orientation.uprightWidthPx(WIDTH, HEIGHT));
            for (int row = 0; row < HEIGHT; row++) {
                for (int column = 0; column < WIDTH; column++) {
                    double[] centre = orientation.map(column + 0.5, row + 0.5, WIDTH, HEIGHT);
                    assertEquals(0.5, centre[0] - Math.floor(centre[0]), 1e-12);
                    assertEquals(image[row][column], upright[(int) centre[1]][(int) centre[0]], orientation.toString());
                }
            }
        }
    }

    @Test
    void theInverseLeadsBack() {
        for (ImageOrientation orientation : all()) {
            int w = orientation.uprightWidthPx(WIDTH, HEIGHT);
            int h = orientation.uprightHeightPx(WIDTH, HEIGHT);
            double[] points = {1.3, 2.9, 0, 0, 6.5, 3.5};
            double[] there = orientation.map(points, WIDTH, HEIGHT);
            assertArrayEquals(points, orientation.inverse().map(there, w, h), 1e-12, orientation.toString());
            assertEquals(WIDTH, orientation.inverse().uprightWidthPx(w, h));
        }
    }

    @Test
    void theBoundaryOfAnEllipseLiesOnTheMappedEllipse() {
        for (double angle : new double[] {0.3, -1.2, Math.PI / 2, 0}) {
            Ellipse ellipse = new Ellipse(4.2, 1.1, 2.0, 0.5, angle);
            for (ImageOrientation orientation : all()) {
                Ellipse mapped = orientation.map(ellipse, WIDTH, HEIGHT);
                assertEquals(2.0, mapped.semiMajor());
                assertEquals(0.5, mapped.semiMinor());
                for (double[] p : ellipse.boundary(16)) {
                    double[] q = orientation.map(p[0], p[1], WIDTH, HEIGHT);
                    double dx = q[0] - mapped.centreX();
                    double dy = q[1] - mapped.centreY();
                    double along = (Math.cos(mapped.angleRad()) * dx + Math.sin(mapped.angleRad()) * dy) / 2.0;
                    double across = (-Math.sin(mapped.angleRad()) * dx + Math.cos(mapped.angleRad()) * dy) / 0.5;
                    assertEquals(1, along * along + across * across, 1e-9, orientation + ", " + angle);
                }
            }
        }
        assertNull(ImageOrientation.of(1, true).map((Ellipse) null, WIDTH, HEIGHT));
    }

    /**
     * Independent of Android's rule: by the directions of the device. Its axes in natural orientation are x right, y
     * up, z towards the user. Whatever lies in direction x of the device must be shown in direction x of its screen, as
     * a window (back camera) or a mirror (front camera) would.
     */
    @Test
    void cameraImagesStandUprightOnTheDisplayHoweverTheDeviceIsHeld() {
        int combinations = 0;
        for (int sensor = 0; sensor < 360; sensor += 90) {
            for (int display = 0; display < 360; display += 90) {
                for (boolean front : new boolean[] {false, true}) {
                    ImageOrientation orientation = ImageOrientation.of(sensor, display, front);
                    // right and up of the image if the sensor were not turned: the back camera looks along -z, the
                    // front camera along +z, so that its right is the device's left
                    double[] right = {front ? -1 : 1, 0};
                    double[] up = {0, 1};
                    // the image comes turned anticlockwise by the sensor's angle, as turning it clockwise makes it
                    // upright: the direction that the image shows at its top is the one upright shows at angle s
                    // clockwise from top
                    double s = Math.toRadians(sensor);
                    double[] imageUp = combine(Math.cos(s), up, Math.sin(s), right);
                    double[] imageRight = combine(-Math.sin(s), up, Math.cos(s), right);
                    // what is drawn is turned clockwise from the device's natural orientation by the display's angle
                    double d = Math.toRadians(display);
                    double[] screenUp = {Math.sin(d), Math.cos(d)};
                    double[] screenRight = {Math.cos(d), -Math.sin(d)};
                    for (double[] of : new double[][] {{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
                        // of: a step in the image, u right and v down
                        double[] device = combine(of[0], imageRight, -of[1], imageUp);
                        double[] from = orientation.map(0, 0, WIDTH, HEIGHT);
                        double[] to = orientation.map(of[0], of[1], WIDTH, HEIGHT);
                        double[] shown = {dot(device, screenRight), -dot(device, screenUp)};
                        assertArrayEquals(shown, new double[] {to[0] - from[0], to[1] - from[1]}, 1e-12,
                                "sensor " + sensor + ", display " + display + (front ? ", front" : ", back"));
                    }
                    combinations++;
                }
            }
        }
        assertEquals(32, combinations);
    }

    private static double[] combine(double a, double[] x, double b, double[] y) {
        return new double[] {a * x[0] + b * y[0], a * x[1] + b * y[1]};
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1];
    }

    /** What most phones have: sensor 90 at the back, 270 in front. */
    @Test
    void usualDevicesTurnAsTheirUsersKnowThem() {
        assertEquals(ImageOrientation.of(1, false), ImageOrientation.of(90, 0, false));
        assertTrue(ImageOrientation.of(90, 90, false).isIdentity());
        assertEquals(ImageOrientation.of(2, false), ImageOrientation.of(90, 270, false));
        assertEquals(ImageOrientation.of(3, true), ImageOrientation.of(270, 0, true));
        assertEquals(ImageOrientation.of(0, true), ImageOrientation.of(270, 90, true));
        assertThrows(IllegalArgumentException.class, () -> ImageOrientation.of(45, 0, false));
        assertEquals(ImageOrientation.of(3, false), ImageOrientation.of(-1, false));
    }

    @Test
    void theIdentityGivesBackWhatItGets() {
        Ellipse ellipse = new Ellipse(1, 2, 3, 1, 0.3);
        assertSame(ellipse, ImageOrientation.IDENTITY.map(ellipse, WIDTH, HEIGHT));
        assertArrayEquals(new double[] {0.1, 0.2}, ImageOrientation.IDENTITY.map(0.1, 0.2, WIDTH, HEIGHT), 0);
    }

    @Test
    void aFittedImageLiesInTheMiddleOfTheView() {
        // 1080 / 720 = 1.5 fills the width, 1794 / 1280 = 1.4016 the height
        ViewFit crop = ViewFit.centreCrop(720, 1280, 1080, 1794);
        assertEquals(1.5, crop.scale(), 1e-12);
        assertArrayEquals(new double[] {0, -63}, crop.toView(0, 0), 1e-9);
        assertArrayEquals(new double[] {1080, 1794 + 63}, crop.toView(720, 1280), 1e-9);
        ViewFit whole = ViewFit.fit(720, 1280, 1080, 1794);
        assertEquals(1794 / 1280.0, whole.scale(), 1e-12);
        assertArrayEquals(new double[] {540, 897}, whole.toView(360, 640), 1e-9);
        assertEquals(0, whole.dy(), 1e-12);
        assertTrue(whole.dx() > 0);
        for (ViewFit fit : new ViewFit[] {crop, whole}) {
            double[] there = fit.toView(12.5, 700);
            assertArrayEquals(new double[] {12.5, 700}, fit.toImage(there[0], there[1]), 1e-9);
        }
        assertThrows(IllegalArgumentException.class, () -> ViewFit.fit(0, 1, 1, 1));
    }
}
