package org.cellgauge.internal.live;

import io.reactivex.rxjava3.core.Scheduler;
import io.reactivex.rxjava3.schedulers.Schedulers;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/**
 * Schedulers whose threads end by themselves when they have been idle for a moment.
 *
 * <p>Nobody shuts them down, so that no task is ever refused. With a scheduler that is shut down, a task that comes at
 * that very moment is an error that reaches nobody, and on Android such an error ends the program.
 */
public final class IdleThreads {
    private static final long IDLE_MS = 200;

    private IdleThreads() {
    }

    /**
     * One thread for all workers: tasks run one at a time, in the order in which they came. Disposing a worker lets the
     * task in progress go on.
     *
     * @param name of the thread
     * @return a scheduler
     */
    public static Scheduler one(String name) {
        ThreadPoolExecutor executor =
                new ThreadPoolExecutor(1, 1, IDLE_MS, TimeUnit.MILLISECONDS, new LinkedBlockingQueue<>(), named(name));
        executor.allowCoreThreadTimeOut(true);
        return Schedulers.from(executor);
    }

    /**
     * A thread for each worker that has something to do. Disposing a worker interrupts its task in progress.
     *
     * @param name of the threads
     * @return a scheduler
     */
    public static Scheduler oneForEachWorker(String name) {
        return Schedulers.from(new ThreadPoolExecutor(0, Integer.MAX_VALUE, IDLE_MS, TimeUnit.MILLISECONDS,
                new SynchronousQueue<>(), named(name)), true);
    }

    private static ThreadFactory named(String name) {
        return task -> {
            Thread thread = new Thread(task, name);
            thread.setDaemon(true);
            return thread;
        };
    }
}
