package org.cellgauge.placement;

import java.util.OptionalInt;
import org.cellgauge.internal.warning.Decimal;
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
        /** That the corners of {@link Misfit#markerId()} are of a square, by how square the others are. */
        NO_SQUARE,
        /** That {@link Misfit#markerId()} and {@link Misfit#otherId()} are two markers: they are in one place of it. */
        ONE_PLACE_IN_PHOTO,
        /** Nothing; the cell file has {@link Misfit#markerId()} and {@link Misfit#otherId()} in one place. */
        ONE_PLACE_IN_CELL,
        /** Nothing; chains and Laplace's approximation of the same figures are far apart. */
        CHAINS_APART,
        /** Stated placements and corner noise together, and no single reference stands out. */
        REFERENCES,
        /** What is stated, by the cause {@link Misfit#cause()}. */
        CAUSE,
        /** The places of references, so that no pose makes sense of them, and nothing explains it. */
        CONTRADICTION
    }

    private final Kind kind;
    private final OptionalInt markerId;
    private final OptionalInt otherId;
    private final double times;
    private final double statedStdPx;
    private final double shownStdPx;
    private final @Nullable Explanation cause;
    private final @Nullable String causeText;

    private Misfit(Kind kind, OptionalInt markerId, OptionalInt otherId, double times, double statedStdPx,
            double shownStdPx, @Nullable Explanation cause, @Nullable String causeText) {
        this.cause = cause;
        this.causeText = causeText;
        this.kind = kind;
        this.markerId = markerId;
        this.otherId = otherId;
        this.times = times;
        this.statedStdPx = statedStdPx;
        this.shownStdPx = shownStdPx;
    }

    /**
     * A misfit found earlier.
     *
     * @param kind what is contradicted
     * @param markerId as {@link #markerId()}
     * @param otherId as {@link #otherId()}
     * @param times as {@link #times()}
     * @param statedStdPx as {@link #statedStdPx()}
     * @param shownStdPx as {@link #shownStdPx()}
     * @param causeText as {@link #causeText()}
     * @return the misfit, without the parts of its cause
     */
    public static Misfit of(Kind kind, OptionalInt markerId, OptionalInt otherId, double times, double statedStdPx,
            double shownStdPx, @Nullable String causeText) {
        return new Misfit(kind, markerId, otherId, times, statedStdPx, shownStdPx, null, causeText);
    }

    static Misfit ofNoise(double times, double statedStdPx, double shownStdPx) {
        return new Misfit(Kind.NOISE, OptionalInt.empty(), OptionalInt.empty(), times, statedStdPx,
                shownStdPx, null, null);
    }

    static Misfit ofMarker(int markerId, double times, double statedStdPx) {
        return new Misfit(Kind.MARKER, OptionalInt.of(markerId), OptionalInt.empty(), times, statedStdPx,
                Double.NaN, null, null);
    }

    static Misfit ofNoSquare(int markerId, double times) {
        return new Misfit(Kind.NO_SQUARE, OptionalInt.of(markerId), OptionalInt.empty(), times, Double.NaN,
                Double.NaN, null, null);
    }

    static Misfit ofOverlap(boolean inPhoto, int markerId, int otherId) {
        return new Misfit(inPhoto ? Kind.ONE_PLACE_IN_PHOTO : Kind.ONE_PLACE_IN_CELL, OptionalInt.of(markerId),
                OptionalInt.of(otherId), Double.NaN, Double.NaN, Double.NaN, null, null);
    }

    /**
     * A misfit of the model with itself.
     *
     * @return one of the kind {@link Kind#CHAINS_APART}
     */
    public static Misfit ofChains() {
        return new Misfit(Kind.CHAINS_APART, OptionalInt.empty(), OptionalInt.empty(), Double.NaN, Double.NaN,
                Double.NaN, null, null);
    }

    static Misfit ofReferences(double times) {
        return new Misfit(Kind.REFERENCES, OptionalInt.empty(), OptionalInt.empty(), times, Double.NaN,
                Double.NaN, null, null);
    }

    static Misfit ofCause(Explanation cause) {
        return new Misfit(Kind.CAUSE, OptionalInt.empty(), OptionalInt.empty(), Double.NaN, Double.NaN, Double.NaN,
                cause, cause.warning().toString());
    }

    static Misfit ofContradiction() {
        return new Misfit(Kind.CONTRADICTION, OptionalInt.empty(), OptionalInt.empty(), Double.NaN, Double.NaN,
                Double.NaN, null, null);
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
     * The marker that is out of line.
     *
     * @return its id; empty where all corners or references are
     */
    public OptionalInt markerId() {
        return markerId;
    }

    /**
     * The cause that explains it.
     *
     * @return null but for {@link Kind#CAUSE}, and of a misfit that a file has kept
     */
    public @Nullable Explanation cause() {
        return cause;
    }

    /**
     * What is said of that cause, in English.
     *
     * @return a sentence without a full stop; null but for {@link Kind#CAUSE}
     */
    public @Nullable String causeText() {
        return causeText;
    }

    /**
     * The marker in the same place.
     *
     * @return its id; empty where no two are in one place
     */
    public OptionalInt otherId() {
        return otherId;
    }

    /**
     * How many times worse than stated the fit is: root of chi-square by its degrees of freedom. For {@link
     * Kind#NO_SQUARE}, than that of the others.
     *
     * @return more than 1; NaN where there is no such figure
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
                return String.format(Decimal.POINT, " But corners are %.1f times noisier than the stated %.3f px: "
                        + "figures promise too much; state pixel_std_px: %.3f, or leave pixel_std_px out.", times,
                        statedStdPx, shownStdPx);
            case MARKER:
                return String.format(Decimal.POINT, " But the corners of marker %d are %.1f times noisier than the "
                        + "stated %.3f px: see whether it is covered, smudged or bent.", markerId.getAsInt(),
                        times, statedStdPx);
            case CAUSE:
            case CONTRADICTION:
                return " But " + contradiction();
            case NO_SQUARE:
                return String.format(Decimal.POINT,
                        " But the corners of marker %d fit no square, %.1f times worse than "
                        + "those of the others: see whether it is covered, smudged or bent.", markerId.getAsInt(),
                        times);
            case ONE_PLACE_IN_PHOTO:
                return String.format(Decimal.POINT, " But markers %d and %d are seen in one place: one of the two is "
                        + "misread.", markerId.getAsInt(), otherId.getAsInt());
            case CHAINS_APART:
                return " But chains and Laplace's approximation are far apart: state smaller placement deviations, or "
                        + "add references.";
            case ONE_PLACE_IN_CELL:
                return String.format(Decimal.POINT, " But the cell file has references %d and %d in one place: correct "
                        + "the position of one.", markerId.getAsInt(), otherId.getAsInt());
            default:
                return String.format(Decimal.POINT, " But the references together fit %.1f times worse than stated: "
                        + "measure their positions again.", times);
        }
    }

    /** The same where it is all there is to say: a sentence that may stand alone. */
    public String contradiction() {
        switch (kind) {
            case CAUSE:
                return "references do not fit together: " + causeText + ".";
            case REFERENCES:
                return String.format(Decimal.POINT, "the references together fit %.1f times worse than stated, and no "
                        + "single cause explains it: measure their positions again.", times);
            default:
                return Warning.of(CheckWarning.REFERENCES_CONTRADICT) + ".";
        }
    }
}
