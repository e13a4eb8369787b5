package org.cellgauge.output;

import org.jspecify.annotations.Nullable;

/** One of several poses that explain a photo, with the share of the posterior it holds; immutable. */
public final class ModeView extends Value {
    private final double weight;
    private final PoseView pose;

    ModeView(double weight, PoseView pose) {
        this.weight = Figures.finite(weight);
        this.pose = pose;
    }

    /**
     * Share of the posterior.
     *
     * @return 0 to 1
     */
    public double weight() {
        return weight;
    }

    /**
     * The pose near this mode.
     *
     * @return its mean and covariance
     */
    public PoseView pose() {
        return pose;
    }

    @Override
    @Nullable Object[] figures() {
        return new @Nullable Object[] {weight, pose};
    }
}
