package org.cellgauge.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.desktop.BatchCheck;
import org.cellgauge.desktop.BatchListener;
import org.cellgauge.desktop.BatchOutcome;
import org.cellgauge.desktop.CellFile;
import org.cellgauge.desktop.CheckInput;
import org.cellgauge.desktop.CheckText;
import org.cellgauge.desktop.DrawFiles;
import org.cellgauge.desktop.InputOutcome;
import org.cellgauge.desktop.ResultFolder;
import org.cellgauge.desktop.StopSignal;
import org.cellgauge.desktop.TextTable;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.internal.warning.Printable;
import org.cellgauge.output.ResultRow;
import org.cellgauge.output.ResultView;
import org.cellgauge.settings.CheckSettings;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;
import picocli.CommandLine.Model.UsageMessageSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;

/** {@code cellgauge check}: from photos of a cell to poses, their uncertainties and a verdict. */
public final class CheckCommand implements Callable<Integer> {
    static final String DRAWS = "--draws";
    private static final String CELL = "--cell";
    private static final String DETECTIONS = "--detections";
    private static final String OUT = "--out";
    private static final String JSON = "--json";
    private static final String REJUDGE = "--rejudge";
    private static final String AGAIN = "--again";
    private static final String NO_ADVICE = "--no-advice";

    /** Most different things to do that are told of a batch. */
    private static final int MOST_ACTIONS = 20;
    private static final Path DEFAULT_FOLDER = Path.of("cellgauge-out");

    private final Main main;
    private final CommandSpec spec;
    private Path cellFile;
    private List<Path> images;
    private List<Path> detectionsFiles;
    private Path out;
    private boolean json;
    private boolean rejudge;
    private boolean again;
    private Boolean draws;
    private boolean noAdvice;
    private Stages stages;

    private CheckCommand(Main main) {
        this.main = main;
        spec = CommandSpec.wrapWithoutInspection(this).name("check").versionProvider(new Main.Version());
    }

    /**
     * The command with its options. They are made by calls, since reading annotations takes longer than all the rest of
     * a command line.
     *
     * @param main the command it belongs to
     * @return a specification of {@link CheckCommand}
     */
    static CommandSpec spec(Main main) {
        CommandSpec spec = new CheckCommand(main).spec;
        addTexts(spec.usageMessage());
        addOptions(spec);
        CheckOptions.addToCheck(spec);
        return StandardOptions.add(spec);
    }

    private static void addTexts(UsageMessageSpec usage) {
        usage.sortOptions(false);
        usage.description("Finds the markers in photos of a cell, estimates the poses of camera and objects with their "
                    + "uncertainties, and judges these against the target of the cell file.", "", "Examples:",
            "  cellgauge check --cell cell.yaml photo.png",
            "  cellgauge check --cell cell.yaml photos/ --out results",
            "  cellgauge check --cell cell.yaml --detections a.json",
            "  cellgauge check --cell cell.yaml photos/ --rejudge --target 2",
            "  camera-tool | cellgauge check --cell cell.yaml --json -",
            "");
        usage.footer("",
            "Files in DIR: NAME.result.json and NAME.overlay.png of every photo, report.html and summary.csv of the",
            "run; NAME.chain-K.csv (Stan CSV) of a single photo, or with --draws. What an earlier run left there of",
            "the same photo, cell and settings is kept; other results of the same names are replaced. Beyond 100",
            "photos the report has pages.",
            "The table goes to standard output, progress and messages to standard error.",
            "",
            "Exit codes: 0 target met or none set, 1 internal error, 2 usage, 3 input refused or results",
            "not writable, 4 target missed, 5 not converged or pose ambiguous: no figure to trust. Of several",
            "photos the most serious counts: 1, then 3, 5, 4, 0. Stopped by Ctrl-C 130, by SIGTERM 143: what is",
            "done by then is in DIR, summary and report included, and the same command does the rest.");
    }

    private static void addOptions(CommandSpec spec) {
        spec.addOption(OptionSpec.builder(CELL).required(true).paramLabel("CELL").type(Path.class)
                .description("The cell file; - is standard input, here and below.").build());
        spec.addPositional(PositionalParamSpec.builder().paramLabel("IMAGE").arity("0..*")
                .type(List.class).auxiliaryTypes(Path.class)
                .description("Photos of the cell (PNG, JPEG, BMP, TIFF, GIF, WebP, PGM, PPM), or folders of them.")
                .build());
        spec.addOption(OptionSpec.builder(DETECTIONS).paramLabel("FILE").arity("1..*")
                .type(List.class).auxiliaryTypes(Path.class)
                .description("Files of corners from any detector, in place of photos; name photos before this option.")
                .build());
        spec.addOption(OptionSpec.builder(OUT).paramLabel("DIR").type(Path.class)
                .description("Folder for the results; made if it is missing (cellgauge-out; with --json: no files).")
                .build());
        addFlag(spec, JSON, "Prints one line of JSON for each input in place of the table: its result file, or why it "
                + "was refused.");
        addFlag(spec, REJUDGE, "Samples nothing: judges the results in DIR by the target as it is now. They must be of "
                + "the same inputs, settings and, but for its target, the same cell.");
        addFlag(spec, AGAIN, "Checks all photos, also those whose results an earlier run left in DIR.");
        spec.addOption(OptionSpec.builder(DRAWS).negatable(true).fallbackValue("true").type(Boolean.class)
                .description("Writes all draws into NAME.chain-K.csv, some MB a photo, or none. Without either: of a "
                        + "single photo 1000 draws a chain at most and 20 MB in all, of several photos none.").build());
        addFlag(spec, NO_ADVICE, "Leaves out which changes of the set-up would meet a target that is missed.");
    }

