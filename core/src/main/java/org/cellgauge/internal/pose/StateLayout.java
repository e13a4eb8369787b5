package org.cellgauge.internal.pose;

/**
 * Which places of a vector of unknowns belong to what: a step, a gradient, the rows and columns of an information or of
 * a covariance; immutable.
 *
 * <p>Order: for every view its camera's pose (dp x, y, z in mm; w x, y, z in rad); the unknown intrinsics, in the order
 * of {@link IntrinsicsPrior}; the unknowns that markers share, of {@link CornerErrors}; and, in the coordinates of
 * chains, the added noise where it is unknown.
 */
public final class StateLayout {
    /** Unknowns of a pose. */
    public static final int POSE = 6;

    private final int views;
    private final int intrinsics;
    private final int shared;
    private final boolean noiseUnknown;

    private StateLayout(int views, int intrinsics, int shared, boolean noiseUnknown) {
        this.views = views;
        this.intrinsics = intrinsics;
        this.shared = shared;
        this.noiseUnknown = noiseUnknown;
    }

    /**
     * The unknowns of a fit.
     *
     * @param views number of views, at least 1
     * @param intrinsics unknown intrinsics
     * @param shared number of unknowns that markers share
     * @return the layout
     */
    public static StateLayout of(int views, IntrinsicsPrior intrinsics, int shared) {
        return new StateLayout(views, intrinsics.count(), shared, false);
    }

    /**
     * The same with the added noise as the last unknown.
     *
     * @param unknown whether it is one
     * @return the layout
     */
    public StateLayout withNoise(boolean unknown) {
        return new StateLayout(views, intrinsics, shared, unknown);
    }

    /**
     * Number of views.
     *
     * @return at least 1
     */
    public int views() {
        return views;
    }

    /**
     * Where the pose of a view begins.
     *
     * @param view 0 to views - 1
     * @return index of the first of its {@value #POSE} unknowns
     */
    public int pose(int view) {
        return POSE * view;
    }

    /**
     * Number of unknowns of all poses.
     *
     * @return {@value #POSE} per view
     */
    public int poses() {
        return POSE * views;
    }

    /**
     * Where unknown intrinsics begin.
     *
     * @return index of the first
     */
    public int intrinsics() {
        return poses();
    }

    /**
     * Number of unknown intrinsics.
     *
     * @return 0 where all are known
     */
    public int intrinsicsCount() {
        return intrinsics;
    }

    /**
     * Where unknowns that markers share begin.
     *
     * @return index of the first
     */
    public int shared() {
        return poses() + intrinsics;
    }

    /**
     * Number of unknowns that markers share.
     *
     * @return 0 where there are none
     */
    public int sharedCount() {
        return shared;
    }

    /**
     * Where the added noise is.
     *
     * @return its index; that past the end where it is no unknown
     */
    public int noise() {
        return shared() + shared;
    }

    /**
     * Whether the added noise is an unknown.
     *
     * @return true if it is the last
     */
    public boolean isNoiseUnknown() {
        return noiseUnknown;
    }

    /**
     * Number of all unknowns.
     *
     * @return length of the vector
     */
    public int size() {
        return noise() + (noiseUnknown ? 1 : 0);
    }
}
