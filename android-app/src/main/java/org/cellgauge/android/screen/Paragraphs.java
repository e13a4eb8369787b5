package org.cellgauge.android.screen;

import java.util.regex.Pattern;

/** Text that was broken into lines for a page, for a screen of any width. */
final class Paragraphs {
    /** Shorter lines end where they were meant to: titles, names, the last line of a paragraph. */
    private static final int SHORTEST_BROKEN = 45;
    private static final Pattern ITEM = Pattern.compile("(?:[-*]|\\(?\\w{1,3}[.)])\\s.*");
    private static final Pattern RULE = Pattern.compile("[-=]{10,}");
    private static final String SHORT_RULE = "———";

    private Paragraphs() {
    }

    /**
     * Joins lines that belong together. Words and their order stay; indents go, and rules become short.
     *
     * @param page lines separated by a line feed
     * @return one line per paragraph or item of a list, at most one empty line in between
     */
    static String of(String page) {
        StringBuilder text = new StringBuilder();
        String before = "";
        for (String whole : page.split("\n")) {
            String line = whole.trim();
            if (RULE.matcher(line).matches()) {
                line = SHORT_RULE;
            }
            if (line.isEmpty() && before.isEmpty()) {
                continue;
            }
            boolean goesOn = before.length() >= SHORTEST_BROKEN && !line.isEmpty() && !SHORT_RULE.equals(line)
                    && !ITEM.matcher(line).matches();
            text.append(text.length() == 0 ? "" : goesOn ? " " : "\n").append(line);
            before = line;
        }
        return text.toString();
    }
}
