package org.cellgauge.android.screen;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import android.graphics.Bitmap;
import android.graphics.Matrix;
import android.view.Surface;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.cellgauge.android.R;
import org.cellgauge.android.camera.CameraSetup;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.internal.overlay.Box;
import org.cellgauge.internal.overlay.CellOverlay;
import org.cellgauge.internal.overlay.Overlay;
import org.cellgauge.internal.overlay.OverlayStyle;
import org.cellgauge.internal.overlay.Role;
import org.cellgauge.internal.overlay.Shape;
import org.cellgauge.internal.overlay.TextShape;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.statistics.Ellipse;
import org.cellgauge.vision.BoofMarkerDetector;
import org.cellgauge.vision.MarkerObservation;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.annotation.Config;

/**
 * A rendered frame fed in as a camera's comes out as ellipses at the right pixels of the view, however the device is
 * held and whichever way the camera looks. What is right is worked out here from the check of the frame alone.
 */
@RunWith(RobolectricTestRunner.class)
@Config(application = TestApp.class, minSdk = 27)
public class OverlayOnFrameTest {
    private static final int WIDTH = 1280;
    private static final int HEIGHT = 720;
    /** A capital letter of 12 sp, but for the pixel that may be lost where the view is laid out. */
    private static final double SMALLEST_CAP_DP = 8.4;
    /** How the sensor lies in most phones; tablets have it at 0 or 270 degrees, some of either at 180. */
    private static final int SENSOR_DEG = 90;
    private static final int POINTS = 60;
    /** Share of an ellipse's points that labels and axes may lie over. */
    private static final double LABELS_HIDE = 0.1;
    /** How many times as large an ellipse is where nothing is drawn: outside its own line, short of its neighbour's. */
    private static final double AROUND = 1.35;

    /** Quarter turns clockwise from a frame to the display, by how the device's makers count angles: see the Android
     * reference of SENSOR_ORIENTATION, which has the sum for a front camera and the difference for a back camera. */
    private static int quarterTurns(int sensorDeg, int displayDeg, boolean front) {
        return ((front ? sensorDeg + displayDeg : sensorDeg - displayDeg + 360) / 90) % 4;
    }

    /**
     * Where a point of the frame lies on the upright picture: rows a, b, c, d, e, f of (a u + b v + c, d u + e v + f).
     */
    private static double[] upright(double u, double v, int turns, boolean mirrored) {
        double[][] turn = {{1, 0, 0, 0, 1, 0}, {0, -1, HEIGHT, 1, 0, 0}, {-1, 0, WIDTH, 0, -1, HEIGHT},
            {0, 1, 0, -1, 0, WIDTH}};
        double[] t = turn[turns];
        double x = t[0] * u + t[1] * v + t[2];
        double y = t[3] * u + t[4] * v + t[5];
        double width = turns % 2 == 0 ? WIDTH : HEIGHT;
        return new double[] {mirrored ? width - x : x, y};
    }

    /** The upright picture fills the view. */
    private static double[] inView(double[] p, int turns, int viewWidth, int viewHeight) {
        double width = turns % 2 == 0 ? WIDTH : HEIGHT;
        double height = turns % 2 == 0 ? HEIGHT : WIDTH;
        double scale = Math.max(viewWidth / width, viewHeight / height);
        return new double[] {viewWidth / 2.0 + scale * (p[0] - width / 2),
            viewHeight / 2.0 + scale * (p[1] - height / 2)};
    }

    static CheckResult checkOfTheFrame() {
        Fixture fixture = Fixture.LIFTED;
        return CellCheck.run(fixture.cell(),
                BoofMarkerDetector.forCell(fixture.cell()).detect(fixture.image(), "frame"),
                CheckSettings.builder().build());
    }

    /** Sensors lie along the device's longer side, whichever way up the device is by nature. */
    private static Screen held(int sensorDeg, int displayRotation, boolean front) {
        turn(sensorDeg, displayRotation);
        Screen screen = Screen.live(Fixture.LIFTED.document(), sensorDeg, front);
        screen.holdStillUntilResult(Fixture.LIFTED);
        return screen;
    }

    private static void turn(int sensorDeg, int displayRotation) {
        boolean landscape = (sensorDeg / 90 + displayRotation) % 2 == 0;
        RuntimeEnvironment.setQualifiers(landscape ? Screen.TABLET_LANDSCAPE : Screen.TABLET_PORTRAIT);
        Screen.turnDisplay(displayRotation);
    }

