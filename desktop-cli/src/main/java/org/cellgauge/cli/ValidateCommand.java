package org.cellgauge.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.Callable;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.desktop.render.CellSimulation;
import org.cellgauge.desktop.render.RenderedPhotos;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.validation.CellSource;
import org.cellgauge.internal.validation.CellTruth;
import org.cellgauge.internal.validation.OneCell;
import org.cellgauge.internal.validation.RandomLayouts;
import org.cellgauge.internal.validation.TruthPrior;
import org.cellgauge.internal.validation.Validation;
import org.cellgauge.internal.validation.ValidationResult;
import org.cellgauge.internal.validation.ValidationSettings;
import org.cellgauge.internal.vision.BoofThreads;
import org.cellgauge.settings.CalibrationUse;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.SettingTable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParentCommand;
import picocli.CommandLine.Spec;

/** {@code cellgauge validate}: is a stated 95 % right 95 times in 100, for this cell? */
@Command(name = "validate", mixinStandardHelpOptions = true, sortOptions = false,
        versionProvider = Main.Version.class, modelTransformer = CheckOptions.OfValidate.class,
        description = {"Simulates cells that were built and photographed just as precisely as the cell file states, "
                + "checks each, and counts how often the stated regions hold the truth.", "", "Examples:",
            "  cellgauge validate --photos --cell cell.yaml",
            "  cellgauge validate --cell cell.yaml --pixel-std 0.1",
            "  cellgauge validate --cell cell.yaml --model corner-cube",
            "  cellgauge validate --photos --grid --cell cell.yaml \\",
            "      --simulations 400 --out grid.md",
            "  cellgauge validate --random-layouts --simulations 400",
            "  cellgauge validate --cell cell.yaml --outliers 0.05,20",
            "  cellgauge validate --random-layouts --cause all --simulations 300",
            "  cellgauge validate --calibration --simulations 400",
            ""},
        footer = {"",
            "Angles are in degrees, as in the cell file, unless they end in 'rad'.",
            "Each check runs until it has converged and the Monte Carlo error of every standard deviation is below",
            "10 %%, unless --iterations or --precision is given: these errors average out over the simulations.",
            "The tables go to standard output, progress and messages to standard error.",
            "",
            "Exit codes: 0 all 95 %% regions hold the truth as often as they claim, within chance, 1 internal error,",
            "2 usage, 3 input refused, 4 a 95 %% region holds it too rarely or too often, 5 more than 5 %% of the",
            "simulations gave no figure."})
public final class ValidateCommand implements Callable<Integer> {
    /** Share of simulations without a figure beyond which coverage of the others says little. */
    private static final double MOST_WITHOUT_FIGURE = 0.05;
    private static final int REPORTS = 10;
    /** Options besides settings on which figures depend. */
    private static final Set<String> DETERMINING = Set.of("--object", "--camera-pose", "--only", "--cause", "--alone",
            "--deviations", "--photos-per-cell", "--drift");
    private static final double MOST_DRIFT_MM = 1000;

    @Spec
    private CommandSpec spec;

    @ParentCommand
    private Main main;

    @Option(names = "--cell", paramLabel = "CELL",
            description = "The cell file. Needed, but for --random-layouts and --calibration.")
    private Path cellFile;

    @Option(names = "--object", paramLabel = "ID=X,Y,Z[,PSI,THETA,PHI]",
            description = "Nominal pose of an object of the cell in the world, mm and degrees; repeat it for others. "
                    + "Objects without one are spread between the references, turned like these.")
    private List<String> objects = new ArrayList<>();

    @Option(names = "--camera-pose", paramLabel = "X,Y,Z,PSI,THETA,PHI", converter = PoseArgument.Converter.class,
            preprocessor = PoseArgument.MayBeNegative.class,
            description = "Nominal pose of the camera in the world, mm and degrees. Without it the camera is where "
                    + "the cell file plans it, or looks straight at the plane z = 0, from where all markers fit.")
    private PoseArgument cameraPose;

    @Option(names = "--cause", paramLabel = "NAME|none|all",
            description = "Counts how often what is wrong with a cell is named, in cells stated or photographed wrong "
                    + "in that way, by --deviations where it has a size; none: in how many right ones anything is said."
                    + " No chains are run.")
    private String cause;

    @Option(names = "--deviations", paramLabel = "LEAST,MOST",
            description = "With --cause: how large a cause that has a size is, uniform between so many of its standard "
                    + "deviations, those with any one other cause allowed for. Default: 5,10")
    private String deviations;

    @Option(names = "--alone",
            description = "With --cause: deviations are those of a cause that is known to be the only one possible.")
    private boolean alone;

