package org.cellgauge.android.camera;

import android.graphics.Rect;
import android.hardware.camera2.CameraMetadata;
import android.hardware.camera2.CaptureRequest;
import android.hardware.camera2.params.MeteringRectangle;
import android.os.Build;
import android.util.Range;
import java.util.Collections;
import java.util.EnumSet;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
import org.cellgauge.internal.geometry.PixelArea;
import org.cellgauge.vision.Detections;

/**
 * What a camera is told so that a calibration holds for its frames: no zoom, no stabilisation, no correction of the
 * lens, a focus that stays, nothing that sharpens edges; immutable.
 */
final class RequestSettings {
    /** How the focus is held. */
    enum Focus {
        /** The lens does not move. */
        FIXED,
        /** It is focused once and then stays until it is asked again. */
        HELD,
        /** It is set to a distance and then stays. */
        AT_DISTANCE,
        /** The device moves it when it likes. */
        FREE
    }

    /** Takes settings: a request's builder. */
    interface Target {
        /**
         * Sets one key.
         *
         * @param <T> type of its value
         * @param key the key
         * @param value its value
         */
        <T> void set(CaptureRequest.Key<T> key, T value);
    }

    private static final int NO_MODE = -1;
    /** Faster frames than these would be exposed shorter still, and come faster than they can be looked at. */
    private static final double ENOUGH_FPS = 30;
    private static final double NS_PER_S = 1e9;
    /** A duration of 33 333 333 ns is 30 frames a second, and so is one of 33.4 ms. */
    private static final double ROUNDED_FPS = 0.5;
    /** A lens that is set to its nearest distance is not much farther out of focus than this, as a share. */
    private static final double NEAREST_SHARE = 1.05;
    private static final int PLAIN_BOOST = 100;
    private static final int PER_THOUSAND_SECONDS = 1000;

    private final CameraTraits traits;
    private final Focus focus;
    private final int focusMode;
    private final float focusDpt;
    private final Set<CameraNote> notes;

    private RequestSettings(CameraTraits traits, Focus focus, int focusMode, float focusDpt, Set<CameraNote> notes) {
        this.traits = traits;
        this.focus = focus;
        this.focusMode = focusMode;
        this.focusDpt = focusDpt;
        this.notes = Collections.unmodifiableSet(notes);
    }

    /**
     * The settings for a camera.
     *
     * @param traits what it offers
     * @param focusDistanceM distance that its calibration was made at, m; empty where that is not known
     * @return the settings
     */
    static RequestSettings of(CameraTraits traits, OptionalDouble focusDistanceM) {
        Set<CameraNote> notes = EnumSet.noneOf(CameraNote.class);
        if (cannotBeOff(traits.opticalStabilisationModes(), CameraMetadata.LENS_OPTICAL_STABILIZATION_MODE_OFF)
                || cannotBeOff(traits.videoStabilisationModes(), CameraMetadata.CONTROL_VIDEO_STABILIZATION_MODE_OFF)) {
            notes.add(CameraNote.STABILISATION_ON);
        }
        int mode = holdingMode(traits.focusModes());
        Focus focus = Focus.FREE;
        if (traits.minFocusDistanceDpt() == 0 || mode == CameraMetadata.CONTROL_AF_MODE_OFF) {
            focus = Focus.FIXED;
            mode = CameraTraits.has(traits.focusModes(), CameraMetadata.CONTROL_AF_MODE_OFF)
                    ? CameraMetadata.CONTROL_AF_MODE_OFF : NO_MODE;
        } else if (mode != NO_MODE) {
            focus = Focus.HELD;
        } else {
            notes.add(CameraNote.FOCUS_NOT_LOCKED);
        }
        float dpt = Float.NaN;
        if (focusDistanceM.isPresent() && focus != Focus.FIXED) {
            dpt = (float) (1 / focusDistanceM.getAsDouble());
            if (traits.statesFocusDistance() && dpt <= NEAREST_SHARE * traits.minFocusDistanceDpt()
                    && CameraTraits.has(traits.focusModes(), CameraMetadata.CONTROL_AF_MODE_OFF)) {
                dpt = Math.min(dpt, traits.minFocusDistanceDpt());
                focus = Focus.AT_DISTANCE;
                mode = CameraMetadata.CONTROL_AF_MODE_OFF;
                notes.remove(CameraNote.FOCUS_NOT_LOCKED);
                notes.add(CameraNote.FOCUS_AS_CALIBRATED);
            } else {
                notes.add(CameraNote.FOCUS_NOT_AS_CALIBRATED);
            }
        }
        return new RequestSettings(traits, focus, mode, dpt, notes);
    }

