package org.cellgauge.cell;

import org.jspecify.annotations.Nullable;

/** A marker on an object that the robot will grip, with its gripping point where one is given; immutable. */
public final class ObjectMarker {
    private final int id;
    private final double sizeMm;
    private final double @Nullable [] gripMm;
    private final boolean moves;

    /**
     * An object marker.
     *
     * @param id marker id
     * @param sizeMm outer edge of the black border, mm, positive
     * @param gripMm gripping point in the marker's frame, 3 values, mm, or null where none is given; copied
     */
    public ObjectMarker(int id, double sizeMm, double @Nullable [] gripMm) {
        this(id, sizeMm, gripMm, false);
    }

    /**
     * An object marker that may stand elsewhere in every photo.
     *
     * @param id marker id
     * @param sizeMm outer edge of the black border, mm, positive
     * @param gripMm gripping point in the marker's frame, 3 values, mm, or null where none is given; copied
     * @param moves whether it moves between photos of one survey; one photo alone does not care
     */
    public ObjectMarker(int id, double sizeMm, double @Nullable [] gripMm, boolean moves) {
        if (!(sizeMm > 0)) {
            throw new IllegalArgumentException("marker " + id + ": size must be positive, not " + sizeMm);
        }
        this.id = id;
        this.sizeMm = sizeMm;
        this.gripMm = gripMm == null ? null : gripMm.clone();
        this.moves = moves;
    }

    /**
     * Whether it moves between photos of one survey.
     *
     * @return false for an object that stands still
     */
    public boolean moves() {
        return moves;
    }

    /**
     * Marker id.
     *
     * @return the id within the cell's family
     */
    public int id() {
        return id;
    }

    /**
     * Outer edge of the black border.
     *
     * @return mm
     */
    public double sizeMm() {
        return sizeMm;
    }

    /**
     * Whether a gripping point is given.
     *
     * @return true if {@link #gripMm()} is not null
     */
    public boolean hasGrip() {
        return gripMm != null;
    }

    /**
     * Gripping point in the marker's frame.
     *
     * @return a copy of its 3 coordinates, mm, or null where none is given
     */
    public double @Nullable [] gripMm() {
        return gripMm == null ? null : gripMm.clone();
    }
}
