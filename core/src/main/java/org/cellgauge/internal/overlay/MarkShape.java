package org.cellgauge.internal.overlay;

/** A {@link Mark} at a place; immutable. */
public final class MarkShape extends Shape {
    private final Mark mark;
    private final double centreU;
    private final double centreV;
    private final double radiusPx;

    /**
     * A mark.
     *
     * @param role what it stands for
     * @param status how that was judged
     * @param strokePx line width, px
     * @param mark the sign
     * @param centreU u of its centre
     * @param centreV v of its centre
     * @param radiusPx half its size, px
     */
    public MarkShape(Role role, Status status, double strokePx, Mark mark, double centreU, double centreV,
            double radiusPx) {
        super(role, status, strokePx, false);
        this.mark = mark;
        this.centreU = centreU;
        this.centreV = centreV;
        this.radiusPx = radiusPx;
    }

    /**
     * The sign.
     *
     * @return the mark
     */
    public Mark mark() {
        return mark;
    }

    /**
     * Its centre.
     *
     * @return u, v in px
     */
    public double[] centrePx() {
        return new double[] {centreU, centreV};
    }

    @Override
    public void draw(Pen pen) {
        for (double[] line : mark.lines()) {
            pen.moveTo(centreU + radiusPx * line[0], centreV + radiusPx * line[1]);
            for (int i = 2; i < line.length; i += 2) {
                pen.lineTo(centreU + radiusPx * line[i], centreV + radiusPx * line[i + 1]);
            }
        }
    }
}
