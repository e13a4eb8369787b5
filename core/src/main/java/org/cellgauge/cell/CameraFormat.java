package org.cellgauge.cell;

import org.jspecify.annotations.Nullable;

/**
 * Whose form a camera file has. All but BoofCV's count pixels so that (0, 0) is the middle of the upper left one, half
 * a pixel less than here; reading adds 0.5 px to both coordinates of the principal point, and writing takes it off.
 */
public enum CameraFormat {
    /** BoofCV's calibration file, the form of this project's own. */
    BOOFCV("BoofCV", 0),
    /** OpenCV's FileStorage with a camera matrix and distortion coefficients: YAML, XML or JSON. */
    OPENCV("OpenCV", 0.5),
    /** ROS's {@code camera_info}. */
    ROS("ROS camera_info", 0.5),
    /** A camera of Kalibr's chain of cameras. */
    KALIBR("Kalibr", 0.5),
    /** PhotonVision's calibration, JSON. */
    PHOTONVISION("PhotonVision", 0.5),
    /** The intrinsics of librealsense as JSON. */
    REALSENSE("RealSense", 0.5),
    /** mrcal's cameramodel. */
    MRCAL("mrcal", 0.5);

    private final String words;
    private final double principalPointShiftPx;

    CameraFormat(String words, double principalPointShiftPx) {
        this.words = words;
        this.principalPointShiftPx = principalPointShiftPx;
    }

    /**
     * Its name for people.
     *
     * @return a name in any language
     */
    public String words() {
        return words;
    }

    /**
     * What is added to a principal point in this form, because pixel centres are at +0.5 here.
     *
     * @return px, for x and y alike
     */
    public double principalPointShiftPx() {
        return principalPointShiftPx;
    }

    /** Whose form a mapping has; null where it has none of them. */
    static @Nullable CameraFormat of(YamlMapping camera) {
        if (camera.optional("pinhole") != null) {
            return BOOFCV;
        }
        if (camera.optional("imagersize") != null) {
            return MRCAL;
        }
        if (camera.optional("cameraIntrinsics") != null) {
            return PHOTONVISION;
        }
        if (camera.optional("ppx") != null) {
            return REALSENSE;
        }
        if (camera.optional("camera_model") != null) {
            return KALIBR;
        }
        if (camera.optional("distortion_model") != null && OtherCamera.hasMatrix(camera)) {
            return ROS;
        }
        if (OtherCamera.hasMatrix(camera)) {
            return OPENCV;
        }
        return camera.optional("model") != null ? BOOFCV : null;
    }
}
