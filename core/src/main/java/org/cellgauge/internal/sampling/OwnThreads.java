package org.cellgauge.internal.sampling;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.IntConsumer;

/**
 * Work that is shared between the calling thread and others made for it alone. The pool that all of a program shares is
 * left to that program: who asks for one thread gets one.
 */
public final class OwnThreads {
    private OwnThreads() {
    }

    /**
     * Does tasks 0 to count - 1, in any order, and returns when all are done. The tasks of an interrupted caller are
     * done all the same; it stays interrupted.
     *
     * @param count number of tasks
     * @param threads how many threads work, the calling one among them, at least 1
     * @param task what to do; called on any of the threads
     * @throws RuntimeException that a task throws; others may be left undone then
     */
    public static void forEach(int count, int threads, IntConsumer task) {
        AtomicInteger next = new AtomicInteger();
        AtomicReference<Throwable> failure = new AtomicReference<>();
        Runnable work = () -> {
            try {
                for (int i = next.getAndIncrement(); i < count; i = next.getAndIncrement()) {
                    task.accept(i);
                }
            } catch (RuntimeException | Error e) {
                failure.compareAndSet(null, e);
                next.set(count);
            }
        };
        List<Thread> others = new ArrayList<>();
        for (int i = 1; i < Math.min(threads, count); i++) {
            Thread thread = new Thread(work, "cellgauge-worker");
            thread.setDaemon(true);
            thread.start();
            others.add(thread);
        }
        work.run();
        others.forEach(OwnThreads::join);
        if (failure.get() instanceof Error) {
            throw (Error) failure.get();
        }
        if (failure.get() != null) {
            throw (RuntimeException) failure.get();
        }
    }

    private static void join(Thread thread) {
        boolean interrupted = false;
        while (true) {
            try {
                thread.join();
                break;
            } catch (InterruptedException e) {
                interrupted = true;
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
