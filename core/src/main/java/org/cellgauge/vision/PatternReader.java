package org.cellgauge.vision;

import org.cellgauge.geometry.Lens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.TangentPlane;

/**
 * Reads the cells of a marker again, once its corners, grey values and blur are known to fractions.
 *
 * <p>A cell of a small or blurred marker is as grey as its neighbours make it: a fixed threshold misreads a white cell
 * among black ones, and a family without a checksum then yields another marker. So the reading is compared with what it
 * would look like: each cell's expected grey, blurred as the marker's edges are. A cell is wrong when its grey is
 * nearer to what it would be after changing it alone. Wrong cells are changed until none is wrong. Not thread-safe.
 */
final class PatternReader {
    private static final int MAX_ROUNDS = 6;
    /** Variance that reading adds to the blur: the pixel's own square and the interpolation between pixels. */
    private static final double READING_VARIANCE_PX2 = 1.0 / 12 + 1.0 / 6;
    private static final int POINTS = 3;
    private static final double POINT_SPACING = 0.15;

    private final Lens lens;
    private final double[] intrinsics;
    /** Where the marker is looked at under a wide lens; null for others. */
    private final TangentPlane plane;
    private final MarkerGrid grid;
    private final int bands;
    private final double[] level;
    private final double[] weightX;
    private final double[] weightY;
    private final double[] outsideX;
    private final double[] outsideY;
    private final double[] homography = new double[8];
    private final double[] ray = new double[3];
    private final double[] uv = new double[2];
    private final double[] ideal = new double[8];

    /**
     * A reader.
     *
     * @param camera camera of the images
     * @param grid lattice of the markers
     */
    PatternReader(PinholeCamera camera, MarkerGrid grid) {
        this.lens = camera.lens();
        this.intrinsics = camera.intrinsics();
        this.plane = lens.isWide() ? new TangentPlane(camera) : null;
        this.grid = grid;
        this.bands = grid.bands();
        this.level = new double[bands * bands];
        this.weightX = new double[bands * bands];
        this.weightY = new double[bands * bands];
        this.outsideX = new double[bands];
        this.outsideY = new double[bands];
    }

    /**
     * Reads a marker.
     *
     * @param image the image
     * @param cornersPx 8 values, distorted px, in the order of the pattern's top-left, top-right, bottom-right,
     *     bottom-left
     * @param scale tone curve: blur mixes light
     * @param darkGrey grey value of its black
     * @param brightGrey grey value of its white, above its black
     * @param blurPx optical blur of its edges, standard deviation
     * @param white the reading to start from, row by row, true for white; replaced by the better one
     * @return whether the reading settled with no cell wrong
     */
    boolean read(GreyImage image, double[] cornersPx, GreyScale scale, double darkGrey, double brightGrey,
            double blurPx, boolean[] white) {
        if (!setHomography(cornersPx)) {
            return false;
        }
        sample(image, scale, darkGrey, brightGrey);
        double blur = Math.sqrt(blurPx * blurPx + READING_VARIANCE_PX2);
        weights(blur * grid.cells() / meanLength(cornersPx, 0, 1, 3, 2), weightX, outsideX);
        weights(blur * grid.cells() / meanLength(cornersPx, 0, 3, 1, 2), weightY, outsideY);
        for (int round = 0; round < MAX_ROUNDS; round++) {
            int worst = -1;
            double worstExcess = 0;
            for (int row = 0; row < bands; row++) {
                for (int column = 0; column < bands; column++) {
                    int cell = row * bands + column;
                    double ownShare = weightY[row * bands + row] * weightX[column * bands + column];
                    double off = level[cell] - expected(white, row, column);
                    double excess = (white[cell] ? -off : off) / ownShare - 0.5;
                    if (excess > worstExcess) {
                        worstExcess = excess;
                        worst = cell;
                    }
                }
            }
            if (worst < 0) {
                return true;
            }
            // one at a time, the worst first: changing a cell explains part of what its neighbours seemed to lack
            white[worst] = !white[worst];
        }
        return false;
    }

    private double expected(boolean[] white, int row, int column) {
        double sum = 0;
        for (int r = 0; r < bands; r++) {
            double inRow = outsideX[column];
            for (int c = 0; c < bands; c++) {
                if (white[r * bands + c]) {
                    inRow += weightX[column * bands + c];
                }
            }
            sum += weightY[row * bands + r] * inRow;
        }
        return sum + outsideY[row];
    }

    /** Share of each cell, and of the white around the marker, in the light that reaches each cell's middle. */
    private void weights(double blurCells, double[] weight, double[] outside) {
        for (int i = 0; i < bands; i++) {
            double sum = 0;
            double below = EdgeProfile.cumulative(-grid.middle(i) / blurCells);
            for (int k = 0; k < bands; k++) {
                double above = EdgeProfile.cumulative((grid.line(k + 1) - grid.middle(i)) / blurCells);
                weight[i * bands + k] = above - below;
                sum += above - below;
                below = above;
            }
            outside[i] = 1 - sum;
        }
    }

    private static double meanLength(double[] c, int a, int b, int d, int e) {
        return (Math.hypot(c[2 * a] - c[2 * b], c[2 * a + 1] - c[2 * b + 1])
                + Math.hypot(c[2 * d] - c[2 * e], c[2 * d + 1] - c[2 * e + 1])) / 2;
    }

    /** Light of each cell's middle, 0 at the marker's black and 1 at its white. */
    private void sample(GreyImage image, GreyScale scale, double darkGrey, double brightGrey) {
        double dark = scale.light(darkGrey);
        // what is clipped reads as 255, however bright it was
        double contrast = scale.light(Math.min(255, brightGrey)) - dark;
        for (int row = 0; row < bands; row++) {
            for (int column = 0; column < bands; column++) {
                double sum = 0;
                for (int k = 0; k < POINTS * POINTS; k++) {
                    double x = (grid.middle(column) + POINT_SPACING * (k % POINTS - POINTS / 2)) / grid.cells();
                    double y = (grid.middle(row) + POINT_SPACING * (k / POINTS - POINTS / 2)) / grid.cells();
                    double w = homography[6] * x + homography[7] * y + 1;
                    double xn = (homography[0] * x + homography[1] * y + homography[2]) / w;
                    double yn = (homography[3] * x + homography[4] * y + homography[5]) / w;
                    if (plane != null) {
                        plane.toImage(xn, yn, uv, 0);
                    } else {
                        lens.project(intrinsics, xn, yn, 1, uv, 0);
                    }
                    sum += scale.tabulatedLight(image.interpolate(uv[0], uv[1]));
                }
                level[row * bands + column] = (sum / (POINTS * POINTS) - dark) / contrast;
            }
        }
    }

    private boolean setHomography(double[] cornersPx) {
        if (plane != null && !plane.aim(cornersPx)) {
            return false;
        }
        for (int i = 0; i < 4; i++) {
            double u = cornersPx[2 * i];
            double v = cornersPx[2 * i + 1];
            if (plane != null) {
                if (!plane.toPlane(u, v, ideal, 2 * i)) {
                    return false;
                }
                continue;
            }
            if (!lens.toRay(intrinsics, u, v, ray)) {
                return false;
            }
            ideal[2 * i] = ray[0];
            ideal[2 * i + 1] = ray[1];
        }
        return Homography.ofUnitSquare(ideal, homography);
    }
}
