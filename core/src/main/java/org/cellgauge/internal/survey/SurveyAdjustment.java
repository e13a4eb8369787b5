package org.cellgauge.internal.survey;

import java.util.Arrays;
import org.cellgauge.internal.geometry.DampedGaussNewton;

/**
 * The search for the mode of a survey: the unknowns that all photos share are damped, the photos' own follow them, as
 * in a calibration. Not thread-safe.
 */
final class SurveyAdjustment implements DampedGaussNewton.Problem {
    private static final int MAX_STEPS = 60;
    /** Length of a step, in deviations, that is none. */
    private static final double ENOUGH_STDS = 1e-4;

    private final SurveyModel model;
    private final SurveyState state;
    private final SurveyState trial;
    private final ViewEquations[] own;
    private final double[] ownStep;
    private final double[] noNoise;
    private final double[] work;

    SurveyAdjustment(SurveyModel model, SurveyState start) {
        this.model = model;
        state = start;
        trial = new SurveyState(model.layout, model.views);
        own = new ViewEquations[model.views.size()];
        int most = 0;
        for (int v = 0; v < own.length; v++) {
            own[v] = new ViewEquations(model.views.get(v).locals(), model.shared());
            most = Math.max(most, model.views.get(v).locals());
        }
        ownStep = new double[most];
        noNoise = new double[most];
        work = new double[most];
    }

    /** Fits; the state that this was made with stands at the mode then. The cost there; not finite for none. */
    double solve() {
        return new DampedGaussNewton(model.shared(), DampedGaussNewton.Damping.NIELSEN, MAX_STEPS).minimise(this);
    }

    @Override
    public double linearise(double[] information, double[] gradient) {
        Arrays.fill(information, 0);
        Arrays.fill(gradient, 0);
        double cost = model.linearisePriors(state, information, gradient);
        for (int v = 0; v < own.length; v++) {
            cost += model.lineariseView(state, v, own[v], information, gradient);
        }
        mirror(information, model.shared());
        return cost;
    }

    static void mirror(double[] information, int n) {
        for (int a = 0; a < n; a++) {
            for (int b = 0; b < a; b++) {
                information[b * n + a] = information[a * n + b];
            }
        }
    }

    @Override
    public double at(double[] step) {
        trial.moveShared(state, step);
        for (int v = 0; v < own.length; v++) {
            own[v].follow(step, true, noNoise, 0, ownStep, 0, work);
            trial.moveOwn(state, v, ownStep, 0);
        }
        return SurveyModel.isCamera(trial) ? model.cost(trial) : Double.POSITIVE_INFINITY;
    }

    @Override
    public void accept() {
        state.copyFrom(trial);
    }

    @Override
    public boolean isEnough(double squaredStds, double before, double after, boolean accepted) {
        return squaredStds < ENOUGH_STDS * ENOUGH_STDS;
    }
}
