package org.cellgauge.vision;

/**
 * How far the edges of one marker seem to have moved into the dark, along their normals and all alike, as measured from
 * its inner edges: there dark and bright lie the other way round than along the outline, so that a black border that
 * looks thinner than the pattern has it tells the shift. Immutable.
 *
 * <p>What moves edges so is common to the markers of a photo (a tone curve that is not quite the one assumed, a
 * sharpening filter) or to prints of one size (ink that spreads moves them the other way). Corners of a
 * {@link MarkerObservation} are where the outline is seen: <em>not</em> corrected by this shift. Measured corners and
 * measured shift share errors, so their covariance is given, too.
 */
public final class EdgeShift {
    private final double shiftPx;
    private final double variancePx2;
    private final double[] covarianceWithCornersPx2;

    /**
     * A measured shift.
     *
     * @param shiftPx shift of the edges, px, positive into the dark: the black square looks smaller than it is
     * @param variancePx2 variance of its error, px², positive
     * @param covarianceWithCornersPx2 covariance of its error with the errors of the 8 corner coordinates, px²; copied
     * @throws IllegalArgumentException if a value is not finite, the variance not positive or there are not 8
     */
    public EdgeShift(double shiftPx, double variancePx2, double[] covarianceWithCornersPx2) {
        if (!Double.isFinite(shiftPx) || !(variancePx2 > 0) || Double.isInfinite(variancePx2)) {
            throw new IllegalArgumentException("no edge shift: " + shiftPx + " px, variance " + variancePx2);
        }
        if (covarianceWithCornersPx2.length != 8) {
            throw new IllegalArgumentException("4 corners take 8 values, not " + covarianceWithCornersPx2.length);
        }
        for (double v : covarianceWithCornersPx2) {
            if (!Double.isFinite(v)) {
                throw new IllegalArgumentException("a covariance is not finite");
            }
        }
        this.shiftPx = shiftPx;
        this.variancePx2 = variancePx2;
        this.covarianceWithCornersPx2 = covarianceWithCornersPx2.clone();
    }

    /**
     * The shift.
     *
     * @return px, positive into the dark
     */
    public double shiftPx() {
        return shiftPx;
    }

    /**
     * Variance of its error.
     *
     * @return px², positive
     */
    public double variancePx2() {
        return variancePx2;
    }

    /**
     * Covariance of its error with the errors of the corner coordinates.
     *
     * @return a copy of 8 values, px²
     */
    public double[] covarianceWithCornersPx2() {
        return covarianceWithCornersPx2.clone();
    }

    /**
     * How the corners of a marker move when ink has spread by 1 mm on the paper on all sides, by the homography from
     * the paper to the image (the lens taken as straight over so small a distance).
     *
     * @param cornersPx 8 values: u, v of the four corners, in the order of the outline, px
     * @param sizeMm side of the printed square, mm, positive
     * @return 8 values, px per mm
     */
    public static double[] byInk(double[] cornersPx, double sizeMm) {
        double[] h = new double[8];
        double[] out = new double[8];
        if (!Homography.ofUnitSquare(cornersPx, h)) {
            return out;
        }
        for (int i = 0; i < 4; i++) {
            double x = i == 1 || i == 2 ? 1 : 0;
            double y = i >= 2 ? 1 : 0;
            double w = h[6] * x + h[7] * y + 1;
            // outwards by 1 mm in either direction
            double dx = (2 * x - 1) / sizeMm;
            double dy = (2 * y - 1) / sizeMm;
            double dw = h[6] * dx + h[7] * dy;
            out[2 * i] = (h[0] * dx + h[1] * dy - cornersPx[2 * i] * dw) / w;
            out[2 * i + 1] = (h[3] * dx + h[4] * dy - cornersPx[2 * i + 1] * dw) / w;
        }
        return out;
    }

    /**
     * How the corners of a marker move when all its sides move by 1 px along their normals, inwards.
     *
     * @param cornersPx 8 values: u, v of the four corners, in either sense of turning, px
     * @return 8 values, px per px
     */
    public static double[] ofCorners(double[] cornersPx) {
        // inward normals of the sides from corner i to the next: the side's line is n.x = c, moved to n.x = c + 1
        double[] nx = new double[4];
        double[] ny = new double[4];
        double area = 0;
        for (int i = 0; i < 4; i++) {
            int j = (i + 1) % 4;
            double dx = cornersPx[2 * j] - cornersPx[2 * i];
            double dy = cornersPx[2 * j + 1] - cornersPx[2 * i + 1];
            double length = Math.hypot(dx, dy);
            nx[i] = -dy / length;
            ny[i] = dx / length;
            area += cornersPx[2 * i] * cornersPx[2 * j + 1] - cornersPx[2 * j] * cornersPx[2 * i + 1];
        }
        double sense = area > 0 ? 1 : -1;
        double[] out = new double[8];
        for (int i = 0; i < 4; i++) {
            int before = (i + 3) % 4;
            // corner i is where the sides before and after it meet
            double determinant = nx[before] * ny[i] - nx[i] * ny[before];
            out[2 * i] = sense * (ny[i] - ny[before]) / determinant;
            out[2 * i + 1] = sense * (nx[before] - nx[i]) / determinant;
        }
        return out;
    }
}
