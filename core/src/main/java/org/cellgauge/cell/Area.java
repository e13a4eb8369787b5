package org.cellgauge.cell;

/**
 * A rectangle in the cell as seen from above; immutable.
 *
 * @param xLowMm smallest world x, mm
 * @param yLowMm smallest world y, mm
 * @param xHighMm largest world x, mm
 * @param yHighMm largest world y, mm
 */
public record Area(double xLowMm, double yLowMm, double xHighMm, double yHighMm) {
    /**
     * The rectangle with two corners that are opposite each other.
     *
     * @param mm x and y of one, x and y of the other
     * @return the area
     */
    public static Area ofCorners(double[] mm) {
        return new Area(Math.min(mm[0], mm[2]), Math.min(mm[1], mm[3]), Math.max(mm[0], mm[2]),
                Math.max(mm[1], mm[3]));
    }

    /**
     * Whether a point lies in it, at whatever height.
     *
     * @param x world x, mm
     * @param y world y, mm
     * @return true also on its border
     */
    public boolean has(double x, double y) {
        return x >= xLowMm && x <= xHighMm && y >= yLowMm && y <= yHighMm;
    }
}
