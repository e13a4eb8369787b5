package org.cellgauge.android.camera;

import static android.hardware.camera2.CameraMetadata.CONTROL_AF_STATE_ACTIVE_SCAN;
import static android.hardware.camera2.CameraMetadata.CONTROL_AF_STATE_FOCUSED_LOCKED;
import static android.hardware.camera2.CameraMetadata.CONTROL_AF_STATE_NOT_FOCUSED_LOCKED;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import android.Manifest;
import android.app.Application;
import android.graphics.ImageFormat;
import android.graphics.Rect;
import android.graphics.SurfaceTexture;
import android.hardware.camera2.CameraAccessException;
import android.hardware.camera2.CameraCharacteristics;
import android.hardware.camera2.CameraDevice;
import android.hardware.camera2.CameraManager;
import android.hardware.camera2.CameraMetadata;
import android.hardware.camera2.CaptureRequest;
import android.hardware.camera2.CaptureResult;
import android.hardware.camera2.params.MeteringRectangle;
import android.util.Range;
import android.util.Size;
import android.util.SizeF;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.GreyImage;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.Shadows;
import org.robolectric.annotation.Config;
import org.robolectric.shadow.api.Shadow;
import org.robolectric.shadows.ShadowCameraCharacteristics;
import org.robolectric.shadows.ShadowSystemClock;
import org.robolectric.shadows.StreamConfigurationMapBuilder;

/** The feed over cameras that do what the test tells them. */
@RunWith(RobolectricTestRunner.class)
@Config(shadows = {FakeCameras.Manager.class, FakeCameras.Reader.class,
    FakeCameras.RequestBuilder.class})
public class Camera2FeedTest {
    private static final long WAIT_S = 20;

    private final Application app = RuntimeEnvironment.getApplication();
    private final Heard heard = new Heard();
    private Camera2Feed feed;
    private FakeCameras cameras;

    /** Everything that a listener heard, in words. */
    private static final class Heard implements CameraFeed.Listener {
        final BlockingQueue<String> events = new LinkedBlockingQueue<>();
        volatile CameraSetup setup;
        volatile CountDownLatch hold;
        volatile boolean overlapped;
        private volatile boolean busy;
        /** What is said to be seen in every frame. */
        volatile Detections seen;

        @Override
        public void onOpened(CameraSetup value) {
            setup = value;
            events.add("opened");
        }

        @Override
        public void onFocusing() {
            events.add("focusing");
        }

        @Override
        public Detections onFrame(GreyImage luminance, long timestampNs) {
            overlapped |= busy;
            busy = true;
            boolean even = true;
            for (int y = 0; y < luminance.heightPx(); y++) {
                for (int x = 0; x < luminance.widthPx(); x++) {
                    even &= luminance.get(x, y) == luminance.get(0, 0);
                }
            }
            events.add("frame " + luminance.get(0, 0) + " at " + timestampNs + (even ? "" : ", with padding in it"));
            CountDownLatch latch = hold;
            if (latch != null) {
                try {
                    latch.await(WAIT_S, TimeUnit.SECONDS);
                } catch (InterruptedException e) {
                    Thread.currentThread().interrupt();
                }
            }
            busy = false;
            return seen;
        }

        @Override
        public void onFault(CameraFault fault) {
            events.add("fault " + fault);
        }

        String next() throws InterruptedException {
            return events.poll(WAIT_S, TimeUnit.SECONDS);
        }
    }

    @Before
    public void newCameras() {
        cameras = new FakeCameras();
        FakeCameras.current = cameras;
        feed = new Camera2Feed(app);
    }

    @After
    public void nothingStaysOpen() throws InterruptedException {
        if (heard.hold != null) {
            heard.hold.countDown();
        }
        feed.close();
        eventually(cameras::allClosed);
        assertFalse("calls of the listener overlap", heard.overlapped);
    }

