package org.cellgauge.internal.sampling;

import io.reactivex.rxjava3.core.BackpressureStrategy;
import io.reactivex.rxjava3.core.Flowable;
import io.reactivex.rxjava3.core.FlowableEmitter;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntSupplier;
import java.util.function.ToIntFunction;
import org.cellgauge.sampling.AcceptanceCount;
import org.cellgauge.sampling.Draws;
import org.cellgauge.sampling.QuantityLayout;

/**
 * Several chains run in parallel, round by round, as a stream of snapshots.
 *
 * <p>In a round every chain takes the same number of steps; chains share nothing, so the draws are the same whatever
 * the number of threads. After each part of a round the running statistics of all chains are merged in the order of the
 * chains and published. At the end of a round, when enough draws are there by the caller's rule or the cap is reached,
 * the stream ends.
 *
 * <p>An ensemble runs once: a second subscription is refused.
 */
public final class ChainEnsemble {
    private static final int CANCEL_CHECK_EVERY = 64;
    private static final int PUBLISH_EVERY = 500;

    private final List<? extends ChainProcess> processes;
    private final QuantityLayout layout;
    private final RunLength length;
    private final ToIntFunction<List<Draws>> wanted;
    private final IntSupplier threads;
    private final List<Draws> draws = new ArrayList<>();
    private final List<RunningSummary> summaries = new ArrayList<>();
    private final java.util.concurrent.atomic.AtomicBoolean started = new java.util.concurrent.atomic.AtomicBoolean();

    /**
     * An ensemble.
     *
     * @param processes one per chain
     * @param layout quantities of their draws
     * @param length warm-up, rounds and cap
     * @param wanted asked at the end of each round with the draws of all chains how many of each are wanted: no more
     *     than there are where they suffice
     * @param threads number of threads, at least 1
     */
    public ChainEnsemble(List<? extends ChainProcess> processes, QuantityLayout layout, RunLength length,
            ToIntFunction<List<Draws>> wanted, int threads) {
        this(processes, layout, length, wanted, () -> threads);
    }

    /**
     * An ensemble whose number of threads may change while it runs.
     *
     * @param processes one per chain
     * @param layout quantities of their draws
     * @param length warm-up, rounds and cap
     * @param wanted asked at the end of each round with the draws of all chains how many of each are wanted: no more
     *     than there are where they suffice
     * @param threads asked before each part of a round, so that a device that gets warm can step down
     */
    public ChainEnsemble(List<? extends ChainProcess> processes, QuantityLayout layout, RunLength length,
            ToIntFunction<List<Draws>> wanted, IntSupplier threads) {
        this.processes = Collections.unmodifiableList(new ArrayList<>(processes));
        this.layout = layout;
        this.length = length;
        this.wanted = wanted;
        this.threads = threads;
        for (int i = 0; i < processes.size(); i++) {
            draws.add(new Draws(layout));
            summaries.add(new RunningSummary(layout));
        }
    }

    /**
     * Runs the chains.
     *
     * <dl>
     * <dt><b>Backpressure:</b></dt>
     * <dd>Latest value: a slow subscriber misses snapshots but always gets the newest and the last one.</dd>
     * <dt><b>Scheduler:</b></dt>
     * <dd>Rounds are led on the thread that subscribes; chains step on threads of their own, which end with the
     * stream.</dd>
     * <dt><b>Error handling:</b></dt>
     * <dd>An exception of a chain ends the stream with it. Cancelling stops all chains within a few dozen steps.</dd>
     * </dl>
     *
     * @return snapshots, the last one marked as such
     */
    public Flowable<EnsembleSnapshot> stream() {
        return Flowable.create(this::run, BackpressureStrategy.LATEST);
    }

    /**
     * The kept draws of each chain.
     *
     * @return complete once the stream has ended; not to be read before
     */
    public List<Draws> draws() {
        return Collections.unmodifiableList(draws);
    }

    private void run(FlowableEmitter<EnsembleSnapshot> emitter) {
        if (!started.compareAndSet(false, true)) {
            emitter.tryOnError(new IllegalStateException("an ensemble runs once"));
            return;
        }
        ExecutorService executor = Executors.newCachedThreadPool(task -> {
            Thread thread = new Thread(task, "cellgauge-chain");
            thread.setDaemon(true);
            return thread;
        });
        try {
            int done = 0;
            int roundEnd = (int) Math.min(length.iterations(), (long) length.warmup() + length.firstRound());
            while (!emitter.isCancelled()) {
                int partEnd = Math.min(roundEnd, done + PUBLISH_EVERY);
                advance(executor, emitter, done, partEnd);
                done = partEnd;
                if (emitter.isCancelled()) {
                    return;
                }
                boolean last = false;
                if (done == roundEnd) {
                    last = done == length.iterations();
                    int kept = done - length.warmup();
                    int asked = last ? kept : wanted.applyAsInt(draws());
                    last |= asked <= kept;
                    roundEnd = (int) Math.min(length.iterations(), (long) length.warmup() + asked);
                }
                emitter.onNext(snapshot(done, last));
                if (last) {
                    emitter.onComplete();
                    return;
                }
            }
        } catch (ExecutionException e) {
            emitter.tryOnError(e.getCause());
        } catch (InterruptedException e) {
            // a cancelled subscription interrupts this thread; that is no error then
            Thread.currentThread().interrupt();
            emitter.tryOnError(e);
        } finally {
            executor.shutdownNow();
        }
    }

    private void advance(ExecutorService executor, FlowableEmitter<EnsembleSnapshot> emitter, int from, int to)
            throws InterruptedException, ExecutionException {
        List<Future<?>> parts = new ArrayList<>();
        AtomicInteger next = new AtomicInteger();
        int workers = Math.max(1, Math.min(threads.getAsInt(), processes.size()));
        for (int w = 0; w < workers; w++) {
            parts.add(executor.submit(() -> {
                for (int chain = next.getAndIncrement(); chain < processes.size(); chain = next.getAndIncrement()) {
                    advance(chain, emitter, from, to);
                }
            }));
        }
        ExecutionException failure = null;
        for (Future<?> part : parts) {
            try {
                part.get();
            } catch (ExecutionException e) {
                failure = failure == null ? e : failure;
            }
        }
        if (failure != null) {
            throw failure;
        }
    }

    private void advance(int chain, FlowableEmitter<EnsembleSnapshot> emitter, int from, int to) {
        ChainProcess process = processes.get(chain);
        Draws kept = draws.get(chain);
        RunningSummary summary = summaries.get(chain);
        double[] quantities = new double[layout.size()];
        for (int i = from; i < to; i++) {
            if (i % CANCEL_CHECK_EVERY == 0 && emitter.isCancelled()) {
                return;
            }
            if (i == length.warmup()) {
                process.warmedUp();
            }
            process.step();
            if (i >= length.warmup()) {
                process.read(quantities);
                kept.add(quantities);
                summary.add(quantities);
            }
        }
    }

    private EnsembleSnapshot snapshot(int done, boolean last) {
        RunningSummary merged = new RunningSummary(layout);
        summaries.forEach(merged::merge);
        Map<String, AcceptanceCount> counts = new LinkedHashMap<>();
        for (ChainProcess process : processes) {
            for (AcceptanceCount count : process.acceptance()) {
                counts.merge(count.proposal(), count, AcceptanceCount::plus);
            }
        }
        return new EnsembleSnapshot(done, merged, new ArrayList<>(counts.values()), last);
    }
}
