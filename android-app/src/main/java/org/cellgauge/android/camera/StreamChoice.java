package org.cellgauge.android.camera;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.geometry.PixelArea;

/** The sizes in which a camera delivers: frames to measure in and the preview that shows them; immutable. */
final class StreamChoice {
    /** Frames need at least this many pixels where the camera has them, for corners to be found at arm's length. */
    static final long MIN_AREA = 1280L * 720;
    /** Frames have at most this many pixels where there is a choice: detection must keep up. */
    static final long MAX_AREA = 1920L * 1080;
    /** Frames come at least about 15 times a second where there is a choice. */
    static final long MAX_FRAME_DURATION_NS = 67_000_000;
    /** A preview needs no more than a screen has. */
    private static final long MAX_PREVIEW_AREA = 1920L * 1080;

    private final PixelSize frame;
    private final PixelSize preview;

    private StreamChoice(PixelSize frame, PixelSize preview) {
        this.frame = frame;
        this.preview = preview;
    }

    /** Size of the frames. */
    PixelSize frame() {
        return frame;
    }

    /** Size of the preview: of the frames' shape, so that both show the same part of the world. */
    PixelSize preview() {
        return preview;
    }

    /**
     * The sizes to try, the best first: cameras list sizes that they then cannot deliver together.
     *
     * @param camera what it offers
     * @param calibration intrinsics that the user has for it, or null
     * @return with a calibration: its own size and then others of its shape, empty where there is none of either;
     *     without one: by area and speed, empty only where the camera has no frames at all
     */
    static List<StreamChoice> of(CameraTraits camera, PinholeCamera calibration) {
        List<PixelSize> frames = new ArrayList<>(camera.frameSizes().keySet());
        PixelSize calibrated = calibration == null ? null
                : new PixelSize(calibration.widthPx(), calibration.heightPx());
        if (calibrated != null) {
            frames.removeIf(size -> !size.sameShapeAs(calibrated));
        }
        PixelSize sensor = sensorShape(camera);
        frames.sort(Comparator.comparing((PixelSize size) -> !size.equals(calibrated))
                .thenComparing(size -> rank(camera, size))
                .thenComparing(size -> distanceFromBounds(size))
                .thenComparing(size -> -size.area())
                // of equal areas the one that cuts nothing off the sensor's image
                .thenComparing(size -> sensor == null || !size.sameShapeAs(sensor)));
        List<StreamChoice> choices = new ArrayList<>();
        for (PixelSize frame : frames) {
            choices.add(new StreamChoice(frame, previewFor(frame, camera.previewSizes())));
        }
        return Collections.unmodifiableList(choices);
    }

    /** 0 for frames that are large and fast enough; then those that are at least fast. */
    private static int rank(CameraTraits camera, PixelSize size) {
        boolean fast = camera.frameSizes().get(size) <= MAX_FRAME_DURATION_NS;
        boolean within = distanceFromBounds(size) == 0;
        return fast && within ? 0 : fast ? 1 : within ? 2 : 3;
    }

    /** By how many pixels a size is too small or too large. */
    private static long distanceFromBounds(PixelSize size) {
        return Math.max(0, Math.max(MIN_AREA - size.area(), size.area() - MAX_AREA));
    }

    private static PixelSize sensorShape(CameraTraits camera) {
        PixelArea active = camera.activeArray();
        return active == null ? null : new PixelSize((int) active.widthPx(), (int) active.heightPx());
    }

    private static PixelSize previewFor(PixelSize frame, List<PixelSize> offered) {
        PixelSize best = null;
        for (PixelSize size : offered) {
            if (size.sameShapeAs(frame) && size.area() <= MAX_PREVIEW_AREA
                    && (best == null || size.area() > best.area())) {
                best = size;
            }
        }
        // cameras deliver to a screen whatever they deliver as frames, whether they list it or not
        return best != null ? best : frame;
    }
}
