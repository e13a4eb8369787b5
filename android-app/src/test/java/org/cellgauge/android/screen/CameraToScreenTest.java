package org.cellgauge.android.screen;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import android.content.Context;
import android.hardware.camera2.CameraMetadata;
import android.view.Surface;
import android.view.View;
import org.cellgauge.android.R;
import org.cellgauge.android.camera.Camera2Feed;
import org.cellgauge.android.camera.CameraFeed;
import org.cellgauge.android.camera.CameraModelSource;
import org.cellgauge.android.camera.FakeCameras;
import org.cellgauge.check.CheckResult;
import org.cellgauge.vision.GreyImage;
import org.junit.Before;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.annotation.Config;

/**
 * The way of a frame through the whole app: from the camera's memory, by the app's own use of Camera2, to the ellipses
 * on the screen. Only the camera itself is a test's, and the files.
 */
@RunWith(RobolectricTestRunner.class)
@Config(application = CameraToScreenTest.AppWithCamera.class, shadows = {FakeCameras.Manager.class,
    FakeCameras.Reader.class, FakeCameras.RequestBuilder.class})
public class CameraToScreenTest {
    private static final int WIDTH = 1280;
    private static final int HEIGHT = 720;
    private static final long FRAME_NS = 100_000_000;

    private FakeCameras cameras;
    private long timeNs;

    /** Its camera is the device's, as in the app that is packed. */
    public static class AppWithCamera extends TestApp {
        @Override
        public CameraFeed cameraFeed(Context context) {
            return new Camera2Feed(context);
        }
    }

    @Before
    public void newCameras() {
        cameras = FakeCameras.begin();
    }

    private void deliver(GreyImage seen) {
        timeNs += FRAME_NS;
        cameras.deliver(seen, timeNs);
    }

    /** Of frames that come faster than they are looked at only the newest is: the next waits for the first look. */
    private void holdStillUntilResult(Screen screen) {
        screen.until("camera", () -> cameras.streams() && screen.state().setup() != null);
        deliver(Fixture.LIFTED.image());
        screen.until("quick look", () -> screen.state().live() != null);
        deliver(Fixture.LIFTED.image());
        screen.until("result", () -> screen.state().verdict() != null);
    }

    private void assertFramesBecomeEllipses(int facing, int sensorDeg, String qualifiers, int rotation, int turns) {
        boolean front = facing == CameraMetadata.LENS_FACING_FRONT;
        CheckResult expected = OverlayOnFrameTest.checkOfTheFrame();
        FakeCameras.plugIn(facing, sensorDeg, WIDTH, HEIGHT);
        Screen.allowCamera();
        RuntimeEnvironment.setQualifiers(qualifiers);
        Screen.turnDisplay(rotation);
        try (Screen screen = Screen.start()) {
            screen.chooseCell(Fixture.LIFTED.document());
            holdStillUntilResult(screen);
            assertEquals(CameraModelSource.CALIBRATION_FILE, screen.state().setup().source());
            assertEquals(front, screen.state().setup().frontFacing());
            assertEquals(expected.verdict(), screen.state().verdict());
            assertEquals(View.VISIBLE, screen.find(R.id.overlay).getVisibility());
            OverlayOnFrameTest.assertEllipsesOnPixels(screen, expected, "from the camera", turns, front);
            assertEquals(2, cameras.delivered());
            assertTrue("every image was closed", cameras.allFramesClosed());
            assertFalse("the camera goes on", cameras.allClosed());

            screen.pause();
            screen.until("closing", cameras::allClosed);
        }
        assertTrue(cameras.allClosed());
    }

    @Test
    public void framesOfABackCameraBecomeEllipsesOnTheScreenAndAPauseClosesIt() {
        // upright by a quarter turn clockwise: the sensor's 90 degrees
        assertFramesBecomeEllipses(CameraMetadata.LENS_FACING_BACK, 90, Screen.TABLET_PORTRAIT, Surface.ROTATION_0, 1);
    }

    @Test
    public void framesOfAFrontCameraBecomeEllipsesOfItsMirroredPicture() {
        // 270 degrees of the sensor and, the camera looking back at who turns it, 90 more of the display: none
        assertFramesBecomeEllipses(CameraMetadata.LENS_FACING_FRONT, 270, Screen.TABLET_LANDSCAPE,
                Surface.ROTATION_90, 0);
    }

    @Test
    public void afterAPauseTheCameraOpensAnewAndItsFramesAreChecked() {
        FakeCameras.plugIn(CameraMetadata.LENS_FACING_BACK, 90, WIDTH, HEIGHT);
        Screen.allowCamera();
        try (Screen screen = Screen.start()) {
            screen.chooseCell(Fixture.LIFTED.document());
            screen.until("camera", () -> cameras.streams() && screen.state().setup() != null);
            int before = cameras.openings();
            screen.pause();
            screen.until("closing", cameras::allClosed);
            assertNull(screen.state().verdict());
            screen.resume();
            screen.until("opening", () -> cameras.openings() == before + 1);
            holdStillUntilResult(screen);
            assertTrue("every image was closed", cameras.allFramesClosed());
        }
        assertTrue(cameras.delivered() > 0);
    }
}