    private static boolean cannotBeOff(int[] modes, int off) {
        return modes.length > 0 && !CameraTraits.has(modes, off);
    }

    /**
     * The mode in which the lens stays where a trigger left it; in the continuous ones it does once they are triggered.
     */
    private static int holdingMode(int[] modes) {
        int[] preferred = {CameraMetadata.CONTROL_AF_MODE_AUTO, CameraMetadata.CONTROL_AF_MODE_CONTINUOUS_PICTURE,
            CameraMetadata.CONTROL_AF_MODE_CONTINUOUS_VIDEO, CameraMetadata.CONTROL_AF_MODE_MACRO,
            CameraMetadata.CONTROL_AF_MODE_OFF};
        for (int mode : preferred) {
            if (CameraTraits.has(modes, mode)) {
                return mode;
            }
        }
        return NO_MODE;
    }

    /**
     * The focal length that is asked for: a lens with several would else zoom.
     *
     * @return the shortest, mm; NaN where none is stated
     */
    static float focalLengthMm(CameraTraits traits) {
        float shortest = Float.NaN;
        for (float f : traits.focalLengthsMm()) {
            if (f > 0 && !(f >= shortest)) {
                shortest = f;
            }
        }
        return shortest;
    }

    /** How the focus is held. */
    Focus focus() {
        return focus;
    }

    /** Where the lens is set to, 1/m; of no account where the focus is not {@link Focus#AT_DISTANCE}. */
    float focusDpt() {
        return focusDpt;
    }

    /** What the camera cannot do, and how its focus is held. */
    Set<CameraNote> notes() {
        return notes;
    }

    /**
     * Writes the settings of every frame.
     *
     * @param request gets them
     */
    void applyTo(Target request) {
        request.set(CaptureRequest.CONTROL_MODE, CameraMetadata.CONTROL_MODE_AUTO);
        if (focusMode != NO_MODE) {
            request.set(CaptureRequest.CONTROL_AF_MODE, focusMode);
        }
        if (focus == Focus.AT_DISTANCE) {
            request.set(CaptureRequest.LENS_FOCUS_DISTANCE, focusDpt);
        }
        setIfOffered(request, CaptureRequest.LENS_OPTICAL_STABILIZATION_MODE, traits.opticalStabilisationModes(),
                CameraMetadata.LENS_OPTICAL_STABILIZATION_MODE_OFF);
        setIfOffered(request, CaptureRequest.CONTROL_VIDEO_STABILIZATION_MODE, traits.videoStabilisationModes(),
                CameraMetadata.CONTROL_VIDEO_STABILIZATION_MODE_OFF);
        // sharpening draws a rim along edges, which is what corners are measured by
        setIfOffered(request, CaptureRequest.EDGE_MODE, traits.edgeModes(), CameraMetadata.EDGE_MODE_OFF);
        setIfOffered(request, CaptureRequest.NOISE_REDUCTION_MODE, traits.noiseReductionModes(),
                CameraMetadata.NOISE_REDUCTION_MODE_FAST);
        PixelArea whole = whole();
        if (correctionCanBeOff()) {
            request.set(CaptureRequest.DISTORTION_CORRECTION_MODE, CameraMetadata.DISTORTION_CORRECTION_MODE_OFF);
        }
        if (whole != null) {
            request.set(CaptureRequest.SCALER_CROP_REGION,
                    new Rect(0, 0, (int) whole.widthPx(), (int) whole.heightPx()));
        }
        if (Build.VERSION.SDK_INT >= Build.VERSION_CODES.S) {
            // else Android turns and cuts images for apps that it shows in a window of the other orientation
            setIfOffered(request, CaptureRequest.SCALER_ROTATE_AND_CROP, traits.rotateAndCropModes(),
                    CameraMetadata.SCALER_ROTATE_AND_CROP_NONE);
        }
        float focalLength = focalLengthMm(traits);
        if (traits.focalLengthsMm().length > 1 && focalLength > 0) {
            request.set(CaptureRequest.LENS_FOCAL_LENGTH, focalLength);
        }
    }

    private boolean correctionCanBeOff() {
        return Build.VERSION.SDK_INT >= Build.VERSION_CODES.P && CameraTraits.has(traits.distortionCorrectionModes(),
                CameraMetadata.DISTORTION_CORRECTION_MODE_OFF);
    }

