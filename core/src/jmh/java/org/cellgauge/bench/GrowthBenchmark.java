package org.cellgauge.bench;

import java.util.concurrent.TimeUnit;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.GridScene;
import org.cellgauge.placement.ReferenceCheck;
import org.cellgauge.settings.CheckSettings;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * How a whole check of 700 iterations grows with the markers of a cell: references by objects. {@code -prof gc} beside
 * it says how its memory does.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 2, time = 2)
@Measurement(iterations = 3, time = 2)
public class GrowthBenchmark {
    /** References on a grid, and objects above them. */
    @Param({"2 1", "6 1", "20 1", "50 1", "100 1", "300 1", "4 1", "4 3", "4 10", "4 30", "4 100", "100 100"})
    public String markers = "2 1";

    private GridScene scene;
    private CheckSettings settings;

    @Setup
    public void prepare() {
        int space = markers.indexOf(' ');
        scene = GridScene.of(Integer.parseInt(markers.substring(0, space)),
                Integer.parseInt(markers.substring(space + 1)));
        settings = CheckSettings.builder().threads(1).seed(1).iterations(700).build();
    }

    @Benchmark
    public CheckResult wholeCheck(Cpu cpu) {
        cpu.calls++;
        return CellCheck.run(scene.cell, scene.detections, settings);
    }

    /** Modes, Laplace's approximation and tests of references: all but the chains. */
    @Benchmark
    public ReferenceCheck withoutChains(Cpu cpu) {
        cpu.calls++;
        return CellCheck.quickLook(scene.cell, scene.detections, settings, null).referenceCheck();
    }
}
