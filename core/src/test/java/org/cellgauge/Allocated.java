package org.cellgauge;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import org.junit.jupiter.api.Assumptions;

/** What a thread allocates: every object that it makes, whether it is kept or not. */
public final class Allocated {
    private Allocated() {
    }

    /** Bytes that the calling thread allocates in an action; a JVM that does not count them has the test skipped. */
    public static long bytes(Runnable action) {
        java.lang.management.ThreadMXBean bean = ManagementFactory.getThreadMXBean();
        Assumptions.assumeTrue(bean instanceof ThreadMXBean);
        ThreadMXBean threads = (ThreadMXBean) bean;
        Assumptions.assumeTrue(threads.isThreadAllocatedMemorySupported() && threads.isThreadAllocatedMemoryEnabled());
        long id = Thread.currentThread().getId();
        long before = threads.getThreadAllocatedBytes(id);
        action.run();
        return threads.getThreadAllocatedBytes(id) - before;
    }

    /** The least of several rounds: what the first ones load is not the action's. */
    public static long leastBytes(int rounds, Runnable action) {
        long least = Long.MAX_VALUE;
        for (int round = 0; round < rounds; round++) {
            least = Math.min(least, bytes(action));
        }
        return least;
    }
}
