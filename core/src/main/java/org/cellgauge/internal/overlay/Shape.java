package org.cellgauge.internal.overlay;

import java.util.List;

/**
 * One thing to draw, in image px (pixel centres at +0.5, u right, v down); immutable.
 *
 * <p>Whatever a shape is, {@link #strokes()} has it as lines, so that a painter needs to know nothing else.
 */
public abstract class Shape {
    private final Role role;
    private final Status status;
    private final double strokePx;
    private final boolean dashed;

    Shape(Role role, Status status, double strokePx, boolean dashed) {
        if (!(strokePx > 0)) {
            throw new IllegalArgumentException("stroke width must be positive, not " + strokePx);
        }
        this.role = role;
        this.status = status;
        this.strokePx = strokePx;
        this.dashed = dashed;
    }

    /**
     * What it stands for.
     *
     * @return the role
     */
    public Role role() {
        return role;
    }

    /**
     * How that was judged.
     *
     * @return the status
     */
    public Status status() {
        return status;
    }

    /**
     * Width of its lines; it grows with the image.
     *
     * @return px, positive
     */
    public double strokePx() {
        return strokePx;
    }

    /**
     * Whether its lines are dashed: what they show is not to be relied on, or second choice.
     *
     * @return true for dashes
     */
    public boolean dashed() {
        return dashed;
    }

    /**
     * The shape as lines.
     *
     * @return polylines, each an array u0, v0, u1, v1, … of at least two points; a closed one ends where
     *     it begins
     */
    public abstract List<double[]> strokes();

    /**
     * The smallest box around the shape's strokes.
     *
     * @return the box, without the width of the lines
     */
    public Box bounds() {
        return Box.around(strokes());
    }
}
