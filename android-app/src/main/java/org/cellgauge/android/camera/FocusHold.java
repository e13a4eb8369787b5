package org.cellgauge.android.camera;

import android.hardware.camera2.CameraMetadata;

/**
 * Whether the lens stands still, so that frames may be measured in. A scan is asked for, the device reports how it
 * goes, and from its end on the lens stays where it is. Or the lens is set to a distance, and stays once it is there.
 */
final class FocusHold {
    /** A lens this near to where it was set to is there, as a share and besides, 1/m. */
    private static final double THERE_SHARE = 0.05;
    private static final double THERE_DPT = 0.05;

    private final RequestSettings.Focus focus;
    private final float setDpt;
    /** Whether the lens moves: in a scan, or on its way to a distance. */
    private boolean scanning;
    private boolean found = true;
    /** Number of the frame with which the scan in progress was asked for; reports on earlier ones are of the past. */
    private long scanFrame = Long.MAX_VALUE;

    /**
     * A lens before its first scan, or on its way to where it is set to.
     *
     * @param focus how its focus is held
     * @param setDpt where it is set to, 1/m; of no account with another focus
     */
    FocusHold(RequestSettings.Focus focus, float setDpt) {
        this.focus = focus;
        this.setDpt = setDpt;
        scanning = focus == RequestSettings.Focus.AT_DISTANCE;
    }

    /** Whether a scan makes sense: the lens moves, and stays where it came to. */
    boolean canScan() {
        return focus == RequestSettings.Focus.HELD;
    }

    /** A scan was asked for. */
    void scanAsked() {
        if (canScan()) {
            scanning = true;
            scanFrame = Long.MAX_VALUE;
        }
    }

    /**
     * The camera took up the request for a scan.
     *
     * @param frameNumber the frame that it goes with
     */
    void scanBegun(long frameNumber) {
        scanFrame = frameNumber;
    }

    /**
     * The device reports on a frame.
     *
     * @param frameNumber the frame
     * @param state one of the {@code CONTROL_AF_STATE} constants; null where the device reports none
     * @return whether the scan ended with this
     */
    boolean report(long frameNumber, Integer state) {
        if (!scanning || frameNumber < scanFrame || state == null) {
            return false;
        }
        // what counts for measuring is that it stays; whether it is sharp is said
        if (state == CameraMetadata.CONTROL_AF_STATE_FOCUSED_LOCKED
                || state == CameraMetadata.CONTROL_AF_STATE_NOT_FOCUSED_LOCKED) {
            scanning = false;
            found = state == CameraMetadata.CONTROL_AF_STATE_FOCUSED_LOCKED;
            return true;
        }
        return false;
    }

    /**
     * The device reports where the lens of a frame was.
     *
     * @param state one of the {@code LENS_STATE} constants; null where the device reports none
     * @param distanceDpt 1/m; null where the device reports none
     * @return whether a lens that was set to a distance is there with this
     */
    boolean lensReport(Integer state, Float distanceDpt) {
        boolean there = distanceDpt != null && Math.abs(distanceDpt - setDpt) <= THERE_SHARE * setDpt + THERE_DPT;
        boolean stands = state == null || state == CameraMetadata.LENS_STATE_STATIONARY;
        if (focus != RequestSettings.Focus.AT_DISTANCE || !scanning || !there || !stands) {
            return false;
        }
        scanning = false;
        return true;
    }

    /** Whether the last scan that ended found a focus. */
    boolean found() {
        return found;
    }

    /**
     * Waiting has no more sense.
     *
     * @return whether a scan was in progress: then nobody knows whether the lens stays
     */
    boolean giveUp() {
        boolean was = scanning;
        scanning = false;
        return was;
    }

    /** Whether frames may be measured in: no scan is in progress. */
    boolean isStill() {
        return !scanning;
    }
}
