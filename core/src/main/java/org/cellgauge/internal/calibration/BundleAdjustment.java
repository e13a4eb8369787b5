package org.cellgauge.internal.calibration;

import java.util.Arrays;
import java.util.List;
import org.cellgauge.geometry.Lens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.geometry.DampedGaussNewton;

/**
 * Lens, shape of the board and the poses of all photos at once, so that reprojection errors become least (B. Triggs et
 * al., "Bundle adjustment - a modern synthesis", 2000).
 *
 * <p>Poses of photos do not meet each other in any error, so they are eliminated from the normal equations one by one
 * (Schur complement, section 6.1 there): what is left is as small as the lens and the board have unknowns, whatever the
 * number of photos. That small system is damped; poses follow its steps.
 */
final class BundleAdjustment implements DampedGaussNewton.Problem {
    /** Deviation of how far light moves the sides of markers, before a photo is seen, px. */
    static final double SHIFT_PRIOR_PX = 0.5;
    private static final int POSE = 6;
    private static final int MAX_STEPS = 60;
    private static final double ENOUGH_GAIN = 1e-10;
    private static final double ENOUGH_STEP = 1e-10;

    private final LensChoice choice;
    private final Lens lens;
    private final BoardShape board;
    private final List<TargetPhoto> photos;
    private final int globals;
    private final int locals;
    private final boolean withShift;
    /** Values of the lens, then of the board. */
    private final double[] values;
    private final double[] trial;
    private double stdPx;

    // work
    private final double[] point = new double[3];
    private final double[] turned = new double[3];
    private final double[] uv = new double[2];
    private final double[] byPoint = new double[6];
    private final double[] byLens;
    private final double[] rowU;
    private final double[] rowV;
    private final double[] ownStep;
    private final double[] information;
    private final double[] gradient;

    /**
     * An adjustment that stands where its photos' poses and the values are.
     *
     * @param choice the lens, and which of its parameters are unknown
     * @param values of the lens, then of the board
     * @param stdPx deviation of a coordinate, px
     */
    BundleAdjustment(LensChoice choice, BoardShape board, List<TargetPhoto> photos, double[] values, double stdPx) {
        this.choice = choice;
        this.lens = choice.lens();
        this.board = board;
        this.photos = photos;
        this.values = values.clone();
        this.stdPx = stdPx;
        trial = values.clone();
        withShift = !photos.isEmpty() && photos.get(0).outwards != null;
        locals = POSE + (withShift ? 1 : 0);
        globals = choice.unknowns() + board.unknowns();
        byLens = new double[2 * lens.parameterCount()];
        rowU = new double[globals + locals];
        rowV = new double[globals + locals];
        ownStep = new double[locals];
        information = new double[globals * globals];
        gradient = new double[globals];
        for (TargetPhoto photo : photos) {
            photo.own = new double[locals * locals];
            photo.ownFactor = new double[locals * locals];
            photo.shared = new double[locals * globals];
            photo.ownGradient = new double[locals];
            photo.reduced = new double[globals * globals];
        }
    }

    /** Fits; afterwards this stands at the result. The cost there; not finite where there is none. */
    double solve() {
        if (globals == 0) {
            return Double.NaN;
        }
        return new DampedGaussNewton(globals, DampedGaussNewton.Damping.NIELSEN, MAX_STEPS).minimise(this);
    }

    void setStdPx(double std) {
        stdPx = std;
    }

    double stdPx() {
        return stdPx;
    }

    double[] values() {
        return values.clone();
    }

    int globals() {
        return globals;
    }

    int locals() {
        return locals;
    }

    /** Information about the unknowns of all photos, poses left free; what the photos' parts add up to with priors. */
    double[] information() {
        linearise(information, gradient);
        return information.clone();
    }

    // ---- the problem

    @Override
    public double linearise(double[] sum, double[] sumGradient) {
        Arrays.fill(sum, 0);
        Arrays.fill(sumGradient, 0);
        double cost = addPriors(values, sum, sumGradient);
        for (TargetPhoto photo : photos) {
            cost += lineariseOne(photo, sum, sumGradient);
        }
        return cost;
    }

    private double addPriors(double[] at, double[] sum, double[] sumGradient) {
        double cost = 0;
        for (int k = 0; k < board.unknowns(); k++) {
            double std = board.priorStd(k);
            double value = at[lens.parameterCount() + k];
            int g = choice.unknowns() + k;
            sum[g * (globals + 1)] += 1 / (std * std);
            sumGradient[g] += value / (std * std);
            cost += 0.5 * value * value / (std * std);
        }
        return cost;
    }

