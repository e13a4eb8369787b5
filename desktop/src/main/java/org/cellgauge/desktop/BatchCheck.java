package org.cellgauge.desktop;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Collections;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.FutureTask;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.Lock;
import java.util.concurrent.locks.ReadWriteLock;
import java.util.concurrent.locks.ReentrantReadWriteLock;
import java.util.function.Function;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.Target;
import org.cellgauge.internal.vision.BoofThreads;
import org.cellgauge.internal.warning.Printable;
import org.cellgauge.output.CellView;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.warning.Message;

/**
 * Checks photos and detections files of one cell, several at once, and writes what it finds into a folder: result file,
 * overlay and draws of each, summary and report of all. One input that cannot be used does not cost the others their
 * results; what an earlier run left of the same is kept; a run that ends early leaves summary and report of what was
 * done. However many inputs there are, the memory holds a few of them at a time.
 *
 * <p>Same inputs, cell, settings and day: same bytes, whatever the number of threads.
 */
public final class BatchCheck {
    /** How far the threads may be ahead of the first input that is not done, in inputs for each. */
    private static final int AHEAD = 4;
    private static final int LARGE_PICTURE_PX = 1280;
    private static final int MEDIUM_PICTURE_PX = 640;
    private static final int SMALL_PICTURE_PX = 320;
    private static final String SUMMARY = "summary.csv";
    private static final int FEW = 24;
    private static final int MANY = 200;

    private final Builder with;
    private final Cell cell;
    private final Target target;

