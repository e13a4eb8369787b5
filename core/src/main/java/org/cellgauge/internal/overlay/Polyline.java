package org.cellgauge.internal.overlay;

/** A line of straight pieces, closed or open; immutable. */
public final class Polyline extends Shape {
    private final double[] pointsPx;

    /**
     * A polyline.
     *
     * @param role what it stands for
     * @param status how that was judged
     * @param strokePx line width, px
     * @param dashed whether it is dashed
     * @param pointsPx u0, v0, u1, v1, …; at least two points; copied; closed where the last is the first
     * @throws IllegalArgumentException if there are fewer than two points or one is not finite
     */
    public Polyline(Role role, Status status, double strokePx, boolean dashed, double... pointsPx) {
        this(pointsPx.clone(), role, status, strokePx, dashed);
    }

    private Polyline(double[] pointsPx, Role role, Status status, double strokePx, boolean dashed) {
        super(role, status, strokePx, dashed);
        if (pointsPx.length < 4 || pointsPx.length % 2 != 0) {
            throw new IllegalArgumentException("a polyline takes at least two points, not " + pointsPx.length
                    + " values");
        }
        for (double v : pointsPx) {
            if (!Double.isFinite(v)) {
                throw new IllegalArgumentException("a point of a polyline is not finite");
            }
        }
        this.pointsPx = pointsPx;
    }

    /** The same without a copy, of points that nobody changes any more. */
    static Polyline ofOwn(Role role, Status status, double strokePx, boolean dashed, double[] pointsPx) {
        return new Polyline(pointsPx, role, status, strokePx, dashed);
    }

    /**
     * The points.
     *
     * @return a copy, u0, v0, u1, v1, …, px
     */
    public double[] pointsPx() {
        return pointsPx.clone();
    }

    @Override
    public void draw(Pen pen) {
        pen.moveTo(pointsPx[0], pointsPx[1]);
        for (int i = 2; i < pointsPx.length; i += 2) {
            pen.lineTo(pointsPx[i], pointsPx[i + 1]);
        }
    }
}