    @Test
    public void shapesLieOnTheirPixelsInEveryRotationAndMirrored() {
        assertShapesOnPixels(SENSOR_DEG, Surface.ROTATION_0, Surface.ROTATION_90, Surface.ROTATION_180,
                Surface.ROTATION_270);
    }

    /**
     * Each at one display rotation; on the newest Android only, since which way is up is the app's own reckoning and
     * the test above runs on both.
     */
    @Test
    @Config(minSdk = 27)
    public void shapesLieOnTheirPixelsHoweverTheSensorLies() {
        assertShapesOnPixels(0, Surface.ROTATION_90);
        assertShapesOnPixels(180, Surface.ROTATION_270);
        assertShapesOnPixels(270, Surface.ROTATION_0);
    }

    private static void assertShapesOnPixels(int sensorDeg, int... rotations) {
        CheckResult expected = checkOfTheFrame();
        Overlay desktop = CellOverlay.of(expected, OverlayStyle.PHOTO.withoutPanels());
        for (int rotation : rotations) {
            for (boolean front : new boolean[] {false, true}) {
                String held = "sensor at " + sensorDeg + ", display at " + rotation * 90 + " degrees, "
                        + (front ? "front" : "back");
                int turns = quarterTurns(sensorDeg, 90 * rotation, front);
                try (Screen screen = held(sensorDeg, rotation, front)) {
                    assertEllipsesOnPixels(screen, expected, held, turns, front);
                    assertShapesOfTheDesktop(screen.state().overlay(), desktop, turns, front);
                    screen.tap(R.id.freeze);
                    assertHeldFrameBelow(screen, turns, front);
                }
            }
        }
    }

    @Test
    public void figuresInThePictureAreAsLargeAsTheSmallestTextOfTheScreenHoweverSmallThePictureIs() {
        for (String qualifiers : new String[] {Screen.TABLET_LANDSCAPE, Screen.TABLET_PORTRAIT,
            Screen.PHONE_LANDSCAPE, Screen.PHONE_PORTRAIT}) {
            RuntimeEnvironment.setQualifiers(qualifiers);
            Screen.turnDisplay(qualifiers.contains("-land") ? Surface.ROTATION_90 : Surface.ROTATION_0);
            try (Screen screen = Screen.live(Fixture.LIFTED.document(), SENSOR_DEG, false)) {
                screen.holdStillUntilResult(Fixture.LIFTED);
                OverlayView view = screen.find(R.id.overlay);
                Overlay overlay = screen.state().overlay();
                double density = view.getResources().getDisplayMetrics().density;
                double dpPerPx = view.getWidth() / density / overlay.widthPx();
                int figures = 0;
                for (Shape shape : overlay.shapes(Role.LABEL)) {
                    if (shape instanceof TextShape && ((TextShape) shape).text().contains("\u03c3")) {
                        figures++;
                        double capDp = ((TextShape) shape).capHeightPx() * dpPerPx;
                        assertTrue(qualifiers + ": " + capDp + " dp", capDp >= SMALLEST_CAP_DP);
                    }
                }
                assertEquals(qualifiers, 4, figures);
            }
        }
    }

    static void assertEllipsesOnPixels(Screen screen, CheckResult expected, String held, int turns,
            boolean front) {
        OverlayView view = screen.find(R.id.overlay);
        Overlay whole = screen.state().overlay();
        Bitmap drawn = Screen.picture(view);
        // by themselves, to see that there is nothing where they are not
        view.setOverlay(new Overlay(whole.widthPx(), whole.heightPx(), whole.status(), whole.magnification(),
                whole.gridSpacingMm(), whole.shapes(Role.OBJECT_ELLIPSE)));
        Bitmap alone = Screen.picture(view);
        view.setOverlay(whole);
        for (ObjectEstimate object : expected.estimate().objects()) {
            Ellipse e = object.ellipse95Px();
            double m = whole.magnification();
            String what = held + ", ellipse of object " + object.id() + ": ";
            assertEquals(what + "drawn", 1, greenShare(drawn, e, m, turns, front), LABELS_HIDE);
            assertEquals(what + "drawn alone", 1, greenShare(alone, e, m, turns, front), 0);
            assertEquals(what + "within", 0, greenShare(alone, e, 0.2 * m, turns, front), 0);
            assertEquals(what + "around", 0, greenShare(alone, e, AROUND * m, turns, front), 0);
        }
    }

