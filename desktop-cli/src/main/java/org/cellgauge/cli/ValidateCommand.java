package org.cellgauge.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Callable;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.desktop.render.CellSimulation;
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
import org.cellgauge.settings.CheckSettings;
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
        description = "Simulates cells that were built and photographed just as precisely as the cell file states, "
                + "checks each, and counts how often the stated regions hold the truth.",
        footer = {"", "Examples:",
            "  cellgauge validate --cell cell.yaml",
            "  cellgauge validate --cell cell.yaml --object 5=370,295,0,0,0,20 \\",
            "      --camera-pose 418,106,1070,3.08rad,0.10rad,0.02rad --spread 0,0 --simulations 1000",
            "  cellgauge validate --cell cell.yaml --model corner-cube --json",
            "  cellgauge validate --cell cell.yaml --photos --tone-curve srgb --blur-px 1.2 --marker-px 32",
            "  cellgauge validate --cell cell.yaml --photos --grid --simulations 400 --out grid.md",
            "  cellgauge validate --random-layouts --simulations 400",
            "  cellgauge validate --random-layouts --cause all --simulations 300",
            "",
            "Angles are in degrees, as in the cell file, unless they end in 'rad'.",
            "Each check runs until it has converged and the Monte Carlo error of every standard deviation is below",
            "10 %%, unless --iterations or --precision is given: these errors average out over the simulations.",
            "The tables go to standard output, progress and messages to standard error.",
            "",
            "Exit codes: 0 all 95 %% regions hold the truth as often as they claim, within chance, 1 internal error,",
            "2 usage, 3 input refused, 4 a 95 %% region holds it too rarely or too often, 5 more than 5 %% of the",
            "simulations gave no figure. With --cause: 0 it is named first in 90 %% of the cells and nothing is said",
            "of 99 %% of right ones, 4 it is not."})
public final class ValidateCommand implements Callable<Integer> {
    /** Share of simulations without a figure beyond which coverage of the others says little. */
    private static final double MOST_WITHOUT_FIGURE = 0.05;
    private static final int REPORTS = 10;
    /** Options on which no figure depends. */
    private static final Set<String> WITHOUT_EFFECT = Set.of("--json", "--out", "--threads", "--debug");

    @Spec
    private CommandSpec spec;

    @ParentCommand
    private Main main;

    @Option(names = "--cell", paramLabel = "CELL",
            description = "The cell file. Needed, but for --random-layouts.")
    private Path cellFile;

    @Option(names = "--simulations", paramLabel = "N", defaultValue = "200",
            description = "Number of simulated cells (${DEFAULT-VALUE}).")
    private int simulations;

    @Option(names = "--object", paramLabel = "ID=X,Y,Z[,PSI,THETA,PHI]",
            description = "Nominal pose of an object of the cell in the world, mm and degrees; repeat it for others. "
                    + "Objects without one are spread between the references, turned like these.")
    private List<String> objects = new ArrayList<>();

    @Option(names = "--camera-pose", paramLabel = "X,Y,Z,PSI,THETA,PHI", converter = PoseArgument.Converter.class,
            preprocessor = PoseArgument.MayBeNegative.class,
            description = "Nominal pose of the camera in the world, mm and degrees. Without it the camera looks "
                    + "straight at the plane z = 0, from where all markers fit.")
    private PoseArgument cameraPose;

    @Option(names = "--spread", paramLabel = "MM,DEG", defaultValue = "50,10",
            preprocessor = PoseArgument.MayBeNegative.class,
            description = "Standard deviation of the true poses about the nominal ones, from simulation to simulation: "
                    + "the camera swings about the references, objects move before the camera (${DEFAULT-VALUE}). "
                    + "0,0: the truth is the same in all. At most the distance from camera to references, and below "
                    + "57 degrees.")
    private String spread;

    @Option(names = "--pixel-std", paramLabel = "PX",
            description = "Corner noise that is simulated, where it is to differ from the pixel_std_px of the cell "
                    + "file, or that is 'auto'.")
    private Double pixelStdPx;

    @Option(names = "--cause", paramLabel = "NAME|none|all",
            description = "Counts how often what is wrong with a cell is named, in cells stated or photographed wrong "
                    + "in that way, by 5 to 10 standard deviations where it has a size (those with any one other cause "
                    + "allowed for); none: in how many right ones anything is said. No chains are run.")
    private String cause;

    @Option(names = "--alone",
            description = "With --cause: deviations are those of a cause that is known to be the only one possible.")
    private boolean alone;

    @Option(names = "--json", description = "Prints all counts and ranks as JSON in place of the tables.")
    private boolean json;

    @Mixin
    private StudyOptions study;

