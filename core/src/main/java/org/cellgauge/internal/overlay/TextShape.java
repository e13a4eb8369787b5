package org.cellgauge.internal.overlay;

/** One line of text in the letters of {@link StrokeFont}; immutable. */
public final class TextShape extends Shape {
    private final double leftPx;
    private final double baselinePx;
    private final double capHeightPx;
    private final String text;

    /**
     * A line of text.
     *
     * @param role what it stands for
     * @param status how that was judged
     * @param weight line width in cap heights, 0.1 light to 0.2 bold
     * @param leftPx u of its left end
     * @param baselinePx v of the line the letters stand on
     * @param capHeightPx height of a capital letter, positive
     * @param text what it says, one line
     */
    public TextShape(Role role, Status status, double weight, double leftPx, double baselinePx, double capHeightPx,
            String text) {
        super(role, status, weight * capHeightPx, false);
        this.leftPx = leftPx;
        this.baselinePx = baselinePx;
        this.capHeightPx = capHeightPx;
        this.text = text;
    }

    /**
     * u of the left end.
     *
     * @return px
     */
    public double leftPx() {
        return leftPx;
    }

    /**
     * v of the line the letters stand on.
     *
     * @return px
     */
    public double baselinePx() {
        return baselinePx;
    }

    /**
     * Height of a capital letter.
     *
     * @return px
     */
    public double capHeightPx() {
        return capHeightPx;
    }

    /**
     * What it says.
     *
     * @return one line
     */
    public String text() {
        return text;
    }

    /**
     * The box of the line: its width by {@link StrokeFont}, from the tops of capitals to the ends of descenders,
     * whatever letters occur.
     *
     * @return the box
     */
    @Override
    public Box bounds() {
        return new Box(leftPx, baselinePx - StrokeFont.ASCENT * capHeightPx,
                leftPx + StrokeFont.widthInCapHeights(text) * capHeightPx,
                baselinePx + StrokeFont.DESCENT * capHeightPx);
    }

    @Override
    public void draw(Pen pen) {
        StrokeFont.draw(text, leftPx, baselinePx, capHeightPx, pen);
    }
}
