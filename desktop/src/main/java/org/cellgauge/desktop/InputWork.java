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
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.CheckUpdate;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.cell.InputChecks;
import org.cellgauge.internal.output.StanCsv;
import org.cellgauge.internal.overlay.CellOverlay;
import org.cellgauge.internal.overlay.OverlayStyle;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.output.AdviceView;
import org.cellgauge.output.ResultJson;
import org.cellgauge.output.ResultRecord;
import org.cellgauge.output.ResultView;
import org.cellgauge.output.StoredResult;
import org.cellgauge.settings.SettingTable;
import org.cellgauge.vision.BoofMarkerDetector;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.DetectionsFile;
import org.cellgauge.vision.GreyImage;
import org.cellgauge.vision.MarkerDetector;
import org.cellgauge.vision.MarkerObservation;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;
import org.cellgauge.warning.Warning;

/**
 * The work on single inputs, from their bytes to files of results and what the report says of them, in one thread: the
 * detector keeps its work space from one photo to the next.
 */
final class InputWork {
    private final BatchCheck.Plan plan;
    private final Cell cell;
    private final EarlierResults earlier;
    private final Map<String, Double> stages = new LinkedHashMap<>();
    private MarkerDetector detector;
    private int detectorWidthPx;
    private long stageNs;

    /**
     * Work for a batch.
     *
     * @param plan what it is to do
     */
    InputWork(BatchCheck.Plan plan) {
        this.plan = plan;
        cell = plan.cell();
        earlier = plan.folder() == null ? null
                : new EarlierResults(plan.folder(), plan.cellFile(), cell, plan.settings());
    }

    /**
     * An input that was worked on.
     *
     * @param outcome what became of it
     * @param section what the report says of it
     * @param unwritable why the folder took no results; null where it did
     * @param stages how long they took, s
     */
    record Done(InputOutcome outcome, PhotoSection section, ResultFolder.UnwritableException unwritable,
            Map<String, Double> stages) {
    }

    /** An input and what was read of it. Its checksum is made beside the first work on it, which takes as long. */
    private record Read(CheckInput input, byte[] bytes, CompletableFuture<String> sum) {
        String sha256() {
            return sum.join();
        }
    }

    /** Markers and the picture, which may be null. */
    private record Found(Cell cell, Detections detections, GreyImage photo) {
    }

    /** A result, every how-manieth draw is in its files (0 where there are none), and what the report says of it. */
    private record Result(StoredResult stored, boolean isKept, int everyDraw, PhotoSection section) {
    }

    /** The batch was stopped while an input was worked on. */
    private static final class StoppedException extends RuntimeException {
        private static final long serialVersionUID = 1L;

        StoppedException() {
            super(null, null, false, false);
        }
    }

    /**
     * Works on an input.
     *
     * @param input the input
     * @param number its place in the batch, from 1
     * @return what became of it; null where the batch was stopped before anything did
     */
    Done on(CheckInput input, int number) {
        long start = System.nanoTime();
        stageNs = start;
        stages.clear();
        Attempt attempt = new Attempt(input, number);
        try {
            if (plan.stop().isGiven()) {
                return null;
            }
            attempt.run();
        } catch (StoppedException e) {
            return null;
        }
        return attempt.done((System.nanoTime() - start) * 1e-9);
    }

    private void stage(String name) {
        long now = System.nanoTime();
        stages.merge(name, (now - stageNs) * 1e-9, Double::sum);
        stageNs = now;
    }

    /** One input on its way. */
    private final class Attempt {
        private final CheckInput input;
        private final int number;
        private StoredResult computed;
        private Result result;
        private InputOutcome.Kind kind = InputOutcome.Kind.RESULT;
        private InputOutcome.Failure failure;
        private ResultFolder.UnwritableException unwritable;

        Attempt(CheckInput input, int number) {
            this.input = input;
            this.number = number;
        }

        void run() {
            try {
                if (input.refusal() != null) {
                    throw new InputRefusedException(input.file().toString(), input.refusal());
                }
                Read read = read(input);
                result = plan.storedOnly() ? judged(read, earlier.of(input, read.sha256()))
                        : keptOrChecked(read);
            } catch (InputRefusedException e) {
                failed(InputOutcome.Kind.REFUSED, refused(e));
            } catch (ResultFolder.UnwritableException e) {
                unwritable = e;
            } catch (StoppedException e) {
                throw e;
            } catch (RuntimeException | Error e) {
                // one photo must not cost the others their results
                Optional<Refusal> limit = MachineRefusal.behind(e);
                if (limit.isPresent()) {
                    failed(InputOutcome.Kind.REFUSED, refused(new InputRefusedException(
                            limit.get().withPlace(Place.of(input.file().toString())), e)));
                } else {
                    failed(InputOutcome.Kind.INTERNAL_ERROR, new InputOutcome.Failure("internal-error",
                            BatchCheck.inShort(e), null,
                            e instanceof RuntimeException error ? error : new IllegalStateException(e)));
                }
            }
        }

