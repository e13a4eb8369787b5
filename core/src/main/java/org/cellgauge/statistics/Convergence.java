package org.cellgauge.statistics;

/**
 * The word that stands beside every figure computed from chains.
 *
 * <p>Thresholds of Vehtari, Gelman, Simpson, Carpenter &amp; B&uuml;rkner 2021, "Rank-normalization, folding, and
 * localization: an improved R-hat for assessing convergence of MCMC", Bayesian Analysis 16(2), section 4: R-hat below
 * 1.01, and effective sample sizes of at least 400 over four chains. The wider bound of 1.05 for doubtful results is
 * this library's. The constants are ordered from best to worst.
 */
public enum Convergence {
    /** R-hat below 1.01, bulk and tail effective sample size at least 400. */
    CONVERGED,
    /** R-hat at most 1.05, but a condition of {@link #CONVERGED} is missed. */
    DOUBTFUL,
    /** R-hat above 1.05, or a diagnostic that does not exist. */
    NOT_CONVERGED;

    /** Convergence requires an R-hat below this. */
    public static final double R_HAT_CONVERGED = 1.01;

    /** Results up to this R-hat, inclusive, are doubtful; above, not converged. */
    public static final double R_HAT_DOUBTFUL = 1.05;

    /** Convergence requires bulk and tail effective sample sizes of at least this, all chains together. */
    public static final double ESS_CONVERGED = 400;

    /**
     * Judges the diagnostics of one parameter.
     *
     * @param rHat larger of bulk and folded R-hat; NaN where it does not exist
     * @param essBulk bulk effective sample size; NaN where it does not exist
     * @param essTail tail effective sample size; NaN where it does not exist
     * @return the verdict; {@link #NOT_CONVERGED} if any of the three is NaN
     */
    public static Convergence of(double rHat, double essBulk, double essTail) {
        if (Double.isNaN(rHat) || Double.isNaN(essBulk) || Double.isNaN(essTail) || rHat > R_HAT_DOUBTFUL) {
            return NOT_CONVERGED;
        }
        return rHat < R_HAT_CONVERGED && essBulk >= ESS_CONVERGED && essTail >= ESS_CONVERGED ? CONVERGED : DOUBTFUL;
    }

    /**
     * The verdict over two parameters: a set of chains is as good as its worst parameter.
     *
     * @param other verdict on another parameter
     * @return the worse of the two
     */
    public Convergence worse(Convergence other) {
        return compareTo(other) >= 0 ? this : other;
    }
}
