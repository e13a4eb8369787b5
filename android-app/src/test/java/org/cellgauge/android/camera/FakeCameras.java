package org.cellgauge.android.camera;

import android.graphics.ImageFormat;
import android.hardware.camera2.CameraAccessException;
import android.hardware.camera2.CameraCaptureSession;
import android.hardware.camera2.CameraCharacteristics;
import android.hardware.camera2.CameraDevice;
import android.hardware.camera2.CameraManager;
import android.hardware.camera2.CaptureFailure;
import android.hardware.camera2.CaptureRequest;
import android.hardware.camera2.CaptureResult;
import android.hardware.camera2.TotalCaptureResult;
import android.hardware.camera2.params.InputConfiguration;
import android.hardware.camera2.params.OutputConfiguration;
import android.media.Image;
import android.media.ImageReader;
import android.os.Handler;
import android.util.Size;
import android.view.Surface;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import org.cellgauge.vision.GreyImage;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.annotation.Implementation;
import org.robolectric.annotation.Implements;
import org.robolectric.shadow.api.Shadow;
import org.robolectric.shadows.ShadowCameraCharacteristics;
import org.robolectric.shadows.ShadowCameraManager;
import org.robolectric.shadows.ShadowTotalCaptureResult;
import org.robolectric.shadows.StreamConfigurationMapBuilder;
import org.robolectric.util.ReflectionHelpers;

/**
 * Cameras that do what a test tells them: open late or not at all, refuse sizes, report a focus, deliver frames, die.
 * They answer on the handler that they are given, as Android's do.
 */
public final class FakeCameras {
    /** What the next calls meet; replaced before every test. */
    static FakeCameras current = new FakeCameras();

    final List<Device> devices = new CopyOnWriteArrayList<>();
    final List<Reader> readers = new CopyOnWriteArrayList<>();
    /** Whether a camera waits with its answer until {@link Device#open} is called. */
    volatile boolean openLate;
    /** Error code in place of opening; 0 for none. */
    volatile int openError;
    /** Thrown when a camera is to be opened, if not null. */
    volatile Exception openFault;
    /** Thrown when cameras are listed, if not null. */
    volatile CameraAccessException listFault;
    /** Thrown when a session is asked for, if not null. */
    volatile Exception sessionFault;
    /** Thrown when frames are asked for, if not null. */
    volatile Exception streamFault;
    /** How many sessions are refused. */
    volatile int refuse;
    /** Whether scans of the focus are never reported on. */
    volatile boolean muteFocus;

    private final Map<CaptureRequest, Map<CaptureRequest.Key<?>, Object>> requests = new IdentityHashMap<>();

    /** Cameras of which nothing is open yet; the next calls meet these. */
    public static FakeCameras begin() {
        current = new FakeCameras();
        return current;
    }

    /** The device has a camera whose lens does not move, with frames of one size alone. */
    public static void plugIn(int facing, int sensorOrientationDeg, int widthPx, int heightPx) {
        CameraCharacteristics c = ShadowCameraCharacteristics.newCameraCharacteristics();
        ShadowCameraCharacteristics shadow = Shadow.extract(c);
        shadow.set(CameraCharacteristics.LENS_FACING, facing);
        shadow.set(CameraCharacteristics.SENSOR_ORIENTATION, sensorOrientationDeg);
        shadow.set(CameraCharacteristics.SCALER_STREAM_CONFIGURATION_MAP, StreamConfigurationMapBuilder.newBuilder()
                .addOutputSize(ImageFormat.YUV_420_888, new Size(widthPx, heightPx))
                .addOutputSize(new Size(widthPx, heightPx)).build());
        shadow.set(CameraCharacteristics.LENS_INFO_MINIMUM_FOCUS_DISTANCE, 0f);
        shadow.set(CameraCharacteristics.CONTROL_AF_AVAILABLE_MODES, new int[] {0});
        Manager manager = Shadow.extract(RuntimeEnvironment.getApplication().getSystemService(CameraManager.class));
        manager.addCamera("0", c);
    }

    /** How many cameras were opened so far. */
    public int openings() {
        return devices.size();
    }

    /** Whether the camera that was opened last delivers frames. */
    public boolean streams() {
        return !devices.isEmpty() && lastDevice().session != null && lastDevice().session.streams();
    }

    /** The camera that was opened last takes a picture of what is stated, of its frames' size. */
    public void deliver(GreyImage seen, long timestampNs) {
        Reader reader = lastReader();
        if (seen.widthPx() != reader.width || seen.heightPx() != reader.height) {
            throw new IllegalArgumentException("the camera was asked for other frames: " + reader.width + " x "
                    + reader.height);
        }
        reader.deliver(new Frame(seen, timestampNs));
    }

