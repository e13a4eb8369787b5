package org.cellgauge.internal.overlay;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Letters as lines: text that every painter can draw, that measures the same everywhere and needs no installed font (a
 * Java runtime without a window system often has none).
 *
 * <p>Drawn for this program. A glyph is a path on a grid where a capital is 14 high, a small letter 10, the baseline 0
 * and y points up: {@code M x y} begins a line, {@code L x y} draws to a point, {@code A x y rx ry from to} an arc of
 * the ellipse around (x, y) by angles in degrees, counter-clockwise where {@code to} is larger, joined to the line
 * before it, {@code E x y rx ry} a whole ellipse on its own.
 */
public final class StrokeFont {
    /** How far the tallest letters reach above the baseline, in cap heights. */
    public static final double ASCENT = 1.08;
    /** How far letters reach below the baseline, in cap heights. */
    public static final double DESCENT = 0.32;
    /** Distance between baselines of successive lines, in cap heights. */
    public static final double LINE_SPACING = 1.75;

    private static final double CAP = 14;
    private static final double GAP = 3.7;
    private static final double DEGREES_PER_PIECE = 15;
    private static final Map<Character, Glyph> GLYPHS = table();
    /** What stands for a character the font does not have: an empty box. */
    private static final Glyph UNKNOWN = new Glyph(8, "M 0 0 L 8 0 L 8 14 L 0 14 L 0 0");

    private StrokeFont() {
    }

    /**
     * Whether the font has a character.
     *
     * @param c the character
     * @return false if an empty box is drawn in its place
     */
    public static boolean has(char c) {
        return isSpace(c) || GLYPHS.containsKey(c);
    }

    /**
     * Width of a line of text.
     *
     * @param text one line
     * @return cap heights, 0 for an empty text
     */
    public static double widthInCapHeights(String text) {
        double width = 0;
        for (int i = 0; i < text.length(); i++) {
            width += advance(text.charAt(i));
        }
        return text.isEmpty() ? 0 : (width - GAP) / CAP;
    }

