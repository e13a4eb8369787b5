package org.cellgauge.internal.statistics;

/**
 * Unrolls angles about a fixed direction, so that draws close to that direction can be treated as numbers on a line.
 *
 * <p>Mean, covariance and chain diagnostics assume numbers on a line. Draws of an angle that cross the seam at pi jump
 * by 2 pi there although the direction hardly moves. Expressed as the reference plus the shortest turn from it, they
 * stay together as long as they lie within half a turn of the reference.
 */
public final class ReferenceAngle {
    private final double referenceRad;

    /**
     * Unrolls about a direction, usually the mean direction or the mode.
     *
     * @param referenceRad the direction, rad
     * @throws IllegalArgumentException if it is not finite
     */
    public ReferenceAngle(double referenceRad) {
        if (!Double.isFinite(referenceRad)) {
            throw new IllegalArgumentException("the reference angle must be finite, was " + referenceRad);
        }
        this.referenceRad = Angles.wrapToPi(referenceRad);
    }

    /**
     * The direction about which angles are unrolled.
     *
     * @return the reference in (-pi, pi], rad
     */
    public double referenceRad() {
        return referenceRad;
    }

    /**
     * The representative of an angle that is closest to the reference.
     *
     * @param angleRad any angle, rad
     * @return the same direction in (reference - pi, reference + pi], rad; NaN for a non-finite angle
     */
    public double unroll(double angleRad) {
        return referenceRad + Angles.difference(angleRad, referenceRad);
    }
}
