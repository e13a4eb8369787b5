package org.cellgauge.internal.sampling;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.reactivex.rxjava3.plugins.RxJavaPlugins;
import io.reactivex.rxjava3.schedulers.Schedulers;
import io.reactivex.rxjava3.subscribers.TestSubscriber;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.sampling.AcceptanceCount;
import org.cellgauge.sampling.Draws;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.sampling.QuantityLayout;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.parallel.Isolated;

@Isolated("counts threads, and takes over what RxJava does with lost errors")
@Timeout(60)
class ChainEnsembleTest {
    private static QuantityLayout layout() {
        QuantityLayout.Builder builder = new QuantityLayout.Builder();
        builder.add(Quantity.camera(Quantity.Axis.X));
        builder.addAngle(Quantity.camera(Quantity.Axis.PSI), 3.1);
        builder.group(0, 1);
        return builder.build();
    }

    /** A walk of its own stream: its draws depend on its number alone. */
    private static class Walk implements ChainProcess {
        final RandomGenerator random;
        final AtomicInteger steps = new AtomicInteger();
        final List<Integer> warmedUpAt = new ArrayList<>();
        double x;

        Walk(int chain) {
            random = RandomStreams.of(77, chain);
        }

        @Override
        public void step() {
            steps.incrementAndGet();
            x = 0.5 * x + random.nextGaussian();
        }

        @Override
        public void warmedUp() {
            warmedUpAt.add(steps.get());
        }

        @Override
        public void read(double[] out) {
            out[0] = 100 + x;
            out[1] = org.cellgauge.internal.statistics.Angles.wrapToPi(3.1 + 0.1 * x);
        }

        @Override
        public List<AcceptanceCount> acceptance() {
            return List.of(new AcceptanceCount("walk", steps.get(), 0), new AcceptanceCount("none", 0, 2));
        }
    }

    private static List<Walk> walks(int count) {
        List<Walk> list = new ArrayList<>();
        for (int c = 0; c < count; c++) {
            list.add(new Walk(c));
        }
        return list;
    }

    private static ChainEnsemble ensemble(List<? extends ChainProcess> processes, RunLength length, int threads) {
        return new ChainEnsemble(processes, layout(), length, draws -> 2 * draws.get(0).count(), threads);
    }

    @Test
    void drawsAreTheSameForAnyNumberOfThreads() {
        double[][] first = null;
        for (int threads : new int[] {1, 2, 4, 9}) {
            ChainEnsemble ensemble = ensemble(walks(4), new RunLength(100, 300, 1500), threads);
            EnsembleSnapshot last = ensemble.stream().blockingLast();
            double[][] all = new double[5][];
            for (int c = 0; c < 4; c++) {
                assertEquals(1400, ensemble.draws().get(c).count());
                all[c] = ensemble.draws().get(c).series(0);
            }
            all[4] = last.summary().mean(0);
            first = first == null ? all : first;
            for (int c = 0; c < 5; c++) {
                assertArrayEquals(first[c], all[c], 0);
            }
        }
        assertFalse(first[0][7] == first[1][7]);
    }

    /** One thread until the first snapshot; then all four chains wait for each other in the middle of a part. */
    @Test
    void theNumberOfThreadsMayChangeWhileChainsRun() {
        AtomicInteger threads = new AtomicInteger(1);
        AtomicInteger inside = new AtomicInteger();
        AtomicInteger most = new AtomicInteger();
        CyclicBarrier all = new CyclicBarrier(4);
        AtomicInteger together = new AtomicInteger();
        List<ChainProcess> processes = new ArrayList<>();
        for (int c = 0; c < 4; c++) {
            processes.add(new Walk(c) {
                @Override
                public void step() {
                    if (threads.get() == 1) {
                        most.accumulateAndGet(inside.incrementAndGet(), Math::max);
                        Thread.yield();
                        inside.decrementAndGet();
                    } else if (steps.get() == 700) {
                        try {
                            all.await(30, TimeUnit.SECONDS);
                            together.incrementAndGet();
                        } catch (Exception e) {
                            throw new IllegalStateException("alone", e);
                        }
                    }
                    super.step();
                }
            });
        }
        ChainEnsemble changing = new ChainEnsemble(processes, layout(), new RunLength(100, 1000, 1100), draws -> 0,
                threads::get);
        changing.stream().doOnNext(snapshot -> {
            assertEquals(1, most.get());
            threads.set(4);
        }).blockingLast();
        assertEquals(4, together.get());
        ChainEnsemble constant = ensemble(walks(4), new RunLength(100, 1000, 1100), 2);
        constant.stream().blockingLast();
        for (int c = 0; c < 4; c++) {
            assertArrayEquals(constant.draws().get(c).series(0), changing.draws().get(c).series(0), 0);
        }
    }

