package org.cellgauge.cell;

import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.geometry.RigidTransform;

/** A marker with a known place in the world; immutable. */
public final class Reference {
    private final int id;
    private final double sizeMm;
    private final RigidTransform worldFromMarker;
    private final Placement placement;

    /**
     * A reference.
     *
     * @param id marker id
     * @param sizeMm outer edge of the black border, mm, positive
     * @param worldFromMarker nominal pose of the marker in the world
     * @param placement how precisely it was placed there
     */
    public Reference(int id, double sizeMm, RigidTransform worldFromMarker, Placement placement) {
        if (!(sizeMm > 0)) {
            throw new IllegalArgumentException("marker " + id + ": size must be positive, not " + sizeMm);
        }
        this.id = id;
        this.sizeMm = sizeMm;
        this.worldFromMarker = worldFromMarker;
        this.placement = placement;
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
     * Nominal pose in the world.
     *
     * @return worldFromMarker
     */
    public RigidTransform worldFromMarker() {
        return worldFromMarker;
    }

    /**
     * Precision of the placement.
     *
     * @return standard deviations
     */
    public Placement placement() {
        return placement;
    }

    /**
     * Where it might really stand: its nominal pose off by a draw from its placement.
     *
     * @param random source of randomness; six normal numbers are taken from it, three of the place first
     * @return worldFromMarker
     */
    public RigidTransform drawn(RandomGenerator random) {
        double[] shift = new double[3];
        double[] turn = new double[3];
        for (int i = 0; i < 3; i++) {
            shift[i] = placement.stdMm(i) * random.nextGaussian();
        }
        for (int i = 0; i < 3; i++) {
            turn[i] = placement.stdRad() * random.nextGaussian();
        }
        return worldFromMarker.displaced(shift, turn);
    }
}
