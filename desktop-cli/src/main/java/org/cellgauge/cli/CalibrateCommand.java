package org.cellgauge.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import org.cellgauge.calibration.Calibration;
import org.cellgauge.calibration.CalibrationOptions;
import org.cellgauge.calibration.CalibrationResult;
import org.cellgauge.cell.CalibrationTargetReader;
import org.cellgauge.cell.CameraFormat;
import org.cellgauge.cell.CameraReader;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.desktop.CalibrationJson;
import org.cellgauge.desktop.CalibrationReport;
import org.cellgauge.desktop.CalibrationRun;
import org.cellgauge.desktop.CalibrationText;
import org.cellgauge.desktop.CheckInput;
import org.cellgauge.desktop.CheckText;
import org.cellgauge.desktop.WholeFiles;
import org.cellgauge.internal.warning.Printable;
import org.cellgauge.vision.TargetObservation;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import picocli.CommandLine.Spec;

/** {@code cellgauge calibrate}: from photos of a target to a camera file that says how well it is known. */
@Command(name = "calibrate", mixinStandardHelpOptions = true, sortOptions = false, versionProvider = Main.Version.class,
        description = {"Calibrates a camera from photos of a target: its intrinsics with their joint covariance.", "",
            "Examples:",
            "  cellgauge calibrate --target target.yaml photos/ --out camera.yaml",
            "  cellgauge calibrate --target target.yaml --lens brown-5 --warp 0 \\",
            "      photos/ --out camera.yaml",
            "  cellgauge calibrate --target target.yaml --json photos/",
            ""},
        footer = {"",
            "A target file holds cellgauge_target: 1 and one of",
            "  chessboard: {rows: 7, columns: 5, square_mm: 30}",
            "  ecocheck: {rows: 10, columns: 7, square_mm: 30}",
            "  circle_grid, hexagonal_circle_grid: {rows: 8, columns: 10, diameter_mm: 20, spacing_mm: 40}",
            "  charuco: {rows: 8, columns: 11, square_mm: 24, marker_mm: 18, family: aruco-mip-36h12}",
            "  marker_plate: {family: apriltag-36h11, size_mm: 40, positions_mm: {0: [0, 0], 1: [60, 0]}}",
            "  cell: {file: cell.yaml}",
            "Rows and columns count squares, not corners. BoofCV's target files are read too.",
            "Beside FILE a page of the same name, ended by .html, has the pictures. The tables go to standard output,",
            "progress and messages to standard error.",
            "",
            "Exit codes: 0 calibrated, 1 internal error, 2 usage, 3 input refused or not writable, 5 in question: too",
            "many corners had to be left out."})