    /**
     * The area of the sensor that frames are cut out of, which is all of it; requests count from its upper left corner.
     *
     * @return null where the camera does not state it
     */
    PixelArea whole() {
        // without the correction of the lens, areas are those of the sensor before it
        return correctionCanBeOff() ? traits.preCorrectionActiveArray() : traits.activeArray();
    }

    /**
     * Keeps the exposure of every frame short, so that a hand's tremor does not blur it: the frame rate with the
     * highest lower bound is asked for, since no frame is exposed longer than the next one may wait. In dim light the
     * frames get noisier instead, which the figures know of.
     *
     * @param request gets it
     * @param frame size of the frames, which bounds their rate
     */
    void keepExposureShort(Target request, PixelSize frame) {
        Long durationNs = traits.frameSizes().get(frame);
        double most = durationNs == null || durationNs <= 0 ? ENOUGH_FPS
                : Math.min(ENOUGH_FPS, NS_PER_S / durationNs + ROUNDED_FPS);
        Range<Integer> best = null;
        for (Range<Integer> range : traits.frameRates()) {
            boolean possible = range.getLower() > 0 && perSecond(range.getUpper()) <= most;
            if (possible && (best == null || range.getLower() > best.getLower()
                    || range.getLower().equals(best.getLower()) && range.getUpper() > best.getUpper())) {
                best = range;
            }
        }
        if (best != null) {
            request.set(CaptureRequest.CONTROL_AE_TARGET_FPS_RANGE, best);
        }
    }

    /**
     * Has frames exposed as the device likes, or as stated.
     *
     * @param request gets it
     * @param exposure what is stated; null for the device's automatic exposure
     * @param frame size of the frames, which bounds their rate
     */
    void expose(Target request, ExposureCap.Exposure exposure, PixelSize frame) {
        if (exposure == null) {
            request.set(CaptureRequest.CONTROL_AE_MODE, CameraMetadata.CONTROL_AE_MODE_ON);
            return;
        }
        Long durationNs = traits.frameSizes().get(frame);
        request.set(CaptureRequest.CONTROL_AE_MODE, CameraMetadata.CONTROL_AE_MODE_OFF);
        request.set(CaptureRequest.SENSOR_EXPOSURE_TIME, exposure.timeNs());
        request.set(CaptureRequest.SENSOR_SENSITIVITY, exposure.sensitivity());
        // the rate of frames is the automatic exposure's to keep, and without it the sensor must be told
        request.set(CaptureRequest.SENSOR_FRAME_DURATION, Math.max((long) (NS_PER_S / ENOUGH_FPS),
                Math.max(exposure.timeNs(), durationNs == null ? 0 : durationNs)));
        if (traits.exposureLimits() != null && traits.exposureLimits().mostBoost() > PLAIN_BOOST) {
            request.set(CaptureRequest.CONTROL_POST_RAW_SENSITIVITY_BOOST, exposure.boost());
        }
    }

    private static double perSecond(int rate) {
        return rate >= PER_THOUSAND_SECONDS ? rate / (double) PER_THOUSAND_SECONDS : rate;
    }

    /**
     * Has light metered and the focus searched at the markers.
     *
     * @param request gets the areas, as many as the camera takes
     * @param seen the markers of the last frame
     * @return what light is metered in and the focus searched at; empty where the camera meters as it likes
     */
    List<MeteringRectangle> meterAt(Target request, Detections seen) {
        int most = Math.max(traits.maxExposureAreas(), traits.maxFocusAreas());
        List<MeteringRectangle> areas = whole() == null ? Collections.emptyList()
                : MeteringAreas.of(seen, whole(), most);
        setAreas(request, CaptureRequest.CONTROL_AE_REGIONS, areas, traits.maxExposureAreas());
        setAreas(request, CaptureRequest.CONTROL_AF_REGIONS, areas, traits.maxFocusAreas());
        return areas;
    }

    private static void setAreas(Target request, CaptureRequest.Key<MeteringRectangle[]> key,
            List<MeteringRectangle> areas, int most) {
        if (most > 0 && !areas.isEmpty()) {
            request.set(key, areas.subList(0, Math.min(most, areas.size())).toArray(new MeteringRectangle[0]));
        }
    }

    private static void setIfOffered(Target request, CaptureRequest.Key<Integer> key, int[] offered, int mode) {
        if (CameraTraits.has(offered, mode)) {
            request.set(key, mode);
        }
    }
}
