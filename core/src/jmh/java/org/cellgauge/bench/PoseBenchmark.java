package org.cellgauge.bench;

import java.util.List;
import java.util.concurrent.TimeUnit;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.pose.CameraModeFinder;
import org.cellgauge.internal.pose.InitialPose;
import org.cellgauge.internal.pose.MarkerPoseFinder;
import org.cellgauge.internal.pose.PoseMode;
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

/** Point estimates: once per photo and object, and once per draw where intrinsics are sampled. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class PoseBenchmark {
    private BenchScene scene;
    private CameraModeFinder finder;
    private RigidTransform start;
    private double[] cornersPx;

    @Setup
    public void prepare() {
        scene = new BenchScene(false);
        finder = scene.finder();
        start = InitialPose.PNP.estimate(scene.view, scene.camera);
        cornersPx = scene.detections.find(5).cornersPx();
    }

    /** Both modes of one object marker. */
    @Benchmark
    public List<PoseMode> markerModes() {
        return new MarkerPoseFinder().modes(cornersPx, ThesisScene.SIZE_MM, scene.camera, BenchScene.PIXEL_STD);
    }

    /** Modes of the camera pose, covariances frozen at them, from the pose of all references at once. */
    @Benchmark
    public List<PoseMode> cameraModes() {
        return finder.modes(start);
    }

    /** The start itself. */
    @Benchmark
    public RigidTransform pnpStart() {
        return InitialPose.PNP.estimate(scene.view, scene.camera);
    }
}
