package org.cellgauge.vision;

import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.vision.SideBand;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.warning.Warning;
import org.jspecify.annotations.Nullable;

/**
 * What the edges of all markers of a photo say together of its light: the tone curve, which skews every blurred edge
 * alike, and the noise.
 *
 * <p>The curve is of the kind that the image file says (a power, if it says nothing), its power unknown with a Gaussian
 * prior about what it says; each round fits all sides at one power, sums up score and information of the power with the
 * sides' own unknowns projected out, and takes one Gauss-Newton step (variable projection: Golub and Pereyra, SIAM
 * J. Numer. Anal. 1973). A curve that the user states is taken as it is.
 *
 * <p>Of frames of one camera, what one was found to have is believed of the next until edges contradict it.
 */
final class LightFit {
    private static final double UNKNOWN_POWER = 1.6;
    private static final double UNKNOWN_POWER_STD = 0.8;
    private static final double SAID_POWER_STD = 0.4;
    private static final double LEAST_POWER = 0.7;
    private static final double LARGEST_POWER = 3.2;
    /** How well the skew of edges can tell a power at best. */
    private static final double MODEL_POWER_STD = 0.05;
    /**
     * Edges that move into the dark are mostly the curve's doing: how far prints and sharpening move them beside it,
     * px. So a shift that inner edges show speaks for another power.
     */
    private static final double SHIFT_STD_PX = 0.015;
    private static final double LARGEST_STEP = 0.8;
    /** Edges that have moved by more than this leave the light that was taken as given about them stale, px. */
    private static final double STALE_PX = 0.03;
    /** Where to look first when nothing is known of the curve. */
    private static final double[] SCANNED = {1, 1.6, 2.3};
    /** At a power so near to the one they are fitted at, sides are not fitted again for it. */
    private static final double NEAR_POWER = 0.3;
    /** A first step that moves edges by more than this says that the file's word on its curve is wrong, px. */
    private static final double SURPRISE_PX = 0.1;
    /** And one that changes the mask of the frame before by this amount says that it is gone. */
    private static final double SURPRISE_AMOUNT = 0.25;
    /** And an overshoot that is larger by so much, as a share of the step, says that there is one now. */
    private static final double SURPRISE_OVERSHOOT = 0.01;
    /** A marker whose edges are shifted by so much more than the others', or whose noise is so many times theirs. */
    private static final double ODD_SHIFT_PX = 0.08;
    private static final double NOT_BELIEVED_SHIFT_PX = 0.14;
    private static final double USUAL_SIDE_PX = 60;
    private static final int LEAST_TO_JUDGE = 4;
    private static final double ODD_NOISE = 1.7;
    private static final double CLIPPED_SHARE = 0.1;
    private static final double FAR_TOO_BRIGHT = 3;
    /** Of the pixels beside one side: a bright speck is less, a mirrored lamp more. */
    private static final double GLARE_SHARE = 0.4;
    private static final double CRUSHED_SHARE = 0.4;
    private static final double OVERSHOOT = 0.025;
    /** Difference of white and black below which steps of grey weigh heavily, grey levels. */
    private static final double DARK_CONTRAST = 40;
    /** White from which on a low contrast is the print's doing and not the light's, grey levels. */
    private static final double FAINT_WHITE = 128;
    /** A power this near to the one that the file says bears it out. */
    private static final double CONFIRMED_POWER = 0.35;
    private static final int MOST_MARKERS = 5;
    /** How far about a marker blocks of a JPEG file are looked for, px. */
    private static final int ABOUT_PX = 16;
    /**
     * How far blocks of a JPEG file move outlines into the dark against inner edges, px: for each that the power of the
     * curve is above 1, and for each that differences across borders are larger by. Rendered photos have 0.003, 0.006
     * and 0.010 px at quality 90, 85 and 70 with sRGB's curve and a blur of 0.7 px, a third to a half of it at 0.4 and
     * 1.2 px, and a fifth with a linear one.
     */
    private static final double IN_DARK_BY_BLOCKS_PX = 0.0095;
    /** How far outlines may lie beside that, alike on all markers: rendered photos leave up to 0.005 px. */
    private static final double OUTLINE_STD_IN_BLOCKS_PX = 0.009;
    /** What is rounded off is not independent from pixel to pixel: lines are so many times less well known. */
    private static final double NOISE_IN_BLOCKS = 1.11;
    /** What they move the inner edges of one marker by, px. */
    private static final double SHIFT_STD_IN_BLOCKS_PX = 0.01;
    /**
     * And sharpening that is not quite undone where the noise of flat ground does not tell it, px for a blur of one
     * cell: 0.008 px at a blur of 1.2 px and cells of 3 px, 0.003 px at cells of 6 px.
     */
    private static final double OUTLINE_STD_OF_SHARPENED_PX = 0.022;
    /** Pixels of a side that is so much sharper than the others, as a share of their blur, did not tell its blur. */
    private static final double VANISHED_BLUR = 0.5;
    /** Nor was one whose place is less well known than this, px. */
    private static final double UNTOLD_PX = 0.05;
    /** How alike the blur of sides is, as a share of it: focus, motion and the lens make some more blurred. */
    private static final double EXPECTED_BLUR_STD = 0.25;
    /** Markers by which the curve is looked for first: a start within the reach of Gauss-Newton is enough. */
    private static final int MOST_SCANNED = 3;
    /** Frames of a camera after which its curve is looked for anew all the same: its settings may have changed. */
    private static final int FRAMES_OF_A_SCAN = 30;
    private static final int MAX_ROUNDS = 6;
    /** A change of the power that moves edges by less is none, px. */
    private static final double SETTLED_PX = 0.002;
    /** After a step of the power that moves edges by less, the next would mostly be no change, px. */
    private static final double SETTLING_PX = 0.01;
    /**
     * How far edges may still lie from where a curve puts them, px: curves of cameras are no powers, lenses blur by no
     * Gaussian. Inner edges then tell how far.
     */
    private static final double ESTIMATED_STD_PX = 0.1;
    private static final double STATED_STD_PX = 0.05;
    /** A side whose residuals are so many times those of all is weighed by its own. */
    private static final double OUT_OF_LINE = 3;
    /** Noise before any is measured: what the photo before had must not matter. */
    private static final double FIRST_NOISE_GREY = 1.5;
    /** Noise of rounding to whole grey levels. */
    private static final double ROUNDING = Math.sqrt(1.0 / 12);

