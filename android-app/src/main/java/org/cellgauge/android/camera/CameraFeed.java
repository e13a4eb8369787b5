package org.cellgauge.android.camera;

import android.graphics.SurfaceTexture;
import java.util.OptionalDouble;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.GreyImage;

/** A camera that delivers frames: the device's, or one of a test. All methods are called on the main thread. */
public interface CameraFeed {
    /** Gets what the camera has to say, on a thread of the feed; calls never overlap. */
    interface Listener {
        /**
         * The camera is open and frames will follow. Called again where it turns out later that less is known of the
         * frames, as when the focus does not hold: the set-up replaces the earlier one.
         *
         * @param setup how they come
         */
        void onOpened(CameraSetup setup);

        /** The lens begins to move by itself, because the view has changed: no frame comes until it stands still. */
        void onFocusing();

        /**
         * The newest frame; older ones that nobody fetched are gone.
         *
         * @param luminance the frame's luminance in sensor orientation; valid until this call returns, its array is
         *     used again
         * @param timestampNs time of the exposure, from a clock that never runs backwards
         * @return the markers that it shows, where light is then metered and by which the focus is watched; null where
         *     it was not looked at
         */
        Detections onFrame(GreyImage luminance, long timestampNs);

        /**
         * The camera stopped; it is closed already and can be opened again.
         *
         * @param fault why
         */
        void onFault(CameraFault fault);
    }

    /**
     * Opens the camera; a call while it is open closes it first.
     *
     * @param calibration intrinsics that the user has for the camera, or null: the device's own model
     * @param focusDistanceM distance that the lens was focused at for that calibration, m, which it is set to where it
     *     can be; empty where that is not known
     * @param preview where the camera shows its picture, or null for none
     * @param listener gets set-up, frames and faults
     */
    void open(PinholeCamera calibration, OptionalDouble focusDistanceM, SurfaceTexture preview, Listener listener);

    /**
     * Focuses once more and then holds the focus, as after opening. No frames come while the lens moves. Does nothing
     * where the camera is closed, or its lens does not move.
     */
    void refocus();

    /**
     * Switches the lamp beside the camera. Does nothing where the camera is closed, or there is none; a camera opens
     * with its lamp off.
     *
     * @param on whether it is to shine
     */
    void torch(boolean on);

    /**
     * Closes the camera; no call of the listener begins after it, but one that has begun may still run. Does nothing
     * where the camera is closed. Returns at once, before the device has let go of the camera.
     */
    void close();
}