    /**
     * Runs the validation.
     *
     * @return the exit code
     */
    @Override
    public Integer call() {
        CheckSettings check = CheckOptions.settings(spec.commandLine(), CheckOptions.OfValidate.USUAL);
        study.check(spec.commandLine());
        if (cellFile == null && !study.randomLayouts()) {
            throw new ParameterException(spec.commandLine(), "Missing required option: '--cell=CELL'");
        }
        ParsedSpread spreads = parseSpread();
        Map<Integer, RigidTransform> given = ObjectPoses.parse(spec.commandLine(), objects);
        try {
            requireCornersForCauses();
            if (study.randomLayouts()) {
                requireNoCell();
                if (cause != null) {
                    return causes(RandomLayouts.withDrawnNoise(MarkerFamily.SQUARE_BINARY), check);
                }
                return study(check).randomLayouts(json, pixelStdPx, this::progress);
            }
            Cell cell = CellReader.read(cellFile);
            ObjectPoses.requireKnown(spec.commandLine(), cell, cellFile, given);
            Map<Integer, RigidTransform> poses = CellTruth.objectPoses(cell, given);
            RigidTransform camera = cameraPose != null ? cameraPose.pose() : CellSimulation.overview(cell, poses);
            CellTruth nominal = new CellTruth(camera, poses);
            if (cause != null) {
                return causes(OneCell.of(prior(cell, nominal, spreads, check)), check);
            }
            if (study.photos()) {
                if (pixelStdPx != null) {
                    throw new ParameterException(spec.commandLine(), "--pixel-std is the noise of drawn corners; with "
                            + "--photos it is the detector's: leave it out, or say what the check is told with "
                            + "--state-pixel-std");
                }
                CoverageStudyRun run = study(check);
                return study.grid() ? run.grid(cell, nominal, (c, n) -> prior(c, n, spreads, check), json)
                        : run.oneCell(cell, nominal, (c, n) -> prior(c, n, spreads, check), json, this::progress);
            }
            TruthPrior prior = prior(cell, nominal, spreads, check);
            ValidationSettings settings = settings(cell, check);
            ValidationResult result = Validation.run(prior, settings, this::progress);
            ValidationText text = new ValidationText(prior, settings, result);
            PrintWriter out = spec.commandLine().getOut();
            out.print(json ? text.json(repeating(), Main.version()) : text.text());
            out.flush();
            return exitCode(result);
        } catch (InputRefusedException e) {
            return main.report(e, ExitCodes.INPUT_REFUSED, spec.commandLine());
        } catch (IOException e) {
            return main.report(e, ExitCodes.INTERNAL_ERROR, spec.commandLine());
        }
    }

    private int causes(CellSource cells, CheckSettings check) {
        return new CauseStudyRun(spec.commandLine(), cells, check, simulations).run(cause, alone, json, this::progress);
    }

    private void requireCornersForCauses() {
        if (cause == null && alone) {
            throw new ParameterException(spec.commandLine(), "--alone is about --cause: give that, too");
        }
        if (cause != null && (study.photos() || pixelStdPx != null)) {
            throw new ParameterException(spec.commandLine(), "--cause draws corners with the noise that cells state: "
                    + "leave out " + (study.photos() ? "--photos" : "--pixel-std"));
        }
    }

    /** What makes the figures again. */
    private String repeating() {
        return RepeatingCommand.asGiven(spec.name(), spec.commandLine().getParseResult(), WITHOUT_EFFECT);
    }

    private CoverageStudyRun study(CheckSettings check) {
        return new CoverageStudyRun(spec.commandLine(), study, check, simulations, repeating());
    }

    private void requireNoCell() {
        String given = cellFile != null ? "--cell" : !objects.isEmpty() ? "--object"
                : cameraPose != null ? "--camera-pose" : study.photos() && pixelStdPx != null ? "--pixel-std" : null;
        if (given != null) {
            throw new ParameterException(spec.commandLine(), "--random-layouts makes its own cells"
                    + (study.photos() ? " and photos" : "") + ": leave out " + given);
        }
    }

    private static int exitCode(ValidationResult result) {
        return result.withoutFigure() > MOST_WITHOUT_FIGURE ? ExitCodes.NO_FIGURE
                : result.covers(ValidationText.JUDGED) ? ExitCodes.OK : ExitCodes.TARGET_MISSED;
    }

    private TruthPrior prior(Cell cell, CellTruth nominal, ParsedSpread spreads, CheckSettings check) {
        try {
            return new TruthPrior(cell, nominal, spreads.mm(), spreads.rad(),
                    IntrinsicsPrior.stated(cell.camera(), check.model()));
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), "--spread: " + e.getMessage());
        }
    }

    private ValidationSettings settings(Cell cell, CheckSettings check) {
        if (pixelStdPx == null && cell.pixelStdPx().isEmpty()) {
            throw new InputRefusedException(cellFile.toString(), CommandRefusal.NO_CORNER_NOISE);
        }
        double pixels = pixelStdPx != null ? pixelStdPx : cell.pixelStdPx().getAsDouble();
        try {
            return new ValidationSettings(simulations, check, pixels, check.sampling().threads());
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), e.getMessage());
        }
    }

    private record ParsedSpread(double mm, double rad) {
    }

    private ParsedSpread parseSpread() {
        String[] parts = spread.split(",", -1);
        try {
            double mm = Double.parseDouble(parts[0].trim());
            double degrees = Double.parseDouble(parts[parts.length - 1].trim());
            if (parts.length == 2) {
                return new ParsedSpread(mm, Math.toRadians(degrees));
            }
        } catch (NumberFormatException e) {
            // said below
        }
        throw new ParameterException(spec.commandLine(), "--spread: '" + spread + "' is not MM,DEG, as in 50,10");
    }

    private void progress(int done) {
        int every = Math.max(1, simulations / REPORTS);
        if (done % every == 0 || done == simulations) {
            PrintWriter err = spec.commandLine().getErr();
            err.println("[" + done + "/" + simulations + "] cells simulated and checked");
            err.flush();
        }
    }
}
