package org.cellgauge.live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.reactivex.rxjava3.core.Scheduler;
import io.reactivex.rxjava3.plugins.RxJavaPlugins;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.cellgauge.internal.live.IdleThreads;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;

@Isolated("counts threads, and takes over what RxJava does with lost errors")
class IdleThreadsTest {
    private static long threads(String name) {
        return Thread.getAllStackTraces().keySet().stream().filter(t -> t.isAlive() && t.getName().equals(name))
                .count();
    }

    private static void awaitNoThread(String name) throws InterruptedException {
        for (int i = 0; i < 500 && threads(name) > 0; i++) {
            TimeUnit.MILLISECONDS.sleep(10);
        }
        assertEquals(0, threads(name));
    }

    /** What a scheduler with an end of its own does not do: most rounds of this race end with a refused task there. */
    @Test
    void aTaskThatComesWhileItsWorkerIsDisposedIsNoError() throws InterruptedException {
        for (Scheduler scheduler : List.of(IdleThreads.one("idle-race"), IdleThreads.oneForEachWorker("idle-race"))) {
            assertEquals(List.of(), errorsOfRace(scheduler, 300));
        }
        awaitNoThread("idle-race");
    }

    private static List<Throwable> errorsOfRace(Scheduler scheduler, int rounds) throws InterruptedException {
        List<Throwable> lost = new CopyOnWriteArrayList<>();
        RxJavaPlugins.setErrorHandler(lost::add);
        try {
            for (int round = 0; round < rounds; round++) {
                Scheduler.Worker worker = scheduler.createWorker();
                CountDownLatch running = new CountDownLatch(50);
                Thread busy = new Thread(() -> {
                    while (!worker.isDisposed()) {
                        worker.schedule(() -> { });
                        running.countDown();
                    }
                });
                busy.start();
                running.await();
                worker.dispose();
                busy.join();
            }
        } finally {
            RxJavaPlugins.setErrorHandler(null);
        }
        return lost;
    }

    @Test
    void tasksOfOneThreadRunInTheOrderInWhichTheyCame() throws InterruptedException {
        Scheduler.Worker worker = IdleThreads.one("idle-order").createWorker();
        List<Integer> order = new CopyOnWriteArrayList<>();
        List<Integer> expected = new ArrayList<>();
        CountDownLatch done = new CountDownLatch(1);
        for (int i = 0; i < 100; i++) {
            int number = i;
            expected.add(i);
            worker.schedule(() -> order.add(number));
        }
        worker.schedule(done::countDown, 1, TimeUnit.MILLISECONDS);
        assertTrue(done.await(10, TimeUnit.SECONDS));
        assertEquals(expected, order);
        assertTrue(threads("idle-order") <= 1);
        awaitNoThread("idle-order");
        // and another one comes when there is something to do again
        CountDownLatch again = new CountDownLatch(1);
        worker.schedule(again::countDown);
        assertTrue(again.await(10, TimeUnit.SECONDS));
        awaitNoThread("idle-order");
    }

    @Test
    void disposingAWorkerWithAThreadOfItsOwnInterruptsIt() throws InterruptedException {
        Scheduler scheduler = IdleThreads.oneForEachWorker("idle-interrupt");
        Scheduler.Worker first = scheduler.createWorker();
        Scheduler.Worker second = scheduler.createWorker();
        CountDownLatch begun = new CountDownLatch(2);
        CountDownLatch ended = new CountDownLatch(1);
        AtomicBoolean interrupted = new AtomicBoolean();
        first.schedule(() -> {
            begun.countDown();
            try {
                TimeUnit.SECONDS.sleep(60);
            } catch (InterruptedException e) {
                interrupted.set(true);
            }
            ended.countDown();
        });
        // does not wait for the first one
        second.schedule(begun::countDown);
        assertTrue(begun.await(10, TimeUnit.SECONDS));
        first.dispose();
        assertTrue(ended.await(10, TimeUnit.SECONDS));
        assertTrue(interrupted.get());
        second.dispose();
        awaitNoThread("idle-interrupt");
    }
}