    private double lineariseOne(TargetPhoto photo, double[] sum, double[] sumGradient) {
        Arrays.fill(photo.own, 0);
        Arrays.fill(photo.shared, 0);
        Arrays.fill(photo.ownGradient, 0);
        Arrays.fill(photo.reduced, 0);
        if (photo.activeCount() < 4) {
            return 0;
        }
        double weight = 1 / stdPx;
        double cost = 0;
        for (int i = 0; i < photo.count; i++) {
            if (!photo.active[i]) {
                continue;
            }
            if (!rows(photo, i)) {
                return Double.POSITIVE_INFINITY;
            }
            double errorU = weight * (uv[0] - photo.uv[2 * i]);
            double errorV = weight * (uv[1] - photo.uv[2 * i + 1]);
            cost += 0.5 * (errorU * errorU + errorV * errorV);
            for (int a = 0; a < globals + locals; a++) {
                rowU[a] *= weight;
                rowV[a] *= weight;
            }
            for (int a = 0; a < globals; a++) {
                double u = rowU[a];
                double v = rowV[a];
                sumGradient[a] += u * errorU + v * errorV;
                for (int b = 0; b <= a; b++) {
                    photo.reduced[a * globals + b] += u * rowU[b] + v * rowV[b];
                }
                for (int l = 0; l < locals; l++) {
                    photo.shared[l * globals + a] += u * rowU[globals + l] + v * rowV[globals + l];
                }
            }
            for (int l = 0; l < locals; l++) {
                double u = rowU[globals + l];
                double v = rowV[globals + l];
                photo.ownGradient[l] += u * errorU + v * errorV;
                for (int m = 0; m <= l; m++) {
                    photo.own[l * locals + m] += u * rowU[globals + m] + v * rowV[globals + m];
                }
            }
        }
        if (withShift) {
            double precision = 1 / (SHIFT_PRIOR_PX * SHIFT_PRIOR_PX);
            photo.own[locals * locals - 1] += precision;
            photo.ownGradient[locals - 1] += photo.shift * precision;
            cost += 0.5 * photo.shift * photo.shift * precision;
        }
        return eliminate(photo, sum, sumGradient) ? cost : Double.POSITIVE_INFINITY;
    }

    /** Takes the photo's own unknowns out: the Schur complement, by the Cholesky factor of their block. */
    private boolean eliminate(TargetPhoto photo, double[] sum, double[] sumGradient) {
        System.arraycopy(photo.own, 0, photo.ownFactor, 0, photo.own.length);
        if (!Cholesky.factor(photo.ownFactor, locals)) {
            return false;
        }
        // y = L^-1 shared, h = L^-1 gradient; shared and gradient themselves are kept for the way back
        double[] y = photo.shared.clone();
        double[] h = photo.ownGradient.clone();
        for (int i = 0; i < locals; i++) {
            double pivot = photo.ownFactor[i * locals + i];
            for (int k = 0; k < i; k++) {
                double f = photo.ownFactor[i * locals + k];
                h[i] -= f * h[k];
                for (int a = 0; a < globals; a++) {
                    y[i * globals + a] -= f * y[k * globals + a];
                }
            }
            h[i] /= pivot;
            for (int a = 0; a < globals; a++) {
                y[i * globals + a] /= pivot;
            }
        }
        for (int l = 0; l < locals; l++) {
            for (int a = 0; a < globals; a++) {
                double ya = y[l * globals + a];
                sumGradient[a] -= ya * h[l];
                for (int b = 0; b <= a; b++) {
                    photo.reduced[a * globals + b] -= ya * y[l * globals + b];
                }
            }
        }
        for (int a = 0; a < globals; a++) {
            for (int b = 0; b <= a; b++) {
                double v = photo.reduced[a * globals + b];
                photo.reduced[b * globals + a] = v;
                sum[a * globals + b] += v;
                if (a != b) {
                    sum[b * globals + a] += v;
                }
            }
        }
        return true;
    }

    /** Image of a point and its derivatives by the unknowns of all photos and of this one. */
    private boolean rows(TargetPhoto photo, int i) {
        int index = photo.points[i];
        board.point(index, values, lens.parameterCount(), point);
        double[] r = photo.rotation;
        for (int k = 0; k < 3; k++) {
            turned[k] = r[3 * k] * point[0] + r[3 * k + 1] * point[1] + r[3 * k + 2] * point[2];
        }
        if (!lens.projectWithDerivatives(values, turned[0] + photo.translation[0], turned[1] + photo.translation[1],
                turned[2] + photo.translation[2], uv, byPoint, byLens)) {
            return false;
        }
        choice.select(byLens, rowU, rowV);
        int at = choice.unknowns();
        for (int k = 0; k < board.warp; k++) {
            double b = board.basis[index * board.warp + k];
            rowU[at] = b * (byPoint[0] * r[2] + byPoint[1] * r[5] + byPoint[2] * r[8]);
            rowV[at++] = b * (byPoint[3] * r[2] + byPoint[4] * r[5] + byPoint[5] * r[8]);
        }
        if (board.aspect) {
            double y = board.xyzMm[3 * index + 1];
            rowU[at] = y * (byPoint[0] * r[1] + byPoint[1] * r[4] + byPoint[2] * r[7]);
            rowV[at++] = y * (byPoint[3] * r[1] + byPoint[4] * r[4] + byPoint[5] * r[7]);
        }
        // a turn w moves the point by w x turned
        rowU[at] = byPoint[2] * turned[1] - byPoint[1] * turned[2];
        rowV[at] = byPoint[5] * turned[1] - byPoint[4] * turned[2];
        rowU[at + 1] = byPoint[0] * turned[2] - byPoint[2] * turned[0];
        rowV[at + 1] = byPoint[3] * turned[2] - byPoint[5] * turned[0];
        rowU[at + 2] = byPoint[1] * turned[0] - byPoint[0] * turned[1];
        rowV[at + 2] = byPoint[4] * turned[0] - byPoint[3] * turned[1];
        for (int k = 0; k < 3; k++) {
            rowU[at + 3 + k] = byPoint[k];
            rowV[at + 3 + k] = byPoint[3 + k];
        }
        double[] outwards = photo.outwards;
        if (withShift && outwards != null) {
            rowU[at + 6] = outwards[2 * i];
            rowV[at + 6] = outwards[2 * i + 1];
            uv[0] += photo.shift * outwards[2 * i];
            uv[1] += photo.shift * outwards[2 * i + 1];
        }
        return true;
    }

