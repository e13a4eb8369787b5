package org.cellgauge.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.desktop.PlanText;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.output.PlanJson;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.output.ResultReader;
import org.cellgauge.output.ResultRow;
import org.cellgauge.output.ResultView;
import org.cellgauge.plan.CellPlanner;
import org.cellgauge.plan.ChangeKind;
import org.cellgauge.plan.Layout;
import org.cellgauge.plan.ObjectPlaces;
import org.cellgauge.plan.Plan;
import org.cellgauge.plan.PlanOptions;
import org.cellgauge.settings.CheckSettings;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code cellgauge plan}: what a layout would reach, and which change of it reaches the target. */
@Command(name = "plan", mixinStandardHelpOptions = true, sortOptions = false, versionProvider = Main.Version.class,
        description = {"Predicts, without a photo, how precisely objects would be found, and which changes of the "
                + "set-up reach the target.", "", "Examples:",
            "  cellgauge plan --cell cell.yaml",
            "  cellgauge plan --cell cell.yaml --photo-like photo.result.json",
            "  cellgauge plan --cell cell.yaml --object 5=370,295,0 \\",
            "      --look-at 250,190,0 --distance 900 --target-std-mm 1",
            ""},
        footer = {"",
            "Objects of which no place is said may lie anywhere between the references: the worst place counts.",
            "Costs are minutes of work, or whatever unit --cost is given in.",
            "Exit codes: 0 target met or none set, 1 internal error, 2 usage, 3 input refused, 4 target missed."})
