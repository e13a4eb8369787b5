package org.cellgauge.desktop;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.function.Function;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.internal.cell.InputChecks;
import org.cellgauge.internal.output.StanCsv;
import org.cellgauge.internal.overlay.CellOverlay;
import org.cellgauge.internal.overlay.OverlayStyle;
import org.cellgauge.internal.vision.BoofThreads;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.internal.warning.Printable;
import org.cellgauge.output.CellView;
import org.cellgauge.output.ResultJson;
import org.cellgauge.output.ResultReader;
import org.cellgauge.output.ResultRecord;
import org.cellgauge.output.ResultView;
import org.cellgauge.output.StoredResult;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.SamplerKind;
import org.cellgauge.settings.SettingTable;
import org.cellgauge.vision.BoofMarkerDetector;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.DetectionsFile;
import org.cellgauge.vision.GreyImage;
import org.cellgauge.vision.MarkerDetector;
import org.cellgauge.vision.MarkerObservation;
import org.cellgauge.warning.Message;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;
import org.cellgauge.warning.Warning;

/**
 * Checks photos and detections files of one cell, one after the other, and writes what it finds into a folder: result
 * file, overlay and draws of each, summary and report of all. One input that cannot be used does not cost the others
 * their results.
 *
 * <p>Same inputs, cell, settings and day: same bytes.
 */
public final class BatchCheck {
    private final Builder with;
    private final Cell cell;
    private final CheckSettings settings;
    private final OptionalDouble targetStdMm;
    private MarkerDetector detector;

    private BatchCheck(Builder builder) {
        with = builder;
        settings = builder.settings;
        targetStdMm = settings.model().targetStdMm().isPresent() ? settings.model().targetStdMm()
                : builder.cellFile.cell().targetStdMm();
        cell = builder.cellFile.cell().withTarget(targetStdMm);
    }

    /**
     * A batch of the usual settings that writes no files.
     *
     * @param cell the cell
     * @return a builder
     */
    public static Builder of(CellFile cell) {
        return new Builder(cell);
    }

    /** Says what a batch is to do; every method returns the builder itself. */
    public static final class Builder {
        private final CellFile cellFile;
        private CheckSettings settings = CheckSettings.builder().build();
        private ResultFolder folder;
        private String version = "";
        private String day;
        private Function<? super Message, String> words = Message::toString;
        private Function<CheckInput, String> command = input -> null;
        private BatchListener listener = outcome -> { };
        private boolean storedOnly;
        private boolean withDraws = true;

        private Builder(CellFile cellFile) {
            this.cellFile = cellFile;
        }

        /**
         * Sets how photos are checked.
         *
         * @param value settings
         * @return this
         */
        public Builder settings(CheckSettings value) {
            settings = value;
            return this;
        }

        /**
         * Sets where results go.
         *
         * @param value the folder, or null: no files are written
         * @return this
         */
        public Builder folder(ResultFolder value) {
            folder = value;
            return this;
        }

        /**
         * Sets the version that results name.
         *
         * @param value of the program
         * @return this
         */
        public Builder version(String value) {
            version = value;
            return this;
        }

        /**
         * Sets the day that results name.
         *
         * @param value as in {@code 2026-11-28}, or null: none
         * @return this
         */
        public Builder day(String value) {
            day = value;
            return this;
        }

        /**
         * Sets how warnings and refusals are worded.
         *
         * @param value makes a sentence of a message
         * @return this
         */
        public Builder words(Function<? super Message, String> value) {
            words = value;
            return this;
        }

        /**
         * Sets what results name as the command that makes them again.
         *
         * @param value gives the line for an input, or null
         * @return this
         */
        public Builder command(Function<CheckInput, String> value) {
            command = value;
            return this;
        }

        /**
         * Sets who is told how the batch goes on.
         *
         * @param value is told
         * @return this
         */
        public Builder listener(BatchListener value) {
            listener = value;
            return this;
        }

        /**
         * Leaves out the files of draws, some megabytes of each input.
         *
         * @return this
         */
        public Builder withoutDraws() {
            withDraws = false;
            return this;
        }

