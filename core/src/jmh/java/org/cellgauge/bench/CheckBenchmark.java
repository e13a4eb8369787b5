package org.cellgauge.bench;

import java.util.concurrent.TimeUnit;
import org.cellgauge.cell.Cell;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.settings.CheckSettings;
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

/** A whole check from corners to verdict: three references, three objects, default settings. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class CheckBenchmark {
    private BenchScene scene;
    private Cell cell;
    private CheckSettings settings;

    @Setup
    public void prepare() {
        scene = new BenchScene(false);
        cell = scene.scene.cell();
        settings = CheckSettings.builder().build();
    }

    @Benchmark
    public CheckResult wholeCheck() {
        return CellCheck.run(cell, scene.detections, settings);
    }
}
