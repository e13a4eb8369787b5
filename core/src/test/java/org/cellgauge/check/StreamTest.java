package org.cellgauge.check;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.reactivex.rxjava3.schedulers.Schedulers;
import io.reactivex.rxjava3.subscribers.TestSubscriber;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.sampling.Draws;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Estimate;
import org.cellgauge.settings.SamplerKind;
import org.cellgauge.vision.Detections;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** What a check promises of its course: same figures whatever the threads, updates in order, an end when asked for. */
@Isolated("looks for threads that are left")
class StreamTest {
    private static final ThesisScene SCENE = ThesisScene.inPlane(3);
    private static final Detections NOISY = SCENE.detections(0.3, RandomStreams.of(3), 5, 0.01);

    private static CheckResult run(CheckSettings.Builder settings) {
        return CellCheck.run(SCENE.cell(), NOISY, settings.build());
    }

    private static void assertSameDraws(CheckResult a, CheckResult b) {
        assertEquals(a.draws().size(), b.draws().size());
        for (int c = 0; c < a.draws().size(); c++) {
            for (int q = 0; q < a.layout().size(); q++) {
                assertArrayEquals(a.draws().get(c).series(q), b.draws().get(c).series(q));
            }
        }
        for (int o = 0; o < 3; o++) {
            assertArrayEquals(a.estimate().objects().get(o).pose().mean(), b.estimate().objects().get(o).pose().mean());
            assertArrayEquals(a.estimate().objects().get(o).pose().tangentCovariance(),
                    b.estimate().objects().get(o).pose().tangentCovariance());
        }
        assertEquals(a.reason(), b.reason());
        assertEquals(a.warnings(), b.warnings());
        assertEquals(a.diagnostics().rHatMax(), b.diagnostics().rHatMax());
    }

    @ParameterizedTest
    @EnumSource(SamplerKind.class)
    void figuresDoNotDependOnTheNumberOfThreads(SamplerKind sampler) {
        CheckSettings.Builder settings = CheckSettings.builder().sampler(sampler).iterations(1200).warmup(300).seed(5);
        CheckResult one = run(settings.threads(1));
        assertSameDraws(one, run(settings.threads(2)));
        assertSameDraws(one, run(settings.threads(4)));
    }

    @Test
    void figuresOfARunOfOpenLengthDoNotDependOnTheNumberOfThreads() {
        CheckSettings.Builder settings = CheckSettings.builder().seed(6).estimate(Estimate.FOCAL);
        CheckResult one = run(settings.threads(1));
        CheckResult four = run(settings.threads(4));
        assertEquals(one.iterationsPerChain(), four.iterationsPerChain());
        assertSameDraws(one, four);
    }

    @Test
    void sameSeedGivesSameDrawsAndAnotherSeedOthers() {
        CheckSettings.Builder settings = CheckSettings.builder().iterations(1200);
        CheckResult first = run(settings.seed(7));
        assertSameDraws(first, run(settings.seed(7)));
        CheckResult other = run(settings.seed(8));
        int z = first.layout().indexOf(Quantity.object(5, Quantity.Axis.Z));
        double[] a = first.draws().get(0).series(z);
        double[] b = other.draws().get(0).series(z);
        int equal = 0;
        for (int i = 0; i < a.length; i++) {
            equal += a[i] == b[i] ? 1 : 0;
        }
        assertEquals(0, equal);
    }

    @Test
    void chainsOfOneRunDiffer() {
        List<Draws> draws = run(CheckSettings.builder().iterations(1200)).draws();
        int z = 3;
        for (int c = 1; c < draws.size(); c++) {
            assertTrue(draws.get(0).get(z, 500) != draws.get(c).get(z, 500));
        }
    }

    @Test
    void quickLookComesFirstThenSamplingThenTheResultAlone() {
        List<CheckUpdate> updates = CellCheck.stream(SCENE.cell(), NOISY,
                CheckSettings.builder().iterations(6_000).build()).toList().blockingGet();
        assertTrue(updates.size() >= 3, updates.size() + " updates");
        int last = updates.size() - 1;
        assertEquals(CheckUpdate.Phase.QUICK_LOOK, updates.get(0).phase());
        assertEquals(0, updates.get(0).iterationsPerChain());
        for (int i = 1; i < last; i++) {
            assertEquals(CheckUpdate.Phase.SAMPLING, updates.get(i).phase());
            assertNull(updates.get(i).result());
            assertTrue(updates.get(i).iterationsPerChain() >= updates.get(i - 1).iterationsPerChain());
        }
        assertEquals(CheckUpdate.Phase.RESULT, updates.get(last).phase());
        assertNotNull(updates.get(last).result());
        assertEquals(6_000, updates.get(last).result().iterationsPerChain());
    }

    @Test
    void cancellingStopsTheChains() throws InterruptedException {
        CheckSettings endless = CheckSettings.builder().sampler(SamplerKind.ADAPTIVE).iterations(500_000_000)
                .warmup(1000).threads(2).build();
        Thread[] worker = new Thread[1];
        TestSubscriber<CheckUpdate> subscriber = CellCheck.stream(SCENE.cell(), NOISY, endless)
                .subscribeOn(Schedulers.newThread())
                .doOnNext(u -> worker[0] = Thread.currentThread())
                .test();
        subscriber.awaitCount(3);
        subscriber.cancel();
        int chains = chainSteps();
        // what ran on may end its batch; then no thread is left in a chain
        for (int i = 0; i < 100 && chains > 0; i++) {
            TimeUnit.MILLISECONDS.sleep(50);
            chains = chainSteps();
        }
        assertEquals(0, chains);
        assertFalse(subscriber.values().stream().anyMatch(u -> u.result() != null));
    }

    /** Threads that are in a chain just now. */
    private static int chainSteps() {
        int count = 0;
        for (StackTraceElement[] stack : Thread.getAllStackTraces().values()) {
            for (StackTraceElement frame : stack) {
                if (frame.getClassName().endsWith("MetropolisChain")) {
                    count++;
                    break;
                }
            }
        }
        return count;
    }

    @Test
    void slowSubscriberGetsTheQuickLookAndTheResult() {
        TestSubscriber<CheckUpdate> slow = CellCheck.stream(SCENE.cell(), NOISY,
                CheckSettings.builder().iterations(6_000).build()).test(1);
        // the stream has run to its end on this thread; all that was not asked for has been dropped but the newest
        slow.assertValueCount(1);
        slow.assertNotComplete();
        assertEquals(CheckUpdate.Phase.QUICK_LOOK, slow.values().get(0).phase());
        slow.request(1);
        slow.assertValueCount(2);
        slow.assertComplete();
        assertEquals(CheckUpdate.Phase.RESULT, slow.values().get(1).phase());
    }

    @Test
    void eachSubscriptionRunsAnew() {
        var stream = CellCheck.stream(SCENE.cell(), NOISY, CheckSettings.builder().iterations(1200).build());
        CheckResult first = stream.blockingLast().result();
        CheckResult second = stream.blockingLast().result();
        assertTrue(first != second);
        assertSameDraws(first, second);
    }
}
