package org.cellgauge.bench;

import java.util.concurrent.TimeUnit;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.internal.posterior.CameraLikelihood;
import org.cellgauge.internal.posterior.CornerCubeLikelihood;
import org.cellgauge.internal.posterior.MovingRigidLikelihood;
import org.cellgauge.internal.posterior.RigidMarkerLikelihood;
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

/** One log likelihood of a camera pose, three references. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class LikelihoodBenchmark {
    /** The third has a shift of edges, ink on one size of markers and an unknown noise besides. */
    @Param({"rigid-marker", "corner-cube", "rigid-marker-shared", "rigid-marker-moving"})
    public String model;
    @Param({"false", "true"})
    public boolean distortion;

    private CameraLikelihood likelihood;
    private CameraState[] states;
    private int next;

    @Setup
    public void prepare() {
        BenchScene scene = new BenchScene(distortion);
        if (model.equals("rigid-marker-shared")) {
            scene = scene.withSharedErrors();
        }
        PoseMode mode = scene.mode();
        likelihood = scene.errors != null ? new RigidMarkerLikelihood(scene.view, mode, scene.errors)
                : model.equals("rigid-marker-moving")
                ? new MovingRigidLikelihood(scene.view, mode, scene.finder().noise(), null)
                : model.equals("corner-cube") ? new CornerCubeLikelihood(scene.view, 0.5)
                : new RigidMarkerLikelihood(scene.view, mode.whitening());
        states = BenchScene.around(mode);
    }

    @Benchmark
    public double logLikelihood() {
        next = (next + 1) & 63;
        return likelihood.at(states[next]);
    }
}
