package org.cellgauge.internal.validation;

import java.util.Collections;
import java.util.List;

/** What a validation found; immutable. */
public final class ValidationResult {
    private final int simulations;
    private final int notConverged;
    private final int refused;
    private final int ambiguous;
    private final int falseAlarms;
    private final int noiseMisfits;
    private final int referenceMisfits;
    private final double weightShareMin;
    private final List<RegionCoverage> regions;
    private final List<RankedQuantity> quantities;

    ValidationResult(int simulations, int notConverged, int refused, int ambiguous, int falseAlarms,
            int noiseMisfits, int referenceMisfits, double weightShareMin, List<RegionCoverage> regions,
            List<RankedQuantity> quantities) {
        this.simulations = simulations;
        this.notConverged = notConverged;
        this.refused = refused;
        this.ambiguous = ambiguous;
        this.falseAlarms = falseAlarms;
        this.noiseMisfits = noiseMisfits;
        this.referenceMisfits = referenceMisfits;
        this.weightShareMin = weightShareMin;
        this.regions = Collections.unmodifiableList(regions);
        this.quantities = Collections.unmodifiableList(quantities);
    }

    /**
     * Number of simulated cells.
     *
     * @return at least 1
     */
    public int simulations() {
        return simulations;
    }

    /**
     * Cells whose chains have not converged: their checks state no region, so none is counted.
     *
     * @return count
     */
    public int notConverged() {
        return notConverged;
    }

    /**
     * Cells whose corners the check refused as of no pose at all: they state no region either.
     *
     * @return count
     */
    public int refused() {
        return refused;
    }

    /**
     * Cells whose check found a pose ambiguous. Their overall mean and covariance, and the draws, are of both poses;
     * they are counted like all others.
     *
     * @return count
     */
    public int ambiguous() {
        return ambiguous;
    }

    /**
     * Cells whose check named a reference as misplaced, or a cause, although all was as the cell file states.
     *
     * @return count, refused cells left out
     */
    public int falseAlarms() {
        return falseAlarms;
    }

    /**
     * Cells whose corners do not fit the stated noise, which is no false alarm where other noise was simulated.
     *
     * @return count, refused cells left out; honest: at most 2 in 1000
     */
    public int noiseMisfits() {
        return noiseMisfits;
    }

    /**
     * Cells whose references together do not fit as stated, but for those called misplaced.
     *
     * @return count, refused cells left out; honest: at most 1 in 1000
     */
    public int referenceMisfits() {
        return referenceMisfits;
    }

    /**
     * Smallest effective share of draws left after weighting them to the prior of the truth, over all cells and parts:
     * with a very small share of the draws ranks say little.
     *
     * @return 0 to 1; 1 for truths without spread; NaN if no check stated a figure
     */
    public double weightShareMin() {
        return weightShareMin;
    }

    /**
     * Coverage by region: the camera's pose, then of every object its position, pose and, if it has one, its grip.
     *
     * @return unmodifiable
     */
    public List<RegionCoverage> regions() {
        return regions;
    }

    /**
     * Ranks by quantity, part by part.
     *
     * @return unmodifiable
     */
    public List<RankedQuantity> quantities() {
        return quantities;
    }

    /**
     * Whether every kind of region of a probability held the truth as often as it claims, within chance.
     *
     * @param probability in (0, 1)
     * @return true if all counts lie in their bands
     */
    public boolean covers(double probability) {
        for (RegionCoverage region : regions) {
            if (!region.covers(probability)) {
                return false;
            }
        }
        return true;
    }

    /**
     * Share of the simulations of which no figure came.
     *
     * @return (not converged + refused) / simulations
     */
    public double withoutFigure() {
        return (double) (notConverged + refused) / simulations;
    }

    /**
     * Smallest p-value of all rank histograms times their number (Bonferroni): the p-value of all together.
     *
     * @return at most 1; NaN if no check stated a figure
     */
    public double rankPValue() {
        double least = Double.NaN;
        for (RankedQuantity q : quantities) {
            double p = q.ranks().pValue();
            least = Double.isNaN(least) ? p : Math.min(least, p);
        }
        return Math.min(1, least * quantities.size());
    }
}
