package org.cellgauge.vision;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * The pixels whose centres lie in a band along a side of a marker, row by row, with their grey values.
 *
 * <p>Not thread-safe; arrays are kept between bands.
 */
final class BandPixels {
    private static final double WHITE = 255;
    /** Pieces of a band's long sides: under a lens that distorts they are bent in the image. */
    private static final int PIECES = 8;
    /** How far from the outline between those points pixels are asked whether they lie in the band, px. */
    private static final double MARGIN_PX = 0.5;

    /** Pixels that room is made for before they are gathered, at most. */
    private static final double MOST_FORESEEN = 1 << 20;

    /** How many there are. */
    int count;
    /** Place along the side from its middle, px, and across it, outwards. */
    double[] along = new double[0];
    double[] across = new double[0];
    /** Grey level, and where its scale ends below and above. */
    double[] grey = new double[0];
    double[] floor = new double[0];
    double[] cap = new double[0];

    // outline of the band in the image, and what it spans of every row of pixels
    private final double[] outline = new double[4 * (PIECES + 1)];
    private int outlineCount;
    private int top;
    private int rows;
    private double[] low = new double[0];
    private double[] high = new double[0];
    private final double[] place = new double[2];

    /**
     * Gathers them.
     *
     * @param image the image
     * @param levels grey values to be taken instead of the image's; null for none
     * @param plane where the side is straight
     * @param side place and direction of the side
     * @param halfLength how far along the side, either way from its middle, px
     * @param inner how far inwards, px
     * @param outer how far outwards, px; negative where the band lies inside
     */
    void gather(GreyImage image, @Nullable Unsharpened levels, StraightPlane plane, SideFit side, double halfLength,
            double inner, double outer) {
        setOutline(plane, side, halfLength, inner, outer);
        setSpans(image);
        count = 0;
        // about as many as square pixels; a lens may make it more
        reserve((int) Math.min(MOST_FORESEEN, 64 + 2.3 * halfLength * Math.max(0, inner + outer)));
        for (int r = 0; r < rows; r++) {
            int y = top + r;
            int first = Math.max(0, (int) Math.floor(low[r]) - 1);
            int last = Math.min(image.widthPx() - 1, (int) Math.ceil(high[r]));
            if (first <= last) {
                reserve(last - first + 1);
            }
            int from = count;
            for (int x = first; x <= last; x++) {
                if (!plane.ofPixel(x, y, place)) {
                    continue;
                }
                double px = place[0] - side.middleX;
                double py = place[1] - side.middleY;
                double t = px * side.tangentX + py * side.tangentY;
                double d = px * side.normalX + py * side.normalY;
                if (d >= -inner && d <= outer && t >= -halfLength && t <= halfLength) {
                    along[count] = t;
                    across[count] = d;
                    if (levels == null) {
                        grey[count++] = image.get(x, y);
                    } else {
                        floor[count] = levels.floor(x, y);
                        cap[count] = levels.cap(x, y);
                        grey[count++] = levels.get(x, y);
                    }
                }
            }
            if (levels == null) {
                Arrays.fill(floor, from, count, 0);
                Arrays.fill(cap, from, count, WHITE);
            }
        }
    }

    private void setOutline(StraightPlane plane, SideFit side, double halfLength, double inner, double outer) {
        int pieces = plane.isDistorted() ? PIECES : 1;
        outlineCount = 2 * (pieces + 1);
        for (int k = 0; k < outlineCount; k++) {
            // out along one long side and back along the other
            boolean back = k > pieces;
            double t = halfLength * (2.0 * (back ? outlineCount - 1 - k : k) / pieces - 1);
            double d = back ? -inner : outer;
            plane.toImage(side.middleX + side.tangentX * t + side.normalX * d,
                    side.middleY + side.tangentY * t + side.normalY * d, outline, 2 * k);
        }
    }

    private void setSpans(GreyImage image) {
        double lowV = Double.POSITIVE_INFINITY;
        double highV = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < outlineCount; k++) {
            lowV = Math.min(lowV, outline[2 * k + 1]);
            highV = Math.max(highV, outline[2 * k + 1]);
        }
        top = Math.max(0, (int) Math.floor(lowV - MARGIN_PX));
        rows = Math.max(0, Math.min(image.heightPx() - 1, (int) Math.floor(highV + MARGIN_PX)) - top + 1);
        if (low.length < rows) {
            low = new double[2 * rows];
            high = new double[2 * rows];
        }
        Arrays.fill(low, 0, rows, Double.POSITIVE_INFINITY);
        Arrays.fill(high, 0, rows, Double.NEGATIVE_INFINITY);
        for (int k = 0; k < outlineCount; k++) {
            int next = k + 1 == outlineCount ? 0 : k + 1;
            span(outline[2 * k], outline[2 * k + 1], outline[2 * next], outline[2 * next + 1]);
        }
    }

    /** Widens the spans of the rows that a piece of the outline passes, each by what it passes of it. */
    private void span(double u0, double v0, double u1, double v1) {
        double from = Math.min(v0, v1);
        double to = Math.max(v0, v1);
        double uByV = v1 == v0 ? 0 : (u1 - u0) / (v1 - v0);
        int first = Math.max(0, (int) Math.floor(from - MARGIN_PX) - top);
        int last = Math.min(rows - 1, (int) Math.floor(to + MARGIN_PX) - top);
        for (int r = first; r <= last; r++) {
            double middle = top + r + 0.5;
            double a = Math.max(from, Math.min(to, middle - MARGIN_PX));
            double b = Math.max(from, Math.min(to, middle + MARGIN_PX));
            double ua = v1 == v0 ? u0 : u0 + (a - v0) * uByV;
            double ub = v1 == v0 ? u1 : u0 + (b - v0) * uByV;
            low[r] = Math.min(low[r], Math.min(ua, ub));
            high[r] = Math.max(high[r], Math.max(ua, ub));
        }
    }

    private void reserve(int more) {
        if (count + more > along.length) {
            int length = count == 0 ? more : 2 * (count + more);
            along = Arrays.copyOf(along, length);
            across = Arrays.copyOf(across, length);
            grey = Arrays.copyOf(grey, length);
            floor = Arrays.copyOf(floor, length);
            cap = Arrays.copyOf(cap, length);
        }
    }
}
