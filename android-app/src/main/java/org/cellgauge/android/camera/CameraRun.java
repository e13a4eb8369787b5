package org.cellgauge.android.camera;

import android.Manifest;
import android.content.Context;
import android.content.pm.PackageManager;
import android.graphics.ImageFormat;
import android.graphics.SurfaceTexture;
import android.hardware.camera2.CameraAccessException;
import android.hardware.camera2.CameraCaptureSession;
import android.hardware.camera2.CameraDevice;
import android.hardware.camera2.CameraManager;
import android.hardware.camera2.CameraMetadata;
import android.hardware.camera2.CaptureFailure;
import android.hardware.camera2.CaptureRequest;
import android.hardware.camera2.CaptureResult;
import android.hardware.camera2.TotalCaptureResult;
import android.hardware.camera2.params.MeteringRectangle;
import android.media.Image;
import android.media.ImageReader;
import android.os.Handler;
import android.os.HandlerThread;
import android.util.Log;
import android.view.Surface;
import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumSet;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.GreyImage;

/**
 * One opening of a camera, from asking for it until it is closed.
 *
 * <p>Everything but {@link #start}, {@link #close}, {@link #refocus} and {@link #torch} happens on the run's own
 * thread. The thread ends when the camera is closed; where the device still owes an answer to the request to open it,
 * the thread waits for it, since a camera whose answer nobody hears stays open for good.
 */
final class CameraRun {
    private static final String TAG = "CameraRun";
    /** For a camera to open, to deliver its first frame, or to be let go by the run before, ms. */
    private static final long PATIENCE_MS = 8_000;
    /** For a scan of the focus, ms; devices give up after 2 to 4 s themselves. */
    private static final long SCAN_MS = 5_000;
    /** While the view moves, the camera is told no more often where to meter, ns. */
    private static final long METERING_PAUSE_NS = 500_000_000;
    // one that is filled, one that waits and one that is read
    private static final int FRAMES_IN_FLIGHT = 3;
    private static final int BROKEN_FRAMES_ALLOWED = 30;

    private final Context context;
    private final PinholeCamera calibration;
    private final OptionalDouble focusDistanceM;
    private final SurfaceTexture preview;
    private final CameraFeed.Listener listener;
    private final HandlerThread thread = new HandlerThread("camera");
    private final AtomicBoolean closed = new AtomicBoolean();
    private final CountDownLatch ended = new CountDownLatch(1);
    private final LuminancePlane luminance = new LuminancePlane();
    private final Runnable patience = () -> fault(CameraFault.FAILED, null);
    private final Runnable scanPatience = this::scanEndless;

    private final CountDownLatch previousEnd;

    private volatile Handler handler;
    // of this run's thread alone
    private boolean opening;
    private CameraTraits traits;
    private RequestSettings settings;
    private List<StreamChoice> streams;
    private FocusHold focus;
    private ExposureCap exposure;
    private final FocusWatch watch = new FocusWatch();
    private boolean shining;
    /** Where markers were when the camera was told last where to meter. */
    private List<MeteringRectangle> metered = Collections.emptyList();
    private long meteredNs;
    private CameraDevice device;
    private ImageReader reader;
    private Surface previewSurface;
    private CameraCaptureSession session;
    private CaptureRequest.Builder request;
    private CameraSetup setup;
    private boolean framesCame;
    /** Exposure from which on the lens stands still. */
    private long stillFromNs = Long.MIN_VALUE;
    private int brokenFrames;
    private long lastTimestampNs = Long.MIN_VALUE;

    /**
     * A run that has not begun.
     *
     * @param context of the app
     * @param previousEnd counts down when the run before, which is closed, has let go of its camera and its listener
     * @param calibration the user's intrinsics, or null
     * @param focusDistanceM distance that the lens was focused at for them, m; empty where that is not known
     * @param preview where the camera shows its picture, or null
     * @param listener gets set-up, frames and faults
     */
    CameraRun(Context context, CountDownLatch previousEnd, PinholeCamera calibration, OptionalDouble focusDistanceM,
            SurfaceTexture preview, CameraFeed.Listener listener) {
        this.context = context;
        this.previousEnd = previousEnd;
        this.calibration = calibration;
        this.focusDistanceM = focusDistanceM;
        this.preview = preview;
        this.listener = listener;
    }

