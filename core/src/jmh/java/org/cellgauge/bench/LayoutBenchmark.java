package org.cellgauge.bench;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.Placement;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.estimate.VarianceBudget;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.plan.LayoutModel;
import org.cellgauge.internal.plan.SubsetSearch;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.vision.CornerForecast;
import org.cellgauge.laplace.LayoutPrediction;
import org.cellgauge.plan.Layout;
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
    private Layout layout;
    private SubsetSearch search;
    private final int[] members = {0, 1, 2};

    @Setup
    public void prepare() {
        ThesisScene scene = ThesisScene.inPlane(4).placement(5, 0.01).pixelStd(0.3).planeObjects().grip(20, 0, 0, 100);
        cell = scene.cell();
        objects = scene.objects();
        settings = CheckSettings.builder().build();
        Map<Integer, List<RigidTransform>> places = new LinkedHashMap<>();
        objects.forEach((id, pose) -> places.put(id, List.of(pose)));
        layout = new Layout(cell, List.of(ThesisScene.WORLD_FROM_CAMERA), places);
        LayoutModel model = model();
        double[][][] candidates = new double[8][1][];
        for (int i = 0; i < candidates.length; i++) {
            candidates[i][0] = model.view(0).information(RigidTransform.ofEuler(100 + 40 * i, 100, 0, 0, 0, 0), 47,
                    new Placement(5, 5, 5, 0.01));
        }
        search = new SubsetSearch(List.of(model.design(0)), new double[][] {model.information(0, List.of(), 3)},
                candidates, (a, b) -> true);
    }

    private LayoutModel model() {
        return new LayoutModel(layout, CornerForecast.USUAL, IntrinsicsPrior.KNOWN);
    }

    /** A layout as a plan tries it: any change of markers or camera. */
    @Benchmark
    public double planned() {
        return model().worst();
    }

    /** A layout of which the information of every marker is known: three of many places for more references. */
    @Benchmark
    public double placesOfKnownInformation() {
        return search.worst(members, members.length);
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