    /** Radius of an unsharp mask where nothing tells it, px, and how far others are from it, as a share. */
    private static final double USUAL_RADIUS_PX = 1;
    private static final double RADIUS_STD = 0.5;
    private static final double LEAST_RADIUS_PX = 0.4;
    private static final double LARGEST_RADIUS_PX = 4;
    private static final double USUAL_AMOUNT_STD = 1;
    private static final double LARGEST_AMOUNT = 4;
    /**
     * Below this amount no mask is believed in: lenses blur by no Gaussian. Below so many deviations from 0 it takes
     * noise that bears the mask out, and below the second number none is looked for.
     */
    private static final double LEAST_AMOUNT = 0.12;
    private static final double CERTAIN_DEVIATIONS = 4;
    private static final double LEAST_DEVIATIONS = 1;
    /**
     * Noise that is correlated between pixels beside each other by less than minus this, and so many deviations, is
     * blue: then it tells the mask too.
     */
    private static final double BLUE_CORRELATION = 0.03;
    private static final double BLUE_DEVIATIONS = 2;
    /** Markers that a mask is undone about first, and how much their noise must speak against it to end the search. */
    private static final int MOST_TRIED = 2;
    private static final double RULED_OUT = -3;
    /** Logarithm of a ratio of likelihoods by which noise bears a mask out. */
    private static final double BORNE_OUT = 8;
    /** Share of a band's pixels that the noise is measured by: those on the edge's slope. */
    private static final double PIXELS_ON_SLOPE = 0.3;
    /**
     * What edges that hide a mask say of it is the model's doing as much as the noise's: three times less well known,
     * where the noise tells it too.
     */
    private static final double MODEL_VARIANCE_FACTOR = 9;
    /** How well edges can tell amount and radius at best. */
    private static final double MODEL_AMOUNT_STD = 0.02;
    private static final double MODEL_RADIUS_STD = 0.03;
    private static final int SHAPES = SideFit.SHAPES;
    /** Information of what is stated. */
    private static final double FIXED = 1e12;
    private static final double LARGEST_AMOUNT_STEP = 0.6;
    private static final double LARGEST_RADIUS_STEP = 0.35;
    private static final int MASK_ROUNDS = 8;
    /** Step of numerical derivatives by amount and logarithm of the radius. */
    private static final double DIFFERENCE = 1e-3;
    private static final double SETTLED_AMOUNT = 0.01;
    private static final double SETTLED_RADIUS = 0.02;

    private final GreyScale scale;
    private final SharedLoop loop;
    private ToneCurve curve = ToneCurve.LINEAR;
    /** What the photo before was found to have, and how many were fitted from it on; null where that tells nothing. */
    private @Nullable Found before;
    private int sinceScan;
    /** What the photo at hand is taken to have unless its edges say otherwise; null where all is to be looked for. */
    private @Nullable Found kept;
    private double offsetByPower;
    private double powerInformation;
    private double powerMean;
    private double powerStd;
    private boolean estimated;
    /** Whether the file's word on its curve still stands. */
    private boolean said;
    private boolean fileSaid;
    private double clippedShare;
    private double usualShiftPx = Double.NaN;
    private double noiseGrey;
    private double degreesOfFreedom;
    private double edgeShiftStdPx;
    private double blurPx;
    private double blurInCells;
    private double maskAmount;
    private double maskRadiusPx;
    private double maskOvershoot;
    /** What is seen of sharpening, undone or not, as a share of the step from black to white. */
    private double overshoot;
    /** The same before a mask was looked for, of the markers that tell the curve. */
    private double untouchedOvershoot;
    private double whiteGrey;
    private final FlatNoise flatNoise = new FlatNoise();
    /** Whether the noise of flat ground is blue, as a mask alone makes it. */
    private boolean noiseTells;
    private final double[] ofMask = new double[FlatNoise.LAGS.length];
    private final double[] otherAmount = new double[FlatNoise.LAGS.length];
    private final double[] otherRadius = new double[FlatNoise.LAGS.length];
    private boolean inBlocks;
    private double blocksExcess;
    private final BlockGrid blocks = new BlockGrid();

    /** Of a photo: its curve, its mask, what edges are off by for not knowing both, and whether it has blocks. */
    private static final class Found {
        final ToneCurve curve;
        final double maskAmount;
        final double maskRadiusPx;
        final double maskOvershoot;
        final double ofPowerPx;
        final boolean inBlocks;
        final double blocksExcess;
        final double untouchedOvershoot;

        Found(LightFit of, double ofPowerPx) {
            this.curve = of.curve;
            this.maskAmount = of.maskAmount;
            this.maskRadiusPx = of.maskRadiusPx;
            this.maskOvershoot = of.maskOvershoot;
            this.ofPowerPx = ofPowerPx;
            this.inBlocks = of.inBlocks;
            this.blocksExcess = of.blocksExcess;
            this.untouchedOvershoot = of.untouchedOvershoot;
        }
    }

    /**
     * The light of photos.
     *
     * @param scale receives curve and noise; that of the markers' edges
     * @param loop how markers are gone through
     */
    LightFit(GreyScale scale, SharedLoop loop) {
        this.scale = scale;
        this.loop = loop;
    }

