package org.cellgauge.bench;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.util.Locale;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;

/**
 * Processor time of the process, which other work on the machine leaves alone as it does not the clock: said at the end
 * of a benchmark, the least that any iteration had per call. Compilers and collectors are in it.
 */
@State(Scope.Thread)
public class Cpu {
    /** Calls in this iteration; the benchmark counts them. */
    int calls;
    private final OperatingSystemMXBean process =
            (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
    private long start;
    private double leastMs = Double.POSITIVE_INFINITY;

    @Setup(Level.Iteration)
    public void start() {
        start = process.getProcessCpuTime();
        calls = 0;
    }

    @TearDown(Level.Iteration)
    public void stop() {
        leastMs = Math.min(leastMs, (process.getProcessCpuTime() - start) / 1e6 / calls);
    }

    @TearDown(Level.Trial)
    public void say() {
        System.out.printf(Locale.ROOT, "%nLeast processor time of an iteration: %.1f ms/op%n", leastMs);
    }
}
