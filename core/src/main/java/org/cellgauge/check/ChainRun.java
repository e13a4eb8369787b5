package org.cellgauge.check;

import io.reactivex.rxjava3.core.Flowable;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntSupplier;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Target;
import org.cellgauge.estimate.ModeEstimate;
import org.cellgauge.internal.chains.CameraSampler;
import org.cellgauge.internal.chains.CameraTarget;
import org.cellgauge.internal.chains.CellProcess;
import org.cellgauge.internal.chains.CellQuantities;
import org.cellgauge.internal.chains.ObjectTarget;
import org.cellgauge.internal.chains.RandomPaths;
import org.cellgauge.internal.chains.TunedMixture;
import org.cellgauge.internal.laplace.ObjectFit;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.internal.sampling.ChainEnsemble;
import org.cellgauge.internal.sampling.EnsembleSnapshot;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.internal.sampling.RunLength;
import org.cellgauge.internal.sampling.StartException;
import org.cellgauge.internal.warning.CheckPhrase;
import org.cellgauge.sampling.Draws;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.ObjectNoise;
import org.cellgauge.settings.SamplerKind;
import org.cellgauge.warning.CheckRefusal;
import org.cellgauge.warning.CheckWarning;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;
import org.cellgauge.warning.Warning;
import org.jspecify.annotations.Nullable;

/** One run of the chains of a photo, from its quick look to draws that suffice; for one subscription. */
final class ChainRun {
    private static final int FIRST_ROUND = 1000;
    /** The first round where the precision asked for needs fewer draws than convergence does. */
    private static final int SHORT_ROUND = 400;
    /** Precision of deviations that FIRST_ROUND is for; it needs draws with the square of what is asked for. */
    private static final double USUAL_PRECISION = 0.02;

    /** What is added to the draws that an error asks for: it is an estimate, and the largest of many. */
    private static final double WITH_MARGIN = 1.1;
    /** Fewer more are not worth the diagnostics; many more, and not even the error is known yet. */
    private static final double LEAST_GROWTH = 1.25;
    private static final double MOST_GROWTH = 4;

    private final QuickLook quickLook;
    private final Observed observed;
    private final CheckSettings settings;
    private final long seed;
    private final List<Warning> warnings;
    private final CellQuantities quantities;
    private SamplerKind samplerUsed;
    private long tuningEvaluations;
    private @Nullable Diagnostics diagnostics;
    private int diagnosedDraws;

    ChainRun(QuickLook quickLook) {
        this.quickLook = quickLook;
        observed = quickLook.modes.observed;
        settings = observed.settings;
        seed = observed.photoSeed();
        samplerUsed = settings.sampling().sampler();
        warnings = new ArrayList<>(quickLook.modes.warnings);
        quantities = new CellQuantities(quickLook.modes.camera, tunedObjects());
    }

    /**
     * Runs the chains.
     *
     * @param threads how many threads to step them on; asked again and again
     * @return running statistics, the result last
     */
    Flowable<CheckUpdate> stream(IntSupplier threads) {
        Estimates estimates = new Estimates(observed.cell, quantities, quickLook.estimate());
        CameraSampler.Tuned tuned = tunedSampler();
        List<CellProcess> processes = new ArrayList<>();
        try {
            for (int c = 0; c < settings.sampling().chains(); c++) {
                processes.add(new CellProcess(quantities, tuned, seed, c));
            }
        } catch (IllegalStateException e) {
            Object why = e instanceof StartException
                    ? Warning.of(CheckPhrase.DENSITY_AT_START, String.valueOf(((StartException) e).logDensity()))
                    : String.valueOf(e.getMessage());
            throw new InputRefusedException(Refusal.at(Place.of(observed.detections.imageName()),
                    CheckRefusal.CHAINS_CANNOT_START, why, CheckPhrase.INITIAL_PNP), e);
        }
        boolean[] judged = quantities.judged();
        int cap = settings.sampling().iterations().orElse(settings.sampling().maxIterations());
        int warmup = settings.sampling().warmup(samplerUsed);
        RunLength length = new RunLength(warmup,
                settings.sampling().iterations().isPresent() ? cap - warmup : firstRound(), cap);
        ChainEnsemble ensemble = new ChainEnsemble(processes, quantities.layout, length,
                draws -> wanted(diagnosed(draws, judged, threads.getAsInt()), draws), threads);
        return ensemble.stream().map(snapshot -> {
            CellEstimate running = snapshot.summary().count() > 1 ? estimates.of(snapshot.summary(), List.of())
                    : quickLook.estimate();
            if (!snapshot.last()) {
                return new CheckUpdate(CheckUpdate.Phase.SAMPLING, running, snapshot.iterationsPerChain(), null);
            }
            CheckResult result = CheckResult.of(
                    sampled(estimates, judged, ensemble.draws(), snapshot, threads.getAsInt()));
            return new CheckUpdate(CheckUpdate.Phase.RESULT, result.estimate(), snapshot.iterationsPerChain(), result);
        });
    }

