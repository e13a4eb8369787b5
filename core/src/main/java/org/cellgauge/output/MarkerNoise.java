package org.cellgauge.output;

import org.jspecify.annotations.Nullable;

/** How noisy the corners of one marker are; immutable. */
public final class MarkerNoise extends Value {
    private final int id;
    private final double stdPx;
    private final double timesStated;
    private final double setAsideTimes;

    MarkerNoise(int id, double stdPx, double timesStated, double setAsideTimes) {
        this.id = id;
        this.stdPx = Figures.finite(stdPx);
        this.timesStated = Figures.finite(timesStated);
        this.setAsideTimes = Figures.finite(setAsideTimes);
    }

    /**
     * The marker.
     *
     * @return its id
     */
    public int id() {
        return id;
    }

    /**
     * Root of the mean variance of its corner coordinates, added noise and inflation included.
     *
     * @return px
     */
    public double stdPx() {
        return stdPx;
    }

    /**
     * How many times noisier than stated its corners are, by how square they are.
     *
     * @return NaN where that is not tested
     */
    public double timesStated() {
        return timesStated;
    }

    /**
     * How many times worse than those of the others its corners fit a square.
     *
     * @return NaN where it is not set aside
     */
    public double setAsideTimes() {
        return setAsideTimes;
    }

    @Override
    @Nullable Object[] figures() {
        return new @Nullable Object[] {id, stdPx, timesStated, setAsideTimes};
    }
}