    /** How many frames were delivered so far, by all cameras. */
    public int delivered() {
        return readers.stream().mapToInt(r -> r.frames.size()).sum();
    }

    /** Whether the app has closed every image that it took, so that the cameras have their memory back. */
    public boolean allFramesClosed() {
        return readers.stream().flatMap(r -> r.frames.stream()).allMatch(f -> f.closed);
    }

    private Map<CaptureRequest.Key<?>, Object> settingsOf(CaptureRequest request) {
        synchronized (requests) {
            return requests.get(request);
        }
    }

    Device lastDevice() {
        return devices.get(devices.size() - 1);
    }

    Reader lastReader() {
        return readers.get(readers.size() - 1);
    }

    /** Whether nothing that was opened is still open. */
    public boolean allClosed() {
        return devices.stream().allMatch(d -> d.closed) && readers.stream().allMatch(r -> r.closed);
    }

    @SuppressWarnings("unchecked")
    private static <E extends Exception> void raise(Exception e) throws E {
        if (e != null) {
            throw (E) e;
        }
    }

    /** The camera service. */
    @Implements(CameraManager.class)
    public static final class Manager extends ShadowCameraManager {
        @Implementation
        protected String[] getCameraIdList() throws CameraAccessException {
            FakeCameras.<CameraAccessException>raise(current.listFault);
            return super.getCameraIdList();
        }

        @Implementation
        protected void openCamera(String id, CameraDevice.StateCallback callback, Handler handler)
                throws CameraAccessException {
            FakeCameras.<CameraAccessException>raise(current.openFault);
            Device device = new Device(id, callback, handler);
            current.devices.add(device);
            if (current.openError != 0) {
                handler.post(() -> callback.onError(device, current.openError));
            } else if (!current.openLate) {
                device.open();
            }
        }
    }

    /** A camera; its deprecated methods are the ones of API 26. */
    @SuppressWarnings("deprecation")
    static final class Device extends CameraDevice {
        final CameraDevice.StateCallback callback;
        volatile boolean closed;
        volatile Session session;
        private final String id;
        private final Handler handler;

        Device(String id, CameraDevice.StateCallback callback, Handler handler) {
            this.id = id;
            this.callback = callback;
            this.handler = handler;
        }

        void open() {
            handler.post(() -> callback.onOpened(this));
        }

        void disconnect() {
            handler.post(() -> callback.onDisconnected(this));
        }

        void fail(int code) {
            handler.post(() -> callback.onError(this, code));
        }

        @Override
        public String getId() {
            return id;
        }

        @Override
        public CaptureRequest.Builder createCaptureRequest(int template) {
            return Shadow.newInstanceOf(CaptureRequest.Builder.class);
        }

        @Override
        public void createCaptureSession(List<Surface> outputs, CameraCaptureSession.StateCallback events, Handler on)
                throws CameraAccessException {
            FakeCameras.<CameraAccessException>raise(current.sessionFault);
            Session created = new Session(this, outputs.size());
            on.post(() -> {
                if (closed) {
                    return;
                }
                if (current.refuse > 0) {
                    current.refuse--;
                    events.onConfigureFailed(created);
                } else {
                    session = created;
                    events.onConfigured(created);
                }
            });
        }

        @Override
        public void close() {
            closed = true;
        }

        @Override
        public void createCaptureSessionByOutputConfigurations(List<OutputConfiguration> outputs,
                CameraCaptureSession.StateCallback events, Handler on) {
            throw new UnsupportedOperationException();
        }

        @Override
        public void createReprocessableCaptureSession(InputConfiguration input, List<Surface> outputs,
                CameraCaptureSession.StateCallback events, Handler on) {
            throw new UnsupportedOperationException();
        }

        @Override
        public void createReprocessableCaptureSessionByConfigurations(InputConfiguration input,
                List<OutputConfiguration> outputs, CameraCaptureSession.StateCallback events, Handler on) {
            throw new UnsupportedOperationException();
        }

        @Override
        public void createConstrainedHighSpeedCaptureSession(List<Surface> outputs,
                CameraCaptureSession.StateCallback events, Handler on) {
            throw new UnsupportedOperationException();
        }

        @Override
        public void createCustomCaptureSession(InputConfiguration input, List<OutputConfiguration> outputs, int mode,
                CameraCaptureSession.StateCallback events, Handler on) {
            throw new UnsupportedOperationException();
        }