    @Test
    void lastSnapshotHoldsTheMomentsOfAllDrawsOfAllChains() {
        ChainEnsemble ensemble = ensemble(walks(3), new RunLength(50, 100, 1250), 2);
        EnsembleSnapshot last = ensemble.stream().blockingLast();
        assertTrue(last.last());
        assertEquals(1250, last.iterationsPerChain());
        assertEquals(3600, last.summary().count());
        List<double[]> all = new ArrayList<>();
        for (Draws draws : ensemble.draws()) {
            for (int i = 0; i < draws.count(); i++) {
                double angle = draws.get(1, i);
                // angles lie on both sides of pi: unrolled by hand
                all.add(new double[] {draws.get(0, i), angle < 0 ? angle + 2 * Math.PI : angle});
            }
        }
        double[] mean = new double[2];
        for (double[] d : all) {
            mean[0] += d[0] / all.size();
            mean[1] += d[1] / all.size();
        }
        double[][] covariance = new double[2][2];
        for (double[] d : all) {
            for (int a = 0; a < 2; a++) {
                for (int b = 0; b < 2; b++) {
                    covariance[a][b] += (d[a] - mean[a]) * (d[b] - mean[b]) / (all.size() - 1);
                }
            }
        }
        assertEquals(mean[0], last.summary().mean(0)[0], 1e-10);
        // mean direction, not mean: they differ by the third moment, 1e-3 of the spread here
        assertEquals(mean[1], last.summary().mean(0)[1], 1e-3);
        for (int a = 0; a < 2; a++) {
            assertArrayEquals(covariance[a], last.summary().covariance(0)[a], 1e-10);
        }
        assertEquals(2, last.acceptance().size());
        assertEquals(3 * 1250, last.acceptance().get(0).accepted());
        assertEquals(6, last.acceptance().get(1).rejected());
        assertThrows(UnsupportedOperationException.class, () -> last.acceptance().clear());
    }

    @Test
    void snapshotsComeInOrderAndStayAsTheyWere() {
        List<Integer> counts = new ArrayList<>();
        List<EnsembleSnapshot> snapshots = ensemble(walks(2), new RunLength(200, 1000, 2600), 2).stream()
                .doOnNext(s -> counts.add((int) s.summary().count())).toList().blockingGet();
        for (int i = 0; i < snapshots.size(); i++) {
            assertEquals(counts.get(i), (int) snapshots.get(i).summary().count());
            assertEquals(i == snapshots.size() - 1, snapshots.get(i).last());
            assertTrue(i == 0 || snapshots.get(i).iterationsPerChain() > snapshots.get(i - 1).iterationsPerChain());
            assertEquals(2 * Math.max(0, snapshots.get(i).iterationsPerChain() - 200), counts.get(i));
        }
        assertTrue(snapshots.size() >= 5);
    }

    @Test
    void slowSubscriberGetsTheLastSnapshot() {
        ChainEnsemble ensemble = ensemble(walks(2), new RunLength(0, 100, 5000), 2);
        TestSubscriber<EnsembleSnapshot> subscriber = ensemble.stream().test(0);
        subscriber.assertNoValues();
        subscriber.assertNotComplete();
        subscriber.request(1);
        subscriber.assertValueCount(1);
        assertTrue(subscriber.values().get(0).last());
        assertEquals(5000, subscriber.values().get(0).iterationsPerChain());
        subscriber.assertComplete();
    }

    @Test
    void roundsGoOnToWhatIsWantedUntilItSuffices() {
        List<Integer> asked = new ArrayList<>();
        List<Walk> walks = walks(2);
        ChainEnsemble ensemble = new ChainEnsemble(walks, layout(), new RunLength(100, 200, 100_000), draws -> {
            asked.add(draws.get(1).count());
            int count = draws.get(0).count();
            return count == 200 ? 250 : count >= 1000 ? count : 4 * count;
        }, 2);
        EnsembleSnapshot last = ensemble.stream().blockingLast();
        assertEquals(List.of(200, 250, 1000), asked);
        assertEquals(1100, last.iterationsPerChain());
        assertEquals(1100, walks.get(0).steps.get());
        assertEquals(List.of(100), walks.get(0).warmedUpAt);
        assertTrue(last.last());
    }

    @Test
    void capEndsTheRunWithoutAsking() {
        List<Integer> asked = new ArrayList<>();
        ChainEnsemble ensemble = new ChainEnsemble(walks(1), layout(), new RunLength(0, 200, 700), draws -> {
            asked.add(draws.get(0).count());
            return 2 * draws.get(0).count();
        }, 1);
        assertEquals(700, ensemble.stream().blockingLast().iterationsPerChain());
        assertEquals(List.of(200, 400), asked);
        // a single round as long as can be said
        assertEquals(300, ensemble(walks(1), new RunLength(10, Integer.MAX_VALUE, 300), 1).stream().blockingLast()
                .iterationsPerChain());
        for (int[] bad : new int[][] {{-1, 1, 10}, {0, 0, 10}, {10, 1, 10}, {10, 1, 5}}) {
            assertThrows(IllegalArgumentException.class, () -> new RunLength(bad[0], bad[1], bad[2]));
        }
    }

