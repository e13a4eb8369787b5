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
import java.util.concurrent.Callable;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.Requirement;
import org.cellgauge.check.Conformity;
import org.cellgauge.desktop.CellFile;
import org.cellgauge.desktop.CheckInput;
import org.cellgauge.desktop.CheckText;
import org.cellgauge.desktop.EpochJson;
import org.cellgauge.desktop.PhotoReading;
import org.cellgauge.desktop.SurveyJson;
import org.cellgauge.desktop.SurveyReport;
import org.cellgauge.desktop.SurveyText;
import org.cellgauge.desktop.WholeFiles;
import org.cellgauge.internal.cell.CellWriter;
import org.cellgauge.internal.warning.Printable;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.statistics.Convergence;
import org.cellgauge.survey.Drift;
import org.cellgauge.survey.Epoch;
import org.cellgauge.survey.Survey;
import org.cellgauge.survey.SurveyResult;
import org.cellgauge.survey.SurveyedObject;
import org.cellgauge.vision.Detections;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;
import org.cellgauge.warning.Warning;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import picocli.CommandLine.Spec;

/** {@code cellgauge survey}: many photos of one cell: where references and objects really stand. */
@Command(name = "survey", mixinStandardHelpOptions = true, sortOptions = false, versionProvider = Main.Version.class,
        modelTransformer = CheckOptions.OfSurvey.class,
        description = {"Many photos of one cell: where its references and objects really stand, and how well that is "
                + "known.", "",
            "Examples:",
            "  cellgauge survey --cell cell.yaml photos/",
            "  cellgauge survey --cell cell.yaml photos/ --out surveyed.cell.yaml",
            "  cellgauge survey --cell cell.yaml --json --detections corners/*.json",
            "  cellgauge survey --cell cell.yaml --against surveyed.survey.json later/",
            ""},
        footer = {"",
            "FILE is a cell file with references where they were found and their joint covariance; beside it, under",
            "the same name, .html has tables and curves, and .survey.json all figures. Tables go to standard output,",
            "messages to standard error.",
            "",
            "Exit codes: 0 target met (or none set), 1 internal error, 2 usage, 3 input refused, 4 target missed or",
            "something has moved, 5 not converged or pose ambiguous: no figure to trust."})
