package org.cellgauge.desktop.reproduce;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * A diagram as SVG: axes, lines, points, words. Readable on light and dark ground: it brings its own. Coordinates of
 * its methods are those of the data; logarithmic axes take positive values. Not safe for several threads.
 */
final class Svg {
    /** Colours that people who see no red or green can tell apart (Okabe and Ito 2008). */
    static final String BLUE = "#0072b2";
    static final String ORANGE = "#d55e00";
    static final String GREEN = "#009e73";
    static final String PINK = "#cc79a7";
    static final String GREY = "#777777";
    static final String BLACK = "#1a1a1a";

    private static final int LEFT = 66;
    private static final int RIGHT = 16;
    private static final int TOP = 34;
    private static final int BOTTOM = 46;
    private static final int MOST_TICKS = 7;

    private final int width;
    private final int height;
    private final Axis x;
    private final Axis y;
    private final StringBuilder body = new StringBuilder();
    private final List<String> legend = new ArrayList<>();

    /**
     * One of the two axes.
     *
     * @param name what it shows, with its unit; empty for an axis without ticks
     * @param low smallest value
     * @param high largest value
     * @param logarithmic whether decades are equally long
     */
    record Axis(String name, double low, double high, boolean logarithmic) {
        static Axis linear(String name, double low, double high) {
            double room = 0.05 * (high - low);
            return new Axis(name, low - room, high + room, false);
        }

        static Axis logarithmic(String name, double low, double high) {
            return new Axis(name, low / 1.3, high * 1.3, true);
        }

        double share(double value) {
            return logarithmic ? Math.log(Math.max(value, low) / low) / Math.log(high / low)
                    : (value - low) / (high - low);
        }

        List<Double> ticks() {
            List<Double> ticks = new ArrayList<>();
            if (logarithmic) {
                boolean wide = high / low > 300;
                for (int decade = (int) Math.floor(Math.log10(low)); decade <= Math.ceil(Math.log10(high)); decade++) {
                    for (int lead : wide ? new int[] {1} : new int[] {1, 2, 5}) {
                        addWithin(ticks, lead * Math.pow(10, decade));
                    }
                }
                return ticks;
            }
            double step = Math.pow(10, Math.floor(Math.log10((high - low) / MOST_TICKS)));
            for (int lead : new int[] {2, 5, 10}) {
                if ((high - low) / step <= MOST_TICKS) {
                    break;
                }
                step *= lead == 5 ? 2.5 : 2;
            }
            for (double tick = Math.ceil(low / step) * step; tick <= high; tick += step) {
                addWithin(ticks, Math.rint(tick / step) * step);
            }
            return ticks;
        }

        private void addWithin(List<Double> ticks, double tick) {
            if (tick >= low && tick <= high) {
                ticks.add(tick);
            }
        }
    }

    Svg(int width, int height, String title, Axis x, Axis y) {
        this.width = width;
        this.height = height;
        this.x = x;
        this.y = y;
        word(LEFT, 18, "start", BLACK, 14, title);
        for (double tick : x.name().isEmpty() ? List.<Double>of() : x.ticks()) {
            segment(x(tick), TOP, x(tick), height - BOTTOM, "#e4e4e4", 1);
            word(x(tick), height - BOTTOM + 16, "middle", BLACK, 11, tickText(tick));
        }
        for (double tick : y.ticks()) {
            segment(LEFT, y(tick), width - RIGHT, y(tick), "#e4e4e4", 1);
            word(LEFT - 6, y(tick) + 4, "end", BLACK, 11, tickText(tick));
        }
        word((LEFT + width - RIGHT) / 2.0, height - 8, "middle", BLACK, 12, x.name());
        body.append(String.format(Locale.ROOT,
                "<text transform=\"translate(14,%d) rotate(-90)\" text-anchor=\"middle\" font-size=\"12\" fill=\"%s\">"
                        + "%s</text>%n", (TOP + height - BOTTOM) / 2, BLACK, escaped(y.name())));
    }

    private static String tickText(double tick) {
        return tick == Math.rint(tick) ? Long.toString(Math.round(tick))
                : String.format(Locale.ROOT, "%.3f", tick).replaceAll("0+$", "");
    }

    private double x(double value) {
        return LEFT + x.share(value) * (width - LEFT - RIGHT);
    }

    private double y(double value) {
        return height - BOTTOM - y.share(value) * (height - TOP - BOTTOM);
    }

    Svg line(double[] xs, double[] ys, String colour, double thickness) {
        StringBuilder points = new StringBuilder();
        for (int i = 0; i < xs.length; i++) {
            if (Double.isFinite(ys[i])) {
                points.append(String.format(Locale.ROOT, "%.1f,%.1f ", x(xs[i]), y(ys[i])));
            }
        }
        body.append(String.format(Locale.ROOT,
                "<polyline points=\"%s\" fill=\"none\" stroke=\"%s\" stroke-width=\"%.1f\"/>%n",
                points.toString().strip(), colour, thickness));
        return this;
    }

    /** A point: filled, or a ring. */
    Svg point(double px, double py, String colour, double radius, boolean filled) {
        if (Double.isFinite(py)) {
            body.append(String.format(Locale.ROOT,
                    "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"%s\" stroke=\"%s\" stroke-width=\"1.5\"/>%n",
                    x(px), y(py), radius, filled ? colour : "none", colour));
        }
        return this;
    }

    /** A bar from one value to another, at a place along x. */
    Svg bar(double px, double from, double to, String colour, double thickness) {
        segment(x(px), y(from), x(px), y(to), colour, thickness);
        return this;
    }

    /** A line all across, at a value. */
    Svg level(double value, String colour) {
        segment(LEFT, y(value), width - RIGHT, y(value), colour, 1);
        return this;
    }

    /** A word under the axis, at a place along x. */
    Svg under(double px, String what) {
        word(x(px), height - BOTTOM + 16, "middle", BLACK, 10, what);
        return this;
    }

    /** A name in the legend, which stands along the top. */
    Svg legend(String what, String colour) {
        legend.add(what + "\t" + colour);
        return this;
    }

    private void segment(double x1, double y1, double x2, double y2, String colour, double thickness) {
        body.append(String.format(Locale.ROOT,
                "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\" "
                        + "stroke-width=\"%.1f\"/>%n", x1, y1, x2,
                y2, colour, thickness));
    }

    private void word(double atX, double atY, String anchor, String colour, int size, String what) {
        body.append(String.format(Locale.ROOT,
                "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" font-size=\"%d\" fill=\"%s\">%s</text>%n", atX, atY,
                anchor, size, colour, escaped(what)));
    }

    private static String escaped(String what) {
        return what.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
    }

    /** The whole file. */
    String text() {
        StringBuilder all = new StringBuilder(String.format(Locale.ROOT,
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\" "
                        + "font-family=\"sans-serif\">%n<rect width=\"%d\" height=\"%d\" fill=\"#ffffff\"/>%n", width,
                height, width, height, width, height)).append(body);
        double at = LEFT;
        for (String entry : legend) {
            String[] parts = entry.split("\t");
            all.append(String.format(Locale.ROOT,
                    "<rect x=\"%.1f\" y=\"23\" width=\"10\" height=\"8\" fill=\"%s\"/>"
                            + "<text x=\"%.1f\" y=\"31\" font-size=\"11\" fill=\"%s\">%s</text>%n", at, parts[1],
                    at + 14, BLACK, escaped(parts[0])));
            at += 30 + 6.2 * parts[0].length();
        }
        return all.append("</svg>\n").toString().replace("\r\n", "\n");
    }
}
