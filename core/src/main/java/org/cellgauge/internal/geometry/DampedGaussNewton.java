package org.cellgauge.internal.geometry;

/**
 * Nonlinear least squares by damped Gauss-Newton (Levenberg-Marquardt): steps solve {@code (J^T J + damping) s = -J^T
 * r}, and the damping follows from whether they lessen the sum of squares (Madsen, Nielsen, Tingleff, "Methods for
 * non-linear least squares problems", 2nd ed. 2004, section 3.2). Damping is in proportion to the diagonal of J^T J, so
 * that units of the unknowns do not matter.
 *
 * <p>Allocates nothing in a fit; not thread-safe.
 */
public final class DampedGaussNewton {
    /**
     * A sum of squares to be made small. It holds the point where the fit stands, in whatever coordinates it likes; a
     * step is in those that its derivative is by.
     */
    public interface Problem {
        /**
         * Evaluates sum of squares and derivative at the point where the fit stands.
         *
         * @param information receives J^T J, unknowns x unknowns, both triangles
         * @param gradient receives J^T r, one value per unknown
         * @return the cost: the sum of squares, or half of it; not finite where there is none
         */
        double linearise(double[] information, double[] gradient);

        /**
         * The cost a step further, without going there.
         *
         * @param step one value per unknown; not to be changed
         * @return the cost; infinite or NaN where there is none
         */
        double at(double[] step);

        /** Goes where the last step led. */
        void accept();

        /**
         * Whether the last step was so small, or gained so little, that the fit ends with it. Asked before it is taken.
         *
         * @param squaredStds its squared length in standard deviations of the damped problem
         * @param before cost before it
         * @param after cost after it
         * @param accepted whether it will be taken
         * @return true to end
         */
        boolean isEnough(double squaredStds, double before, double after, boolean accepted);
    }

    /** How damping starts, and how it follows the success of steps. */
    public enum Damping {
        /**
         * Nielsen's: it shrinks by how well the linear model has foretold the gain of a step, and grows ever faster
         * while steps fail (algorithm 3.16 there). For a cost that is half the sum of squares.
         */
        NIELSEN(1e-4, 2, 1e30) {
            @Override
            double damped(double diagonal, double lambda) {
                return diagonal + lambda * diagonal;
            }

            @Override
            double afterSuccess(double lambda, double ratio) {
                double shrink = 2 * ratio - 1;
                return lambda * Math.max(1.0 / 3, 1 - shrink * shrink * shrink);
            }

            @Override
            double fasterGrowth(double growth) {
                return 2 * growth;
            }
        },
        /**
         * Marquardt's own: a tenth after every success, ten times as much after every failure. A direction that nothing
         * tells of is kept finite. For fits of a few steps, where the model's forecast says little.
         */
        TENFOLD(1e-3, 10, 1e6) {
            @Override
            double damped(double diagonal, double lambda) {
                return diagonal * (1 + lambda) + RIDGE;
            }

            @Override
            double afterSuccess(double lambda, double ratio) {
                return lambda / 10;
            }

            @Override
            double fasterGrowth(double growth) {
                return growth;
            }
        };

        private final double first;
        private final double growth;
        private final double limit;

        Damping(double first, double growth, double limit) {
            this.first = first;
            this.growth = growth;
            this.limit = limit;
        }

        abstract double damped(double diagonal, double lambda);

        abstract double afterSuccess(double lambda, double ratio);

        abstract double fasterGrowth(double growth);
    }

    private static final double RIDGE = 1e-9;
    /** Least damping after a matrix that could not be factored. */
    private static final double LEAST_FOR_SINGULAR = 1e-12;

    private final int unknowns;
    private final Damping damping;
    private final int maxSteps;
    private final double[] information;
    private final double[] gradient;
    private final double[] damped;
    private final double[] step;
    private boolean singular;

    /**
     * A solver.
     *
     * @param unknowns number of unknowns, at least 1
     * @param damping how it is damped
     * @param maxSteps steps tried at most, failures included
     */
    public DampedGaussNewton(int unknowns, Damping damping, int maxSteps) {
        this.unknowns = unknowns;
        this.damping = damping;
        this.maxSteps = maxSteps;
        information = new double[unknowns * unknowns];
        damped = new double[unknowns * unknowns];
        gradient = new double[unknowns];
        step = new double[unknowns];
    }

    /**
     * Fits from where a problem stands.
     *
     * @param problem what is fitted; it stands at the result afterwards
     * @return the cost there; that of the start where it is not finite
     */
    public double minimise(Problem problem) {
        double cost = problem.linearise(information, gradient);
        singular = !(cost < Double.POSITIVE_INFINITY);
        double lambda = damping.first;
        double growth = damping.growth;
        for (int i = 0; i < maxSteps && cost < Double.POSITIVE_INFINITY; i++) {
            System.arraycopy(information, 0, damped, 0, damped.length);
            for (int k = 0; k < unknowns; k++) {
                int at = k * (unknowns + 1);
                damped[at] = damping.damped(information[at], lambda);
                step[k] = -gradient[k];
            }
            singular = !Cholesky.factor(damped, unknowns);
            if (singular) {
                lambda = Math.max(lambda * growth, LEAST_FOR_SINGULAR);
                growth = damping.fasterGrowth(growth);
                if (lambda > damping.limit) {
                    return cost;
                }
                continue;
            }
            Cholesky.solveLower(damped, unknowns, step);
            double squaredStds = 0;
            for (double s : step) {
                squaredStds += s * s;
            }
            Cholesky.solveUpper(damped, unknowns, step);
            double before = cost;
            double after = problem.at(step);
            boolean accepted = after <= before;
            boolean enough = problem.isEnough(squaredStds, before, after, accepted);
            if (accepted) {
                double foretold = foretold(lambda);
                problem.accept();
                cost = problem.linearise(information, gradient);
                lambda = damping.afterSuccess(lambda, foretold > 0 ? (before - after) / foretold : 1);
                growth = damping.growth;
            }
            if (enough) {
                return cost;
            }
            if (!accepted) {
                lambda *= growth;
                growth = damping.fasterGrowth(growth);
                if (lambda > damping.limit) {
                    return cost;
                }
            }
        }
        return cost;
    }

    /** What the linear model says the step gains of half the sum of squares. */
    private double foretold(double lambda) {
        double sum = 0;
        for (int k = 0; k < unknowns; k++) {
            sum -= step[k] * gradient[k];
            sum += 0.5 * lambda * information[k * (unknowns + 1)] * step[k] * step[k];
        }
        return 0.5 * sum;
    }

    /**
     * Whether the last fit ended because its equations could not be solved.
     *
     * @return true where J^T J was not finite, or not positive definite whatever the damping
     */
    public boolean isSingular() {
        return singular;
    }
}
