package org.cellgauge.output;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import com.google.gson.Strictness;
import com.google.gson.stream.JsonReader;
import com.google.gson.stream.JsonToken;
import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.check.Verdict;
import org.cellgauge.estimate.VarianceSource;
import org.cellgauge.internal.cell.InputFiles;
import org.cellgauge.statistics.Ellipse;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;

/**
 * Reads result files back: {@code NAME.result.json}, as {@link ResultJson} writes it.
 *
 * <p>What a file does not hold is absent in the view: modes of a pose that is not ambiguous, and the verdicts of rows
 * in files of versions that did not write them. Keys that are not known are passed over, so that files of later
 * versions of the same {@code schema} can be read. Every refusal names file, place and remedy.
 */
public final class ResultReader {
    /** Largest result file that is read, bytes. */
    public static final int MAX_BYTES = 64 << 20;

    private static final Pattern PLACE = Pattern.compile("line (\\d+) column (\\d+)");

    private final String file;

    private ResultReader(String file) {
        this.file = file;
    }

    /**
     * Reads a result file.
     *
     * @param file JSON in UTF-8
     * @return what it holds
     * @throws InputRefusedException if it is missing, not readable or no result file
     */
    public static ResultView read(Path file) {
        return of(InputFiles.text(file, ResultRefusal.RESULT_FILE, MAX_BYTES), file.toString());
    }

    /**
     * Reads a result from its text.
     *
     * @param json the text of a result file
     * @param displayName the name that messages give it
     * @return what it holds
     * @throws InputRefusedException if it is no result
     */
    public static ResultView of(String json, String displayName) {
        ResultReader reader = new ResultReader(displayName);
        return reader.view(reader.root(json));
    }

    private Node root(String text) {
        JsonReader json = new JsonReader(new StringReader(text));
        json.setStrictness(Strictness.STRICT);
        try {
            JsonElement element = JsonParser.parseReader(json);
            if (json.peek() != JsonToken.END_DOCUMENT) {
                throw new InputRefusedException(file, ResultRefusal.MORE_TEXT);
            }
            return new Node(element, "");
        } catch (IOException | JsonParseException e) {
            Matcher place = PLACE.matcher(String.valueOf(e.getMessage()));
            boolean found = place.find();
            throw new InputRefusedException(Refusal.at(Place.of(file, found ? Integer.parseInt(place.group(1)) : 0,
                    found ? Integer.parseInt(place.group(2)) : 0, ""), ResultRefusal.NOT_JSON), e);
        }
    }

    private ResultView view(Node root) {
        int schema = root.at("schema").integer();
        if (schema != ResultJson.SCHEMA) {
            throw root.at("schema").refused(ResultRefusal.OTHER_SCHEMA, schema, ResultJson.SCHEMA);
        }
        List<ResultRow> rows = new ArrayList<>();
        Node camera = root.at("camera");
        rows.add(new ResultRow.Builder(ResultRow.Kind.CAMERA, OptionalInt.empty()).pose(pose(camera))
                .modes(modes(camera)).build());
        Node objects = root.at("objects");
        Set<String> ids = new LinkedHashSet<>(root.at("settings").at("object_markers").keys());
        ids.addAll(objects.keys());
        for (String id : ids) {
            addObject(id, objects, rows);
        }
        List<ResultView.Intrinsic> intrinsics = new ArrayList<>();
        Node unknown = root.find("intrinsics");
        if (unknown != null) {
            List<Node> names = unknown.at("names").elements();
            double[] mean = unknown.at("mean").numbers(names.size());
            double[] std = unknown.at("std").numbers(names.size());
            for (int i = 0; i < mean.length; i++) {
                intrinsics.add(new ResultView.Intrinsic(names.get(i).text(), mean[i], std[i]));
            }
        }
        List<String> warnings = new ArrayList<>();
        root.at("warnings").elements().forEach(warning -> warnings.add(warning.text()));
        double target = root.at("target").at("std_mm").number();
        return new ResultView(root.at("verdict").verdict(), root.at("decided").bool(), root.at("reason").text(),
                Double.isNaN(target) ? OptionalDouble.empty() : OptionalDouble.of(target), rows, intrinsics,
                chains(root.at("diagnostics")), warnings);
    }

