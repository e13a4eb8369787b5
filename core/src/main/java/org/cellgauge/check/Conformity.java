package org.cellgauge.check;

/**
 * How probable it is that a true value lies within what is tolerated about the stated one, held against what is asked
 * (conformance probability: JCGM 106:2012, section 7); immutable.
 *
 * @param of what is tolerated
 * @param tolerance in {@link Of#unit()}
 * @param probability share of the draws that keep the tolerance
 * @param mcse Monte Carlo error of that: one standard error
 * @param asked the least probability allowed
 */
public record Conformity(Of of, double tolerance, double probability, double mcse, double asked) {
    /** What is tolerated. */
    public enum Of {
        /** The coordinate along world x. */
        X("x", "mm"),
        /** The coordinate along world y. */
        Y("y", "mm"),
        /** The coordinate along world z. */
        Z("z", "mm"),
        /** The distance of the point from the stated one. */
        DISTANCE("distance", "mm"),
        /** The angle by which the object is turned from the stated orientation, about whatever axis. */
        TURN("turn", "deg");

        private final String key;
        private final String unit;

        Of(String key, String unit) {
            this.key = key;
            this.unit = unit;
        }

        /**
         * Its word in files.
         *
         * @return such as {@code distance}
         */
        public String key() {
            return key;
        }

        /**
         * Its unit.
         *
         * @return {@code mm} or {@code deg}
         */
        public String unit() {
            return unit;
        }
    }

    /** By how much the probability is beyond what is asked, in its Monte Carlo errors; negative where it is below. */
    double margin() {
        double difference = probability - asked;
        return difference == 0 ? 0 : difference / mcse;
    }

    /**
     * Whether the tolerance is kept as it seems, without allowance for the Monte Carlo error.
     *
     * @return true where the probability is at least the one asked for
     */
    public boolean isKept() {
        return probability >= asked;
    }

    /**
     * Whether the probability is above or below what is asked by more than its guard band, twice its Monte Carlo error
     * (JCGM 106:2012, section 8.3).
     *
     * @return false where more draws could turn the verdict
     */
    public boolean isDecided() {
        return Math.abs(probability - asked) > TargetTest.GUARD_ERRORS * mcse;
    }
}
