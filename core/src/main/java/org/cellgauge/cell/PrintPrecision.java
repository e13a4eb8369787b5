package org.cellgauge.cell;

/**
 * How precisely the markers of a cell are printed and mounted.
 *
 * <p>Sizes are off alike for all markers of one size, as prints of one file on one printer are; a corner is off the
 * plane of its marker on its own.
 *
 * @param sizeStdMm standard deviation of the outer edge, common to the markers of one size, mm, not negative; 0: exact
 * @param flatnessMm standard deviation of each corner off the plane of its marker, mm, not negative; 0: flat
 * @param printGainStdMm standard deviation of how far ink spreads at every edge, common to the markers of one size, mm,
 *     not negative
 */
public record PrintPrecision(double sizeStdMm, double flatnessMm, double printGainStdMm) {
    /** Markers of exactly their size and flat; ink may spread by 0.05 mm. */
    public static final PrintPrecision USUAL = new PrintPrecision(0, 0, 0.05);

    /**
     * A precision of prints.
     *
     * @throws IllegalArgumentException if a deviation is negative or not finite
     */
    public PrintPrecision {
        for (double std : new double[] {sizeStdMm, flatnessMm, printGainStdMm}) {
            if (!(std >= 0) || Double.isInfinite(std)) {
                throw new IllegalArgumentException("a deviation of prints must not be negative, not " + std);
            }
        }
    }
}