public final class CalibrateCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @ParentCommand
    private Main main;

    @Option(names = "--target", required = true, paramLabel = "TARGET",
            description = "The target file: what was photographed.")
    private Path target;

    @Parameters(paramLabel = "IMAGE", arity = "1..*",
            description = "Photos of the target, or folders of them; all of one size, focus and zoom unchanged.")
    private List<Path> images = new ArrayList<>();

    @Option(names = "--out", paramLabel = "FILE",
            description = "The camera file to write (camera.yaml; with --json: no files).")
    private Path out;

    @Option(names = "--to", paramLabel = CameraForm.WORDS, defaultValue = "boofcv",
            description = "The form of the camera file: whose program is to read it besides this one "
                    + "(${DEFAULT-VALUE}).")
    private String to;

    @Option(names = "--json", description = "Prints one line of JSON in place of the tables.")
    private boolean json;

    @Option(names = "--lens", paramLabel = "MODEL", defaultValue = CalibrationOptions.AUTO,
            description = "auto, radial-1, radial-2, brown-4 (with p1, p2), brown-5 (with k3), rational-8 (with k4 to "
                    + "k6), prism-12 (with s1 to s4) or fisheye (${DEFAULT-VALUE}: radial-2, or one up to rational-8 "
                    + "where it explains photos better that were held out).")
    private String lens;

    @Option(names = "--warp", paramLabel = "N", defaultValue = "auto",
            description = "Coefficients of the board's own warp, 0 to 5 (${DEFAULT-VALUE}: 2 where photos that were "
                    + "held out are better explained so).")
    private String warp;

    @Option(names = "--aspect", paramLabel = "WORD", defaultValue = "auto",
            description = "Whether the board's rows may be farther apart than stated: stated, unknown or auto "
                    + "(${DEFAULT-VALUE}: unknown where the target was turned between photos).")
    private String aspect;

    @Option(names = "--distance", paramLabel = "MM", defaultValue = "0",
            description = "Distance at which the uncertainty of the projection is stated in mm (that of the photos).")
    private double distanceMm;

    @Option(names = "--focus-distance-m", paramLabel = "M",
            description = "Distance that the lens was focused at in the photos, m, where it was set by hand. The "
                    + "camera file states it, and the tablet app focuses its own lens there.")
    private Double focusDistanceM;

    @Option(names = "--threads", paramLabel = "N",
            description = "Photos looked at at once (as many as the machine has processors).")
    private Integer threads;

    /**
     * Calibrates.
     *
     * @return the exit code
     */
    @Override
    public Integer call() {
        CalibrationOptions options = options();
        int atOnce = threads == null ? Runtime.getRuntime().availableProcessors() : threads;
        if (atOnce < 1) {
            throw new ParameterException(spec.commandLine(), "--threads: must be at least 1");
        }
        try {
            return run(options, atOnce, CameraForm.of(spec.commandLine(), to));
        } catch (InputRefusedException e) {
            return main.report(e, ExitCodes.INPUT_REFUSED, spec.commandLine());
        }
    }

    private CalibrationOptions options() {
        if (!lens.equals(CalibrationOptions.AUTO) && !Calibration.lenses().contains(lens)) {
            throw new ParameterException(spec.commandLine(), "--lens: '" + lens + "' is none of auto, "
                    + String.join(", ", Calibration.lenses()));
        }
        int coefficients = CalibrationOptions.BY_PHOTOS;
        if (!warp.equals("auto")) {
            coefficients = warp.matches("\\d") ? Integer.parseInt(warp) : -1;
            if (coefficients < 0 || coefficients > CalibrationOptions.MOST_WARP) {
                throw new ParameterException(spec.commandLine(), "--warp: must be auto or from 0 to 5, not " + warp);
            }
        }
        CalibrationOptions.Aspect choice = Map.of("auto", CalibrationOptions.Aspect.BY_PHOTOS, "stated",
                CalibrationOptions.Aspect.STATED, "unknown", CalibrationOptions.Aspect.UNKNOWN).get(aspect);
        if (choice == null) {
            throw new ParameterException(spec.commandLine(), "--aspect: must be auto, stated or unknown, not "
                    + aspect);
        }
        if (!(distanceMm >= 0 && distanceMm < 1e7)) {
            throw new ParameterException(spec.commandLine(), "--distance: must be a distance in mm");
        }
        if (focusDistanceM != null && !CameraReader.isFocusDistance(focusDistanceM)) {
            throw new ParameterException(spec.commandLine(), "--focus-distance-m: must be from "
                    + CameraReader.plain(CameraReader.LEAST_FOCUS_DISTANCE_M) + " to "
                    + CameraReader.plain(CameraReader.LARGEST_FOCUS_DISTANCE_M) + " m, not "
                    + CameraReader.plain(focusDistanceM));
        }
        return new CalibrationOptions(lens, coefficients, choice, distanceMm);
    }

    private int run(CalibrationOptions options, int atOnce, CameraFormat format) {
        PrintWriter err = spec.commandLine().getErr();
        CheckInput.Inputs inputs = CheckInput.resolve(images, List.of());
        for (CheckInput input : inputs.inputs()) {
            if (input.refusal() != null) {
                throw new InputRefusedException(Refusal.at(Place.of(input.file().toString()), input.refusal()));
            }
        }
        inputs.remarks().forEach(remark -> err.println(Printable.of(remark)));
        CalibrationResult result = new CalibrationRun(CalibrationTargetReader.read(target), options, atOnce,
                this::progress).of(inputs.inputs().stream().map(CheckInput::file).toList());
        String command = RepeatingCommand.calibrate(spec.commandLine().getParseResult());
        PrintWriter stdout = spec.commandLine().getOut();
        if (json) {
            stdout.print(CalibrationJson.line(result, Main.version(), command));
        } else {
            stdout.print(CalibrationText.of(result));
        }
        stdout.flush();
        result.warnings().forEach(w -> err.print(CheckText.wrap("Warning: " + CommandWords.of(w), "  ")));
        if (result.nextPhoto() != null) {
            err.print(CheckText.wrap("What would help most: " + CommandWords.of(result.nextPhoto()), "  "));
        }
        if (!json || out != null) {
            write(result, format, command);
        }
        err.flush();
        return result.inQuestion() ? ExitCodes.NO_FIGURE : ExitCodes.OK;
    }

    private void progress(int number, int count, TargetObservation seen) {
        PrintWriter err = spec.commandLine().getErr();
        err.printf(Locale.ROOT, "[%d/%d] %s: %s%n", number, count, Printable.of(seen.name()),
                seen.count() == 0 ? "target not found" : seen.count() + " corners");
        err.flush();
    }

    private void write(CalibrationResult result, CameraFormat format, String command) {
        Path file = out == null ? Path.of("camera.yaml") : out;
        Path page = file.resolveSibling(CheckInput.baseName(file) + ".html");
        Map<Path, WholeFiles.Content> contents = new LinkedHashMap<>();
        contents.put(file, text(CalibrationJson.cameraFile(result, format,
                focusDistanceM == null ? OptionalDouble.empty() : OptionalDouble.of(focusDistanceM))));
        contents.put(page, text(CalibrationReport.of(result, Main.version(), command)));
        try {
            Files.createDirectories(file.toAbsolutePath().getParent());
            WholeFiles.writeContents(contents);
        } catch (IOException e) {
            throw new InputRefusedException(Refusal.at(Place.of(file.toString()), CommandRefusal.CAMERA_NOT_WRITTEN,
                    String.valueOf(e.getMessage())), e);
        }
        spec.commandLine().getErr().println("Camera file " + file + ", pictures in " + page);
    }

    private static WholeFiles.Content text(String text) {
        return to -> to.write(text.getBytes(StandardCharsets.UTF_8));
    }
}
