package org.cellgauge.internal.overlay;

import org.cellgauge.statistics.Ellipse;

/** An ellipse; it may reach beyond the image. Immutable. */
public final class EllipseShape extends Shape {
    private static final int POINTS = 96;
    private final Ellipse ellipse;

    /**
     * An ellipse.
     *
     * @param role what it stands for
     * @param status how that was judged
     * @param strokePx line width, px
     * @param dashed whether it is dashed
     * @param ellipse centre, semi-axes in px and angle as drawn, any magnification included
     */
    public EllipseShape(Role role, Status status, double strokePx, boolean dashed, Ellipse ellipse) {
        super(role, status, strokePx, dashed);
        this.ellipse = ellipse;
    }

    /**
     * The ellipse as drawn.
     *
     * @return centre and semi-axes in px, angle from u towards v in rad
     */
    public Ellipse ellipse() {
        return ellipse;
    }

    @Override
    public void draw(Pen pen) {
        double cos = Math.cos(ellipse.angleRad());
        double sin = Math.sin(ellipse.angleRad());
        for (int i = 0; i <= POINTS; i++) {
            double t = 2 * Math.PI * (i % POINTS) / POINTS;
            double along = ellipse.semiMajor() * Math.cos(t);
            double across = ellipse.semiMinor() * Math.sin(t);
            double u = ellipse.centreX() + cos * along - sin * across;
            double v = ellipse.centreY() + sin * along + cos * across;
            if (i == 0) {
                pen.moveTo(u, v);
            } else {
                pen.lineTo(u, v);
            }
        }
    }
}
