package org.cellgauge.internal.validation;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.IntConsumer;
import java.util.function.IntFunction;

/** Many tasks over several threads, their results in the order of the tasks. */
final class InOrder {
    private InOrder() {
    }

    /**
     * Runs tasks 0 to count - 1.
     *
     * @param count number of tasks
     * @param threads number of threads
     * @param task what to do; called on any of the threads
     * @param progress told the number of finished tasks, in order, on the calling thread
     * @return the results, in order
     */
    static <T> List<T> run(int count, int threads, IntFunction<T> task, IntConsumer progress) {
        ExecutorService executor = Executors.newFixedThreadPool(threads, work -> {
            Thread thread = new Thread(work, "cellgauge-validation");
            thread.setDaemon(true);
            return thread;
        });
        List<T> results = new ArrayList<>();
        try {
            List<Future<T>> futures = new ArrayList<>();
            for (int i = 0; i < count; i++) {
                int index = i;
                futures.add(executor.submit(() -> task.apply(index)));
            }
            for (Future<T> future : futures) {
                results.add(future.get());
                progress.accept(results.size());
            }
            return results;
        } catch (ExecutionException e) {
            if (e.getCause() instanceof RuntimeException) {
                throw (RuntimeException) e.getCause();
            }
            throw new IllegalStateException(e.getCause());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted", e);
        } finally {
            executor.shutdownNow();
        }
    }
}