public final class PlanCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Option(names = "--cell", required = true, paramLabel = "CELL", description = "The cell file; - reads it from "
            + "standard input.")
    private Path cellFile;

    @Option(names = "--photo-like", paramLabel = "RESULT",
            description = "A result file of a check: camera and objects stand where they did, blur and noise are that "
                    + "photo's.")
    private Path photoLike;

    @Option(names = "--object", paramLabel = "ID=X,Y,Z[,PSI,THETA,PHI]",
            description = "Pose of an object in the world, mm and degrees. Repeat it for others.")
    private List<String> objects = new ArrayList<>();

    @Mixin
    private Viewpoint viewpoint = new Viewpoint();

    @Option(names = "--target-std-mm", paramLabel = "MM",
            description = "Largest standard deviation allowed, mm (that of the cell file).")
    private Double targetStdMm;

    @Option(names = "--free", paramLabel = "X0,Y0,X1,Y1", preprocessor = PoseArgument.MayBeNegative.class,
            description = "Where references may be put, seen from above, mm. Repeat it for more (anywhere in view).")
    private List<String> free = new ArrayList<>();

    @Option(names = "--max-height-mm", paramLabel = "MM", defaultValue = "200",
            description = "How far off their plane references may be raised (${DEFAULT-VALUE}).")
    private double maxHeightMm;

    @Option(names = "--least-side-px", paramLabel = "PX", defaultValue = "20",
            description = "Added and moved references are at least so large in the photo (${DEFAULT-VALUE}).")
    private double leastSidePx;

    @Option(names = "--blur-px", paramLabel = "PX", description = "Blur of the photo (0.7).")
    private Double blurPx;

    @Option(names = "--noise", paramLabel = "GREY", description = "Noise of the photo in grey levels of 255 (2).")
    private Double noiseGrey;

    @Option(names = "--tone-curve", paramLabel = "srgb|linear|\"gamma G\"",
            description = "Tone curve of the camera (that of the cell, or srgb).")
    private String toneCurve;

    @Option(names = "--cost", paramLabel = "CHANGE=COST",
            description = "What a change costs, for each marker that it touches: place-precisely, measure-reference, "
                    + "add-reference, raise-reference, tilt-reference, larger-object-markers, "
                    + "larger-reference-markers, camera-closer, camera-aslant, longer-lens, more-pixels, calibrate. "
                    + "Repeat it for others (minutes of work).")
    private List<String> costs = new ArrayList<>();

    @Option(names = "--json", description = "Writes the plan to standard output as JSON.")
    private boolean json;

    /**
     * Makes the plan.
     *
     * @return the exit code
     */
    @Override
    public Integer call() {
        viewpoint.requireOne(spec.commandLine());
        Map<Integer, RigidTransform> poses = ObjectPoses.parse(spec.commandLine(), objects);
        if (targetStdMm != null && !(targetStdMm > 0 && Double.isFinite(targetStdMm))) {
            throw usage("--target-std-mm: must be positive, not " + targetStdMm);
        }
        try {
            Cell cell = StandardInput.cell(cellFile);
            ObjectPoses.requireKnown(spec.commandLine(), cell, cellFile, poses);
            if (cell.objects().isEmpty()) {
                throw usage("--cell: " + cellFile + " has no objects, so there is nothing to plan for");
            }
            if (targetStdMm != null) {
                cell = cell.withTarget(OptionalDouble.of(targetStdMm));
            }
            ResultView like = photoLike == null ? null : ResultReader.read(photoLike);
            Plan plan = CellPlanner.plan(layout(cell, poses, like), options(cell, like));
            PrintWriter out = spec.commandLine().getOut();
            out.print(json ? PlanJson.of(plan) : PlanText.of(plan));
            out.flush();
            return plan.met() ? ExitCodes.OK : ExitCodes.TARGET_MISSED;
        } catch (InputRefusedException e) {
            spec.commandLine().getErr().println(CommandWords.of(e));
            return ExitCodes.INPUT_REFUSED;
        }
    }

    private Layout layout(Cell cell, Map<Integer, RigidTransform> stated, ResultView like) {
        Map<Integer, RigidTransform> poses = new LinkedHashMap<>(stated);
        RigidTransform camera = null;
        if (like != null) {
            camera = like.camera().pose() == null ? null : like.camera().pose().transform();
            for (ResultRow row : like.objects()) {
                if (row.pose() != null && row.id().isPresent()
                        && cell.objects().stream().anyMatch(o -> o.id() == row.id().getAsInt())) {
                    poses.putIfAbsent(row.id().getAsInt(), row.pose().transform());
                }
            }
            if (camera == null) {
                throw usage("--photo-like: " + photoLike + " has no pose of the camera");
            }
        }
        if (camera == null || viewpoint.given()) {
            camera = viewpoint.pose(spec.commandLine(), cell, poses);
        }
        Map<Integer, List<RigidTransform>> places = new LinkedHashMap<>();
        for (ObjectMarker object : cell.objects()) {
            RigidTransform pose = poses.get(object.id());
            places.put(object.id(), pose != null ? List.of(pose) : ObjectPlaces.between(cell, camera, object));
        }
        return new Layout(cell, List.of(camera), places);
    }

    private PlanOptions options(Cell cell, ResultView like) {
        PlanOptions usual = PlanOptions.USUAL;
        boolean light = like != null && like.light() != null;
        ToneCurve curve = toneCurve != null ? PhotoOptions.toneCurve(toneCurve, null)
                : light ? like.light().toneCurve() : cell.toneCurve() != null ? cell.toneCurve() : usual.toneCurve();
        Map<ChangeKind, Double> costOf = new EnumMap<>(ChangeKind.class);
        costs.forEach(text -> addCost(text, costOf));
        try {
            return new PlanOptions(CheckSettings.builder().build(), curve,
                    blurPx != null ? blurPx : light ? like.light().blurPx() : usual.blurPx(),
                    noiseGrey != null ? noiseGrey : light ? like.light().noiseGrey() : usual.noiseGrey(),
                    free.stream().map(this::area).toList(), maxHeightMm, leastSidePx, costOf);
        } catch (IllegalArgumentException e) {
            throw usage("--blur-px, --noise, --max-height-mm, --least-side-px: " + e.getMessage());
        }
    }

    private void addCost(String text, Map<ChangeKind, Double> to) {
        int equals = text.indexOf('=');
        String word = text.substring(0, Math.max(0, equals)).trim();
        for (ChangeKind kind : ChangeKind.values()) {
            if (kind.code().equals(word)) {
                try {
                    double cost = Double.parseDouble(text.substring(equals + 1).trim());
                    if (cost >= 0 && Double.isFinite(cost)) {
                        to.put(kind, cost);
                        return;
                    }
                } catch (NumberFormatException e) {
                    // said below
                }
            }
        }
        throw usage("--cost: '" + text + "' is no change with a cost of at least 0, as in raise-reference=20; changes "
                + "are " + String.join(", ", Arrays.stream(ChangeKind.values()).map(ChangeKind::code).toList()));
    }

    private PlanOptions.FreeArea area(String text) {
        String[] parts = text.split(",", -1);
        try {
            double[] v = Arrays.stream(parts).mapToDouble(part -> Double.parseDouble(part.trim())).toArray();
            if (v.length == 4 && Arrays.stream(v).allMatch(Double::isFinite)) {
                return new PlanOptions.FreeArea(
                        new PlanOptions.Point(Math.min(v[0], v[2]), Math.min(v[1], v[3])),
                        new PlanOptions.Point(Math.max(v[0], v[2]), Math.max(v[1], v[3])));
            }
        } catch (NumberFormatException e) {
            // said below
        }
        throw usage("--free: '" + text.trim() + "' is not X0,Y0,X1,Y1 in mm, as in 0,0,500,400");
    }

    private ParameterException usage(String message) {
        return new ParameterException(spec.commandLine(), message);
    }
}
