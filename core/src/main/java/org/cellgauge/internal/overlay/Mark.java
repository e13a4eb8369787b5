package org.cellgauge.internal.overlay;

import org.jspecify.annotations.Nullable;

/** A sign that says a status by its form alone, drawn in a square of side 2 around (0, 0), v down. */
public enum Mark {
    /** A check mark: within the target. */
    CHECK(new double[][] {{-0.8, 0.05, -0.25, 0.65, 0.85, -0.7}}),
    /** A cross: beyond the target. */
    CROSS(new double[][] {{-0.7, -0.7, 0.7, 0.7}, {0.7, -0.7, -0.7, 0.7}}),
    /** A triangle with an exclamation mark: not converged. */
    WARNING(new double[][] {{0, -0.95, 1, 0.85, -1, 0.85, 0, -0.95}, {0, -0.3, 0, 0.2}, {0, 0.5, 0, 0.52}}),
    /** Two overlapping squares: two poses explain it. */
    TWO(new double[][] {{-0.9, -0.9, 0.35, -0.9, 0.35, 0.35, -0.9, 0.35, -0.9, -0.9},
        {-0.35, -0.35, 0.9, -0.35, 0.9, 0.9, -0.35, 0.9, -0.35, -0.35}}),
    /** A plus sign: a point in the image. */
    PLUS(new double[][] {{-1, 0, 1, 0}, {0, -1, 0, 1}});

    private final double[][] lines;

    Mark(double[][] lines) {
        this.lines = lines;
    }

    double[][] lines() {
        return lines;
    }

    /**
     * The mark of a status.
     *
     * @param status the status
     * @return its mark, or null for {@link Status#NEUTRAL}
     */
    public static @Nullable Mark of(Status status) {
        switch (status) {
            case PASS:
                return CHECK;
            case FAIL:
                return CROSS;
            case NOT_CONVERGED:
                return WARNING;
            case AMBIGUOUS:
                return TWO;
            default:
                return null;
        }
    }
}