    @Option(names = "--calibration",
            description = "Simulates calibrations in place of cells: errors of every parameter and of the projection, "
                    + "over the deviations stated of them, for good and poor photos and for a bent board.")
    private boolean calibration;

    @Option(names = "--photos-per-cell", paramLabel = "K",
            description = "Surveys each cell from K photos all around it in place of checking one: regions of objects, "
                    + "gripping points, references, and objects of a later photo. By Laplace's approximation; by draws "
                    + "where --iterations says how many. With --photos from rendered ones.")
    private Integer photosPerCell;

    @Option(names = "--drift", paramLabel = "MM",
            description = "With --photos-per-cell: surveys each cell twice, a reference moved by MM in between (0: "
                    + "nothing moved), and counts what is called moved.")
    private Double drift;

    @Option(names = "--json", description = "Prints all counts and ranks as JSON in place of the tables.")
    private boolean json;

    @Mixin
    private StudyOptions options;

    private StudySettings study;
    private CheckSettings check;

    /**
     * Runs the validation.
     *
     * @return the exit code
     */
    @Override
    public Integer call() {
        check = CheckOptions.settings(spec.commandLine(), CheckOptions.OfValidate.USUAL);
        study = options.settings(spec.commandLine());
        boolean randomLayouts = study.get(StudyTable.RANDOM_LAYOUTS);
        if (calibration) {
            return calibrations();
        }
        if (cellFile == null && !randomLayouts) {
            throw new ParameterException(spec.commandLine(), "Missing required option: '--cell=CELL'");
        }
        Map<Integer, RigidTransform> given = ObjectPoses.parse(spec.commandLine(), objects);
        try {
            requireCornersForCauses();
            if (randomLayouts) {
                requireNoCell();
                if (cause != null) {
                    return causes(RandomLayouts.withDrawnNoise(MarkerFamily.SQUARE_BINARY));
                }
                return studyRun().randomLayouts(json, this::progress);
            }
            Cell cell = StandardInput.cell(cellFile);
            if (photosPerCell != null) {
                return surveys(cell);
            }
            ObjectPoses.requireKnown(spec.commandLine(), cell, cellFile, given);
            Map<Integer, RigidTransform> poses = CellTruth.objectPoses(cell, given);
            RigidTransform camera = cameraPose != null ? cameraPose.pose() : CellSimulation.overview(cell, poses);
            CellTruth nominal = new CellTruth(camera, poses);
            if (cause != null) {
                return causes(OneCell.of(prior(cell, nominal)));
            }
            if (study.photos()) {
                CoverageStudyRun run = studyRun();
                return study.get(StudyTable.GRID) ? run.grid(cell, nominal, this::prior, json)
                        : run.oneCell(cell, nominal, this::prior, json, this::progress);
            }
            TruthPrior prior = prior(cell, nominal);
            ValidationSettings settings = settings(cell);
            if (study.get(StudyTable.OUTLIERS).isPresent()) {
                return studyRun().drawnCorners(prior, settings.pixelStdPx(), json, this::progress);
            }
            ValidationResult result = Validation.run(prior, settings, this::progress);
            ValidationText text = new ValidationText(prior, settings, result);
            PrintWriter out = spec.commandLine().getOut();
            out.print(json ? text.json(study.plain(), repeating(), Main.version()) : text.text());
            out.flush();
            return exitCode(result);
        } catch (InputRefusedException e) {
            return main.report(e, ExitCodes.INPUT_REFUSED, spec.commandLine());
        } catch (IOException e) {
            return main.report(e, ExitCodes.INTERNAL_ERROR, spec.commandLine());
        }
    }

    private int calibrations() {
        if (cellFile != null || study.photos()) {
            throw new ParameterException(spec.commandLine(), "--calibration draws corners of a board: leave out "
                    + (cellFile != null ? "--cell" : "--photos"));
        }
        return CalibrationStudyRun.run(spec.commandLine(),
                study.get(StudyTable.PIXEL_STD_PX).orElse(Validation.CALIBRATION_STD_PX), study.simulations(),
                check.sampling().seed(), json, done -> { });
    }

