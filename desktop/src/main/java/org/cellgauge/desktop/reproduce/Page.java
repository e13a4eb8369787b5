package org.cellgauge.desktop.reproduce;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** A page of Markdown with its pictures, as it is written. Not safe for several threads. */
final class Page {
    private final StringBuilder text = new StringBuilder();
    private final Map<String, byte[]> pictures = new LinkedHashMap<>();
    private final String pictureFolder;

    /** An empty page whose pictures go to a folder beside it. */
    Page(String pictureFolder) {
        this.pictureFolder = pictureFolder;
    }

    Page heading(int level, String title) {
        text.append(text.length() == 0 ? "" : "\n").append("#".repeat(level)).append(' ').append(title).append("\n\n");
        return this;
    }

    Page paragraph(String words) {
        text.append(words).append("\n\n");
        return this;
    }

    Page list(List<String> points) {
        points.forEach(point -> text.append("- ").append(point).append('\n'));
        text.append('\n');
        return this;
    }

    /** A table; a row may have empty cells. */
    Page table(List<String> head, List<List<String>> rows) {
        row(head);
        row(new ArrayList<>(Collections.nCopies(head.size(), "---")));
        rows.forEach(this::row);
        text.append('\n');
        return this;
    }

    private void row(List<String> cells) {
        text.append("| ").append(String.join(" | ", cells)).append(" |\n");
    }

    Page picture(String file, String what, Svg svg) {
        return picture(file, what, svg.text().getBytes(StandardCharsets.UTF_8));
    }

    Page picture(String file, String what, byte[] bytes) {
        pictures.put(file, bytes);
        return paragraph("![" + what + "](" + pictureFolder + "/" + file + ")");
    }

    /** Markdown, one empty line between its parts and none at its end. */
    String text() {
        return text.toString().replaceAll("\n{3,}", "\n\n").strip() + "\n";
    }

    /** Pictures by file name. */
    Map<String, byte[]> pictures() {
        return pictures;
    }
}
