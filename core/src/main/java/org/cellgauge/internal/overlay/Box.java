package org.cellgauge.internal.overlay;

import java.util.Collection;

/** A box along the image's axes, in px; immutable. */
public final class Box {
    private final double left;
    private final double top;
    private final double right;
    private final double bottom;

    /**
     * A box.
     *
     * @param left smallest u
     * @param top smallest v
     * @param right largest u, at least left
     * @param bottom largest v, at least top
     * @throws IllegalArgumentException if the sides are out of order or not numbers
     */
    public Box(double left, double top, double right, double bottom) {
        if (!(left <= right && top <= bottom)) {
            throw new IllegalArgumentException("not a box: " + left + ", " + top + ", " + right + ", " + bottom);
        }
        this.left = left;
        this.top = top;
        this.right = right;
        this.bottom = bottom;
    }

    /**
     * The smallest box around polylines.
     *
     * @param strokes polylines u0, v0, u1, v1, …, at least one point in all
     * @return the box
     */
    public static Box around(Collection<double[]> strokes) {
        double left = Double.POSITIVE_INFINITY;
        double top = Double.POSITIVE_INFINITY;
        double right = Double.NEGATIVE_INFINITY;
        double bottom = Double.NEGATIVE_INFINITY;
        for (double[] s : strokes) {
            for (int i = 0; i < s.length; i += 2) {
                left = Math.min(left, s[i]);
                right = Math.max(right, s[i]);
                top = Math.min(top, s[i + 1]);
                bottom = Math.max(bottom, s[i + 1]);
            }
        }
        return new Box(left, top, right, bottom);
    }

    /**
     * Smallest u.
     *
     * @return px
     */
    public double left() {
        return left;
    }

    /**
     * Smallest v.
     *
     * @return px
     */
    public double top() {
        return top;
    }

    /**
     * Largest u.
     *
     * @return px
     */
    public double right() {
        return right;
    }

    /**
     * Largest v.
     *
     * @return px
     */
    public double bottom() {
        return bottom;
    }

    /**
     * Width.
     *
     * @return px
     */
    public double width() {
        return right - left;
    }

    /**
     * Height.
     *
     * @return px
     */
    public double height() {
        return bottom - top;
    }

    /**
     * The box with a margin around it.
     *
     * @param margin px, on every side
     * @return a new box
     */
    public Box grown(double margin) {
        return new Box(left - margin, top - margin, right + margin, bottom + margin);
    }

    /**
     * The box moved.
     *
     * @param du to the right
     * @param dv down
     * @return a new box
     */
    public Box moved(double du, double dv) {
        return new Box(left + du, top + dv, right + du, bottom + dv);
    }

    /**
     * The area two boxes share.
     *
     * @param other the other box
     * @return px², 0 where they only touch
     */
    public double overlap(Box other) {
        double w = Math.min(right, other.right) - Math.max(left, other.left);
        double h = Math.min(bottom, other.bottom) - Math.max(top, other.top);
        return w > 0 && h > 0 ? w * h : 0;
    }

    /**
     * Whether another box lies in this one.
     *
     * @param other the other box
     * @return true if no part of it sticks out
     */
    public boolean contains(Box other) {
        return other.left >= left && other.right <= right && other.top >= top && other.bottom <= bottom;
    }

    /**
     * The shortest way between two boxes.
     *
     * @param other the other box
     * @return px, 0 where they touch or overlap
     */
    public double distance(Box other) {
        double du = Math.max(0, Math.max(other.left - right, left - other.right));
        double dv = Math.max(0, Math.max(other.top - bottom, top - other.bottom));
        return Math.hypot(du, dv);
    }

    @Override
    public String toString() {
        return "[" + left + ", " + right + "] x [" + top + ", " + bottom + "]";
    }
}
