package org.cellgauge.vision;

import java.util.Arrays;

/**
 * The light of the white cells of a marker's pattern, as pixels beside one of its sides see it: rows of cells from the
 * border inwards, each with its white stretches along the side.
 *
 * <p>A row is white by the share that blur brings from its stretches along the side, times the share that it brings
 * from the row's depth. With every edge moved into the dark by the shift, the true outline lies that far outside the
 * one that is seen, all that hangs on it moves along, and white cells are larger by it on all sides.
 *
 * <p>Not thread-safe; arrays are kept between sides. Loops do one thing to all pixels, so that the compiler can take
 * several at a time.
 */
final class PatternLight {
    /** Rows of the pattern, from its border inwards, whose light reaches a side. */
    private static final int ROWS = 3;
    /** How far from an end of a stretch its blur is seen, deviations. */
    private static final double REACH = 4;
    /** Deviations of the blur beyond which a row is not looked for: less than a hundred-thousandth of it is seen. */
    private static final double DEEPEST = 4.5;
    /** Pixels that are gone through at a time: all those beside a side of a marker of usual size. */
    private static final int AT_ONCE = 256;
    /** A pixel that sees less of a row has no use for where that lies. */
    private static final double LEAST_SEEN = 1e-5;

    private final MarkerGrid grid;
    private final int bands;
    private final double[] point = new double[2];

    private int side;
    private double[] homography = new double[0];
    private boolean[] white = new boolean[0];
    private double shiftPx;
    private double originX;
    private double originY;
    private double tangentX;
    private double tangentY;
    private double normalX;
    private double normalY;

    // the pattern as seen from the side: depth of the lines between rows at the middle of the side and its change along
    // it, and for each row the ends of its white stretches along the side, their change with depth (a marker seen
    // aslant is sheared: taken as upright, the ends would feign a shift of 0.01 px) and the cosine of that slant
    private final double[] depth = new double[ROWS + 1];
    private final double[] depthSlope = new double[ROWS + 1];
    private final double[][] ends = new double[ROWS][];
    private final double[][] endSlope = new double[ROWS][];
    private final double[][] endCosine = new double[ROWS][];
    private final int[] endCount = new int[ROWS];
    private int rows;

    /** Of each pixel: what it sees of white cells, as a share of the difference of white and black. */
    double[] share = new double[0];
    /** Its change where the whole pattern moves inwards; where the shift grows; and by the blur, each 1/px. */
    double[] bySlide = new double[0];
    double[] byShift = new double[0];
    double[] byBlur = new double[0];

    // work space, of each row and pixel: how far the pixel lies behind the line before the row and where the middle of
    // what it sees of it is, px; how white the row is there, and how that changes by blur and shift
    private int rowsSeen;
    private final double[][] behind = new double[ROWS][AT_ONCE];
    private final double[][] depthSeen = new double[ROWS][AT_ONCE];
    private final double[][] rowWhite = new double[ROWS][AT_ONCE];
    private final double[][] rowByBlur = new double[ROWS][AT_ONCE];
    private final double[][] rowGrowth = new double[ROWS][AT_ONCE];
    private final double[] none = new double[AT_ONCE];
    private final double[] alongSome = new double[AT_ONCE];
    private final double[] depthSome = new double[AT_ONCE];
    // what is asked of the profile, of all rows at once: for few distances its loops are all beginning and end
    private int askedCount;
    private double[] asked = new double[0];
    private int[] askedBy = new int[0];
    private final int[][] askedUpTo = new int[ROWS][];
    private final int[] rowAskedUpTo = new int[ROWS];
    private double[] profileShare = new double[0];
    private double[] profileByDistance = new double[0];
    private double[] profileByBlur = new double[0];

    /**
     * For markers of one family.
     *
     * @param grid lattice of its markers
     */
    PatternLight(MarkerGrid grid) {
        this.grid = grid;
        this.bands = grid.bands();
        for (int r = 0; r < ROWS; r++) {
            ends[r] = new double[bands + 1];
            endSlope[r] = new double[bands + 1];
            endCosine[r] = new double[bands + 1];
            askedUpTo[r] = new int[bands + 1];
        }
    }