        /**
         * Judges the results that the folder holds already by the target as it is now; nothing is sampled. They must be
         * of the same inputs, cell and settings but for the target.
         *
         * @return this
         */
        public Builder rejudge() {
            storedOnly = true;
            return this;
        }

        /**
         * The batch.
         *
         * @return ready to run
         * @throws IllegalArgumentException if stored results are to be judged and there is no folder
         */
        public BatchCheck build() {
            if (storedOnly && folder == null) {
                throw new IllegalArgumentException("stored results are in a folder");
            }
            return new BatchCheck(this);
        }
    }

    /** What was found in one input, its markers and its picture, which may be null. */
    private record Found(Detections detections, GreyImage photo, String sha256) {
    }

    /** A result to write; what the chains drew is null where nothing was sampled. */
    private record Result(StoredResult stored, CheckResult sampled, Found found) {
    }

    /** The overlay as its own file, and smaller for the report. */
    private record Picture(byte[] png, byte[] jpeg) {
    }

    /**
     * Checks inputs.
     *
     * @param inputs what to check
     * @return what became of all
     * @throws ResultFolder.UnwritableException if results cannot be written: a batch has no use in going on then
     */
    public BatchOutcome run(CheckInput.Inputs inputs) {
        BoofThreads.useOne();
        return new Run(inputs).all();
    }

    /** The line about a whole batch. */
    static String total(int count, Map<String, Integer> byWord) {
        List<String> parts = new ArrayList<>();
        byWord.forEach((word, number) -> parts.add(number + " " + word));
        return (count == 1 ? "1 photo: " : count + " photos: ") + String.join(", ", parts);
    }

    // ---- one input

    private Result one(CheckInput input) {
        if (input.refusal() != null) {
            throw new InputRefusedException(input.file().toString(), input.refusal());
        }
        return with.storedOnly ? rejudged(input) : checked(input);
    }

    private Result checked(CheckInput input) {
        Found found = found(input);
        CheckResult result = CellCheck.run(with.cellFile.cell(), found.detections(), settings);
        with.listener.stage("check");
        return new Result(new StoredResult(ResultView.of(result, with.words),
                record(input, found.sha256())), result, found);
    }

    private Found found(CheckInput input) {
        GreyImage photo;
        Detections detections;
        String name = input.file().toString();
        byte[] bytes = input.isDetections() ? DetectionsFile.bytes(input.file()) : ImageFiles.bytes(input.file());
        if (input.isDetections()) {
            detections = withRemarks(DetectionsFile.read(bytes, name));
            InputChecks.imageSize(cell, detections.widthPx(), detections.heightPx(), name);
            with.listener.stage("detections file");
            photo = photoBeside(input.file(), detections);
        } else {
            photo = ImageFiles.decode(bytes, name, (width, height) -> InputChecks.imageSize(cell, width, height, name));
            with.listener.stage("image file");
            if (detector == null) {
                detector = BoofMarkerDetector.forCell(cell);
            }
            detections = detector.detect(photo, name);
            with.listener.stage("detection");
        }
        return new Found(detections, photo, Sha256.of(bytes));
    }

    private ResultRecord record(CheckInput input, String sha256) {
        Path name = input.file().getFileName();
        return with.cellFile.in(ResultRecord.of(name == null ? input.file().toString() : name.toString(), sha256,
                with.version)).withDate(with.day).withCommand(with.command.apply(input));
    }

    /** A stored result as the target of now judges it. */
    private Result rejudged(CheckInput input) {
        Found found = found(input);
        String file = input.file().toString();
        Path path = with.folder.file(resultFile(input));
        if (!Files.exists(path)) {
            throw new InputRefusedException(file, BatchRefusal.NOT_STORED, with.folder.toString());
        }
        StoredResult stored = ResultReader.stored(path);
        ResultView view = stored.view();
        if (!found.sha256().equals(stored.record().inputSha256())) {
            throw new InputRefusedException(file, BatchRefusal.OTHER_INPUT);
        }
        if (!CellView.of(cell).equals(view.cell())) {
            throw new InputRefusedException(file, BatchRefusal.OTHER_CELL);
        }
        if (!sampledAs(view).equals(view.run().settings().toBuilder()
                .set(SettingTable.TARGET_STD_MM, OptionalDouble.empty()).build())) {
            throw new InputRefusedException(file, BatchRefusal.OTHER_SETTINGS);
        }
        with.listener.stage("stored result");
        ResultView judged = view.withTarget(targetStdMm);
        ResultRecord record = with.cellFile.in(stored.record()).withCommand(with.command.apply(input));
        if (!judged.equals(view)) {
            record = record.withJudgedOn(with.day);
        }
        return new Result(new StoredResult(judged, record), null, found);
    }