        private Result keptOrChecked(Read read) {
            StoredResult stored = earlier == null || plan.anew()
                    || !Files.exists(plan.folder().file(input.name() + ResultFolder.RESULT)) ? null
                    : earlier.asIfMadeNow(input, record(input, read.sha256()), plan.draws());
            return stored == null ? checked(read) : judged(read, stored);
        }

        private Result checked(Read read) {
            Found found = found(read);
            CheckResult sampled = sampled(found);
            stage("check");
            computed = new StoredResult(advised(ResultView.of(sampled, plan.words())),
                    record(input, read.sha256()));
            return withFiles(computed, found, sampled);
        }

        /** A stored result as the target and the files of now have it; what it says already stays as it is. */
        private Result judged(Read read, StoredResult stored) {
            stage("stored result");
            ResultView judged = stored.view().withTarget(plan.target());
            judged = judged == stored.view() ? judged : advised(judged);
            ResultRecord record = plan.cellFile().in(stored.record()).withCommand(plan.command().apply(input));
            boolean anew = !judged.equals(stored.view());
            computed = new StoredResult(judged, anew ? record.withJudgedOn(plan.day()) : record);
            if (plan.drawsUnwanted()) {
                plan.folder().deleteChainsFrom(input.name(), 1);
            }
            // whether a photo lay beside the corners when they were painted is not stored
            Found found = anew || plan.storedOnly() || input.isDetections() ? found(read) : null;
            if (anew || plan.storedOnly() || found != null && found.photo() != null) {
                return withFiles(computed, found, null);
            }
            if (!record.equals(stored.record())) {
                plan.folder().writeHeld(Map.of(input.name() + ResultFolder.RESULT, text(ResultJson.of(computed))));
            }
            byte[] jpeg = ofStoredPicture();
            if (jpeg == null) {
                return withFiles(computed, found == null ? found(read) : found, null);
            }
            stage("files");
            return new Result(computed, true, 0, section(computed).withPicture(jpeg));
        }

        /** With what would meet a target that is missed, unless that is not wanted. */
        private ResultView advised(ResultView view) {
            return plan.advice() ? view.withAdvice(AdviceView.of(cell, plan.settings(), view, plan.words())) : view;
        }

        /** The picture for the report, of the overlay in the folder; null where that is not what was written. */
        private byte[] ofStoredPicture() {
            try {
                PinholeCamera camera = computed.view().cell().camera();
                Optional<BufferedImage> stored = Pictures.read(ImageFiles.bytes(plan.folder().file(input.name()
                        + ResultFolder.OVERLAY)), camera.widthPx(), camera.heightPx());
                return stored.isEmpty() ? null : Pictures.jpeg(stored.get(), plan.reportWidthPx());
            } catch (IOException | RuntimeException e) {
                return null;
            }
        }

        /** Paints and writes a result; sampled is null where its draws are not to be touched. */
        private Result withFiles(StoredResult stored, Found found, CheckResult sampled) {
            if (plan.folder() == null) {
                return new Result(stored, sampled == null, 0, null);
            }
            // painted and encoded while the rest is written, unless one thread is all there may be
            Executor besides = plan.settings().sampling().threads() == 1 ? Runnable::run : InputWork::besides;
            CompletableFuture<BufferedImage> painted = CompletableFuture.supplyAsync(() -> OverlayPainter.paint(
                    found.photo(), CellOverlay.of(found.cell(), found.detections(), stored.view(), OverlayStyle.PHOTO)),
                    besides);
            CompletableFuture<byte[]> png = painted.thenApply(picture -> Pictures.png(picture, besides));
            CompletableFuture<byte[]> jpeg = painted.thenApplyAsync(this::jpeg, besides);
            PhotoSection section = section(stored);
            Map<String, WholeFiles.Content> files = new LinkedHashMap<>();
            int chains = sampled == null || plan.draws() == DrawFiles.NONE ? 0 : sampled.draws().size();
            int most = chains == 0 ? 0 : plan.draws().most(sampled);
            for (int i = 1; i <= chains; i++) {
                int chain = i;
                files.put(ResultFolder.chain(input.name(), chain), bytes -> {
                    Writer writer = new OutputStreamWriter(bytes, StandardCharsets.UTF_8);
                    StanCsv.write(sampled, chain, stored.record().inputName(), plan.version(), most, writer);
                    writer.flush();
                });
            }
            files.put(input.name() + ResultFolder.OVERLAY, bytes -> bytes.write(png.join()));
            files.put(input.name() + ResultFolder.RESULT, text(ResultJson.of(stored)));
            plan.folder().writeHeld(files);
            if (sampled != null) {
                plan.folder().deleteChainsFrom(input.name(), chains + 1);
            }
            stage("files");
            return new Result(stored, sampled == null, chains == 0 ? 0
                    : StanCsv.thin(sampled.draws().get(0).count(), most), section.withPicture(jpeg.join()));
        }

