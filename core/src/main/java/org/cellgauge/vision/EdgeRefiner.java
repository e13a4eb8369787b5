package org.cellgauge.vision;

import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.Projection;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;

/**
 * Sharpens the corners of a marker to hundredths of a pixel by fitting its four sides to the grey values themselves.
 *
 * <p>Sides of a marker are straight only where the lens does not bend them. So every pixel in a band along a side is
 * taken to undistorted pixels first (its grey value stays what the sensor measured: nothing is interpolated), and there
 * a straight blurred step is fitted by least squares: position and slope of the line, width of the blur, grey value on
 * either side. That is the maximum-likelihood estimate of the line under white noise. Corners are where neighbouring
 * sides meet, taken back through the lens. Not thread-safe.
 */
final class EdgeRefiner {
    private static final int CORNERS = 4;
    private static final int UNKNOWNS = 5;
    private static final int OFFSET = 0;
    private static final int SLOPE = 1;
    private static final int BLUR = 2;
    private static final int DARK = 3;
    private static final int BRIGHT = 4;
    private static final int MAX_PASSES = 3;
    private static final int MAX_STEPS = 20;
    private static final double SETTLED_PX = 1e-3;
    /** A line that moved further than this has left the band it was fitted in: its pixels are chosen again. */
    private static final double BAND_STILL_GOOD_PX = 0.2;
    private static final double SMALLEST_BLUR_PX = 0.1;
    private static final double LARGEST_BLUR_PX = 4;
    private static final double FIRST_BLUR_PX = 0.6;

    private final double[] intrinsics;
    private final boolean distorted;
    private final double innerBandFraction;
    private final double bandPx;
    private final double cornerMarginPx;
    private final double furthestMovePx;

    private double[] along = new double[256];
    private double[] across = new double[256];
    private double[] grey = new double[256];
    private int samples;
    private double darkGrey;
    private double brightGrey;
    private double blurPx;

    private final double[] ideal = new double[2 * CORNERS];
    private final double[] refined = new double[2 * CORNERS];
    private final double[] before = new double[2 * CORNERS];
    private final double[] line = new double[3 * CORNERS];
    private final double[] normalised = new double[2];
    private final double[] trialPoint = new double[2];
    private final EdgeProfile profile = new EdgeProfile();
    private final double[] unknowns = new double[UNKNOWNS];
    private final double[] trial = new double[UNKNOWNS];
    private final double[] row = new double[UNKNOWNS];
    private final LinearSolverDense<DMatrixRMaj> solver = LinearSolverFactory_DDRM.symmPosDef(UNKNOWNS);
    private final DMatrixRMaj normal = new DMatrixRMaj(UNKNOWNS, UNKNOWNS);
    private final DMatrixRMaj damped = new DMatrixRMaj(UNKNOWNS, UNKNOWNS);
    private final DMatrixRMaj gradient = new DMatrixRMaj(UNKNOWNS, 1);
    private final DMatrixRMaj step = new DMatrixRMaj(UNKNOWNS, 1);

    /**
     * A refiner.
     *
     * @param camera camera of the images
     * @param borderFraction width of the black border as a share of the marker's width: how far the band may reach
     *     inwards before it meets the pattern
     */
    EdgeRefiner(PinholeCamera camera, double borderFraction) {
        this(camera, borderFraction, 3, 2, 3);
    }

    EdgeRefiner(PinholeCamera camera, double borderFraction, double bandPx, double cornerMarginPx,
            double furthestMovePx) {
        this.intrinsics = camera.intrinsics();
        this.distorted = camera.hasDistortion();
        this.innerBandFraction = 0.6 * borderFraction;
        this.bandPx = bandPx;
        this.cornerMarginPx = cornerMarginPx;
        this.furthestMovePx = furthestMovePx;
    }