    /**
     * Turns to a side.
     *
     * @param number of the side, from corner {@code number} to the next
     * @param of its place and direction
     * @param unitSquare homography that takes the unit square to the marker, see {@link Homography#ofUnitSquare}
     * @param pattern white cells, row by row
     * @param shift of the edges, px into the dark
     */
    void turnTo(int number, SideFit of, double[] unitSquare, boolean[] pattern, double shift) {
        side = number;
        homography = unitSquare;
        white = pattern;
        shiftPx = shift;
        originX = of.middleX;
        originY = of.middleY;
        tangentX = of.tangentX;
        tangentY = of.tangentY;
        normalX = of.normalX;
        normalY = of.normalY;
        rows = Math.min(ROWS, grid.codeCells());
        for (int r = 0; r <= rows; r++) {
            double z = grid.line(grid.borderBands() + r) / grid.cells();
            place(0.2, z, point);
            double t0 = point[0];
            double d0 = point[1];
            place(0.8, z, point);
            depthSlope[r] = (point[1] - d0) / (point[0] - t0);
            // the true outline lies outside the one that is seen, and what hangs on it likewise
            depth[r] = d0 - depthSlope[r] * t0 - frame(r) * shiftPx;
        }
        double stretch = 1 + 2 * shiftPx / of.lengthPx;
        for (int r = 0; r < rows; r++) {
            setEnds(r, stretch);
        }
    }

    private void setEnds(int r, double stretch) {
        double front = grid.line(grid.borderBands() + r) / grid.cells();
        double back = grid.line(grid.borderBands() + r + 1) / grid.cells();
        int count = 0;
        boolean inWhite = false;
        for (int k = 0; k <= bands; k++) {
            boolean here = k < bands && whiteCell(grid.borderBands() + r, k);
            if (here != inWhite) {
                place(grid.line(k) / grid.cells(), front, point);
                double t0 = point[0];
                double z0 = point[1];
                place(grid.line(k) / grid.cells(), back, point);
                double slope = (point[0] - t0) / (point[1] - z0);
                double cosine = 1 / Math.sqrt(1 + slope * slope);
                // white that has spread begins earlier and ends later
                ends[r][count] = (t0 - slope * z0) * stretch + (here ? -shiftPx : shiftPx) / cosine;
                endSlope[r][count] = slope;
                endCosine[r][count++] = cosine;
                inWhite = here;
            }
        }
        endCount[r] = count;
    }

    /** The cell at a depth of rows and a place along the side. */
    private boolean whiteCell(int row, int along) {
        switch (side) {
            case 0:
                return white[row * bands + along];
            case 1:
                return white[along * bands + bands - 1 - row];
            case 2:
                return white[(bands - 1 - row) * bands + bands - 1 - along];
            default:
                return white[(bands - 1 - along) * bands + row];
        }
    }

    /**
     * A point of the marker in the side's coordinates.
     *
     * @param a place along the side, 0 to 1
     * @param z how deep, 0 to 1
     * @param out receives place along the side from its middle and depth, px
     */
    void place(double a, double z, double[] out) {
        double x;
        double y;
        switch (side) {
            case 0:
                x = a;
                y = z;
                break;
            case 1:
                x = 1 - z;
                y = a;
                break;
            case 2:
                x = 1 - a;
                y = 1 - z;
                break;
            default:
                x = z;
                y = 1 - a;
                break;
        }
        double w = homography[6] * x + homography[7] * y + 1;
        double px = (homography[0] * x + homography[1] * y + homography[2]) / w - originX;
        double py = (homography[3] * x + homography[4] * y + homography[5]) / w - originY;
        out[0] = px * tangentX + py * tangentY;
        out[1] = -(px * normalX + py * normalY);
    }

    /** How deep the inner edge of the border lies in the middle of the side, px; and its change along the side. */
    double borderPx() {
        return depth[0];
    }

    double borderSlope() {
        return depthSlope[0];
    }

