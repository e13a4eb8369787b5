package org.cellgauge.internal.pose;

import org.cellgauge.settings.LikelihoodModel;
import org.cellgauge.settings.ModelSettings;

/**
 * How far the image coordinates of a reference's corners, eight in one view, may be from where the pose puts them: the
 * covariance of their residuals, split by what causes it. In several views it is the joint covariance of all
 * coordinates of its block, in the order of {@link BlockLayout}.
 */
public interface ReferenceNoise {
    /**
     * The noise of a model.
     *
     * @param model how placement errors move corners
     * @param view the references
     * @param errors errors of their corners
     * @param noise the added noise to evaluate at: the u of {@link AddedNoise}
     * @return its covariances
     */
    static ReferenceNoise of(ModelSettings model, ReferenceView view, CornerErrors errors, double noise) {
        return model.likelihood() == LikelihoodModel.CORNER_CUBE ? new CornerCubeNoise(view, model.kappa())
                : new RigidMarkerNoise(view, errors, noise);
    }

    /**
     * Covariance of the residuals of one reference at a pose.
     *
     * @param state pose and intrinsics
     * @param marker index of the reference in its {@link Observations}
     * @param placementPx2 receives the part that comes from the placement of the reference, 8x8 in one view, row by
     *     row, px²
     * @param pixelPx2 receives the part, as large, that comes from corner noise, row by row, px²
     * @return false, with the outputs undefined, if a corner is not in front of the camera
     */
    boolean covariance(CameraState state, int marker, double[] placementPx2, double[] pixelPx2);

    /**
     * The added noise that it is evaluated at.
     *
     * @return the u of {@link AddedNoise}; 0 where the noise is stated
     */
    default double noise() {
        return 0;
    }

    /**
     * The same noise with its placement errors linearised elsewhere than at the references' nominal places.
     *
     * @param placed where the references are taken to stand
     * @return noise of that place; this one where it knows no rigid placement errors
     */
    default ReferenceNoise about(PlacedReferences placed) {
        return this;
    }

    /**
     * Whether placement errors are rigid, so that {@link #placementJacobian} is defined.
     *
     * @return false where the noise knows no such errors
     */
    default boolean hasRigidPlacement() {
        return false;
    }

    /**
     * Derivative of the projected corners of one reference by its placement error, where errors are linearised.
     *
     * @param state pose and intrinsics
     * @param marker index of the reference
     * @param out 8x6 in one view, row by row: (u, v) of each corner by (shift along world x, y, z in mm; rotation
     * vector
     *     in world axes, rad), px per mm and per rad
     * @return false, with the output undefined, if a corner is not in front of the camera
     * @throws UnsupportedOperationException where there are no rigid placement errors
     */
    default boolean placementJacobian(CameraState state, int marker, double[] out) {
        throw new UnsupportedOperationException("no rigid placement errors");
    }
}
