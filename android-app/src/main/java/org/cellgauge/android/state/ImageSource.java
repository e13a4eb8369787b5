package org.cellgauge.android.state;

/** What the screen shows. */
public enum ImageSource {
    /** The camera's picture. */
    LIVE,
    /** The frame of the camera that the figures belong to, held. */
    FROZEN,
    /** A saved photo. */
    PHOTO
}
