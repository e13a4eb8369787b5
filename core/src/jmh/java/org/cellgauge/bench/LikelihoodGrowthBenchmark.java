package org.cellgauge.bench;

import java.util.concurrent.TimeUnit;
import org.cellgauge.check.GridScene;
import org.cellgauge.internal.pose.CameraModeFinder;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.internal.pose.ReferenceView;
import org.cellgauge.internal.pose.RigidMarkerNoise;
import org.cellgauge.internal.posterior.RigidMarkerLikelihood;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * One log likelihood of a camera pose by the number of references. The least of many samples (p0.00) is what a busy
 * machine leaves alone; {@code core/src/jmh/c/likelihood.c} measures the same in C.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.SampleTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 3, time = 1)
public class LikelihoodGrowthBenchmark {
    private static final int STATES = 64;
    private static final double PIXEL_STD = 0.1;

    @Param({"2", "3", "6", "20", "50", "100"})
    public int references = 2;

    private RigidMarkerLikelihood likelihood;
    private CameraState[] states;

    @Setup
    public void prepare() {
        GridScene scene = GridScene.of(references, 0);
        ReferenceView view = ReferenceView.of(scene.cell.references(), scene.detections);
        PoseMode mode = new CameraModeFinder(view, scene.cell.camera(), new RigidMarkerNoise(view, PIXEL_STD),
                IntrinsicsPrior.KNOWN, null).modes(GridScene.WORLD_FROM_CAMERA).get(0);
        likelihood = new RigidMarkerLikelihood(view, mode.whitening());
        states = BenchScene.around(mode);
    }

    @Benchmark
    @OperationsPerInvocation(STATES)
    public double logLikelihood() {
        double sum = 0;
        for (CameraState state : states) {
            sum += likelihood.at(state);
        }
        return sum;
    }
}
