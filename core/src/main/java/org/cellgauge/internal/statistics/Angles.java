package org.cellgauge.internal.statistics;

/** Wrapping and differences of angles in radians. */
public final class Angles {
    private static final double TWO_PI = 2 * Math.PI;

    private Angles() {}

    /**
     * The same direction in (-pi, pi]. An angle already in that interval comes back unchanged, to the last bit.
     *
     * @param angleRad any angle, rad
     * @return the angle in (-pi, pi], rad; NaN for a non-finite angle
     */
    public static double wrapToPi(double angleRad) {
        if (angleRad > -Math.PI && angleRad <= Math.PI) {
            return angleRad;
        }
        if (Math.abs(angleRad) < 1.25 * TWO_PI) {
            // one turn off, as deviations of angles near pi are: the same difference, exact, without a remainder's time
            return angleRad > 0 ? angleRad - TWO_PI : angleRad + TWO_PI;
        }
        // The remainder is exact and lies in [-pi, pi]; only its lower end is outside the half-open interval
        double wrapped = Math.IEEEremainder(angleRad, TWO_PI);
        return wrapped <= -Math.PI ? Math.PI : wrapped;
    }

    /**
     * The same direction in [0, 2 pi). An angle already in that interval comes back unchanged, to the last bit.
     *
     * @param angleRad any angle, rad
     * @return the angle in [0, 2 pi), rad; NaN for a non-finite angle
     */
    public static double wrapToTwoPi(double angleRad) {
        if (angleRad >= 0 && angleRad < TWO_PI) {
            // Adding zero turns -0.0 into 0.0
            return angleRad + 0.0;
        }
        double wrapped = angleRad % TWO_PI;
        if (wrapped < 0) {
            wrapped += TWO_PI;
        }
        // A tiny negative angle plus 2 pi rounds to 2 pi itself, which is outside the half-open interval
        return wrapped >= TWO_PI ? 0.0 : wrapped + 0.0;
    }

    /**
     * The shortest turn that leads from one direction to another.
     *
     * @param toRad where the turn ends, rad
     * @param fromRad where it starts, rad
     * @return {@code toRad - fromRad} in (-pi, pi], rad; NaN for a non-finite angle
     */
    public static double difference(double toRad, double fromRad) {
        return wrapToPi(toRad - fromRad);
    }
}
