package org.cellgauge.cell;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.cellgauge.internal.cell.CellPhrase;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;
import org.yaml.snakeyaml.DumperOptions;
import org.yaml.snakeyaml.error.Mark;
import org.yaml.snakeyaml.nodes.MappingNode;
import org.yaml.snakeyaml.nodes.Node;
import org.yaml.snakeyaml.nodes.NodeTuple;
import org.yaml.snakeyaml.nodes.ScalarNode;
import org.yaml.snakeyaml.nodes.SequenceNode;
import org.yaml.snakeyaml.nodes.Tag;

/**
 * The XML that OpenCV's FileStorage writes, as the same tree of values that its YAML is: elements of elements are
 * mappings, or lists where all are named {@code _}; several words are a list. It knows neither document types nor
 * entities of their own, so that nothing outside of the file is ever read.
 */
final class OpenCvXml {
    private static final String ROOT = "opencv_storage";
    private static final int MAX_DEPTH = 20;
    private static final String[][] ENTITIES = {{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&apos;", "'"},
        {"&amp;", "&"}};

    private final String text;
    private final String file;
    private int at;
    private int counted;
    private int line = 1;

    private OpenCvXml(String text, String file) {
        this.text = text;
        this.file = file;
    }

    static YamlValue parse(String text, String file, int maxChars) {
        if (text.length() > maxChars) {
            throw new InputRefusedException(file, CellRefusal.TOO_LARGE, maxChars / 1024, CellPhrase.CAMERA_FILE);
        }
        OpenCvXml xml = new OpenCvXml(text, file);
        xml.skipMisc();
        int first = xml.line();
        if (!xml.text.startsWith("<" + ROOT, xml.at)) {
            throw xml.refused();
        }
        Element root = xml.element(1);
        xml.skipMisc();
        if (xml.at < text.length() || !root.name.equals(ROOT)) {
            throw xml.refused();
        }
        return new YamlValue(file, "", first, root.node);
    }

    /** An element: its name, where it stands, and what is in it. */
    private record Element(String name, Mark mark, Node node) { }

    private InputRefusedException refused() {
        return new InputRefusedException(Refusal.at(Place.of(file, line(), 0, ""), CellRefusal.NO_OPENCV_XML));
    }

    /** The line of the place that is read next. */
    private int line() {
        for (; counted < Math.min(at, text.length()); counted++) {
            if (text.charAt(counted) == '\n') {
                line++;
            }
        }
        return line;
    }

    private Mark mark() {
        return new Mark(file, 0, line() - 1, 0, new int[0], 0);
    }

    /** White, comments and processing instructions. */
    private void skipMisc() {
        while (at < text.length()) {
            if (Character.isWhitespace(text.charAt(at))) {
                at++;
            } else if (text.startsWith("<!--", at)) {
                skipTo("-->");
            } else if (text.startsWith("<?", at)) {
                skipTo("?>");
            } else {
                return;
            }
        }
    }

    private void skipTo(String end) {
        int found = text.indexOf(end, at);
        if (found < 0) {
            throw refused();
        }
        at = found + end.length();
    }

    private Element element(int depth) {
        if (depth > MAX_DEPTH) {
            throw refused();
        }
        Mark mark = mark();
        at++;
        int nameEnd = at;
        while (nameEnd < text.length() && (Character.isLetterOrDigit(text.charAt(nameEnd))
                || "_-.:".indexOf(text.charAt(nameEnd)) >= 0)) {
            nameEnd++;
        }
        String name = text.substring(at, nameEnd);
        int close = text.indexOf('>', nameEnd);
        if (name.isEmpty() || close < 0 || text.substring(nameEnd, close).indexOf('<') >= 0) {
            throw refused();
        }
        at = close + 1;
        if (text.charAt(close - 1) == '/') {
            return new Element(name, mark, scalar("", mark));
        }
        StringBuilder words = new StringBuilder();
        List<Element> parts = new ArrayList<>();
        while (!text.startsWith("</", at)) {
            if (at >= text.length()) {
                throw refused();
            }
            if (text.startsWith("<!--", at)) {
                skipTo("-->");
            } else if (text.charAt(at) == '<') {
                parts.add(element(depth + 1));
            } else {
                words.append(text.charAt(at++));
            }
        }
        String ending = "</" + name;
        int end = text.indexOf('>', at);
        if (!text.startsWith(ending, at) || end < 0 || !text.substring(at + ending.length(), end).isBlank()
                || !parts.isEmpty() && !words.toString().isBlank()) {
            throw refused();
        }
        at = end + 1;
        return new Element(name, mark, parts.isEmpty() ? words(name, words.toString(), mark) : parts(parts, mark));
    }

    private static Node parts(List<Element> parts, Mark mark) {
        if (parts.stream().allMatch(e -> e.name.equals("_"))) {
            return list(parts.stream().map(Element::node).collect(Collectors.toList()), mark);
        }
        List<NodeTuple> tuples = new ArrayList<>();
        for (Element part : parts) {
            tuples.add(new NodeTuple(word(part.name, part.mark), part.node));
        }
        return new MappingNode(Tag.MAP, true, tuples, mark, mark, DumperOptions.FlowStyle.BLOCK);
    }

    /** The words of an element: one is a scalar, several are a list, and a matrix's data always are. */
    private Node words(String name, String content, Mark mark) {
        List<Node> items = new ArrayList<>();
        int i = 0;
        while (i < content.length()) {
            if (Character.isWhitespace(content.charAt(i))) {
                i++;
                continue;
            }
            int end = i;
            boolean quoted = content.charAt(i) == '"';
            if (quoted) {
                int closing = content.indexOf('"', i + 1);
                if (closing < 0) {
                    throw refused();
                }
                end = closing + 1;
            }
            while (!quoted && end < content.length() && !Character.isWhitespace(content.charAt(end))) {
                end++;
            }
            items.add(quoted ? word(content.substring(i + 1, end - 1), mark) : scalar(content.substring(i, end), mark));
            i = end;
        }
        if (items.size() == 1 && !name.equals("data")) {
            return items.get(0);
        }
        return items.isEmpty() ? scalar("", mark) : list(items, mark);
    }

    private static Node list(List<Node> items, Mark mark) {
        return new SequenceNode(Tag.SEQ, true, items, mark, mark, DumperOptions.FlowStyle.FLOW);
    }

    private static ScalarNode scalar(String value, Mark mark) {
        return new ScalarNode(value.isEmpty() ? Tag.NULL : Tag.STR, plain(value), mark, mark,
                DumperOptions.ScalarStyle.PLAIN);
    }

    private static ScalarNode word(String value, Mark mark) {
        return new ScalarNode(Tag.STR, plain(value), mark, mark, DumperOptions.ScalarStyle.DOUBLE_QUOTED);
    }

    private static String plain(String value) {
        String out = value;
        for (String[] entity : ENTITIES) {
            out = out.replace(entity[0], entity[1]);
        }
        return out;
    }
}
