package org.cellgauge.cell;

import java.io.Reader;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import org.cellgauge.internal.cell.CellPhrase;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;
import org.cellgauge.warning.RefusalKind;
import org.jspecify.annotations.Nullable;
import org.yaml.snakeyaml.DumperOptions;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.composer.Composer;
import org.yaml.snakeyaml.error.MarkedYAMLException;
import org.yaml.snakeyaml.error.YAMLException;
import org.yaml.snakeyaml.nodes.MappingNode;
import org.yaml.snakeyaml.nodes.Node;
import org.yaml.snakeyaml.nodes.ScalarNode;
import org.yaml.snakeyaml.nodes.SequenceNode;
import org.yaml.snakeyaml.nodes.Tag;
import org.yaml.snakeyaml.parser.ParserImpl;
import org.yaml.snakeyaml.reader.StreamReader;
import org.yaml.snakeyaml.resolver.Resolver;

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
    private static final String NO_ESCAPE_OR_TAG = "an escape after \\ or a tag after ! that is none";
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
     * @param what what it should be, such as {@link CellPhrase#CELL_FILE}
     * @param maxChars largest length
     * @return the value at its top
     * @throws InputRefusedException if it is empty, too long or no YAML
     */
    static YamlValue parse(String text, String file, RefusalKind what, int maxChars) {
        if (text.length() > maxChars) {
            throw new InputRefusedException(file, CellRefusal.TOO_LARGE, maxChars / 1024, what);
        }
        LoaderOptions options = new LoaderOptions();
        options.setCodePointLimit(maxChars + 1);
        options.setMaxAliasesForCollections(MAX_ALIASES);
        options.setNestingDepthLimit(MAX_DEPTH);
        options.setAllowRecursiveKeys(false);
        StreamReader characters = new StreamReader(new WholeCharacters(text));
        Node root;
        try {
            root = new Composer(new ParserImpl(characters, options), new Resolver(), options).getSingleNode();
        } catch (MarkedYAMLException e) {
            throw new InputRefusedException(syntax(e, file), e);
        } catch (YAMLException e) {
            throw new InputRefusedException(Refusal.at(Place.of(file), CellRefusal.NOT_YAML,
                    firstLine(e.getMessage()), what), e);
        } catch (IllegalArgumentException e) {
            // what the parser throws where an escape is cut short or no character, and where a tag is none
            throw new InputRefusedException(Refusal.at(Place.of(file, characters.getLine() + 1,
                    characters.getColumn() + 1, ""), CellRefusal.YAML_SYNTAX, NO_ESCAPE_OR_TAG), e);
        }
        if (root == null) {
            throw new InputRefusedException(file, CellRefusal.EMPTY, what);
        }
        return new YamlValue(file, "", root.getStartMark().getLine() + 1, root);
    }

    /**
     * The characters of a text, pairs of surrogates never apart: the parser reads in pieces, and stumbles over a
     * character of which a piece holds one half.
     */
    private static final class WholeCharacters extends Reader {
        private final String text;
        private int next;

        WholeCharacters(String text) {
            this.text = text;
        }

        @Override
        public int read(char[] into, int offset, int length) {
            int count = Math.min(length, text.length() - next);
            if (count <= 0) {
                return length > 0 ? -1 : 0;
            }
            if (count > 1 && next + count < text.length() && Character.isHighSurrogate(text.charAt(next + count - 1))) {
                count--;
            }
            text.getChars(next, next + count, into, offset);
            next += count;
            return count;
        }

        @Override
        public void close() {
            // nothing to close
        }
    }

    private static Refusal syntax(MarkedYAMLException e, String file) {
        String problem = e.getProblem() == null ? String.valueOf(e.getContext()) : e.getProblem();
        Place place = e.getProblemMark() == null ? Place.of(file)
                : Place.of(file, e.getProblemMark().getLine() + 1, e.getProblemMark().getColumn() + 1, "");
        if (problem.contains("TAB")) {
            return Refusal.at(place, CellRefusal.TAB);
        }
        if (problem.contains("but found another document")) {
            return Refusal.at(place, CellRefusal.SECOND_DOCUMENT);
        }
        return Refusal.at(place, CellRefusal.YAML_SYNTAX, firstLine(problem));
    }

    private static String firstLine(@Nullable String message) {
        String m = String.valueOf(message).trim();
        int end = m.indexOf('\n');
        return end < 0 ? m : m.substring(0, end);
    }

    /** A refusal of this value: file, line, key path, and what is wrong with it. */
    InputRefusedException refused(RefusalKind kind, Object... arguments) {
        return new InputRefusedException(refusal(kind, arguments));
    }

    static InputRefusedException refused(String file, int line, String path, RefusalKind kind, Object... arguments) {
        return new InputRefusedException(Refusal.at(Place.of(file, line, 0, path), kind, arguments));
    }

    /** The same as data. */
    Refusal refusal(RefusalKind kind, Object... arguments) {
        return Refusal.at(Place.of(file, line, 0, path), kind, arguments);
    }

    private InputRefusedException expected(Object what, Object got, Object remedy, Object hint) {
        return refused(CellRefusal.EXPECTED, what, got, remedy, hint);
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
     * @param example how to write it, as an argument of a refusal
     * @param known keys that may stand in it, or none where keys are ids
     */
    YamlMapping mapping(Object example, String... known) {
        if (!isMapping() || !Tag.MAP.equals(node.getTag())) {
            throw expected(CellPhrase.MAPPING, described(), example, "");
        }
        YamlMapping mapping = new YamlMapping(this, (MappingNode) node);
        if (known.length > 0) {
            mapping.refuseUnknown(Arrays.asList(known));
        }
        return mapping;
    }

    /** This value as a text, quoted or not. */
    String text(Object example) {
        if (!(node instanceof ScalarNode) || isEmpty() || ((ScalarNode) node).getValue().trim().isEmpty()) {
            throw expected(CellPhrase.TEXT, described(), example, "");
        }
        standardTag();
        return ((ScalarNode) node).getValue();
    }

    /**
     * This value as a finite number.
     *
     * @param remedy what to write, as an argument of a refusal
     */
    double number(Object remedy) {
        String text = scalar(CellPhrase.NUMBER, remedy);
        if (NOT_FINITE.matcher(text).matches()) {
            throw expected(CellPhrase.FINITE_NUMBER, text, remedy, "");
        }
        if (!NUMBER.matcher(text).matches() || octal(text)) {
            Object hint = "";
            if (text.matches("[-+]?\\d+,\\d+")) {
                hint = Refusal.of(CellPhrase.WITH_POINT, text.replace(',', '.'));
            } else if (WITH_UNIT.matcher(text).matches()) {
                hint = CellPhrase.WITHOUT_UNIT;
            }
            throw expected(CellPhrase.NUMBER, Refusal.of(CellPhrase.WORD, text), remedy, hint);
        }
        double value = Double.parseDouble(text);
        if (Double.isInfinite(value)) {
            throw expected(CellPhrase.FINITE_NUMBER, text, remedy, "");
        }
        return value;
    }

    /** This value as a finite number above 0. */
    double positive(Object remedy) {
        double value = number(remedy);
        if (!(value > 0)) {
            throw refused(CellRefusal.NOT_POSITIVE, ((ScalarNode) node).getValue(), remedy);
        }
        return value;
    }

    /** This value as a whole number within a range. */
    int whole(int min, int max, Object remedy) {
        String text = scalar(CellPhrase.WHOLE_NUMBER, remedy);
        if (!WHOLE.matcher(text).matches() || octal(text)) {
            throw expected(CellPhrase.WHOLE_NUMBER, Refusal.of(CellPhrase.WORD, text), remedy, "");
        }
        double value = Double.parseDouble(text);
        if (!(value >= min && value <= max)) {
            throw refused(CellRefusal.OUT_OF_RANGE, min, max, text, remedy);
        }
        return (int) value;
    }

    /** This value as a list of as many finite numbers. */
    double[] numbers(int count, Object remedy) {
        if (!isList()) {
            throw expected(Refusal.of(CellPhrase.NUMBERS, count), described(), remedy, "");
        }
        List<YamlValue> items = items();
        if (items.size() != count) {
            throw expected(Refusal.of(CellPhrase.NUMBERS, count), items.size(), remedy,
                    items.size() == 2 * count ? CellPhrase.POINT_NOT_COMMA : "");
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
            throw expected(CellPhrase.LIST, described(), "[a, b, ...]", "");
        }
        List<YamlValue> items = new ArrayList<>();
        for (Node item : ((SequenceNode) node).getValue()) {
            items.add(new YamlValue(file, path + "[" + items.size() + "]", item.getStartMark().getLine() + 1, item));
        }
        return items;
    }

    private String scalar(CellPhrase expected, Object remedy) {
        if (!(node instanceof ScalarNode) || isEmpty()) {
            throw expected(expected, described(), remedy, "");
        }
        ScalarNode scalar = (ScalarNode) node;
        standardTag();
        if (scalar.getScalarStyle() != DumperOptions.ScalarStyle.PLAIN) {
            throw expected(expected, Refusal.of(CellPhrase.QUOTED, scalar.getValue()), remedy,
                    CellPhrase.WITHOUT_QUOTES);
        }
        return scalar.getValue();
    }

    private void standardTag() {
        if (!node.getTag().getValue().startsWith(Tag.PREFIX) || Tag.BINARY.equals(node.getTag())) {
            throw refused(CellRefusal.TAG, node.getTag().getValue());
        }
    }

    private static boolean octal(String text) {
        return text.matches("[-+]?0\\d.*");
    }

    /** What stands here. */
    private Refusal described() {
        if (node instanceof SequenceNode) {
            return Refusal.of(CellPhrase.LIST);
        }
        if (node instanceof MappingNode) {
            return Refusal.of(CellPhrase.MAPPING);
        }
        if (isEmpty() || ((ScalarNode) node).getValue().trim().isEmpty()) {
            return Refusal.of(CellPhrase.NOTHING);
        }
        String value = ((ScalarNode) node).getValue();
        return Refusal.of(CellPhrase.WORD, value.length() > 40 ? value.substring(0, 40) + "..." : value);
    }
}
