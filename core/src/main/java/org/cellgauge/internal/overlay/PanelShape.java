package org.cellgauge.internal.overlay;

/** A box behind texts, to be filled so that they stand out; immutable. */
public final class PanelShape extends Shape {
    private final Box box;

    /**
     * A panel.
     *
     * @param role what it stands for
     * @param status how that was judged
     * @param strokePx width of its edge, px
     * @param box where it is
     */
    public PanelShape(Role role, Status status, double strokePx, Box box) {
        super(role, status, strokePx, false);
        this.box = box;
    }

    @Override
    public Box bounds() {
        return box;
    }

    @Override
    public void draw(Pen pen) {
        pen.moveTo(box.left(), box.top());
        pen.lineTo(box.right(), box.top());
        pen.lineTo(box.right(), box.bottom());
        pen.lineTo(box.left(), box.bottom());
        pen.lineTo(box.left(), box.top());
    }
}