    /**
     * Starts on a photo.
     *
     * @param stated the curve that the user states, or null
     * @param ofFile the curve that the image file says, or null
     * @param isNextFrame whether it is of the same camera as the photo before: then its curve is where to start, and
     *     its mask is taken as it was, unless edges say that they are wrong
     */
    void start(@Nullable ToneCurve stated, @Nullable ToneCurve ofFile, boolean isNextFrame) {
        estimated = stated == null;
        said = ofFile != null;
        fileSaid = said;
        clippedShare = 0;
        inBlocks = false;
        noiseTells = false;
        maskAmount = 0;
        maskRadiusPx = USUAL_RADIUS_PX;
        maskOvershoot = 0;
        overshoot = 0;
        whiteGrey = 255;
        scale.setNoise(FIRST_NOISE_GREY);
        kept = isNextFrame && sinceScan < FRAMES_OF_A_SCAN ? before : null;
        sinceScan = kept == null ? 0 : sinceScan + 1;
        if (stated != null) {
            scale.set(stated);
            return;
        }
        curve = ofFile == null ? ToneCurve.gamma(UNKNOWN_POWER) : ofFile;
        powerMean = curve.power();
        powerStd = ofFile == null ? UNKNOWN_POWER_STD : SAID_POWER_STD;
        if (kept != null && (ofFile == null || kept.maskAmount > 0)) {
            said = true;
            curve = kept.curve;
        }
        scale.set(curve);
    }

    /**
     * Fits the light of a photo to the edges of its markers, and the edges to that light.
     *
     * @param image the photo
     * @param markers edges of its markers, each fitted at the curve that was started with
     * @param patterns what each of them was read as
     */
    void fit(GreyImage image, List<MarkerEdges> markers, List<boolean[]> patterns) {
        // some markers tell the curve as well as all: what is left is the model's
        List<MarkerEdges> some = markers.subList(0, Math.min(MOST_MARKERS, markers.size()));
        double ofPower;
        if (kept != null && kept.maskAmount > 0 && bearOut(kept, image, markers, some, patterns)) {
            ofPower = kept.ofPowerPx;
        } else {
            ofPower = estimated ? findCurve(image, some, patterns) : 0;
            untouchedOvershoot = estimated && !some.isEmpty() ? medianOf(some, side -> side.overshoot) : 0;
            if (kept != null && untouchedOvershoot > kept.untouchedOvershoot + SURPRISE_OVERSHOOT) {
                // sharpened since
                drop();
                curve = curve.withPower(powerMean);
                ofPower = findCurve(image, some, patterns);
            }
            if (kept == null) {
                findBlocks(image, some);
                // what blocks leave of noise and edges looks like a mask's doing, and a refused photo's mask is of no
                // account
                ofPower = inBlocks || isFarTooBright(some) ? ofPower : findMask(image, some, patterns, ofPower);
            } else {
                inBlocks = kept.inBlocks;
                blocksExcess = kept.blocksExcess;
            }
            loop.each(markers.size(), m -> refit(image, markers.get(m), patterns.get(m)));
        }
        setNoise(markers);
        fitOutliersAnew(image, markers);
        setNoise(markers);
        expectBlurOfOthers(image, markers, patterns);
        // one marker, or clipped whites, do not tell it well enough
        before = markers.size() > 1 && !isFarTooBright(some) ? new Found(this, ofPower) : null;
        edgeShiftStdPx = Math.hypot(ofPower, estimated ? ESTIMATED_STD_PX : STATED_STD_PX);
        double[] blurs = new double[markers.size()];
        for (int m = 0; m < blurs.length; m++) {
            blurs[m] = markers.get(m).blurPx();
        }
        blurPx = blurs.length == 0 ? 0 : median(blurs);
        for (int m = 0; m < blurs.length; m++) {
            blurs[m] /= markers.get(m).cellPx();
        }
        blurInCells = blurs.length == 0 ? 0 : median(blurs);
    }

    /**
     * Fits markers with the mask and the curve of the photo before, and asks whether edges agree.
     *
     * @param found in the photo before
     * @param image the photo
     * @param markers its markers
     * @param some of them that are asked
     * @param patterns what each was read as
     * @return whether they do; if not, the mask is forgotten, and markers are left as they are fitted
     */
    private boolean bearOut(Found found, GreyImage image, List<MarkerEdges> markers, List<MarkerEdges> some,
            List<boolean[]> patterns) {
        maskAmount = found.maskAmount;
        maskRadiusPx = found.maskRadiusPx;
        loop.each(markers.size(), m -> refit(image, markers.get(m), patterns.get(m)));
        loop.each(some.size(), m -> some.get(m).sharpness(maskAmount, maskRadiusPx));
        setNoise(some);
        measureFlatNoise(image, some, true);
        double[] score = new double[SHAPES];
        double[] offsetBy = new double[SHAPES];
        double[] covariance = shapeCovariance(some, true, scale.curve().power(), score, offsetBy);
        if (covariance != null && Math.abs(step(covariance, 0, score) * offsetBy[0]) < SURPRISE_PX
                && Math.abs(step(covariance, 1, score)) < SURPRISE_AMOUNT) {
            inBlocks = found.inBlocks;
            blocksExcess = found.blocksExcess;
            maskOvershoot = found.maskOvershoot;
            return true;
        }
        drop();
        maskAmount = 0;
        maskRadiusPx = USUAL_RADIUS_PX;
        for (MarkerEdges marker : markers) {
            marker.unsharpen(image, 0, USUAL_RADIUS_PX);
        }
        return false;
    }

