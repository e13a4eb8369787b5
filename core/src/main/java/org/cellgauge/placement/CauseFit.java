package org.cellgauge.placement;

import java.util.List;

/**
 * What one photo says of one cause that moves the corners of all references, whether or not it is named, and how well
 * it would show; immutable.
 */
public final class CauseFit {
    private final Explanation explanation;
    private final double statistic;
    private final double limit;
    private final double apartStd;

    CauseFit(Explanation explanation, double statistic, double limit, double apartStd) {
        this.explanation = explanation;
        this.statistic = statistic;
        this.limit = limit;
        this.apartStd = apartStd;
    }

    /**
     * The cause.
     *
     * @return one that has a size
     */
    public Cause cause() {
        return explanation.cause();
    }

    /**
     * The references that it is about.
     *
     * @return marker ids; empty for all
     */
    public List<Integer> references() {
        return explanation.references();
    }

    /**
     * The world axis that it is about.
     *
     * @return 0, 1, 2 for x, y, z; -1 for none
     */
    public int axis() {
        return explanation.axis();
    }

    /**
     * The size that fits best if this cause alone is at work.
     *
     * @return as {@link Explanation#size()}
     */
    public double[] size() {
        return explanation.size();
    }

    /**
     * Standard deviation of that size.
     *
     * @return in its unit
     */
    public double std() {
        return explanation.std();
    }

    /**
     * The same if any one other cause, or shift or turn of one reference, may be at work besides: of a size of several
     * of these the photo tells what it is.
     *
     * @return at least {@link #std()}; infinite where something else looks just like it
     */
    public double apartStd() {
        return apartStd;
    }

    /**
     * The statistic of its test.
     *
     * @return standard normal if the cell is as stated
     */
    public double statistic() {
        return statistic;
    }

    /**
     * The size of the statistic that raises an alarm.
     *
     * @return the limit
     */
    public double limit() {
        return limit;
    }
}