    /** The settings of now as a result made with them holds them, but for the target. */
    private CheckSettings sampledAs(ResultView view) {
        CheckSettings.Builder builder = settings.toBuilder()
                .set(SettingTable.TARGET_STD_MM, OptionalDouble.empty())
                .set(SettingTable.THREADS, SettingTable.THREADS.usual());
        for (SamplerKind kind : SamplerKind.values()) {
            if (kind.word().equals(view.run().samplerUsed())) {
                builder.warmup(settings.sampling().warmup(kind));
            }
        }
        return builder.build();
    }

    /** Markers that the cell does not know are of no use, and often a sign of the wrong cell file. */
    private Detections withRemarks(Detections detections) {
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
        warnings.add(Warning.of(BatchWarning.FOREIGN_MARKERS, Listing.comma(foreign)));
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
            String shown = photo.toString();
            return ImageFiles.decode(ImageFiles.bytes(photo), shown, (width, height) -> {
                if (width != detections.widthPx() || height != detections.heightPx()) {
                    throw new InputRefusedException(shown, BatchRefusal.OTHER_SIZE);
                }
            });
        } catch (InvalidPathException | InputRefusedException | IOException e) {
            return null;
        }
    }

    private static String resultFile(CheckInput input) {
        return input.name() + ".result.json";
    }

    /** One run over inputs: what it writes, and what it counts. */
    private final class Run {
        private final CheckInput.Inputs inputs;
        private final int count;
        private final HtmlReport report;
        private final SummaryCsv summary = new SummaryCsv();
        private final Map<String, Integer> byWord = new LinkedHashMap<>();
        private boolean withResult;
        private int done;
        private long startedNs = System.nanoTime();

        Run(CheckInput.Inputs inputs) {
            this.inputs = inputs;
            count = inputs.inputs().size();
            report = new HtmlReport(with.cellFile, CellView.of(cell), targetStdMm, with.version, with.day);
        }

        BatchOutcome all() {
            for (CheckInput input : inputs.inputs()) {
                try {
                    result(input, one(input));
                } catch (InputRefusedException e) {
                    refused(input, e);
                } catch (ResultFolder.UnwritableException e) {
                    throw e;
                } catch (RuntimeException | OutOfMemoryError e) {
                    // one photo must not cost the others their results
                    Optional<Refusal> limit = MachineRefusal.behind(e);
                    if (limit.isPresent()) {
                        refused(input, new InputRefusedException(
                                limit.get().withPlace(Place.of(input.file().toString())), e));
                    } else {
                        failed(input, InputOutcome.Kind.INTERNAL_ERROR,
                                new InputOutcome.Failure("internal-error", inShort(e), null, (RuntimeException) e),
                                null);
                    }
                }
            }
            boolean reported = with.folder != null && (inputs.isBatch() || withResult);
            if (reported) {
                Map<String, WholeFiles.Content> files = new LinkedHashMap<>();
                files.put("summary.csv", text(summary.text()));
                files.put("report.html", text(report.html(total(count, byWord))));
                with.folder.write(files);
                with.listener.stage("report");
            }
            return new BatchOutcome(count, Collections.unmodifiableMap(byWord), reported);
        }

        private void result(CheckInput input, Result result) {
            ResultFolder.UnwritableException unwritable = null;
            if (with.folder != null) {
                try {
                    files(input, result);
                } catch (InputRefusedException e) {
                    failed(input, InputOutcome.Kind.REFUSED, failure(e), result.stored());
                    return;
                } catch (ResultFolder.UnwritableException e) {
                    // what was computed is at least told
                    unwritable = e;
                }
            }
            summary.add(input, result.stored().view());
            withResult = true;
            tell(input, InputOutcome.Kind.RESULT, result.stored(), result.stored().record(), null);
            if (unwritable != null) {
                throw unwritable;
            }
        }

        private void files(CheckInput input, Result result) {
            CheckResult sampled = result.sampled();
            // painted while the chains are written, which takes about as long, unless one thread is all there may be
            CompletableFuture<Picture> picture = CompletableFuture.supplyAsync(() -> picture(result),
                    settings.sampling().threads() == 1 || sampled == null ? Runnable::run : BatchCheck::besides);
            Map<String, WholeFiles.Content> files = new LinkedHashMap<>();
            int chains = sampled == null || !with.withDraws ? 0 : sampled.draws().size();
            for (int i = 1; i <= chains; i++) {
                int chain = i;
                files.put(input.name() + ".chain-" + chain + ".csv", bytes -> {
                    Writer writer = new OutputStreamWriter(bytes, StandardCharsets.UTF_8);
                    StanCsv.write(sampled, chain, result.stored().record().inputName(), with.version, writer);
                    writer.flush();
                });
            }
            files.put(input.name() + ".overlay.png", bytes -> bytes.write(picture.join().png()));
            files.put(resultFile(input), text(ResultJson.of(result.stored())));
            with.folder.write(files);
            report.add(input, result.stored(), picture.join().jpeg());
            if (sampled != null) {
                with.folder.deleteChainsFrom(input.name(), chains + 1);
            }
            with.listener.stage("files");
        }

        private Picture picture(Result result) {
            BufferedImage painted = OverlayPainter.paint(result.found().photo(), CellOverlay.of(cell,
                    result.found().detections(), result.stored().view(), OverlayStyle.PHOTO));
            try {
                return new Picture(Pictures.png(painted), Pictures.jpeg(painted, reportWidthPx()));
            } catch (IOException e) {
                throw new IllegalStateException("encoding in memory failed", e);
            }
        }

        /** Reports of many photos must stay small enough to open. */
        private int reportWidthPx() {
            return count <= 24 ? 1280 : count <= 200 ? 640 : 320;
        }

        private void refused(CheckInput input, InputRefusedException e) {
            failed(input, InputOutcome.Kind.REFUSED, failure(e), null);
        }

        private InputOutcome.Failure failure(InputRefusedException e) {
            Refusal refusal = e.refusal();
            return new InputOutcome.Failure(refusal.kind().code(), with.words.apply(refusal), refusal.place(), e);
        }

        private void failed(CheckInput input, InputOutcome.Kind kind, InputOutcome.Failure why, StoredResult computed) {
            if (with.folder != null && !with.storedOnly) {
                // what an earlier run found must not be taken for the answer of this one
                with.folder.deleteResults(input.name());
            }
            InputOutcome outcome = tell(input, kind, computed,
                    computed == null ? record(input, null) : computed.record(), why);
            summary.add(input, outcome.word(), why.message());
            report.add(input, outcome.word(), why.message());
        }

        private InputOutcome tell(CheckInput input, InputOutcome.Kind kind, StoredResult result, ResultRecord record,
                InputOutcome.Failure why) {
            long now = System.nanoTime();
            InputOutcome outcome = new InputOutcome(input, kind, result, record, why, ++done, count,
                    (now - startedNs) * 1e-9);
            startedNs = now;
            byWord.merge(outcome.word(), 1, Integer::sum);
            with.listener.finished(outcome);
            return outcome;
        }
    }

    private static void besides(Runnable task) {
        Thread thread = new Thread(task, "cellgauge-picture");
        thread.setDaemon(true);
        thread.start();
    }

    private static WholeFiles.Content text(String text) {
        return bytes -> bytes.write(text.getBytes(StandardCharsets.UTF_8));
    }

    /**
     * An unexpected error in a line.
     *
     * @param e the error
     * @return its class and message
     */
    public static String inShort(Throwable e) {
        String message = e.getMessage() == null ? "" : ": " + Printable.shortened(e.getMessage());
        return e.getClass().getSimpleName() + message;
    }
}