    @Override
    public double at(double[] step) {
        choice.add(values, step, trial);
        for (int k = 0; k < board.unknowns(); k++) {
            trial[lens.parameterCount() + k] = values[lens.parameterCount() + k] + step[choice.unknowns() + k];
        }
        if (!(trial[PinholeCamera.FX] > 0 && trial[PinholeCamera.FY] > 0)) {
            return Double.POSITIVE_INFINITY;
        }
        double cost = 0;
        for (int k = 0; k < board.unknowns(); k++) {
            double whitened = trial[lens.parameterCount() + k] / board.priorStd(k);
            cost += 0.5 * whitened * whitened;
        }
        for (TargetPhoto photo : photos) {
            if (photo.activeCount() < 4) {
                photo.tryStep(new double[7], withShift);
                continue;
            }
            for (int l = 0; l < locals; l++) {
                double s = -photo.ownGradient[l];
                for (int a = 0; a < globals; a++) {
                    s -= photo.shared[l * globals + a] * step[a];
                }
                ownStep[l] = s;
            }
            Cholesky.solveLower(photo.ownFactor, locals, ownStep);
            Cholesky.solveUpper(photo.ownFactor, locals, ownStep);
            photo.tryStep(ownStep, withShift);
            cost += costAt(photo);
        }
        return cost;
    }

    /** The cost of the only photo's trial, lens and board as they are. */
    double costHere() {
        System.arraycopy(values, 0, trial, 0, values.length);
        return costAt(photos.get(0));
    }

    private double costAt(TargetPhoto photo) {
        double sum = 0;
        for (int i = 0; i < photo.count; i++) {
            if (photo.active[i]) {
                if (!image(photo, i, photo.trialRotation, photo.trialTranslation, photo.trialShift, trial)) {
                    return Double.POSITIVE_INFINITY;
                }
                double du = uv[0] - photo.uv[2 * i];
                double dv = uv[1] - photo.uv[2 * i + 1];
                sum += du * du + dv * dv;
            }
        }
        double whitened = withShift ? photo.trialShift / SHIFT_PRIOR_PX : 0;
        return 0.5 * (sum / (stdPx * stdPx) + whitened * whitened);
    }

    private boolean image(TargetPhoto photo, int i, double[] r, double[] t, double shift, double[] at) {
        board.point(photo.points[i], at, lens.parameterCount(), point);
        if (!lens.project(at, r[0] * point[0] + r[1] * point[1] + r[2] * point[2] + t[0],
                r[3] * point[0] + r[4] * point[1] + r[5] * point[2] + t[1],
                r[6] * point[0] + r[7] * point[1] + r[8] * point[2] + t[2], uv, 0)) {
            return false;
        }
        double[] outwards = photo.outwards;
        if (outwards != null) {
            uv[0] += shift * outwards[2 * i];
            uv[1] += shift * outwards[2 * i + 1];
        }
        return true;
    }

    @Override
    public void accept() {
        System.arraycopy(trial, 0, values, 0, values.length);
        photos.forEach(TargetPhoto::acceptTrial);
    }

    @Override
    public boolean isEnough(double squaredStds, double before, double after, boolean accepted) {
        return accepted && (before - after <= ENOUGH_GAIN * before || squaredStds < ENOUGH_STEP);
    }

    // ---- what is left

    /** Image minus observation of every point, px; NaN where the lens does not see it. */
    double[] residuals(TargetPhoto photo) {
        double[] out = new double[2 * photo.count];
        for (int i = 0; i < photo.count; i++) {
            boolean seen = image(photo, i, photo.rotation, photo.translation, photo.shift, values);
            out[2 * i] = seen ? uv[0] - photo.uv[2 * i] : Double.NaN;
            out[2 * i + 1] = seen ? uv[1] - photo.uv[2 * i + 1] : Double.NaN;
        }
        return out;
    }
}
