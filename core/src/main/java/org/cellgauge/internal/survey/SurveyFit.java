package org.cellgauge.internal.survey;

import java.util.Arrays;
import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.Cholesky;
import org.jspecify.annotations.Nullable;

/**
 * The mode of a survey with the covariance that Laplace's method gives of everything; immutable but for work space,
 * for one thread.
 */
final class SurveyFit {
    private static final int POSE = SurveyLayout.POSE;

    final SurveyModel model;
    final SurveyState mode;
    final double cost;
    /** Of what all photos share, own unknowns eliminated; both triangles. */
    final double[] information;
    final double[] covariance;
    /** Lower Cholesky factor of the information. */
    final double[] factor;
    final ViewEquations[] own;

    private SurveyFit(SurveyModel model, SurveyState mode, double cost, double[] information, double[] factor,
            double[] covariance, ViewEquations[] own) {
        this.model = model;
        this.mode = mode;
        this.cost = cost;
        this.information = information;
        this.factor = factor;
        this.covariance = covariance;
        this.own = own;
    }

    /** Fits from a start; null where no mode is found from there. */
    static @Nullable SurveyFit of(SurveyModel model, SurveyState start) {
        double cost = new SurveyAdjustment(model, start).solve();
        if (!Double.isFinite(cost)) {
            return null;
        }
        int n = model.shared();
        double[] information = new double[n * n];
        double[] gradient = new double[n];
        model.linearisePriors(start, information, gradient);
        ViewEquations[] own = new ViewEquations[model.views.size()];
        for (int v = 0; v < own.length; v++) {
            own[v] = new ViewEquations(model.views.get(v).locals(), n);
            model.lineariseView(start, v, own[v], information, gradient);
        }
        SurveyAdjustment.mirror(information, n);
        double[] factor = information.clone();
        if (!Cholesky.factor(factor, n)) {
            return null;
        }
        double[] inverse = new double[n * n];
        Cholesky.invertLower(factor, n, inverse);
        double[] covariance = new double[n * n];
        for (int a = 0; a < n; a++) {
            for (int k = a; k < n; k++) {
                double f = inverse[k * n + a];
                for (int b = 0; b <= a; b++) {
                    covariance[a * n + b] += f * inverse[k * n + b];
                }
            }
        }
        SurveyAdjustment.mirror(covariance, n);
        return new SurveyFit(model, start, cost, information, factor, covariance, own);
    }

    /** The views that it is of. */
    List<SurveyView> views() {
        return model.views;
    }

    /** Covariance of some linear functions of what all photos share: rows x shared values, row by row. */
    double[] sandwich(double[] rows, int count) {
        return sandwich(rows, count, covariance, model.shared());
    }

    static double[] sandwich(double[] rows, int count, double[] covariance, int n) {
        double[] half = new double[count * n];
        for (int i = 0; i < count; i++) {
            for (int a = 0; a < n; a++) {
                double r = rows[i * n + a];
                for (int b = 0; b < n && r != 0; b++) {
                    half[i * n + b] += r * covariance[a * n + b];
                }
            }
        }
        double[] out = new double[count * count];
        for (int i = 0; i < count; i++) {
            for (int j = 0; j < count; j++) {
                double sum = 0;
                for (int a = 0; a < n; a++) {
                    sum += half[i * n + a] * rows[j * n + a];
                }
                out[i * count + j] = sum;
            }
        }
        return out;
    }

    /** Pose of a camera. */
    RigidTransform worldFromCamera(int view) {
        return worldFromCamera(mode, view);
    }