    /**
     * Finds the power of the curve that some markers show.
     *
     * @return how well edges are known by it, px
     */
    private double findCurve(GreyImage image, List<MarkerEdges> some, List<boolean[]> patterns) {
        double stale = 0;
        if (!said && !some.isEmpty()) {
            scan(image, some, patterns);
        }
        for (int round = 0; round < MAX_ROUNDS; round++) {
            loop.each(some.size(), m -> {
                some.get(m).measureShift(image);
                some.get(m).conclude(true);
            });
            double unbounded = powerStep(some);
            if (round == 0 && said && Math.abs(unbounded * offsetByPower) > SURPRISE_PX) {
                // not the curve that the file says: Gauss-Newton from far off may end beside the best one
                drop();
                scan(image, some, patterns);
                continue;
            }
            double step = clamp(unbounded, LARGEST_STEP);
            double next = clamp(curve.power() + step, LEAST_POWER, LARGEST_POWER);
            double moved = Math.abs((next - curve.power()) * offsetByPower);
            if (moved < SETTLED_PX) {
                break;
            }
            stale += moved;
            curve = curve.withPower(next);
            scale.set(curve);
            if (moved < SETTLING_PX) {
                break;
            }
            boolean anew = stale > STALE_PX;
            stale = anew ? 0 : stale;
            loop.each(some.size(), m -> {
                if (anew) {
                    some.get(m).refitNearly(image, patterns.get(m));
                } else {
                    some.get(m).refitSamePixels();
                }
            });
        }
        return offsetByPower / Math.sqrt(powerInformation);
    }

    /** Whether the photo at hand has the light of the one before, by its edges. */
    boolean isKept() {
        return kept != null;
    }

    /** Believes neither what the file says nor what the photo before had. */
    private void drop() {
        said = false;
        kept = null;
        sinceScan = 0;
    }

    /**
     * The step of Gauss-Newton that fitted and concluded markers ask of the power; sets its information and by how much
     * edges move with it, and the noise.
     */
    private double powerStep(List<MarkerEdges> some) {
        setNoise(some);
        scale.setNoise(noiseGrey);
        double variance = noiseGrey * noiseGrey;
        double shapeScore = 0;
        double shapeInformation = 0;
        double moved = 0;
        double weight = 0;
        double shift = 0;
        double shiftWeight = 0;
        for (MarkerEdges marker : some) {
            for (int i = 0; i < 4; i++) {
                SideFit side = marker.side(i);
                shapeScore += side.powerScore / variance;
                shapeInformation += side.powerInformation / variance;
                moved += side.powerInformation * side.offsetByPower;
                weight += side.powerInformation;
            }
            double w = marker.shiftWeight(variance);
            shift += w * marker.shiftPx();
            shiftWeight += w;
        }
        offsetByPower = weight > 0 ? moved / weight : 0;
        // curves that are no powers, blur that is no Gaussian: however many pixels there are, the power is no better
        double deflated = 1 / (1 + shapeInformation * MODEL_POWER_STD * MODEL_POWER_STD);
        double shiftInformation = shiftWeight > 0 ? 1 / (SHIFT_STD_PX * SHIFT_STD_PX + 1 / shiftWeight) : 0;
        double score = (powerMean - curve.power()) / (powerStd * powerStd) + deflated * shapeScore
                + (shiftWeight > 0 ? shift / shiftWeight * offsetByPower * shiftInformation : 0);
        powerInformation = 1 / (powerStd * powerStd) + deflated * shapeInformation
                + offsetByPower * offsetByPower * shiftInformation;
        return score / powerInformation;
    }

    /** Whether so much white is clipped that the photo will be refused whatever a second look says. */
    private boolean isFarTooBright(List<MarkerEdges> markers) {
        if (!estimated || fileSaid || markers.isEmpty()) {
            return false;
        }
        return medianOf(markers, side -> side.clippedShare) > FAR_TOO_BRIGHT * CLIPPED_SHARE;
    }

    /** Looks for blocks of a JPEG file about the markers. */
    private void findBlocks(GreyImage image, List<MarkerEdges> markers) {
        blocks.clear();
        double[] corners = new double[8];
        for (MarkerEdges marker : markers) {
            marker.corners(corners);
            double left = Double.POSITIVE_INFINITY;
            double top = Double.POSITIVE_INFINITY;
            double right = 0;
            double bottom = 0;
            for (int i = 0; i < 8; i += 2) {
                left = Math.min(left, corners[i]);
                right = Math.max(right, corners[i]);
                top = Math.min(top, corners[i + 1]);
                bottom = Math.max(bottom, corners[i + 1]);
            }
            blocks.add(image, (int) left - ABOUT_PX, (int) top - ABOUT_PX, (int) right + ABOUT_PX,
                    (int) bottom + ABOUT_PX, noiseGrey);
        }
        inBlocks = blocks.shows();
        blocksExcess = blocks.excess();
    }

