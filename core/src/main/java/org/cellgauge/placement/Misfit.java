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
        /** Stated placements and corner noise together, and no single reference stands out. */
        REFERENCES
    }

    private final Kind kind;
    private final OptionalInt markerId;
    private final double times;
    private final double statedStdPx;
    private final double shownStdPx;

    private Misfit(Kind kind, OptionalInt markerId, double times, double statedStdPx, double shownStdPx) {
        this.kind = kind;
        this.markerId = markerId;
        this.times = times;
        this.statedStdPx = statedStdPx;
        this.shownStdPx = shownStdPx;
    }

    /**
     * A misfit found earlier.
     *
     * @param kind what is contradicted
     * @param markerId the one marker of {@link Kind#MARKER}, else empty
     * @param times how many times worse than stated the fit is
     * @param statedStdPx the stated noise of corners, px; NaN for {@link Kind#REFERENCES}
     * @param shownStdPx the noise that the photo shows, px; NaN but for {@link Kind#NOISE}
     * @return the misfit
     */
    public static Misfit of(Kind kind, OptionalInt markerId, double times, double statedStdPx, double shownStdPx) {
        return new Misfit(kind, markerId, times, statedStdPx, shownStdPx);
    }

    static Misfit ofNoise(double times, double statedStdPx, double shownStdPx) {
        return new Misfit(Kind.NOISE, OptionalInt.empty(), times, statedStdPx, shownStdPx);
    }

    static Misfit ofMarker(int markerId, double times, double statedStdPx) {
        return new Misfit(Kind.MARKER, OptionalInt.of(markerId), times, statedStdPx, Double.NaN);
    }

    static Misfit ofReferences(double times) {
        return new Misfit(Kind.REFERENCES, OptionalInt.empty(), times, Double.NaN, Double.NaN);
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
     * How many times worse than stated the fit is: root of chi-square by its degrees of freedom.
     *
     * @return more than 1
     */
    public double times() {
        return times;
    }

    /**
     * The stated noise of corners.
     *
     * @return px; NaN for {@link Kind#REFERENCES}
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
            default:
                return String.format(Locale.ROOT, " But the references together fit %.1f times worse than stated: "
                        + "measure their positions again.", times);
        }
    }
}
