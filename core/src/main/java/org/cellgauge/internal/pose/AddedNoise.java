package org.cellgauge.internal.pose;

/**
 * Corner noise that nobody has stated: a variance {@code e(u) = scale exp(rate u)} common to all coordinates of all
 * markers of a photo, added to what the detector says of each marker, with u standard normal beforehand; immutable.
 *
 * <p>Real corners are worse than their grey values say: prints are imprecise, lenses are not the model. The added
 * variance is lognormal a priori: mostly little beside what the fits say, with a tail that reaches many times that.
 */
public final class AddedNoise {
    /** Step of the grid that whitening matrices are made on. */
    static final double STEP = 0.05;
    private static final double LOWEST = -4;
    private static final double HIGHEST = 4.5;
    /** Number of nodes of that grid. */
    public static final int NODES = (int) Math.round((HIGHEST - LOWEST) / STEP) + 1;
    /** Corners of which nothing is known: 0.15 px, a factor of 3.7 up or down being one deviation. */
    private static final double UNKNOWN_STD_PX = 0.15;
    private static final double UNKNOWN_LOG_STD = 1.3;
    /** What is added to the variance of fits in the median of the prior, as a share of it. */
    private static final double SHARE_OF_FIT = 0.02;
    private static final double FIT_LOG_STD = 4;

    private final double scalePx2;
    private final double rate;
    /** By node of the grid. */
    private final double[] variancesPx2 = new double[NODES];

    private AddedNoise(double scalePx2, double rate) {
        this.scalePx2 = scalePx2;
        this.rate = rate;
        for (int node = 0; node < NODES; node++) {
            variancesPx2[node] = variancePx2(atNode(node));
        }
    }

    /**
     * For corners of which nothing is known: all of their variance.
     *
     * @return the prior
     */
    public static AddedNoise toNothing() {
        return new AddedNoise(UNKNOWN_STD_PX * UNKNOWN_STD_PX, 2 * UNKNOWN_LOG_STD);
    }

    /**
     * For corners with covariances.
     *
     * @param variancePx2 usual variance of a coordinate by these, px², positive
     * @return the prior
     */
    public static AddedNoise toFits(double variancePx2) {
        return new AddedNoise(SHARE_OF_FIT * variancePx2, FIT_LOG_STD);
    }

    /**
     * Whether it is all of the noise there is.
     *
     * @return true for {@link #toNothing()}
     */
    public boolean isAll() {
        return rate == 2 * UNKNOWN_LOG_STD;
    }

    /**
     * The added variance.
     *
     * @param u standard normal beforehand
     * @return px², positive
     */
    public double variancePx2(double u) {
        return scalePx2 * Math.exp(rate * u);
    }

    /** The same at a node of the grid. */
    double variancePx2AtNode(int node) {
        return variancesPx2[node];
    }

    /**
     * The u of an added variance.
     *
     * @param variancePx2 px², positive
     * @return its u
     */
    public double ofVariance(double variancePx2) {
        return Math.log(variancePx2 / scalePx2) / rate;
    }

    /**
     * The node of the grid that is nearest.
     *
     * @param u any value
     * @return 0 to {@link #NODES} - 1
     */
    public static int node(double u) {
        double at = Math.rint((u - LOWEST) / STEP);
        return at > 0 ? (int) Math.min(at, NODES - 1) : 0;
    }

    /**
     * The value of a node.
     *
     * @param node 0 to {@link #NODES} - 1
     * @return u
     */
    public static double atNode(int node) {
        return LOWEST + STEP * node;
    }
}
