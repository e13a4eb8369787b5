package org.cellgauge.output;

import org.jspecify.annotations.Nullable;

/** A reference as the cell states it; immutable. */
public final class StatedReference extends Value {
    private final int id;
    private final double sizeMm;
    private final double[] positionMm;
    private final double[] rotationRad;
    private final double[] stdMm;
    private final double stdRad;

    StatedReference(int id, double sizeMm, double[] positionMm, double[] rotationRad, double[] stdMm, double stdRad) {
        this.id = id;
        this.sizeMm = Figures.finite(sizeMm);
        this.positionMm = Figures.finite(positionMm);
        this.rotationRad = Figures.finite(rotationRad);
        this.stdMm = Figures.finite(stdMm);
        this.stdRad = Figures.finite(stdRad);
    }

    /**
     * The reference.
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
     * Where its centre is.
     *
     * @return x, y, z in the world, mm; a new array
     */
    public double[] positionMm() {
        return positionMm.clone();
    }

    /**
     * How it is turned.
     *
     * @return psi, theta, phi in rad, in (-pi, pi]; a new array
     */
    public double[] rotationRad() {
        return rotationRad.clone();
    }

    /**
     * How precisely it was placed.
     *
     * @return standard deviations along world x, y, z, mm; a new array
     */
    public double[] stdMm() {
        return stdMm.clone();
    }

    /**
     * How precisely it was turned.
     *
     * @return standard deviation of each component of a rotation vector, rad
     */
    public double stdRad() {
        return stdRad;
    }

    @Override
    @Nullable Object[] figures() {
        return new @Nullable Object[] {id, sizeMm, positionMm, rotationRad, stdMm, stdRad};
    }
}