    private static void eventually(BooleanSupplier condition) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(WAIT_S);
        while (!condition.getAsBoolean()) {
            assertTrue("waited too long", System.nanoTime() < end);
            Thread.sleep(2);
        }
    }

    /** Time enough for what must not happen to happen. */
    private static void meanwhile() throws InterruptedException {
        Thread.sleep(60);
    }

    private void permit() {
        Shadows.shadowOf(app).grantPermissions(Manifest.permission.CAMERA);
    }

    private void addCamera(boolean withFocus) {
        CameraCharacteristics c = ShadowCameraCharacteristics.newCameraCharacteristics();
        ShadowCameraCharacteristics shadow = Shadow.extract(c);
        shadow.set(CameraCharacteristics.LENS_FACING, CameraMetadata.LENS_FACING_BACK);
        shadow.set(CameraCharacteristics.SENSOR_ORIENTATION, 90);
        shadow.set(CameraCharacteristics.SCALER_STREAM_CONFIGURATION_MAP, StreamConfigurationMapBuilder.newBuilder()
                .addOutputSize(ImageFormat.YUV_420_888, new Size(64, 48))
                .addOutputSize(ImageFormat.YUV_420_888, new Size(32, 24))
                .addOutputSize(new Size(64, 48)).build());
        shadow.set(CameraCharacteristics.SENSOR_INFO_ACTIVE_ARRAY_SIZE, new Rect(0, 0, 4000, 3000));
        shadow.set(CameraCharacteristics.SENSOR_INFO_PIXEL_ARRAY_SIZE, new Size(4000, 3000));
        shadow.set(CameraCharacteristics.SENSOR_INFO_PHYSICAL_SIZE, new SizeF(5.6f, 4.2f));
        shadow.set(CameraCharacteristics.LENS_INFO_AVAILABLE_FOCAL_LENGTHS, new float[] {4.2f});
        shadow.set(CameraCharacteristics.LENS_INFO_MINIMUM_FOCUS_DISTANCE, withFocus ? 10f : 0f);
        shadow.set(CameraCharacteristics.CONTROL_AF_AVAILABLE_MODES, withFocus ? new int[] {0, 1} : new int[] {0});
        shadow.set(CameraCharacteristics.CONTROL_AE_AVAILABLE_TARGET_FPS_RANGES,
                RequestSettingsTest.ranges(7, 15, 15, 30, 30, 30, 60, 60));
        shadow.set(CameraCharacteristics.CONTROL_MAX_REGIONS_AE, 4);
        shadow.set(CameraCharacteristics.CONTROL_MAX_REGIONS_AF, withFocus ? 1 : 0);
        shadow.set(CameraCharacteristics.FLASH_INFO_AVAILABLE, true);
        shadow.set(CameraCharacteristics.LENS_INFO_FOCUS_DISTANCE_CALIBRATION,
                CameraMetadata.LENS_INFO_FOCUS_DISTANCE_CALIBRATION_CALIBRATED);
        shadow.set(CameraCharacteristics.REQUEST_AVAILABLE_CAPABILITIES, new int[] {0, 1});
        shadow.set(CameraCharacteristics.CONTROL_AE_AVAILABLE_MODES, new int[] {0, 1});
        shadow.set(CameraCharacteristics.SENSOR_INFO_EXPOSURE_TIME_RANGE, new Range<>(100_000L, 500_000_000L));
        shadow.set(CameraCharacteristics.SENSOR_INFO_SENSITIVITY_RANGE, new Range<>(50, 3200));
        ((FakeCameras.Manager) Shadow.extract(app.getSystemService(CameraManager.class))).addCamera("0", c);
    }

    private void ready(boolean withFocus) {
        permit();
        addCamera(withFocus);
    }

    private FakeCameras.Device openAndStream(boolean withFocus) throws InterruptedException {
        ready(withFocus);
        feed.open(null, OptionalDouble.empty(), null, heard);
        assertEquals("opened", heard.next());
        FakeCameras.Device device = cameras.lastDevice();
        eventually(() -> device.session != null && device.session.streams());
        return device;
    }

    // ---- what is as it should be

    @Test
    public void framesComeWithTheirCameraAndTheirTime() throws InterruptedException {
        openAndStream(false);
        assertEquals(64, heard.setup.camera().widthPx());
        assertEquals(48, heard.setup.camera().heightPx());
        assertEquals(48, heard.setup.camera().get(PinholeCamera.FX), 1e-4);
        assertEquals(CameraModelSource.FIELD_OF_VIEW, heard.setup.source());
        assertEquals(90, heard.setup.sensorOrientationDeg());
        assertFalse(heard.setup.frontFacing());
        FakeCameras.Frame first = cameras.lastReader().deliver(17, 1000, false);
        assertEquals("frame 17 at 1000", heard.next());
        FakeCameras.Frame second = cameras.lastReader().deliver(200, 2000, false);
        assertEquals("frame 200 at 2000", heard.next());
        assertTrue(first.closed && second.closed);
    }

    @Test
    public void aCalibrationDecidesTheSizeOfTheFrames() throws InterruptedException {
        ready(false);
        feed.open(PinholeCamera.ideal(32, 24, 30, 30, 16, 12), OptionalDouble.empty(), null, heard);
        assertEquals("opened", heard.next());
        assertEquals(32, cameras.lastReader().width);
        assertEquals(CameraModelSource.CALIBRATION_FILE, heard.setup.source());
    }

    @Test
    public void thePreviewIsAnOutputOfItsOwn() throws InterruptedException {
        ready(false);
        SurfaceTexture preview = new SurfaceTexture(0);
        feed.open(null, OptionalDouble.empty(), preview, heard);
        assertEquals("opened", heard.next());
        assertEquals(2, cameras.lastDevice().session.outputs);
    }

    @Test
    public void aPreviewThatIsGoneIsAFault() throws InterruptedException {
        ready(false);
        SurfaceTexture preview = new SurfaceTexture(0);
        cameras.sessionFault = new IllegalArgumentException("Surface was abandoned");
        feed.open(null, OptionalDouble.empty(), preview, heard);
        assertEquals("fault FAILED", heard.next());
    }

    @Test
    public void whileAFrameIsLookedAtOnlyTheNewestOfTheOthersWaits() throws InterruptedException {
        openAndStream(false);
        heard.hold = new CountDownLatch(1);
        FakeCameras.Frame looked = cameras.lastReader().deliver(1, 1, false);
        assertEquals("frame 1 at 1", heard.next());
        assertTrue("the camera has its memory back while the listener works", looked.closed);
        for (int i = 2; i <= 9; i++) {
            cameras.lastReader().deliver(i, i, false);
        }
        heard.hold.countDown();
        assertEquals("frame 9 at 9", heard.next());
        eventually(() -> cameras.lastReader().frames.stream().allMatch(f -> f.closed));
        meanwhile();
        assertNull(heard.events.poll());
    }

    @Test
    public void timeNeverRunsBackwards() throws InterruptedException {
        openAndStream(false);
        cameras.lastReader().deliver(1, 500, false);
        assertEquals("frame 1 at 500", heard.next());
        cameras.lastReader().deliver(2, 400, false);
        assertEquals("frame 2 at 500", heard.next());
    }

    @Test
    public void everyFrameIsAskedForWithWhatMeasuringNeeds() throws InterruptedException {
        FakeCameras.Device device = openAndStream(true);
        assertEquals(CameraMetadata.CONTROL_AF_MODE_AUTO,
                device.session.settings.get(CaptureRequest.CONTROL_AF_MODE));
        assertEquals(new Rect(0, 0, 4000, 3000), device.session.settings.get(CaptureRequest.SCALER_CROP_REGION));
    }

    // ---- focus

    @Test
    public void framesWaitUntilTheLensStandsStill() throws InterruptedException {
        FakeCameras.Device device = openAndStream(true);
        eventually(() -> device.session.triggers.size() == 2);
        assertEquals(Arrays.asList(CameraMetadata.CONTROL_AF_TRIGGER_CANCEL, CameraMetadata.CONTROL_AF_TRIGGER_START),
                device.session.triggers);
        device.session.reportFocus(CONTROL_AF_STATE_ACTIVE_SCAN, null);
        FakeCameras.Frame blurred = cameras.lastReader().deliver(1, 1, false);
        eventually(() -> blurred.closed);
        device.session.reportFocus(CONTROL_AF_STATE_FOCUSED_LOCKED, null);
        meanwhile();
        cameras.lastReader().deliver(2, 2, false);
        assertEquals("frame 2 at 2", heard.next());
        assertFalse(heard.setup.notes().contains(CameraNote.FOCUS_NOT_LOCKED));
    }

    @Test
    public void framesFromBeforeTheLensStoodStillAreLeftOut() throws InterruptedException {
        FakeCameras.Device device = openAndStream(true);
        eventually(() -> device.session.triggers.size() == 2);
        device.session.reportFocus(CONTROL_AF_STATE_FOCUSED_LOCKED, 1000L);
        meanwhile();
        FakeCameras.Frame before = cameras.lastReader().deliver(1, 999, false);
        eventually(() -> before.closed);
        cameras.lastReader().deliver(2, 1000, false);
        assertEquals("frame 2 at 1000", heard.next());
    }

    @Test
    public void focusingAgainHoldsFramesBackOnceMore() throws InterruptedException {
        FakeCameras.Device device = openAndStream(true);
        eventually(() -> device.session.triggers.size() == 2);
        device.session.reportFocus(CONTROL_AF_STATE_FOCUSED_LOCKED, null);
        meanwhile();
        cameras.lastReader().deliver(1, 1, false);
        assertEquals("frame 1 at 1", heard.next());
        feed.refocus();
        eventually(() -> device.session.triggers.size() == 4);
        meanwhile();
        FakeCameras.Frame blurred = cameras.lastReader().deliver(2, 2, false);
        eventually(() -> blurred.closed);
        device.session.reportFocus(CONTROL_AF_STATE_FOCUSED_LOCKED, null);
        meanwhile();
        cameras.lastReader().deliver(3, 3, false);
        assertEquals("frame 3 at 3", heard.next());
    }

    @Test
    public void aLensThatNeverReportsIsMeasuredWithAndSaidNotToBeHeld() throws InterruptedException {
        cameras.muteFocus = true;
        FakeCameras.Device device = openAndStream(true);
        eventually(() -> device.session.triggers.size() == 2);
        FakeCameras.Frame early = cameras.lastReader().deliver(1, 1, false);
        eventually(() -> early.closed);
        ShadowSystemClock.advanceBy(Duration.ofSeconds(6));
        assertEquals("opened", heard.next());
        assertTrue(heard.setup.notes().contains(CameraNote.FOCUS_NOT_LOCKED));
        cameras.lastReader().deliver(2, 2, false);
        assertEquals("frame 2 at 2", heard.next());
    }

    @Test
    public void aScanThatTheCameraDropsIsNotWaitedFor() throws InterruptedException {
        FakeCameras.Device device = openAndStream(true);
        eventually(() -> device.session.triggers.size() == 2);
        device.session.failScan();
        assertEquals("opened", heard.next());
        assertTrue(heard.setup.notes().contains(CameraNote.FOCUS_NOT_LOCKED));
    }

    @Test
    public void aScanThatFindsNothingIsSaidUntilOneFinds() throws InterruptedException {
        FakeCameras.Device device = openAndStream(true);
        eventually(() -> device.session.triggers.size() == 2);
        device.session.reportFocus(CONTROL_AF_STATE_NOT_FOCUSED_LOCKED, null);
        assertEquals("opened", heard.next());
        assertTrue(heard.setup.notes().contains(CameraNote.FOCUS_NOT_FOUND));
        cameras.lastReader().deliver(1, 1, false);
        assertEquals("frame 1 at 1", heard.next());
        feed.refocus();
        eventually(() -> device.session.triggers.size() == 4);
        meanwhile();
        device.session.reportFocus(CONTROL_AF_STATE_FOCUSED_LOCKED, null);
        assertEquals("opened", heard.next());
        assertFalse(heard.setup.notes().contains(CameraNote.FOCUS_NOT_FOUND));
    }

    @Test
    public void markersThatComeNearerAreFocusedAnew() throws InterruptedException {
        FakeCameras.Device device = openAndStream(true);
        eventually(() -> device.session.triggers.size() == 2);
        device.session.reportFocus(CONTROL_AF_STATE_FOCUSED_LOCKED, 1_000L);
        meanwhile();
        heard.seen = FocusWatchTest.seen(64, 48, 10, 10, 10, 0.7);
        String said = "";
        int second = 0;
        while (!said.equals("focusing")) {
            second++;
            cameras.lastReader().deliver(second, second * 1_000_000_000L, false);
            said = heard.next();
            assertTrue(said + " after " + second, second < 20 && said.matches("focusing|frame .*"));
            heard.seen = second > 2 ? FocusWatchTest.seen(64, 48, 8.5, 8.5, 13, 0.7) : heard.seen;
        }
        assertTrue("after " + second, second > 2 + FocusWatch.FRAMES);
        heard.events.clear();
        eventually(() -> device.session.triggers.size() == 4);
        FakeCameras.Frame blurred = cameras.lastReader().deliver(21, 21_000_000_000L, false);
        eventually(() -> blurred.closed);
        meanwhile();
        device.session.reportFocus(CONTROL_AF_STATE_FOCUSED_LOCKED, 21_500_000_000L);
        meanwhile();
        cameras.lastReader().deliver(22, 22_000_000_000L, false);
        assertEquals("frame 22 at 22000000000", heard.next());
    }

    @Test
    public void aLensIsSetToTheDistanceOfTheCalibrationAndWaitedFor() throws InterruptedException {
        ready(true);
        feed.open(PinholeCamera.ideal(64, 48, 60, 60, 32, 24), OptionalDouble.of(0.5), null, heard);
        assertEquals("opened", heard.next());
        assertTrue(heard.setup.notes().contains(CameraNote.FOCUS_AS_CALIBRATED));
        FakeCameras.Device device = cameras.lastDevice();
        eventually(() -> device.session != null && device.session.streams());
        assertEquals(2f, device.session.settings.get(CaptureRequest.LENS_FOCUS_DISTANCE));
        device.session.report(Map.of(CaptureResult.LENS_STATE, CameraMetadata.LENS_STATE_MOVING,
                CaptureResult.LENS_FOCUS_DISTANCE, 1.2f));
        FakeCameras.Frame early = cameras.lastReader().deliver(1, 1, false);
        eventually(() -> early.closed);
        device.session.report(Map.of(CaptureResult.LENS_STATE, CameraMetadata.LENS_STATE_STATIONARY,
                CaptureResult.LENS_FOCUS_DISTANCE, 1.98f, CaptureResult.SENSOR_TIMESTAMP, 1000L));
        meanwhile();
        FakeCameras.Frame before = cameras.lastReader().deliver(2, 999, false);
        eventually(() -> before.closed);
        cameras.lastReader().deliver(3, 1000, false);
        assertEquals("frame 3 at 1000", heard.next());
        feed.refocus();
        meanwhile();
        assertTrue("nothing is searched", device.session.triggers.isEmpty());
    }

    @Test
    public void aLensThatDoesNotSayThatItIsThereIsNotSaidToBe() throws InterruptedException {
        ready(true);
        feed.open(null, OptionalDouble.of(0.5), null, heard);
        assertEquals("opened", heard.next());
        eventually(() -> cameras.lastDevice().session != null && cameras.lastDevice().session.streams());
        ShadowSystemClock.advanceBy(Duration.ofSeconds(6));
        assertEquals("opened", heard.next());
        assertTrue(heard.setup.notes().contains(CameraNote.FOCUS_NOT_AS_CALIBRATED));
        assertFalse(heard.setup.notes().contains(CameraNote.FOCUS_AS_CALIBRATED));
        cameras.lastReader().deliver(2, 2, false);
        assertEquals("frame 2 at 2", heard.next());
    }

    // ---- light

    private static void measured(FakeCameras.Device device, long exposureNs, int sensitivity) {
        for (int i = 0; i < ExposureCap.SETTLED_FRAMES; i++) {
            device.session.report(Map.of(CaptureResult.CONTROL_AE_STATE, CameraMetadata.CONTROL_AE_STATE_CONVERGED,
                    CaptureResult.SENSOR_EXPOSURE_TIME, exposureNs, CaptureResult.SENSOR_SENSITIVITY, sensitivity));
        }
    }

    @Test
    public void aLongExposureIsCutUntilTheLightChanges() throws InterruptedException {
        FakeCameras.Device device = openAndStream(false);
        assertNull(device.session.settings.get(CaptureRequest.SENSOR_EXPOSURE_TIME));
        measured(device, 33_000_000, 400);
        eventually(() -> device.session.settings.containsKey(CaptureRequest.SENSOR_EXPOSURE_TIME));
        assertEquals(CameraMetadata.CONTROL_AE_MODE_OFF,
                device.session.settings.get(CaptureRequest.CONTROL_AE_MODE));
        assertEquals(10_000_000L, device.session.settings.get(CaptureRequest.SENSOR_EXPOSURE_TIME));
        assertEquals(1320, device.session.settings.get(CaptureRequest.SENSOR_SENSITIVITY));
        heard.seen = FocusWatchTest.seen(64, 48, 16, 12, 8, 0.7);
        for (int i = 1; i <= 20; i++) {
            // as bright for two seconds, then half as bright
            cameras.lastReader().deliver(i < 10 ? 150 : 75, i * 300_000_000L, false);
            assertTrue(heard.next().startsWith("frame"));
        }
        eventually(() -> device.session.settings.get(CaptureRequest.CONTROL_AE_MODE)
                .equals(CameraMetadata.CONTROL_AE_MODE_ON));
        measured(device, 33_000_000, 3200);
        assertEquals("opened", heard.next());
        assertTrue(heard.setup.notes().contains(CameraNote.LIGHT_SHORT));
        // the request that follows what is said comes from the camera's thread
        eventually(() -> Long.valueOf(16_500_000L).equals(
                device.session.settings.get(CaptureRequest.SENSOR_EXPOSURE_TIME)));
        feed.torch(true);
        eventually(() -> device.session.settings.get(CaptureRequest.CONTROL_AE_MODE)
                .equals(CameraMetadata.CONTROL_AE_MODE_ON));
        measured(device, 8_000_000, 200);
        assertEquals("opened", heard.next());
        assertFalse(heard.setup.notes().contains(CameraNote.LIGHT_SHORT));
        assertEquals(CameraMetadata.CONTROL_AE_MODE_ON, device.session.settings.get(CaptureRequest.CONTROL_AE_MODE));
    }

    @Test
    public void lightIsMeteredAtTheMarkersThatWereSeen() throws InterruptedException {
        FakeCameras.Device device = openAndStream(false);
        assertNull(device.session.settings.get(CaptureRequest.CONTROL_AE_REGIONS));
        heard.seen = FocusWatchTest.seen(64, 48, 16, 12, 8, 0.7);
        cameras.lastReader().deliver(1, 1, false);
        assertEquals("frame 1 at 1", heard.next());
        eventually(() -> device.session.settings.get(CaptureRequest.CONTROL_AE_REGIONS) != null);
        MeteringRectangle[] areas =
                (MeteringRectangle[]) device.session.settings.get(CaptureRequest.CONTROL_AE_REGIONS);
        // 62.5 px of the sensor for each of a frame, and a fifth of the marker around it
        assertEquals(new Rect(900, 650, 1600, 1350), areas[0].getRect());
        assertFalse("a lens that does not move",
                device.session.settings.containsKey(CaptureRequest.CONTROL_AF_REGIONS));
        int asked = device.session.requests.get();
        cameras.lastReader().deliver(2, 2, false);
        assertEquals("frame 2 at 2", heard.next());
        meanwhile();
        assertEquals("the same areas are not asked for again", asked, device.session.requests.get());
        heard.seen = FocusWatchTest.seen(64, 48, 40, 12, 8, 0.7);
        cameras.lastReader().deliver(3, 400_000_000, false);
        assertEquals("frame 3 at 400000000", heard.next());
        meanwhile();
        assertEquals("nor others so soon", asked, device.session.requests.get());
        cameras.lastReader().deliver(4, 600_000_000, false);
        assertEquals("frame 4 at 600000000", heard.next());
        eventually(() -> device.session.requests.get() == asked + 1);
    }

    @Test
    public void framesAreExposedNoLongerThanAThirtiethOfASecond() throws InterruptedException {
        assertEquals(new Range<>(30, 30),
                openAndStream(false).session.settings.get(CaptureRequest.CONTROL_AE_TARGET_FPS_RANGE));
    }

    @Test
    public void theLampShinesWhileItIsWanted() throws InterruptedException {
        FakeCameras.Device device = openAndStream(false);
        assertTrue(heard.setup.hasTorch());
        assertEquals(CameraMetadata.FLASH_MODE_OFF, device.session.settings.get(CaptureRequest.FLASH_MODE));
        feed.torch(true);
        eventually(() -> device.session.settings.get(CaptureRequest.FLASH_MODE)
                .equals(CameraMetadata.FLASH_MODE_TORCH));
        feed.torch(false);
        eventually(() -> device.session.settings.get(CaptureRequest.FLASH_MODE).equals(CameraMetadata.FLASH_MODE_OFF));
        feed.close();
        feed.torch(true);
    }

    @Test
    public void aLampThatIsWantedBeforeTheCameraIsOpenShinesFromItsFirstFrame() throws InterruptedException {
        ready(false);
        cameras.openLate = true;
        feed.open(null, OptionalDouble.empty(), null, heard);
        feed.torch(true);
        eventually(() -> cameras.devices.size() == 1);
        meanwhile();
        cameras.lastDevice().open();
        assertEquals("opened", heard.next());
        eventually(() -> cameras.lastDevice().session.streams());
        assertEquals(CameraMetadata.FLASH_MODE_TORCH,
                cameras.lastDevice().session.settings.get(CaptureRequest.FLASH_MODE));
    }

    // ---- faults

    @Test
    public void withoutThePermissionNothingIsOpened() throws InterruptedException {
        addCamera(false);
        feed.open(null, OptionalDouble.empty(), null, heard);
        assertEquals("fault NOT_PERMITTED", heard.next());
        assertTrue(cameras.devices.isEmpty());
    }

    @Test
    public void aDeviceWithoutACameraSaysSo() throws InterruptedException {
        permit();
        feed.open(null, OptionalDouble.empty(), null, heard);
        assertEquals("fault NO_CAMERA", heard.next());
    }

    @Test
    public void aCalibrationOfAnotherShapeIsRefused() throws InterruptedException {
        ready(false);
        feed.open(PinholeCamera.ideal(1920, 1080, 1500, 1500, 960, 540), OptionalDouble.empty(), null, heard);
        assertEquals("fault NO_SUITABLE_SIZE", heard.next());
        assertTrue(cameras.devices.isEmpty());
    }

    @Test
    public void aCameraThatStatesNothingNeedsACalibration() throws InterruptedException {
        permit();
        CameraCharacteristics c = ShadowCameraCharacteristics.newCameraCharacteristics();
        ((ShadowCameraCharacteristics) Shadow.extract(c)).set(CameraCharacteristics.SCALER_STREAM_CONFIGURATION_MAP,
                StreamConfigurationMapBuilder.newBuilder()
                        .addOutputSize(ImageFormat.YUV_420_888, new Size(64, 48)).build());
        ((FakeCameras.Manager) Shadow.extract(app.getSystemService(CameraManager.class))).addCamera("0", c);
        feed.open(null, OptionalDouble.empty(), null, heard);
        assertEquals("fault NO_CAMERA_MODEL", heard.next());
        feed.open(PinholeCamera.ideal(64, 48, 60, 60, 32, 24), OptionalDouble.empty(), null, heard);
        assertEquals("opened", heard.next());
    }

    @Test
    public void whatTheServiceThrowsBecomesAFault() throws InterruptedException {
        ready(false);
        assertFaultOnOpening(new CameraAccessException(CameraAccessException.CAMERA_IN_USE), "IN_USE");
        assertFaultOnOpening(new CameraAccessException(CameraAccessException.MAX_CAMERAS_IN_USE), "IN_USE");
        assertFaultOnOpening(new CameraAccessException(CameraAccessException.CAMERA_DISABLED), "DISABLED");
        assertFaultOnOpening(new CameraAccessException(CameraAccessException.CAMERA_DISCONNECTED), "DISCONNECTED");
        assertFaultOnOpening(new CameraAccessException(CameraAccessException.CAMERA_ERROR), "FAILED");
        assertFaultOnOpening(new SecurityException("taken back"), "NOT_PERMITTED");
        assertFaultOnOpening(new IllegalArgumentException("unknown id"), "FAILED");
        assertFaultOnOpening(new IllegalStateException("dying"), "FAILED");
        cameras.openFault = null;
        cameras.listFault = new CameraAccessException(CameraAccessException.CAMERA_DISABLED);
        feed.open(null, OptionalDouble.empty(), null, heard);
        assertEquals("fault DISABLED", heard.next());
    }

    private void assertFaultOnOpening(Exception e, String fault) throws InterruptedException {
        cameras.openFault = e;
        feed.open(null, OptionalDouble.empty(), null, heard);
        assertEquals("fault " + fault, heard.next());
    }

    @Test
    public void errorCodesBecomeFaultsAndTheCameraIsClosed() throws InterruptedException {
        ready(false);
        int[] codes = {CameraDevice.StateCallback.ERROR_CAMERA_IN_USE,
            CameraDevice.StateCallback.ERROR_MAX_CAMERAS_IN_USE, CameraDevice.StateCallback.ERROR_CAMERA_DISABLED,
            CameraDevice.StateCallback.ERROR_CAMERA_DEVICE, CameraDevice.StateCallback.ERROR_CAMERA_SERVICE, 99};
        String[] faults = {"IN_USE", "IN_USE", "DISABLED", "FAILED", "FAILED", "FAILED"};
        for (int i = 0; i < codes.length; i++) {
            cameras.openError = codes[i];
            feed.open(null, OptionalDouble.empty(), null, heard);
            assertEquals("fault " + faults[i], heard.next());
            assertTrue(cameras.lastDevice().closed);
        }
    }

    @Test
    public void aCameraThatIsTakenAwayIsClosedAndCanBeOpenedAgain() throws InterruptedException {
        FakeCameras.Device device = openAndStream(false);
        device.disconnect();
        assertEquals("fault DISCONNECTED", heard.next());
        assertTrue(device.closed);
        assertTrue(cameras.lastReader().closed);
        feed.open(null, OptionalDouble.empty(), null, heard);
        assertEquals("opened", heard.next());
    }

    @Test
    public void aCameraThatFailsWhileItRunsIsHeardOfOnce() throws InterruptedException {
        FakeCameras.Device device = openAndStream(false);
        device.fail(CameraDevice.StateCallback.ERROR_CAMERA_DEVICE);
        device.disconnect();
        assertEquals("fault FAILED", heard.next());
        meanwhile();
        assertNull(heard.events.poll());
    }

    @Test
    public void sizesThatTheCameraRefusesGiveWayToTheNext() throws InterruptedException {
        ready(false);
        cameras.refuse = 1;
        feed.open(null, OptionalDouble.empty(), null, heard);
        assertEquals("opened", heard.next());
        assertEquals(32, heard.setup.camera().widthPx());
        assertEquals(2, cameras.readers.size());
        assertTrue(cameras.readers.get(0).closed);
    }

    @Test
    public void aCameraThatRefusesEverySizeFails() throws InterruptedException {
        ready(false);
        cameras.refuse = 2;
        feed.open(null, OptionalDouble.empty(), null, heard);
        assertEquals("fault FAILED", heard.next());
        cameras.refuse = 2;
        feed.open(PinholeCamera.ideal(64, 48, 60, 60, 32, 24), OptionalDouble.empty(), null, heard);
        assertEquals("fault NO_SUITABLE_SIZE", heard.next());
    }

    @Test
    public void framesThatCannotBeAskedForAreAFault() throws InterruptedException {
        ready(false);
        cameras.streamFault = new IllegalStateException("session was closed");
        feed.open(null, OptionalDouble.empty(), null, heard);
        assertEquals("opened", heard.next());
        assertEquals("fault FAILED", heard.next());
    }

    @Test
    public void aCameraThatNeverAnswersIsGivenUpAndClosedWhenItDoes() throws InterruptedException {
        ready(false);
        cameras.openLate = true;
        feed.open(null, OptionalDouble.empty(), null, heard);
        eventually(() -> cameras.devices.size() == 1);
        ShadowSystemClock.advanceBy(Duration.ofSeconds(9));
        assertEquals("fault FAILED", heard.next());
        cameras.lastDevice().open();
        eventually(() -> cameras.lastDevice().closed);
        meanwhile();
        assertNull(heard.events.poll());
    }

    @Test
    public void aCameraThatDeliversNothingIsGivenUp() throws InterruptedException {
        openAndStream(false);
        ShadowSystemClock.advanceBy(Duration.ofSeconds(9));
        assertEquals("fault FAILED", heard.next());
    }

    @Test
    public void aCameraThatPausesAfterItsFirstFrameIsNotGivenUp() throws InterruptedException {
        openAndStream(false);
        cameras.lastReader().deliver(1, 1, false);
        assertEquals("frame 1 at 1", heard.next());
        ShadowSystemClock.advanceBy(Duration.ofSeconds(60));
        meanwhile();
        assertNull(heard.events.poll());
    }

    @Test
    public void aBrokenFrameIsLeftOutAndManyAreAFault() throws InterruptedException {
        openAndStream(false);
        FakeCameras.Frame broken = cameras.lastReader().deliver(1, 1, true);
        eventually(() -> broken.closed);
        cameras.lastReader().deliver(2, 2, false);
        assertEquals("frame 2 at 2", heard.next());
        List<FakeCameras.Frame> all = new ArrayList<>();
        for (int i = 0; i < 31; i++) {
            FakeCameras.Frame next = cameras.lastReader().deliver(1, 1, true);
            all.add(next);
            eventually(() -> next.closed);
        }
        assertEquals("fault FAILED", heard.next());
    }

    // ---- races

    @Test
    public void closingWhileTheCameraOpensClosesItWhenItIsOpen() throws InterruptedException {
        ready(false);
        cameras.openLate = true;
        feed.open(null, OptionalDouble.empty(), null, heard);
        eventually(() -> cameras.devices.size() == 1);
        feed.close();
        meanwhile();
        assertFalse(cameras.lastDevice().closed);
        cameras.lastDevice().open();
        eventually(() -> cameras.lastDevice().closed);
        meanwhile();
        assertNull(heard.events.poll());
    }

    @Test
    public void openingWhileTheEarlierOneStillOpensWaitsForIt() throws InterruptedException {
        ready(false);
        cameras.openLate = true;
        feed.open(null, OptionalDouble.empty(), null, heard);
        eventually(() -> cameras.devices.size() == 1);
        Heard second = new Heard();
        feed.open(null, OptionalDouble.empty(), null, second);
        meanwhile();
        assertEquals(1, cameras.devices.size());
        cameras.openLate = false;
        cameras.devices.get(0).open();
        assertEquals("opened", second.next());
        assertEquals(2, cameras.devices.size());
        assertTrue(cameras.devices.get(0).closed);
        assertNull(heard.events.poll());
    }

    @Test
    public void openingAnOpenCameraClosesItFirst() throws InterruptedException {
        FakeCameras.Device first = openAndStream(false);
        Heard second = new Heard();
        feed.open(null, OptionalDouble.empty(), null, second);
        assertEquals("opened", second.next());
        assertTrue(first.closed);
        assertEquals(2, cameras.devices.size());
    }

    @Test
    public void aListenerThatIsStillBusyIsWaitedForBeforeTheNextOpening() throws InterruptedException {
        openAndStream(false);
        heard.hold = new CountDownLatch(1);
        cameras.lastReader().deliver(1, 1, false);
        assertEquals("frame 1 at 1", heard.next());
        feed.open(null, OptionalDouble.empty(), null, heard);
        meanwhile();
        assertEquals(1, cameras.devices.size());
        heard.hold.countDown();
        assertEquals("opened", heard.next());
    }

    @Test
    public void afterClosingNothingIsHeard() throws InterruptedException {
        FakeCameras.Device device = openAndStream(false);
        FakeCameras.Reader reader = cameras.lastReader();
        feed.close();
        feed.close();
        reader.deliver(1, 1, false);
        device.disconnect();
        eventually(() -> device.closed && reader.closed);
        meanwhile();
        assertNull(heard.events.poll());
        feed.refocus();
    }

    @Test
    public void openAndCloseInARowLeaveNothingOpen() throws InterruptedException {
        ready(true);
        for (int i = 0; i < 20; i++) {
            feed.open(null, OptionalDouble.empty(), null, heard);
            if (i % 3 == 0) {
                feed.refocus();
            }
            feed.close();
        }
        Heard last = new Heard();
        feed.open(null, OptionalDouble.empty(), null, last);
        assertEquals("opened", last.next());
        eventually(() -> cameras.devices.stream().filter(d -> !d.closed).count() == 1);
    }

    @Test
    public void closingWhatWasNeverOpenedDoesNothing() {
        feed.close();
        feed.refocus();
    }

    @Test
    public void aThrowingListenerStillLeavesTheFrameClosed() throws InterruptedException {
        ready(false);
        Thread.UncaughtExceptionHandler before = Thread.getDefaultUncaughtExceptionHandler();
        BlockingQueue<Throwable> thrown = new LinkedBlockingQueue<>();
        Thread.setDefaultUncaughtExceptionHandler((t, e) -> thrown.add(e));
        try {
            feed.open(null, OptionalDouble.empty(), null, new CameraFeed.Listener() {
                @Override
                public void onOpened(CameraSetup setup) {
                    heard.onOpened(setup);
                }

                @Override
                public void onFocusing() {
                    heard.onFocusing();
                }

                @Override
                public Detections onFrame(GreyImage luminance, long timestampNs) {
                    throw new IllegalArgumentException("a mistake in the listener");
                }

                @Override
                public void onFault(CameraFault fault) {
                    heard.onFault(fault);
                }
            });
            assertEquals("opened", heard.next());
            FakeCameras.Frame frame = cameras.lastReader().deliver(1, 1, false);
            eventually(() -> frame.closed);
            assertEquals("a mistake in the listener", thrown.poll(WAIT_S, TimeUnit.SECONDS).getMessage());
        } finally {
            Thread.setDefaultUncaughtExceptionHandler(before);
        }
        // such a mistake ends the app; what is left of it here is closed by hand
        feed = new Camera2Feed(app);
        cameras.devices.forEach(CameraDevice::close);
        cameras.readers.forEach(r -> r.closed = true);
    }
}
