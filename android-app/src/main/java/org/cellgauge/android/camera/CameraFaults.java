package org.cellgauge.android.camera;

import android.hardware.camera2.CameraAccessException;
import android.hardware.camera2.CameraDevice;

/** What the errors of the camera service mean to the user. */
final class CameraFaults {
    private CameraFaults() {
    }

    /**
     * The fault behind an exception.
     *
     * @param e thrown by the camera service or a camera
     * @return what to tell
     */
    static CameraFault of(Exception e) {
        if (e instanceof SecurityException) {
            return CameraFault.NOT_PERMITTED;
        }
        if (!(e instanceof CameraAccessException)) {
            // IllegalArgumentException, IllegalStateException and what a device's own code throws
            return CameraFault.FAILED;
        }
        switch (((CameraAccessException) e).getReason()) {
            case CameraAccessException.CAMERA_IN_USE:
            case CameraAccessException.MAX_CAMERAS_IN_USE:
                return CameraFault.IN_USE;
            case CameraAccessException.CAMERA_DISABLED:
                return CameraFault.DISABLED;
            case CameraAccessException.CAMERA_DISCONNECTED:
                return CameraFault.DISCONNECTED;
            default:
                return CameraFault.FAILED;
        }
    }

    /**
     * The fault behind an error code.
     *
     * @param code as {@link CameraDevice.StateCallback#onError} gets it
     * @return what to tell
     */
    static CameraFault ofDevice(int code) {
        switch (code) {
            case CameraDevice.StateCallback.ERROR_CAMERA_IN_USE:
            case CameraDevice.StateCallback.ERROR_MAX_CAMERAS_IN_USE:
                return CameraFault.IN_USE;
            case CameraDevice.StateCallback.ERROR_CAMERA_DISABLED:
                return CameraFault.DISABLED;
            default:
                return CameraFault.FAILED;
        }
    }
}