    /**
     * Looks for an unsharp mask: its amount and radius and the power of the curve, together, by Gauss-Newton steps from
     * no mask on, the sides' own unknowns projected out. A photo that shows none is left as it was.
     *
     * @param image the photo
     * @param some markers, fitted at the curve found so far
     * @param patterns what each of them was read as
     * @param shiftStdPx how well edges are known without a mask, px
     * @return the same with what was found, px
     */
    private double findMask(GreyImage image, List<MarkerEdges> some, List<boolean[]> patterns, double shiftStdPx) {
        ToneCurve without = scale.curve();
        double power = without.power();
        double noise = scale.noise();
        double[] shape = new double[SHAPES];
        double[] covariance = null;
        double sharpNoise = 0;
        double deviations = 0;
        double[] score = new double[SHAPES];
        double[] offsetBy = new double[SHAPES];
        for (int round = 0; round < MASK_ROUNDS; round++) {
            boolean first = round == 0;
            loop.each(some.size(), m -> {
                if (!first) {
                    some.get(m).measureShift(image);
                }
                if (!first || !estimated) {
                    some.get(m).conclude(false);
                }
                some.get(m).sharpness(maskAmount, maskRadiusPx);
            });
            setNoise(some);
            scale.setNoise(noiseGrey);
            if (round == 0) {
                measureFlatNoise(image, some, false);
            }
            covariance = shapeCovariance(some, estimated || round > 0, power, score, offsetBy);
            if (covariance == null) {
                break;
            }
            for (int a = 0; a < SHAPES; a++) {
                shape[a] = step(covariance, a, score);
            }
            if (round == 0) {
                sharpNoise = noiseGrey;
                deviations = shape[1] / Math.sqrt(covariance[4]);
                if (shape[1] < LEAST_AMOUNT || deviations < LEAST_DEVIATIONS) {
                    scale.setNoise(noise);
                    return shiftStdPx;
                }
            } else if (byNoise(sharpNoise) < (round == 1 || deviations >= CERTAIN_DEVIATIONS ? 0 : BORNE_OUT)) {
                // what edges hint at, noise must bear out: more so where they are not sure of it
                maskAmount = 0;
                break;
            }
            double nextPower = clamp(power + clamp(shape[0], LARGEST_STEP), LEAST_POWER, LARGEST_POWER);
            double nextAmount = clamp(maskAmount + clamp(shape[1], LARGEST_AMOUNT_STEP), 0, LARGEST_AMOUNT);
            double nextRadius = clamp(maskRadiusPx * Math.exp(clamp(shape[2], LARGEST_RADIUS_STEP)), LEAST_RADIUS_PX,
                    LARGEST_RADIUS_PX);
            boolean settled = Math.abs((nextPower - power) * offsetBy[0]) < SETTLED_PX
                    && Math.abs(nextAmount - maskAmount) < SETTLED_AMOUNT
                    && Math.abs(Math.log(nextRadius / maskRadiusPx)) < SETTLED_RADIUS;
            if (settled) {
                break;
            }
            if (estimated) {
                power = nextPower;
                scale.set(without.withPower(power));
            }
            maskAmount = nextAmount;
            maskRadiusPx = nextRadius;
            int tried = round == 0 ? Math.min(MOST_TRIED, some.size()) : 0;
            if (tried > 0 && isRuledOut(image, some.subList(0, tried), patterns)) {
                maskAmount = 0;
                break;
            }
            undoMask(image, some.subList(tried, some.size()), patterns.subList(tried, some.size()));
        }
        if (covariance == null || maskAmount < LEAST_AMOUNT) {
            maskAmount = 0;
            scale.set(without);
            scale.setNoise(noise);
            return shiftStdPx;
        }
        curve = scale.curve();
        maskOvershoot = medianOf(some, side -> side.maskOvershoot);
        return Math.sqrt(Math.max(0, quadratic(covariance, offsetBy)));
    }

    private static double step(double[] covariance, int of, double[] score) {
        double sum = 0;
        for (int b = 0; b < SHAPES; b++) {
            sum += covariance[of * SHAPES + b] * score[b];
        }
        return sum;
    }

    private void undoMask(GreyImage image, List<MarkerEdges> of, List<boolean[]> patterns) {
        loop.each(of.size(), m -> {
            of.get(m).unsharpen(image, maskAmount, maskRadiusPx);
            of.get(m).refit(image, patterns.get(m));
        });
    }

    /** Undoes a mask that edges hint at about a few markers, and asks whether their noise speaks clearly against it. */
    private boolean isRuledOut(GreyImage image, List<MarkerEdges> few, List<boolean[]> patterns) {
        setNoise(few);
        double sharpNoise = noiseGrey;
        undoMask(image, few, patterns);
        for (MarkerEdges marker : few) {
            marker.measureShift(image);
            marker.conclude(false);
        }
        setNoise(few);
        return byNoise(sharpNoise) < RULED_OUT;
    }

    private static double quadratic(double[] matrix, double[] by) {
        double sum = 0;
        for (int a = 0; a < by.length; a++) {
            for (int b = 0; b < by.length; b++) {
                sum += by[a] * matrix[a * by.length + b] * by[b];
            }
        }
        return sum;
    }

