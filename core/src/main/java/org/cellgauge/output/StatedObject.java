package org.cellgauge.output;

import org.jspecify.annotations.Nullable;

/** An object as the cell states it; immutable. */
public final class StatedObject extends Value {
    private final int id;
    private final double sizeMm;
    private final double @Nullable [] gripMm;

    StatedObject(int id, double sizeMm, double @Nullable [] gripMm) {
        this.id = id;
        this.sizeMm = Figures.finite(sizeMm);
        this.gripMm = gripMm == null ? null : Figures.finite(gripMm);
    }

    /**
     * The object.
     *
     * @return marker id
     */
    public int id() {
        return id;
    }

    /**
     * Side of its marker.
     *
     * @return mm
     */
    public double sizeMm() {
        return sizeMm;
    }

    /**
     * Its gripping point.
     *
     * @return x, y, z in the marker's frame, mm, a new array; null where it has none
     */
    public double @Nullable [] gripMm() {
        return gripMm == null ? null : gripMm.clone();
    }

    @Override
    @Nullable Object[] figures() {
        return new @Nullable Object[] {id, sizeMm, gripMm};
    }
}
