package org.cellgauge.cell;

import org.cellgauge.internal.cell.CellPhrase;

/**
 * The texts of camera files as trees of values. YAML is read as it is; what other programs write that YAML is not quite
 * is made YAML first, line for line, so that places in messages are those of the file: OpenCV's first line and its
 * tags, JSON with tabs, mrcal's form, which is Python's, and OpenCV's XML.
 */
final class CameraText {
    /** Largest text of which a tree is made, characters: what is left once {@link #flow} has taken pictures out. */
    private static final int MAX_CHARS = 1 << 20;
    /** Nothing that is asked of a camera file is longer; pictures and solutions of optimisations are. */
    private static final int LONGEST_STRING = 2000;
    /** PhotonVision's key of the corners and pictures of all its photos. */
    private static final String OBSERVATIONS = "observations";
    private static final String[] TAGS = {"!!opencv-matrix", "!!opencv-nd-matrix"};

    private CameraText() {
    }

    /**
     * The value at the top of a camera file.
     *
     * @param text YAML, JSON, OpenCV's XML or mrcal's form
     * @param file its name for messages
     * @return a value, mostly a mapping
     * @throws InputRefusedException if it is none of them, or too long
     */
    static YamlValue parse(String text, String file) {
        char first = firstSign(text);
        if (first == '<') {
            return OpenCvXml.parse(text, file, MAX_CHARS);
        }
        String yaml = first == '{' ? flow(text) : text;
        if (yaml.startsWith("%YAML")) {
            // OpenCV's "%YAML:1.0" is no directive of YAML
            yaml = "#" + yaml.substring(1);
        }
        for (String tag : TAGS) {
            yaml = yaml.replace(tag, " ".repeat(tag.length()));
        }
        return YamlValue.parse(yaml, file, CellPhrase.CAMERA_FILE, MAX_CHARS);
    }

    /** The first sign that is neither white nor of a comment; a space where there is none. */
    private static char firstSign(String text) {
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            if (c == '#') {
                i = lineEnd(text, i) - 1;
            } else if (!Character.isWhitespace(c)) {
                return c;
            }
        }
        return ' ';
    }

    private static int lineEnd(String text, int from) {
        int end = text.indexOf('\n', from);
        return end < 0 ? text.length() : end;
    }

    /** JSON and Python's form without tabs, without Python's bytes and without what no camera needs. */
    private static String flow(String text) {
        StringBuilder out = new StringBuilder(Math.min(text.length(), MAX_CHARS));
        int depth = 0;
        boolean hidden = false;
        boolean hides = false;
        int i = 0;
        while (i < text.length()) {
            char c = text.charAt(i);
            int end = i + 1;
            if (c == '#') {
                end = lineEnd(text, i);
            } else if (c == '"' || c == '\'') {
                end = stringEnd(text, i);
                hides = depth == 1 && end - i == OBSERVATIONS.length() + 2 && text.startsWith(OBSERVATIONS, i + 1);
            } else if (c == '[' || c == '{') {
                depth++;
                if (hides && depth == 2) {
                    out.append(c);
                    hidden = true;
                }
                hides = false;
            } else if (c == ']' || c == '}') {
                depth--;
                hidden &= depth > 1;
            } else if (c == ',') {
                hides = false;
            }
            boolean opaque = end - i > LONGEST_STRING || c == '\'' && i > 0 && text.charAt(i - 1) == 'b';
            for (int k = i; k < end; k++) {
                char sign = text.charAt(k);
                if (sign == '\n') {
                    out.append(sign);
                } else if (!hidden && !(opaque && k > i && k < end - 1)) {
                    out.append(sign == '\t' ? ' ' : sign);
                }
            }
            i = end;
        }
        return out.toString();
    }

    /** Behind the quote that ends a string, or the end of the text. */
    private static int stringEnd(String text, int start) {
        char quote = text.charAt(start);
        for (int i = start + 1; i < text.length(); i++) {
            char c = text.charAt(i);
            if (c == '\\') {
                i++;
            } else if (c == quote) {
                return i + 1;
            }
        }
        return text.length();
    }
}