    private BatchCheck(Builder builder) {
        with = builder;
        OptionalDouble asked = builder.settings.model().targetStdMm();
        target = asked.isPresent() ? Target.ofStdMm(asked) : builder.cellFile.cell().target();
        cell = builder.cellFile.cell().withTarget(target);
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
        private boolean anew;
        private DrawFiles draws;
        private boolean advice = true;
        private StopSignal stop = new StopSignal();

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
         * Sets whether results that miss their target say which changes of the set-up would meet it.
         *
         * @param value true, which is usual, costs some milliseconds for each of them
         * @return this
         */
        public Builder advice(boolean value) {
            advice = value;
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
         * Sets which draws are written into files.
         *
         * @param value where none is set, a bounded number for a single input, and none of a folder or list
         * @return this
         */
        public Builder draws(DrawFiles value) {
            draws = value;
            return this;
        }

        /**
         * Checks all inputs anew. Otherwise results that the folder holds of the same bytes, cell, settings and version
         * are kept, and held against the target as it is now.
         *
         * @return this
         */
        public Builder anew() {
            anew = true;
            return this;
        }

        /**
         * Sets what ends the batch early.
         *
         * @param value when it is given, what is done is written, and the batch ends
         * @return this
         */
        public Builder stop(StopSignal value) {
            stop = value;
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

    /** What the work on each input of a run needs to know. */
    record Plan(CellFile cellFile, Cell cell, Target target, CheckSettings settings, ResultFolder folder,
            String version, String day, Function<? super Message, String> words, Function<CheckInput, String> command,
            DrawFiles draws, boolean drawsUnwanted, boolean advice, boolean storedOnly, boolean anew,
            StopSignal stop, int count) {
        /** Reports of many photos must stay small enough to open. */
        int reportWidthPx() {
            return count <= FEW ? LARGE_PICTURE_PX : count <= MANY ? MEDIUM_PICTURE_PX : SMALL_PICTURE_PX;
        }
    }

    /**
     * Checks inputs.
     *
     * @param inputs what to check
     * @return what became of all, also where the folder took no more at some point: the batch ends there
     * @throws ResultFolder.UnwritableException if the folder takes nothing from the beginning, or another run has it
     */
    public BatchOutcome run(CheckInput.Inputs inputs) {
        BoofThreads.useOne();
        if (with.folder == null) {
            return new Run(inputs).all();
        }
        ResultFolder.Hold hold = with.folder.hold();
        try (hold; Run run = new Run(inputs)) {
            return run.all();
        }
    }

    /** One run over inputs: what it writes, and what it counts. */
    private final class Run implements AutoCloseable {
        private final List<CheckInput> inputs;
        private final boolean isBatch;
        private final Plan plan;
        private final int workers;
        private final ReadWriteLock memory = new ReentrantReadWriteLock();
        private final Map<String, Integer> byWord = new LinkedHashMap<>();
        private GrowingFile summary;
        private ReportPages report;
        private boolean withResult;
        private int done;
        private int kept;
        /** Why the folder takes no more; the threads ask for it. */
        private volatile ResultFolder.UnwritableException unwritable;

        Run(CheckInput.Inputs named) {
            inputs = named.inputs();
            isBatch = named.isBatch();
            int threads = with.settings.sampling().threads();
            workers = Math.max(1, Math.min(threads, inputs.size()));
            DrawFiles draws = with.draws != null ? with.draws : isBatch ? DrawFiles.NONE : DrawFiles.BOUNDED;
            plan = new Plan(with.cellFile, cell, target,
                    with.settings.toBuilder().threads(Math.max(1, threads / workers)).build(), with.folder,
                    with.version, with.day, with.words, with.command, draws, with.draws == DrawFiles.NONE,
                    with.advice, with.storedOnly, with.anew, with.stop, inputs.size());
            if (with.folder != null) {
                try {
                    summary = new GrowingFile(with.folder.file(SUMMARY), 0);
                    summary.append(SummaryCsv.header());
                } catch (IOException e) {
                    close();
                    throw with.folder.unwritable(e);
                }
                report = new ReportPages(new HtmlReport(with.cellFile, CellView.of(cell), target, with.version,
                        with.day, named.remarks()), with.folder.path(), inputs.size());
            }
        }

        BatchOutcome all() {
            AtomicInteger threads = new AtomicInteger();
            ExecutorService pool = workers == 1 ? null : Executors.newFixedThreadPool(workers, task -> {
                Thread thread = new Thread(task, "cellgauge-input-" + threads.incrementAndGet());
                thread.setDaemon(true);
                return thread;
            });
            ThreadLocal<InputWork> work = ThreadLocal.withInitial(() -> new InputWork(plan));
            Deque<Future<InputWork.Done>> ahead = new ArrayDeque<>();
            try {
                int next = 0;
                while (true) {
                    while (ahead.size() < (pool == null ? 1 : AHEAD * workers) && next < inputs.size()
                            && !plan.stop().isGiven() && unwritable == null) {
                        int index = next++;
                        FutureTask<InputWork.Done> task = new FutureTask<>(() -> work(work.get(), index));
                        ahead.add(task);
                        if (pool == null) {
                            task.run();
                        } else {
                            pool.execute(task);
                        }
                    }
                    if (ahead.isEmpty()) {
                        break;
                    }
                    InputWork.Done one = result(ahead.remove());
                    if (one != null) {
                        add(one);
                    }
                }
            } finally {
                work.remove();
                if (pool != null) {
                    pool.shutdownNow();
                }
            }
            String total = outcome(Optional.empty()).total();
            Optional<Path> reported = with.folder != null && (isBatch || withResult) ? finished(total)
                    : Optional.empty();
            return outcome(reported);
        }

        private BatchOutcome outcome(Optional<Path> reported) {
            return new BatchOutcome(inputs.size(), done, kept, Collections.unmodifiableMap(byWord), reported,
                    Optional.ofNullable(unwritable));
        }

        /** An input that the memory is too small for beside others is tried again alone. */
        private InputWork.Done work(InputWork work, int index) {
            InputWork.Done one = locked(memory.readLock(), work, index);
            boolean isShort = one != null && one.outcome().refusal() != null
                    && one.outcome().refusal().code().equals(MachineRefusal.MEMORY.code());
            return isShort && workers > 1 ? locked(memory.writeLock(), work, index) : one;
        }

        private InputWork.Done locked(Lock lock, InputWork work, int index) {
            lock.lock();
            try {
                // what the folder takes no more of need not be made
                return unwritable == null ? work.on(inputs.get(index), index + 1) : null;
            } finally {
                lock.unlock();
            }
        }

        private InputWork.Done result(Future<InputWork.Done> task) {
            try {
                return task.get();
            } catch (ExecutionException e) {
                // work keeps its errors in its outcome; this one is of no input
                throw e.getCause() instanceof RuntimeException error ? error : new IllegalStateException(e.getCause());
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                throw new IllegalStateException("interrupted", e);
            }
        }

        private void add(InputWork.Done one) {
            InputOutcome outcome = one.outcome();
            if (one.unwritable() == null && with.folder != null) {
                try {
                    summary.append(outcome.kind() == InputOutcome.Kind.RESULT
                            ? SummaryCsv.rows(outcome.input(), outcome.view())
                            : SummaryCsv.row(outcome.input(), outcome.word(), outcome.refusal().message()));
                    report.add(outcome.number(), one.section(),
                            outcome.kind() == InputOutcome.Kind.RESULT ? outcome.view() : null);
                } catch (IOException e) {
                    unwritable = unwritable == null ? with.folder.unwritable(e) : unwritable;
                }
            }
            if (one.unwritable() != null) {
                unwritable = unwritable == null ? one.unwritable() : unwritable;
            } else {
                done++;
                kept += outcome.isKept() && !plan.storedOnly() ? 1 : 0;
                byWord.merge(outcome.word(), 1, Integer::sum);
                withResult |= outcome.kind() == InputOutcome.Kind.RESULT;
            }
            one.stages().forEach(with.listener::stage);
            // what was computed is told also where it could not be written
            if (one.unwritable() == null || outcome.result() != null) {
                with.listener.finished(outcome);
            }
        }

        /** Ends summary and report, elsewhere if the folder takes them no more. */
        private Optional<Path> finished(String total) {
            long start = System.nanoTime();
            try {
                finish(total, with.folder.path());
                with.listener.stage("report", (System.nanoTime() - start) * 1e-9);
                return Optional.of(with.folder.path());
            } catch (IOException e) {
                unwritable = unwritable == null ? with.folder.unwritable(e) : unwritable;
            }
            try {
                Path elsewhere = Files.createTempDirectory("cellgauge-report-");
                finish(total, elsewhere);
                return Optional.of(elsewhere);
            } catch (IOException e) {
                return Optional.empty();
            }
        }

        private void finish(String total, Path folder) throws IOException {
            // the folder may have been removed
            Files.createDirectories(folder);
            summary.moveTo(folder.resolve(SUMMARY));
            report.finish(total, folder);
        }

        @Override
        public void close() {
            try {
                if (summary != null) {
                    summary.close();
                }
                if (report != null) {
                    report.close();
                }
            } catch (IOException e) {
                // files that nobody needs: the next run deletes them
            }
        }
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
