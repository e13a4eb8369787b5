package org.cellgauge.internal.statistics;

/**
 * Mean direction and circular standard deviation of a stream of angles, in constant memory and mergeable.
 *
 * <p>Every angle counts as the unit vector that points along it, so 0.01 and 6.27 rad average to about 0 and not
 * to about pi. Definitions as in Mardia &amp; Jupp 2000, "Directional Statistics", Wiley: mean direction in section
 * 2.2, mean resultant length and circular standard deviation in section 2.3.
 *
 * <p>Not safe for use by several threads at once.
 */
public final class CircularMoments {
    /**
     * Below this resultant length the unit vectors cancel to within rounding: each cosine is good to one unit in the
     * last place, so a mean this small carries no direction.
     */
    private static final double CANCELLED = 1e-15;

    private double cosineSum;
    private double sineSum;
    // Neumaier's compensation: a million draws of a narrow angle would otherwise lose 1 - R, and with it the deviation
    private double cosineLost;
    private double sineLost;
    private long count;

    /** An empty stream. */
    public CircularMoments() {}

    /**
     * Adds one angle. A non-finite angle makes every statistic NaN for good.
     *
     * @param angleRad any angle, rad
     */
    public void add(double angleRad) {
        addCosine(Math.cos(angleRad));
        addSine(Math.sin(angleRad));
        count++;
    }

    /**
     * Takes in every angle of another stream, which is left as it is.
     *
     * @param other the other stream
     */
    public void merge(CircularMoments other) {
        double otherCosineLost = other.cosineLost;
        double otherSineLost = other.sineLost;
        long otherCount = other.count;
        addCosine(other.cosineSum);
        addSine(other.sineSum);
        cosineLost += otherCosineLost;
        sineLost += otherSineLost;
        count += otherCount;
    }

    /**
     * An independent stream with the same state.
     *
     * @return the copy
     */
    public CircularMoments copy() {
        CircularMoments copy = new CircularMoments();
        copy.cosineSum = cosineSum;
        copy.sineSum = sineSum;
        copy.cosineLost = cosineLost;
        copy.sineLost = sineLost;
        copy.count = count;
        return copy;
    }

    /**
     * Number of angles so far.
     *
     * @return the count, 0 for an empty stream
     */
    public long count() {
        return count;
    }

    /**
     * The mean direction: the direction of the sum of the unit vectors.
     *
     * @return the mean direction in (-pi, pi], rad; NaN where there is none: for an empty stream, and where the unit
     *     vectors cancel to within rounding (resultant length at most 1e-15), as for directions spread evenly
     */
    public double meanDirectionRad() {
        double length = resultantLength();
        if (!(length > CANCELLED)) {
            return Double.NaN;
        }
        double direction = Math.atan2(sineSum + sineLost, cosineSum + cosineLost);
        // A sum of sines of -0.0 gives -pi, the excluded end
        return direction <= -Math.PI ? Math.PI : direction;
    }

    /**
     * The mean resultant length R: 1 if all angles agree, 0 if they cancel.
     *
     * @return R in [0, 1]; NaN for an empty stream
     */
    public double resultantLength() {
        if (count == 0) {
            return Double.NaN;
        }
        double length = Math.hypot(cosineSum + cosineLost, sineSum + sineLost) / count;
        // Rounding can exceed 1 by a few units in the last place, and the logarithm below must not turn positive
        return length > 1 ? 1 : length;
    }

    /**
     * The circular standard deviation sqrt(-2 ln R). For narrow distributions it tends to the ordinary standard
     * deviation with divisor n; for a wrapped normal distribution it is the deviation before wrapping. Because R is
     * close to 1 for a narrow distribution, deviations below about 1e-8 rad cannot be told from zero.
     *
     * @return the circular standard deviation, rad, not negative; infinite where the directions cancel to within
     *     rounding; NaN for an empty stream
     */
    public double stdRad() {
        double length = resultantLength();
        if (length <= CANCELLED) {
            return Double.POSITIVE_INFINITY;
        }
        // max also removes the sign of -0.0
        return Math.sqrt(Math.max(0.0, -2 * Math.log(length)));
    }

    private void addCosine(double value) {
        double sum = cosineSum + value;
        cosineLost += Math.abs(cosineSum) >= Math.abs(value) ? (cosineSum - sum) + value : (value - sum) + cosineSum;
        cosineSum = sum;
    }

    private void addSine(double value) {
        double sum = sineSum + value;
        sineLost += Math.abs(sineSum) >= Math.abs(value) ? (sineSum - sum) + value : (value - sum) + sineSum;
        sineSum = sum;
    }
}
