package org.cellgauge.vision;

import java.util.Arrays;
import org.cellgauge.geometry.Lens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.geometry.TangentPlane;
import org.cellgauge.internal.vision.SideBand;
import org.jspecify.annotations.Nullable;

/**
 * The edges of one marker in one image: its four sides fitted to the grey values, corners where they meet, the
 * covariance of these corners, and what the inner edges say of a shift common to all edges.
 *
 * <p>Sides of a marker are straight only where the lens does not bend them. So every pixel in a band along a side is
 * taken to undistorted pixels first (its grey value stays what the sensor measured: nothing is interpolated), in one
 * plane for the whole image or, under a wide lens, in a plane of the marker's own ({@link TangentPlane}), and there
 * a straight blurred step is fitted ({@link SideFit}). The light that blur brings into that band from the pattern
 * inside (known, once the marker is read), from the ends of the side and from beyond the edge of the paper (looked for
 * in the image) is part of the model: left out, it moves a side of a marker of 24 px by 0.02 px at a blur of 1.2 px.
 *
 * <p>Not thread-safe; work space is kept from marker to marker.
 */
final class MarkerEdges {
    private static final int CORNERS = 4;
    private static final int MAX_PASSES = 6;
    /** A line that moved further than this has left the band it was fitted in: its pixels are chosen again. */
    private static final double BAND_STILL_GOOD_PX = 0.05;
    /** The same while the tone curve is not known yet. */
    private static final double FIRST_BAND_STILL_GOOD_PX = 0.3;
    private static final double FIRST_BLUR_PX = 0.6;
    private static final double FURTHEST_MOVE_PX = 3;
    private static final int SHORTEST_SIDE_PX = 8;
    private static final double LARGEST_SHIFT_PX = 1;
    /** A step of the shift by more than this has left the place where it is linear to a thousandth of a pixel. */
    private static final double LINEAR_SHIFT_PX = 0.02;
    private static final int MAX_SHIFT_STEPS = 4;
    /** Rows of the pattern, from its border inwards, whose light reaches a side. */
    private static final int ROWS = 3;
    private static final double REACH = 4;
    /** Deviations of the blur beyond which nothing at all is seen of an edge, however it lies to the pixels. */
    private static final double DEEPEST = 6;
    /** White from which on it may be clipped, grey levels. */
    private static final double BRIGHTEST_FOR_LAMP = 248;
    /** Change of the light from one end of a marker to the other, as a share of it, that is no lamp's. */
    private static final double STEEPEST_LAMP = 0.3;
    /** A pixel that sees less of the dark has no use for where that lies. */
    private static final double LEAST_SEEN = 1e-5;
    /** Variance that a pixel's own square adds to the blur. */
    static final double PIXEL_VARIANCE = SideBand.PIXEL_VARIANCE;
    /** How far outwards the edge of the paper is looked for. */
    private static final int PAPER_STEPS = 24;
    private static final int PAPER_LINES = 3;
    private static final int PAPER_ROUNDS = 4;
    /** Beyond so many deviations of the blur from the band the edge of the paper need not be known well. */
    private static final double FAR_BLURS = 4;
    /** Variance that interpolating between pixels adds to the blur. */
    private static final double INTERPOLATION_VARIANCE = 1.0 / 6;
    private static final double PAPER_STEP_PX = 0.5;
    /** A drop of the light by less than this share of the difference of white and black is no edge of the paper. */
    private static final double PAPER_CONTRAST = 0.06;
    /** What lines and shift hang on, of every side. */
    private static final int[] SIDE_UNKNOWNS = {SideFit.OFFSET, SideFit.SLOPE, SideFit.BLUR, SideFit.BRIGHT};
    private static final int BY_BLUR = 2;
    private static final int BY_BRIGHT = 3;

    private static final double WHITE = 255;
    /** About a marker, what its sides' bands reach; and the most pixels whose places are kept, of 16 bytes each. */
    private static final int CACHE_MARGIN_PX = 8;
    private static final int MOST_CACHED = 1 << 16;
    /** About a marker, where the edge of the paper is looked for, and what a sharpened pixel sees beyond. */
    private static final int SURROUNDINGS_PX = 15;
    private static final int SURROUNDINGS_RADII = 5;

    private final Lens lens;
    private final double[] intrinsics;
    /** Where the marker is looked at under a wide lens; null for others. */
    private final @Nullable TangentPlane plane;
    private final boolean distorted;
    private final MarkerGrid grid;
    private final GreyScale scale;
    private final int bands;
    private final EdgeProfile profile = new EdgeProfile();
    private final SideFit[] sides = {new SideFit(), new SideFit(), new SideFit(), new SideFit()};

    private final double[] ideal = new double[2 * CORNERS];
    private final double[] refined = new double[2 * CORNERS];
    private final double[] before = new double[2 * CORNERS];
    private final double[] line = new double[3 * CORNERS];
    private final double[] homography = new double[8];
    private final double[] normal = new double[9];
    private final double[] gradient = new double[3];
    private final double[] shiftRow = new double[3];
    private final double[][] byOwn = new double[CORNERS][3];
    private final double[][] byOwnAlong = new double[CORNERS][3];
    private final double[][] byOwnBlur = new double[CORNERS][3];
    private final double[] factorInverse = new double[9];
    private final double[] inverse = new double[9];
    private final double[] point = new double[2];
    private final double[] ray = new double[3];
    private boolean[] white = new boolean[0];
    /** Grey values with an unsharp mask undone, in force where {@link #unsharpened}. */
    private final Unsharpened levels = new Unsharpened();
    private double settledPx = SideFit.SETTLED_PX;
    private boolean unsharpened;
    private final SharpenedStep step = new SharpenedStep();

    // the pattern as seen from one side: depth of the lines between rows at the middle of the side and its change
    // along it, and for each row the ends of its white stretches along the side, their change with depth (a marker seen
    // aslant is sheared: taken as upright, the ends would feign a shift of 0.01 px) and the cosine of that slant
    private final double[] depth = new double[ROWS + 1];
    private final double[] depthSlope = new double[ROWS + 1];
    private final double[][] ends = new double[ROWS][];
    private final double[][] endSlope = new double[ROWS][];
    private final double[][] endCosine = new double[ROWS][];
    private final int[] endCount = new int[ROWS];
    private int rows;
    /** How many of them the last pixel saw. */
    private int rowsSeen;
    private final double[] rowWhite = new double[ROWS];
    private final double[] rowByBlur = new double[ROWS];
    private double innerByBlur;
    private final double[] rowGrowth = new double[ROWS];
    private final double[] rowStretch = new double[ROWS];

    // the sides before and after the one at hand: where they meet it, their change along it with depth, and its cosine
    private final double[] cornerAt = new double[2];
    private final double[] cornerSlope = new double[2];
    private final double[] cornerCosine = new double[2];

    // change of the lamp's light over the marker as a share of it, 1/px, and how it hangs on the white of each side
    private double lampX;
    private double lampY;
    private final double[] lampXByBright = new double[CORNERS];
    private final double[] lampYByBright = new double[CORNERS];