    /** Counts down when this run has let go of its camera and its listener. */
    CountDownLatch ended() {
        return ended;
    }

    void start() {
        thread.start();
        handler = new Handler(thread.getLooper());
        handler.post(this::begin);
    }

    void close() {
        if (closed.compareAndSet(false, true)) {
            handler.post(this::end);
        }
    }

    void refocus() {
        if (!closed.get()) {
            handler.post(this::scan);
        }
    }

    void torch(boolean on) {
        if (!closed.get()) {
            handler.post(() -> shine(on));
        }
    }

    // ---- opening

    private void begin() {
        if (!previousHasEnded()) {
            fault(CameraFault.FAILED, null);
            return;
        }
        if (closed.get()) {
            return;
        }
        if (context.checkSelfPermission(Manifest.permission.CAMERA) != PackageManager.PERMISSION_GRANTED) {
            fault(CameraFault.NOT_PERMITTED, null);
            return;
        }
        CameraManager manager = context.getSystemService(CameraManager.class);
        try {
            traits = manager == null ? null : CameraChoice.of(cameras(manager));
            if (traits == null) {
                fault(CameraFault.NO_CAMERA, null);
                return;
            }
            streams = StreamChoice.of(traits, calibration);
            if (streams.isEmpty()) {
                fault(CameraFault.NO_SUITABLE_SIZE, null);
                return;
            }
            if (ModelChoice.of(traits, streams.get(0).frame(), calibration) == null) {
                fault(CameraFault.NO_CAMERA_MODEL, null);
                return;
            }
            settings = RequestSettings.of(traits, focusDistanceM);
            focus = new FocusHold(settings.focus(), settings.focusDpt());
            exposure = new ExposureCap(traits.exposureLimits());
            opening = true;
            handler.postDelayed(patience, PATIENCE_MS);
            manager.openCamera(traits.id(), new DeviceEvents(), handler);
        } catch (CameraAccessException | RuntimeException e) {
            opening = false;
            fault(CameraFaults.of(e), e);
        }
    }

