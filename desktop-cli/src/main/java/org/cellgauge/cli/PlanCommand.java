package org.cellgauge.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import org.cellgauge.cell.Area;
import org.cellgauge.cell.CameraRange;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ChangeKind;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Planning;
import org.cellgauge.cell.Wall;
import org.cellgauge.check.SampledForecast;
import org.cellgauge.desktop.PlanPage;
import org.cellgauge.desktop.PlanText;
import org.cellgauge.desktop.WholeFiles;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.cell.CellWriter;
import org.cellgauge.internal.output.PlanJson;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.output.ResultReader;
import org.cellgauge.output.ResultRow;
import org.cellgauge.output.ResultView;
import org.cellgauge.plan.CellPlanner;
import org.cellgauge.plan.DecisionTable;
import org.cellgauge.plan.Layout;
import org.cellgauge.plan.ObjectPlaces;
import org.cellgauge.plan.Plan;
import org.cellgauge.plan.PlanOptions;
import org.cellgauge.plan.Proposal;
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

    @Option(names = "--region", paramLabel = "ID=X0,Y0,X1,Y1",
            description = "Where an object may lie anywhere, seen from above, mm: the worst place counts. Repeat it "
                    + "for others.")
    private List<String> regions = new ArrayList<>();

    @Option(names = "--camera-range", paramLabel = "X,Y,Z,TURN",
            description = "How far the camera may be from its pose, either way along world axes in mm, and about its "
                    + "own in degrees: the worst pose counts.")
    private String cameraRange;

    @Option(names = "--free", paramLabel = "X0,Y0,X1,Y1", preprocessor = PoseArgument.MayBeNegative.class,
            description = "Where references may be put, seen from above, mm. Repeat it for more (as the cell file "
                    + "says, or anywhere in view).")
    private List<String> free = new ArrayList<>();

    @Option(names = "--wall", paramLabel = "X0,Y0,X1,Y1,HEIGHT", preprocessor = PoseArgument.MayBeNegative.class,
            description = "An upright wall, its ends seen from above, mm: references may hang on it, and what is "
                    + "behind it is hidden. Repeat it for more.")
    private List<String> walls = new ArrayList<>();

    @Option(names = "--max-height-mm", paramLabel = "MM",
            description = "How far off their plane references may be raised (that of the cell file, or 200).")
    private Double maxHeightMm;

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
                    + "larger-reference-markers, camera-closer, camera-aslant, longer-lens, more-pixels, add-plate, "
                    + "measure-distance, more-photos, calibrate. Repeat it for others (as the cell file says, or "
                    + "minutes of work).")
    private List<String> costs = new ArrayList<>();

    @Option(names = "--table", description = "Prints the decision table of this cell in place of a plan: what "
            + "precision, number and arrangement of references reach.")
    private boolean table;

    @Option(names = "--no-sampling", description = "Leaves out that what is proposed is confirmed by chains, which "
            + "takes a second or so for each proposal.")
    private boolean noSampling;

    @Option(names = "--out", paramLabel = "FILE.html", description = "Writes a page of pictures: the layout from above "
            + "and from the camera, as it is and with each proposal, and a map of deviations over the table.")
    private Path page;

    @Option(names = "--apply", paramLabel = "CELL", description = "Writes the cell file with the first proposal "
            + "applied that is one photo of independent references.")
    private Path applied;

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
            Layout layout = layout(cell, poses, like);
            PlanOptions options = options(cell, like);
            PrintWriter out = spec.commandLine().getOut();
            if (table) {
                out.print(PlanText.of(DecisionTable.of(layout, options)));
                out.flush();
                return ExitCodes.OK;
            }
            Plan plan = CellPlanner.plan(layout, options);
            List<SampledForecast> sampled = plan.met() || noSampling ? List.of()
                    : plan.best().stream().map(proposal -> sampled(proposal, options)).toList();
            String text = PlanText.of(plan, sampled);
            out.print(json ? PlanJson.of(plan, sampled) : text);
            out.flush();
            write(plan, options, text);
            return plan.met() ? ExitCodes.OK : ExitCodes.TARGET_MISSED;
        } catch (InputRefusedException e) {
            spec.commandLine().getErr().println(CommandWords.of(e));
            return ExitCodes.INPUT_REFUSED;
        } catch (IOException e) {
            spec.commandLine().getErr().println("cannot write " + e.getMessage() + "; name another file, or make its "
                    + "folder");
            return ExitCodes.INPUT_REFUSED;
        }
    }

    private static SampledForecast sampled(Proposal proposal, PlanOptions options) {
        return SampledForecast.of(proposal.layout(), options, options.settings());
    }

    private void write(Plan plan, PlanOptions options, String text) throws IOException {
        Map<Path, WholeFiles.Content> files = new LinkedHashMap<>();
        if (page != null) {
            byte[] html = PlanPage.of(plan, options, text, RepeatingCommand.plan(spec.commandLine().getParseResult()))
                    .getBytes(StandardCharsets.UTF_8);
            files.put(page, stream -> stream.write(html));
        }
        if (applied != null) {
            Proposal first = plan.best().stream().filter(p -> p.layout().isOnePhoto()).findFirst().orElse(null);
            if (first == null || plan.met()) {
                spec.commandLine().getErr().println(plan.met() ? "the target is met as it is: nothing to apply"
                        : "no proposal is one photo of independent references: nothing to apply");
            } else {
                files.put(applied, stream -> stream.write(withProposal(first).getBytes(StandardCharsets.UTF_8)));
            }
        }
        WholeFiles.writeContents(files);
    }

    private static String withProposal(Proposal proposal) {
        Cell cell = proposal.layout().cell();
        Planning stated = cell.planning();
        return CellWriter.text(cell.withPlanning(new Planning(proposal.layout().worldFromCameras().get(0),
                stated.cameraRange(), stated.regions(), stated.free(), stated.walls(), stated.maxHeightMm(),
                stated.costs())), List.of("With changes of cellgauge plan: " + proposal.sentence()));
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
        if (viewpoint.given() || camera == null && cell.planning().worldFromCamera() == null) {
            camera = viewpoint.pose(spec.commandLine(), cell, poses);
        } else if (camera == null) {
            camera = cell.planning().worldFromCamera();
        }
        Map<Integer, Area> areas = new LinkedHashMap<>(cell.planning().regions());
        regions.forEach(text -> addRegion(text, cell, areas));
        Map<Integer, List<RigidTransform>> places = new LinkedHashMap<>();
        for (ObjectMarker object : cell.objects()) {
            RigidTransform pose = poses.get(object.id());
            Area area = areas.get(object.id());
            places.put(object.id(), pose != null ? List.of(pose) : area != null ? ObjectPlaces.in(cell, area)
                    : ObjectPlaces.between(cell, camera, object));
        }
        CameraRange range = cameraRange == null ? cell.planning().cameraRange() : range();
        return new Layout(cell, range.poses(camera), places);
    }

    private void addRegion(String text, Cell cell, Map<Integer, Area> to) {
        int equals = text.indexOf('=');
        String id = text.substring(0, Math.max(0, equals)).trim();
        ObjectMarker object = cell.objects().stream().filter(o -> String.valueOf(o.id()).equals(id)).findFirst()
                .orElseThrow(() -> usage("--region: '" + text.trim() + "' is not ID=X0,Y0,X1,Y1 with the id of an "
                        + "object, as in 5=0,0,500,400"));
        to.put(object.id(), Area.ofCorners(numbers("--region", text.substring(equals + 1), 4,
                "X0,Y0,X1,Y1 in mm, as in 5=0,0,500,400")));
    }

    private PlanOptions options(Cell cell, ResultView like) {
        PlanOptions stated = PlanOptions.of(cell, CheckSettings.builder().build());
        boolean light = like != null && like.light() != null;
        ToneCurve curve = toneCurve != null ? PhotoOptions.toneCurve(toneCurve, null)
                : light ? like.light().toneCurve() : stated.toneCurve();
        Map<ChangeKind, Double> costOf = new EnumMap<>(ChangeKind.class);
        costOf.putAll(stated.costs());
        costs.forEach(text -> addCost(text, costOf));
        try {
            return new PlanOptions(stated.settings(), curve,
                    blurPx != null ? blurPx : light ? like.light().blurPx() : stated.blurPx(),
                    noiseGrey != null ? noiseGrey : light ? like.light().noiseGrey() : stated.noiseGrey(),
                    free.isEmpty() ? stated.freeAreas() : free.stream().map(text -> Area.ofCorners(numbers("--free",
                            text, 4, "X0,Y0,X1,Y1 in mm, as in 0,0,500,400"))).toList(),
                    walls.isEmpty() ? stated.walls() : walls.stream().map(this::wall).toList(),
                    maxHeightMm != null ? maxHeightMm : stated.maxHeightMm(), leastSidePx, costOf);
        } catch (IllegalArgumentException e) {
            throw usage("--blur-px, --noise, --max-height-mm, --least-side-px: " + e.getMessage());
        }
    }

    private Wall wall(String text) {
        double[] v = numbers("--wall", text, 5, "X0,Y0,X1,Y1,HEIGHT in mm, as in 0,400,500,400,300");
        try {
            return new Wall(v[0], v[1], v[2], v[3], v[4]);
        } catch (IllegalArgumentException e) {
            throw usage("--wall: " + e.getMessage());
        }
    }

    private CameraRange range() {
        double[] v = numbers("--camera-range", cameraRange, 4, "X,Y,Z,TURN in mm and degrees, as in 50,50,20,5");
        try {
            return new CameraRange(v[0], v[1], v[2], v[3]);
        } catch (IllegalArgumentException e) {
            throw usage("--camera-range: " + e.getMessage());
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

    private double[] numbers(String option, String text, int count, String form) {
        try {
            double[] v = Arrays.stream(text.split(",", -1)).mapToDouble(part -> Double.parseDouble(part.trim()))
                    .toArray();
            if (v.length == count && Arrays.stream(v).allMatch(Double::isFinite)) {
                return v;
            }
        } catch (NumberFormatException e) {
            // said below
        }
        throw usage(option + ": '" + text.trim() + "' is not " + form);
    }

    private ParameterException usage(String message) {
        return new ParameterException(spec.commandLine(), message);
    }
}
