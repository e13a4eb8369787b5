package org.cellgauge.bench;

import java.util.concurrent.TimeUnit;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.statistics.ChainDiagnostics;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** R-hat, effective sample sizes and Monte Carlo errors of one quantity: done for each of some dozens, every round. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class DiagnosticsBenchmark {
    private final double[][] chains = new double[4][1000];

    /** Four autoregressive chains of 1000 draws, lag-one correlation 0.5. */
    @Setup
    public void prepare() {
        RandomGenerator random = RandomStreams.of(5);
        for (double[] chain : chains) {
            double x = random.nextGaussian();
            for (int i = 0; i < chain.length; i++) {
                chain[i] = x;
                x = 0.5 * x + random.nextGaussian();
            }
        }
    }

    @Benchmark
    public double fourChainsOfAThousandDraws() {
        ChainDiagnostics diagnostics = ChainDiagnostics.of(chains);
        return diagnostics.rHat() + diagnostics.essBulk() + diagnostics.essTail() + diagnostics.mcseSd();
    }
}
