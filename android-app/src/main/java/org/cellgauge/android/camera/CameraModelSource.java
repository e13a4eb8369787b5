package org.cellgauge.android.camera;

/** Where the camera model in use comes from, the best first. */
public enum CameraModelSource {
    /** A calibration file that the user chose, or the keys inline in the cell file. */
    CALIBRATION_FILE,
    /** The calibration that the maker stored in the device (LENS_INTRINSIC_CALIBRATION). */
    DEVICE_CALIBRATION,
    /** The field of view by focal length and sensor size; the focal length is sampled. */
    FIELD_OF_VIEW
}
