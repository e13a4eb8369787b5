package org.cellgauge.plan;

/**
 * A distance between the centres of two references that is measured, besides where each of them stands; immutable.
 *
 * @param first id of a reference
 * @param second id of another
 * @param stdMm standard deviation of the measurement, mm, positive
 */
public record MeasuredDistance(int first, int second, double stdMm) {
    /**
     * A distance.
     *
     * @throws IllegalArgumentException if it is one of a reference to itself, or the deviation is not positive
     */
    public MeasuredDistance {
        if (first == second || !(stdMm > 0)) {
            throw new IllegalArgumentException("no distance: " + first + " to " + second + ", " + stdMm + " mm");
        }
    }
}
