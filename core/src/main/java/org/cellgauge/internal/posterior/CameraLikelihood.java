package org.cellgauge.internal.posterior;

import org.cellgauge.internal.pose.CameraState;

/** Log likelihood of the references' corners given where the references stand before the camera. */
public interface CameraLikelihood {
    /**
     * The log likelihood, up to a constant.
     *
     * @param state pose of the references in the camera frame and intrinsics; not changed
     * @return finite, or -infinity where a corner is not in front of the camera
     */
    double at(CameraState state);
}
