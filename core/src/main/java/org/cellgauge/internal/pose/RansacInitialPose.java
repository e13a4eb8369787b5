package org.cellgauge.internal.pose;

import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.jspecify.annotations.Nullable;

/** Consensus of single corners; a misplaced reference does not pull it. */
final class RansacInitialPose implements InitialPose {
    /** Corners of references placed to a few millimetres stay within this distance of the true projection, px. */
    private static final double THRESHOLD_PX = 5;
    /** The sampling is part of the estimator: the same corners always give the same pose. */
    private static final long SAMPLING_SEED = 4096;

    @Override
    public @Nullable RigidTransform estimate(ReferenceView view, PinholeCamera camera) {
        RigidTransform cameraFromSet = new TargetPnp().ransac(camera, view.points(), view.observed(), THRESHOLD_PX,
                SAMPLING_SEED);
        return cameraFromSet == null ? null : view.worldFromCamera(cameraFromSet);
    }
}
