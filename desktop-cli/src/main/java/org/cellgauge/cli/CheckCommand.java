package org.cellgauge.cli;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStreamWriter;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.desktop.CheckInput;
import org.cellgauge.desktop.CheckText;
import org.cellgauge.desktop.HtmlReport;
import org.cellgauge.desktop.ImageFiles;
import org.cellgauge.desktop.OverlayPainter;
import org.cellgauge.desktop.Pictures;
import org.cellgauge.desktop.SummaryCsv;
import org.cellgauge.desktop.TextTable;
import org.cellgauge.desktop.WholeFiles;
import org.cellgauge.internal.cell.InputChecks;
import org.cellgauge.internal.output.StanCsv;
import org.cellgauge.internal.overlay.CellOverlay;
import org.cellgauge.internal.vision.BoofThreads;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.output.ResultJson;
import org.cellgauge.output.ResultRow;
import org.cellgauge.output.ResultView;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.BoofMarkerDetector;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.DetectionsFile;
import org.cellgauge.vision.GreyImage;
import org.cellgauge.vision.MarkerDetector;
import org.cellgauge.vision.MarkerObservation;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;
import org.cellgauge.warning.Warning;
import org.cellgauge.warning.WarningKind;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import picocli.CommandLine.Spec;

/** {@code cellgauge check}: from photos of a cell to poses, their uncertainties and a verdict. */
@Command(name = "check", mixinStandardHelpOptions = true, sortOptions = false, versionProvider = Main.Version.class,
        modelTransformer = CheckOptions.OfCheck.class,
        description = {"Finds the markers in photos of a cell, estimates the poses of camera and objects with their "
                + "uncertainties, and judges these against the target of the cell file.", "", "Examples:",
            "  cellgauge check --cell cell.yaml photo.png",
            "  cellgauge check --cell cell.yaml photos/ --out results",
            "  cellgauge check --cell cell.yaml --detections a.json",
            "  camera-tool | cellgauge check --cell cell.yaml --json -",
            ""},
        footer = {"",
            "Files in DIR: NAME.result.json, NAME.overlay.png and NAME.chain-K.csv (Stan CSV) of every photo,",
            "report.html and summary.csv of the run. Results of earlier runs of the same names are replaced.",
            "The table goes to standard output, progress and messages to standard error.",
            "",
            "Exit codes: 0 target met or none set, 1 internal error, 2 usage, 3 input refused or results",
            "not writable, 4 target missed, 5 not converged or pose ambiguous: no figure to trust. Of several",
            "photos the most serious counts: 1, then 3, 5, 4, 0."})
public final class CheckCommand implements Callable<Integer> {
    private static final Path DEFAULT_FOLDER = Path.of("cellgauge-out");

    @Spec
    private CommandSpec spec;

    @ParentCommand
    private Main main;

    @Option(names = "--cell", required = true, paramLabel = "CELL",
            description = "The cell file; - is standard input, here and below.")
    private Path cellFile;

    @Parameters(paramLabel = "IMAGE", arity = "0..*",
            description = "Photos of the cell (PNG, JPEG, BMP, TIFF, GIF), or folders of them.")
    private List<Path> images = new ArrayList<>();

    @Option(names = "--detections", paramLabel = "FILE", arity = "1..*",
            description = "Files of corners from any detector, in place of photos; name photos before this option.")
    private List<Path> detectionsFiles = new ArrayList<>();

    @Option(names = "--out", paramLabel = "DIR",
            description = "Folder for the results; made if it is missing (cellgauge-out; with --json: no files).")
    private Path out;

    @Option(names = "--json",
            description = "Prints the result file to standard output in place of the table; of several photos, a list.")
    private boolean json;

    @Option(names = "--no-draws",
            description = "Leaves out NAME.chain-K.csv, some MB a photo; the other results hold all figures.")
    private boolean noDraws;

    private Cell cell;
    private CheckSettings settings;
    private String version;
    private MarkerDetector detector;
    private Stages stages;