        @Override
        public CaptureRequest.Builder createReprocessCaptureRequest(TotalCaptureResult result) {
            throw new UnsupportedOperationException();
        }
    }

    /** Collects what a request is to say; Android's has native code behind it. */
    @Implements(CaptureRequest.Builder.class)
    public static final class RequestBuilder {
        private final Map<CaptureRequest.Key<?>, Object> settings = new HashMap<>();

        @Implementation
        protected <T> void set(CaptureRequest.Key<T> key, T value) {
            settings.put(key, value);
        }

        @Implementation
        protected void addTarget(Surface surface) {
        }

        @Implementation
        protected CaptureRequest build() {
            CaptureRequest request = Shadow.newInstanceOf(CaptureRequest.class);
            synchronized (current.requests) {
                current.requests.put(request, new HashMap<>(settings));
            }
            return request;
        }
    }

    /** A session of a camera. */
    static final class Session extends CameraCaptureSession {
        final int outputs;
        /** Values of the focus' trigger in requests for one frame. */
        final List<Integer> triggers = new CopyOnWriteArrayList<>();
        /** Settings of the request for all frames. */
        volatile Map<CaptureRequest.Key<?>, Object> settings;
        /** How many requests for all frames there were. */
        final AtomicInteger requests = new AtomicInteger();
        private final Device device;
        private volatile CaptureCallback repeating;
        private volatile Handler repeatingOn;
        private volatile CaptureCallback scan;
        private volatile long frameNumber;

        Session(Device device, int outputs) {
            this.device = device;
            this.outputs = outputs;
        }

        boolean streams() {
            return repeating != null;
        }

        /** The camera says of its next frame how the focus is. */
        void reportFocus(Integer state, Long exposureNs) {
            frameNumber++;
            TotalCaptureResult result = result(frameNumber, state);
            if (exposureNs != null) {
                ((ShadowTotalCaptureResult) Shadow.extract(result)).set(CaptureResult.SENSOR_TIMESTAMP, exposureNs);
            }
            repeatingOn.post(() -> repeating.onCaptureCompleted(this, null, result));
        }

        /** The camera says of its next frame what a test states; focus and exposure are left out where it does not. */
        void report(Map<CaptureResult.Key<?>, Object> values) {
            frameNumber++;
            TotalCaptureResult result = result(frameNumber, null);
            values.forEach((key, value) -> set(result, key, value));
            repeatingOn.post(() -> repeating.onCaptureCompleted(this, null, result));
        }

        @SuppressWarnings("unchecked")
        private static <T> void set(TotalCaptureResult result, CaptureResult.Key<T> key, Object value) {
            ((ShadowTotalCaptureResult) Shadow.extract(result)).set(key, (T) value);
        }

        /** The camera drops the request for a scan. */
        void failScan() {
            CaptureCallback failing = scan;
            repeatingOn.post(() -> failing.onCaptureFailed(this, null, (CaptureFailure) null));
        }

        private static TotalCaptureResult result(long frameNumber, Integer state) {
            TotalCaptureResult result = ShadowTotalCaptureResult.newTotalCaptureResult();
            ReflectionHelpers.setField(CaptureResult.class, result, "mFrameNumber", frameNumber);
            if (state != null) {
                ((ShadowTotalCaptureResult) Shadow.extract(result)).set(CaptureResult.CONTROL_AF_STATE, state);
            }
            return result;
        }

        @Override
        public int setRepeatingRequest(CaptureRequest request, CaptureCallback callback, Handler on)
                throws CameraAccessException {
            FakeCameras.<CameraAccessException>raise(current.streamFault);
            repeatingOn = on;
            requests.incrementAndGet();
            settings = current.settingsOf(request);
            repeating = callback;
            return 1;
        }

        @Override
        public int capture(CaptureRequest request, CaptureCallback callback, Handler on) {
            triggers.add((Integer) current.settingsOf(request).get(CaptureRequest.CONTROL_AF_TRIGGER));
            if (callback != null) {
                scan = callback;
                if (!current.muteFocus) {
                    frameNumber++;
                    long number = frameNumber;
                    on.post(() -> callback.onCaptureStarted(this, request, 0, number));
                }
            }
            return 2;
        }

        @Override
        public CameraDevice getDevice() {
            return device;
        }

        @Override
        public void close() {
        }

        @Override
        public void prepare(Surface surface) {
        }

        @Override
        public void prepare(int maxCount, Surface surface) {
        }