    /**
     * Sums up what sides, inner edges and what is known beforehand say of power, amount and radius.
     *
     * @param withShift whether the inner edges were measured
     * @param score receives the gradient of the log posterior
     * @param offsetBy receives the mean change of a side's offset, px
     * @return covariance of the three, or null where nothing tells them
     */
    private double @Nullable [] shapeCovariance(List<MarkerEdges> some, boolean withShift, double power,
            double[] score, double[] offsetBy) {
        double variance = noiseGrey * noiseGrey;
        double[] information = new double[SHAPES * SHAPES];
        double[] ofSides = new double[SHAPES];
        Arrays.fill(offsetBy, 0);
        double shift = 0;
        double shiftWeight = 0;
        double weights = 0;
        for (MarkerEdges marker : some) {
            for (int i = 0; i < 4; i++) {
                SideFit side = marker.side(i);
                double weight = 1 / side.covariance(SideFit.OFFSET, SideFit.OFFSET);
                weights += weight;
                for (int a = 0; a < SHAPES; a++) {
                    ofSides[a] += side.shapeScore[a] / variance;
                    offsetBy[a] += weight * side.offsetByShape[a];
                }
                for (int k = 0; k < information.length; k++) {
                    information[k] += side.shapeInformation[k] / variance;
                }
            }
            double w = withShift ? marker.shiftWeight(variance) : 0;
            shift += w * marker.shiftPx();
            shiftWeight += w;
        }
        if (!(weights > 0)) {
            return null;
        }
        shift = shiftWeight > 0 ? shift / shiftWeight : 0;
        double shiftInformation = shiftWeight > 0 ? 1 / (SHIFT_STD_PX * SHIFT_STD_PX + 1 / shiftWeight) : 0;
        for (int a = 0; a < SHAPES; a++) {
            offsetBy[a] /= weights;
            information[a * (SHAPES + 1)] += 1e-9;
        }
        // however many pixels there are, the three are no better known than the model is right
        double[] deflated = Cholesky.inverse(information, SHAPES);
        if (deflated == null) {
            return null;
        }
        double[] best = new double[SHAPES];
        for (int a = 0; a < SHAPES; a++) {
            for (int b = 0; b < SHAPES; b++) {
                best[a] += deflated[a * SHAPES + b] * ofSides[b];
            }
        }
        if (noiseTells) {
            for (int k = 0; k < deflated.length; k++) {
                deflated[k] *= MODEL_VARIANCE_FACTOR;
            }
        }
        deflated[0] += MODEL_POWER_STD * MODEL_POWER_STD;
        deflated[4] += MODEL_AMOUNT_STD * MODEL_AMOUNT_STD;
        deflated[8] += MODEL_RADIUS_STD * MODEL_RADIUS_STD;
        double[] posterior = Cholesky.inverse(deflated, SHAPES);
        if (posterior == null) {
            return null;
        }
        for (int a = 0; a < SHAPES; a++) {
            score[a] = offsetBy[a] * shift * shiftInformation;
            for (int b = 0; b < SHAPES; b++) {
                score[a] += posterior[a * SHAPES + b] * best[b];
            }
        }
        for (int a = 0; a < SHAPES; a++) {
            for (int b = 0; b < SHAPES; b++) {
                posterior[a * SHAPES + b] += offsetBy[a] * offsetBy[b] * shiftInformation;
            }
        }
        double ofPower = estimated ? 1 / (powerStd * powerStd) : FIXED;
        posterior[0] += ofPower;
        score[0] += estimated ? ofPower * (powerMean - power) : 0;
        posterior[4] += 1 / (USUAL_AMOUNT_STD * USUAL_AMOUNT_STD);
        score[1] -= maskAmount / (USUAL_AMOUNT_STD * USUAL_AMOUNT_STD);
        posterior[8] += 1 / (RADIUS_STD * RADIUS_STD);
        addFlatNoise(posterior, score);
        score[2] -= Math.log(maskRadiusPx / USUAL_RADIUS_PX) / (RADIUS_STD * RADIUS_STD);
        return Cholesky.inverse(posterior, SHAPES);
    }

    /**
     * Measures the noise of the ground about markers.
     *
     * @param again whether it was that of a mask in the frame before: then a part of the ground will do
     */
    private void measureFlatNoise(GreyImage image, List<MarkerEdges> some, boolean again) {
        double[] corners = new double[8];
        flatNoise.clear();
        for (MarkerEdges marker : some) {
            marker.corners(corners);
            flatNoise.add(image, corners);
        }
        noiseTells = flatNoise.measure(image, -BLUE_CORRELATION, again)
                && flatNoise.correlation(0) < -BLUE_DEVIATIONS * Math.sqrt(flatNoise.variance(0))
                && (again || flatNoise.isOfAMask());
    }

    /** Adds what the noise of flat ground says of amount and radius of the mask. */
    private void addFlatNoise(double[] information, double[] score) {
        if (!noiseTells) {
            return;
        }
        Unsharpened.noiseCorrelation(maskAmount, maskRadiusPx, ofMask);
        Unsharpened.noiseCorrelation(maskAmount + DIFFERENCE, maskRadiusPx, otherAmount);
        Unsharpened.noiseCorrelation(maskAmount, maskRadiusPx * Math.exp(DIFFERENCE), otherRadius);
        for (int l = 0; l < FlatNoise.LAGS.length; l++) {
            double weight = flatNoise.weight(l);
            double byAmount = (otherAmount[l] - ofMask[l]) / DIFFERENCE;
            double byRadius = (otherRadius[l] - ofMask[l]) / DIFFERENCE;
            double off = flatNoise.correlation(l) - ofMask[l];
            score[1] += weight * byAmount * off;
            score[2] += weight * byRadius * off;
            information[4] += weight * byAmount * byAmount;
            information[5] += weight * byAmount * byRadius;
            information[7] += weight * byAmount * byRadius;
            information[8] += weight * byRadius * byRadius;
        }
    }

    /** Logarithm of the ratio of the likelihoods of the noise of flat ground with the mask and without one. */
    private double byFlatNoise() {
        Unsharpened.noiseCorrelation(0, maskRadiusPx, otherAmount);
        Unsharpened.noiseCorrelation(maskAmount, maskRadiusPx, ofMask);
        return (flatNoise.misfit(otherAmount) - flatNoise.misfit(ofMask)) / 2;
    }

    /**
     * What the noise says of the mask: logarithm of the ratio of the likelihoods of grey values with the mask and
     * without one. By flat ground where it is blue; else by the sides: a mask makes white noise blue, and undoing it
     * makes it white again and smaller than its Jacobian asks for; where noise was white, undoing a mask leaves it
     * larger than that (Jensen).
     */
    private double byNoise(double sharpNoise) {
        if (noiseTells) {
            return byFlatNoise();
        }
        return PIXELS_ON_SLOPE * degreesOfFreedom * (Math.log(sharpNoise / noiseGrey)
                - Unsharpened.meanLogGain(maskAmount, maskRadiusPx));
    }

    private static double clamp(double value, double most) {
        return clamp(value, -most, most);
    }

    private static double clamp(double value, double least, double most) {
        return Math.max(least, Math.min(most, value));
    }

