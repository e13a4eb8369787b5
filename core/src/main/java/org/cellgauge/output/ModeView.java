package org.cellgauge.output;

/** One of several poses that explain a photo, with the share of the posterior it holds; immutable. */
public final class ModeView {
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
    public boolean equals(Object other) {
        return other instanceof ModeView && Double.compare(weight, ((ModeView) other).weight) == 0
                && pose.equals(((ModeView) other).pose);
    }

    @Override
    public int hashCode() {
        return 31 * Double.hashCode(weight) + pose.hashCode();
    }
}