    /**
     * Runs the check.
     *
     * @return the exit code
     */
    @Override
    public Integer call() {
        settings = CheckOptions.settings(spec.commandLine(), CheckOptions.OfCheck.USUAL);
        if (images.isEmpty() && detectionsFiles.isEmpty()) {
            throw new ParameterException(spec.commandLine(),
                    "nothing to check; name photos, a folder of them, or --detections FILE");
        }
        List<Path> read = new ArrayList<>(images);
        read.addAll(detectionsFiles);
        read.add(cellFile);
        StandardInput.requireOnce(spec.commandLine(), read);
        stages = new Stages(main.debug());
        BoofThreads.useOne();
        version = Main.version();
        try {
            cell = StandardInput.cell(cellFile);
            stages.end("cell file");
            CheckOutput output = out != null ? CheckOutput.into(out) : json ? null : CheckOutput.into(DEFAULT_FOLDER);
            return run(CheckInput.resolve(StandardInput.kept(images, System.in),
                    StandardInput.kept(detectionsFiles, System.in)), output);
        } catch (InputRefusedException | CheckOutput.UnwritableException e) {
            return main.report(e, ExitCodes.INPUT_REFUSED, spec.commandLine());
        }
    }

    private int run(CheckInput.Inputs inputs, CheckOutput output) {
        PrintWriter err = spec.commandLine().getErr();
        inputs.remarks().forEach(err::println);
        Run run = new Run(inputs.inputs().size(), inputs.isBatch(), output);
        for (CheckInput input : inputs.inputs()) {
            try {
                run.result(input, one(input));
            } catch (InputRefusedException e) {
                run.refused(input, ExitCodes.INPUT_REFUSED, "refused", e);
            } catch (CheckOutput.UnwritableException e) {
                run.endOfTable();
                throw e;
            } catch (RuntimeException e) {
                // one photo must not cost the others their results
                run.refused(input, ExitCodes.INTERNAL_ERROR, "internal error", e);
            } catch (OutOfMemoryError e) {
                run.refused(input, ExitCodes.INPUT_REFUSED, "refused", new InputRefusedException(
                        input.file().toString(), CommandRefusal.MEMORY,
                        (int) (Runtime.getRuntime().maxMemory() / (1 << 20))));
            }
        }
        return run.finish();
    }

    /** What was found in one input, with its picture and checksum. */
    private record Outcome(CheckResult result, GreyImage photo, String sha256) {
    }

    private Outcome one(CheckInput input) {
        if (input.refusal() != null) {
            throw new InputRefusedException(input.file().toString(), input.refusal());
        }
        GreyImage photo;
        Detections detections;
        if (input.isDetections()) {
            detections = withRemarks(DetectionsFile.read(input.file()), input.file());
            InputChecks.imageSize(cell, detections.widthPx(), detections.heightPx(), input.file().toString());
            stages.end("detections file");
            photo = photoBeside(input.file(), detections);
        } else {
            photo = ImageFiles.read(input.file());
            stages.end("image file");
            InputChecks.imageSize(cell, photo.widthPx(), photo.heightPx(), input.file().toString());
            if (detector == null) {
                detector = BoofMarkerDetector.forCell(cell);
            }
            detections = detector.detect(photo, input.file().toString());
            stages.end("detection");
        }
        String sha256 = sha256(input.file());
        CheckResult result = CellCheck.run(cell, detections, settings);
        stages.end("check");
        return new Outcome(result, photo, sha256);
    }

    /** What this command warns of besides the check. */
    private enum Remark implements WarningKind {
        /** Markers of a detections file that the cell does not know: ids. */
        FOREIGN_MARKERS("the detections file names markers that are not in the cell file: %s; they are ignored");

        private final String english;

        Remark(String english) {
            this.english = english;
        }

        @Override
        public String english() {
            return english;
        }
    }

    /** Markers that the cell does not know are of no use, and often a sign of the wrong cell file. */
    private Detections withRemarks(Detections detections, Path file) {
        Set<Integer> known = new HashSet<>();
        cell.references().forEach(r -> known.add(r.id()));
        cell.objects().forEach(o -> known.add(o.id()));
        List<Integer> foreign = new ArrayList<>();
        for (MarkerObservation marker : detections.markers()) {
            if (!known.contains(marker.id())) {
                foreign.add(marker.id());
            }
        }
        if (foreign.isEmpty()) {
            return detections;
        }
        List<Warning> warnings = new ArrayList<>(detections.warnings());
        warnings.add(Warning.of(Remark.FOREIGN_MARKERS, Listing.comma(foreign)));
        return new Detections(detections.imageName(), detections.widthPx(), detections.heightPx(), detections.markers(),
                warnings, detections.light());
    }