    /**
     * Starts at the power, of a few and of the one that sides are fitted at, under which they leave the smallest
     * residuals.
     */
    private void scan(GreyImage image, List<MarkerEdges> some, List<boolean[]> patterns) {
        List<MarkerEdges> few = some.subList(0, Math.min(MOST_SCANNED, some.size()));
        double[][] first = fitted(few);
        double[][] ofBest = first;
        ToneCurve start = scale.curve();
        ToneCurve best = start;
        double least = noiseOf(few);
        for (double power : SCANNED) {
            if (Math.abs(power - start.power()) < NEAR_POWER) {
                continue;
            }
            scale.set(curve.withPower(power));
            loop.each(few.size(), m -> {
                few.get(m).returnTo(first[m]);
                few.get(m).refitNearly(image, patterns.get(m));
            });
            double noise = noiseOf(few);
            if (noise < least) {
                least = noise;
                best = scale.curve();
                ofBest = fitted(few);
            }
        }
        curve = best;
        scale.set(curve);
        double[][] known = ofBest;
        boolean moved = best != start;
        loop.each(some.size(), m -> {
            if (m < known.length) {
                some.get(m).returnTo(known[m]);
            } else if (moved) {
                some.get(m).refitSamePixels();
            }
            some.get(m).refitNearly(image, patterns.get(m));
        });
    }

    private static double[][] fitted(List<MarkerEdges> few) {
        double[][] fitted = new double[few.size()][];
        for (int m = 0; m < fitted.length; m++) {
            fitted[m] = few.get(m).fitted();
        }
        return fitted;
    }

    private double noiseOf(List<MarkerEdges> few) {
        loop.each(few.size(), m -> few.get(m).conclude(false));
        setNoise(few);
        return noiseGrey;
    }

    /**
     * Fits a marker in the light that was found.
     *
     * @param image the photo
     * @param marker its edges, fitted before
     * @param pattern what it was read as
     */
    void refit(GreyImage image, MarkerEdges marker, boolean[] pattern) {
        marker.unsharpen(image, maskAmount, maskRadiusPx);
        marker.refit(image, pattern);
        marker.measureShift(image);
        marker.conclude(false);
    }

    /**
     * Fits markers anew that lie far from the others in residuals or shift: most have stuck on the way to the curve.
     */
    private void fitOutliersAnew(GreyImage image, List<MarkerEdges> markers) {
        usualShiftPx = Double.NaN;
        if (markers.size() < 2) {
            return;
        }
        double[] shifts = new double[markers.size()];
        for (int m = 0; m < shifts.length; m++) {
            shifts[m] = markers.get(m).shiftPx();
        }
        double usual = median(shifts);
        usualShiftPx = shifts.length < LEAST_TO_JUDGE ? Double.NaN : usual;
        for (MarkerEdges marker : markers) {
            if (Math.abs(marker.shiftPx() - usual) > ODD_SHIFT_PX
                    || ofMarker(marker) > ODD_NOISE * noiseGrey * noiseGrey) {
                marker.fitAnew(image, usual);
                marker.measureShift(image);
                marker.conclude(false);
            }
        }
    }

    /**
     * Fits sides anew that lie along a row of pixels in a sharp photo: their grey values tell a sharper edge here or a
     * more blurred one there, with nothing to choose. Blur as of the photo's other sides is taken then.
     */
    private void expectBlurOfOthers(GreyImage image, List<MarkerEdges> markers, List<boolean[]> patterns) {
        double[] blurs = new double[4 * markers.size()];
        for (int k = 0; k < blurs.length; k++) {
            blurs[k] = markers.get(k / 4).side(k % 4).unknowns[SideFit.BLUR];
        }
        double usual = blurs.length == 0 ? 0 : median(blurs);
        for (int m = 0; m < markers.size(); m++) {
            MarkerEdges marker = markers.get(m);
            boolean any = false;
            for (int i = 0; i < 4; i++) {
                SideFit side = marker.side(i);
                if (side.unknowns[SideFit.BLUR] < VANISHED_BLUR * usual || side.offsetStdPx(noiseGrey) > UNTOLD_PX) {
                    side.expectBlur(usual, EXPECTED_BLUR_STD * usual, noiseGrey);
                    any = true;
                }
            }
            if (any) {
                refit(image, marker, patterns.get(m));
            }
        }
    }

    /**
     * Blur of a marker's edges as the photo shows them, its mask not undone: that of an edge which is as steep in the
     * middle. A mask makes edges steeper, so more of them keep clear of each other than before it.
     *
     * @param marker edges of a marker, fitted
     * @return deviation, px, at least 0; without a mask the fitted one
     */
    double blurInPhotoPx(MarkerEdges marker) {
        double blur = marker.blurPx();
        return maskAmount == 0 ? blur : SideBand.sharpenedBlurPx(blur, maskAmount, maskRadiusPx);
    }

    /**
     * Whether a marker's edges still lie so far from where the others' do that its fit cannot be believed: ink spreads
     * differently from print to print, but by hundredths of a millimetre.
     */
    boolean isOdd(MarkerEdges marker) {
        double scale = Math.max(1, marker.side(0).lengthPx / USUAL_SIDE_PX);
        return Math.abs(marker.shiftPx() - usualShiftPx) > NOT_BELIEVED_SHIFT_PX * scale;
    }

    private static double ofMarker(MarkerEdges marker) {
        double sum = 0;
        for (int i = 0; i < 4; i++) {
            sum += ofSide(marker.side(i)) / 4;
        }
        return sum;
    }

    /** Noise of all sides together, those far out of line left out. */
    private void setNoise(List<MarkerEdges> markers) {
        double[] own = new double[4 * markers.size()];
        for (int k = 0; k < own.length; k++) {
            own[k] = ofSide(markers.get(k / 4).side(k % 4));
        }
        double[] sorted = own.clone();
        Arrays.sort(sorted);
        double median = sorted.length == 0 ? 1 : sorted[sorted.length / 2];
        double sum = 0;
        double weights = 0;
        for (int k = 0; k < own.length; k++) {
            double freedom = markers.get(k / 4).side(k % 4).degreesOfFreedom;
            if (own[k] <= OUT_OF_LINE * median) {
                sum += freedom * own[k];
                weights += freedom;
            }
        }
        noiseGrey = Math.sqrt(Math.max(ROUNDING * ROUNDING, weights > 0 ? sum / weights : median));
        degreesOfFreedom = weights;
    }