    private int surveys(Cell cell) {
        if (photosPerCell < 1) {
            throw new ParameterException(spec.commandLine(), "--photos-per-cell: must be at least 1");
        }
        if (study.photos()) {
            if (drift != null) {
                throw new ParameterException(spec.commandLine(), "--drift draws corners: leave out --photos");
            }
            BoofThreads.useOne();
            Cell stated = study.stated(cell);
            PhotoOptions.requirePrintable(spec.commandLine(), stated, study.printGainMm());
            return SurveyStudyRun.run(spec.commandLine(), stated, check, photosPerCell, study.simulations(),
                    new RenderedPhotos(study.sensor(), study.jpegQuality(), study.printGainMm(),
                            study.outlinesDrawn()), json);
        }
        Cell noisy = cell.withPixelStdPx(OptionalDouble.of(settings(cell).pixelStdPx()));
        if (drift != null) {
            if (!(drift >= 0 && drift <= MOST_DRIFT_MM)) {
                throw new ParameterException(spec.commandLine(), "--drift: must be from 0 to 1000 mm");
            }
            return SurveyStudyRun.drift(spec.commandLine(), noisy, check, photosPerCell, study.simulations(), drift,
                    json);
        }
        return SurveyStudyRun.run(spec.commandLine(), noisy, check, photosPerCell, study.simulations(), null, json);
    }

    private int causes(CellSource cells) {
        return new CauseStudyRun(spec.commandLine(), cells, check, study.simulations()).run(cause, deviations(), alone,
                json, this::progress);
    }

    private NumberPair deviations() {
        NumberPair pair = deviations == null ? CauseStudyRun.DEVIATIONS : NumberPair.of(deviations).orElseThrow(
                () -> new ParameterException(spec.commandLine(), "--deviations: '" + deviations
                        + "' is not two numbers, such as 5,10"));
        if (!(pair.first() > 0 && pair.second() >= pair.first())) {
            throw new ParameterException(spec.commandLine(), "--deviations: must be positive, the larger one last");
        }
        return pair;
    }

    private void requireCornersForCauses() {
        String without = cause != null ? null : alone ? "--alone" : deviations != null ? "--deviations" : null;
        if (without != null) {
            throw new ParameterException(spec.commandLine(), without + " is about --cause: give that, too");
        }
        boolean noise = study.get(StudyTable.PIXEL_STD_PX).isPresent();
        boolean outliers = study.get(StudyTable.OUTLIERS).isPresent();
        if (cause != null && (study.photos() || noise || outliers)) {
            throw new ParameterException(spec.commandLine(), "--cause draws corners with the noise that cells state: "
                    + "leave out " + (study.photos() ? "--photos" : noise ? "--pixel-std" : "--outliers"));
        }
    }

    /** What makes the figures again. */
    private String repeating() {
        return RepeatingCommand.validate(cellFile, study, check, spec.commandLine().getParseResult(), DETERMINING);
    }

    private CoverageStudyRun studyRun() {
        return new CoverageStudyRun(spec.commandLine(), options, study, check, repeating());
    }

    private void requireNoCell() {
        String given = cellFile != null ? "--cell" : !objects.isEmpty() ? "--object"
                : cameraPose != null ? "--camera-pose" : null;
        if (given != null) {
            throw new ParameterException(spec.commandLine(), "--random-layouts makes its own cells"
                    + (study.photos() ? " and photos" : "") + ": leave out " + given);
        }
    }

    private static int exitCode(ValidationResult result) {
        return result.withoutFigure() > MOST_WITHOUT_FIGURE ? ExitCodes.NO_FIGURE
                : result.covers(ValidationText.JUDGED) ? ExitCodes.OK : ExitCodes.TARGET_MISSED;
    }

    private TruthPrior prior(Cell cell, CellTruth nominal) {
        NumberPair spread = study.get(StudyTable.SPREAD);
        try {
            return new TruthPrior(cell, nominal, spread.first(), Math.toRadians(spread.second()),
                    study.get(StudyTable.CALIBRATION_PHOTOS).isPresent() ? IntrinsicsPrior.KNOWN
                    // true cameras differ from the calibrated one as it says, whatever the check makes of that
                    : IntrinsicsPrior.stated(cell, check.toBuilder()
                            .set(SettingTable.CALIBRATION, CalibrationUse.UNCERTAIN).build().model()));
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), "--spread: " + e.getMessage());
        }
    }

    private ValidationSettings settings(Cell cell) {
        OptionalDouble asked = study.get(StudyTable.PIXEL_STD_PX);
        if (asked.isEmpty() && cell.pixelStdPx().isEmpty()) {
            throw new InputRefusedException(cellFile.toString(), CommandRefusal.NO_CORNER_NOISE);
        }
        double pixels = asked.isPresent() ? asked.getAsDouble() : cell.pixelStdPx().getAsDouble();
        return new ValidationSettings(study.simulations(), check, pixels, check.sampling().threads())
                .calibrating(study.get(StudyTable.CALIBRATION_PHOTOS).orElse(0));
    }

    private void progress(int done) {
        int simulations = study.simulations();
        int every = Math.max(1, simulations / REPORTS);
        if (done % every == 0 || done == simulations) {
            PrintWriter err = spec.commandLine().getErr();
            err.println("[" + done + "/" + simulations + "] cells simulated and checked");
            err.flush();
        }
    }
}
