package org.cellgauge.android.camera;

import java.util.Collections;
import java.util.EnumSet;
import java.util.Set;
import org.cellgauge.cell.CameraReader;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.cell.CameraWriter;
import org.cellgauge.internal.geometry.PixelArea;
import org.cellgauge.internal.geometry.SensorCalibration;

/** The camera model of a stream of frames and how far it can be relied on; immutable. */
final class ModelChoice {
    // handheld devices have 40 to 100 degrees, ultra-wide lenses 120; what is beyond is no field of view but a mistake
    private static final double MIN_FIELD_OF_VIEW_RAD = Math.toRadians(15);
    private static final double MAX_FIELD_OF_VIEW_RAD = Math.toRadians(130);
    private static final double MAX_FOCAL_RATIO = 1.1;
    private static final double MAX_OFF_CENTRE = 0.2;
    private static final double EXACTLY_CENTRAL_PX = 0.51;

    private final PinholeCamera camera;
    private final CameraModelSource source;
    private final Set<CameraNote> notes;

    private ModelChoice(PinholeCamera camera, CameraModelSource source, Set<CameraNote> notes) {
        this.camera = camera;
        this.source = source;
        this.notes = Collections.unmodifiableSet(notes);
    }

    /** Intrinsics of the frames. */
    PinholeCamera camera() {
        return camera;
    }

    /** Where they come from. */
    CameraModelSource source() {
        return source;
    }

    /** What the user should know of them. */
    Set<CameraNote> notes() {
        return notes;
    }

    /**
     * The best model there is: the user's calibration, else the device's, else the field of view of its data sheet.
     * What a device states is judged as a camera file is, and passed over where no camera can be like that.
     *
     * @param traits what the device states
     * @param frame size of the frames
     * @param calibration the user's, of the frames' shape, or null
     * @return the model, or null where there is no calibration and the device states nothing of use
     */
    static ModelChoice of(CameraTraits traits, PixelSize frame, PinholeCamera calibration) {
        if (calibration != null) {
            return ofFile(frame, calibration);
        }
        ModelChoice device = ofDevice(traits, frame);
        return device != null ? device : ofDataSheet(traits, frame);
    }

    private static ModelChoice ofFile(PixelSize frame, PinholeCamera calibration) {
        Set<CameraNote> notes = EnumSet.of(CameraNote.CALIBRATION_OF_ANOTHER_CAMERA);
        PinholeCamera camera = calibration;
        if (calibration.widthPx() != frame.widthPx() || calibration.heightPx() != frame.heightPx()) {
            camera = calibration.resized(frame.widthPx(), frame.heightPx());
            notes.add(CameraNote.CALIBRATION_SCALED);
        }
        return new ModelChoice(camera, CameraModelSource.CALIBRATION_FILE, notes);
    }

    private static ModelChoice ofDevice(CameraTraits traits, PixelSize frame) {
        float[] stated = traits.intrinsicCalibration();
        PixelArea before = traits.preCorrectionActiveArray();
        if (stated == null || before == null) {
            return null;
        }
        PixelArea after = traits.activeArray() == null ? before : traits.activeArray();
        float[] distortion = traits.distortion();
        boolean corrected = traits.alwaysCorrectsLens();
        PinholeCamera camera;
        try {
            camera = SensorCalibration.of(stated, distortion, before, after)
                    .toCamera(frame.widthPx(), frame.heightPx(), corrected);
        } catch (IllegalArgumentException e) {
            return null;
        }
        if (!isPlausible(camera)) {
            return null;
        }
        Set<CameraNote> notes = EnumSet.noneOf(CameraNote.class);
        if (corrected || distortion == null) {
            notes.add(CameraNote.DISTORTION_UNKNOWN);
        }
        // an axis through the very middle and a lens without any distortion are a drawing's, not a measurement's
        if (!statesDistortion(distortion) && isCentral(stated, before)) {
            notes.add(CameraNote.DISTORTION_UNKNOWN);
            notes.add(CameraNote.FOCAL_LENGTH_ESTIMATED);
            return new ModelChoice(camera, CameraModelSource.FIELD_OF_VIEW, notes);
        }
        return new ModelChoice(camera, CameraModelSource.DEVICE_CALIBRATION, notes);
    }

    private static boolean statesDistortion(float[] distortion) {
        if (distortion != null) {
            for (float k : distortion) {
                if (k != 0) {
                    return true;
                }
            }
        }
        return false;
    }

    private static boolean isCentral(float[] intrinsics, PixelArea array) {
        return Math.abs(intrinsics[2] - array.widthPx() / 2) <= EXACTLY_CENTRAL_PX
                && Math.abs(intrinsics[3] - array.heightPx() / 2) <= EXACTLY_CENTRAL_PX;
    }

    private static ModelChoice ofDataSheet(CameraTraits traits, PixelSize frame) {
        float[] focalLengths = traits.focalLengthsMm();
        PixelSize array = traits.pixelArray();
        PixelArea active = traits.alwaysCorrectsLens() ? traits.activeArray() : traits.preCorrectionActiveArray();
        if (array == null && active != null) {
            array = new PixelSize((int) active.widthPx(), (int) active.heightPx());
        }
        if (array == null || focalLengths.length == 0) {
            return null;
        }
        if (active == null) {
            active = new PixelArea(0, 0, array.widthPx(), array.heightPx());
        }
        PinholeCamera camera;
        try {
            camera = SensorCalibration.ofDataSheet(RequestSettings.focalLengthMm(traits), traits.sensorWidthMm(),
                    traits.sensorHeightMm(), array.widthPx(), array.heightPx(), active)
                    .toCamera(frame.widthPx(), frame.heightPx(), traits.alwaysCorrectsLens());
        } catch (IllegalArgumentException e) {
            return null;
        }
        return isPlausible(camera) ? new ModelChoice(camera, CameraModelSource.FIELD_OF_VIEW,
                EnumSet.of(CameraNote.FOCAL_LENGTH_ESTIMATED, CameraNote.DISTORTION_UNKNOWN)) : null;
    }

    /** Whether a lens can be like that, and the app's results can be read again elsewhere. */
    private static boolean isPlausible(PinholeCamera camera) {
        double fieldOfView = camera.horizontalFieldOfViewRad();
        double focalRatio = camera.get(PinholeCamera.FX) / camera.get(PinholeCamera.FY);
        double offX = camera.get(PinholeCamera.CX) / camera.widthPx() - 0.5;
        double offY = camera.get(PinholeCamera.CY) / camera.heightPx() - 0.5;
        // pixels are square; else width and height were mixed up, or a value is made up
        if (!(fieldOfView >= MIN_FIELD_OF_VIEW_RAD && fieldOfView <= MAX_FIELD_OF_VIEW_RAD
                && focalRatio <= MAX_FOCAL_RATIO && focalRatio >= 1 / MAX_FOCAL_RATIO
                && Math.abs(offX) <= MAX_OFF_CENTRE && Math.abs(offY) <= MAX_OFF_CENTRE)) {
            return false;
        }
        try {
            CameraReader.read(CameraWriter.text(camera), "camera of the device");
            return true;
        } catch (InputRefusedException e) {
            return false;
        }
    }
}
