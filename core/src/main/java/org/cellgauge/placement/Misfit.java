package org.cellgauge.placement;

import java.util.Locale;
import java.util.OptionalInt;
import org.cellgauge.warning.CheckWarning;
import org.cellgauge.warning.Warning;
import org.jspecify.annotations.Nullable;

/** What the photo contradicts of what the figures rest on, so that no target counts as met; immutable. */
public final class Misfit {
    /** What it contradicts. */
    public enum Kind {
        /** The stated corner noise, by how square markers are. */
        NOISE,
        /** The same of the one marker {@link Misfit#markerId()} alone. */
        MARKER,
        /** Stated placements and corner noise together, and no single reference stands out. */
        REFERENCES,
        /** What is stated, by the cause {@link Misfit#cause()}. */
        CAUSE,
        /** The places of references, so that no pose makes sense of them, and nothing explains it. */
        CONTRADICTION
    }

    private final Kind kind;
    private final OptionalInt markerId;
    private final double times;
    private final double statedStdPx;
    private final double shownStdPx;
    private final @Nullable Explanation cause;

    private Misfit(Kind kind, OptionalInt markerId, double times, double statedStdPx, double shownStdPx,
            @Nullable Explanation cause) {
        this.cause = cause;
        this.kind = kind;
        this.markerId = markerId;
        this.times = times;
        this.statedStdPx = statedStdPx;
        this.shownStdPx = shownStdPx;
    }

    static Misfit ofNoise(double times, double statedStdPx, double shownStdPx) {
        return new Misfit(Kind.NOISE, OptionalInt.empty(), times, statedStdPx, shownStdPx, null);
    }

    static Misfit ofMarker(int markerId, double times, double statedStdPx) {
        return new Misfit(Kind.MARKER, OptionalInt.of(markerId), times, statedStdPx, Double.NaN, null);
    }

    static Misfit ofReferences(double times) {
        return new Misfit(Kind.REFERENCES, OptionalInt.empty(), times, Double.NaN, Double.NaN, null);
    }

    static Misfit ofCause(Explanation cause) {
        return new Misfit(Kind.CAUSE, OptionalInt.empty(), Double.NaN, Double.NaN, Double.NaN, cause);
    }

    static Misfit ofContradiction() {
        return new Misfit(Kind.CONTRADICTION, OptionalInt.empty(), Double.NaN, Double.NaN, Double.NaN, null);
    }

    /**
     * What the photo contradicts.
     *
     * @return the kind
     */
    public Kind kind() {
        return kind;
    }

    /**
     * The one marker whose corners are worse than stated.
     *
     * @return its id; empty but for {@link Kind#MARKER}
     */
    public OptionalInt markerId() {
        return markerId;
    }

    /**
     * The cause that explains it.
     *
     * @return null but for {@link Kind#CAUSE}
     */
    public @Nullable Explanation cause() {
        return cause;
    }

    /**
     * How many times worse than stated the fit is: root of chi-square by its degrees of freedom.
     *
     * @return more than 1; NaN for {@link Kind#CAUSE} and {@link Kind#CONTRADICTION}
     */
    public double times() {
        return times;
    }

    /**
     * The stated noise of corners.
     *
     * @return px; NaN but for {@link Kind#NOISE} and {@link Kind#MARKER}
     */
    public double statedStdPx() {
        return statedStdPx;
    }

    /**
     * The noise that the photo shows.
     *
     * @return px; NaN but for {@link Kind#NOISE}
     */
    public double shownStdPx() {
        return shownStdPx;
    }

    /** What it adds to a reason. */
    public String english() {
        switch (kind) {
            case NOISE:
                return String.format(Locale.ROOT, " But corners are %.1f times noisier than the stated %.3f px: "
                        + "figures promise too much; state pixel_std_px: %.3f, or leave pixel_std_px out.", times,
                        statedStdPx, shownStdPx);
            case MARKER:
                return String.format(Locale.ROOT, " But the corners of marker %d are %.1f times noisier than the "
                        + "stated %.3f px: see whether it is covered, smudged or bent.", markerId.getAsInt(),
                        times, statedStdPx);
            case CAUSE:
            case CONTRADICTION:
                return " But " + contradiction();
            default:
                return String.format(Locale.ROOT, " But the references together fit %.1f times worse than stated: "
                        + "measure their positions again.", times);
        }
    }

    /** The same where it is all there is to say: a sentence that may stand alone. */
    public String contradiction() {
        switch (kind) {
            case CAUSE:
                return "references do not fit together: " + cause.warning() + ".";
            case REFERENCES:
                return String.format(Locale.ROOT, "the references together fit %.1f times worse than stated, and no "
                        + "single cause explains it: measure their positions again.", times);
            default:
                return Warning.of(CheckWarning.REFERENCES_CONTRADICT) + ".";
        }
    }
}
