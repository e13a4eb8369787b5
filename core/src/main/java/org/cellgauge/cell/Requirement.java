package org.cellgauge.cell;

/**
 * What is asked of one object: of its position, and of its gripping point where it has one; immutable. All of it must
 * hold. What is not asked is infinite.
 *
 * <p>A tolerance is kept where the true value lies within it of the stated one with at least the probability asked for
 * (conformance probability: JCGM 106:2012, section 7).
 *
 * @param stdMm largest standard deviation along each axis of the world, mm
 * @param toleranceMm how far the true coordinate along each axis may be from the stated one, mm
 * @param distanceMm how far the true point may be from the stated one, mm
 * @param toleranceDeg how far the true orientation of the object may be turned from the stated one, about any axis,
 *     degrees; nothing of a gripping point
 * @param probability of each coordinate, distance and turn to be within its tolerance, above 0 and below 1; of no
 *     meaning where there is no tolerance
 */
public record Requirement(Axes stdMm, Axes toleranceMm, double distanceMm, double toleranceDeg, double probability) {
    /** The probability that counts where none is stated. */
    public static final double USUAL_PROBABILITY = 0.95;
    /** Nothing is asked. */
    public static final Requirement NONE = new Requirement(Axes.NONE, Axes.NONE, Double.POSITIVE_INFINITY,
            Double.POSITIVE_INFINITY, USUAL_PROBABILITY);

    /**
     * A limit along each axis of the world.
     *
     * @param x along x, positive, infinite for none
     * @param y along y
     * @param z along z
     */
    public record Axes(double x, double y, double z) {
        /** No limit. */
        public static final Axes NONE = all(Double.POSITIVE_INFINITY);

        /**
         * Limits.
         *
         * @throws IllegalArgumentException if one is not positive
         */
        public Axes {
            if (!(x > 0 && y > 0 && z > 0)) {
                throw new IllegalArgumentException("a limit must be positive, not (" + x + ", " + y + ", " + z + ")");
            }
        }

        /**
         * The same along every axis.
         *
         * @param limit positive
         * @return the limits
         */
        public static Axes all(double limit) {
            return new Axes(limit, limit, limit);
        }

        /**
         * The limit along an axis.
         *
         * @param axis 0, 1 or 2 for x, y, z
         * @return infinite where there is none
         */
        public double of(int axis) {
            return axis == 0 ? x : axis == 1 ? y : z;
        }

        /**
         * Whether it is one limit along every axis.
         *
         * @return false where there is none
         */
        public boolean isUniform() {
            return x == y && y == z && isAny();
        }

        /**
         * Whether there is a limit along any axis.
         *
         * @return false where there is none
         */
        public boolean isAny() {
            return Math.min(x, Math.min(y, z)) < Double.POSITIVE_INFINITY;
        }
    }

    /**
     * A requirement.
     *
     * @throws IllegalArgumentException if a tolerance is not positive, or the probability not between 0 and 1
     */
    public Requirement {
        if (!(distanceMm > 0 && toleranceDeg > 0)) {
            throw new IllegalArgumentException("a tolerance must be positive");
        }
        if (!(probability > 0 && probability < 1)) {
            throw new IllegalArgumentException("a probability must be between 0 and 1, not " + probability);
        }
    }

    /**
     * Standard deviations alone, the same along every axis.
     *
     * @param stdMm the largest allowed, mm, positive
     * @return the requirement
     */
    public static Requirement ofStdMm(double stdMm) {
        return new Requirement(Axes.all(stdMm), Axes.NONE, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY,
                USUAL_PROBABILITY);
    }

    /**
     * Whether a probability is asked for.
     *
     * @return true where there is a tolerance
     */
    public boolean asksForProbability() {
        return toleranceMm.isAny() || distanceMm < Double.POSITIVE_INFINITY
                || toleranceDeg < Double.POSITIVE_INFINITY;
    }

    /**
     * Whether anything is asked.
     *
     * @return false for {@link #NONE} and its like
     */
    public boolean isAny() {
        return stdMm.isAny() || asksForProbability();
    }

    /**
     * Whether standard deviations alone are asked for, the same along every axis.
     *
     * @return true for {@link #ofStdMm}
     */
    public boolean isOneStd() {
        return stdMm.isUniform() && !asksForProbability();
    }

    @Override
    public String toString() {
        StringBuilder out = new StringBuilder();
        part(out, stdMm, "a standard deviation of ", " mm");
        part(out, toleranceMm, "within ", " mm");
        if (distanceMm < Double.POSITIVE_INFINITY) {
            out.append(out.length() == 0 ? "" : ", ").append("within a distance of ").append(plain(distanceMm))
                    .append(" mm");
        }
        if (toleranceDeg < Double.POSITIVE_INFINITY) {
            out.append(out.length() == 0 ? "" : ", ").append("turned by at most ").append(plain(toleranceDeg))
                    .append(" degrees");
        }
        return asksForProbability() ? out.append(" with probability ").append(plain(probability)).toString()
                : out.length() == 0 ? "nothing" : out.toString();
    }

    private static void part(StringBuilder out, Axes limits, String before, String after) {
        if (limits.isAny()) {
            out.append(out.length() == 0 ? "" : ", ").append(before).append(limits.isUniform() ? plain(limits.x())
                    : "(" + plain(limits.x()) + ", " + plain(limits.y()) + ", " + plain(limits.z()) + ")")
                    .append(after);
        }
    }

    private static String plain(double value) {
        return Double.isInfinite(value) ? "any"
                : value == Math.rint(value) && value < 1e9 ? String.valueOf((long) value) : String.valueOf(value);
    }
}
