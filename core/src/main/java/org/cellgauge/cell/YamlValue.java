package org.cellgauge.cell;

import java.io.StringReader;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import org.yaml.snakeyaml.DumperOptions;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.Yaml;
import org.yaml.snakeyaml.error.MarkedYAMLException;
import org.yaml.snakeyaml.error.YAMLException;
import org.yaml.snakeyaml.nodes.MappingNode;
import org.yaml.snakeyaml.nodes.Node;
import org.yaml.snakeyaml.nodes.ScalarNode;
import org.yaml.snakeyaml.nodes.SequenceNode;
import org.yaml.snakeyaml.nodes.Tag;

/**
 * A value of a YAML file that knows where it stands, so that every refusal names file, line and key.
 *
 * <p>It reads the node graph rather than Java objects: only there do lines, quotes and repeated keys still exist.
 * Numbers are plain decimal numbers. What YAML 1.1 would also take for one (octal 012, 1:30 for 90) is refused, since
 * nobody who writes it in such a file means it.
 */
final class YamlValue {
    private static final Pattern NUMBER = Pattern.compile("[-+]?(\\d+(\\.\\d*)?|\\.\\d+)([eE][-+]?\\d+)?");
    private static final Pattern NOT_FINITE = Pattern.compile("[-+]?\\.?(nan|inf|infinity)", Pattern.CASE_INSENSITIVE);
    private static final Pattern WHOLE = Pattern.compile("[-+]?\\d+");
    private static final Pattern WITH_UNIT = Pattern.compile("([-+]?[\\d.]+) ?(mm|cm|m|px|deg|°|rad)");
    private static final int MAX_ALIASES = 50;
    private static final int MAX_DEPTH = 20;

    private final String file;
    private final String path;
    private final int line;
    private final Node node;

    YamlValue(String file, String path, int line, Node node) {
        this.file = file;
        this.path = path;
        this.line = line;
        this.node = node;
    }

    /**
     * Parses a file that holds one mapping.
     *
     * @param text YAML text
     * @param file its name for messages
     * @param what what it should be, "cell file"
     * @param maxChars largest length
     * @return the value at its top
     * @throws InputRefusedException if it is empty, too long or no YAML
     */
    static YamlValue parse(String text, String file, String what, int maxChars) {
        if (text.length() > maxChars) {
            throw new InputRefusedException(file + ": larger than " + maxChars / 1024 + " KiB, which no " + what
                    + " is; check the name of the file");
        }
        LoaderOptions options = new LoaderOptions();
        options.setCodePointLimit(maxChars + 1);
        options.setMaxAliasesForCollections(MAX_ALIASES);
        options.setNestingDepthLimit(MAX_DEPTH);
        options.setAllowRecursiveKeys(false);
        Node root;
        try {
            root = new Yaml(options).compose(new StringReader(text));
        } catch (MarkedYAMLException e) {
            throw new InputRefusedException(syntax(e, file), e);
        } catch (YAMLException e) {
            throw new InputRefusedException(file + ": not readable as YAML (" + firstLine(e.getMessage())
                    + "); check that this is a " + what, e);
        }
        if (root == null) {
            throw new InputRefusedException(file + ": the file is empty; name a filled " + what);
        }
        return new YamlValue(file, "", root.getStartMark().getLine() + 1, root);
    }

    private static String syntax(MarkedYAMLException e, String file) {
        String problem = e.getProblem() == null ? String.valueOf(e.getContext()) : e.getProblem();
        StringBuilder s = new StringBuilder(file);
        if (e.getProblemMark() != null) {
            s.append(", line ").append(e.getProblemMark().getLine() + 1).append(", column ")
                    .append(e.getProblemMark().getColumn() + 1);
        }
        s.append(": ");
        if (problem.contains("TAB")) {
            return s.append("a tab stands where YAML allows only spaces; indent with spaces").toString();
        }
        if (problem.contains("but found another document")) {
            return s.append("a second document begins here; delete \"---\" and keep one document").toString();
        }
        return s.append("not valid YAML (").append(firstLine(problem))
                .append("); check brackets, quotes, colons and indentation near this place").toString();
    }

    private static String firstLine(String message) {
        String m = String.valueOf(message).trim();
        int end = m.indexOf('\n');
        return end < 0 ? m : m.substring(0, end);
    }

    /** A refusal of this value: file, line, key path and the given words. */
    InputRefusedException refused(String problem) {
        return refused(file, line, path, problem);
    }

    static InputRefusedException refused(String file, int line, String path, String problem) {
        return new InputRefusedException(file + ", line " + line + (path.isEmpty() ? "" : ", " + path) + ": "
                + problem);
    }

    int line() {
        return line;
    }

    String file() {
        return file;
    }

    String path() {
        return path;
    }

    Node node() {
        return node;
    }

    /** Whether nothing stands after the colon, or "null" or "~". */
    boolean isEmpty() {
        return node instanceof ScalarNode && Tag.NULL.equals(node.getTag());
    }

    boolean isMapping() {
        return node instanceof MappingNode;
    }

    boolean isList() {
        return node instanceof SequenceNode;
    }