    private static double ofSide(SideFit side) {
        return side.squares / side.expectedSquares;
    }

    /** Noise of each side of a marker, grey levels: that of the photo, its own where it is far out of line. */
    double[] noiseOfSides(MarkerEdges marker) {
        double[] out = new double[4];
        double factor = inBlocks ? NOISE_IN_BLOCKS : 1;
        for (int i = 0; i < 4; i++) {
            double own = ofSide(marker.side(i));
            double ofAll = noiseGrey * noiseGrey;
            out[i] = factor * (own > OUT_OF_LINE * ofAll ? Math.sqrt(own) : noiseGrey);
        }
        return out;
    }

    /** Whether a mask is undone: whites between edges are then brighter than others, be it by little. */
    boolean undoesMask() {
        return maskAmount > 0;
    }

    /** Whether a mask is undone that lifts white beside edges: small whites are then brighter than large ones. */
    boolean isSharpened() {
        return maskOvershoot > OVERSHOOT;
    }

    /**
     * What is to be said of the light.
     *
     * @param markers edges of the photo's markers, fitted in this light
     * @param warnings receives it
     */
    void warn(List<MarkerEdges> markers, List<Warning> warnings) {
        if (markers.isEmpty()) {
            return;
        }
        clippedShare = medianOf(markers, side -> side.clippedShare);
        if (clippedShare > CLIPPED_SHARE) {
            warnings.add(Warning.of(DetectionWarning.WHITES_CLIPPED, percent(clippedShare)));
        }
        double crushed = medianOf(markers, side -> side.crushedShare);
        if (crushed > CRUSHED_SHARE) {
            warnings.add(Warning.of(DetectionWarning.BLACKS_CRUSHED, percent(crushed)));
        }
        overshoot = Math.max(maskOvershoot, medianOf(markers, side -> side.overshoot));
        if (overshoot > OVERSHOOT && clippedShare < CLIPPED_SHARE) {
            warnings.add(Warning.of(DetectionWarning.SHARPENED, percent(overshoot)));
        }
        if (inBlocks) {
            warnings.add(Warning.of(DetectionWarning.IN_BLOCKS));
        }
        double medianWhite = medianOf(markers, side -> side.unknowns[SideFit.BRIGHT]);
        whiteGrey = medianWhite;
        double medianContrast = medianOf(markers,
                side -> side.unknowns[SideFit.BRIGHT] - side.unknowns[SideFit.DARK]);
        if (medianContrast < DARK_CONTRAST && medianWhite > FAINT_WHITE) {
            warnings.add(Warning.of(DetectionWarning.FAINT, (int) Math.round(medianWhite - medianContrast),
                    (int) Math.round(medianWhite)));
        } else if (medianContrast < DARK_CONTRAST) {
            warnings.add(Warning.of(DetectionWarning.TOO_DARK, (int) Math.round(medianWhite)));
        }
    }

    /**
     * How much of one marker is cut off above, where the photo as a whole is not: a lamp that it mirrors.
     *
     * @param marker its edges, fitted in this light
     * @return share of the pixels beside its worst side that are at the brightest value, percent; 0 where it is few
     */
    int glarePercent(MarkerEdges marker) {
        double worst = 0;
        for (int k = 0; k < 4; k++) {
            worst = Math.max(worst, marker.side(k).clippedShare);
        }
        return clippedShare <= CLIPPED_SHARE && worst > GLARE_SHARE ? percent(worst) : 0;
    }

    private static int percent(double share) {
        return (int) Math.round(100 * share);
    }

    private static double medianOf(List<MarkerEdges> markers, ToDoubleFunction<SideFit> ofSide) {
        double[] values = new double[4 * markers.size()];
        for (int k = 0; k < values.length; k++) {
            values[k] = ofSide.applyAsDouble(markers.get(k / 4).side(k % 4));
        }
        return median(values);
    }

    private static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        return sorted[sorted.length / 2];
    }

    /**
     * Whether whites are clipped and the curve is not known beforehand: then nothing tells the two apart, and edges lie
     * wherever the curve puts them.
     */
    private boolean curveIsOpen() {
        return estimated && clippedShare > CLIPPED_SHARE
                && !(fileSaid && Math.abs(curve.power() - powerMean) < CONFIRMED_POWER);
    }

    /** What the measured shift of a marker may be off by beside noise, px. */
    double shiftStdPx() {
        return inBlocks ? SHIFT_STD_IN_BLOCKS_PX : 0;
    }

    /** How far outlines are known to lie in the dark beside what inner edges show, px, at least 0. */
    double inDarkPx() {
        return inBlocks ? IN_DARK_BY_BLOCKS_PX * Math.max(0, scale.curve().power() - 1) * blocksExcess : 0;
    }

    /** What was found. */
    PhotoLight light() {
        PhotoLight light = new PhotoLight(scale.curve(), estimated, blurPx, noiseGrey, degreesOfFreedom,
                edgeShiftStdPx);
        light = light.withOutlineStdPx(PhotoLight.usualOutlineStdPx(blurPx, whiteGrey,
                blurInCells > 0 ? blurPx / blurInCells : Double.POSITIVE_INFINITY));
        boolean surelyUndone = noiseTells && maskAmount > 0;
        double more = Math.hypot(inBlocks ? OUTLINE_STD_IN_BLOCKS_PX : 0,
                overshoot > OVERSHOOT && !surelyUndone ? OUTLINE_STD_OF_SHARPENED_PX * blurInCells : 0);
        if (more > 0) {
            light = light.withOutlineStdPx(Math.hypot(light.outlineStdPx(), more));
        }
        return curveIsOpen() ? light.withOpenToneCurve() : light;
    }
}