    private boolean previousHasEnded() {
        try {
            return previousEnd.await(PATIENCE_MS, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return false;
        }
    }

    private static List<CameraTraits> cameras(CameraManager manager) throws CameraAccessException {
        List<CameraTraits> cameras = new ArrayList<>();
        CameraAccessException fault = null;
        for (String id : manager.getCameraIdList()) {
            try {
                cameras.add(CameraTraits.of(id, manager.getCameraCharacteristics(id)));
            } catch (CameraAccessException e) {
                fault = e;
            } catch (RuntimeException | AssertionError e) {
                // one that was unplugged meanwhile, or whose maker's code fails on it; the others still count
                Log.w(TAG, "camera " + id + " does not say what it can do", e);
            }
        }
        if (cameras.isEmpty() && fault != null) {
            throw fault;
        }
        return cameras;
    }

    /** What becomes of the device; on the run's thread. */
    private final class DeviceEvents extends CameraDevice.StateCallback {
        @Override
        public void onOpened(CameraDevice opened) {
            opening = false;
            device = opened;
            if (closed.get()) {
                end();
                return;
            }
            configure();
        }

        @Override
        public void onDisconnected(CameraDevice lost) {
            gone(lost, CameraFault.DISCONNECTED, "disconnected");
        }

        @Override
        public void onError(CameraDevice failed, int code) {
            gone(failed, CameraFaults.ofDevice(code), "error " + code);
        }

        private void gone(CameraDevice which, CameraFault fault, String what) {
            Log.w(TAG, "camera " + which.getId() + ": " + what);
            opening = false;
            device = which;
            if (closed.get()) {
                end();
            } else {
                fault(fault, null);
            }
        }
    }

    // ---- streaming

    /** Asks for the best streams that were not refused yet. */
    @SuppressWarnings("deprecation") // the newer form, with SessionConfiguration, does not exist on API 26 and 27
    private void configure() {
        StreamChoice choice = streams.get(0);
        PixelSize frame = choice.frame();
        ModelChoice model = ModelChoice.of(traits, frame, calibration);
        if (model == null) {
            fault(CameraFault.NO_CAMERA_MODEL, null);
            return;
        }
        Set<CameraNote> notes = EnumSet.noneOf(CameraNote.class);
        notes.addAll(model.notes());
        notes.addAll(settings.notes());
        setup = new CameraSetup(model.camera(), model.source(), traits.sensorOrientationDeg(),
                traits.facing() == CameraTraits.Facing.FRONT, traits.hasTorch(), notes);
        try {
            reader = ImageReader.newInstance(frame.widthPx(), frame.heightPx(), ImageFormat.YUV_420_888,
                    FRAMES_IN_FLIGHT);
            reader.setOnImageAvailableListener(this::frameCame, handler);
            request = device.createCaptureRequest(CameraDevice.TEMPLATE_PREVIEW);
            settings.applyTo(request::set);
            settings.keepExposureShort(request::set, frame);
            shine();
            List<Surface> surfaces = new ArrayList<>();
            surfaces.add(reader.getSurface());
            if (preview != null) {
                preview.setDefaultBufferSize(choice.preview().widthPx(), choice.preview().heightPx());
                previewSurface = new Surface(preview);
                surfaces.add(previewSurface);
            }
            surfaces.forEach(request::addTarget);
            device.createCaptureSession(surfaces, new SessionEvents(), handler);
        } catch (CameraAccessException | RuntimeException e) {
            fault(CameraFaults.of(e), e);
        }
    }

    /** What becomes of the session; on the run's thread. */
    private final class SessionEvents extends CameraCaptureSession.StateCallback {
        @Override
        public void onConfigured(CameraCaptureSession configured) {
            if (closed.get()) {
                return;
            }
            session = configured;
            stream();
        }

        @Override
        public void onConfigureFailed(CameraCaptureSession refused) {
            if (closed.get()) {
                return;
            }
            Log.w(TAG, "camera " + traits.id() + " refuses frames of " + streams.get(0).frame() + " with a preview of "
                    + streams.get(0).preview());
            releaseStreams();
            streams = streams.subList(1, streams.size());
            if (streams.isEmpty()) {
                fault(calibration == null ? CameraFault.FAILED : CameraFault.NO_SUITABLE_SIZE, null);
            } else {
                configure();
            }
        }
    }

    private void stream() {
        listener.onOpened(setup);
        handler.removeCallbacks(patience);
        handler.postDelayed(patience, PATIENCE_MS);
        if (repeat()) {
            if (!focus.isStill()) {
                handler.postDelayed(scanPatience, SCAN_MS);
            }
            scan();
        }
    }

    /** Asks for frames as the request has it by now; whether that was possible. */
    private boolean repeat() {
        try {
            session.setRepeatingRequest(request.build(), new FrameReports(), handler);
            return true;
        } catch (CameraAccessException | RuntimeException e) {
            fault(CameraFaults.of(e), e);
            return false;
        }
    }

    private void shine(boolean on) {
        if (closed.get() || shining == on) {
            return;
        }
        shining = on;
        // before there is a request it is told when it is made
        if (session != null) {
            shine();
            if (exposure.measureAgain()) {
                expose();
            }
            repeat();
        }
    }

    private void shine() {
        if (traits.hasTorch()) {
            request.set(CaptureRequest.FLASH_MODE,
                    shining ? CameraMetadata.FLASH_MODE_TORCH : CameraMetadata.FLASH_MODE_OFF);
        }
    }

    /** Meters and focuses by the markers of a frame. */
    private void look(Detections seen, long timestampNs) {
        if (closed.get() || session == null || !focus.isStill()) {
            return;
        }
        boolean due = focus.canScan() && watch.isDue(seen, timestampNs);
        if (settings.whole() != null && !seen.markers().isEmpty()) {
            List<MeteringRectangle> now = MeteringAreas.of(seen, settings.whole(), seen.markers().size());
            boolean early = !metered.isEmpty() && timestampNs - meteredNs < METERING_PAUSE_NS;
            if (due || !early && MeteringAreas.differ(metered, now, settings.whole())) {
                metered = now;
                meteredNs = timestampNs;
                if (!settings.meterAt(request::set, seen).isEmpty() && !repeat()) {
                    return;
                }
            }
        }
        if (due) {
            listener.onFocusing();
            scan();
        }
    }

    /** Asks for a scan of the focus; the repeating request then holds what it finds. */
    private void scan() {
        if (closed.get() || session == null || !focus.canScan()) {
            return;
        }
        focus.scanAsked();
        handler.removeCallbacks(scanPatience);
        handler.postDelayed(scanPatience, SCAN_MS);
        try {
            // out of the lock that an earlier scan ended in
            trigger(CameraMetadata.CONTROL_AF_TRIGGER_CANCEL, null);
            trigger(CameraMetadata.CONTROL_AF_TRIGGER_START, new ScanBegin());
        } catch (CameraAccessException | RuntimeException e) {
            fault(CameraFaults.of(e), e);
        }
    }

    private void trigger(int what, CameraCaptureSession.CaptureCallback callback) throws CameraAccessException {
        request.set(CaptureRequest.CONTROL_AF_TRIGGER, what);
        CaptureRequest once = request.build();
        request.set(CaptureRequest.CONTROL_AF_TRIGGER, CameraMetadata.CONTROL_AF_TRIGGER_IDLE);
        session.capture(once, callback, handler);
    }

    /** Hears with which frame a scan begins, and what the device says of it. */
    private final class ScanBegin extends CameraCaptureSession.CaptureCallback {
        @Override
        public void onCaptureStarted(CameraCaptureSession which, CaptureRequest what, long timestamp,
                long frameNumber) {
            focus.scanBegun(frameNumber);
        }

        @Override
        public void onCaptureCompleted(CameraCaptureSession which, CaptureRequest what, TotalCaptureResult result) {
            reported(result);
        }

        @Override
        public void onCaptureFailed(CameraCaptureSession which, CaptureRequest what, CaptureFailure failure) {
            // the request may have been dropped before the lens heard of it
            scanEndless();
        }
    }

    private final class FrameReports extends CameraCaptureSession.CaptureCallback {
        @Override
        public void onCaptureCompleted(CameraCaptureSession which, CaptureRequest what, TotalCaptureResult result) {
            reported(result);
        }
    }

    private void reported(CaptureResult result) {
        if (closed.get() || session == null) {
            return;
        }
        focusReported(result);
        boolean other = exposure.report(result.get(CaptureResult.CONTROL_AE_STATE),
                result.get(CaptureResult.SENSOR_EXPOSURE_TIME), result.get(CaptureResult.SENSOR_SENSITIVITY),
                result.get(CaptureResult.CONTROL_POST_RAW_SENSITIVITY_BOOST),
                result.get(CaptureResult.STATISTICS_SCENE_FLICKER));
        note(CameraNote.LIGHT_SHORT, exposure.isLightShort());
        if (other) {
            expose();
            repeat();
        }
    }

    /** Writes into the request how frames are exposed by now. */
    private void expose() {
        settings.expose(request::set, exposure.held(), streams.get(0).frame());
    }

    private void focusReported(CaptureResult result) {
        if (focus.report(result.getFrameNumber(), result.get(CaptureResult.CONTROL_AF_STATE))
                || focus.lensReport(result.get(CaptureResult.LENS_STATE),
                        result.get(CaptureResult.LENS_FOCUS_DISTANCE))) {
            handler.removeCallbacks(scanPatience);
            // reports and images come on ways of their own: an image may still be from before
            Long exposureNs = result.get(CaptureResult.SENSOR_TIMESTAMP);
            stillFromNs = exposureNs == null ? Long.MIN_VALUE : exposureNs;
            watch.scanned(Math.max(lastTimestampNs, stillFromNs));
            // an earlier scan may have come to no end, this one has
            noteFocus(settings.notes().contains(CameraNote.FOCUS_NOT_LOCKED), !focus.found());
        }
    }

    private void scanEndless() {
        if (!closed.get() && focus.giveUp()) {
            watch.scanned(lastTimestampNs);
            noteFocus(true, false);
        }
    }

    /** Says how the focus is, where that is news. */
    private void noteFocus(boolean notLocked, boolean notFound) {
        Set<CameraNote> notes = notes();
        with(notes, CameraNote.FOCUS_NOT_LOCKED, notLocked);
        with(notes, CameraNote.FOCUS_NOT_FOUND, notFound);
        if (settings.focus() == RequestSettings.Focus.AT_DISTANCE) {
            // one that did not report that it is there may be anywhere
            with(notes, CameraNote.FOCUS_AS_CALIBRATED, !notLocked);
            with(notes, CameraNote.FOCUS_NOT_AS_CALIBRATED, notLocked);
        }
        say(notes);
    }

    /** Says one thing, or no longer, where that is news. */
    private void note(CameraNote which, boolean holds) {
        if (setup.notes().contains(which) != holds) {
            Set<CameraNote> notes = notes();
            with(notes, which, holds);
            say(notes);
        }
    }

    private Set<CameraNote> notes() {
        Set<CameraNote> notes = EnumSet.noneOf(CameraNote.class);
        notes.addAll(setup.notes());
        return notes;
    }

    private static void with(Set<CameraNote> notes, CameraNote which, boolean holds) {
        if (holds) {
            notes.add(which);
        } else {
            notes.remove(which);
        }
    }

    private void say(Set<CameraNote> notes) {
        if (!notes.equals(setup.notes())) {
            setup = setup.withNotes(notes);
            listener.onOpened(setup);
        }
    }

    private void frameCame(ImageReader source) {
        if (closed.get()) {
            return;
        }
        GreyImage frame = null;
        long timestampNs = 0;
        try (Image image = source.acquireLatestImage()) {
            if (image == null) {
                return;
            }
            firstFrameCame();
            if (!focus.isStill() || image.getTimestamp() < stillFromNs) {
                return;
            }
            Image.Plane plane = image.getPlanes()[0];
            frame = luminance.read(plane.getBuffer(), plane.getRowStride(), plane.getPixelStride(), image.getWidth(),
                    image.getHeight());
            timestampNs = image.getTimestamp();
        } catch (RuntimeException | OutOfMemoryError e) {
            // no such plane, a device that delivers in another format than it was asked for, or no room for a copy
            brokenFrame(e);
            return;
        }
        brokenFrames = 0;
        lastTimestampNs = Math.max(lastTimestampNs, timestampNs);
        // the camera has its memory back already: however long the listener takes, newer frames go on arriving
        Detections seen = listener.onFrame(frame, lastTimestampNs);
        if (seen != null) {
            look(seen, lastTimestampNs);
            lookAtLight(frame, seen);
        }
    }

    /** Has the light measured anew where the markers show that it is another one. */
    private void lookAtLight(GreyImage frame, Detections seen) {
        if (!closed.get() && session != null && exposure.held() != null
                && exposure.look(MarkerWhite.of(frame, seen), lastTimestampNs)) {
            expose();
            repeat();
        }
    }

    private void firstFrameCame() {
        if (!framesCame) {
            framesCame = true;
            handler.removeCallbacks(patience);
        }
    }

    /** A frame that cannot be read: one may happen, but where all are like that the user must hear of it. */
    private void brokenFrame(Throwable e) {
        brokenFrames++;
        if (brokenFrames > BROKEN_FRAMES_ALLOWED) {
            fault(CameraFault.FAILED, e);
        }
    }

    // ---- the end

    private void fault(CameraFault fault, Throwable cause) {
        if (!closed.compareAndSet(false, true)) {
            return;
        }
        Log.w(TAG, "camera stops: " + fault, cause);
        release();
        listener.onFault(fault);
        quit();
    }

    /** Ends a run that is closed. */
    private void end() {
        release();
        quit();
    }

    private void release() {
        handler.removeCallbacks(patience);
        handler.removeCallbacks(scanPatience);
        session = null;
        if (device != null) {
            try {
                // ends the session as well; waits until the camera writes no more frames
                device.close();
            } catch (RuntimeException e) {
                Log.w(TAG, "camera " + device.getId() + " could not be closed", e);
            }
            device = null;
        }
        releaseStreams();
    }

    private void releaseStreams() {
        if (reader != null) {
            reader.setOnImageAvailableListener(null, null);
            reader.close();
            reader = null;
        }
        if (previewSurface != null) {
            previewSurface.release();
            previewSurface = null;
        }
    }

    private void quit() {
        if (!opening) {
            ended.countDown();
            thread.quitSafely();
        }
    }
}