    /**
     * Refines the corners of one marker.
     *
     * @param image the image
     * @param cornersPx 8 values, distorted px, within about a pixel of the corners, in any sense of turning; replaced
     *     where the fit succeeds and stays near, left alone otherwise
     * @return whether they were replaced
     */
    boolean refine(GreyImage image, double[] cornersPx) {
        for (int i = 0; i < CORNERS; i++) {
            if (!toIdeal(cornersPx[2 * i], cornersPx[2 * i + 1], ideal, 2 * i)) {
                return false;
            }
        }
        System.arraycopy(ideal, 0, before, 0, 2 * CORNERS);
        for (int pass = 0; pass < MAX_PASSES; pass++) {
            double centreX = (ideal[0] + ideal[2] + ideal[4] + ideal[6]) / CORNERS;
            double centreY = (ideal[1] + ideal[3] + ideal[5] + ideal[7]) / CORNERS;
            darkGrey = 0;
            brightGrey = 0;
            blurPx = 0;
            for (int i = 0; i < CORNERS; i++) {
                if (!fitSide(image, i, centreX, centreY)) {
                    return false;
                }
            }
            double moved = 0;
            for (int i = 0; i < CORNERS; i++) {
                if (!intersect((i + CORNERS - 1) % CORNERS, i)) {
                    return false;
                }
                moved = Math.max(moved, Math.hypot(refined[2 * i] - ideal[2 * i], refined[2 * i + 1]
                        - ideal[2 * i + 1]));
                if (!(Math.hypot(refined[2 * i] - before[2 * i], refined[2 * i + 1] - before[2 * i + 1])
                        <= furthestMovePx)) {
                    return false;
                }
            }
            System.arraycopy(refined, 0, ideal, 0, 2 * CORNERS);
            if (moved < BAND_STILL_GOOD_PX) {
                break;
            }
        }
        for (int i = 0; i < CORNERS; i++) {
            toImage(ideal[2 * i], ideal[2 * i + 1], cornersPx, 2 * i);
        }
        return true;
    }

    /** Grey value of the black border, mean over the sides of the last marker refined. */
    double darkGrey() {
        return darkGrey;
    }

    /** Grey value of the white around the border, mean over the sides of the last marker refined. */
    double brightGrey() {
        return brightGrey;
    }

    /** Optical blur of the sides, mean standard deviation over the sides of the last marker refined, px. */
    double blurPx() {
        return blurPx;
    }

    private boolean toIdeal(double u, double v, double[] out, int at) {
        if (!distorted) {
            out[at] = u;
            out[at + 1] = v;
            return true;
        }
        if (!Projection.toNormalised(intrinsics, u, v, normalised)) {
            return false;
        }
        out[at] = intrinsics[PinholeCamera.FX] * normalised[0] + intrinsics[PinholeCamera.SKEW] * normalised[1]
                + intrinsics[PinholeCamera.CX];
        out[at + 1] = intrinsics[PinholeCamera.FY] * normalised[1] + intrinsics[PinholeCamera.CY];
        return true;
    }

    private void toImage(double x, double y, double[] out, int at) {
        if (!distorted) {
            out[at] = x;
            out[at + 1] = y;
            return;
        }
        double yn = (y - intrinsics[PinholeCamera.CY]) / intrinsics[PinholeCamera.FY];
        double xn = (x - intrinsics[PinholeCamera.CX] - intrinsics[PinholeCamera.SKEW] * yn)
                / intrinsics[PinholeCamera.FX];
        Projection.project(intrinsics, xn, yn, 1, out, at);
    }