public final class SurveyCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @ParentCommand
    private Main main;

    @Option(names = "--cell", required = true, paramLabel = "CELL", description = "The cell file.")
    private Path cellFile;

    @Parameters(paramLabel = "IMAGE", arity = "0..*", description = "Photos of the cell, or folders of them.")
    private List<Path> images = new ArrayList<>();

    @Option(names = "--detections", paramLabel = "FILE", arity = "1..*",
            description = "Files of corners from any detector, in place of photos; name photos before this option.")
    private List<Path> detectionsFiles = new ArrayList<>();

    @Option(names = "--out", paramLabel = "FILE",
            description = "The surveyed cell file to write (without it: no files).")
    private Path out;

    @Option(names = "--json", description = "Prints one line of JSON in place of the tables.")
    private boolean json;

    @Option(names = "--leave-out-misfits",
            description = "Leaves out photos that do not fit the others, as where something was moved.")
    private boolean leaveOut;

    @Option(names = "--against", paramLabel = "SURVEY",
            description = "An earlier survey of the cell (NAME.survey.json, or its JSON): what has moved since, by all "
                    + "photos together and by each of them.")
    private Path against;

    @Option(names = "--camera-stands",
            description = "With --against: all photos, those of the earlier survey too, are of a camera that should "
                    + "not have moved; tells whether it has.")
    private boolean cameraStands;

    /**
     * Surveys.
     *
     * @return the exit code
     */
    @Override
    public Integer call() {
        CheckSettings settings = CheckOptions.settings(spec.commandLine(), CheckOptions.CHECK_USUAL);
        if (images.isEmpty() && detectionsFiles.isEmpty()) {
            throw new ParameterException(spec.commandLine(),
                    "nothing to survey; name photos, a folder of them, or --detections FILE");
        }
        if (cameraStands && against == null) {
            throw new ParameterException(spec.commandLine(),
                    "--camera-stands: says something of --against only; name the earlier survey");
        }
        try {
            return run(settings);
        } catch (InputRefusedException e) {
            return main.report(e, ExitCodes.INPUT_REFUSED, spec.commandLine());
        }
    }

    private int run(CheckSettings settings) {
        PrintWriter err = spec.commandLine().getErr();
        Epoch earlier = against == null ? null : EpochJson.read(against);
        Cell stated = CellFile.read(cellFile).cell();
        Cell cell = settings.model().targetStdMm().isPresent() ? stated.withTarget(settings.model().targetStdMm())
                : stated;
        CheckInput.Inputs inputs = CheckInput.resolve(images, detectionsFiles);
        inputs.remarks().forEach(remark -> err.println(Printable.of(remark)));
        List<Detections> seen = new ArrayList<>();
        int code = ExitCodes.OK;
        for (PhotoReading.Photo photo : PhotoReading.of(cell, inputs.inputs(), settings.sampling().threads(),
                this::progress)) {
            if (photo.detections() != null) {
                seen.add(photo.detections());
            } else {
                code = main.report(new InputRefusedException(photo.refusal()), ExitCodes.INPUT_REFUSED,
                        spec.commandLine());
            }
        }
        if (seen.isEmpty() && code != ExitCodes.OK) {
            return code;
        }
        Survey all = Survey.of(cell, seen, settings);
        Survey survey = leaveOut ? all.withoutMisfits() : all;
        SurveyResult result = survey.sampled();
        Drift drift = earlier == null ? null : survey.against(earlier, cameraStands);
        int judged = code(result, drift);
        String command = RepeatingCommand.survey(spec.commandLine().getParseResult());
        print(result, drift, judged, command);
        if (out != null) {
            write(result, drift, judged, command);
        }
        err.flush();
        return ExitCodes.moreSerious(code, judged);
    }

    private void progress(int number, int count, PhotoReading.Photo photo) {
        PrintWriter err = spec.commandLine().getErr();
        err.printf(Locale.ROOT, "[%d/%d] %s: %s%n", number, count, Printable.of(photo.input().name()),
                photo.detections() == null ? "refused" : photo.detections().markers().size() + " markers");
        err.flush();
    }

    private static int code(SurveyResult result, @Nullable Drift drift) {
        if (result.run() == null || result.run().convergence() != Convergence.CONVERGED
                || result.objects().stream().anyMatch(SurveyedObject::ambiguous) || isUndecided(result)) {
            return ExitCodes.NO_FIGURE;
        }
        return (drift == null || !drift.any()) && result.objects().stream()
                .allMatch(o -> meets(o, result.cell().target().of(o.marker().id()).stdMm()))
                ? ExitCodes.OK : ExitCodes.TARGET_MISSED;
    }

    /** Whether more draws could turn a verdict that nothing else decides. */
    private static boolean isUndecided(SurveyResult result) {
        return result.objects().stream().flatMap(o -> o.conformities().stream()).anyMatch(c -> !c.isDecided())
                && result.objects().stream().flatMap(o -> o.conformities().stream())
                        .noneMatch(c -> c.isDecided() && !c.isKept());
    }

    private static boolean meets(SurveyedObject o, Requirement.Axes limits) {
        boolean meets = o.conformities().stream().allMatch(Conformity::isKept);
        for (int axis = 0; axis < 3; axis++) {
            meets &= o.pose().std()[axis] <= limits.of(axis);
            meets &= o.grip() == null || o.grip().stdMm()[axis] <= limits.of(axis);
        }
        return meets;
    }

    private static boolean hasTarget(SurveyResult result) {
        return result.objects().stream().anyMatch(o -> result.cell().target().of(o.marker().id()).isAny());
    }

    private static String verdict(SurveyResult result, @Nullable Drift drift, int code) {
        if (code == ExitCodes.NO_FIGURE) {
            return result.objects().stream().anyMatch(SurveyedObject::ambiguous) ? "ambiguous"
                    : result.run() != null && result.run().convergence() == Convergence.CONVERGED ? "undecided"
                            : "not-converged";
        }
        return drift != null && drift.any() ? "moved" : code == ExitCodes.TARGET_MISSED ? "fail"
                : hasTarget(result) ? "pass" : "no-target";
    }

    private void print(SurveyResult result, @Nullable Drift drift, int judged, String command) {
        PrintWriter stdout = spec.commandLine().getOut();
        String verdict = verdict(result, drift, judged);
        if (json) {
            stdout.print(SurveyJson.line(result, drift, verdict, Main.version(), command));
        } else {
            stdout.println(Main.coloured(verdict.toUpperCase(Locale.ROOT), judged));
            stdout.print(SurveyText.of(result));
            stdout.print(drift == null ? "" : SurveyText.of(drift));
        }
        stdout.flush();
        PrintWriter err = spec.commandLine().getErr();
        List<Warning> said = new ArrayList<>(result.warnings());
        said.addAll(drift == null ? List.of() : drift.warnings());
        said.forEach(w -> err.print(CheckText.wrap("Warning: " + CommandWords.of(w), "  ")));
    }

    private void write(SurveyResult result, @Nullable Drift drift, int judged, String command) {
        String name = CheckInput.baseName(out);
        Path page = out.resolveSibling(name + ".html");
        Path figures = out.resolveSibling(name + ".survey.json");
        Map<Path, WholeFiles.Content> contents = new LinkedHashMap<>();
        contents.put(out, text(CellWriter.text(result.surveyedCell(), List.of(
                "references where " + result.used() + " photos found them, with their joint covariance"))));
        contents.put(page, text(SurveyReport.of(result, drift, Main.version(), command)));
        contents.put(figures, text(SurveyJson.line(result, drift, verdict(result, drift, judged), Main.version(),
                command)));
        try {
            Files.createDirectories(out.toAbsolutePath().getParent());
            WholeFiles.writeContents(contents);
        } catch (IOException e) {
            throw new InputRefusedException(Refusal.at(Place.of(out.toString()), CommandRefusal.SURVEY_NOT_WRITTEN,
                    String.valueOf(e.getMessage())), e);
        }
        spec.commandLine().getErr().println("Surveyed cell file " + out + ", curves in " + page + ", figures for "
                + "a later --against in " + figures);
    }

    private static WholeFiles.Content text(String text) {
        return to -> to.write(text.getBytes(StandardCharsets.UTF_8));
    }
}
