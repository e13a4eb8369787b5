package org.cellgauge.internal.overlay;

import java.util.ArrayList;
import java.util.List;

/**
 * One thing to draw, in image px (pixel centres at +0.5, u right, v down); immutable.
 *
 * <p>Whatever a shape is, {@link #draw(Pen)} has it as lines, so that a painter needs to know nothing else.
 */
public abstract sealed class Shape permits EllipseShape, MarkShape, PanelShape, Polyline, TextShape {
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
     * Draws the shape as lines.
     *
     * @param pen gets polylines of at least two points; a closed one ends where it begins
     */
    public abstract void draw(Pen pen);

    /**
     * The shape as lines.
     *
     * @return polylines, each an array u0, v0, u1, v1, … of at least two points; a closed one ends where
     *     it begins
     */
    public List<double[]> strokes() {
        List<double[]> strokes = new ArrayList<>();
        PointRun run = new PointRun(8);
        draw(new Pen() {
            @Override
            public void moveTo(double u, double v) {
                run.flush(strokes);
                run.add(u, v);
            }

            @Override
            public void lineTo(double u, double v) {
                run.add(u, v);
            }
        });
        run.flush(strokes);
        return strokes;
    }

    /**
     * The smallest box around the shape's strokes.
     *
     * @return the box, without the width of the lines
     */
    public Box bounds() {
        Extent extent = new Extent();
        draw(extent);
        return new Box(extent.left, extent.top, extent.right, extent.bottom);
    }

    private static final class Extent implements Pen {
        private double left = Double.POSITIVE_INFINITY;
        private double top = Double.POSITIVE_INFINITY;
        private double right = Double.NEGATIVE_INFINITY;
        private double bottom = Double.NEGATIVE_INFINITY;

        @Override
        public void moveTo(double u, double v) {
            lineTo(u, v);
        }

        @Override
        public void lineTo(double u, double v) {
            left = Math.min(left, u);
            right = Math.max(right, u);
            top = Math.min(top, v);
            bottom = Math.max(bottom, v);
        }
    }
}
