package org.cellgauge.android.camera;

import java.util.List;

/** Which camera of a device measures. */
final class CameraChoice {
    private CameraChoice() {
    }

    /**
     * The camera to measure with: one that looks away from the user, else one that is plugged in, else one that looks
     * at the user; of several the first in the device's order, which is its main one.
     *
     * @param cameras the device's, in its order
     * @return one that delivers frames, or null if there is none
     */
    static CameraTraits of(List<CameraTraits> cameras) {
        CameraTraits best = null;
        for (CameraTraits camera : cameras) {
            boolean usable = camera.takesPhotos() && !camera.frameSizes().isEmpty();
            if (usable && (best == null || camera.facing().compareTo(best.facing()) < 0)) {
                best = camera;
            }
        }
        return best;
    }
}
