package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class SharedLoopTest {
    private final ExecutorService helpers = Executors.newFixedThreadPool(3);

    private final List<SharedLoop> loops = new ArrayList<>();

    @AfterEach
    void end() throws InterruptedException {
        loops.forEach(SharedLoop::dismiss);
        helpers.shutdown();
        // those who are let go leave
        assertTrue(helpers.awaitTermination(1, TimeUnit.MINUTES));
    }

    private SharedLoop spread() {
        SharedLoop loop = new SharedLoop();
        loop.spread(helpers, 4);
        loop.gather();
        loops.add(loop);
        return loop;
    }

    @Test
    void eachIsDoneOnceAndAllBeforeItReturns() {
        SharedLoop loop = spread();
        for (int round = 0; round < 200; round++) {
            AtomicIntegerArray done = new AtomicIntegerArray(7);
            loop.each(7, i -> {
                // long enough for helpers to be in the midst of one when no other is left
                LockSupport.parkNanos(50_000);
                done.incrementAndGet(i);
            });
            for (int i = 0; i < 7; i++) {
                assertEquals(1, done.get(i));
            }
        }
    }

    /** Two that wait for each other end only where two threads have them. */
    @Test
    void helpersWorkBesideTheCallingThread() {
        CountDownLatch both = new CountDownLatch(2);
        Set<Thread> threads = ConcurrentHashMap.newKeySet();
        spread().each(2, i -> {
            threads.add(Thread.currentThread());
            both.countDown();
            try {
                assertTrue(both.await(1, TimeUnit.MINUTES));
            } catch (InterruptedException e) {
                throw new IllegalStateException(e);
            }
        });
        assertEquals(2, threads.size());
    }

    @Test
    void whatOneThrowsIsThrownWhenAllOthersAreDone() {
        IllegalStateException thrown = new IllegalStateException("of the third");
        AtomicIntegerArray done = new AtomicIntegerArray(20);
        assertSame(thrown, assertThrows(IllegalStateException.class, () -> spread().each(20, i -> {
            if (i == 2) {
                throw thrown;
            }
            done.incrementAndGet(i);
        })));
        for (int i = 0; i < 20; i++) {
            assertEquals(i == 2 ? 0 : 1, done.get(i));
        }
    }

    @Test
    void anInterruptedCallerGetsItsMarkersAndStaysInterrupted() {
        AtomicIntegerArray done = new AtomicIntegerArray(7);
        Thread.currentThread().interrupt();
        spread().each(7, done::incrementAndGet);
        assertTrue(Thread.interrupted());
        assertFalse(Thread.interrupted());
        for (int i = 0; i < 7; i++) {
            assertEquals(1, done.get(i));
        }
    }
}