    @Test
    void cancellingStopsEveryChainWithinAHundredSteps() {
        TestSubscriber<EnsembleSnapshot> subscriber = new TestSubscriber<>();
        List<Walk> walks = new ArrayList<>();
        walks.add(new Walk(0) {
            @Override
            public void step() {
                super.step();
                if (steps.get() == 1200) {
                    subscriber.cancel();
                }
            }
        });
        walks.add(new Walk(1));
        // one thread: the second chain of the part in which the first one cancels comes after it
        ensemble(walks, new RunLength(0, 1_000_000, 1_000_000), 1).stream().subscribe(subscriber);
        assertTrue(walks.get(0).steps.get() < 1300, walks.get(0).steps + " steps");
        assertTrue(walks.get(1).steps.get() < 1100, walks.get(1).steps + " steps");
        subscriber.assertNotComplete();
        subscriber.assertNoErrors();
    }

    @Test
    void cancellingFromElsewhereLeavesNoErrorAndNoThreadBehind() throws InterruptedException {
        List<Throwable> undeliverable = new CopyOnWriteArrayList<>();
        RxJavaPlugins.setErrorHandler(undeliverable::add);
        try {
            for (int i = 0; i < 20; i++) {
                CountDownLatch running = new CountDownLatch(200);
                List<Walk> walks = new ArrayList<>();
                boolean failing = i % 2 == 0;
                TestSubscriber<EnsembleSnapshot> subscriber = new TestSubscriber<>();
                for (int c = 0; c < 3; c++) {
                    walks.add(new Walk(c) {
                        @Override
                        public void step() {
                            super.step();
                            running.countDown();
                            if (failing && subscriber.isCancelled()) {
                                throw new IllegalStateException("fails after the stream was cancelled");
                            }
                        }
                    });
                }
                ensemble(walks, new RunLength(0, 1000, Integer.MAX_VALUE), 2).stream()
                        .subscribeOn(Schedulers.io()).subscribe(subscriber);
                assertTrue(running.await(20, TimeUnit.SECONDS));
                subscriber.cancel();
                int before = -1;
                int now = walks.get(0).steps.get();
                while (before != now) {
                    TimeUnit.MILLISECONDS.sleep(20);
                    before = now;
                    now = walks.stream().mapToInt(w -> w.steps.get()).sum();
                }
                subscriber.assertNoErrors();
                subscriber.assertNotComplete();
            }
            long left = Thread.getAllStackTraces().keySet().stream().filter(t -> t.getName().equals("cellgauge-chain"))
                    .filter(Thread::isAlive).count();
            for (int i = 0; left > 0 && i < 200; i++) {
                TimeUnit.MILLISECONDS.sleep(20);
                left = Thread.getAllStackTraces().keySet().stream().filter(t -> t.getName().equals("cellgauge-chain"))
                        .filter(Thread::isAlive).count();
            }
            assertEquals(0, left);
            assertEquals(List.of(), undeliverable);
        } finally {
            RxJavaPlugins.reset();
        }
    }

    @Test
    void exceptionOfAChainEndsTheStreamWithIt() {
        IllegalStateException failure = new IllegalStateException("no such pose");
        for (int failing = 0; failing < 3; failing++) {
            List<Walk> walks = walks(3);
            walks.set(failing, new Walk(failing) {
                @Override
                public void step() {
                    super.step();
                    if (steps.get() == 700) {
                        throw failure;
                    }
                }
            });
            TestSubscriber<EnsembleSnapshot> subscriber = ensemble(walks, new RunLength(0, 5000, 5000), 2).stream()
                    .test();
            subscriber.assertError(failure);
            subscriber.assertNotComplete();
            assertFalse(subscriber.values().stream().anyMatch(EnsembleSnapshot::last));
        }
        Error error = new AssertionError("broken");
        ChainEnsemble broken = new ChainEnsemble(walks(1), layout(), new RunLength(0, 100, 200), draws -> {
            throw error;
        }, 1);
        broken.stream().test().assertError(error);
    }

    @Test
    void ensembleRunsOnce() {
        ChainEnsemble ensemble = ensemble(walks(2), new RunLength(0, 100, 200), 2);
        ensemble.stream().test().assertComplete();
        TestSubscriber<EnsembleSnapshot> second = ensemble.stream().test();
        second.assertNoValues();
        second.assertError(IllegalStateException.class);
        assertEquals(200, ensemble.draws().get(0).count());
    }

    @Test
    void layoutNamesItsQuantities() {
        QuantityLayout layout = layout();
        assertEquals(List.of("camera_x_mm", "camera_psi_rad"), layout.names());
        assertEquals(1, layout.indexOf(Quantity.camera(Quantity.Axis.PSI)));
        assertTrue(layout.isAngle(1));
        assertFalse(layout.isAngle(0));
        assertEquals(3.1, layout.referenceRad(1), 0);
        assertThrows(IllegalArgumentException.class, () -> layout.indexOf(Quantity.camera(Quantity.Axis.Y)));
        QuantityLayout.Builder twice = new QuantityLayout.Builder();
        twice.add(Quantity.ADDED_NOISE);
        assertThrows(IllegalArgumentException.class, () -> twice.add(Quantity.ADDED_NOISE));
        assertSame(layout, new RunningSummary(layout).layout());
    }
}