    /**
     * Draws a line of text.
     *
     * @param text one line
     * @param leftPx u of its left end
     * @param baselinePx v of the baseline
     * @param capHeightPx height of a capital
     * @param pen gets the lines, v down
     */
    public static void draw(String text, double leftPx, double baselinePx, double capHeightPx, Pen pen) {
        double scale = capHeightPx / CAP;
        double x = 0;
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            if (!isSpace(c)) {
                for (double[] line : glyph(c).lines) {
                    pen.moveTo(leftPx + scale * (x + line[0]), baselinePx - scale * line[1]);
                    for (int k = 2; k < line.length; k += 2) {
                        pen.lineTo(leftPx + scale * (x + line[k]), baselinePx - scale * line[k + 1]);
                    }
                }
            }
            x += advance(c);
        }
    }

    /**
     * Breaks a text into lines at its spaces, but not at those that bind. A word that is wider than a line is broken
     * within.
     *
     * @param text the text
     * @param widthInCapHeights width of a line, positive
     * @return at least one line
     */
    public static List<String> wrap(String text, double widthInCapHeights) {
        List<String> lines = new ArrayList<>();
        StringBuilder line = new StringBuilder();
        for (String word : text.trim().split("[ \\t\\n\\r]+")) {
            String rest = word;
            String joined = line.length() == 0 ? rest : line + " " + rest;
            if (widthInCapHeights(joined) <= widthInCapHeights) {
                line.setLength(0);
                line.append(joined);
                continue;
            }
            if (line.length() > 0) {
                lines.add(line.toString());
                line.setLength(0);
            }
            while (rest.length() > 1 && widthInCapHeights(rest) > widthInCapHeights) {
                int fits = 1;
                while (fits < rest.length() && widthInCapHeights(rest.substring(0, fits + 1)) <= widthInCapHeights) {
                    fits++;
                }
                lines.add(rest.substring(0, fits));
                rest = rest.substring(fits);
            }
            line.append(rest);
        }
        if (line.length() > 0 || lines.isEmpty()) {
            lines.add(line.toString());
        }
        return lines;
    }

    private static double advance(char c) {
        return isSpace(c) ? 6.5 : glyph(c).width + GAP;
    }

    /** A space, also one where no line may break. */
    private static boolean isSpace(char c) {
        return c == ' ' || c == '\u00a0' || c == '\u202f';
    }

    private static Glyph glyph(char c) {
        return GLYPHS.getOrDefault(c, UNKNOWN);
    }

    /** One letter: its width and its lines on the grid. */
    private static final class Glyph {
        private final double width;
        private final List<double[]> lines;

        Glyph(double width, String path) {
            this.width = width;
            this.lines = parse(path);
        }
    }

    private static List<double[]> parse(String path) {
        List<double[]> lines = new ArrayList<>();
        List<Double> points = new ArrayList<>();
        String[] tokens = path.trim().split("\\s+");
        int i = 0;
        while (i < tokens.length) {
            String command = tokens[i++];
            int count = "A".equals(command) ? 6 : "E".equals(command) ? 4 : 2;
            double[] v = new double[count];
            for (int k = 0; k < count; k++) {
                v[k] = Double.parseDouble(tokens[i++]);
            }
            switch (command) {
                case "M":
                    finish(points, lines);
                    add(points, v[0], v[1]);
                    break;
                case "L":
                    add(points, v[0], v[1]);
                    break;
                case "A":
                    arc(points, v, v[4], v[5]);
                    break;
                case "E":
                    finish(points, lines);
                    arc(points, v, 0, 360);
                    finish(points, lines);
                    break;
                default:
                    throw new IllegalArgumentException(String.format(Locale.ROOT, "no such path command: %s", command));
            }
        }
        finish(points, lines);
        return Collections.unmodifiableList(lines);
    }

    private static void arc(List<Double> points, double[] v, double fromDeg, double toDeg) {
        int pieces = (int) Math.ceil(Math.abs(toDeg - fromDeg) / DEGREES_PER_PIECE);
        for (int k = 0; k <= pieces; k++) {
            double a = Math.toRadians(fromDeg + (toDeg - fromDeg) * k / pieces);
            add(points, v[0] + v[2] * Math.cos(a), v[1] + v[3] * Math.sin(a));
        }
    }

    private static void add(List<Double> points, double x, double y) {
        points.add(x);
        points.add(y);
    }

    private static void finish(List<Double> points, List<double[]> lines) {
        if (points.size() >= 4) {
            lines.add(points.stream().mapToDouble(Double::doubleValue).toArray());
        }
        points.clear();
    }

    private static Map<Character, Glyph> table() {
        Map<Character, Glyph> t = new HashMap<>();
        digitsAndCapitals(t);
        smallLetters(t);
        germanLetters(t);
        signs(t);
        return Collections.unmodifiableMap(t);
    }

    private static void digitsAndCapitals(Map<Character, Glyph> t) {
        // digits share one width, so that figures below each other line up
        t.put('0', new Glyph(9, "E 4.5 7 4.5 7"));
        t.put('1', new Glyph(9, "M 1.6 11.2 L 5 14 L 5 0 M 1.8 0 L 8.2 0"));
        t.put('2', new Glyph(9, "A 4.5 9.7 4.2 4.3 165 -35 L 0.3 0 L 8.9 0"));
        t.put('3', new Glyph(9, "A 4.4 10.6 3.7 3.4 155 -90 A 4.4 3.6 4.5 3.6 90 -155"));
        t.put('4', new Glyph(9, "M 6.8 0 L 6.8 14 L 0 4.2 L 9 4.2"));
        t.put('5', new Glyph(9, "M 8.1 14 L 1.5 14 L 0.9 7.6 A 4.3 4.6 4.6 4.6 128 -152"));
        t.put('6', new Glyph(9, "A 8.5 4.6 8.4 9.4 95 180 A 4.5 4.6 4.4 4.6 180 540"));
        t.put('7', new Glyph(9, "M 0.3 14 L 8.8 14 L 3.2 0"));
        t.put('8', new Glyph(9, "E 4.5 10.6 3.7 3.4 E 4.5 3.6 4.5 3.6"));
        t.put('9', new Glyph(9, "A 0.5 9.4 8.4 9.4 -85 0 A 4.5 9.4 4.4 4.6 0 360"));
        t.put('A', new Glyph(10, "M 0 0 L 5 14 L 10 0 M 1.7 4.8 L 8.3 4.8"));
        t.put('B', new Glyph(8.7, "M 0 7.4 L 4.4 7.4 A 4.4 10.7 3.6 3.3 -90 90 L 0 14 L 0 0 L 4.7 0 "
                + "A 4.7 3.7 4 3.7 -90 90"));
        t.put('C', new Glyph(9.2, "A 5.4 7 5.4 7 48 312"));
        t.put('D', new Glyph(9.4, "M 0 0 L 0 14 L 3.4 14 A 3.4 7 6 7 90 -90 L 0 0"));
        t.put('E', new Glyph(7.4, "M 7.4 14 L 0 14 L 0 0 L 7.4 0 M 0 7.2 L 6.2 7.2"));
        t.put('F', new Glyph(7.2, "M 7.2 14 L 0 14 L 0 0 M 0 7 L 6.2 7"));
        t.put('G', new Glyph(10.3, "A 5.4 7 5.4 7 48 350 L 10.4 6.6 L 6 6.6"));
        t.put('H', new Glyph(9, "M 0 0 L 0 14 M 9 0 L 9 14 M 0 7.2 L 9 7.2"));
        t.put('I', new Glyph(1, "M 0.5 0 L 0.5 14"));
        t.put('J', new Glyph(6.8, "M 6.8 14 L 6.8 4.2 A 3.4 4.2 3.4 4.2 0 -170"));
        t.put('K', new Glyph(8.7, "M 0 0 L 0 14 M 8.2 14 L 0 5.2 M 3.1 8.5 L 8.7 0"));
        t.put('L', new Glyph(7, "M 0 14 L 0 0 L 7 0"));
        t.put('M', new Glyph(11, "M 0 0 L 0 14 L 5.5 3.5 L 11 14 L 11 0"));
        t.put('N', new Glyph(9, "M 0 0 L 0 14 L 9 0 L 9 14"));
        t.put('O', new Glyph(11, "E 5.5 7 5.5 7"));
        t.put('P', new Glyph(8.5, "M 0 0 L 0 14 L 4.6 14 A 4.6 10.2 3.9 3.8 90 -90 L 0 6.4"));
        t.put('Q', new Glyph(11, "E 5.5 7 5.5 7 M 6.8 3.4 L 10.8 -1.2"));
        t.put('R', new Glyph(8.9, "M 0 0 L 0 14 L 4.6 14 A 4.6 10.2 3.9 3.8 90 -90 L 0 6.4 M 4.6 6.4 L 8.9 0"));
        t.put('S', new Glyph(8.8, "A 4.4 10.5 3.9 3.5 35 270 A 4.4 3.5 4.4 3.5 90 -150"));
        t.put('T', new Glyph(9, "M 0 14 L 9 14 M 4.5 14 L 4.5 0"));
        t.put('U', new Glyph(9, "M 0 14 L 0 4.5 A 4.5 4.5 4.5 4.5 180 360 L 9 14"));
        t.put('V', new Glyph(10, "M 0 14 L 5 0 L 10 14"));
        t.put('W', new Glyph(14, "M 0 14 L 3.5 0 L 7 12.4 L 10.5 0 L 14 14"));
        t.put('X', new Glyph(9, "M 0 0 L 9 14 M 0 14 L 9 0"));
        t.put('Y', new Glyph(9.4, "M 0 14 L 4.7 6.6 L 9.4 14 M 4.7 6.6 L 4.7 0"));
        t.put('Z', new Glyph(9, "M 0 14 L 9 14 L 0 0 L 9 0"));
    }

    private static void smallLetters(Map<Character, Glyph> t) {
        t.put('a', new Glyph(7.8, "E 3.9 5 3.9 5 M 7.8 10 L 7.8 0"));
        t.put('b', new Glyph(7.8, "M 0 14.5 L 0 0 E 3.9 5 3.9 5"));
        t.put('c', new Glyph(6.8, "A 4 5 4 5 50 310"));
        t.put('d', new Glyph(7.8, "E 3.9 5 3.9 5 M 7.8 14.5 L 7.8 0"));
        t.put('e', new Glyph(8, "M 0.1 5.3 L 8 5.3 A 4 5 4 5 4 315"));
        t.put('f', new Glyph(4.8, "A 5 11.3 3 3.2 80 180 L 2 0 M 0 10 L 4.8 10"));
        t.put('g', new Glyph(7.8, "E 3.9 5 3.9 5 M 7.8 10 L 7.8 -0.6 A 4 -0.6 3.8 3.6 0 -150"));
        t.put('h', new Glyph(7.2, "M 0 14.5 L 0 0 M 0 6 A 3.6 6.2 3.6 3.8 180 0 L 7.2 0"));
        t.put('i', new Glyph(1, "M 0.5 10 L 0.5 0 M 0.5 13.4 L 0.5 14.2"));
        t.put('j', new Glyph(2.4, "M 1.9 10 L 1.9 -2 A -0.4 -2 2.3 2.2 0 -80 M 1.9 13.4 L 1.9 14.2"));
        t.put('k', new Glyph(7, "M 0 14.5 L 0 0 M 6.6 10 L 0 3.8 M 2.5 6.1 L 7 0"));
        t.put('l', new Glyph(2.4, "M 0.5 14.5 L 0.5 2 A 2.5 2 2 2 180 270"));
        t.put('m', new Glyph(12, "M 0 10 L 0 0 M 0 6.4 A 3 6.7 3 3.3 180 0 L 6 0 M 6 6.4 A 9 6.7 3 3.3 180 0 L 12 0"));
        t.put('n', new Glyph(7.2, "M 0 10 L 0 0 M 0 6 A 3.6 6.2 3.6 3.8 180 0 L 7.2 0"));
        t.put('o', new Glyph(8, "E 4 5 4 5"));
        t.put('p', new Glyph(7.8, "M 0 10 L 0 -4 E 3.9 5 3.9 5"));
        t.put('q', new Glyph(7.8, "E 3.9 5 3.9 5 M 7.8 10 L 7.8 -4"));
        t.put('r', new Glyph(4.6, "M 0 10 L 0 0 M 0 5.8 A 3.8 6 3.8 4 180 75"));
        t.put('s', new Glyph(6.6, "A 3.3 7.5 2.9 2.5 35 270 A 3.3 2.5 3.3 2.5 90 -150"));
        t.put('t', new Glyph(5, "M 2 13.6 L 2 2.6 A 4.4 2.6 2.4 2.6 180 285 M 0 10 L 4.8 10"));
        t.put('u', new Glyph(7.2, "M 0 10 L 0 3.8 A 3.6 3.8 3.6 3.8 180 360 M 7.2 10 L 7.2 0"));
        t.put('v', new Glyph(7.6, "M 0 10 L 3.8 0 L 7.6 10"));
        t.put('w', new Glyph(11, "M 0 10 L 2.8 0 L 5.5 8.8 L 8.2 0 L 11 10"));
        t.put('x', new Glyph(7.2, "M 0 10 L 7.2 0 M 7.2 10 L 0 0"));
        t.put('y', new Glyph(7.6, "M 0 10 L 3.8 0 M 7.6 10 L 2.5 -4 L 0.6 -4"));
        t.put('z', new Glyph(7, "M 0 10 L 7 10 L 0 0 L 7 0"));
    }

    /** Capitals with dots are lower by what the dots take, so that a line is no higher for them. */
    private static void germanLetters(Map<Character, Glyph> t) {
        t.put('\u00c4', new Glyph(10, "M 0 0 L 5 12 L 10 0 M 1.9 4.6 L 8.1 4.6 M 2 14 L 2 14.8 M 8 14 L 8 14.8"));
        t.put('\u00d6', new Glyph(11, "E 5.5 5.9 5.5 5.9 M 3.3 14 L 3.3 14.8 M 7.7 14 L 7.7 14.8"));
        t.put('\u00dc', new Glyph(9, "M 0 11.8 L 0 4.5 A 4.5 4.5 4.5 4.5 180 360 L 9 11.8 M 2.3 14 L 2.3 14.8 "
                + "M 6.7 14 L 6.7 14.8"));
        t.put('\u00e4', new Glyph(7.8, "E 3.9 5 3.9 5 M 7.8 10 L 7.8 0 M 1.9 13.4 L 1.9 14.2 M 5.9 13.4 L 5.9 14.2"));
        t.put('\u00f6', new Glyph(8, "E 4 5 4 5 M 2 13.4 L 2 14.2 M 6 13.4 L 6 14.2"));
        t.put('\u00fc', new Glyph(7.2, "M 0 10 L 0 3.8 A 3.6 3.8 3.6 3.8 180 360 M 7.2 10 L 7.2 0 "
                + "M 1.6 13.4 L 1.6 14.2 M 5.6 13.4 L 5.6 14.2"));
        t.put('\u00df', new Glyph(7.6, "M 0 0 L 0 11.2 A 3.3 11.2 3.3 3.3 180 -60 L 3.5 7.9 "
                + "A 3.5 3.95 4.1 3.95 90 -125"));
    }

    private static void signs(Map<Character, Glyph> t) {
        t.put('.', new Glyph(1, "M 0.5 0 L 0.5 1"));
        t.put(',', new Glyph(1.2, "M 0.9 0.4 L 0.1 -2.6"));
        t.put(':', new Glyph(1, "M 0.5 0 L 0.5 1 M 0.5 8.2 L 0.5 9.2"));
        t.put(';', new Glyph(1.2, "M 0.9 0.4 L 0.1 -2.6 M 0.8 8.2 L 0.8 9.2"));
        t.put('!', new Glyph(1, "M 0.5 14 L 0.5 4.4 M 0.5 0 L 0.5 1"));
        t.put('?', new Glyph(7, "A 3.5 10.6 3.4 3.4 165 -60 L 3.6 5.8 L 3.6 4.3 M 3.6 0 L 3.6 1"));
        t.put('\'', new Glyph(1, "M 0.5 14 L 0.5 10.6"));
        t.put('\u2019', new Glyph(1.2, "M 0.9 14 L 0.3 10.6"));
        t.put('"', new Glyph(4, "M 0.5 14 L 0.5 10.6 M 3.5 14 L 3.5 10.6"));
        t.put('(', new Glyph(3.4, "A 7 5 7 10.5 118 242"));
        t.put(')', new Glyph(3.4, "A -3.6 5 7 10.5 62 -62"));
        t.put('[', new Glyph(3, "M 3 15 L 0 15 L 0 -3.5 L 3 -3.5"));
        t.put(']', new Glyph(3, "M 0 15 L 3 15 L 3 -3.5 L 0 -3.5"));
        t.put('{', new Glyph(4, "M 4 15 L 2.6 14.4 L 2 13 L 2 8 L 0.4 6 L 2 4 L 2 -1 L 2.6 -2.9 L 4 -3.5"));
        t.put('}', new Glyph(4, "M 0 15 L 1.4 14.4 L 2 13 L 2 8 L 3.6 6 L 2 4 L 2 -1 L 1.4 -2.9 L 0 -3.5"));
        t.put('<', new Glyph(8, "M 8 11 L 0 6 L 8 1"));
        t.put('>', new Glyph(8, "M 0 11 L 8 6 L 0 1"));
        t.put('\u2264', new Glyph(8, "M 8 12 L 0 7.8 L 8 3.6 M 0 0.6 L 8 0.6"));
        t.put('\u2265', new Glyph(8, "M 0 12 L 8 7.8 L 0 3.6 M 0 0.6 L 8 0.6"));
        t.put('=', new Glyph(8, "M 0 8 L 8 8 M 0 4 L 8 4"));
        t.put('\u2248', new Glyph(8, "M 0 7.4 A 2 7.8 2 1.5 180 0 A 6 7.8 2 1.5 180 360 "
                + "M 0 3.4 A 2 3.8 2 1.5 180 0 A 6 3.8 2 1.5 180 360"));
        t.put('~', new Glyph(8, "M 0 5.6 A 2 6 2 1.6 180 0 A 6 6 2 1.6 180 360"));
        t.put('+', new Glyph(8, "M 0 6 L 8 6 M 4 10 L 4 2"));
        t.put('\u00b1', new Glyph(8, "M 0 8 L 8 8 M 4 12 L 4 4 M 0 1 L 8 1"));
        t.put('-', new Glyph(5, "M 0.4 6 L 4.6 6"));
        t.put('\u2212', new Glyph(8, "M 0 6 L 8 6"));
        t.put('\u2013', new Glyph(8, "M 0 6 L 8 6"));
        t.put('\u2014', new Glyph(14, "M 0 6 L 14 6"));
        t.put('_', new Glyph(8, "M 0 -2.5 L 8 -2.5"));
        t.put('/', new Glyph(6, "M 0 -2 L 6 15"));
        t.put('\\', new Glyph(6, "M 0 15 L 6 -2"));
        t.put('|', new Glyph(1, "M 0.5 15 L 0.5 -3.5"));
        t.put('*', new Glyph(6, "M 3 13.5 L 3 6.5 M 0 11.8 L 6 8.2 M 0 8.2 L 6 11.8"));
        t.put('#', new Glyph(9.6, "M 3.2 14 L 1.6 0 M 8 14 L 6.4 0 M 0.4 9.6 L 9.6 9.6 M 0 4.4 L 9.2 4.4"));
        t.put('$', new Glyph(8.8, "A 4.4 10 3.9 3 35 270 A 4.4 3.8 4.4 3.2 90 -150 M 4.4 15 L 4.4 -1.5"));
        t.put('%', new Glyph(12.4, "M 10.2 14 L 2.2 0 E 2.7 10.8 2.7 3.2 E 9.7 3.2 2.7 3.2"));
        t.put('&', new Glyph(10, "M 10 0 L 2.6 9.6 A 4.8 11.5 2.6 2.5 215 -40 "
                + "L 2.3 6.8 A 4 3.6 4 3.6 125 320 L 9.6 6.4"));
        t.put('@', new Glyph(13, "E 6.3 5.6 2.7 3.2 M 9 8.8 L 9 4.2 A 10.9 4.2 1.9 1.8 180 360 A 6.4 6 6.4 7.5 0 300"));
        t.put('^', new Glyph(7, "M 0 10 L 3.5 14 L 7 10"));
        t.put('`', new Glyph(2.5, "M 0 14 L 2.5 11.4"));
        t.put('\u03c3', new Glyph(9.2, "E 4.1 4.7 4.1 4.7 M 4.1 9.4 L 9.4 9.4"));
        t.put('\u00d7', new Glyph(7, "M 0.3 2.6 L 6.7 9 M 0.3 9 L 6.7 2.6"));
        t.put('\u00b0', new Glyph(4.4, "E 2.2 12 2.2 2.2"));
        t.put('\u00b2', new Glyph(5, "A 2.5 12.6 2.2 2.2 165 -35 L 0.2 7.4 L 5 7.4"));
        t.put('\u00b7', new Glyph(1, "M 0.5 5.9 L 0.5 6.2"));
        t.put('\u2026', new Glyph(9, "M 0.5 0 L 0.5 1 M 4.5 0 L 4.5 1 M 8.5 0 L 8.5 1"));
        t.put('\u00b5', new Glyph(7.2, "M 0 10 L 0 -4 M 0 3.8 A 3.6 3.8 3.6 3.8 180 360 M 7.2 10 L 7.2 0"));
    }
}