    /** How far the line before a row moves outwards with the outline, per px of each of the four sides. */
    private double frame(int row) {
        return 1 - 2 * grid.line(grid.borderBands() + row) / grid.cells();
    }

    /**
     * Evaluates {@link #share} and its derivatives.
     *
     * @param along places of pixels along the side from its middle, px
     * @param depths how deep they lie, px
     * @param count how many
     * @param profile turned to the side's normal
     * @param blur standard deviation of the optical blur, px
     * @param std the same with the pixel's own extent, px
     * @param perLength change of the place of an end by the shift, as a share of that place, 1/px
     */
    void see(double[] along, double[] depths, int count, EdgeProfile profile, double blur, double std,
            double perLength) {
        reserve(count);
        for (int from = 0; from < count; from += AT_ONCE) {
            int some = Math.min(AT_ONCE, count - from);
            System.arraycopy(along, from, alongSome, 0, some);
            System.arraycopy(depths, from, depthSome, 0, some);
            seeSome(from, some, profile, blur, std, perLength);
        }
    }

    private void seeSome(int from, int count, EdgeProfile profile, double blur, double std, double perLength) {
        double beyond = DEEPEST * std + Math.abs(shiftPx);
        rowsSeen = 0;
        while (rowsSeen < rows && isSeen(rowsSeen, count, beyond)) {
            rowsSeen++;
        }
        askEnds(count, std, beyond);
        profile.at(asked, askedCount, blur, profileShare, profileByDistance, profileByBlur);
        addEnds(perLength);
        askRows(count, beyond);
        profile.at(asked, askedCount, blur, profileShare, profileByDistance, profileByBlur);
        addRows(from, count);
    }