    /** Fits side i, from corner i to the next, and leaves it in {@link #line} as a x + b y + c = 0. */
    private boolean fitSide(GreyImage image, int i, double centreX, double centreY) {
        int j = (i + 1) % CORNERS;
        double x0 = ideal[2 * i];
        double y0 = ideal[2 * i + 1];
        double length = Math.hypot(ideal[2 * j] - x0, ideal[2 * j + 1] - y0);
        if (!(length > 4 * cornerMarginPx)) {
            return false;
        }
        double tx = (ideal[2 * j] - x0) / length;
        double ty = (ideal[2 * j + 1] - y0) / length;
        double nx = -ty;
        double ny = tx;
        if (nx * (centreX - x0) + ny * (centreY - y0) > 0) {
            nx = ty;
            ny = -tx;
        }
        double middleX = x0 + tx * length / 2;
        double middleY = y0 + ty * length / 2;
        double halfLength = length / 2 - cornerMarginPx;
        double shortest = shortestAcross(nx, ny);
        double inner = Math.min(bandPx, innerBandFraction * shortest);
        double outer = Math.min(bandPx, 0.12 * shortest);
        profile.turn(nx, ny);
        collect(image, middleX, middleY, tx, ty, nx, ny, halfLength, inner, outer);
        if (samples < 4 * UNKNOWNS || !fitStep(halfLength)) {
            return false;
        }
        darkGrey += unknowns[DARK] / CORNERS;
        brightGrey += unknowns[BRIGHT] / CORNERS;
        blurPx += unknowns[BLUR] / CORNERS;
        // across = offset + slope * along is the line in the side's own coordinates
        double a = nx - unknowns[SLOPE] * tx;
        double b = ny - unknowns[SLOPE] * ty;
        line[3 * i] = a;
        line[3 * i + 1] = b;
        line[3 * i + 2] = -(a * middleX + b * middleY) - unknowns[OFFSET];
        return true;
    }

