package org.cellgauge.internal.posterior;

import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.pose.PosePrior;
import org.cellgauge.internal.sampling.LogDensity;
import org.cellgauge.settings.RotationPrior;

/** Posterior of the camera pose and unknown intrinsics in the coordinates of a chart. Not thread-safe. */
public final class CameraPosterior implements LogDensity {
    private final CameraChart chart;
    private final CameraLikelihood likelihood;
    private final RotationPrior rotationPrior;
    private final IntrinsicsPrior intrinsicsPrior;
    private final PosePrior posePrior;
    private final SharedPrior sharedPrior;
    private final CameraState state = new CameraState();
    private final double[] scratch9 = new double[9];
    private final double[] scratch3 = new double[3];

    /**
     * A posterior.
     *
     * @param chart coordinates
     * @param likelihood of the references' corners
     * @param rotationPrior prior over rotations; position is flat
     * @param intrinsicsPrior prior of the unknown intrinsics
     * @param posePrior weak prior of the pose on top, or null
     */
    public CameraPosterior(CameraChart chart, CameraLikelihood likelihood, RotationPrior rotationPrior,
            IntrinsicsPrior intrinsicsPrior, PosePrior posePrior) {
        this(chart, likelihood, rotationPrior, intrinsicsPrior, posePrior, null);
    }

    /**
     * A posterior with unknowns that markers share.
     *
     * @param chart coordinates
     * @param likelihood of the references' corners
     * @param rotationPrior prior over rotations; position is flat
     * @param intrinsicsPrior prior of the unknown intrinsics
     * @param posePrior weak prior of the pose on top, or null
     * @param sharedPrior prior of what markers share, or null where they share nothing
     */
    public CameraPosterior(CameraChart chart, CameraLikelihood likelihood, RotationPrior rotationPrior,
            IntrinsicsPrior intrinsicsPrior, PosePrior posePrior, SharedPrior sharedPrior) {
        this.sharedPrior = sharedPrior;
        this.chart = chart;
        this.likelihood = likelihood;
        this.rotationPrior = rotationPrior;
        this.intrinsicsPrior = intrinsicsPrior;
        this.posePrior = posePrior;
    }

    @Override
    public int dimension() {
        return chart.dimension();
    }

    @Override
    public double at(double[] x) {
        double prior = chart.logMeasure(x);
        if (!(prior > Double.NEGATIVE_INFINITY)) {
            return Double.NEGATIVE_INFINITY;
        }
        chart.decode(x, state);
        prior += logDensity(rotationPrior, state) + intrinsicsPrior.logDensity(state.intrinsics);
        if (sharedPrior != null) {
            prior += sharedPrior.logDensity(state);
        }
        if (posePrior != null) {
            prior += posePrior.logDensity(state, scratch9, scratch3);
        }
        if (!(prior > Double.NEGATIVE_INFINITY)) {
            return Double.NEGATIVE_INFINITY;
        }
        double value = prior + likelihood.at(state);
        return Double.isNaN(value) ? Double.NEGATIVE_INFINITY : value;
    }

    /**
     * Log density of a prior over rotations, by the uniform measure over them.
     *
     * @param prior the prior
     * @param state pose of the references in the camera frame
     * @return up to a constant
     */
    public static double logDensity(RotationPrior prior, CameraState state) {
        if (prior == RotationPrior.UNIFORM) {
            return 0;
        }
        // sin(theta) is minus the element (3, 1) of worldFromCamera, which is (1, 3) of its transpose
        double sine = state.rotation[2];
        return -0.5 * Math.log(Math.max(1 - sine * sine, Double.MIN_NORMAL));
    }

    /**
     * The chart of the coordinates.
     *
     * @return shared with this posterior: not thread-safe
     */
    public CameraChart chart() {
        return chart;
    }
}