    /** Pose of a camera at another state. */
    RigidTransform worldFromCamera(SurveyState at, int view) {
        RigidTransform cameraFromCentre = SurveyState.get(at.cameras[view], 0);
        return RigidTransform.of(new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1}, model.centreMm)
                .compose(cameraFromCentre.inverse());
    }

    /** Tangent covariance of a camera's pose: position and rotation vector in the world. */
    double[][] cameraCovariance(int view) {
        double[] rows = new double[POSE * model.shared()];
        double[] own = new double[POSE * POSE];
        cameraRows(view, rows, own);
        double[] pose = sandwich(rows, POSE);
        for (int i = 0; i < pose.length; i++) {
            pose[i] += own[i];
        }
        return square(pose, POSE);
    }

    /**
     * A camera's pose in the world, position and rotation vector, by what all photos share.
     *
     * @param rows receives its derivatives, 6 x {@link SurveyModel#shared()}
     * @param ofItself receives the covariance that it has were all of that known, 6 x 6
     */
    void cameraRows(int view, double[] rows, double[] ofItself) {
        ViewEquations equations = own[view];
        int n = model.shared();
        int locals = equations.locals;
        // x = L^-T (noise - Y g): its first six are the pose in the camera frame
        double[] local = new double[POSE * n];
        double[] back = new double[POSE * locals];
        double[] unit = new double[locals];
        for (int i = 0; i < POSE; i++) {
            Arrays.fill(unit, 0);
            unit[i] = 1;
            Cholesky.solveLower(equations.own, locals, unit);
            System.arraycopy(unit, 0, back, i * locals, locals);
            for (int k = 0; k < locals; k++) {
                for (int a = 0; a < n; a++) {
                    local[i * n + a] -= unit[k] * equations.cross[k * n + a];
                }
            }
        }
        double[] jacobian = cameraJacobian(mode.cameras[view]);
        double[] noise = new double[POSE * locals];
        for (int i = 0; i < POSE; i++) {
            for (int k = 0; k < POSE; k++) {
                double j = jacobian[i * POSE + k];
                for (int a = 0; a < n; a++) {
                    rows[i * n + a] += j * local[k * n + a];
                }
                for (int a = 0; a < locals; a++) {
                    noise[i * locals + a] += j * back[k * locals + a];
                }
            }
        }
        for (int i = 0; i < POSE; i++) {
            for (int j = 0; j < POSE; j++) {
                double sum = 0;
                for (int k = 0; k < locals; k++) {
                    sum += noise[i * locals + k] * noise[j * locals + k];
                }
                ofItself[i * POSE + j] = sum;
            }
        }
    }

    /** World pose by the pose in the camera frame: {@code c = g - R^T p}, {@code R_wc = R^T}. */
    static double[] cameraJacobian(double[] camera) {
        double[] j = new double[POSE * POSE];
        double[] p = {camera[9], camera[10], camera[11]};
        for (int i = 0; i < 3; i++) {
            double[] column = {camera[i], camera[3 + i], camera[6 + i]};
            // row i of R^T is column i of R; -R^T [p]x by the turn
            double[] byTurn = {p[2] * column[1] - p[1] * column[2], p[0] * column[2] - p[2] * column[0],
                p[1] * column[0] - p[0] * column[1]};
            for (int c = 0; c < 3; c++) {
                j[i * POSE + c] = -column[c];
                j[i * POSE + 3 + c] = -byTurn[c];
                j[(3 + i) * POSE + 3 + c] = -column[c];
            }
        }
        return j;
    }

    static double[][] square(double[] flat, int n) {
        double[][] out = new double[n][];
        for (int i = 0; i < n; i++) {
            out[i] = Arrays.copyOfRange(flat, i * n, (i + 1) * n);
        }
        return out;
    }

    /** Block of the covariance that belongs to one pose among what all photos share. */
    double[][] block(int first) {
        int n = model.shared();
        double[][] out = new double[POSE][POSE];
        for (int i = 0; i < POSE; i++) {
            System.arraycopy(covariance, (first + i) * n + first, out[i], 0, POSE);
        }
        return out;
    }

    /** Number of all unknowns, those of photos included. */
    int unknowns() {
        int sum = model.shared();
        for (ViewEquations e : own) {
            sum += e.locals;
        }
        return sum;
    }

    /** Turns standard normal numbers into a step of Laplace's approximation: by {@code information^-1/2}. */
    void colour(double[] white, double[] step, double[] work) {
        int n = model.shared();
        System.arraycopy(white, 0, step, 0, n);
        Cholesky.solveUpper(factor, n, step);
        int at = n;
        for (ViewEquations e : own) {
            e.follow(step, false, white, at, step, at, work);
            at += e.locals;
        }
    }

    /** Most unknowns of one photo. */
    int mostLocals() {
        int most = 0;
        for (ViewEquations e : own) {
            most = Math.max(most, e.locals);
        }
        return most;
    }

    /** Fills an array with standard normal numbers. */
    static void normal(RandomGenerator random, double[] out) {
        for (int i = 0; i < out.length; i++) {
            out[i] = random.nextGaussian();
        }
    }
}