    private static void addFlag(CommandSpec spec, String name, String description) {
        spec.addOption(OptionSpec.builder(name).type(boolean.class).description(description).build());
    }

    private void takeOptions(ParseResult given) {
        cellFile = given.matchedOptionValue(CELL, null);
        images = given.matchedPositionalValue(0, List.of());
        detectionsFiles = given.matchedOptionValue(DETECTIONS, List.of());
        out = given.matchedOptionValue(OUT, null);
        json = given.matchedOptionValue(JSON, false);
        rejudge = given.matchedOptionValue(REJUDGE, false);
        again = given.matchedOptionValue(AGAIN, false);
        draws = given.matchedOptionValue(DRAWS, null);
        noAdvice = given.matchedOptionValue(NO_ADVICE, false);
    }

    /**
     * Runs the check.
     *
     * @return the exit code
     */
    @Override
    public Integer call() {
        takeOptions(spec.commandLine().getParseResult());
        CheckSettings settings = CheckOptions.settings(spec.commandLine(), CheckOptions.CHECK_USUAL);
        if (images.isEmpty() && detectionsFiles.isEmpty()) {
            throw new ParameterException(spec.commandLine(),
                    "nothing to check; name photos, a folder of them, or --detections FILE");
        }
        if (rejudge && again) {
            throw new ParameterException(spec.commandLine(),
                    "--rejudge checks nothing anew; leave out --again, or --rejudge");
        }
        List<Path> read = new ArrayList<>(images);
        read.addAll(detectionsFiles);
        read.add(cellFile);
        StandardInput.requireOnce(spec.commandLine(), read);
        stages = new Stages(main.debug());
        long start = System.nanoTime();
        try {
            CellFile cell = StandardInput.cellFile(cellFile);
            stages.add("cell file", (System.nanoTime() - start) * 1e-9);
            boolean files = !json || rejudge || out != null;
            ResultFolder folder = files ? ResultFolder.into(out == null ? DEFAULT_FOLDER : out) : null;
            return run(cell, settings, CheckInput.resolve(StandardInput.kept(images, System.in),
                    StandardInput.kept(detectionsFiles, System.in)), folder);
        } catch (InputRefusedException | ResultFolder.UnwritableException e) {
            return main.report(e, ExitCodes.INPUT_REFUSED, spec.commandLine());
        }
    }

    private int run(CellFile cell, CheckSettings settings, CheckInput.Inputs inputs, ResultFolder folder) {
        PrintWriter err = spec.commandLine().getErr();
        inputs.remarks().forEach(remark -> err.println(Printable.of(remark)));
        err.flush();
        Printed printed = new Printed(inputs.isBatch());
        boolean allDraws = Boolean.TRUE.equals(draws);
        StopSignal stop = new StopSignal();
        BatchCheck.Builder batch = BatchCheck.of(cell).settings(settings).folder(folder).version(Main.version())
                .day(Main.day()).words(CommandWords::of).listener(printed).stop(stop)
                .advice(!noAdvice).draws(draws == null ? null : allDraws ? DrawFiles.ALL : DrawFiles.NONE)
                .command(input -> RepeatingCommand.check(cellFile, input, settings, allDraws));
        if (rejudge) {
            batch.rejudge();
        }
        if (again) {
            batch.anew();
        }
        StopOnShutdown onShutdown = new StopOnShutdown(stop);
        try (onShutdown) {
            BatchOutcome outcome = batch.build().run(inputs);
            printed.end(outcome);
            after(outcome, stop.isGiven(), folder);
            stages.print(err);
            err.flush();
        }
        return printed.exitCode;
    }

    /** What is to be said of a run as a whole, besides its results. */
    private void after(BatchOutcome outcome, boolean stopped, ResultFolder folder) {
        PrintWriter err = spec.commandLine().getErr();
        if (outcome.kept() > 0) {
            err.println(outcome.kept() + " kept from an earlier run; --again checks "
                    + (outcome.kept() == 1 ? "it" : "them") + " anew");
        }
        String where = Printable.of(outcome.reportFolder().map(Path::toString).orElse(""));
        if (stopped || outcome.unwritable().isPresent()) {
            err.println((stopped ? "Stopped: " : "Ended: ") + outcome.done() + " of " + outcome.count()
                    + " photos are done; " + (where.isEmpty() ? "there is no report of them"
                            : "summary and report of these are in " + where)
                    + (folder == null ? "" : ". The same command does the rest."));
        } else if (!where.isEmpty()) {
            err.println("Results in " + where + ": open "
                    + Printable.of(outcome.reportFolder().get().resolve("report.html").toString()));
        }
    }