    /** Share of an ellipse's points that are drawn in the colour of what is within its target. */
    private static double greenShare(Bitmap drawn, Ellipse e, double magnification, int turns, boolean mirrored) {
        int green = 0;
        for (int i = 0; i < POINTS; i++) {
            double t = 2 * Math.PI * i / POINTS;
            double a = magnification * e.semiMajor() * Math.cos(t);
            double b = magnification * e.semiMinor() * Math.sin(t);
            double u = e.centreX() + a * Math.cos(e.angleRad()) - b * Math.sin(e.angleRad());
            double v = e.centreY() + a * Math.sin(e.angleRad()) + b * Math.cos(e.angleRad());
            double[] p = inView(upright(u, v, turns, mirrored), turns, drawn.getWidth(), drawn.getHeight());
            green += isGreenAt(drawn, (int) Math.floor(p[0]), (int) Math.floor(p[1])) ? 1 : 0;
        }
        return (double) green / POINTS;
    }

    /** The line is little more than a pixel wide: at the pixel or a direct neighbour of it. */
    private static boolean isGreenAt(Bitmap drawn, int x, int y) {
        return isGreen(drawn, x, y) || isGreen(drawn, x - 1, y) || isGreen(drawn, x + 1, y) || isGreen(drawn, x, y - 1)
                || isGreen(drawn, x, y + 1);
    }

    private static boolean isGreen(Bitmap drawn, int x, int y) {
        if (x < 0 || y < 0 || x >= drawn.getWidth() || y >= drawn.getHeight()) {
            return false;
        }
        int c = drawn.getPixel(x, y);
        // 14B98A, a line of little more than a pixel on a darker rim
        return (c >>> 24) > 150 && (c >> 8 & 0xFF) > 90 && (c >> 8 & 0xFF) > 2 * (c >> 16 & 0xFF) && (c & 0xFF) > 60;
    }

    private static void assertShapesOfTheDesktop(Overlay shown, Overlay desktop, int turns, boolean front) {
        assertEquals(desktop.magnification(), shown.magnification(), 0);
        for (Role role : Arrays.asList(Role.OBJECT_OUTLINE, Role.REFERENCE_OUTLINE, Role.REFERENCE_EXPECTED,
                Role.GRIP_LINE, Role.OBJECT_AXIS_X, Role.OBJECT_AXIS_Z)) {
            assertSameLines(role, desktop.shapes(role), shown.shapes(role), turns, front);
        }
        for (Role role : Arrays.asList(Role.OBJECT_ELLIPSE, Role.GRIP_ELLIPSE)) {
            assertSameEllipses(desktop.shapes(role), shown.shapes(role), turns, front);
        }
        assertTrue("banner and legend are the screen's own", shown.shapes(Role.BANNER).isEmpty()
                && shown.shapes(Role.LEGEND).isEmpty());
    }

    private static void assertSameLines(Role role, List<Shape> desktop, List<Shape> shown, int turns,
            boolean mirrored) {
        assertFalse(role + " is drawn", desktop.isEmpty());
        assertEquals(role.toString(), pointsOf(desktop).size(), pointsOf(shown).size());
        List<double[]> found = pointsOf(shown);
        for (double[] p : pointsOf(desktop)) {
            double[] q = upright(p[0], p[1], turns, mirrored);
            assertTrue(role + " has a point at " + q[0] + ", " + q[1],
                    found.stream().anyMatch(f -> Math.hypot(f[0] - q[0], f[1] - q[1]) < 1e-6));
        }
    }

    private static List<double[]> pointsOf(List<Shape> shapes) {
        List<double[]> points = new ArrayList<>();
        for (Shape shape : shapes) {
            for (double[] stroke : shape.strokes()) {
                for (int i = 0; i < stroke.length; i += 2) {
                    points.add(new double[] {stroke[i], stroke[i + 1]});
                }
            }
        }
        return points;
    }