    private final double[] paperLight = new double[PAPER_STEPS];
    private double paperPx;
    private double paperShare;

    private int firstX;
    private int lastX;
    private int firstY;
    private int lastY;

    // undistorted places of the pixels about the marker, NaN where nobody has asked yet: bending them back takes as
    // long as all that is then done with them
    private int cachedX;
    private int cachedY;
    private int cachedWidth;
    private int cachedHeight;
    private double[] cached = new double[0];

    private double shiftPx;
    private double shiftInformation;
    private final double[] shiftByLine = new double[2 * CORNERS];
    private final double[] shiftByBlur = new double[CORNERS];
    private boolean shiftMeasured;
    /** Work space of an observation, which copies what it keeps. */
    private final double[] byLines = new double[64];
    private final double[] joint = new double[81];
    private final double[] bySide = new double[9 * SIDE_UNKNOWNS.length];
    private final double[] lines = new double[64];
    private final double[] half = new double[64];
    private final double[] covariance = new double[64];
    private final double[] corners = new double[2 * CORNERS];
    private final double[] withCorners = new double[2 * CORNERS];

    /**
     * Edges of markers of one family in images of one camera.
     *
     * @param camera camera of the images
     * @param grid lattice of the family's markers
     * @param scale tone curve and noise, which may change between the calls of methods
     */
    MarkerEdges(PinholeCamera camera, MarkerGrid grid, GreyScale scale) {
        this.scale = scale.another();
        this.lens = camera.lens();
        this.intrinsics = camera.intrinsics();
        this.plane = lens.isWide() ? new TangentPlane(camera) : null;
        this.distorted = camera.isDistorting();
        this.grid = grid;
        this.bands = grid.bands();
        for (int r = 0; r < ROWS; r++) {
            ends[r] = new double[bands + 1];
            endSlope[r] = new double[bands + 1];
            endCosine[r] = new double[bands + 1];
        }
    }

    /**
     * Fits the sides of a marker for the first time.
     *
     * @param image the image
     * @param cornersPx 8 values, distorted px, within about a pixel of the corners, in the order of the pattern's
     *     top-left, top-right, bottom-right, bottom-left
     * @param pattern white cells, row by row; kept, not copied
     * @return whether all sides were found near where they were looked for
     */
    boolean fit(GreyImage image, double[] cornersPx, boolean[] pattern) {
        if (plane != null && !plane.aim(cornersPx)) {
            return false;
        }
        for (int i = 0; i < CORNERS; i++) {
            if (!toIdeal(cornersPx[2 * i], cornersPx[2 * i + 1], ideal, 2 * i)) {
                return false;
            }
            sides[i].restart();
        }
        System.arraycopy(ideal, 0, before, 0, 2 * CORNERS);
        white = pattern;
        shiftPx = 0;
        unsharpened = false;
        clearLamp();
        if (distorted) {
            clearCache(cornersPx);
        }
        settledPx = SideFit.SETTLED_PX;
        return passes(image, MAX_PASSES, FIRST_BAND_STILL_GOOD_PX);
    }

    /**
     * Fits again from where the last fit ended, with another tone curve or another reading.
     *
     * @param image the same image
     * @param pattern white cells; kept, not copied
     * @return whether all sides were found
     */
    boolean refit(GreyImage image, boolean[] pattern) {
        white = pattern;
        settledPx = SideFit.SETTLED_PX;
        return passes(image, MAX_PASSES, BAND_STILL_GOOD_PX);
    }

    /**
     * The same on the way to a tone curve, where hundredths of a pixel do not matter.
     *
     * @param image the same image
     * @param pattern white cells; kept, not copied
     * @return whether all sides were found
     */
    boolean refitNearly(GreyImage image, boolean[] pattern) {
        white = pattern;
        settledPx = SideFit.NEARLY_SETTLED_PX;
        return passes(image, MAX_PASSES, BAND_STILL_GOOD_PX);
    }

    /**
     * Fits anew from the corners of the first fit on: the way to a tone curve may lead into a corner.
     *
     * @param image the same image
     * @param shift of the edges that the other markers show, px into the dark
     * @return whether all sides were found
     */
    boolean fitAnew(GreyImage image, double shift) {
        System.arraycopy(before, 0, ideal, 0, 2 * CORNERS);
        for (SideFit side : sides) {
            side.restart();
        }
        shiftPx = shift;
        settledPx = SideFit.SETTLED_PX;
        return passes(image, MAX_PASSES, BAND_STILL_GOOD_PX);
    }

    /**
     * Fits the same pixels again with another tone curve: enough on the way to one.
     *
     * @return whether all sides were found
     */
    boolean refitSamePixels() {
        settledPx = SideFit.NEARLY_SETTLED_PX;
        for (SideFit side : sides) {
            profile.turn(side.normalX, side.normalY);
            if (!side.fit(scale, profile, FIRST_BLUR_PX, settledPx)) {
                return false;
            }
        }
        for (int i = 0; i < CORNERS; i++) {
            if (!intersect((i + CORNERS - 1) % CORNERS, i)) {
                return false;
            }
        }
        System.arraycopy(refined, 0, ideal, 0, 2 * CORNERS);
        return true;
    }

