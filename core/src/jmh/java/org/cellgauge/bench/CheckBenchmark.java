package org.cellgauge.bench;

import java.util.concurrent.TimeUnit;
import org.cellgauge.cell.Cell;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.Detections;
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

/** A whole check from corners to verdict: four references, default settings. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class CheckBenchmark {
    /** No objects, three lifted ones, or three that lie in the plane, each with two poses or nearly. */
    @Param({"none", "lifted", "plane"})
    public String objects = "none";

    private Detections detections;
    private Cell cell;
    private CheckSettings settings;

    @Setup
    public void prepare() {
        ThesisScene scene = (objects.equals("lifted") ? ThesisScene.oneRaised(4) : ThesisScene.inPlane(4))
                .placement(1, 0.002).pixelStd(0.1);
        scene = objects.equals("none") ? scene.noObjects() : objects.equals("plane") ? scene.planeObjects() : scene;
        cell = scene.cell();
        detections = scene.detections(0.1, RandomStreams.of(3), 1, 0.002);
        settings = CheckSettings.builder().threads(1).build();
    }

    @Benchmark
    public CheckResult wholeCheck(Cpu cpu) {
        cpu.calls++;
        return CellCheck.run(cell, detections, settings);
    }
}
