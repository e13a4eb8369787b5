package org.cellgauge.desktop.reproduce;

import org.cellgauge.settings.CheckSettings;

/**
 * How much is done for each figure.
 *
 * @param seeds chains of the thesis for each experiment, a multiple of four
 * @param precision Monte Carlo error of deviations, relative to them, at which converged chains stop
 * @param cells simulated cells where errors are held against what is stated of them
 */
record Effort(int seeds, double precision, int cells) {
    /** As the page in docs has it. */
    static final Effort FULL = new Effort(20, 0.02, 200);
    /** For a look. */
    static final Effort QUICK = new Effort(4, 0.2, 40);

    /** Each chain's, whatever the precision then: two references with the focal length explored take many more. */
    private static final int QUICK_ITERATIONS = 8000;

    /** Whether it is less than what the page in docs has: fewer layouts, starts and changes, exact corners. */
    boolean isQuick() {
        return seeds < FULL.seeds();
    }

    /** Chains that run until they are precise enough. */
    CheckSettings.Builder untilPrecise() {
        CheckSettings.Builder settings = CheckSettings.builder().targetMcseStdRel(precision).threads(1);
        return isQuick() ? settings.maxIterations(QUICK_ITERATIONS) : settings;
    }
}
