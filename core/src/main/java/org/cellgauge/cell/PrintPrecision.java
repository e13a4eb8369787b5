package org.cellgauge.cell;

/**
 * How precisely the markers of a cell are printed and mounted; immutable.
 *
 * <p>Sizes are off alike for all markers of one size, as prints of one file on one printer are; a corner is off the
 * plane of its marker on its own.
 */
public final class PrintPrecision {
    /** Markers of exactly their size and flat; ink may spread by 0.05 mm. */
    public static final PrintPrecision USUAL = new PrintPrecision(0, 0, 0.05);

    private final double sizeStdMm;
    private final double flatnessMm;
    private final double printGainStdMm;

    /**
     * A precision of prints.
     *
     * @param sizeStdMm standard deviation of the outer edge, common to the markers of one size, mm, not negative
     * @param flatnessMm standard deviation of each corner off the plane of its marker, mm, not negative
     * @param printGainStdMm standard deviation of how far ink spreads at every edge, common to the markers of one
     *     size, mm, not negative
     * @throws IllegalArgumentException if a deviation is negative or not finite
     */
    public PrintPrecision(double sizeStdMm, double flatnessMm, double printGainStdMm) {
        for (double std : new double[] {sizeStdMm, flatnessMm, printGainStdMm}) {
            if (!(std >= 0) || Double.isInfinite(std)) {
                throw new IllegalArgumentException("a deviation of prints must not be negative, not " + std);
            }
        }
        this.sizeStdMm = sizeStdMm;
        this.flatnessMm = flatnessMm;
        this.printGainStdMm = printGainStdMm;
    }

    /**
     * Standard deviation of the outer edge, common to the markers of one size.
     *
     * @return mm, not negative; 0: exact
     */
    public double sizeStdMm() {
        return sizeStdMm;
    }

    /**
     * Standard deviation of each corner off the plane of its marker.
     *
     * @return mm, not negative; 0: flat
     */
    public double flatnessMm() {
        return flatnessMm;
    }

    /**
     * Standard deviation of how far ink spreads at every edge, common to the markers of one size.
     *
     * @return mm, not negative
     */
    public double printGainStdMm() {
        return printGainStdMm;
    }
}