    /** The photo that a detections file names, where it stands beside it: a ground to paint on, nothing more. */
    private static GreyImage photoBeside(Path file, Detections detections) {
        try {
            Path name = Path.of(detections.imageName()).getFileName();
            Path photo = name == null ? file : file.resolveSibling(name);
            if (!Files.isRegularFile(photo) || Files.isSameFile(photo, file)) {
                return null;
            }
            GreyImage image = ImageFiles.read(photo);
            return image.widthPx() == detections.widthPx() && image.heightPx() == detections.heightPx() ? image : null;
        } catch (InvalidPathException | InputRefusedException | IOException e) {
            return null;
        }
    }

    private static String sha256(Path file) {
        try (InputStream in = Files.newInputStream(file)) {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            byte[] buffer = new byte[1 << 16];
            int n = in.read(buffer);
            while (n >= 0) {
                digest.update(buffer, 0, n);
                n = in.read(buffer);
            }
            StringBuilder hex = new StringBuilder();
            for (byte b : digest.digest()) {
                hex.append(String.format(Locale.ROOT, "%02x", b));
            }
            return hex.toString();
        } catch (IOException e) {
            throw new InputRefusedException(Refusal.at(Place.of(file.toString()), CommandRefusal.NOT_READABLE,
                    String.valueOf(e.getMessage())), e);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }

    /** The overlay as its own file, and smaller for the report. */
    private record Picture(byte[] png, byte[] jpeg) {
    }

    /** What a run prints, writes and returns. */
    private final class Run {
        private final int count;
        private final boolean batch;
        private final CheckOutput output;
        private final PrintWriter stdout = spec.commandLine().getOut();
        private final PrintWriter err = spec.commandLine().getErr();
        private final HtmlReport report = new HtmlReport(cellFile.toString(), version, CommandWords::of);
        private final SummaryCsv summary = new SummaryCsv();
        private final TextTable table = new TextTable(2);
        private final Map<String, Integer> tally = new LinkedHashMap<>();
        private boolean withResult;
        private int done;
        private int exitCode;
        private long startedNs = System.nanoTime();

        Run(int count, boolean batch, CheckOutput output) {
            this.count = count;
            this.batch = batch;
            this.output = output;
            table.row("photo", "verdict", "worst std mm", "of", "R-hat", "draws");
            if (json && batch) {
                stdout.print("[");
            }
        }

        void result(CheckInput input, Outcome outcome) {
            CheckResult result = outcome.result();
            String command = RepeatingCommand.check(cellFile, input, settings);
            String text = ResultJson.of(result, input.file().getFileName().toString(), outcome.sha256(), version,
                    command);
            CheckOutput.UnwritableException unwritable = null;
            if (output != null) {
                try {
                    files(input, outcome, text, command);
                } catch (CheckOutput.UnwritableException e) {
                    // what was computed is at least shown
                    unwritable = e;
                }
            }
            summary.add(input, result);
            withResult = true;
            note(CheckText.word(result.verdict()));
            exitCode = ExitCodes.moreSerious(exitCode, ExitCodes.of(result.verdict()));
            ResultView view = ResultView.of(result);
            ResultRow worst = view.worstObject();
            String std = worst == null ? "-" : CheckText.fixed(view.worstStdMm(worst), 2);
            table.row(input.name(), CheckText.word(result.verdict()), std,
                    worst == null ? "" : CheckText.name(worst), CheckText.fixed(view.chains().rHatMax(), 4),
                    CheckText.fixed(Math.min(view.chains().essBulkMin(), view.chains().essTailMin()), 0));
            if (json) {
                stdout.print(batch && done > 1 ? ",\n" + text.stripTrailing() : text.stripTrailing());
            } else if (!batch) {
                String word = CheckText.word(result.verdict());
                String line = CheckText.wrap(word + "  " + input.file() + ": " + result.reason(), "      ");
                stdout.print(Main.coloured(word, ExitCodes.of(result.verdict())) + line.substring(word.length()));
                stdout.print(CheckText.of(result, CommandWords::of));
            }
            stdout.flush();
            progress(input, CheckText.word(result.verdict()) + (worst == null ? "" : ", worst std " + std + " mm"));
            if (unwritable != null) {
                throw unwritable;
            }
        }

        private void files(CheckInput input, Outcome outcome, String text, String command) {
            CheckResult result = outcome.result();
            // painted while the chains are written, which takes about as long, unless one thread is all there may be
            CompletableFuture<Picture> picture = CompletableFuture.supplyAsync(() -> picture(outcome),
                    settings.sampling().threads() == 1 ? Runnable::run : Run::besides);
            Map<String, WholeFiles.Content> files = new LinkedHashMap<>();
            int chains = noDraws ? 0 : result.draws().size();
            for (int i = 1; i <= chains; i++) {
                int chain = i;
                files.put(input.name() + ".chain-" + chain + ".csv", bytes -> {
                    Writer writer = new OutputStreamWriter(bytes, StandardCharsets.UTF_8);
                    StanCsv.write(result, chain, input.file().getFileName().toString(), version, writer);
                    writer.flush();
                });
            }
            files.put(input.name() + ".overlay.png", bytes -> bytes.write(picture.join().png()));
            files.put(input.name() + ".result.json", text(text));
            output.write(files);
            report.add(input, result, picture.join().jpeg(), command);
            output.deleteChainsFrom(input.name(), chains + 1);
            stages.end("files");
        }

        private static void besides(Runnable task) {
            Thread thread = new Thread(task, "cellgauge-picture");
            thread.setDaemon(true);
            thread.start();
        }

        private Picture picture(Outcome outcome) {
            BufferedImage painted = OverlayPainter.paint(outcome.photo(), CellOverlay.of(outcome.result()));
            try {
                return new Picture(Pictures.png(painted), Pictures.jpeg(painted, reportWidthPx()));
            } catch (IOException e) {
                throw new IllegalStateException("encoding in memory failed", e);
            }
        }

        private static WholeFiles.Content text(String text) {
            return bytes -> bytes.write(text.getBytes(StandardCharsets.UTF_8));
        }

        /** Reports of many photos must stay small enough to open. */
        private int reportWidthPx() {
            return count <= 24 ? 1280 : count <= 200 ? 640 : 320;
        }

        void refused(CheckInput input, int code, String word, RuntimeException e) {
            String message = code == ExitCodes.INPUT_REFUSED ? CommandWords.of(e) : Main.inShort(e);
            main.report(e, code, spec.commandLine());
            exitCode = ExitCodes.moreSerious(exitCode, code);
            if (output != null) {
                // what an earlier run found must not be taken for the answer of this one
                output.deleteResults(input.name());
            }
            summary.add(input, word, message);
            report.add(input, word, message);
            note(word);
            table.row(input.name(), word, "-", "", "-", "-");
            progress(input, word);
        }

        private void note(String word) {
            tally.merge(word, 1, Integer::sum);
            done++;
        }

        private void progress(CheckInput input, String what) {
            if (batch) {
                long now = System.nanoTime();
                err.printf(Locale.ROOT, "[%d/%d] %s: %s (%.2f s)%n", done, count, input.name(), what,
                        (now - startedNs) * 1e-9);
                err.flush();
                startedNs = now;
            }
        }

        /** Ends what is printed as data, also where the run cannot go on. */
        void endOfTable() {
            if (json) {
                stdout.println(batch ? "]" : "");
            } else if (batch) {
                stdout.print(table.text(""));
            }
            stdout.flush();
        }

        int finish() {
            List<String> parts = new ArrayList<>();
            tally.forEach((word, number) -> parts.add(number + " " + word));
            String total = (count == 1 ? "1 photo: " : count + " photos: ") + String.join(", ", parts);
            endOfTable();
            if (batch && !json) {
                stdout.println(total);
                stdout.flush();
            }
            if (output != null && (batch || withResult)) {
                Map<String, WholeFiles.Content> files = new LinkedHashMap<>();
                files.put("summary.csv", text(summary.text()));
                files.put("report.html", text(report.html(total)));
                output.write(files);
                stages.end("report");
                err.println("Results in " + output + ": open " + Path.of(output.toString(), "report.html"));
            }
            stages.print(err);
            err.flush();
            return exitCode;
        }
    }

    /** How long the stages of a run take, for --debug. */
    private static final class Stages {
        private final boolean wanted;
        private final Map<String, Long> nanoseconds = new LinkedHashMap<>();
        private long last;

        Stages(boolean wanted) {
            this.wanted = wanted;
            last = System.nanoTime();
        }

        void end(String stage) {
            long now = System.nanoTime();
            nanoseconds.merge(stage, now - last, Long::sum);
            last = now;
        }

        void print(PrintWriter err) {
            if (wanted) {
                List<String> parts = new ArrayList<>();
                nanoseconds.forEach((stage, ns) -> parts.add(stage + " " + Math.round(ns * 1e-6) + " ms"));
                err.println("Time: " + String.join(", ", parts));
            }
        }
    }
}
