package org.cellgauge.vision;

import java.util.Arrays;
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
    private static final double FIRST_BAND_STILL_GOOD_PX = 0.5;
    /**
     * How far inwards the sides of BoofCV's squares lie, px: 0.1 to 0.4 at a blur of 0.3 to 0.7 px, by curve and
     * contrast, up to 1.1 where photos are blurred.
     */
    private static final double FIRST_OUTWARDS_PX = 0.3;
    /** Blur of a photo of which nothing is known, px. */
    private static final double FIRST_BLUR_PX = 0.6;
    /** A blur that has changed by more has made the band and the light from elsewhere others, px; and at first. */
    private static final double BLUR_STILL_GOOD_PX = 0.02;
    private static final double FIRST_BLUR_STILL_GOOD_PX = 0.15;
    private static final double FURTHEST_MOVE_PX = 3;
    private static final int SHORTEST_SIDE_PX = 8;
    private static final double LARGEST_SHIFT_PX = 1;
    /** A step of the shift by more than this has left the place where it is linear to a thousandth of a pixel. */
    private static final double LINEAR_SHIFT_PX = 0.02;
    private static final int MAX_SHIFT_STEPS = 4;
    /** How far from an edge its blur is seen, deviations; and from the ends of a side, to a millionth of the light. */
    private static final double REACH = 4;
    private static final double ENDS_REACH = 5;
    /** White from which on it may be clipped, grey levels. */
    private static final double BRIGHTEST_FOR_LAMP = 248;
    /** Change of the light from one end of a marker to the other, as a share of it, that is no lamp's. */
    private static final double STEEPEST_LAMP = 0.3;
    /** A pixel that sees less of the dark has no use for where that lies. */
    private static final double LEAST_SEEN = 1e-5;
    /** Variance that a pixel's own square adds to the blur. */
    static final double PIXEL_VARIANCE = SideBand.PIXEL_VARIANCE;
    /** What lines and shift hang on, of every side. */
    private static final int[] SIDE_UNKNOWNS = {SideFit.OFFSET, SideFit.SLOPE, SideFit.BLUR, SideFit.BRIGHT};
    private static final int BY_BLUR = 2;
    private static final int BY_BRIGHT = 3;

    /** About a marker, where the edge of the paper is looked for, and what a sharpened pixel sees beyond. */
    private static final int SURROUNDINGS_PX = 15;
    private static final int SURROUNDINGS_RADII = 5;

    private final StraightPlane plane;
    private final MarkerGrid grid;
    private final GreyScale scale;
    private final EdgeProfile profile = new EdgeProfile();
    private final SideFit.Work sums = new SideFit.Work();
    private final SideFit[] sides = {new SideFit(sums), new SideFit(sums), new SideFit(sums), new SideFit(sums)};

    private final double[] ideal = new double[2 * CORNERS];
    private final double[] refined = new double[2 * CORNERS];
    private final double[] before = new double[2 * CORNERS];
    private final double[] line = new double[3 * CORNERS];
    private final double[] homography = new double[8];
    private final double[] normal = new double[9];
    private final double[] gradient = new double[3];
    private final double[][] byOwn = new double[CORNERS][3];
    private final double[][] byOwnAlong = new double[CORNERS][3];
    private final double[][] byOwnBlur = new double[CORNERS][3];
    private final double[] factorInverse = new double[9];
    private final double[] inverse = new double[9];
    private final double[] point = new double[2];
    private boolean[] white = new boolean[0];
    /** Grey values with an unsharp mask undone, in force where {@link #unsharpened}. */
    private final Unsharpened levels = new Unsharpened();
    private double settledPx = SideFit.SETTLED_PX;
    private boolean unsharpened;
    private final SharpenedStep step = new SharpenedStep();

    private final EdgeWork.Pool works;

    // the sides before and after the one at hand: where they meet it, their change along it with depth, and its cosine
    private final double[] cornerAt = new double[2];
    private final double[] cornerSlope = new double[2];
    private final double[] cornerCosine = new double[2];

    // change of the lamp's light over the marker as a share of it, 1/px, and how it hangs on the white of each side
    private double lampX;
    private double lampY;
    private final double[] lampXByBright = new double[CORNERS];
    private final double[] lampYByBright = new double[CORNERS];

    private double shiftPx;
    private double shiftInformation;
    private final double[] shiftByLine = new double[2 * CORNERS];
    private final double[] shiftByBlur = new double[CORNERS];
    private boolean shiftMeasured;
    /** Work space of an observation, which copies what it keeps. */
    private final double[] byLines = new double[64];
    private final double[] joint = new double[81];
    private final double[] bySide = new double[9 * SIDE_UNKNOWNS.length];
    private final double[] bySideTimes = new double[SIDE_UNKNOWNS.length];
    private final double[] ofSide = new double[SIDE_UNKNOWNS.length * SIDE_UNKNOWNS.length];
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
     * @param works work space, shared with other markers
     */
    MarkerEdges(PinholeCamera camera, MarkerGrid grid, GreyScale scale, EdgeWork.Pool works) {
        this.scale = scale.another();
        this.plane = new StraightPlane(camera);
        this.grid = grid;
        this.works = works;
    }

    /**
     * Fits the sides of a marker for the first time.
     *
     * @param image the image
     * @param cornersPx 8 values, distorted px, within about a pixel of the corners, in the order of the pattern's
     *     top-left, top-right, bottom-right, bottom-left
     * @param cells white cells, row by row; kept, not copied
     * @return whether all sides were found near where they were looked for
     */
    boolean fit(GreyImage image, double[] cornersPx, boolean[] cells) {
        if (!plane.aim(cornersPx)) {
            return false;
        }
        for (int i = 0; i < CORNERS; i++) {
            if (!plane.toPlane(cornersPx[2 * i], cornersPx[2 * i + 1], ideal, 2 * i)) {
                return false;
            }
            sides[i].restart(FIRST_BLUR_PX);
        }
        System.arraycopy(ideal, 0, before, 0, 2 * CORNERS);
        white = cells;
        shiftPx = 0;
        unsharpened = false;
        clearLamp();
        settledPx = SideFit.FIRST_SETTLED_PX;
        return startOutside() && passes(image, FIRST_BAND_STILL_GOOD_PX, FIRST_BLUR_STILL_GOOD_PX);
    }

    /**
     * Fits again from where the last fit ended, with another tone curve or another reading.
     *
     * @param image the same image
     * @param cells white cells; kept, not copied
     * @return whether all sides were found
     */
    boolean refit(GreyImage image, boolean[] cells) {
        white = cells;
        settledPx = SideFit.SETTLED_PX;
        return passes(image, BAND_STILL_GOOD_PX, BLUR_STILL_GOOD_PX);
    }

    /**
     * The same on the way to a tone curve, where hundredths of a pixel do not matter.
     *
     * @param image the same image
     * @param cells white cells; kept, not copied
     * @return whether all sides were found
     */
    boolean refitNearly(GreyImage image, boolean[] cells) {
        white = cells;
        settledPx = SideFit.NEARLY_SETTLED_PX;
        return passes(image, BAND_STILL_GOOD_PX, BLUR_STILL_GOOD_PX);
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
            side.restart(FIRST_BLUR_PX);
        }
        shiftPx = shift;
        settledPx = SideFit.SETTLED_PX;
        return passes(image, BAND_STILL_GOOD_PX, BLUR_STILL_GOOD_PX);
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
            if (!side.fit(scale, profile, settledPx)) {
                return false;
            }
        }
        return intersectAll();
    }

    /** Where the sides lie and what they are fitted with, for {@link #returnTo}. */
    double[] fitted() {
        double[] fitted = Arrays.copyOf(ideal, ideal.length + CORNERS * SideFit.UNKNOWNS);
        for (int i = 0; i < CORNERS; i++) {
            System.arraycopy(sides[i].unknowns, 0, fitted, ideal.length + i * SideFit.UNKNOWNS, SideFit.UNKNOWNS);
        }
        return fitted;
    }

    /**
     * Puts the sides back to start from there, with pixels that are gathered anew.
     *
     * @param fitted of {@link #fitted}
     */
    void returnTo(double[] fitted) {
        System.arraycopy(fitted, 0, ideal, 0, ideal.length);
        for (int i = 0; i < CORNERS; i++) {
            System.arraycopy(fitted, ideal.length + i * SideFit.UNKNOWNS, sides[i].unknowns, 0, SideFit.UNKNOWNS);
        }
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
            plane.toImage(ideal[2 * i] + f * (ideal[2 * j] - ideal[2 * i]),
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

    /** Takes the sides from where squares are found to where edges mostly are. */
    private boolean startOutside() {
        double centreX = centre(0);
        double centreY = centre(1);
        for (int i = 0; i < CORNERS; i++) {
            if (!setSide(i, centreX, centreY)) {
                return false;
            }
            sides[i].unknowns[SideFit.OFFSET] = FIRST_OUTWARDS_PX;
            sides[i].unknowns[SideFit.SLOPE] = 0;
        }
        return intersectAll();
    }

    private double centre(int axis) {
        return (ideal[axis] + ideal[2 + axis] + ideal[4 + axis] + ideal[6 + axis]) / CORNERS;
    }

    /** Puts the corners where the sides meet. */
    private boolean intersectAll() {
        for (int i = 0; i < CORNERS; i++) {
            if (!intersect((i + CORNERS - 1) % CORNERS, i)) {
                return false;
            }
        }
        System.arraycopy(refined, 0, ideal, 0, 2 * CORNERS);
        return true;
    }

    private boolean passes(GreyImage image, double stillGoodPx, double blurStillGoodPx) {
        EdgeWork work = works.take();
        try {
            return passes(image, stillGoodPx, blurStillGoodPx, work);
        } finally {
            works.giveBack(work);
        }
    }

    private boolean passes(GreyImage image, double stillGoodPx, double blurStillGoodPx, EdgeWork work) {
        for (int pass = 0; pass < MAX_PASSES; pass++) {
            if (!setHomography()) {
                return false;
            }
            double centreX = centre(0);
            double centreY = centre(1);
            double blurMoved = 0;
            for (int i = 0; i < CORNERS; i++) {
                double blur = sides[i].unknowns[SideFit.BLUR];
                if (!setSide(i, centreX, centreY) || !fitSide(image, i, work)) {
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
            if (moved < stillGoodPx && blurMoved < blurStillGoodPx) {
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
            plane.toImage(ideal[2 * i], ideal[2 * i + 1], out, 2 * i);
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
        side.halfLengthPx = length / 2 - SideBand.cornerMarginPx(length, side.unknowns[SideFit.BLUR]);
        return true;
    }

    private void setLampOf(SideFit side) {
        side.lampAlong = lampX * side.tangentX + lampY * side.tangentY;
        side.lampAcross = lampX * side.normalX + lampY * side.normalY;
    }

    // ---- one side

    private boolean fitSide(GreyImage image, int i, EdgeWork work) {
        PatternLight pattern = work.pattern;
        PaperEdge paper = work.paper;
        SideFit side = sides[i];
        double blur = side.unknowns[SideFit.BLUR];
        double std = Math.sqrt(blur * blur + PIXEL_VARIANCE);
        profile.turn(side.normalX, side.normalY);
        pattern.turnTo(i, side, homography, white, shiftPx);
        paper.find(image, levels(), plane, scale, side, std, pattern.borderPx());
        double halfWidth = SideBand.halfWidthPx(blur);
        double inner = Math.min(halfWidth, pattern.borderPx() - 0.5);
        double outer = Math.min(halfWidth, Math.max(1, paper.px - 0.3));
        side.clear(blur);
        setLampOf(side);
        work.band.gather(image, levels(), plane, side, side.halfLengthPx, inner, outer);
        setLightFromElsewhere(work, blur, std);
        addPixels(side, work, inner, std);
        return side.fit(scale, profile, settledPx);
    }

    /** Grey values that fits go by where they are not the image's. */
    private @Nullable Unsharpened levels() {
        return unsharpened ? levels : null;
    }

    /** Light that the pixels of the band see of the pattern inside and of the ground beyond the paper. */
    private void setLightFromElsewhere(EdgeWork work, double blur, double std) {
        PatternLight pattern = work.pattern;
        PaperEdge paper = work.paper;
        BandPixels band = work.band;
        int count = band.count;
        work.reserve(count);
        double[] along = band.along;
        double[] across = band.across;
        double[] more = work.shares;
        double[] moreByBlur = work.ofBlur;
        Arrays.fill(more, 0, count, 0);
        Arrays.fill(moreByBlur, 0, count, 0);
        double from = pattern.borderPx() - REACH * std;
        double slope = pattern.borderSlope();
        int inside = 0;
        for (int k = 0; k < count; k++) {
            if (-across[k] > from + slope * along[k]) {
                work.places[inside] = k;
                work.asked[inside] = along[k];
                work.depths[inside++] = -across[k];
            }
        }
        if (inside > 0) {
            pattern.see(work.asked, work.depths, inside, profile, blur, std, 0);
            for (int j = 0; j < inside; j++) {
                more[work.places[j]] = pattern.share[j];
                moreByBlur[work.places[j]] = pattern.byBlur[j];
            }
        }
        double nearPaper = paper.px - REACH * std;
        double inverseStd = 1 / std;
        for (int k = 0; k < count; k++) {
            if (across[k] > nearPaper) {
                more[k] -= paper.share * EdgeProfile.tabulated((across[k] - paper.px) * inverseStd);
            }
        }
    }

    /** Hands the pixels of the band to the fit. */
    private void addPixels(SideFit side, EdgeWork work, double inner, double std) {
        BandPixels band = work.band;
        for (int k = 0; k < 2; k++) {
            cornerAt[k] = (k - 0.5) * side.lengthPx;
            work.pattern.place(k, 0.5, point);
            cornerSlope[k] = (point[0] - cornerAt[k]) / point[1];
            cornerCosine[k] = 1 / Math.sqrt(1 + cornerSlope[k] * cornerSlope[k]);
        }
        // so far from both ends nothing is seen of them, at whatever depth the dark lies that a pixel sees
        double deepest = inner + 2 * std;
        double first = cornerAt[0] + Math.max(-cornerSlope[0] * std, cornerSlope[0] * deepest)
                + ENDS_REACH * std / cornerCosine[0];
        double last = cornerAt[1] + Math.min(-cornerSlope[1] * std, cornerSlope[1] * deepest)
                - ENDS_REACH * std / cornerCosine[1];
        double inverseStd = 1 / std;
        for (int k = 0; k < band.count; k++) {
            double t = band.along[k];
            double d = band.across[k];
            double window = t > first && t < last ? 1 : window(t, -d, std, inverseStd);
            side.add(t, d, band.grey[k], band.floor[k], band.cap[k], window, work.shares[k], work.ofBlur[k]);
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
        EdgeWork work = works.take();
        try {
            double from = Double.NaN;
            for (int i = 0; i < MAX_SHIFT_STEPS && !(Math.abs(shiftPx - from) < LINEAR_SHIFT_PX); i++) {
                from = shiftPx;
                stepShift(image, work);
                if (!shiftMeasured) {
                    return;
                }
            }
        } finally {
            works.giveBack(work);
        }
    }

    private void stepShift(GreyImage image, EdgeWork work) {
        Arrays.fill(normal, 0);
        Arrays.fill(gradient, 0);
        for (int i = 0; i < CORNERS; i++) {
            Arrays.fill(byOwn[i], 0);
            Arrays.fill(byOwnAlong[i], 0);
            Arrays.fill(byOwnBlur[i], 0);
            seeInnerEdge(image, i, work);
            addInnerEdge(sides[i], work, byOwn[i], byOwnAlong[i], byOwnBlur[i]);
        }
        double[] n = normal;
        double[] g = gradient;
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

    /** Gathers the pixels about the inner edge of the border beside a side, and what light they should have. */
    private void seeInnerEdge(GreyImage image, int i, EdgeWork work) {
        PatternLight pattern = work.pattern;
        BandPixels band = work.band;
        SideFit side = sides[i];
        double blur = side.unknowns[SideFit.BLUR];
        double std = Math.sqrt(blur * blur + PIXEL_VARIANCE);
        profile.turn(side.normalX, side.normalY);
        pattern.turnTo(i, side, homography, white, shiftPx);
        double cell = side.lengthPx / grid.cells();
        double halfWidth = Math.max(1.5, 2 * std);
        double border = pattern.borderPx();
        double shallow = Math.max(border - halfWidth, border / 2);
        double deep = Math.min(border + halfWidth, border + 0.7 * cell);
        double halfLength = side.lengthPx / 2 - grid.borderCells() * cell;
        band.gather(image, levels(), plane, side, halfLength, deep, -shallow);
        int count = band.count;
        work.reserveInner(count);
        double[] along = band.along;
        double[] depth = work.depths;
        for (int k = 0; k < count; k++) {
            depth[k] = -band.across[k];
        }
        pattern.see(along, depth, count, profile, blur, std, 2 / side.lengthPx);
        System.arraycopy(pattern.share, 0, work.shares, 0, count);
        System.arraycopy(pattern.byBlur, 0, work.ofBlur, 0, count);
        double reach = REACH * std;
        if (shallow < reach) {
            double offset = side.unknowns[SideFit.OFFSET];
            double slope = side.unknowns[SideFit.SLOPE];
            for (int k = 0; k < count; k++) {
                work.asked[k] = -depth[k] - offset - slope * along[k];
            }
            profile.at(work.asked, count, blur, work.outlineShares, work.outlineByDistance, work.outlineByBlur);
            for (int k = 0; k < count; k++) {
                boolean seen = depth[k] < reach;
                work.shares[k] += seen ? work.outlineShares[k] : 0;
                work.ofBlur[k] += seen ? work.outlineByBlur[k] : 0;
            }
        }
    }

    /** Adds these pixels to the normal equations of the shift, and to how it hangs on the side's own line and blur. */
    private void addInnerEdge(SideFit side, EdgeWork work, double[] bySlide, double[] bySlideAlong, double[] byBlur) {
        PatternLight pattern = work.pattern;
        BandPixels band = work.band;
        int count = band.count;
        double lightDark = scale.light(side.unknowns[SideFit.DARK]);
        double lightBright = scale.light(side.unknowns[SideFit.BRIGHT]);
        double contrast = lightBright - lightDark;
        double darkSlope = scale.lightByGrey(side.unknowns[SideFit.DARK], lightDark);
        double brightSlope = scale.lightByGrey(side.unknowns[SideFit.BRIGHT], lightBright);
        double lampAlong = side.lampAlong;
        double lampAcross = side.lampAcross;
        double[] along = band.along;
        double[] across = band.across;
        double[] share = work.shares;
        for (int k = 0; k < count; k++) {
            double lamp = 1 + lampAlong * along[k] + lampAcross * across[k];
            work.lights[k] = lamp * (lightDark + contrast * share[k]);
        }
        scale.at(work.lights, band.floor, band.cap, count, work.greys, work.byLights, work.insides);
        double n00 = normal[0];
        double n10 = normal[3];
        double n11 = normal[4];
        double n20 = normal[6];
        double n21 = normal[7];
        double n22 = normal[8];
        double g0 = gradient[0];
        double g1 = gradient[1];
        double g2 = gradient[2];
        for (int k = 0; k < count; k++) {
            double byLight = work.byLights[k] * (1 + lampAlong * along[k] + lampAcross * across[k]);
            double r0 = byLight * contrast * pattern.byShift[k];
            double r1 = byLight * darkSlope * (1 - share[k]);
            double r2 = byLight * brightSlope * share[k];
            double residual = work.greys[k] - band.grey[k];
            n00 += r0 * r0;
            n10 += r1 * r0;
            n11 += r1 * r1;
            n20 += r2 * r0;
            n21 += r2 * r1;
            n22 += r2 * r2;
            g0 -= r0 * residual;
            g1 -= r1 * residual;
            g2 -= r2 * residual;
            double slide = byLight * contrast * pattern.bySlide[k];
            double blurred = byLight * contrast * work.ofBlur[k];
            double t = along[k];
            bySlide[0] += r0 * slide;
            bySlide[1] += r1 * slide;
            bySlide[2] += r2 * slide;
            bySlideAlong[0] += r0 * slide * t;
            bySlideAlong[1] += r1 * slide * t;
            bySlideAlong[2] += r2 * slide * t;
            byBlur[0] += r0 * blurred;
            byBlur[1] += r1 * blurred;
            byBlur[2] += r2 * blurred;
        }
        normal[0] = n00;
        normal[1] = n10;
        normal[2] = n20;
        normal[3] = n10;
        normal[4] = n11;
        normal[5] = n21;
        normal[6] = n20;
        normal[7] = n21;
        normal[8] = n22;
        gradient[0] = g0;
        gradient[1] = g1;
        gradient[2] = g2;
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
            // a corner's other work.places are zero from the start and stay so
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
            for (int a = 0; a < n; a++) {
                for (int b = 0; b < n; b++) {
                    ofSide[n * a + b] = variance * sides[i].covariance(SIDE_UNKNOWNS[a], SIDE_UNKNOWNS[b]);
                }
            }
            addSandwiched(by, ofSide, n);
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

    /** Adds B C B' to the lower half of {@link #joint}, C being n x n. */
    private void addSandwiched(double[] b, double[] c, int n) {
        double[] bc = bySideTimes;
        for (int r = 0; r < 9; r++) {
            for (int k = 0; k < n; k++) {
                double sum = 0;
                for (int a = 0; a < n; a++) {
                    sum += b[n * r + a] * c[n * a + k];
                }
                bc[k] = sum;
            }
            for (int q = 0; q <= r; q++) {
                double sum = 0;
                for (int k = 0; k < n; k++) {
                    sum += bc[k] * b[n * q + k];
                }
                joint[9 * r + q] += sum;
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
        if (plane.isDistorted()) {
            double h = 0.25;
            double[] there = new double[4];
            plane.toImage(x + h, y, there, 0);
            plane.toImage(x - h, y, there, 2);
            lens[0] = (there[0] - there[2]) / (2 * h);
            lens[2] = (there[1] - there[3]) / (2 * h);
            plane.toImage(x, y + h, there, 0);
            plane.toImage(x, y - h, there, 2);
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