    /** What a run prints as it goes on, and its exit code. */
    private final class Printed implements BatchListener {
        private final boolean batch;
        private final PrintWriter stdout = spec.commandLine().getOut();
        private final PrintWriter err = spec.commandLine().getErr();
        private final TextTable table = new TextTable(2);
        private final Progress progress;
        /** What to do first, with the photos that say so. */
        private final Map<String, List<String>> actions = new LinkedHashMap<>();
        private int moreActions;
        private int exitCode;

        Printed(boolean batch) {
            this.batch = batch;
            progress = new Progress(err, Main.isTerminal(System.getenv()), Main.columns(System.getenv("COLUMNS")),
                    System::nanoTime);
            table.row("photo", "verdict", "worst std mm", "of", "R-hat", "draws");
        }

        @Override
        public void stage(String name, double seconds) {
            stages.add(name, seconds);
        }

        @Override
        public void finished(InputOutcome outcome) {
            String words = outcome.word();
            progress.clear();
            if (outcome.kind() == InputOutcome.Kind.RESULT) {
                words += result(outcome);
            } else {
                int code = outcome.kind() == InputOutcome.Kind.REFUSED ? ExitCodes.INPUT_REFUSED
                        : ExitCodes.INTERNAL_ERROR;
                exitCode = ExitCodes.moreSerious(exitCode, main.report(outcome.refusal().error(), code,
                        spec.commandLine()));
                table.row(outcome.input().name(), outcome.word(), "-", "", "-", "-");
            }
            if (json) {
                stdout.print(outcome.jsonLine());
            }
            stdout.flush();
            if (batch) {
                progress.done(outcome, words);
            } else if (outcome.everyDraw() > 1) {
                err.println("Files of draws hold every " + outcome.everyDraw() + ". draw; " + DRAWS + " writes all");
            }
        }

        /** Prints a result; gives what progress adds to its word. */
        private String result(InputOutcome outcome) {
            ResultView view = outcome.view();
            int code = ExitCodes.of(view.verdict());
            exitCode = ExitCodes.moreSerious(exitCode, code);
            ResultRow worst = view.worstObject();
            boolean shown = worst != null && view.showsFigures();
            String std = shown ? CheckText.fixed(view.worstStdMm(worst), 2) : "-";
            table.row(outcome.input().name(), outcome.word(), std, shown ? CheckText.name(worst) : "",
                    CheckText.fixed(view.chains().rHatMax(), 4),
                    CheckText.fixed(Math.min(view.chains().essBulkMin(), view.chains().essTailMin()), 0));
            if (!json && !batch) {
                String word = outcome.word();
                String line = CheckText.wrap(word + "  " + Printable.of(outcome.input().file().toString()) + ": "
                        + view.reason(), "      ");
                stdout.print(Main.coloured(word, code) + line.substring(word.length()));
                stdout.print(CheckText.of(view));
            }
            if (view.action() != null) {
                if (actions.size() < MOST_ACTIONS || actions.containsKey(view.action())) {
                    actions.computeIfAbsent(view.action(), a -> new ArrayList<>()).add(outcome.input().name());
                } else {
                    moreActions++;
                }
            }
            return shown ? ", worst std " + std + " mm" : "";
        }

        void end(BatchOutcome outcome) {
            progress.clear();
            if (batch && !json) {
                stdout.print(table.text(""));
                stdout.println(outcome.total());
                actions.forEach((action, photos) -> stdout.print(CheckText.wrap("  " + Listing.and(photos) + ": "
                        + action, "    ")));
                if (moreActions > 0) {
                    stdout.println("  and of " + moreActions + " more photos, in summary.csv and the report");
                }
            }
            stdout.flush();
            outcome.unwritable().ifPresent(e -> exitCode = ExitCodes.moreSerious(exitCode, main.report(e,
                    ExitCodes.INPUT_REFUSED, spec.commandLine())));
        }
    }

    /** How long the stages of a run take, all threads together, for --debug. */
    private static final class Stages {
        private final boolean wanted;
        private final Map<String, Double> seconds = new LinkedHashMap<>();

        Stages(boolean wanted) {
            this.wanted = wanted;
        }

        void add(String stage, double stageSeconds) {
            seconds.merge(stage, stageSeconds, Double::sum);
        }

        void print(PrintWriter err) {
            if (wanted) {
                List<String> parts = new ArrayList<>();
                seconds.forEach((stage, s) -> parts.add(stage + " " + Math.round(s * 1e3) + " ms"));
                err.println("Time: " + String.join(", ", parts));
            }
        }
    }
}
