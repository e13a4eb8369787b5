package org.cellgauge.output;

import org.jspecify.annotations.Nullable;

/** What becomes of one object without the references that seem misplaced; immutable. */
public final class MovedObject extends Value {
    private final int id;
    private final PoseView pose;
    private final double[] moveMm;
    private final double[] errorMm;
    private final @Nullable MovedGrip grip;

    MovedObject(int id, PoseView pose, double[] moveMm, double[] errorMm, @Nullable MovedGrip grip) {
        this.id = id;
        this.pose = pose;
        this.moveMm = Figures.finite(moveMm);
        this.errorMm = Figures.finite(errorMm);
        this.grip = grip;
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
     * Its pose by Laplace's approximation.
     *
     * @return object in world
     */
    public PoseView pose() {
        return pose;
    }

    /**
     * How far it moves when the references are left out.
     *
     * @return along world x, y, z, mm; a new array
     */
    public double[] moveMm() {
        return moveMm.clone();
    }

    /**
     * Root mean square error of the position that the result states, if the references are misplaced.
     *
     * @return along world x, y, z, mm; a new array
     */
    public double[] errorMm() {
        return errorMm.clone();
    }

    /**
     * The same of its gripping point.
     *
     * @return null where it has none
     */
    public @Nullable MovedGrip grip() {
        return grip;
    }

    @Override
    @Nullable Object[] figures() {
        return new @Nullable Object[] {id, pose, moveMm, errorMm, grip};
    }
}
