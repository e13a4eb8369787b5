package org.cellgauge.survey;

import org.cellgauge.statistics.Convergence;

/**
 * How the draws of a survey came about; immutable.
 *
 * @param convergence of the worst quantity
 * @param rHatMax largest R-hat
 * @param essBulkMin least effective number of draws of a mean
 * @param essTailMin least effective number of draws of a quantile
 * @param chains number of chains
 * @param draws of each chain
 * @param evaluations of the posterior by all chains
 * @param acceptance share of proposals that were taken
 * @param worstRatio of sampled to predicted deviation, of the quantity where they differ most
 */
public record SurveyRun(Convergence convergence, double rHatMax, double essBulkMin, double essTailMin, int chains,
        int draws, long evaluations, double acceptance, double worstRatio) {
    /**
     * Effective draws that 1000 evaluations gave, of the worst quantity.
     *
     * @return positive
     */
    public double essPerThousand() {
        return 1000 * Math.min(essBulkMin, essTailMin) / evaluations;
    }
}