    private void addObject(String key, Node objects, List<ResultRow> rows) {
        OptionalInt id = OptionalInt.of(objects.id(key));
        ResultRow.Builder row = new ResultRow.Builder(ResultRow.Kind.OBJECT, id);
        Node object = objects.find(key);
        if (object == null) {
            rows.add(row.build());
            return;
        }
        Node within = object.find("within_target");
        rows.add(row.pose(pose(object.at("pose"))).modes(modes(object)).budget(budget(object, "budget"))
                .ellipse95Px(ellipse(object.find("ellipse95_px"))).verdict(verdict(object.find("position_verdict")))
                .withinTarget(within == null ? null : within.bool()).build());
        Node grip = object.find("grip");
        if (grip != null) {
            rows.add(new ResultRow.Builder(ResultRow.Kind.GRIP, id)
                    .point(grip.at("mean").numbers(3), grip.at("covariance").matrix(3))
                    .budget(budget(object, "grip_budget")).ellipse95Px(ellipse(object.find("grip_ellipse95_px")))
                    .verdict(verdict(object.find("grip_verdict"))).build());
        }
    }

    private static Verdict verdict(Node node) {
        return node == null ? null : node.verdict();
    }

    private static PoseView pose(Node pose) {
        return PoseView.read(pose.at("frame").text(), pose.at("mean").numbers(6), pose.at("covariance").matrix(6),
                pose.at("tangent_base").numbers(3), pose.at("tangent_covariance").matrix(6));
    }

    private static List<ModeView> modes(Node around) {
        List<ModeView> modes = new ArrayList<>();
        Node list = around.find("modes");
        if (list != null) {
            list.elements().forEach(mode -> modes.add(new ModeView(mode.at("weight").number(), pose(mode))));
        }
        return modes;
    }

    private static List<BudgetShare> budget(Node object, String name) {
        String[] axes = {"x", "y", "z"};
        List<Node> shares = new ArrayList<>();
        List<Node> gains = new ArrayList<>();
        shares.add(object.at(name));
        gains.add(object.at(name + "_gain"));
        for (String axis : axes) {
            shares.add(object.at(name + "_axes").at(axis));
            gains.add(object.at(name + "_gain_axes").at(axis));
        }
        List<BudgetShare> all = new ArrayList<>();
        for (String key : shares.get(0).keys()) {
            all.add(new BudgetShare(shares.get(0).source(key), column(shares, key), column(gains, key)));
        }
        return all;
    }

    private static double[] column(List<Node> parts, String key) {
        return parts.stream().map(part -> part.find(key)).mapToDouble(n -> n == null ? Double.NaN : n.number())
                .toArray();
    }

    private static Ellipse ellipse(Node ellipse) {
        if (ellipse == null) {
            return null;
        }
        double[] centre = ellipse.at("centre").numbers(2);
        double[] axes = ellipse.at("semi_axes").numbers(2);
        return new Ellipse(centre[0], centre[1], axes[0], axes[1], ellipse.at("angle_rad").number());
    }

    private static ChainsView chains(Node d) {
        List<QuantityView> quantities = new ArrayList<>();
        Node parameters = d.at("parameters");
        for (String name : parameters.keys()) {
            Node parameter = parameters.at(name);
            double[] numbers = new double[QuantityView.KEYS.length];
            for (int i = 0; i < numbers.length; i++) {
                numbers[i] = parameter.at(QuantityView.KEYS[i]).number();
            }
            quantities.add(new QuantityView(name, parameter.at("status").text(), numbers));
        }
        Node worst = d.find("worst_parameter");
        return new ChainsView(d.at("converged").bool(), new double[] {d.at("r_hat_max").number(),
            d.at("ess_bulk_min").number(), d.at("ess_tail_min").number(), d.at("mcse_std_rel_max").number(),
            d.at("pareto_k_max").number()}, worst == null ? null : worst.text(), () -> quantities);
    }

