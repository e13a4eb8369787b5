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
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.Requirement;
import org.cellgauge.cell.Target;
import org.cellgauge.check.Conformity;
import org.cellgauge.check.Verdict;
import org.cellgauge.estimate.VarianceSource;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.Lens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.cell.InputFiles;
import org.cellgauge.internal.geometry.Lenses;
import org.cellgauge.internal.settings.SettingsJson;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.placement.Misfit;
import org.cellgauge.sampling.AcceptanceCount;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.statistics.Ellipse;
import org.cellgauge.vision.PhotoLight;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;
import org.jspecify.annotations.Nullable;

/**
 * Reads result files back: {@code NAME.result.json}, as {@link ResultJson} writes it.
 *
 * <p>Keys that are not known are passed over, so that files of later versions of the same {@code schema} can be read.
 * Every refusal names file, place and remedy.
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
        return stored(file).view();
    }

    /**
     * Reads a result file, and what it is of.
     *
     * @param file JSON in UTF-8
     * @return what it holds
     * @throws InputRefusedException if it is missing, not readable or no result file
     */
    public static StoredResult stored(Path file) {
        return stored(InputFiles.text(file, ResultRefusal.RESULT_FILE, MAX_BYTES), file.toString());
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
        return stored(json, displayName).view();
    }

    /**
     * Reads a result, and what it is of, from its text.
     *
     * @param json the text of a result file
     * @param displayName the name that messages give it
     * @return what it holds
     * @throws InputRefusedException if it is no result
     */
    public static StoredResult stored(String json, String displayName) {
        ResultReader reader = new ResultReader(displayName);
        return reader.stored(reader.root(json));
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

    private StoredResult stored(Node root) {
        int schema = root.at("schema").integer();
        if (schema != ResultJson.SCHEMA) {
            throw root.at("schema").refused(ResultRefusal.OTHER_SCHEMA, schema, ResultJson.SCHEMA);
        }
        return new StoredResult(view(root), record(root));
    }

    private static ResultRecord record(Node root) {
        Node input = root.at("input");
        Node cell = root.find("cell");
        Node camera = root.find("camera_file");
        return ResultRecord.of(input.at("name").text(), input.textOrNull("sha256"), root.at("version").text())
                .withCell(cell == null ? null : cell.at("name").text(), cell == null ? null : cell.textOrNull("sha256"))
                .withCamera(camera == null ? null : camera.at("name").text(),
                        camera == null ? null : camera.textOrNull("sha256"))
                .withDate(root.textOrNull("date")).withJudgedOn(root.textOrNull("judged_on"))
                .withCommand(root.textOrNull("command"));
    }

    private ResultView view(Node root) {
        Node settings = root.at("settings");
        Node laplace = root.at("laplace");
        List<ResultRow> rows = new ArrayList<>();
        Node camera = root.at("camera");
        rows.add(new ResultRow.Builder(ResultRow.Kind.CAMERA, OptionalInt.empty()).pose(pose(camera))
                .modes(modes(camera)).laplace(comparison(laplace.at("camera"), "", 6)).build());
        Node objects = root.at("objects");
        Set<String> ids = new LinkedHashSet<>(settings.at("object_markers").keys());
        ids.addAll(objects.keys());
        for (String id : ids) {
            addObject(id, objects, laplace.at("objects"), rows);
        }
        NoiseView noise = noise(root.at("noise"), settings, root.find("edges"));
        CellView cell = cell(settings, noise);
        ResultView.Builder view = new ResultView.Builder(cell)
                .judged(root.at("verdict").verdict(), root.at("decided").bool(), root.at("reason").text(),
                        target(root.at("target")))
                .rows(rows).run(run(settings)).foundations(noise, references(root, cell))
                .chains(chains(root.at("diagnostics"), root.at("acceptance"))).warnings(warnings(root))
                .action(root.find("action") == null ? null : root.at("action").text());
        view.advice(advice(root.find("plan")));
        Node light = root.find("light");
        if (light != null) {
            PhotoLight seen = new PhotoLight(light.at("tone_curve").toneCurve(),
                    light.at("tone_curve_estimated").bool(),
                    light.at("blur_px").number(), light.at("noise_grey").number(),
                    light.at("noise_degrees_of_freedom").number(), light.at("edge_shift_std_px").number());
            // results of earlier versions do not say it
            view.light(light.find("outline_std_px") == null ? seen
                    : seen.withOutlineStdPx(light.at("outline_std_px").number()));
        }
        Node unknown = root.find("intrinsics");
        if (unknown != null) {
            List<ResultView.Intrinsic> intrinsics = new ArrayList<>();
            List<Node> names = unknown.at("names").elements();
            double[] mean = unknown.at("mean").numbers(names.size());
            double[] std = unknown.at("std").numbers(names.size());
            double[] priorMean = unknown.at("prior_mean").numbers(names.size());
            double[] priorStd = unknown.at("prior_std").numbers(names.size());
            List<Node> calibrated = unknown.at("calibrated").elements();
            for (int i = 0; i < mean.length; i++) {
                intrinsics.add(new ResultView.Intrinsic(names.get(i).text(), mean[i], std[i], priorMean[i],
                        priorStd[i], calibrated.get(i).bool()));
            }
            view.intrinsics(intrinsics, unknown.at("covariance").matrix(names.size()));
        }
        return view.build();
    }

    private static List<WarningView> warnings(Node root) {
        List<String> texts = new ArrayList<>();
        root.at("warnings").elements().forEach(warning -> texts.add(warning.text()));
        List<Node> codes = root.at("warning_codes").elements();
        if (codes.size() != texts.size()) {
            throw root.at("warning_codes").refused(ResultRefusal.OTHER_COUNT, texts.size(), codes.size());
        }
        List<WarningView> warnings = new ArrayList<>();
        for (int i = 0; i < texts.size(); i++) {
            warnings.add(new WarningView(codes.get(i).text(), texts.get(i)));
        }
        return warnings;
    }

    // ---- the target

    private static Target target(Node target) {
        Map<Integer, Requirement> own = new HashMap<>();
        Node objects = target.find("objects");
        if (objects != null) {
            for (String id : objects.keys()) {
                own.put(objects.id(id), requirement(objects.at(id)));
            }
        }
        return new Target(requirement(target), own);
    }

    private static Requirement requirement(Node asked) {
        Node probability = asked.find("probability");
        try {
            return new Requirement(limits(asked.find("std_mm")), limits(asked.find("tolerance_mm")),
                    limit(asked.find("distance_mm")), limit(asked.find("tolerance_deg")),
                    probability == null ? Requirement.USUAL_PROBABILITY : probability.number());
        } catch (IllegalArgumentException e) {
            throw asked.refused(ResultRefusal.NOT_POSSIBLE, String.valueOf(e.getMessage()));
        }
    }

    private static Requirement.Axes limits(@Nullable Node limits) {
        if (limits != null && limits.isList()) {
            double[] axes = limits.numbers(3);
            return new Requirement.Axes(limit(axes[0]), limit(axes[1]), limit(axes[2]));
        }
        return Requirement.Axes.all(limit(limits));
    }

    private static double limit(@Nullable Node limit) {
        return limit == null ? Double.POSITIVE_INFINITY : limit(limit.number());
    }

    private static double limit(double number) {
        return Double.isNaN(number) ? Double.POSITIVE_INFINITY : number;
    }

    private static List<AdviceView> advice(@Nullable Node all) {
        List<AdviceView> found = new ArrayList<>();
        if (all == null) {
            return found;
        }
        for (Node node : all.elements()) {
            List<String> codes = new ArrayList<>();
            List<String> sentences = new ArrayList<>();
            for (Node change : node.at("changes").elements()) {
                codes.add(change.at("code").text());
                sentences.add(change.at("sentence").text());
            }
            int axis = "xyz".indexOf(node.at("axis").text());
            if (axis < 0) {
                throw node.at("axis").refused(ResultRefusal.UNKNOWN_WORD, node.at("axis").text());
            }
            found.add(new AdviceView(codes, sentences, node.at("cost").number(), node.at("object").integer(),
                    node.at("point").text().equals("grip"), axis, node.at("now_std_mm").number(),
                    node.at("then_std_mm").number(), node.at("worst_std_mm").number()));
        }
        return found;
    }

    private static List<Conformity> conformity(@Nullable Node all) {
        List<Conformity> found = new ArrayList<>();
        if (all == null) {
            return found;
        }
        for (Node node : all.elements()) {
            Conformity.Of of = node.at("of").conformity();
            found.add(new Conformity(of, node.at("tolerance_" + of.unit()).number(), node.at("probability").number(),
                    node.at("mcse").number(), node.at("asked").number()));
        }
        return found;
    }

    // ---- rows

    private static void addObject(String key, Node objects, Node laplace, List<ResultRow> rows) {
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
                .withinTarget(within == null ? null : Boolean.valueOf(within.bool()))
                .laplace(comparison(laplace.at(key), "", 6))
                .conformities(conformity(object.find("position_conformity")))
                .build());
        Node grip = object.find("grip");
        if (grip != null) {
            rows.add(new ResultRow.Builder(ResultRow.Kind.GRIP, id)
                    .point(grip.at("mean").numbers(3), grip.at("covariance").matrix(3))
                    .budget(budget(object, "grip_budget")).ellipse95Px(ellipse(object.find("grip_ellipse95_px")))
                    .verdict(verdict(object.find("grip_verdict"))).laplace(comparison(laplace.at(key), "grip_", 3))
                    .conformities(conformity(object.find("grip_conformity"))).build());
        }
    }

    private static @Nullable Verdict verdict(@Nullable Node node) {
        return node == null ? null : node.verdict();
    }

    private static LaplaceView comparison(Node laplace, String prefix, int size) {
        return new LaplaceView(laplace.at(prefix + "mean").numbers(size), laplace.at(prefix + "std").numbers(size),
                laplace.at(prefix + "mean_shift_by_std").numbers(size),
                laplace.at(prefix + "sampled_by_laplace").numbers(size));
    }

    private static PoseView pose(Node pose) {
        String frame = pose.at("frame").text();
        double[] mean = pose.at("mean").numbers(6);
        double[] base = pose.at("tangent_base").numbers(3);
        double[][] covariance = pose.at("covariance").matrix(6);
        double[][] tangent = pose.at("tangent_covariance").matrix(6);
        return pose.possible(() -> PoseView.read(frame, mean, covariance, base, tangent));
    }

    private static List<ModeView> modes(Node around) {
        List<ModeView> modes = new ArrayList<>();
        for (String key : List.of("modes", "lesser_modes")) {
            Node list = around.find(key);
            if (list != null) {
                list.elements().forEach(mode -> modes.add(new ModeView(mode.at("weight").number(), pose(mode))));
            }
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
        if (shares.get(0).keys().isEmpty()) {
            throw shares.get(0).refused(ResultRefusal.NOT_POSSIBLE, "no source of variance");
        }
        List<BudgetShare> all = new ArrayList<>();
        for (String key : shares.get(0).keys()) {
            all.add(new BudgetShare(shares.get(0).source(key), column(shares, key), column(gains, key)));
        }
        return all;
    }

    private static double[] column(List<Node> parts, String key) {
        return parts.stream().mapToDouble(part -> {
            Node number = part.find(key);
            return number == null ? Double.NaN : number.number();
        }).toArray();
    }

    private static @Nullable Ellipse ellipse(@Nullable Node ellipse) {
        if (ellipse == null) {
            return null;
        }
        double[] centre = ellipse.at("centre").numbers(2);
        double[] axes = ellipse.at("semi_axes").numbers(2);
        double angle = ellipse.at("angle_rad").number();
        return ellipse.possible(() -> new Ellipse(centre[0], centre[1], axes[0], axes[1], angle));
    }

    // ---- what figures rest on

    private static RunView run(Node settings) {
        return new RunView(settings.settings(), settings.at("sampler_used").text(),
                settings.at("iterations_run").integer(), settings.textOrNull("pose_prior"));
    }

    private static CellView cell(Node settings, NoiseView noise) {
        Node prints = settings.at("prints");
        List<StatedReference> references = new ArrayList<>();
        Node stated = settings.at("references");
        for (String id : stated.keys()) {
            Node reference = stated.at(id);
            references.add(new StatedReference(stated.id(id), reference.at("size_mm").number(),
                    reference.at("position_mm").numbers(3), reference.at("rotation_rad").numbers(3),
                    reference.at("placement").at("std_mm").numbers(3),
                    reference.at("placement").at("std_rad").number()));
        }
        List<StatedObject> objects = new ArrayList<>();
        Node markers = settings.at("object_markers");
        for (String id : markers.keys()) {
            Node grip = markers.at(id).find("grip_mm");
            objects.add(new StatedObject(markers.id(id), markers.at(id).at("size_mm").number(),
                    grip == null ? null : grip.numbers(3)));
        }
        boolean noiseStated = settings.at("pixel_std_px_from").text().equals("cell file");
        Node curve = settings.at("tone_curve");
        return new CellView(settings.at("camera_intrinsics").camera(), settings.at("marker_family").text(),
                noiseStated ? OptionalDouble.of(noise.usualStdPx()) : OptionalDouble.empty(),
                curve.text().equals("auto") ? null : curve.toneCurve(), prints.at("size_std_mm").number(),
                prints.at("flatness_mm").number(), prints.at("print_gain_std_mm").number(), references, objects);
    }

    private static NoiseView noise(Node noise, Node settings, @Nullable Node edges) {
        Node fit = noise.at("fit");
        List<MarkerNoise> markers = new ArrayList<>();
        for (String id : noise.at("markers").keys()) {
            Node marker = noise.at("markers").at(id);
            markers.add(new MarkerNoise(noise.id(id), marker.at("std_px").number(),
                    marker.at("times_stated").number(), marker.at("set_aside_times").number()));
        }
        return new NoiseView(noise.at("stated").bool(), settings.at("pixel_std_px").number(),
                noise.at("added_std_px").number(),
                noise.find("added_std_px_q50") == null ? null : noise.numbersOf("added_std_px_q2_5",
                        "added_std_px_q50", "added_std_px_q97_5"),
                fit.boolOrNull("holds"), fit.at("chi_square").number(), fit.at("degrees_of_freedom").integer(),
                fit.at("p").number(), fit.at("shown_std_px").number(), markers,
                edges == null ? null : edges.numbersOf("shift_prior_std_px", "shift_by_inner_edges_px",
                        "shift_by_inner_edges_std_px", "shift_px", "shift_std_px"));
    }

    private static ReferencesView references(Node root, CellView cell) {
        Node together = root.at("noise").at("fit").at("references");
        List<ReferenceFitView> fits = new ArrayList<>();
        for (StatedReference reference : cell.references()) {
            fits.add(fit(reference.id(), root.at("references").at(String.valueOf(reference.id()))));
        }
        List<MisplacedView> misplaced = new ArrayList<>();
        for (Node reference : root.at("misplaced_references").elements()) {
            misplaced.add(new MisplacedView(reference.at("id").integer(), reference.at("offset").numbers(6),
                    reference.at("statistic").number(), reference.at("limit").number(),
                    reference.at("or_instead").integers()));
        }
        Node without = root.find("without_misplaced");
        return new ReferencesView(fits, together.at("chi_square").number(),
                together.at("degrees_of_freedom").integer(), together.at("p").number(), together.boolOrNull("holds"),
                misplaced, without == null ? null : without(without), misfit(root.find("misfit")),
                causes(root.find("causes")), root.at("references_noticeable").text());
    }

    private static ReferenceFitView fit(int id, Node fit) {
        if (!fit.at("used").bool()) {
            return ReferencesView.notUsed(id);
        }
        boolean tested = fit.find("statistic") != null;
        double[][] arrays = new double[5][];
        String[] keys = {"statistic", "limit", "offset", "offset_std", "detectable"};
        for (int i = 0; i < arrays.length; i++) {
            arrays[i] = tested ? fit.at(keys[i]).numbers(6) : ReferencesView.none();
        }
        return new ReferenceFitView(id, true, fit.at("misplaced").bool(), fit.at("chi_square").number(),
                fit.at("degrees_of_freedom").integer(), fit.at("p_value").number(),
                fit.at("normalised_residual").number(), tested, arrays[0], arrays[1], arrays[2], arrays[3],
                arrays[4]);
    }

    private static WithoutView without(Node without) {
        List<MovedObject> objects = new ArrayList<>();
        Node all = without.at("objects");
        for (String id : all.keys()) {
            Node object = all.at(id);
            Node grip = object.find("grip");
            objects.add(new MovedObject(all.id(id), pose(object.at("pose")), object.at("move_mm").numbers(3),
                    object.at("error_mm").numbers(3), grip == null ? null
                            : new MovedGrip(grip.at("mean").numbers(3), grip.at("covariance").matrix(3),
                                    grip.at("move_mm").numbers(3), grip.at("error_mm").numbers(3))));
        }
        return new WithoutView(without.at("left_out").integers(), pose(without.at("camera")),
                without.at("camera").at("move_mm").numbers(3), objects);
    }

    private static @Nullable Misfit misfit(@Nullable Node misfit) {
        if (misfit == null) {
            return null;
        }
        Node cause = misfit.find("cause");
        return Misfit.of(misfit.at("kind").misfitKind(), id(misfit.find("marker")), id(misfit.find("other_marker")),
                misfit.at("times").number(), misfit.at("stated_std_px").number(),
                misfit.at("shown_std_px").number(), cause == null ? null : cause.text());
    }

    private static OptionalInt id(@Nullable Node marker) {
        return marker == null ? OptionalInt.empty() : OptionalInt.of(marker.integer());
    }

    private static List<CauseView> causes(@Nullable Node causes) {
        List<CauseView> all = new ArrayList<>();
        if (causes == null) {
            return all;
        }
        for (Node cause : causes.elements()) {
            List<Integer> references = new ArrayList<>();
            cause.at("references").elements().forEach(id -> references.add(id.integer()));
            List<CauseView.Other> others = new ArrayList<>();
            cause.at("or_instead").elements().forEach(other -> others.add(new CauseView.Other(
                    other.at("cause").text(), other.at("phrase").text())));
            Node axis = cause.find("axis");
            all.add(new CauseView(cause.at("cause").text(), references,
                    axis == null ? -1 : "xyz".indexOf(axis.text()),
                    cause.at("size").numbers(cause.at("size").elements().size()), cause.at("std").number(),
                    cause.at("sentence").text(), others));
        }
        return all;
    }

    private static ChainsView chains(Node d, Node acceptance) {
        List<QuantityView> quantities = new ArrayList<>();
        Node parameters = d.at("parameters");
        for (String name : parameters.keys()) {
            Node parameter = parameters.at(name);
            quantities.add(new QuantityView(name, parameter.at("status").text(),
                    parameter.numbersOf(QuantityView.KEYS)));
        }
        List<AcceptanceCount> counts = new ArrayList<>();
        for (String proposal : acceptance.keys()) {
            Node count = acceptance.at(proposal);
            counts.add(new AcceptanceCount(proposal, count.at("accepted").whole(), count.at("rejected").whole()));
        }
        Node evaluations = d.at("camera_evaluations");
        return new ChainsView(d.at("converged").bool(), d.at("convergence").text(), d.numbersOf(ChainsView.KEYS),
                d.boolOrNull("precision_reached"),
                new long[] {evaluations.at("tuning").whole(), evaluations.at("chains").whole()},
                d.textOrNull("worst_parameter"), counts, () -> quantities);
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
        @Nullable Node find(String key) {
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

        /** A number of counted things, beyond what an integer holds. */
        long whole() {
            double number = number();
            if (number != Math.rint(number) || Math.abs(number) > 1L << 53) {
                throw expected(ResultRefusal.WHOLE_NUMBER);
            }
            return (long) number;
        }

        List<Integer> integers() {
            List<Integer> all = new ArrayList<>();
            elements().forEach(element -> all.add(element.integer()));
            return all;
        }

        /** Members that are numbers. */
        double[] numbersOf(String... keys) {
            double[] numbers = new double[keys.length];
            for (int i = 0; i < keys.length; i++) {
                numbers[i] = at(keys[i]).number();
            }
            return numbers;
        }

        @Nullable Boolean boolOrNull(String key) {
            Node member = find(key);
            return member == null ? null : Boolean.valueOf(member.bool());
        }

        @Nullable String textOrNull(String key) {
            Node member = find(key);
            return member == null ? null : member.text();
        }

        /** What is made of values that stand here. */
        <T> T possible(Supplier<T> made) {
            try {
                return made.get();
            } catch (IllegalArgumentException e) {
                throw refused(ResultRefusal.NOT_POSSIBLE, String.valueOf(e.getMessage()));
            }
        }

        ToneCurve toneCurve() {
            String words = text();
            return possible(() -> ToneCurve.of(words));
        }

        CheckSettings settings() {
            JsonObject object = object();
            return possible(() -> SettingsJson.read(object));
        }

        PinholeCamera camera() {
            String model = textOrNull("lens");
            Lens lens = model == null ? BrownLens.MODEL : Lenses.named(model);
            if (lens == null) {
                throw at("lens").refused(ResultRefusal.UNKNOWN_WORD, String.valueOf(model));
            }
            int width = at("width_px").integer();
            int height = at("height_px").integer();
            double[] values = numbersOf(lens.parameterNames().toArray(new String[0]));
            return possible(() -> PinholeCamera.of(lens, width, height, values));
        }

        Misfit.Kind misfitKind() {
            for (Misfit.Kind kind : Misfit.Kind.values()) {
                if (QuantityView.word(kind).equals(text())) {
                    return kind;
                }
            }
            throw refused(ResultRefusal.UNKNOWN_WORD, text());
        }

        String text() {
            if (!element.isJsonPrimitive() || !element.getAsJsonPrimitive().isString()) {
                throw expected(ResultRefusal.TEXT);
            }
            return element.getAsString();
        }

        boolean isList() {
            return element.isJsonArray();
        }

        Conformity.Of conformity() {
            for (Conformity.Of of : Conformity.Of.values()) {
                if (of.key().equals(text())) {
                    return of;
                }
            }
            throw refused(ResultRefusal.UNKNOWN_WORD, text());
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
