package org.cellgauge.bench;

import java.lang.management.ManagementFactory;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import org.cellgauge.internal.sampling.RunningSummary;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.sampling.Quantity.Axis;
import org.cellgauge.sampling.QuantityLayout;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Running statistics of a camera's pose over more and more draws, and what stays in the heap for them: said at the end,
 * after a collection, with the statistics still in use. The draws are made up; none is kept.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 0)
@Measurement(iterations = 1)
public class RunningMemoryBenchmark {
    @Param({"10000", "1000000", "100000000"})
    public long draws = 10_000;

    private RunningSummary summary;

    @Setup
    public void prepare() {
        QuantityLayout.Builder builder = new QuantityLayout.Builder();
        int x = builder.add(Quantity.camera(Axis.X));
        int y = builder.add(Quantity.camera(Axis.Y));
        int z = builder.add(Quantity.camera(Axis.Z));
        int psi = builder.addAngle(Quantity.camera(Axis.PSI), Math.PI);
        int theta = builder.addAngle(Quantity.camera(Axis.THETA), 0);
        int phi = builder.addAngle(Quantity.camera(Axis.PHI), 0);
        builder.group(x, y, z, psi, theta, phi);
        summary = new RunningSummary(builder.build());
    }

    @Benchmark
    public double add() {
        double[] draw = new double[6];
        for (long i = 0; i < draws; i++) {
            for (int k = 0; k < draw.length; k++) {
                // fractions of multiples of an irrational number: spread evenly, and cheap
                double turns = (i + 1) * 0.6180339887498949 * (k + 1);
                draw[k] = turns - Math.floor(turns);
            }
            summary.add(draw);
        }
        return summary.mean(0)[0];
    }

    @TearDown(Level.Trial)
    public void say() {
        System.gc();
        long bytes = ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed();
        System.out.printf(Locale.ROOT, "%n%d draws, std %.6f: %.2f MB of heap in use%n", summary.count(),
                Math.sqrt(summary.covariance(0)[0][0]), bytes / 1e6);
    }
}
