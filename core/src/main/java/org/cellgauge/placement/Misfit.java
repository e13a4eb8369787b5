package org.cellgauge.placement;

import java.util.Locale;
import java.util.OptionalInt;

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
        REFERENCES
    }

    private final Kind kind;
    private final OptionalInt markerId;
    private final OptionalInt otherId;
    private final double times;
    private final double statedStdPx;
    private final double shownStdPx;

    private Misfit(Kind kind, OptionalInt markerId, OptionalInt otherId, double times, double statedStdPx,
            double shownStdPx) {
        this.kind = kind;
        this.markerId = markerId;
        this.otherId = otherId;
        this.times = times;
        this.statedStdPx = statedStdPx;
        this.shownStdPx = shownStdPx;
    }

    static Misfit ofNoise(double times, double statedStdPx, double shownStdPx) {
        return new Misfit(Kind.NOISE, OptionalInt.empty(), OptionalInt.empty(), times, statedStdPx, shownStdPx);
    }

    static Misfit ofMarker(int markerId, double times, double statedStdPx) {
        return new Misfit(Kind.MARKER, OptionalInt.of(markerId), OptionalInt.empty(), times, statedStdPx, Double.NaN);
    }

    static Misfit ofNoSquare(int markerId, double times) {
        return new Misfit(Kind.NO_SQUARE, OptionalInt.of(markerId), OptionalInt.empty(), times, Double.NaN,
                Double.NaN);
    }

    static Misfit ofOverlap(boolean inPhoto, int markerId, int otherId) {
        return new Misfit(inPhoto ? Kind.ONE_PLACE_IN_PHOTO : Kind.ONE_PLACE_IN_CELL, OptionalInt.of(markerId),
                OptionalInt.of(otherId), Double.NaN, Double.NaN, Double.NaN);
    }

    /**
     * A misfit of the model with itself.
     *
     * @return one of the kind {@link Kind#CHAINS_APART}
     */
    public static Misfit ofChains() {
        return new Misfit(Kind.CHAINS_APART, OptionalInt.empty(), OptionalInt.empty(), Double.NaN, Double.NaN,
                Double.NaN);
    }

    static Misfit ofReferences(double times) {
        return new Misfit(Kind.REFERENCES, OptionalInt.empty(), OptionalInt.empty(), times, Double.NaN, Double.NaN);
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
                return String.format(Locale.ROOT, " But corners are %.1f times noisier than the stated %.3f px: "
                        + "figures promise too much; state pixel_std_px: %.3f, or leave pixel_std_px out.", times,
                        statedStdPx, shownStdPx);
            case MARKER:
                return String.format(Locale.ROOT, " But the corners of marker %d are %.1f times noisier than the "
                        + "stated %.3f px: see whether it is covered, smudged or bent.", markerId.getAsInt(),
                        times, statedStdPx);
            case NO_SQUARE:
                return String.format(Locale.ROOT, " But the corners of marker %d fit no square, %.1f times worse than "
                        + "those of the others: see whether it is covered, smudged or bent.", markerId.getAsInt(),
                        times);
            case ONE_PLACE_IN_PHOTO:
                return String.format(Locale.ROOT, " But markers %d and %d are seen in one place: one of the two is "
                        + "misread.", markerId.getAsInt(), otherId.getAsInt());
            case CHAINS_APART:
                return " But chains and Laplace's approximation are far apart: state smaller placement deviations, or "
                        + "add references.";
            case ONE_PLACE_IN_CELL:
                return String.format(Locale.ROOT, " But the cell file has references %d and %d in one place: correct "
                        + "the position of one.", markerId.getAsInt(), otherId.getAsInt());
            default:
                return String.format(Locale.ROOT, " But the references together fit %.1f times worse than stated: "
                        + "measure their positions again.", times);
        }
    }
}
