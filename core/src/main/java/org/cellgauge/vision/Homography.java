package org.cellgauge.vision;

/** The homography from the unit square to a quadrilateral. */
final class Homography {
    private Homography() {
    }

    /**
     * The homography from the unit square, y down, in closed form (P. Heckbert, "Fundamentals of Texture Mapping and
     * Image Warping", 1989, section 2.2.3).
     *
     * @param corners 8 values: the images of (0, 0), (1, 0), (1, 1), (0, 1)
     * @param out receives 8 values: the matrix row by row, its last element being 1
     * @return false where three corners lie on a line
     */
    static boolean ofUnitSquare(double[] corners, double[] out) {
        double dx1 = corners[2] - corners[4];
        double dy1 = corners[3] - corners[5];
        double dx2 = corners[6] - corners[4];
        double dy2 = corners[7] - corners[5];
        double sx = corners[0] - corners[2] + corners[4] - corners[6];
        double sy = corners[1] - corners[3] + corners[5] - corners[7];
        double determinant = dx1 * dy2 - dx2 * dy1;
        if (determinant == 0) {
            return false;
        }
        double g = (sx * dy2 - dx2 * sy) / determinant;
        double h = (dx1 * sy - sx * dy1) / determinant;
        out[0] = corners[2] - corners[0] + g * corners[2];
        out[1] = corners[6] - corners[0] + h * corners[6];
        out[2] = corners[0];
        out[3] = corners[3] - corners[1] + g * corners[3];
        out[4] = corners[7] - corners[1] + h * corners[7];
        out[5] = corners[1];
        out[6] = g;
        out[7] = h;
        return true;
    }
}
