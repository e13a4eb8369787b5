package org.cellgauge.android.camera;

/** What the user should know about how this device measures. */
public enum CameraNote {
    /** The device cannot lock the focus: sharpness, and with it the focal length, may wander. */
    FOCUS_NOT_LOCKED,
    /** The last scan of the focus found nothing sharp. */
    FOCUS_NOT_FOUND,
    /** The lens is held at the distance that the calibration states. */
    FOCUS_AS_CALIBRATED,
    /** The calibration states a distance that this camera's lens cannot be set to. */
    FOCUS_NOT_AS_CALIBRATED,
    /** Too little light for exposures that a hand does not blur. */
    LIGHT_SHORT,
    /** Optical or video stabilisation cannot be switched off: it shifts the image against the calibration. */
    STABILISATION_ON,
    /**
     * How the lens distorts is not known: the device corrects it in a way it does not state, or states nothing of it.
     * Straight lines may be bent by some pixels near the image's borders.
     */
    DISTORTION_UNKNOWN,
    /** The calibration is for another image size of the same shape and was scaled to the camera's. */
    CALIBRATION_SCALED,
    /** The calibration lacks tablet and lens; whether it belongs to this camera is for the user to know. */
    CALIBRATION_OF_ANOTHER_CAMERA,
    /** The focal length is known by the field of view alone and is estimated along with the poses. */
    FOCAL_LENGTH_ESTIMATED
}
