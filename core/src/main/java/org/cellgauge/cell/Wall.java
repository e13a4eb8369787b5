package org.cellgauge.cell;

/**
 * An upright wall in the cell, along a line as seen from above: references may hang on it, and what lies behind it is
 * hidden; immutable.
 *
 * @param xFromMm world x of one end, mm
 * @param yFromMm world y of it
 * @param xToMm world x of the other end
 * @param yToMm world y of it
 * @param heightMm how far it reaches up from world z = 0, mm, positive
 */
public record Wall(double xFromMm, double yFromMm, double xToMm, double yToMm, double heightMm) {
    /**
     * A wall.
     *
     * @throws IllegalArgumentException if it has no height or no length
     */
    public Wall {
        if (!(heightMm > 0 && Math.hypot(xToMm - xFromMm, yToMm - yFromMm) > 0)) {
            throw new IllegalArgumentException("a wall needs a length and a height");
        }
    }

    /**
     * Whether it hides one point from another: whether the line between them goes through it.
     *
     * @param aMm a point, 3 values, mm
     * @param bMm another
     * @return false where one of them lies in its plane
     */
    public boolean hides(double[] aMm, double[] bMm) {
        double sideOfA = side(aMm);
        double sideOfB = side(bMm);
        if (!(sideOfA * sideOfB < 0)) {
            return false;
        }
        double along = sideOfA / (sideOfA - sideOfB);
        double x = aMm[0] + along * (bMm[0] - aMm[0]);
        double y = aMm[1] + along * (bMm[1] - aMm[1]);
        double z = aMm[2] + along * (bMm[2] - aMm[2]);
        double dx = xToMm - xFromMm;
        double dy = yToMm - yFromMm;
        double onWall = ((x - xFromMm) * dx + (y - yFromMm) * dy) / (dx * dx + dy * dy);
        return onWall >= 0 && onWall <= 1 && z >= 0 && z <= heightMm;
    }

    private double side(double[] mm) {
        return (mm[0] - xFromMm) * (yToMm - yFromMm) - (mm[1] - yFromMm) * (xToMm - xFromMm);
    }
}
