package org.cellgauge.desktop;

import java.util.Map;

/** HTML that grows: tables that become blocks on a narrow screen, and texts escaped. */
final class Html {
    /** The header of what is words and no number. */
    static final String SOURCE = "source";

    private final StringBuilder out = new StringBuilder();
    /** Headers of the table that is being written. */
    private String[] header = {};

    /** Appends HTML as it is. */
    Html append(String html) {
        out.append(html);
        return this;
    }

    /** A table of names and texts; what is null is left out. */
    void pairs(Map<String, String> values) {
        out.append("<table>\n");
        values.forEach((name, value) -> {
            if (value != null) {
                out.append("<tr><td>").append(escape(name)).append("</td><td class=\"text\">").append(escape(value))
                        .append("</td></tr>\n");
            }
        });
        end();
    }

    void header(String... cells) {
        header = cells;
        out.append("<table>\n<tr class=\"head\">");
        for (String cell : cells) {
            out.append(cell.equals(SOURCE) ? "<th class=\"text\">" : "<th>").append(escape(cell)).append("</th>");
        }
        out.append("</tr>\n");
    }

    void row(String... html) {
        out.append("<tr>");
        for (int i = 0; i < html.length; i++) {
            String words = header[i].equals(SOURCE) ? " class=\"text\"" : "";
            out.append(header[i].isEmpty() ? "<td>" : "<td data-of=\"" + escape(header[i]) + "\"" + words + ">")
                    .append(html[i]).append("</td>");
        }
        out.append("</tr>\n");
    }

    void end() {
        out.append("</table>\n");
    }

    @Override
    public String toString() {
        return out.toString();
    }

    /** A verdict in word and shape, coloured by its key. */
    static String verdict(String key, String word) {
        String shape;
        switch (key) {
            case "pass":
                shape = "<circle cx=\"8\" cy=\"8\" r=\"7\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"2\"/>"
                        + "<path d=\"M4.5 8.5l2.5 2.5 4.5-5.5\" fill=\"none\" "
                        + "stroke=\"currentColor\" stroke-width=\"2\"/>";
                break;
            case "not-converged":
            case "ambiguous":
            case "contradicted":
                shape = "<path d=\"M8 1.5l7 13H1z\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"2\"/>"
                        + "<path d=\"M8 6v4M8 11.5v1.5\" stroke=\"currentColor\" stroke-width=\"2\"/>";
                break;
            case "no-target":
                shape = "<path d=\"M2 8h12\" stroke=\"currentColor\" stroke-width=\"3\"/>";
                break;
            default:
                shape = "<path d=\"M5 1h6l4 4v6l-4 4H5l-4-4V5z\" fill=\"currentColor\"/>"
                        + "<path d=\"M5 5l6 6M11 5l-6 6\" stroke-width=\"2\" style=\"stroke:var(--paper)\"/>";
        }
        return "<span class=\"verdict " + key + "\"><svg viewBox=\"0 0 16 16\" aria-hidden=\"true\">" + shape
                + "</svg> " + escape(word) + "</span>";
    }

    static String degrees(double rad) {
        return CheckText.fixed(Math.toDegrees(rad), 4);
    }

    static String escape(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace("\"", "&quot;")
                .replace("'", "&#39;");
    }
}