    /** Whether any pixel sees a row: of what lies deeper the profile would be nothing. Sets how far behind they lie. */
    private boolean isSeen(int r, int count, double beyond) {
        double line = depth[r];
        double slope = depthSlope[r];
        double[] to = behind[r];
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            to[i] = depthSome[i] - line - slope * alongSome[i];
            most = Math.max(most, to[i]);
        }
        return most > -beyond;
    }

    /** Asks for the profile across the ends of white stretches, a pixel being as wide along a side as across it. */
    private void askEnds(int count, double std, double beyond) {
        askedCount = 0;
        double reach = REACH * std;
        for (int r = 0; r < rowsSeen; r++) {
            Arrays.fill(rowWhite[r], 0, count, 0);
            Arrays.fill(rowByBlur[r], 0, count, 0);
            Arrays.fill(rowGrowth[r], 0, count, 0);
            if (endCount[r] > 0) {
                setDepthsSeen(r, count, std, beyond);
            }
            for (int k = 0; k < endCount[r]; k++) {
                askEnd(r, k, count, reach, beyond);
                askedUpTo[r][k] = askedCount;
            }
        }
    }

    private void askEnd(int r, int k, int count, double reach, double beyond) {
        if (asked.length < askedCount + count) {
            reserveAsked((askedCount + count) * 5 / 4 + 64);
        }
        double at = ends[r][k];
        double slope = endSlope[r][k];
        double cosine = endCosine[r][k];
        double sign = (k & 1) == 0 ? 1 : -1;
        double[] white = rowWhite[r];
        double[] seen = behind[r];
        int n = askedCount;
        for (int i = 0; i < count; i++) {
            double z = (alongSome[i] - (at + slope * depthSeen[r][i])) * cosine;
            if (z >= reach) {
                white[i] += sign;
            } else if (z > -reach && seen[i] > -beyond) {
                askedBy[n] = i;
                asked[n++] = z;
            }
        }
        askedCount = n;
    }

    private void addEnds(double perLength) {
        int n = 0;
        for (int r = 0; r < rowsSeen; r++) {
            for (int k = 0; k < endCount[r]; k++) {
                double sign = (k & 1) == 0 ? 1 : -1;
                double at = ends[r][k];
                double slope = endSlope[r][k];
                for (; n < askedUpTo[r][k]; n++) {
                    int i = askedBy[n];
                    rowWhite[r][i] += sign * profileShare[n];
                    rowByBlur[r][i] += sign * profileByBlur[n];
                    rowGrowth[r][i] += profileByDistance[n] * (1 - sign * perLength * (at + slope * depthSeen[r][i]));
                }
            }
        }
    }

    /** Asks for the profile across the lines before rows. */
    private void askRows(int count, double beyond) {
        if (asked.length < rowsSeen * count) {
            reserveAsked(rowsSeen * count * 5 / 4 + 64);
        }
        int n = 0;
        for (int r = 0; r < rowsSeen; r++) {
            double[] white = rowWhite[r];
            double[] before = r == 0 ? none : rowWhite[r - 1];
            double[] seen = behind[r];
            for (int i = 0; i < count; i++) {
                if (seen[i] > -beyond) {
                    askedBy[n] = i;
                    asked[n++] = seen[i] + (white[i] > before[i] ? shiftPx : -shiftPx);
                }
            }
            rowAskedUpTo[r] = n;
        }
        askedCount = n;
    }

    private void addRows(int from, int count) {
        Arrays.fill(share, from, from + count, 0);
        Arrays.fill(bySlide, from, from + count, 0);
        Arrays.fill(byShift, from, from + count, 0);
        Arrays.fill(byBlur, from, from + count, 0);
        int n = 0;
        for (int r = 0; r < rowsSeen; r++) {
            double[] before = r == 0 ? none : rowWhite[r - 1];
            double[] growthBefore = r == 0 ? none : rowGrowth[r - 1];
            double[] byBlurBefore = r == 0 ? none : rowByBlur[r - 1];
            double ofFrame = frame(r);
            for (; n < rowAskedUpTo[r]; n++) {
                int i = askedBy[n];
                double change = rowWhite[r][i] - before[i];
                double seen = profileShare[n];
                double byDistance = profileByDistance[n];
                share[from + i] += change * seen;
                bySlide[from + i] += change * byDistance;
                byShift[from + i] += (Math.abs(change) + change * ofFrame) * byDistance
                        + (rowGrowth[r][i] - growthBefore[i]) * seen;
                byBlur[from + i] += change * profileByBlur[n] + (rowByBlur[r][i] - byBlurBefore[i]) * seen;
            }
        }
    }

    /**
     * Mean depth of what pixels see of a row: that of a normal distribution about the pixel's own depth between the
     * lines before and behind the row (Johnson, Kotz, Balakrishnan, "Continuous Univariate Distributions", volume 1,
     * 1994, section 13.10.1). A pixel that looks across the edge of a slanted cell sees its ends where the cell is, not
     * where the pixel is: taken there, markers tilted by 30 degrees feigned a shift of 0.01 px.
     */
    private void setDepthsSeen(int row, int count, double std, double beyond) {
        boolean last = row == rows - 1;
        double line = depth[row + 1];
        double slope = depthSlope[row + 1];
        double perPx = 1 / std;
        for (int i = 0; i < count; i++) {
            if (behind[row][i] > -beyond) {
                double from = -behind[row][i] * perPx;
                double to = last ? REACH : (line + slope * alongSome[i] - depthSome[i]) * perPx;
                double seen = EdgeProfile.tabulated(to) - EdgeProfile.tabulated(from);
                depthSeen[row][i] = depthSome[i] + std * (seen > LEAST_SEEN
                        ? (EdgeProfile.density(from) - EdgeProfile.density(to)) / seen
                        : from > 0 ? from : Math.min(0, to));
            }
        }
    }

    private void reserve(int count) {
        if (share.length >= count) {
            return;
        }
        int length = count + count / 4 + 64;
        share = new double[length];
        bySlide = new double[length];
        byShift = new double[length];
        byBlur = new double[length];
    }

    private void reserveAsked(int length) {
        asked = Arrays.copyOf(asked, length);
        askedBy = Arrays.copyOf(askedBy, length);
        profileShare = new double[length];
        profileByDistance = new double[length];
        profileByBlur = new double[length];
    }
}
