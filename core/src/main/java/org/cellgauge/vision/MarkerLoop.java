package org.cellgauge.vision;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.IntConsumer;
import org.jspecify.annotations.Nullable;

/**
 * Does the same to each of the markers of a photo, one after another or several at once. Their fits share the photo and
 * its light, which stand still meanwhile, and nothing else, so results are the same either way.
 */
final class MarkerLoop {
    private @Nullable Executor helpers;
    private int threads = 1;

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

    /**
     * Does the work for each, and returns when all is done. It waits for work that has begun alone: where no helper is
     * free, the calling thread does all of it.
     *
     * @param count how many markers
     * @param work to be done with the number of each, from 0; what it throws is thrown when all others are done
     */
    void each(int count, IntConsumer work) {
        Executor with = helpers;
        if (with == null || threads == 1 || count < 2) {
            for (int i = 0; i < count; i++) {
                work.accept(i);
            }
            return;
        }
        Shared shared = new Shared(count, work);
        try {
            for (int i = 1; i < Math.min(threads, count); i++) {
                with.execute(shared);
            }
        } catch (RejectedExecutionException e) {
            // shut down, or busy: there is the calling thread
        }
        shared.run();
        shared.await();
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