        @Override
        public void tearDown(Surface surface) {
        }

        @Override
        public void finalizeOutputConfigurations(List<OutputConfiguration> outputs) {
        }

        @Override
        public int captureBurst(List<CaptureRequest> requests, CaptureCallback callback, Handler on) {
            return 0;
        }

        @Override
        public int setRepeatingBurst(List<CaptureRequest> requests, CaptureCallback callback, Handler on) {
            return 0;
        }

        @Override
        public void stopRepeating() {
        }

        @Override
        public void abortCaptures() {
        }

        @Override
        public boolean isReprocessable() {
            return false;
        }

        @Override
        public Surface getInputSurface() {
            return null;
        }
    }

    /** Takes the place of Android's reader, which has no camera to read from here. */
    @Implements(ImageReader.class)
    public static final class Reader {
        volatile boolean closed;
        volatile int width;
        volatile int height;
        final List<Frame> frames = new CopyOnWriteArrayList<>();
        private final List<Frame> waiting = new ArrayList<>();
        private volatile ImageReader self;
        private volatile ImageReader.OnImageAvailableListener listener;
        private volatile Handler handler;

        @Implementation
        protected static ImageReader newInstance(int width, int height, int format, int maxImages) {
            ImageReader made = Shadow.newInstanceOf(ImageReader.class);
            Reader shadow = Shadow.extract(made);
            shadow.self = made;
            shadow.width = width;
            shadow.height = height;
            current.readers.add(shadow);
            return made;
        }

        @Implementation
        protected void setOnImageAvailableListener(ImageReader.OnImageAvailableListener value, Handler on) {
            listener = value;
            handler = on;
        }

        @Implementation
        protected Surface getSurface() {
            return Shadow.newInstanceOf(Surface.class);
        }

        @Implementation
        protected Image acquireLatestImage() {
            synchronized (waiting) {
                Frame latest = waiting.isEmpty() ? null : waiting.remove(waiting.size() - 1);
                waiting.forEach(Frame::close);
                waiting.clear();
                return latest;
            }
        }

        @Implementation
        protected void close() {
            closed = true;
        }

        @Implementation(methodName = "finalize")
        protected void collected() {
        }

        /** A frame of one grey value comes. */
        Frame deliver(int grey, long timestampNs, boolean cutShort) {
            return deliver(new Frame(width, height, grey, timestampNs, cutShort));
        }

        private Frame deliver(Frame frame) {
            frames.add(frame);
            synchronized (waiting) {
                waiting.add(frame);
            }
            ImageReader.OnImageAvailableListener to = listener;
            if (to != null) {
                handler.post(() -> to.onImageAvailable(self));
            }
            return frame;
        }
    }

    /** A frame with rows 16 bytes longer than its width. */
    static final class Frame extends Image {
        private static final int PADDING = 16;

        volatile boolean closed;
        private final int width;
        private final int height;
        private final long timestampNs;
        private final ByteBuffer plane;

        Frame(int width, int height, int grey, long timestampNs, boolean cutShort) {
            this.width = width;
            this.height = height;
            this.timestampNs = timestampNs;
            int length = (width + PADDING) * (height - 1) + width - (cutShort ? 1 : 0);
            plane = ByteBuffer.allocateDirect(length);
            for (int i = 0; i < length; i++) {
                plane.put(i, (byte) (i % (width + PADDING) < width ? grey : 255));
            }
        }

        Frame(GreyImage seen, long timestampNs) {
            this(seen.widthPx(), seen.heightPx(), 0, timestampNs, false);
            for (int y = 0; y < height; y++) {
                for (int x = 0; x < width; x++) {
                    plane.put(y * (width + PADDING) + x, (byte) seen.get(x, y));
                }
            }
        }

        @Override
        public int getFormat() {
            return ImageFormat.YUV_420_888;
        }

        @Override
        public int getWidth() {
            return width;
        }

        @Override
        public int getHeight() {
            return height;
        }

        @Override
        public long getTimestamp() {
            return timestampNs;
        }

        @Override
        public int getTransform() {
            return 0;
        }

        @Override
        public int getScalingMode() {
            return 0;
        }

        @Override
        public Plane[] getPlanes() {
            return new Plane[] {new Plane() {
                @Override
                public int getRowStride() {
                    return width + PADDING;
                }

                @Override
                public int getPixelStride() {
                    return 1;
                }

                @Override
                public ByteBuffer getBuffer() {
                    return plane;
                }
            }};
        }

        @Override
        public void close() {
            closed = true;
        }
    }
}
