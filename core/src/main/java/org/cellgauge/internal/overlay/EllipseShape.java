package org.cellgauge.internal.overlay;

import java.util.Collections;
import java.util.List;
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
    public List<double[]> strokes() {
        double[][] boundary = ellipse.boundary(POINTS);
        double[] points = new double[2 * POINTS + 2];
        for (int i = 0; i <= POINTS; i++) {
            System.arraycopy(boundary[i % POINTS], 0, points, 2 * i, 2);
        }
        return Collections.singletonList(points);
    }
}
