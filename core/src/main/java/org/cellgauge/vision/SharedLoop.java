package org.cellgauge.vision;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.IntConsumer;
import org.jspecify.annotations.Nullable;

/**
 * Does the same to each of the markers of a photo, or of its parts, one after another or several at once. These share
 * the photo and its light, which stand still meanwhile, and nothing else, so results are the same either way.
 */
final class SharedLoop {
    /** Until the last marker is done: it takes some tenths of a millisecond, and to be woken up takes about as long. */
    private static final int YIELDS = 500;

    private @Nullable Executor helpers;
    private int threads = 1;
    private @Nullable Team team;

    /**
     * From now on several at once.
     *
     * @param with on what threads, beside the calling one
     * @param most how many threads at most, the calling one among them, at least 1
     */
    void spread(Executor with, int most) {
        helpers = with;
        threads = most;
    }

    /** How many threads at most go through one. */
    int threads() {
        return threads;
    }

    /** Has helpers come, and stay until they are let go: to be woken up for each loop takes as long as half of it. */
    void gather() {
        dismiss();
        Executor with = helpers;
        if (with == null || threads == 1) {
            return;
        }
        Team gathered = new Team();
        team = gathered;
        try {
            for (int i = 1; i < threads; i++) {
                with.execute(gathered);
            }
        } catch (RejectedExecutionException e) {
            // shut down, or busy: there is the calling thread
        }
    }

    /** Lets helpers go. */
    void dismiss() {
        Team gathered = team;
        if (gathered != null) {
            gathered.dismissed = true;
            // a helper that was busy may come much later, and is not to hold the image so long
            gathered.shared = null;
            team = null;
        }
    }

    /**
     * Does the work for each, and returns when all is done. It waits for work that has begun alone: where no helper is
     * free, or none was gathered, the calling thread does all of it.
     *
     * @param count how many markers or parts
     * @param work to be done with the number of each, from 0; what it throws is thrown when all others are done
     */
    void each(int count, IntConsumer work) {
        Team with = team;
        if (with == null || count < 2) {
            for (int i = 0; i < count; i++) {
                work.accept(i);
            }
            return;
        }
        Shared shared = new Shared(count, work);
        with.shared = shared;
        shared.run();
        shared.await();
    }

    /** Nothing but time hangs on what the scheduler makes of it, and older Androids know no other hint. */
    @SuppressWarnings("ThreadPriorityCheck")
    private static void waitALittle() {
        Thread.yield();
    }

    private static final class Team implements Runnable {
        private volatile @Nullable Shared shared;
        private volatile boolean dismissed;

        @Override
        public void run() {
            Shared last = null;
            while (!dismissed) {
                Shared now = shared;
                if (now == null || now == last) {
                    waitALittle();
                } else {
                    now.run();
                    last = now;
                }
            }
        }
    }

    private static final class Shared implements Runnable {
        private final int count;
        private final IntConsumer work;
        private final AtomicInteger next = new AtomicInteger();
        private final CountDownLatch left;
        private final AtomicReference<Throwable> failure = new AtomicReference<>();

        Shared(int count, IntConsumer work) {
            this.count = count;
            this.work = work;
            left = new CountDownLatch(count);
        }

        @Override
        public void run() {
            for (int i = next.getAndIncrement(); i < count; i = next.getAndIncrement()) {
                try {
                    work.accept(i);
                } catch (RuntimeException | Error e) {
                    failure.compareAndSet(null, e);
                } finally {
                    left.countDown();
                }
            }
        }

        void await() {
            for (int i = 0; i < YIELDS && left.getCount() > 0; i++) {
                waitALittle();
            }
            boolean interrupted = false;
            while (left.getCount() > 0) {
                try {
                    left.await();
                } catch (InterruptedException e) {
                    // the markers are in the hands of other threads until they are done
                    interrupted = true;
                }
            }
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
            Throwable thrown = failure.get();
            if (thrown instanceof Error) {
                throw (Error) thrown;
            }
            if (thrown != null) {
                throw (RuntimeException) thrown;
            }
        }
    }
}