    /**
     * How many draws of each chain are wanted after a round. Only where they have converged does their number tell how
     * many more make them as precise as asked: else, and where a target lies within their error, it is doubled.
     */
    private int wanted(Diagnostics found, List<Draws> draws) {
        int count = draws.get(0).count();
        if (preciseEnough(found, settings)) {
            return undecided(found, draws) ? 2 * count : count;
        }
        return found.converged() ? wantedFor(count, found.mcseStdRelMax(), settings.sampling().targetMcseStdRel())
                : 2 * count;
    }

    /**
     * How many draws have the error asked for, where as many as there are have a larger one: it shrinks with the root
     * of their number.
     *
     * @param count draws there are
     * @param error their largest Monte Carlo error of a deviation, as a share of it
     * @param asked the error asked for
     * @return somewhat more than that, a quarter more to four times what there are; twice that where no error is known
     */
    static int wantedFor(int count, double error, double asked) {
        double times = WITH_MARGIN * (error / asked) * (error / asked);
        return Double.isNaN(times) ? 2 * count
                : (int) Math.ceil(count * Math.max(LEAST_GROWTH, Math.min(MOST_GROWTH, times)));
    }

    private int firstRound() {
        double share = USUAL_PRECISION / settings.sampling().targetMcseStdRel();
        return (int) Math.max(SHORT_ROUND, Math.min(FIRST_ROUND, FIRST_ROUND * share * share));
    }

    private SampledCell sampled(Estimates estimates, boolean[] judged, List<Draws> draws, EnsembleSnapshot last,
            int threads) {
        Diagnostics all = diagnosed(draws, judged, threads).withTails(threads);
        return new SampledCell(quickLook, quantities, estimates.of(last.summary(), draws), draws, last, all,
                samplerUsed, tuningEvaluations, warnings);
    }

    /** The sampler asked for; where independence fits the posterior too poorly, adaptive Metropolis instead. */
    private CameraSampler.Tuned tunedSampler() {
        CameraSampler.Tuned tuned = tuned(samplerUsed);
        Warning misfit = tuned.misfit();
        if (misfit != null && samplerUsed == SamplerKind.INDEPENDENCE) {
            warnings.add(Warning.of(CheckWarning.FAR_FROM_GAUSSIAN, misfit));
            samplerUsed = SamplerKind.ADAPTIVE;
            return tuned(samplerUsed);
        }
        return tuned;
    }

    private CameraSampler.Tuned tuned(SamplerKind kind) {
        CameraSampler.Tuned tuned = CameraSampler.of(kind).tune(new CameraTarget(quickLook.modes.camera),
                RandomStreams.of(seed, RandomPaths.TUNING));
        tuningEvaluations += tuned.evaluations();
        return tuned;
    }

    /** The objects, each with a proposal fitted to its posterior. */
    private List<ObjectTarget> tunedObjects() {
        List<ObjectTarget> out = new ArrayList<>();
        for (ObjectFit fit : quickLook.modes.objects) {
            ObjectTarget object = ObjectTarget.ofModes(fit);
            out.add(settings.model().objectNoise() == ObjectNoise.NONE ? object
                    : object.withProposal(TunedMixture.tune(object.posterior(), TunedMixture.ofModes(fit.modes),
                            RandomStreams.of(seed, RandomPaths.OBJECT_TUNING, fit.marker.id())).proposal()));
        }
        return out;
    }

    /** Diagnostics of draws, kept: the draws that suffice are those of the result. */
    private Diagnostics diagnosed(List<Draws> draws, boolean[] judged, int threads) {
        int count = draws.get(0).count();
        Diagnostics found = diagnostics;
        if (found == null || diagnosedDraws != count) {
            found = Diagnostics.of(draws, quantities.layout, judged, quantities.measured(), threads);
            diagnostics = found;
            diagnosedDraws = count;
        }
        return found;
    }

    static boolean preciseEnough(Diagnostics found, CheckSettings settings) {
        return found.converged() && found.mcseStdRelMax() < settings.sampling().targetMcseStdRel();
    }

    /** Whether the target lies within the Monte Carlo error of a deviation or probability that could decide on it. */
    private boolean undecided(Diagnostics found, List<Draws> draws) {
        Target target = observed.cell.target();
        CellModes modes = quickLook.modes;
        if (!target.isAny() || !TargetTest.undecided(found, modes.objects, target,
                object -> conformities(object.marker, draws, target))) {
            return false;
        }
        // no target is held against two poses
        return !twoPoses(found, Quantity.CAMERA_MODE, modes.camera.modes) && modes.objects.stream()
                .noneMatch(object -> twoPoses(found, Quantity.objectMode(object.marker.id()), object.modes));
    }

    private List<Conformity> conformities(ObjectMarker object, List<Draws> draws, Target target) {
        Conformities count = new Conformities(draws, quantities.layout, target.of(object.id()));
        List<Conformity> found = new ArrayList<>(count.ofPosition(object.id(), null));
        if (object.hasGrip()) {
            found.addAll(count.ofGrip(object.id(), null));
        }
        return found;
    }

    private static boolean twoPoses(Diagnostics found, Quantity mode, List<PoseMode> modes) {
        if (modes.size() < 2) {
            return false;
        }
        double mean = found.of(mode).mean();
        return mean > ModeEstimate.AMBIGUOUS_SHARE && mean < 1 - ModeEstimate.AMBIGUOUS_SHARE;
    }
}