    /**
     * Undoes an unsharp mask in the grey values that all later fits go by; an amount of 0 takes the photo as it is.
     *
     * @param image the same image
     * @param amount of the mask, at least 0
     * @param radiusPx deviation of its Gaussian, px
     */
    void unsharpen(GreyImage image, double amount, double radiusPx) {
        unsharpened = amount > 0;
        if (!unsharpened) {
            return;
        }
        double lowU = Double.POSITIVE_INFINITY;
        double highU = Double.NEGATIVE_INFINITY;
        double lowV = Double.POSITIVE_INFINITY;
        double highV = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < 4 * CORNERS; k++) {
            int i = k / 4;
            int j = (i + 1) % CORNERS;
            double f = 0.25 * (k % 4);
            toImage(ideal[2 * i] + f * (ideal[2 * j] - ideal[2 * i]),
                    ideal[2 * i + 1] + f * (ideal[2 * j + 1] - ideal[2 * i + 1]), point, 0);
            lowU = Math.min(lowU, point[0]);
            highU = Math.max(highU, point[0]);
            lowV = Math.min(lowV, point[1]);
            highV = Math.max(highV, point[1]);
        }
        double margin = SURROUNDINGS_PX + SURROUNDINGS_RADII * radiusPx;
        levels.undo(image, Math.max(0, (int) (lowU - margin)), Math.max(0, (int) (lowV - margin)),
                Math.min(image.widthPx() - 1, (int) (highU + margin)),
                Math.min(image.heightPx() - 1, (int) (highV + margin)), amount, radiusPx, darkGrey(), brightGrey(),
                Math.sqrt(blurPx() * blurPx() + PIXEL_VARIANCE));
    }

    /**
     * Asks the sides what they say of the tone curve and of an unsharp mask: see {@link SideFit#sharpness}.
     *
     * @param amount of the mask that was undone, at least 0
     * @param radiusPx deviation of its Gaussian, px
     */
    void sharpness(double amount, double radiusPx) {
        for (SideFit side : sides) {
            profile.turn(side.normalX, side.normalY);
            side.sharpness(scale, profile, step, amount, radiusPx);
        }
    }

    /** Turns what is known of the marker so that corner k becomes the first. */
    void turn(int k) {
        if (k == 0) {
            return;
        }
        double[] turned = new double[2 * CORNERS];
        SideFit[] turnedSides = new SideFit[CORNERS];
        for (int i = 0; i < CORNERS; i++) {
            turned[2 * i] = ideal[2 * ((i + k) % CORNERS)];
            turned[2 * i + 1] = ideal[2 * ((i + k) % CORNERS) + 1];
            turnedSides[i] = sides[(i + k) % CORNERS];
        }
        System.arraycopy(turned, 0, ideal, 0, turned.length);
        for (int i = 0; i < CORNERS; i++) {
            turned[2 * i] = before[2 * ((i + k) % CORNERS)];
            turned[2 * i + 1] = before[2 * ((i + k) % CORNERS) + 1];
        }
        System.arraycopy(turned, 0, before, 0, turned.length);
        System.arraycopy(turnedSides, 0, sides, 0, CORNERS);
    }

    private boolean passes(GreyImage image, int most, double stillGoodPx) {
        for (int pass = 0; pass < most; pass++) {
            if (!setHomography()) {
                return false;
            }
            double centreX = (ideal[0] + ideal[2] + ideal[4] + ideal[6]) / CORNERS;
            double centreY = (ideal[1] + ideal[3] + ideal[5] + ideal[7]) / CORNERS;
            double blurMoved = 0;
            for (int i = 0; i < CORNERS; i++) {
                double blur = sides[i].unknowns[SideFit.BLUR];
                if (!setSide(i, centreX, centreY) || !fitSide(image, i)) {
                    return false;
                }
                blurMoved = Math.max(blurMoved, Math.abs(sides[i].unknowns[SideFit.BLUR] - blur));
            }
            double moved = 0;
            for (int i = 0; i < CORNERS; i++) {
                if (!intersect((i + CORNERS - 1) % CORNERS, i)) {
                    return false;
                }
                moved = Math.max(moved, Math.hypot(refined[2 * i] - ideal[2 * i], refined[2 * i + 1]
                        - ideal[2 * i + 1]));
                if (!(Math.hypot(refined[2 * i] - before[2 * i], refined[2 * i + 1] - before[2 * i + 1])
                        <= FURTHEST_MOVE_PX)) {
                    return false;
                }
            }
            System.arraycopy(refined, 0, ideal, 0, 2 * CORNERS);
            setLamp();
            if (moved < stillGoodPx && blurMoved < 0.4 * stillGoodPx) {
                return true;
            }
        }
        return true;
    }

    private void clearLamp() {
        lampX = 0;
        lampY = 0;
        Arrays.fill(lampXByBright, 0);
        Arrays.fill(lampYByBright, 0);
    }

    /**
     * How the lamp's light changes over the marker, by least squares from the white beside the four sides. Lenses
     * darken the corners of images, and lamps stand aside: where one end of a side is brighter by a hundredth than the
     * other, a fit that does not know puts corners off by 0.006 px at a blur of 0.7 px.
     */
    private void setLamp() {
        clearLamp();
        double mean = 0;
        double x = 0;
        double y = 0;
        for (SideFit side : sides) {
            if (side.unknowns[SideFit.BRIGHT] > BRIGHTEST_FOR_LAMP) {
                // clipped white says nothing of the lamp
                return;
            }
            mean += scale.light(side.unknowns[SideFit.BRIGHT]) / CORNERS;
            x += side.middleX / CORNERS;
            y += side.middleY / CORNERS;
        }
        double xx = 0;
        double xy = 0;
        double yy = 0;
        for (SideFit side : sides) {
            xx += (side.middleX - x) * (side.middleX - x);
            xy += (side.middleX - x) * (side.middleY - y);
            yy += (side.middleY - y) * (side.middleY - y);
        }
        double determinant = xx * yy - xy * xy;
        if (!(mean > 0) || !(determinant > 0)) {
            return;
        }
        double ofX = 0;
        double ofY = 0;
        for (int i = 0; i < CORNERS; i++) {
            double dx = sides[i].middleX - x;
            double dy = sides[i].middleY - y;
            double byX = (yy * dx - xy * dy) / determinant / mean;
            double byY = (xx * dy - xy * dx) / determinant / mean;
            double light = scale.light(sides[i].unknowns[SideFit.BRIGHT]);
            double byGrey = scale.lightByGrey(sides[i].unknowns[SideFit.BRIGHT]);
            ofX += byX * light;
            ofY += byY * light;
            lampXByBright[i] = byX * byGrey;
            lampYByBright[i] = byY * byGrey;
        }
        if (Math.hypot(ofX, ofY) * sides[0].lengthPx > STEEPEST_LAMP) {
            // the edge of a shadow, and no even change
            clearLamp();
            return;
        }
        lampX = ofX;
        lampY = ofY;
    }

    /**
     * The corners.
     *
     * @param out receives 8 values, distorted px
     */
    void corners(double[] out) {
        for (int i = 0; i < CORNERS; i++) {
            toImage(ideal[2 * i], ideal[2 * i + 1], out, 2 * i);
        }
    }

    /** Mean grey value of the black border. */
    double darkGrey() {
        return mean(SideFit.DARK);
    }

    /** Mean grey value of the white around the border, where it is clipped continued beyond 255. */
    double brightGrey() {
        return mean(SideFit.BRIGHT);
    }

    /** Optical blur of the sides, mean standard deviation, px. */
    double blurPx() {
        return mean(SideFit.BLUR);
    }

    private double mean(int unknown) {
        double sum = 0;
        for (SideFit side : sides) {
            sum += side.unknowns[unknown] / CORNERS;
        }
        return sum;
    }

    /** One side, from corner i to the next. */
    SideFit side(int i) {
        return sides[i];
    }

    /** Length of a cell in the image, of the shortest side, px. */
    double cellPx() {
        double shortest = Double.POSITIVE_INFINITY;
        for (SideFit side : sides) {
            shortest = Math.min(shortest, side.lengthPx);
        }
        return shortest / grid.cells();
    }

    // ---- geometry

    private boolean toIdeal(double u, double v, double[] out, int at) {
        if (!distorted) {
            out[at] = u;
            out[at + 1] = v;
            return true;
        }
        if (plane != null) {
            return plane.toPlane(u, v, out, at);
        }
        if (!lens.toRay(intrinsics, u, v, ray)) {
            return false;
        }
        out[at] = intrinsics[PinholeCamera.FX] * ray[0] + intrinsics[PinholeCamera.SKEW] * ray[1]
                + intrinsics[PinholeCamera.CX];
        out[at + 1] = intrinsics[PinholeCamera.FY] * ray[1] + intrinsics[PinholeCamera.CY];
        return true;
    }

    /** Forgets undistorted places; those of pixels about the corners will be kept. */
    private void clearCache(double[] cornersPx) {
        double lowU = Double.POSITIVE_INFINITY;
        double highU = Double.NEGATIVE_INFINITY;
        double lowV = Double.POSITIVE_INFINITY;
        double highV = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < CORNERS; i++) {
            lowU = Math.min(lowU, cornersPx[2 * i]);
            highU = Math.max(highU, cornersPx[2 * i]);
            lowV = Math.min(lowV, cornersPx[2 * i + 1]);
            highV = Math.max(highV, cornersPx[2 * i + 1]);
        }
        cachedX = (int) lowU - CACHE_MARGIN_PX;
        cachedY = (int) lowV - CACHE_MARGIN_PX;
        cachedWidth = (int) highU + CACHE_MARGIN_PX - cachedX;
        cachedHeight = (int) highV + CACHE_MARGIN_PX - cachedY;
        if ((long) cachedWidth * cachedHeight > MOST_CACHED) {
            cachedWidth = 0;
            cachedHeight = 0;
        }
        int size = 2 * cachedWidth * cachedHeight;
        if (cached.length < size) {
            cached = new double[size];
        }
        Arrays.fill(cached, 0, size, Double.NaN);
    }

    /** The undistorted place of a pixel's centre, into {@link #point}. */
    private boolean toIdealCached(int x, int y) {
        int column = x - cachedX;
        int row = y - cachedY;
        if (column < 0 || row < 0 || column >= cachedWidth || row >= cachedHeight) {
            return toIdeal(x + 0.5, y + 0.5, point, 0);
        }
        int at = 2 * (row * cachedWidth + column);
        if (Double.isNaN(cached[at])) {
            if (!toIdeal(x + 0.5, y + 0.5, point, 0)) {
                return false;
            }
            cached[at] = point[0];
            cached[at + 1] = point[1];
        }
        point[0] = cached[at];
        point[1] = cached[at + 1];
        return true;
    }

    private void toImage(double x, double y, double[] out, int at) {
        if (!distorted) {
            out[at] = x;
            out[at + 1] = y;
            return;
        }
        if (plane != null) {
            plane.toImage(x, y, out, at);
            return;
        }
        double yn = (y - intrinsics[PinholeCamera.CY]) / intrinsics[PinholeCamera.FY];
        double xn = (x - intrinsics[PinholeCamera.CX] - intrinsics[PinholeCamera.SKEW] * yn)
                / intrinsics[PinholeCamera.FX];
        lens.project(intrinsics, xn, yn, 1, out, at);
    }

    private boolean setHomography() {
        return Homography.ofUnitSquare(ideal, homography);
    }

    private boolean setSide(int i, double centreX, double centreY) {
        SideFit side = sides[i];
        int j = (i + 1) % CORNERS;
        double x0 = ideal[2 * i];
        double y0 = ideal[2 * i + 1];
        double length = Math.hypot(ideal[2 * j] - x0, ideal[2 * j + 1] - y0);
        if (!(length > SHORTEST_SIDE_PX)) {
            return false;
        }
        side.tangentX = (ideal[2 * j] - x0) / length;
        side.tangentY = (ideal[2 * j + 1] - y0) / length;
        side.normalX = -side.tangentY;
        side.normalY = side.tangentX;
        if (side.normalX * (centreX - x0) + side.normalY * (centreY - y0) > 0) {
            side.normalX = side.tangentY;
            side.normalY = -side.tangentX;
        }
        side.middleX = x0 + side.tangentX * length / 2;
        side.middleY = y0 + side.tangentY * length / 2;
        side.lengthPx = length;
        double blur = side.started() ? side.unknowns[SideFit.BLUR] : FIRST_BLUR_PX;
        side.halfLengthPx = length / 2 - SideBand.cornerMarginPx(length, blur);
        return true;
    }

    /** The cell at a place along a side and a depth of rows from it. */
    private boolean whiteCell(int i, int row, int along) {
        switch (i) {
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

    /** A point of the marker, a along side i (0 to 1) and z deep, in the side's coordinates: along it and inwards. */
    private void fromSide(int i, double a, double z, SideFit side) {
        double x;
        double y;
        switch (i) {
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
        double px = (homography[0] * x + homography[1] * y + homography[2]) / w - side.middleX;
        double py = (homography[3] * x + homography[4] * y + homography[5]) / w - side.middleY;
        point[0] = px * side.tangentX + py * side.tangentY;
        point[1] = -(px * side.normalX + py * side.normalY);
    }

    /** How far the line before a row moves outwards with the outline, per px of each of the four sides. */
    private double frame(int row) {
        return 1 - 2 * grid.line(grid.borderBands() + row) / grid.cells();
    }

    private void setPattern(int i) {
        SideFit side = sides[i];
        rows = Math.min(ROWS, grid.codeCells());
        double stretch = 1 + 2 * shiftPx / side.lengthPx;
        for (int r = 0; r <= rows; r++) {
            double z = grid.line(grid.borderBands() + r) / grid.cells();
            fromSide(i, 0.2, z, side);
            double t0 = point[0];
            double d0 = point[1];
            fromSide(i, 0.8, z, side);
            depthSlope[r] = (point[1] - d0) / (point[0] - t0);
            // the true outline lies outside the one that is seen, and what hangs on it likewise
            depth[r] = d0 - depthSlope[r] * t0 - frame(r) * shiftPx;
        }
        for (int r = 0; r < rows; r++) {
            int count = 0;
            boolean inWhite = false;
            for (int k = 0; k <= bands; k++) {
                boolean here = k < bands && whiteCell(i, grid.borderBands() + r, k);
                if (here != inWhite) {
                    fromSide(i, grid.line(k) / grid.cells(), grid.line(grid.borderBands() + r) / grid.cells(), side);
                    double t0 = point[0];
                    double z0 = point[1];
                    fromSide(i, grid.line(k) / grid.cells(), grid.line(grid.borderBands() + r + 1) / grid.cells(),
                            side);
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
    }

    /**
     * How white each row is at a place along the side, and how that changes where white spreads or all is stretched.
     * Only the rows that are seen there: of all deeper ones {@link EdgeProfile} would find none.
     */
    private void setRowWhites(double t, double depthPx, double blur, double reach, double perLength) {
        double deepest = depthPx + DEEPEST / REACH * reach + Math.abs(shiftPx);
        rowsSeen = 0;
        while (rowsSeen < rows && depth[rowsSeen] + depthSlope[rowsSeen] * t < deepest) {
            rowsSeen++;
        }
        for (int r = 0; r < rowsSeen; r++) {
            double sum = 0;
            double growth = 0;
            double stretch = 0;
            double byBlur = 0;
            double[] at = ends[r];
            double seenAt = endCount[r] == 0 ? depthPx : depthSeen(r, t, depthPx, reach / REACH);
            for (int k = 0; k < endCount[r]; k++) {
                double end = at[k] + endSlope[r][k] * seenAt;
                double z = (t - end) * endCosine[r][k];
                double sign = (k & 1) == 0 ? 1 : -1;
                if (z >= reach) {
                    sum += sign;
                } else if (z > -reach) {
                    // a pixel is as wide along a side as across it
                    profile.at(z, blur);
                    sum += sign * profile.share;
                    byBlur += sign * profile.byBlur;
                    growth += profile.byDistance;
                    stretch -= sign * profile.byDistance * end * perLength;
                }
            }
            rowWhite[r] = sum;
            rowByBlur[r] = byBlur;
            rowGrowth[r] = growth;
            rowStretch[r] = stretch;
        }
    }

    /**
     * Mean depth of what a pixel sees of a row: that of a normal distribution about the pixel's own depth between the
     * lines before and behind the row (Johnson, Kotz, Balakrishnan, "Continuous Univariate Distributions", volume 1,
     * 1994, section 13.10.1). A pixel that looks across the edge of a slanted cell sees its ends where the cell is, not
     * where the pixel is: taken there, markers tilted by 30 degrees feigned a shift of 0.01 px.
     */
    private double depthSeen(int row, double t, double depthPx, double std) {
        double from = (depth[row] + depthSlope[row] * t - depthPx) / std;
        double to = row == rows - 1 ? REACH : (depth[row + 1] + depthSlope[row + 1] * t - depthPx) / std;
        double seen = EdgeProfile.tabulated(to) - EdgeProfile.tabulated(from);
        if (!(seen > LEAST_SEEN)) {
            return depthPx + std * (from > 0 ? from : Math.min(0, to));
        }
        return depthPx + std * (EdgeProfile.density(from) - EdgeProfile.density(to)) / seen;
    }

    private void setLampOf(SideFit side) {
        side.lampAlong = lampX * side.tangentX + lampY * side.tangentY;
        side.lampAcross = lampX * side.normalX + lampY * side.normalY;
    }

    // ---- one side

    private boolean fitSide(GreyImage image, int i) {
        SideFit side = sides[i];
        double blur = !side.started() ? FIRST_BLUR_PX : side.unknowns[SideFit.BLUR];
        double std = Math.sqrt(blur * blur + PIXEL_VARIANCE);
        profile.turn(side.normalX, side.normalY);
        setPattern(i);
        findPaper(image, side, std);
        double band = SideBand.halfWidthPx(blur);
        double inner = Math.min(band, depth[0] - 0.5);
        double outer = Math.min(band, Math.max(1, paperPx - 0.3));
        side.clear(blur);
        setLampOf(side);
        collect(image, i, inner, outer, blur, std);
        return side.fit(scale, profile, FIRST_BLUR_PX, settledPx);
    }

    /**
     * Looks for the edge of the paper: a dark step beside the marker's own, blurred alike. The light's profile
     * outwards, a mean over seven places along the side, is fitted by white, ground and the place of the edge
     * (Gauss-Newton).
     */
    private void findPaper(GreyImage image, SideFit side, double std) {
        double most = Double.NEGATIVE_INFINITY;
        int mostAt = 0;
        paperPx = Double.POSITIVE_INFINITY;
        paperShare = 0;
        double[] light = paperLight;
        for (int k = 0; k < PAPER_STEPS; k++) {
            double d = paperDistance(k);
            double sum = 0;
            for (int n = -PAPER_LINES; n <= PAPER_LINES; n++) {
                double t = 0.35 * n * side.lengthPx / PAPER_LINES;
                toImage(side.middleX + side.tangentX * t + side.normalX * d,
                        side.middleY + side.tangentY * t + side.normalY * d, point, 0);
                sum += scale.tabulatedLight(interpolate(image, point[0], point[1]));
            }
            light[k] = sum / (2 * PAPER_LINES + 1);
            if (light[k] > most && d < 2 + 2.5 * std) {
                most = light[k];
                mostAt = k;
            }
        }
        double least = Double.POSITIVE_INFINITY;
        int leastAt = mostAt;
        for (int k = mostAt; k < PAPER_STEPS; k++) {
            if (light[k] < least) {
                least = light[k];
                leastAt = k;
            } else if (light[k] > least + 0.3 * (most - least)) {
                break;
            }
        }
        double dark = side.started() ? scale.light(side.unknowns[SideFit.DARK]) : darkestInside(image, side);
        if (!(most > dark) || most - least < PAPER_CONTRAST * (most - dark)) {
            return;
        }
        double half = (most + least) / 2;
        double edge = Double.NaN;
        for (int k = mostAt + 1; k <= leastAt; k++) {
            if (light[k] < half) {
                edge = paperDistance(k - 1) + PAPER_STEP_PX * (light[k - 1] - half) / (light[k - 1] - light[k]);
                break;
            }
        }
        if (Double.isNaN(edge)) {
            return;
        }
        paperPx = edge;
        paperShare = Math.min(1.2, (most - least) / (most - dark));
        if (edge < FAR_BLURS * std + SideBand.HALF_WIDTH_PX) {
            fitPaper(dark, most, least, edge, leastAt, Math.sqrt(std * std + INTERPOLATION_VARIANCE));
        }
    }

    private static double paperDistance(int step) {
        return 0.5 + PAPER_STEP_PX * step;
    }

    /**
     * White, ground and place of the edge, by least squares over the profile as far as the ground is plain. So many
     * rounds and no trials of steps: two of the three unknowns are linear, and a fit that strays is dropped.
     */
    private void fitPaper(double dark, double firstWhite, double firstGround, double firstEdge, int last, double std) {
        double bright = firstWhite;
        double ground = firstGround;
        double edge = firstEdge;
        double[] n = normal;
        double[] g = gradient;
        for (int round = 0; round < PAPER_ROUNDS; round++) {
            Arrays.fill(n, 0);
            Arrays.fill(g, 0);
            for (int k = 0; k <= last; k++) {
                double d = paperDistance(k);
                double marker = EdgeProfile.tabulated(d / std);
                double z = (d - edge) / std;
                double beyond = EdgeProfile.tabulated(z);
                double residual = dark + (bright - dark) * marker - (bright - ground) * beyond - paperLight[k];
                double byBright = marker - beyond;
                double byEdge = (bright - ground) * EdgeProfile.density(z) / std;
                g[0] += byBright * residual;
                g[1] += beyond * residual;
                g[2] += byEdge * residual;
                n[0] += byBright * byBright;
                n[3] += beyond * byBright;
                n[4] += beyond * beyond;
                n[6] += byEdge * byBright;
                n[7] += byEdge * beyond;
                n[8] += byEdge * byEdge;
            }
            for (int a = 0; a < 3; a++) {
                n[4 * a] *= 1.001;
            }
            if (!Cholesky.factor(n, 3)) {
                return;
            }
            Cholesky.solveLower(n, 3, g);
            Cholesky.solveUpper(n, 3, g);
            bright -= g[0];
            ground -= g[1];
            edge -= g[2];
        }
        if (bright > dark && ground < bright && Math.abs(edge - firstEdge) < 1.5) {
            paperPx = edge;
            paperShare = (bright - ground) / (bright - dark);
        }
    }

    private double darkestInside(GreyImage image, SideFit side) {
        toImage(side.middleX - side.normalX * depth[0] / 2, side.middleY - side.normalY * depth[0] / 2, point, 0);
        return scale.tabulatedLight(interpolate(image, point[0], point[1]));
    }

    private double interpolate(GreyImage image, double u, double v) {
        return unsharpened ? levels.interpolate(u, v) : image.interpolate(u, v);
    }

    /** Gathers the pixels whose centres lie in the band about a side, in its coordinates. */
    private void collect(GreyImage image, int i, double inner, double outer, double blur, double std) {
        SideFit side = sides[i];
        setBounds(image, side, side.halfLengthPx, inner, outer);
        double inverseStd = 1 / std;
        for (int k = 0; k < 2; k++) {
            cornerAt[k] = (k - 0.5) * side.lengthPx;
            fromSide(i, k, 0.5, side);
            cornerSlope[k] = (point[0] - cornerAt[k]) / point[1];
            cornerCosine[k] = 1 / Math.sqrt(1 + cornerSlope[k] * cornerSlope[k]);
        }
        for (int y = firstY; y <= lastY; y++) {
            for (int x = firstX; x <= lastX; x++) {
                if (!toSide(x, y, side)) {
                    continue;
                }
                double t = point[0];
                double d = point[1];
                if (d < -inner || d > outer || t < -side.halfLengthPx || t > side.halfLengthPx) {
                    continue;
                }
                double window = window(t, -d, std, inverseStd);
                double more = 0;
                innerByBlur = 0;
                if (-d > depth[0] + depthSlope[0] * t - REACH * std) {
                    more += innerShare(t, -d, blur, REACH * std);
                }
                if (d > paperPx - REACH * std) {
                    more -= paperShare * EdgeProfile.tabulated((d - paperPx) * inverseStd);
                }
                if (unsharpened) {
                    side.add(t, d, levels.get(x, y), levels.floor(x, y), levels.cap(x, y), window, more, innerByBlur);
                } else {
                    side.add(t, d, image.get(x, y), 0, WHITE, window, more, innerByBlur);
                }
            }
        }
    }

    /**
     * Share of the dark that a pixel would see of a side without ends which lies between the ends of this one.
     *
     * <p>Seen aslant, the next sides do not stand at right angles on this one: they end it where the dark lies that the
     * pixel sees. That is deeper than its centre where it looks across the edge: the mean of the half of a normal
     * distribution (Johnson, Kotz, Balakrishnan, "Continuous Univariate Distributions", volume 1, 1994, section
     * 13.10.1).
     */
    private double window(double t, double z, double std, double inverseStd) {
        double seen = EdgeProfile.tabulated(z * inverseStd);
        double depthOfDark = seen < LEAST_SEEN ? 0 : z + std * EdgeProfile.density(z * inverseStd) / seen;
        double first = t - cornerAt[0] - cornerSlope[0] * depthOfDark;
        double second = cornerAt[1] + cornerSlope[1] * depthOfDark - t;
        return EdgeProfile.tabulated(first * cornerCosine[0] * inverseStd)
                + EdgeProfile.tabulated(second * cornerCosine[1] * inverseStd) - 1;
    }

    /** Light from the white cells of the pattern at a place along a side and a depth. */
    private double innerShare(double t, double z, double blur, double reach) {
        setRowWhites(t, z, blur, reach, 0);
        double share = 0;
        double beforeRow = 0;
        double beforeByBlur = 0;
        for (int r = 0; r < rowsSeen; r++) {
            double change = rowWhite[r] - beforeRow;
            if (change > 1e-4 || change < -1e-4) {
                profile.at(z - depth[r] - depthSlope[r] * t + (change > 0 ? shiftPx : -shiftPx), blur);
                share += change * profile.share;
                innerByBlur += change * profile.byBlur + (rowByBlur[r] - beforeByBlur) * profile.share;
            }
            beforeRow = rowWhite[r];
            beforeByBlur = rowByBlur[r];
        }
        return share;
    }

    /** The pixels that a band may touch: bent by the lens, so points between its ends count too. */
    private void setBounds(GreyImage image, SideFit side, double halfLength, double inner, double outer) {
        double lowU = Double.POSITIVE_INFINITY;
        double highU = Double.NEGATIVE_INFINITY;
        double lowV = Double.POSITIVE_INFINITY;
        double highV = Double.NEGATIVE_INFINITY;
        for (int k = 0; k <= 8; k++) {
            double t = halfLength * (k - 4) / 4;
            for (int n = 0; n < 2; n++) {
                double d = n == 0 ? -inner : outer;
                toImage(side.middleX + side.tangentX * t + side.normalX * d,
                        side.middleY + side.tangentY * t + side.normalY * d, point, 0);
                lowU = Math.min(lowU, point[0]);
                highU = Math.max(highU, point[0]);
                lowV = Math.min(lowV, point[1]);
                highV = Math.max(highV, point[1]);
            }
        }
        firstX = Math.max(0, (int) Math.floor(lowU) - 1);
        lastX = Math.min(image.widthPx() - 1, (int) Math.ceil(highU) + 1);
        firstY = Math.max(0, (int) Math.floor(lowV) - 1);
        lastY = Math.min(image.heightPx() - 1, (int) Math.ceil(highV) + 1);
    }

    /** A pixel's centre in coordinates of a side: along it and outwards. */
    private boolean toSide(int x, int y, SideFit side) {
        double px = x + 0.5;
        double py = y + 0.5;
        if (distorted) {
            if (!toIdealCached(x, y)) {
                return false;
            }
            px = point[0];
            py = point[1];
        }
        px -= side.middleX;
        py -= side.middleY;
        point[0] = px * side.tangentX + py * side.tangentY;
        point[1] = px * side.normalX + py * side.normalY;
        return true;
    }

    /** Puts the meeting point of sides i and j at corner j of {@link #refined}. */
    private boolean intersect(int i, int j) {
        setLine(i);
        setLine(j);
        double determinant = line[3 * i] * line[3 * j + 1] - line[3 * j] * line[3 * i + 1];
        if (Math.abs(determinant) < 1e-3) {
            return false;
        }
        refined[2 * j] = (line[3 * i + 1] * line[3 * j + 2] - line[3 * j + 1] * line[3 * i + 2]) / determinant;
        refined[2 * j + 1] = (line[3 * j] * line[3 * i + 2] - line[3 * i] * line[3 * j + 2]) / determinant;
        return true;
    }

    /** The line of a side as a x + b y + c = 0: across = offset + slope along, in the side's own coordinates. */
    private void setLine(int i) {
        SideFit side = sides[i];
        double slope = side.unknowns[SideFit.SLOPE];
        double a = side.normalX - slope * side.tangentX;
        double b = side.normalY - slope * side.tangentY;
        line[3 * i] = a;
        line[3 * i + 1] = b;
        line[3 * i + 2] = -(a * side.middleX + b * side.middleY) - side.unknowns[SideFit.OFFSET];
    }

    // ---- what the fit says of itself

    /**
     * Evaluates what the fits say of themselves.
     *
     * @param withPower whether the power of the curve is asked for
     * @return false where the information of a side is singular
     */
    boolean conclude(boolean withPower) {
        for (SideFit side : sides) {
            profile.turn(side.normalX, side.normalY);
            if (!side.conclude(scale, profile, withPower)) {
                return false;
            }
        }
        return true;
    }

    /**
     * Measures, at the solution, the shift common to all edges from the border's inner edge and the cells behind it.
     *
     * <p>Linear steps from the shift found before, black and white of the inner cells free. With every edge moved into
     * the dark by s, the true outline lies s outside the one that is seen, and all that hangs on it moves along; and
     * white cells are s larger on all sides.
     */
    void measureShift(GreyImage image) {
        setHomography();
        for (int i = 0; i < MAX_SHIFT_STEPS; i++) {
            double from = shiftPx;
            stepShift(image);
            if (!shiftMeasured || Math.abs(shiftPx - from) < LINEAR_SHIFT_PX) {
                return;
            }
        }
    }

    private void stepShift(GreyImage image) {
        double[] n = normal;
        double[] g = gradient;
        Arrays.fill(n, 0);
        Arrays.fill(g, 0);
        for (int i = 0; i < CORNERS; i++) {
            Arrays.fill(byOwn[i], 0);
            Arrays.fill(byOwnAlong[i], 0);
            Arrays.fill(byOwnBlur[i], 0);
            SideFit side = sides[i];
            double blur = side.unknowns[SideFit.BLUR];
            double std = Math.sqrt(blur * blur + PIXEL_VARIANCE);
            profile.turn(side.normalX, side.normalY);
            setPattern(i);
            double cell = side.lengthPx / grid.cells();
            double band = Math.max(1.5, 2 * std);
            double shallow = Math.max(depth[0] - band, depth[0] / 2);
            double deep = Math.min(depth[0] + band, depth[0] + 0.7 * cell);
            double halfLength = side.lengthPx / 2 - grid.borderCells() * cell;
            double lightDark = scale.light(side.unknowns[SideFit.DARK]);
            double contrast = scale.light(side.unknowns[SideFit.BRIGHT]) - lightDark;
            double darkSlope = scale.lightByGrey(side.unknowns[SideFit.DARK]);
            double brightSlope = scale.lightByGrey(side.unknowns[SideFit.BRIGHT]);
            setBounds(image, side, halfLength, deep, -shallow);
            for (int y = firstY; y <= lastY; y++) {
                for (int x = firstX; x <= lastX; x++) {
                    if (!toSide(x, y, side)) {
                        continue;
                    }
                    double t = point[0];
                    double z = -point[1];
                    if (z < shallow || z > deep || t < -halfLength || t > halfLength) {
                        continue;
                    }
                    setRowWhites(t, z, blur, REACH * std, 2 / side.lengthPx);
                    double share = 0;
                    double bySlide = 0;
                    double byShift = 0;
                    double ofBlur = 0;
                    double beforeRow = 0;
                    double beforeGrowth = 0;
                    double beforeByBlur = 0;
                    for (int r = 0; r < rowsSeen; r++) {
                        double change = rowWhite[r] - beforeRow;
                        profile.at(z - depth[r] - depthSlope[r] * t + (change > 0 ? shiftPx : -shiftPx), blur);
                        double lateral = rowGrowth[r] + rowStretch[r];
                        share += change * profile.share;
                        bySlide += change * profile.byDistance;
                        byShift += (Math.abs(change) + change * frame(r)) * profile.byDistance
                                + (lateral - beforeGrowth) * profile.share;
                        ofBlur += change * profile.byBlur + (rowByBlur[r] - beforeByBlur) * profile.share;
                        beforeRow = rowWhite[r];
                        beforeGrowth = lateral;
                        beforeByBlur = rowByBlur[r];
                    }
                    if (z < REACH * std) {
                        profile.at(-z - side.unknowns[SideFit.OFFSET] - side.unknowns[SideFit.SLOPE] * t, blur);
                        share += profile.share;
                        ofBlur += profile.byBlur;
                    }
                    double lamp = 1 + side.lampAlong * t - side.lampAcross * z;
                    double residual;
                    if (unsharpened) {
                        scale.at(lamp * (lightDark + contrast * share), levels.floor(x, y), levels.cap(x, y));
                        residual = scale.grey - levels.get(x, y);
                    } else {
                        scale.at(lamp * (lightDark + contrast * share));
                        residual = scale.grey - image.get(x, y);
                    }
                    double byLight = scale.byLight * lamp;
                    double byShare = byLight * contrast;
                    shiftRow[0] = byShare * byShift;
                    shiftRow[1] = byLight * darkSlope * (1 - share);
                    shiftRow[2] = byLight * brightSlope * share;
                    for (int a = 0; a < 3; a++) {
                        g[a] -= shiftRow[a] * residual;
                        byOwn[i][a] += shiftRow[a] * byShare * bySlide;
                        byOwnAlong[i][a] += shiftRow[a] * byShare * bySlide * t;
                        byOwnBlur[i][a] += shiftRow[a] * byShare * ofBlur;
                        for (int b = 0; b < 3; b++) {
                            n[3 * a + b] += shiftRow[a] * shiftRow[b];
                        }
                    }
                }
            }
        }
        shiftMeasured = false;
        for (int a = 0; a < 3; a++) {
            n[4 * a] += 1e-9;
        }
        if (!Cholesky.inverse(n, 3, factorInverse, inverse) || !(inverse[0] > 0)) {
            return;
        }
        double step = inverse[0] * g[0] + inverse[1] * g[1] + inverse[2] * g[2];
        shiftPx = Math.max(-LARGEST_SHIFT_PX, Math.min(LARGEST_SHIFT_PX, shiftPx + step));
        shiftInformation = 1 / inverse[0];
        // the inner edge of a side follows its own line by 1 - b and the opposite one's by b
        double b = grid.borderCells() / grid.cells();
        for (int i = 0; i < CORNERS; i++) {
            int opposite = (i + 2) % CORNERS;
            double own = 0;
            double ownAlong = 0;
            double other = 0;
            double otherAlong = 0;
            shiftByBlur[i] = 0;
            for (int a = 0; a < 3; a++) {
                own += inverse[a] * byOwn[i][a];
                ownAlong += inverse[a] * byOwnAlong[i][a];
                other += inverse[a] * byOwn[opposite][a];
                otherAlong += inverse[a] * byOwnAlong[opposite][a];
                shiftByBlur[i] -= inverse[a] * byOwnBlur[i][a];
            }
            // a line moved outwards takes the pattern that is expected behind it along: more white is expected, and
            // less shift is found
            shiftByLine[2 * i] = -((1 - b) * own - b * other);
            shiftByLine[2 * i + 1] = -((1 - b) * ownAlong + b * otherAlong);
        }
        shiftMeasured = shiftInformation > 0;
    }

    /** The shift common to all edges, px, positive into the dark; 0 where it could not be measured. */
    double shiftPx() {
        return shiftMeasured ? shiftPx : 0;
    }

    /**
     * Inverse variance of the shift but for errors of the outline, at a variance of the noise, 1/px²; 0: not measured.
     */
    double shiftWeight(double greyVariance) {
        return shiftMeasured ? shiftInformation / greyVariance : 0;
    }

    /**
     * The marker as observed.
     *
     * @param id its id
     * @param noiseGrey standard deviation of each side's noise, 4 values, grey levels
     * @param shiftStdPx what the measured shift may be off by beside noise, px
     * @param inDarkPx how far outlines are known to lie in the dark beside what inner edges show, px
     * @return corners with their covariance and the measured shift
     */
    MarkerObservation observation(int id, double[] noiseGrey, double shiftStdPx, double inDarkPx) {
        for (int j = 0; j < CORNERS; j++) {
            int i = (j + CORNERS - 1) % CORNERS;
            // a corner's other places are zero from the start and stay so
            cornerByLines(j, i, j, byLines);
        }
        linesAndShift(noiseGrey);
        for (int r = 0; r < 8; r++) {
            System.arraycopy(joint, 9 * r, lines, 8 * r, 8);
        }
        times(byLines, lines, half);
        for (int r = 0; r < 8; r++) {
            for (int c = 0; c <= r; c++) {
                double s = 0;
                for (int k = 0; k < 8; k++) {
                    s += half[8 * r + k] * byLines[8 * c + k];
                }
                covariance[8 * r + c] = s;
                covariance[8 * c + r] = s;
            }
        }
        corners(corners);
        if (inDarkPx != 0) {
            double[] inward = EdgeShift.ofCorners(corners);
            for (int r = 0; r < 8; r++) {
                corners[r] -= inDarkPx * inward[r];
            }
        }
        @Nullable EdgeShift shift = null;
        if (shiftMeasured) {
            Arrays.fill(withCorners, 0);
            for (int r = 0; r < 8; r++) {
                for (int k = 0; k < 8; k++) {
                    withCorners[r] += byLines[8 * r + k] * joint[9 * k + 8];
                }
            }
            shift = new EdgeShift(shiftPx, joint[80] + shiftStdPx * shiftStdPx, withCorners);
        }
        return new MarkerObservation(id, corners, covariance, shift);
    }

    /**
     * Fills the covariance of offset and slope of the four lines and of the shift, 9x9 row by row: noise of the sides'
     * own pixels, of the white that tells the lamp, and of the inner edges.
     *
     * <p>All of it from what every side's fit knows of offset, slope, blur and white, through their derivatives, so
     * that no part of it is left out that another has: what errors of white and blur share was, and where lamp and blur
     * are uncertain (dark photos) corners less what they share with the shift then had no covariance any more.
     */
    private void linesAndShift(double[] noiseGrey) {
        Arrays.fill(joint, 0);
        double[] by = bySide;
        int n = SIDE_UNKNOWNS.length;
        for (int i = 0; i < CORNERS; i++) {
            double variance = noiseGrey[i] * noiseGrey[i];
            Arrays.fill(by, 0);
            for (int k = 0; k < CORNERS; k++) {
                double lamp = lampXByBright[i] * sides[k].tangentX + lampYByBright[i] * sides[k].tangentY;
                by[n * 2 * k + BY_BRIGHT] = sides[k].offsetByLamp * lamp;
                by[n * (2 * k + 1) + BY_BRIGHT] = sides[k].slopeByLamp * lamp;
            }
            by[n * 2 * i] = 1;
            by[n * (2 * i + 1) + 1] = 1;
            if (shiftMeasured) {
                // the pattern follows the lines, and the inner edges are as blurred as the outline was found to be
                by[n * 8 + BY_BLUR] = shiftByBlur[i];
                for (int a = 0; a < n; a++) {
                    for (int k = 0; k < 8; k++) {
                        by[n * 8 + a] += shiftByLine[k] * by[n * k + a];
                    }
                }
            }
            for (int r = 0; r < 9; r++) {
                for (int c = 0; c <= r; c++) {
                    double sum = 0;
                    for (int a = 0; a < n; a++) {
                        for (int b = 0; b < n; b++) {
                            sum += by[n * r + a] * sides[i].covariance(SIDE_UNKNOWNS[a], SIDE_UNKNOWNS[b])
                                    * by[n * c + b];
                        }
                    }
                    joint[9 * r + c] += variance * sum;
                }
            }
            if (shiftMeasured) {
                joint[80] += variance / CORNERS / shiftInformation;
            }
        }
        for (int r = 0; r < 9; r++) {
            for (int c = 0; c < r; c++) {
                joint[9 * c + r] = joint[9 * r + c];
            }
        }
    }

    private static void times(double[] a, double[] b, double[] out) {
        Arrays.fill(out, 0);
        for (int r = 0; r < 8; r++) {
            for (int k = 0; k < 8; k++) {
                double v = a[8 * r + k];
                if (v != 0) {
                    for (int c = 0; c < 8; c++) {
                        out[8 * r + c] += v * b[8 * k + c];
                    }
                }
            }
        }
    }

    /** Rows of corner j by the lines (offset, slope) of sides i and j, through the lens. */
    private void cornerByLines(int j, int i, int jSide, double[] out) {
        double x = ideal[2 * j];
        double y = ideal[2 * j + 1];
        double determinant = sides[i].normalX * sides[jSide].normalY - sides[jSide].normalX * sides[i].normalY;
        double[] lens = {1, 0, 0, 1};
        if (distorted) {
            double h = 0.25;
            double[] there = new double[4];
            toImage(x + h, y, there, 0);
            toImage(x - h, y, there, 2);
            lens[0] = (there[0] - there[2]) / (2 * h);
            lens[2] = (there[1] - there[3]) / (2 * h);
            toImage(x, y + h, there, 0);
            toImage(x, y - h, there, 2);
            lens[1] = (there[0] - there[2]) / (2 * h);
            lens[3] = (there[1] - there[3]) / (2 * h);
        }
        for (int n = 0; n < 2; n++) {
            int s = n == 0 ? i : jSide;
            SideFit side = sides[s];
            SideFit other = sides[n == 0 ? jSide : i];
            // the corner stays on the other line: it moves along that line's direction
            double sign = n == 0 ? 1 : -1;
            double dx = sign * other.normalY / determinant;
            double dy = -sign * other.normalX / determinant;
            double t = (x - side.middleX) * side.tangentX + (y - side.middleY) * side.tangentY;
            double u = lens[0] * dx + lens[1] * dy;
            double v = lens[2] * dx + lens[3] * dy;
            out[8 * (2 * j) + 2 * s] = u;
            out[8 * (2 * j + 1) + 2 * s] = v;
            out[8 * (2 * j) + 2 * s + 1] = u * t;
            out[8 * (2 * j + 1) + 2 * s + 1] = v * t;
        }
    }
}
