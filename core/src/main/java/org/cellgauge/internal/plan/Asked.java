package org.cellgauge.internal.plan;

import org.cellgauge.cell.Requirement;
import org.cellgauge.internal.statistics.NormalBall;
import org.jspecify.annotations.Nullable;

/**
 * What is asked of one point, as limits of variances: errors are taken as normal, so that a tolerance is a limit of a
 * deviation. A distance, and a turn, limit the sum of three variances as if all of it lay along one line, which is
 * never too little where the probability asked for is large; {@link #ratio} then says what it really is.
 */
public final class Asked {
    /** What counts where nothing is asked of anything: 1 mm. */
    static final Requirement ONE_MM = Requirement.ofStdMm(1);

    private final Requirement asked;
    private final double deviations;

    /**
     * Limits.
     *
     * @param asked of one object
     */
    public Asked(Requirement asked) {
        this.asked = asked;
        deviations = NormalBall.deviations(asked.probability());
    }

    /** The largest deviation along an axis, mm; infinite where none is asked for. */
    double limitMm(int axis) {
        return Math.min(asked.stdMm().of(axis), asked.toleranceMm().of(axis) / deviations);
    }

    /** The largest root of the trace of a position's covariance, mm. */
    double traceLimitMm() {
        return asked.distanceMm() / deviations;
    }

    /** The largest root of the trace of an orientation's covariance, rad. */
    double traceLimitRad() {
        return Math.toRadians(asked.toleranceDeg()) / deviations;
    }

    /** How much of what is allowed is taken, at most, squared: 1 where it is just met. */
    double square(double[] covarianceMm2, double @Nullable [] turnRad2) {
        double most = trace(covarianceMm2) / (traceLimitMm() * traceLimitMm());
        for (int axis = 0; axis < 3; axis++) {
            most = Math.max(most, covarianceMm2[4 * axis] / (limitMm(axis) * limitMm(axis)));
        }
        return turnRad2 == null ? most : Math.max(most, trace(turnRad2) / (traceLimitRad() * traceLimitRad()));
    }

    /**
     * How much of what is allowed is taken.
     *
     * @param covarianceMm2 of the point, 3 x 3 row by row, mm²
     * @param turnRad2 of the orientation's rotation vector, 3 x 3, rad²; null where none is asked about
     * @return 1 where it is just met; infinite where nothing is known
     */
    public double ratio(double[] covarianceMm2, double @Nullable [] turnRad2) {
        if (!Double.isFinite(trace(covarianceMm2))) {
            return Double.POSITIVE_INFINITY;
        }
        double most = 0;
        for (int axis = 0; axis < 3; axis++) {
            most = Math.max(most, Math.sqrt(covarianceMm2[4 * axis]) / limitMm(axis));
        }
        if (asked.distanceMm() < Double.POSITIVE_INFINITY) {
            most = Math.max(most, NormalBall.distance(covarianceMm2, asked.probability()) / asked.distanceMm());
        }
        if (turnRad2 != null && asked.toleranceDeg() < Double.POSITIVE_INFINITY) {
            most = Math.max(most, Math.toDegrees(NormalBall.distance(turnRad2, asked.probability()))
                    / asked.toleranceDeg());
        }
        return most;
    }

    /** The least probability of keeping a tolerance; NaN where there is none. */
    double probability(double[] covarianceMm2, double @Nullable [] turnRad2) {
        if (!asked.asksForProbability()) {
            return Double.NaN;
        }
        if (!Double.isFinite(trace(covarianceMm2))) {
            return 0;
        }
        double least = 1;
        for (int axis = 0; axis < 3; axis++) {
            least = Math.min(least, NormalBall.within(asked.toleranceMm().of(axis)
                    / Math.sqrt(covarianceMm2[4 * axis])));
        }
        if (asked.distanceMm() < Double.POSITIVE_INFINITY) {
            least = Math.min(least, NormalBall.within(covarianceMm2, asked.distanceMm()));
        }
        if (turnRad2 != null && asked.toleranceDeg() < Double.POSITIVE_INFINITY) {
            least = Math.min(least, NormalBall.within(turnRad2, Math.toRadians(asked.toleranceDeg())));
        }
        return least;
    }

    static double trace(double[] covariance) {
        return covariance[0] + covariance[4] + covariance[8];
    }
}