    /** Whether it is one word, quoted or not, equal to the given one. */
    boolean is(String word) {
        return node instanceof ScalarNode && ((ScalarNode) node).getValue().equals(word);
    }

    /**
     * This value as a mapping with none but the known keys.
     *
     * @param example how to write it, for the remedy
     * @param known keys that may stand in it, or none where keys are ids
     */
    YamlMapping mapping(String example, String... known) {
        if (!isMapping() || !Tag.MAP.equals(node.getTag())) {
            throw refused("expected a mapping of keys, got " + described() + "; write " + example);
        }
        YamlMapping mapping = new YamlMapping(this, (MappingNode) node);
        if (known.length > 0) {
            mapping.refuseUnknown(Arrays.asList(known));
        }
        return mapping;
    }

    /** This value as a text, quoted or not. */
    String text(String example) {
        if (!(node instanceof ScalarNode) || isEmpty() || ((ScalarNode) node).getValue().trim().isEmpty()) {
            throw refused("expected a text, got " + described() + "; write " + example);
        }
        standardTag();
        return ((ScalarNode) node).getValue();
    }

    /**
     * This value as a finite number.
     *
     * @param remedy what to write, as in "a length in mm"
     */
    double number(String remedy) {
        String text = scalar("a number", remedy);
        if (NOT_FINITE.matcher(text).matches()) {
            throw refused("expected a finite number, got " + text + "; write " + remedy);
        }
        if (!NUMBER.matcher(text).matches() || octal(text)) {
            String hint = "";
            if (text.matches("[-+]?\\d+,\\d+")) {
                hint = ", with a decimal point: " + text.replace(',', '.');
            } else if (WITH_UNIT.matcher(text).matches()) {
                hint = ", the number alone without its unit";
            }
            throw refused("expected a number, got \"" + text + "\"; write " + remedy + hint);
        }
        double value = Double.parseDouble(text);
        if (Double.isInfinite(value)) {
            throw refused("expected a finite number, got " + text + "; write " + remedy);
        }
        return value;
    }

    /** This value as a finite number above 0. */
    double positive(String remedy) {
        double value = number(remedy);
        if (!(value > 0)) {
            throw refused("must be greater than 0, got " + ((ScalarNode) node).getValue() + "; write " + remedy);
        }
        return value;
    }

    /** This value as a whole number within a range. */
    int whole(int min, int max, String remedy) {
        String text = scalar("a whole number", remedy);
        if (!WHOLE.matcher(text).matches() || octal(text)) {
            throw refused("expected a whole number, got \"" + text + "\"; write " + remedy);
        }
        double value = Double.parseDouble(text);
        if (!(value >= min && value <= max)) {
            throw refused("must be from " + min + " to " + max + ", got " + text + "; write " + remedy);
        }
        return (int) value;
    }

    /** This value as a list of as many finite numbers. */
    double[] numbers(int count, String remedy) {
        if (!isList()) {
            throw refused("expected " + count + " numbers, got " + described() + "; write " + remedy);
        }
        List<YamlValue> items = items();
        if (items.size() != count) {
            String hint = items.size() == 2 * count ? " (decimal numbers take a point, not a comma)" : "";
            throw refused("expected " + count + " numbers, got " + items.size() + "; write " + remedy + hint);
        }
        double[] values = new double[count];
        for (int i = 0; i < count; i++) {
            values[i] = items.get(i).number(remedy);
        }
        return values;
    }

    /** The values of a list. */
    List<YamlValue> items() {
        if (!isList() || !Tag.SEQ.equals(node.getTag())) {
            throw refused("expected a list, got " + described() + "; write [a, b, ...]");
        }
        List<YamlValue> items = new ArrayList<>();
        for (Node item : ((SequenceNode) node).getValue()) {
            items.add(new YamlValue(file, path + "[" + items.size() + "]", item.getStartMark().getLine() + 1, item));
        }
        return items;
    }

    private String scalar(String expected, String remedy) {
        if (!(node instanceof ScalarNode) || isEmpty()) {
            throw refused("expected " + expected + ", got " + described() + "; write " + remedy);
        }
        ScalarNode scalar = (ScalarNode) node;
        standardTag();
        if (scalar.getScalarStyle() != DumperOptions.ScalarStyle.PLAIN) {
            throw refused("expected " + expected + ", got the text \"" + scalar.getValue() + "\"; write " + remedy
                    + ", without quotes");
        }
        return scalar.getValue();
    }

    private void standardTag() {
        if (!node.getTag().getValue().startsWith(Tag.PREFIX) || Tag.BINARY.equals(node.getTag())) {
            throw refused("the tag " + node.getTag().getValue() + " is not understood; delete it");
        }
    }

    private static boolean octal(String text) {
        return text.matches("[-+]?0\\d.*");
    }

    /** What stands here, for messages. */
    String described() {
        if (node instanceof SequenceNode) {
            return "a list";
        }
        if (node instanceof MappingNode) {
            return "a mapping of keys";
        }
        if (isEmpty() || ((ScalarNode) node).getValue().trim().isEmpty()) {
            return "nothing";
        }
        String value = ((ScalarNode) node).getValue();
        return "\"" + (value.length() > 40 ? value.substring(0, 40) + "..." : value) + "\"";
    }
}
