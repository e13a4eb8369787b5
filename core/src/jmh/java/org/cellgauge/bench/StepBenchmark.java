package org.cellgauge.bench;

import java.util.List;
import java.util.concurrent.TimeUnit;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.internal.pose.StateLayout;
import org.cellgauge.internal.posterior.CameraPosterior;
import org.cellgauge.internal.posterior.CentredChart;
import org.cellgauge.internal.posterior.CornerCubeLikelihood;
import org.cellgauge.internal.posterior.EulerChart;
import org.cellgauge.internal.posterior.RigidMarkerLikelihood;
import org.cellgauge.internal.sampling.MetropolisChain;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.internal.sampling.StudentTMixture;
import org.cellgauge.internal.sampling.ThesisMixture;
import org.cellgauge.settings.RotationPrior;
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

/** One suggestion with its density, accepted or not: what every iteration of a chain of camera poses costs. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class StepBenchmark {
    private MetropolisChain independence;
    private MetropolisChain thesisMixture;

    @Setup
    public void prepare() {
        BenchScene scene = new BenchScene(false);
        PoseMode mode = scene.mode();
        CentredChart centred = new CentredChart(mode.state(), IntrinsicsPrior.KNOWN);
        independence = new MetropolisChain(
                new CameraPosterior(centred, new RigidMarkerLikelihood(scene.view, mode.whitening()),
                        RotationPrior.UNIFORM, IntrinsicsPrior.KNOWN, null),
                List.of(new StudentTMixture(new double[][] {new double[6]}, new double[][] {mode.covariance()},
                        new double[] {1})),
                new double[6], RandomStreams.of(3));
        EulerChart euler = new EulerChart(scene.view.centroidMm(), mode.state(), IntrinsicsPrior.KNOWN);
        thesisMixture = new MetropolisChain(
                new CameraPosterior(euler, new CornerCubeLikelihood(scene.view, 0.5),
                        RotationPrior.FLAT_IN_EULER_ANGLES, IntrinsicsPrior.KNOWN, null),
                ThesisMixture.proposals(StateLayout.of(1, IntrinsicsPrior.KNOWN, 0),
                        IntrinsicsPrior.KNOWN), euler.encode(mode.state()),
                RandomStreams.of(4));
    }

    /** Independence t mixture, rigid-marker likelihood, centred chart: the default. */
    @Benchmark
    public boolean independenceStep() {
        return independence.step();
    }

    /** Thesis mixture, corner-cube likelihood, Euler angles. */
    @Benchmark
    public boolean thesisMixtureStep() {
        return thesisMixture.step();
    }
}
