package org.cellgauge.internal.survey;

import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.geometry.Rotations;

/**
 * Metropolis draws of a survey by proposals that leave Laplace's approximation as it is: from the step d off the mode
 * to {@code rho d + sqrt(1 - rho^2) L xi}, so that only what the posterior differs from that approximation decides
 * (preconditioned Crank-Nicolson: S. L. Cotter, G. O. Roberts, A. M. Stuart, D. White, "MCMC methods for functions:
 * modifying old algorithms to make them faster", Statistical Science 2013, section 4). Acceptance does not fall with
 * the number of unknowns as it does for random walks, nor does the difference add up to nothing accepted as it does
 * where every unknown is drawn anew.
 *
 * <p>Steps lead along rigid motions of the whole cell ({@link CommonMotion}).
 *
 * <p>Every tenth proposal steps farther or less far than the others, so that a chain in the posterior's tails, which
 * the approximation has lighter than it should, does not stay there. Not thread-safe.
 */
final class SurveyChain {
    private static final double[] PERSISTENCES = {0, 0.3, 0.5, 0.7, 0.85, 0.93, 0.97};
    private static final int TRIALS = 40;
    private static final double SHARE_OF_OTHERS = 0.1;

    private final SurveyFit fit;
    private final SurveyModel model;
    private final CommonMotion common;
    private final RandomGenerator random;
    private final SurveyState state;
    private final double[] step;
    private final double[] proposed;
    private final double[] white;
    private final double[] work;
    private final double[] proposedWhite;
    private final double[] whiteNow;
    /** Where everything is off the mode, positions after the bend. */
    private final double[] shown;
    private double logRatio;
    private double rho = PERSISTENCES[0];
    private long evaluations;
    private long accepted;

    /** A chain that starts at a draw of Laplace's approximation. */
    SurveyChain(SurveyFit fit, SurveyModel ownModel, RandomGenerator random) {
        this.fit = fit;
        this.model = ownModel;
        this.random = random;
        common = new CommonMotion(fit, ownModel);
        state = new SurveyState(model.layout, model.views);
        int n = fit.unknowns();
        step = new double[n];
        proposed = new double[n];
        white = new double[n];
        proposedWhite = new double[n];
        whiteNow = new double[n];
        shown = new double[n];
        work = new double[Math.max(1, fit.mostLocals())];
        do {
            SurveyFit.normal(random, whiteNow);
            fit.colour(whiteNow, step, work);
            logRatio = logRatio(step, whiteNow);
        } while (logRatio == Double.NEGATIVE_INFINITY);
        show();
    }

    /** Takes over where the state just looked at is. */
    private void show() {
        System.arraycopy(step, 0, shown, 0, step.length);
        for (int r = 0; r < model.layout.references.size(); r++) {
            for (int i = SurveyLayout.POSE * r; i < SurveyLayout.POSE * r + 3; i++) {
                shown[i] = state.values[i] - fit.mode.values[i];
            }
        }
        for (int o = 0; o < model.layout.objects.size(); o++) {
            for (int i = 0; i < 3; i++) {
                int at = SurveyState.TRANSFORM * o + 9 + i;
                shown[model.layout.firstObject + SurveyLayout.POSE * o + i] = state.objects[at] - fit.mode.objects[at];
            }
        }
    }

    /** Logarithm of posterior over approximation, up to a constant, at a step off the mode. */
    private double logRatio(double[] at, double[] normal) {
        evaluations++;
        state.moveShared(fit.mode, at);
        int first = model.shared();
        double haar = 0;
        for (int o = 0; o < model.layout.objects.size(); o++) {
            haar += haar(at, model.layout.firstObject + SurveyLayout.POSE * o);
        }
        for (int v = 0; v < model.views.size(); v++) {
            state.moveOwn(fit.mode, v, at, first);
            haar += haar(at, first);
            int moving = first + SurveyLayout.POSE + model.views.get(v).edges;
            first += model.views.get(v).locals();
            for (; moving < first; moving += SurveyLayout.POSE) {
                haar += haar(at, moving);
            }
        }
        common.bend(at, state);
        if (!(state.lens[PinholeCamera.FX] > 0 && state.lens[PinholeCamera.FY] > 0)) {
            return Double.NEGATIVE_INFINITY;
        }
        double squares = 0;
        for (double z : normal) {
            squares += z * z;
        }
        double value = haar + 0.5 * squares - (model.cost(state) - fit.cost);
        return Double.isNaN(value) ? Double.NEGATIVE_INFINITY : value;
    }

    private static double haar(double[] at, int pose) {
        return Rotations.logHaarDensity(at[pose + 3], at[pose + 4], at[pose + 5]);
    }

    /** One proposal; whether it was taken. */
    private boolean propose(double persistence) {
        SurveyFit.normal(random, white);
        double fresh = Math.sqrt(1 - persistence * persistence);
        for (int i = 0; i < white.length; i++) {
            proposedWhite[i] = persistence * whiteNow[i] + fresh * white[i];
        }
        fit.colour(proposedWhite, proposed, work);
        double ratio = logRatio(proposed, proposedWhite);
        if (Math.log(random.nextDouble()) < ratio - logRatio) {
            System.arraycopy(proposed, 0, step, 0, step.length);
            System.arraycopy(proposedWhite, 0, whiteNow, 0, whiteNow.length);
            logRatio = ratio;
            show();
            return true;
        }
        return false;
    }

    /** Chooses how far to step by how far steps of each size came; draws until then are no draws. */
    void tune() {
        double best = -1;
        double chosen = PERSISTENCES[0];
        for (double persistence : PERSISTENCES) {
            int taken = 0;
            for (int i = 0; i < TRIALS; i++) {
                taken += propose(persistence) ? 1 : 0;
            }
            double jump = taken * (1 - persistence);
            if (jump > best) {
                best = jump;
                chosen = persistence;
            }
        }
        rho = chosen;
        evaluations = 0;
        accepted = 0;
    }

    /** How much of a step is kept in the next proposal. */
    double persistence() {
        return rho;
    }

    /** Takes over how far another chain steps. */
    void stepAs(double persistence) {
        rho = persistence;
    }

    /** Moves on by one proposal. */
    void advance() {
        double persistence = random.nextDouble() < SHARE_OF_OTHERS
                ? PERSISTENCES[random.nextInt(PERSISTENCES.length)] : rho;
        accepted += propose(persistence) ? 1 : 0;
    }

    /** Evaluations of the posterior since the tuning. */
    long evaluations() {
        return evaluations;
    }

    long accepted() {
        return accepted;
    }

    /** How far everything that photos share is off the mode where the chain is; shared, not to be changed. */
    double[] offMode() {
        return shown;
    }

    /** The state where the chain is, in a work space of its own. */
    SurveyState state(SurveyState into) {
        into.moveShared(fit.mode, step);
        int first = model.shared();
        for (int v = 0; v < model.views.size(); v++) {
            into.moveOwn(fit.mode, v, step, first);
            first += model.views.get(v).locals();
        }
        common.bend(step, into);
        return into;
    }
}
