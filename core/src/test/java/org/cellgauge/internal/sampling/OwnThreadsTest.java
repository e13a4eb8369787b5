package org.cellgauge.internal.sampling;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicIntegerArray;
import org.junit.jupiter.api.Test;

class OwnThreadsTest {
    @Test
    void everyTaskIsDoneOnce() {
        for (int threads : new int[] {1, 2, 7, 500}) {
            AtomicIntegerArray done = new AtomicIntegerArray(100);
            OwnThreads.forEach(100, threads, done::incrementAndGet);
            for (int i = 0; i < 100; i++) {
                assertEquals(1, done.get(i));
            }
        }
        OwnThreads.forEach(0, 3, i -> {
            throw new AssertionError(i);
        });
    }

    /** Each task waits for all others: they end only if so many threads are at work at once. */
    @Test
    void asManyThreadsWorkAsWereAskedFor() {
        CountDownLatch all = new CountDownLatch(3);
        Set<Thread> threads = ConcurrentHashMap.newKeySet();
        OwnThreads.forEach(3, 3, i -> {
            threads.add(Thread.currentThread());
            all.countDown();
            try {
                assertTrue(all.await(10, TimeUnit.SECONDS));
            } catch (InterruptedException e) {
                throw new IllegalStateException(e);
            }
        });
        assertEquals(3, threads.size());
        assertTrue(threads.remove(Thread.currentThread()));
        threads.forEach(thread -> assertFalse(thread.isAlive()));
    }

    @Test
    void errorOfATaskReachesTheCaller() {
        for (int threads : new int[] {1, 3}) {
            RuntimeException error = new IllegalArgumentException("no");
            assertSame(error, assertThrows(IllegalArgumentException.class, () -> OwnThreads.forEach(20, threads, i -> {
                if (i == 5) {
                    throw error;
                }
            })));
        }
    }

    @Test
    void interruptionIsKeptForTheCaller() {
        CountDownLatch other = new CountDownLatch(1);
        Thread caller = Thread.currentThread();
        OwnThreads.forEach(2, 2, i -> {
            if (Thread.currentThread() == caller) {
                caller.interrupt();
                other.countDown();
            } else {
                try {
                    assertTrue(other.await(10, TimeUnit.SECONDS));
                } catch (InterruptedException e) {
                    throw new IllegalStateException(e);
                }
            }
        });
        assertTrue(Thread.interrupted());
    }
}