    /** Extent of the quadrilateral in a direction: how much room the border and the quiet zone have there. */
    private double shortestAcross(double nx, double ny) {
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < CORNERS; i++) {
            double d = nx * ideal[2 * i] + ny * ideal[2 * i + 1];
            low = Math.min(low, d);
            high = Math.max(high, d);
        }
        return high - low;
    }

    /** Gathers the pixels whose centres lie in the band, in coordinates of the side. */
    private void collect(GreyImage image, double middleX, double middleY, double tx, double ty, double nx, double ny,
            double halfLength, double inner, double outer) {
        samples = 0;
        double lowU = Double.POSITIVE_INFINITY;
        double highU = Double.NEGATIVE_INFINITY;
        double lowV = Double.POSITIVE_INFINITY;
        double highV = Double.NEGATIVE_INFINITY;
        // the band's outline in the image: bent by the lens, so points between its ends count too
        for (int k = 0; k <= 8; k++) {
            double t = halfLength * (k - 4) / 4;
            for (int side = 0; side < 2; side++) {
                double d = side == 0 ? -inner : outer;
                toImage(middleX + tx * t + nx * d, middleY + ty * t + ny * d, normalised, 0);
                lowU = Math.min(lowU, normalised[0]);
                highU = Math.max(highU, normalised[0]);
                lowV = Math.min(lowV, normalised[1]);
                highV = Math.max(highV, normalised[1]);
            }
        }
        int firstX = Math.max(0, (int) Math.floor(lowU) - 1);
        int lastX = Math.min(image.widthPx() - 1, (int) Math.ceil(highU) + 1);
        int firstY = Math.max(0, (int) Math.floor(lowV) - 1);
        int lastY = Math.min(image.heightPx() - 1, (int) Math.ceil(highV) + 1);
        for (int y = firstY; y <= lastY; y++) {
            for (int x = firstX; x <= lastX; x++) {
                double px = x + 0.5;
                double py = y + 0.5;
                if (distorted) {
                    if (!toIdeal(px, py, trialPoint, 0)) {
                        continue;
                    }
                    px = trialPoint[0];
                    py = trialPoint[1];
                }
                double d = (px - middleX) * nx + (py - middleY) * ny;
                double t = (px - middleX) * tx + (py - middleY) * ty;
                if (d < -inner || d > outer || t < -halfLength || t > halfLength) {
                    continue;
                }
                if (samples == along.length) {
                    along = java.util.Arrays.copyOf(along, 2 * samples);
                    across = java.util.Arrays.copyOf(across, 2 * samples);
                    grey = java.util.Arrays.copyOf(grey, 2 * samples);
                }
                along[samples] = t;
                across[samples] = d;
                grey[samples++] = image.get(x, y);
            }
        }
    }

    private boolean fitStep(double halfLength) {
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < samples; i++) {
            low = Math.min(low, grey[i]);
            high = Math.max(high, grey[i]);
        }
        unknowns[OFFSET] = 0;
        unknowns[SLOPE] = 0;
        unknowns[BLUR] = FIRST_BLUR_PX;
        unknowns[DARK] = low;
        unknowns[BRIGHT] = high;
        double damping = 1e-3;
        double sum = linearise(unknowns);
        for (int i = 0; i < MAX_STEPS; i++) {
            damped.setTo(normal);
            for (int k = 0; k < UNKNOWNS; k++) {
                damped.set(k, k, normal.get(k, k) * (1 + damping) + 1e-12);
            }
            if (!solver.setA(damped)) {
                return false;
            }
            solver.solve(gradient, step);
            for (int k = 0; k < UNKNOWNS; k++) {
                trial[k] = unknowns[k] - step.get(k);
            }
            trial[BLUR] = Math.min(LARGEST_BLUR_PX, Math.max(SMALLEST_BLUR_PX, trial[BLUR]));
            double moved = Math.abs(trial[OFFSET] - unknowns[OFFSET])
                    + Math.abs(trial[SLOPE] - unknowns[SLOPE]) * halfLength;
            double trialSum = sumOfSquares(trial);
            if (trialSum <= sum) {
                System.arraycopy(trial, 0, unknowns, 0, UNKNOWNS);
                damping /= 10;
                if (moved < SETTLED_PX) {
                    break;
                }
                sum = linearise(unknowns);
            } else {
                damping *= 10;
                if (damping > 1e6) {
                    break;
                }
            }
        }
        return unknowns[BRIGHT] > unknowns[DARK];
    }

    private double sumOfSquares(double[] p) {
        double sum = 0;
        for (int i = 0; i < samples; i++) {
            profile.at(across[i] - p[OFFSET] - p[SLOPE] * along[i], p[BLUR]);
            double residual = p[DARK] + (p[BRIGHT] - p[DARK]) * profile.share - grey[i];
            sum += residual * residual;
        }
        return sum;
    }

    private double linearise(double[] p) {
        normal.zero();
        gradient.zero();
        double sum = 0;
        double[] n = normal.data;
        double[] g = gradient.data;
        double contrast = p[BRIGHT] - p[DARK];
        for (int i = 0; i < samples; i++) {
            profile.at(across[i] - p[OFFSET] - p[SLOPE] * along[i], p[BLUR]);
            double residual = p[DARK] + contrast * profile.share - grey[i];
            row[OFFSET] = -contrast * profile.byDistance;
            row[SLOPE] = row[OFFSET] * along[i];
            row[BLUR] = contrast * profile.byBlur;
            row[DARK] = 1 - profile.share;
            row[BRIGHT] = profile.share;
            sum += residual * residual;
            for (int k = 0; k < UNKNOWNS; k++) {
                g[k] += row[k] * residual;
                for (int m = 0; m < UNKNOWNS; m++) {
                    n[k * UNKNOWNS + m] += row[k] * row[m];
                }
            }
        }
        return sum;
    }

    /** Puts the meeting point of sides i and j at corner j of {@link #refined}. */
    private boolean intersect(int i, int j) {
        double determinant = line[3 * i] * line[3 * j + 1] - line[3 * j] * line[3 * i + 1];
        if (Math.abs(determinant) < 1e-3) {
            return false;
        }
        refined[2 * j] = (line[3 * i + 1] * line[3 * j + 2] - line[3 * j + 1] * line[3 * i + 2]) / determinant;
        refined[2 * j + 1] = (line[3 * j] * line[3 * i + 2] - line[3 * i] * line[3 * j + 2]) / determinant;
        return true;
    }
}
