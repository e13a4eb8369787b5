package org.cellgauge.android.state;

/** Whether the camera may be used. */
public enum CameraPermission {
    /** Not looked at yet. */
    UNKNOWN,
    /** Given. */
    GRANTED,
    /** Not given, and the user may be asked. */
    ASK,
    /** Refused for good: only the device's settings can give it. */
    REFUSED
}