    /** Boundaries are sampled at other angles, so their boxes are compared: turned, mirrored boxes are boxes. */
    private static void assertSameEllipses(List<Shape> desktop, List<Shape> shown, int turns, boolean mirrored) {
        assertFalse(desktop.isEmpty());
        int samples = shown.size();
        for (int i = 0; i < samples; i++) {
            Box box = desktop.get(i).bounds();
            double[] p = upright(box.left(), box.top(), turns, mirrored);
            double[] q = upright(box.right(), box.bottom(), turns, mirrored);
            Box found = shown.get(i).bounds();
            // a polygon of 96 corners misses its ellipse's extreme by up to 1 - cos(pi / 96) of the axis
            double tolerance = 1e-3 * Math.max(box.width(), box.height());
            assertEquals(Math.min(p[0], q[0]), found.left(), tolerance);
            assertEquals(Math.max(p[0], q[0]), found.right(), tolerance);
            assertEquals(Math.min(p[1], q[1]), found.top(), tolerance);
            assertEquals(Math.max(p[1], q[1]), found.bottom(), tolerance);
        }
    }

    /**
     * The preview's pixels lie under the overlay: a texture stands upright in the device's natural orientation,
     * stretched over the view (a front camera's mirrored), and from there the view's matrix takes it.
     */
    @Test
    public void previewLiesUnderTheOverlay() {
        assertPreviewUnderTheOverlay(SENSOR_DEG);
    }

    /** On the newest Android only: which way is up is the app's own reckoning, and the test above runs on both. */
    @Test
    @Config(minSdk = 27)
    public void previewLiesUnderTheOverlayHoweverTheSensorLies() {
        assertPreviewUnderTheOverlay(0);
        assertPreviewUnderTheOverlay(180);
        assertPreviewUnderTheOverlay(270);
    }

    private static void assertPreviewUnderTheOverlay(int sensorDeg) {
        MarkerObservation marker = BoofMarkerDetector.forCell(Fixture.LIFTED.cell()).detect(Fixture.LIFTED.image(), "f")
                .find(944);
        for (int rotation = 0; rotation < 4; rotation++) {
            for (boolean front : new boolean[] {false, true}) {
                assertPreviewUnderTheOverlay(marker.cornersPx(), sensorDeg, rotation, front);
            }
        }
    }

    private static void assertPreviewUnderTheOverlay(double[] corners, int sensorDeg, int rotation, boolean front) {
        turn(sensorDeg, rotation);
        try (Screen screen = Screen.live(Fixture.LIFTED.document(), sensorDeg, front)) {
            PreviewView preview = screen.find(R.id.preview);
            CameraSetup setup = screen.state().setup();
            assertEquals(front, setup.frontFacing());
            Matrix matrix = preview.getTransform(null);
            int natural = sensorDeg / 90;
            double naturalWidth = natural % 2 == 0 ? WIDTH : HEIGHT;
            double naturalHeight = natural % 2 == 0 ? HEIGHT : WIDTH;
            int turns = quarterTurns(sensorDeg, 90 * rotation, front);
            String held = "sensor at " + sensorDeg + ", display at " + rotation * 90 + ", front " + front;
            for (int k = 0; k < 8; k += 2) {
                double[] up = upright(corners[k], corners[k + 1], natural, front);
                float[] p = {(float) (up[0] / naturalWidth * preview.getWidth()),
                    (float) (up[1] / naturalHeight * preview.getHeight())};
                matrix.mapPoints(p);
                double[] expected = inView(upright(corners[k], corners[k + 1], turns, front), turns,
                        preview.getWidth(), preview.getHeight());
                assertEquals(held, expected[0], p[0], 0.01);
                assertEquals(held, expected[1], p[1], 0.01);
            }
        }
    }

    /** Markers of the held frame are dark where the outlines are. */
    private static void assertHeldFrameBelow(Screen screen, int turns, boolean front) {
        StillView still = screen.find(R.id.still);
        Bitmap drawn = Screen.picture(still);
        for (MarkerObservation m : screen.state().live().keyFrame().markers()) {
            double[] c = m.cornersPx();
            for (int k = 0; k < 4; k++) {
                // a tenth of the way from a corner to the opposite one is in the marker's black border
                int o = (2 * k + 4) % 8;
                double u = c[2 * k] + 0.1 * (c[o] - c[2 * k]);
                double v = c[2 * k + 1] + 0.1 * (c[o + 1] - c[2 * k + 1]);
                double[] p = inView(upright(u, v, turns, front), turns, drawn.getWidth(), drawn.getHeight());
                int grey = drawn.getPixel((int) p[0], (int) p[1]) & 0xFF;
                assertTrue("marker " + m.id() + " corner " + k + ": " + grey, grey < 90);
            }
        }
    }
}