    /** A value of the file and the keys that lead to it. */
    private final class Node {
        private final JsonElement element;
        private final String path;

        Node(JsonElement element, String path) {
            this.element = element;
            this.path = path;
        }

        InputRefusedException refused(ResultRefusal kind, Object... arguments) {
            return new InputRefusedException(Refusal.at(Place.of(file, 0, 0, path), kind, arguments));
        }

        private InputRefusedException expected(ResultRefusal what) {
            return refused(ResultRefusal.EXPECTED, Refusal.of(what));
        }

        private JsonObject object() {
            if (!element.isJsonObject()) {
                throw expected(ResultRefusal.OBJECT);
            }
            return element.getAsJsonObject();
        }

        /** A member; null where it is missing or {@code null}. */
        Node find(String key) {
            JsonElement member = object().get(key);
            return member == null || member.isJsonNull() ? null : new Node(member, path(key));
        }

        private String path(String key) {
            return path.isEmpty() ? key : path + "." + key;
        }

        Node at(String key) {
            JsonElement member = object().get(key);
            if (member == null) {
                throw refused(ResultRefusal.MISSING, key);
            }
            return new Node(member, path(key));
        }

        List<String> keys() {
            return new ArrayList<>(object().keySet());
        }

        List<Node> elements() {
            if (!element.isJsonArray()) {
                throw expected(ResultRefusal.LIST);
            }
            JsonArray array = element.getAsJsonArray();
            List<Node> nodes = new ArrayList<>();
            for (int i = 0; i < array.size(); i++) {
                nodes.add(new Node(array.get(i), path + "[" + i + "]"));
            }
            return nodes;
        }

        /** NaN for {@code null}. */
        double number() {
            if (element.isJsonNull()) {
                return Double.NaN;
            }
            if (!element.isJsonPrimitive() || !element.getAsJsonPrimitive().isNumber()) {
                throw expected(ResultRefusal.NUMBER);
            }
            return element.getAsDouble();
        }

        int integer() {
            double number = number();
            if (number != Math.rint(number) || Math.abs(number) > Integer.MAX_VALUE) {
                throw expected(ResultRefusal.WHOLE_NUMBER);
            }
            return (int) number;
        }

        double[] numbers(int count) {
            List<Node> all = elements();
            if (all.size() != count) {
                throw refused(ResultRefusal.OTHER_COUNT, count, all.size());
            }
            return all.stream().mapToDouble(Node::number).toArray();
        }

        double[][] matrix(int size) {
            List<Node> all = elements();
            if (all.size() != size) {
                throw refused(ResultRefusal.OTHER_COUNT, size, all.size());
            }
            return all.stream().map(row -> row.numbers(size)).toArray(double[][]::new);
        }

        boolean bool() {
            if (!element.isJsonPrimitive() || !element.getAsJsonPrimitive().isBoolean()) {
                throw expected(ResultRefusal.BOOLEAN);
            }
            return element.getAsBoolean();
        }

        String text() {
            if (!element.isJsonPrimitive() || !element.getAsJsonPrimitive().isString()) {
                throw expected(ResultRefusal.TEXT);
            }
            return element.getAsString();
        }

        Verdict verdict() {
            for (Verdict verdict : Verdict.values()) {
                if (verdict.key().equals(text())) {
                    return verdict;
                }
            }
            throw refused(ResultRefusal.UNKNOWN_WORD, text());
        }

        int id(String key) {
            try {
                return Integer.parseInt(key);
            } catch (NumberFormatException e) {
                throw refused(ResultRefusal.UNKNOWN_WORD, key);
            }
        }

        VarianceSource source(String key) {
            try {
                return VarianceSource.ofKey(key);
            } catch (IllegalArgumentException e) {
                throw refused(ResultRefusal.UNKNOWN_WORD, key);
            }
        }
    }
}