        private byte[] jpeg(BufferedImage picture) {
            try {
                return Pictures.jpeg(picture, plan.reportWidthPx());
            } catch (IOException e) {
                throw new IllegalStateException("encoding in memory failed", e);
            }
        }

        private PhotoSection section(StoredResult stored) {
            return PhotoSection.of(number, input, stored);
        }

        private void failed(InputOutcome.Kind what, InputOutcome.Failure why) {
            kind = what;
            failure = why;
            result = null;
            if (plan.folder() != null && !plan.storedOnly()) {
                // what an earlier run found must not be taken for the answer of this one
                try {
                    plan.folder().deleteResults(input.name());
                } catch (ResultFolder.UnwritableException e) {
                    unwritable = e;
                }
            }
        }

        Done done(double seconds) {
            StoredResult stored = result == null ? computed : result.stored();
            InputOutcome outcome = new InputOutcome(input, kind, stored,
                    stored == null ? record(input, null) : stored.record(), failure, result != null && result.isKept(),
                    result == null ? 0 : result.everyDraw(), number, plan.count(), seconds);
            PhotoSection section = plan.folder() == null || unwritable != null ? null
                    : result == null ? PhotoSection.of(number, input, outcome.word(), failure.message())
                    : result.section();
            return new Done(outcome, section, unwritable, new LinkedHashMap<>(stages));
        }
    }

    private InputOutcome.Failure refused(InputRefusedException e) {
        Refusal refusal = e.refusal();
        return new InputOutcome.Failure(refusal.kind().code(), plan.words().apply(refusal), refusal.place(), e);
    }

    private ResultRecord record(CheckInput input, String sha256) {
        Path name = input.file().getFileName();
        return plan.cellFile().in(ResultRecord.of(name == null ? input.file().toString() : name.toString(), sha256,
                plan.version())).withDate(plan.day()).withCommand(plan.command().apply(input));
    }

    private Read read(CheckInput input) {
        byte[] bytes = input.isDetections() ? DetectionsFile.bytes(input.file()) : ImageFiles.bytes(input.file());
        return new Read(input, bytes, CompletableFuture.supplyAsync(() -> Sha256.of(bytes),
                plan.settings().sampling().threads() == 1 ? Runnable::run : InputWork::besides));
    }

    private Found found(Read read) {
        String name = read.input().file().toString();
        if (read.input().isDetections()) {
            Detections detections = withRemarks(DetectionsFile.read(read.bytes(), name));
            Cell shown = shown(detections.widthPx(), detections.heightPx(), name);
            stage("detections file");
            return new Found(shown, withScale(detections), photoBeside(read.input().file(), detections));
        }
        GreyImage photo = ImageFiles.decode(read.bytes(), name, (width, height) -> shown(width, height, name));
        stage("image file");
        Cell shown = shown(photo.widthPx(), photo.heightPx(), name);
        if (detector == null || shown.camera().widthPx() != detectorWidthPx) {
            detector = BoofMarkerDetector.forCell(shown);
            detectorWidthPx = shown.camera().widthPx();
        }
        Detections detections = detector.detect(photo, name);
        stage("detection");
        return new Found(shown, withScale(detections), photo);
    }

    /** The cell in photos of a size. */
    private Cell shown(int widthPx, int heightPx, String name) {
        return InputChecks.ofSize(cell, widthPx, heightPx, name,
                plan.settings().model().get(SettingTable.SCALE_CAMERA));
    }

    /** With the remark that the camera was scaled, where it was. */
    private Detections withScale(Detections detections) {
        PinholeCamera stated = cell.camera();
        return detections.widthPx() == stated.widthPx() ? detections
                : with(detections, Warning.of(BatchWarning.CAMERA_SCALED, stated.widthPx(), stated.heightPx(),
                        detections.widthPx(), detections.heightPx()));
    }

    private static Detections with(Detections detections, Warning warning) {
        List<Warning> warnings = new ArrayList<>(detections.warnings());
        warnings.add(warning);
        return new Detections(detections.imageName(), detections.widthPx(), detections.heightPx(), detections.markers(),
                warnings, detections.light());
    }

    private static void besides(Runnable task) {
        Thread thread = new Thread(task, "cellgauge-besides");
        thread.setDaemon(true);
        thread.start();
    }

    private CheckResult sampled(Found found) {
        if (plan.stop().isGiven()) {
            throw new StoppedException();
        }
        CheckUpdate last = CellCheck.stream(found.cell(), found.detections(), plan.settings())
                .takeUntil(plan.stop().end()).lastElement().blockingGet();
        CheckResult result = last == null ? null : last.result();
        if (result == null) {
            throw new StoppedException();
        }
        return result;
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
        return foreign.isEmpty() ? detections
                : with(detections, Warning.of(BatchWarning.FOREIGN_MARKERS, Listing.comma(foreign)));
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

    private static WholeFiles.Content text(String text) {
        return bytes -> bytes.write(text.getBytes(StandardCharsets.UTF_8));
    }
}
