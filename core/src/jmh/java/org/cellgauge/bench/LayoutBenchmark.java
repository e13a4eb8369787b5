package org.cellgauge.bench;

import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.cellgauge.cell.Cell;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.estimate.VarianceBudget;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.laplace.LayoutPrediction;
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

/** What a photo of a layout would tell, from poses alone: four references, three objects, one gripping point. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class LayoutBenchmark {
    private Cell cell;
    private Map<Integer, RigidTransform> objects;
    private CheckSettings settings;

    @Setup
    public void prepare() {
        ThesisScene scene = ThesisScene.inPlane(4).placement(5, 0.01).pixelStd(0.3).planeObjects().grip(20, 0, 0, 100);
        cell = scene.cell();
        objects = scene.objects();
        settings = CheckSettings.builder().build();
    }

    @Benchmark
    public LayoutPrediction prediction() {
        return LayoutPrediction.of(cell, ThesisScene.WORLD_FROM_CAMERA, objects, settings);
    }

    @Benchmark
    public VarianceBudget predictionAndABudget() {
        return prediction().budget(20);
    }
}
