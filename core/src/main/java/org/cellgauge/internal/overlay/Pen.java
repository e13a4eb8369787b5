package org.cellgauge.internal.overlay;

/** What a shape draws its lines with, point by point, so that a painter needs no list of them. Positions are in px. */
public interface Pen {
    /**
     * Begins a line.
     *
     * @param u to the right
     * @param v down
     */
    void moveTo(double u, double v);

    /**
     * Goes on with the line.
     *
     * @param u to the right
     * @param v down
     */
    void lineTo(double u, double v);
}
