package org.cellgauge.vision;

import java.util.Arrays;
import org.cellgauge.geometry.Lens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.geometry.TangentPlane;
import org.jspecify.annotations.Nullable;

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
    /** Where a cell is looked at again to see whether it is one: so far from its middle both ways, cells. */
    private static final double OFF_MIDDLE = 0.33;

    private final Lens lens;
    private final double[] intrinsics;
    /** Where the marker is looked at under a wide lens; null for others. */
    private final @Nullable TangentPlane plane;
    private final MarkerGrid grid;
    private final int bands;
    private final double[] level;
    private final double[] weightX;
    private final double[] weightY;
    private final double[] outsideX;
    private final double[] outsideY;
    private final double[] middles;
    /** The same as shares of the marker's width. */
    private final double[] sharesOfMiddles;
    /** Places in each band at which it is read, as shares of the marker's width. */
    private final double[] points;
    /** Two places in each band of the code. */
    private final double[] places;
    /** The same as shares of the marker's width. */
    private final double[] sharesOfPlaces;
    private final double[] placeWeightX;
    private final double[] placeWeightY;
    private final double[] placeOutsideX;
    private final double[] placeOutsideY;
    /** Of each row of bands, the share of white in the light along it where columns cross it. */
    private final double[] whiteOfRows;
    /** Along a row of places: where these are, and their light. */
    private final double[] alongX;
    private final double[] alongY;
    private final double[] alongLight;
    private final double[] homography = new double[8];
    private final double[] ray = new double[3];
    private final double[] uv = new double[2];
    private final double[] ideal = new double[8];
    /** Blur of the last reading along both axes of the marker, cells. */
    private double blurX;
    private double blurY;

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
        this.middles = new double[bands];
        for (int i = 0; i < bands; i++) {
            middles[i] = grid.middle(i);
        }
        this.sharesOfMiddles = new double[bands];
        for (int i = 0; i < bands; i++) {
            sharesOfMiddles[i] = middles[i] / grid.cells();
        }
        this.points = new double[POINTS * bands];
        for (int i = 0; i < points.length; i++) {
            points[i] = (middles[i / POINTS] + POINT_SPACING * (i % POINTS - POINTS / 2)) / grid.cells();
        }
        this.places = new double[2 * grid.codeCells()];
        for (int i = 0; i < places.length; i++) {
            places[i] = grid.middle(grid.borderBands() + i / 2) + (i % 2 == 0 ? -OFF_MIDDLE : OFF_MIDDLE);
        }
        this.sharesOfPlaces = new double[places.length];
        for (int i = 0; i < places.length; i++) {
            sharesOfPlaces[i] = places[i] / grid.cells();
        }
        this.whiteOfRows = new double[bands * Math.max(bands, places.length)];
        this.alongX = new double[points.length];
        this.alongY = new double[points.length];
        this.alongLight = new double[points.length];
        this.placeWeightX = new double[places.length * bands];
        this.placeWeightY = new double[places.length * bands];
        this.placeOutsideX = new double[places.length];
        this.placeOutsideY = new double[places.length];
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
        return settle(cornersPx, blurPx, white);
    }

    /** Changes cells of a reading until none is wrong. */
    private boolean settle(double[] cornersPx, double blurPx, boolean[] white) {
        double blur = Math.sqrt(blurPx * blurPx + READING_VARIANCE_PX2);
        blurX = blur * grid.cells() / meanLength(cornersPx, 0, 1, 3, 2);
        blurY = blur * grid.cells() / meanLength(cornersPx, 0, 3, 1, 2);
        weights(middles, blurX, weightX, outsideX);
        weights(middles, blurY, weightY, outsideY);
        setWhiteOfRows(white, weightX, outsideX);
        for (int round = 0; round < MAX_ROUNDS; round++) {
            int worst = -1;
            double worstExcess = 0;
            for (int row = 0; row < bands; row++) {
                for (int column = 0; column < bands; column++) {
                    int cell = row * bands + column;
                    double ownShare = weightY[row * bands + row] * weightX[column * bands + column];
                    double off = level[cell] - expected(row, column, bands, weightY, outsideY);
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
            setWhiteOfRow(worst / bands, white, weightX, outsideX);
        }
        return false;
    }

    /**
     * Reads a marker whose code is not known at all.
     *
     * @param white replaced by the reading
     * @return as {@link #read}
     */
    boolean readAnew(GreyImage image, double[] cornersPx, GreyScale scale, double darkGrey, double brightGrey,
            double blurPx, boolean[] white) {
        if (!setHomography(cornersPx)) {
            return false;
        }
        sample(image, scale, darkGrey, brightGrey);
        return settleAnew(cornersPx, blurPx, white);
    }

    private boolean settleAnew(double[] cornersPx, double blurPx, boolean[] white) {
        for (int i = 0; i < white.length; i++) {
            white[i] = level[i] > 0.5;
        }
        return settle(cornersPx, blurPx, white);
    }

    /**
     * Reads a marker by the middles of its cells alone, to tell whether it can be one of this lattice at all.
     *
     * @param white replaced by the reading, settled or not
     * @return whether its corners are those of a square
     */
    boolean readRoughly(GreyImage image, double[] cornersPx, GreyScale scale, double darkGrey, double brightGrey,
            double blurPx, boolean[] white) {
        if (!setHomography(cornersPx)) {
            return false;
        }
        double dark = scale.light(darkGrey);
        double contrast = scale.light(Math.min(255, brightGrey)) - dark;
        for (int row = 0; row < bands; row++) {
            lightAlong(image, scale, sharesOfMiddles, sharesOfMiddles[row]);
            for (int column = 0; column < bands; column++) {
                level[row * bands + column] = (alongLight[column] - dark) / contrast;
            }
        }
        settleAnew(cornersPx, blurPx, white);
        return true;
    }

    /**
     * How bright the white cells of the code are against the white of the margin, by which they are expected. To be
     * asked right after the reading.
     *
     * @param white the reading; at least one cell of it is white
     * @return about 1; more where the margin is too narrow to be seen white
     */
    double whiteOverMargin(boolean[] white) {
        setWhiteOfRows(white, weightX, outsideX);
        double seen = 0;
        double expected = 0;
        for (int cell = 0; cell < white.length; cell++) {
            if (white[cell]) {
                seen += level[cell];
                expected += expected(cell / bands, cell % bands, bands, weightY, outsideY);
            }
        }
        return seen / expected;
    }

    /**
     * How far the code looks from what a reading makes it look like, between the middles of cells as well: there a
     * marker of another grid gives itself away. To be asked right after the reading.
     *
     * @return root of the mean squared deviation at four places of each cell of the code, as a share of the step from
     *     black to white
     */
    double misfit(GreyImage image, GreyScale scale, double darkGrey, double brightGrey, boolean[] white) {
        return misfit(image, scale, darkGrey, brightGrey, white, Double.POSITIVE_INFINITY);
    }

    /**
     * The same, or any value that is not less than a limit where it is not.
     *
     * @param limit from which on it does not matter how much it is
     */
    double misfit(GreyImage image, GreyScale scale, double darkGrey, double brightGrey, boolean[] white,
            double limit) {
        weights(places, blurX, placeWeightX, placeOutsideX);
        weights(places, blurY, placeWeightY, placeOutsideY);
        setWhiteOfRows(white, placeWeightX, placeOutsideX);
        double dark = scale.light(darkGrey);
        double contrast = scale.light(Math.min(255, brightGrey)) - dark;
        double sum = 0;
        double most = limit * limit * places.length * places.length;
        for (int row = 0; row < places.length && sum < most; row++) {
            lightAlong(image, scale, sharesOfPlaces, sharesOfPlaces[row]);
            for (int column = 0; column < places.length; column++) {
                double seen = (alongLight[column] - dark) / contrast;
                double off = seen - expected(row, column, places.length, placeWeightY, placeOutsideY);
                sum += off * off;
            }
        }
        return Math.sqrt(sum) / places.length;
    }

    /** Sets the light along each row of bands where columns cross it that weights were taken for. */
    private void setWhiteOfRows(boolean[] white, double[] ofX, double[] beyondX) {
        for (int row = 0; row < bands; row++) {
            setWhiteOfRow(row, white, ofX, beyondX);
        }
    }

    private void setWhiteOfRow(int row, boolean[] white, double[] ofX, double[] beyondX) {
        int columns = beyondX.length;
        for (int column = 0; column < columns; column++) {
            double inRow = beyondX[column];
            for (int c = 0; c < bands; c++) {
                if (white[row * bands + c]) {
                    inRow += ofX[column * bands + c];
                }
            }
            whiteOfRows[row * columns + column] = inRow;
        }
    }

    /** Light where a row crosses one of the columns that the light along the rows was set for. */
    private double expected(int row, int column, int columns, double[] ofY, double[] beyondY) {
        double sum = 0;
        for (int r = 0; r < bands; r++) {
            sum += ofY[row * bands + r] * whiteOfRows[r * columns + column];
        }
        return sum + beyondY[row];
    }

    /** Share of each band, and of the white around the marker, in the light that reaches each place along an axis. */
    private void weights(double[] at, double blurCells, double[] weight, double[] outside) {
        for (int i = 0; i < at.length; i++) {
            double sum = 0;
            double below = EdgeProfile.tabulated(-at[i] / blurCells);
            for (int k = 0; k < bands; k++) {
                double above = EdgeProfile.tabulated((grid.line(k + 1) - at[i]) / blurCells);
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
            int first = row * bands;
            Arrays.fill(level, first, first + bands, 0);
            for (int k = 0; k < POINTS; k++) {
                lightAlong(image, scale, points, points[row * POINTS + k]);
                for (int i = 0; i < points.length; i++) {
                    level[first + i / POINTS] += alongLight[i];
                }
            }
            for (int cell = first; cell < first + bands; cell++) {
                level[cell] = (level[cell] / (POINTS * POINTS) - dark) / contrast;
            }
        }
    }

    /** Sets the light at places along a row of the marker, given as shares of its width. */
    private void lightAlong(GreyImage image, GreyScale scale, double[] across, double down) {
        int count = across.length;
        place(across, down);
        for (int i = 0; i < count; i++) {
            if (plane != null) {
                plane.toImage(alongX[i], alongY[i], uv, 0);
            } else {
                lens.project(intrinsics, alongX[i], alongY[i], 1, uv, 0);
            }
            double u = uv[0];
            double v = uv[1];
            alongLight[i] = scale.tabulatedLight(
                    image.hasNeighbours(u, v) ? image.interpolateInside(u, v) : image.interpolate(u, v));
        }
    }

    private void place(double[] across, double down) {
        double[] h = homography;
        double byX = h[0];
        double byY = h[3];
        double byW = h[6];
        double downX = h[1] * down;
        double downY = h[4] * down;
        double downW = h[7] * down;
        double startX = h[2];
        double startY = h[5];
        double[] toX = alongX;
        double[] toY = alongY;
        for (int i = 0; i < across.length; i++) {
            double w = byW * across[i] + downW + 1;
            toX[i] = (byX * across[i] + downX + startX) / w;
            toY[i] = (byY * across[i] + downY + startY) / w;
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
