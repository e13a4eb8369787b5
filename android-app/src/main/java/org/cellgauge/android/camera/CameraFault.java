package org.cellgauge.android.camera;

/** Why the camera does not deliver, as far as the user can do something about it. */
public enum CameraFault {
    /** The device has no camera. */
    NO_CAMERA,
    /** The permission was not given, or was taken back. */
    NOT_PERMITTED,
    /** Another app holds the camera. */
    IN_USE,
    /** A policy or a switch of the device keeps the camera off. */
    DISABLED,
    /** The camera was unplugged or taken away while it ran. */
    DISCONNECTED,
    /** The camera cannot deliver the image size that its calibration is for, nor one of the same shape. */
    NO_SUITABLE_SIZE,
    /** Nobody knows how the camera sees: there is no calibration, and the device states none and no field of view. */
    NO_CAMERA_MODEL,
    /** Anything else; trying again may help. */
    FAILED
}
