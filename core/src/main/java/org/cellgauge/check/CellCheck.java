package org.cellgauge.check;

import io.reactivex.rxjava3.core.Flowable;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.function.IntSupplier;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.pose.AddedNoise;
import org.cellgauge.pose.CameraModeFinder;
import org.cellgauge.pose.CameraState;
import org.cellgauge.pose.CornerErrors;
import org.cellgauge.pose.InitialPose;
import org.cellgauge.pose.IntrinsicsPrior;
import org.cellgauge.pose.NoiseBelief;
import org.cellgauge.pose.PoseMode;
import org.cellgauge.pose.PosePrior;
import org.cellgauge.pose.ReferenceNoise;
import org.cellgauge.pose.ReferenceView;
import org.cellgauge.sampling.ChainEnsemble;
import org.cellgauge.sampling.Draws;
import org.cellgauge.sampling.EnsembleSnapshot;
import org.cellgauge.sampling.RandomStreams;
import org.cellgauge.sampling.RunLength;
import org.cellgauge.statistics.CoverageRegion;
import org.cellgauge.statistics.ParetoTail;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.cellgauge.warning.Decimal;
import org.cellgauge.warning.Listing;
import org.cellgauge.warning.Warning;

/**
 * The check of one photo: from its detections to camera and object poses with uncertainties and a verdict.
 *
 * <p>Modes first (damped Gauss-Newton), Laplace's approximation as a quick look, then chains until the Monte Carlo
 * error of every standard deviation is small enough. The same cell, detections, settings and seed give the same result
 * whatever the number of threads.
 */
public final class CellCheck {
    /** First number of the path of the stream from which a photo's own seed is drawn. */
    private static final long STREAM_PHOTO = 5;
    /** First number of the path of the random stream that tunes the camera's proposal. */
    static final long STREAM_TUNING = 1;
    /** First number of the path of the random stream of a chain. */
    static final long STREAM_CHAIN = 2;
    /** First number of the path of the random stream of an object's chain. */
    static final long STREAM_OBJECT = 3;
    /** First number of the path of the random stream that tunes an object's proposal. */
    static final long STREAM_OBJECT_TUNING = 4;

    /** Share of the posterior above which a second mode makes a pose ambiguous. */
    public static final double AMBIGUOUS_SHARE = 0.01;
    /** A mode with less than this share by Laplace's method is not followed. */
    private static final double NEGLIGIBLE_SHARE = 1e-4;
    /**
     * Mean square of whitened residuals (8 per reference) beyond which a reference is no misplaced one but a wrong one.
     */
    private static final double FOREIGN_MEAN_SQUARE = 50;
    /** Nodes of the grid of the added noise from one fit of the camera pose to the next. */
    private static final int NOISE_STRIDE = 5;
    /** Logarithm of the mass, against the most, at which the noise is followed no further. */
    private static final double NEGLIGIBLE_LOG_NOISE = 12;
    private static final double PRIOR_STD_MM = 1000;
    private static final double PRIOR_STD_RAD = 0.7;
    /** Share of the pose prior in any direction above which the result is said to lean on it. */
    private static final double LEANING_SHARE = 0.01;
    /** Quantile of chi-square within which the residuals at a mode must be for a given start to count as a good one. */
    private static final double EXPLAINED = 0.999;
    private static final int FIRST_ROUND = 1000;
    private static final double SMALLEST_SIDE_PX = 25;
    private static final double ADVISED_SIDE_PX = 32;
    /**
     * Side in px times squared deviation of the turn in rad over corner noise in px: simulated cells of four references
     * cover as stated to 22, and no longer at 60.
     */
    private static final double LARGEST_BEND = 20;

    private final Cell cell;
    private final Detections detections;
    private final CheckSettings settings;
    private final RigidTransform worldFromCameraStart;
    private final List<Warning> warnings = new ArrayList<>();
    private CornerErrors errors;
    private double noiseLevel;
    private CameraTarget camera;
    private ReferenceNoise noise;
    private List<ObjectTarget> objects;
    private List<ObjectMarker> missing;
    private String posePriorText;
    private Estimates estimates;
    private Diagnostics diagnostics;
    private int diagnosedDraws;
    private SamplerKind samplerUsed;
    private long tuningEvaluations;

    private CellCheck(Cell cell, Detections detections, CheckSettings settings, RigidTransform worldFromCameraStart) {
        this.cell = cell;
        this.detections = detections;
        this.settings = settings;
        this.worldFromCameraStart = worldFromCameraStart;
        warnings.addAll(detections.warnings());
    }

    /** A copy of a check whose quick look is done, for chains to run on. */
    private CellCheck(CellCheck prepared) {
        cell = prepared.cell;
        detections = prepared.detections;
        settings = prepared.settings;
        worldFromCameraStart = prepared.worldFromCameraStart;
        warnings.addAll(prepared.warnings);
        errors = prepared.errors;
        noiseLevel = prepared.noiseLevel;
        camera = prepared.camera;
        noise = prepared.noise;
        objects = new ArrayList<>(prepared.objects);
        missing = prepared.missing;
        posePriorText = prepared.posePriorText;
    }

    /**
     * The check of one photo as a stream: the quick look, running statistics, the result last.
     *
     * <dl>
     * <dt><b>Backpressure:</b></dt>
     * <dd>Latest value: a slow subscriber misses updates but always gets the newest and the result.</dd>
     * <dt><b>Scheduler:</b></dt>
     * <dd>Works on the thread that subscribes; chains step on threads of their own.</dd>
     * <dt><b>Error handling:</b></dt>
     * <dd>{@link InputRefusedException} where the photo shows too little; anything else is a fault of the program.
     * Cancelling stops the chains at once.</dd>
     * </dl>
     *
     * @param cell the cell
     * @param detections markers seen in its photo; ids foreign to the cell are ignored
     * @param settings how to go about it
     * @return updates; each subscription runs the whole check anew
     */
    public static Flowable<CheckUpdate> stream(Cell cell, Detections detections, CheckSettings settings) {
        return Flowable.defer(() -> {
            QuickLook quickLook = quickLook(cell, detections, settings, null);
            return Flowable.just(quickLook.update()).concatWith(quickLook.chains(settings::threads));
        }).onBackpressureLatest();
    }

    /**
     * The first part of the check of one photo: modes and Laplace's approximation, without chains.
     *
     * @param cell the cell
     * @param detections markers seen in its photo; ids foreign to the cell are ignored
     * @param settings how to go about it
     * @param worldFromCameraStart where the search for the mode starts, for instance at the mode of a similar photo, or
     *     null for the initial estimate of the settings. It is used only where it leads to a mode that explains the
     *     corners as well as their noise lets expect, and never where two references or fewer need a weak prior, which
     *     is about the initial estimate
     * @return the quick look, from which the chains can be run
     * @throws InputRefusedException as {@link #run}
     */
    public static QuickLook quickLook(Cell cell, Detections detections, CheckSettings settings,
            RigidTransform worldFromCameraStart) {
        CellCheck check = new CellCheck(cell, detections, settings, worldFromCameraStart);
        check.prepare();
        CellEstimate estimate = check.quickLook();
        return new QuickLook(new CheckUpdate(CheckUpdate.Phase.QUICK_LOOK, estimate, 0, null),
                check.errors.usualStdPx(check.noiseLevel),
                threads -> new CellCheck(check).sampling(estimate, threads));
    }

    /**
     * Runs the check to its end.
     *
     * @param cell the cell
     * @param detections markers seen in its photo
     * @param settings how to go about it
     * @return the result
     * @throws InputRefusedException if the photo shows no reference, or corners that no camera pose explains
     */
    public static CheckResult run(Cell cell, Detections detections, CheckSettings settings) {
        return stream(cell, detections, settings).blockingLast().result();
    }

    private Flowable<CheckUpdate> sampling(CellEstimate quickLook, IntSupplier threads) {
        tuneObjects();
        CellQuantities quantities = new CellQuantities(camera, objects);
        estimates = new Estimates(cell, quantities, quickLook);
        CameraSampler.Tuned tuned = tunedSampler();
        List<CellProcess> processes = new ArrayList<>();
        try {
            for (int c = 0; c < settings.chains(); c++) {
                processes.add(new CellProcess(quantities, tuned, photoSeed(), c));
            }
        } catch (IllegalStateException e) {
            throw new InputRefusedException(detections.imageName() + ": the chains cannot start, " + e.getMessage()
                    + "; check the references' positions in the cell file or use --initial pnp", e);
        }
        boolean[] judged = quantities.judged();
        int cap = settings.iterations().orElse(settings.maxIterations());
        int warmup = settings.toBuilder().sampler(samplerUsed).build().warmup();
        RunLength length = new RunLength(warmup, settings.iterations().isPresent() ? cap - warmup : FIRST_ROUND, cap);
        ChainEnsemble ensemble = new ChainEnsemble(processes, quantities.layout, length,
                draws -> preciseEnough(diagnosed(draws, quantities, judged)) && !undecided(), threads);
        return ensemble.stream().map(snapshot -> {
            CellEstimate running = snapshot.summary().count() > 1 ? estimates.of(snapshot.summary(), null) : quickLook;
            if (!snapshot.last()) {
                return new CheckUpdate(CheckUpdate.Phase.SAMPLING, running, snapshot.iterationsPerChain(), null);
            }
            CheckResult result = result(quickLook, quantities, judged, ensemble.draws(), snapshot);
            return new CheckUpdate(CheckUpdate.Phase.RESULT, result.estimate(), snapshot.iterationsPerChain(), result);
        });
    }

    /** The sampler asked for; where independence fits the posterior too poorly, adaptive Metropolis instead. */
    private CameraSampler.Tuned tunedSampler() {
        samplerUsed = settings.sampler();
        CameraSampler.Tuned tuned = tuned(samplerUsed);
        if (tuned.misfit() != null && settings.sampler() == SamplerKind.INDEPENDENCE) {
            warnings.add(Warning.of(CheckWarning.FAR_FROM_GAUSSIAN, tuned.misfit()));
            samplerUsed = SamplerKind.ADAPTIVE;
            return tuned(samplerUsed);
        }
        return tuned;
    }

    private CameraSampler.Tuned tuned(SamplerKind kind) {
        CameraSampler.Tuned tuned = kind.sampler().tune(camera, RandomStreams.of(photoSeed(), STREAM_TUNING));
        tuningEvaluations += tuned.evaluations();
        return tuned;
    }

    /**
     * What names the random streams of this photo: the seed and the corners of its markers, so that photos of a batch
     * do not share their random numbers, and a photo has the same figures alone, in a batch and under another name.
     */
    private long photoSeed() {
        List<MarkerObservation> markers = detections.markers();
        long[] path = new long[1 + 9 * markers.size()];
        int at = 0;
        path[at++] = STREAM_PHOTO;
        for (MarkerObservation marker : markers) {
            path[at++] = marker.id();
            for (double px : marker.cornersPx()) {
                path[at++] = Double.doubleToLongBits(px);
            }
        }
        return RandomStreams.of(settings.seed(), path).nextLong();
    }

    /** Fits each object's proposal, once the quick look is out. */
    private void tuneObjects() {
        if (settings.objectNoise() == CheckSettings.ObjectNoise.NONE) {
            return;
        }
        objects.replaceAll(o -> o.withProposal(TunedMixture.tune(o.posterior(), TunedMixture.ofModes(o.modes),
                RandomStreams.of(photoSeed(), STREAM_OBJECT_TUNING, o.marker.id())).proposal()));
    }

    /** Diagnostics of draws, kept: the draws that suffice are those of the result. */
    private Diagnostics diagnosed(List<Draws> draws, CellQuantities quantities, boolean[] judged) {
        int count = draws.get(0).count();
        if (diagnostics == null || diagnosedDraws != count) {
            diagnostics = Diagnostics.of(draws, quantities.layout, judged, quantities.measured());
            diagnosedDraws = count;
        }
        return diagnostics;
    }

    private boolean preciseEnough(Diagnostics found) {
        return found.converged() && found.mcseStdRelMax() < settings.targetMcseStdRel();
    }

    /** Whether the target lies within the Monte Carlo error of a deviation that could decide on it. */
    private boolean undecided() {
        if (!cell.targetStdMm().isPresent()
                || !Judgement.undecided(diagnostics, objects, cell.targetStdMm().getAsDouble())) {
            return false;
        }
        // no target is held against two poses
        return !twoPoses("camera", camera.modes) && objects.stream()
                .noneMatch(object -> twoPoses("object_" + object.marker.id(), object.modes));
    }

    private boolean twoPoses(String name, List<PoseMode> modes) {
        if (modes.size() < 2) {
            return false;
        }
        double mean = diagnostics.parameters().get(name + "_mode").mean();
        return mean > AMBIGUOUS_SHARE && mean < 1 - AMBIGUOUS_SHARE;
    }

    // ---- from detections to modes

    private void prepare() {
        if (detections.light() != null && detections.light().toneCurveOpen()) {
            throw new InputRefusedException(detections.imageName() + ": whites are clipped, and then nothing in the "
                    + "photo tells its tone curve, without which edges are not where they seem; expose less, or state "
                    + "tone_curve in the cell file");
        }
        warnOfReferencesNotSeen();
        errors = cornerErrors();
        ReferenceView view = ReferenceView.of(cell.references(), errors);
        IntrinsicsPrior intrinsics = settings.intrinsicsPrior(cell.camera());
        camera = withNoise(cameraTarget(view, intrinsics));
        noise = settings.model().noise(camera.view, errors, noiseLevel, settings.kappa());
        CameraState atMode = camera.modes.get(0).state();
        objects = new ArrayList<>();
        missing = new ArrayList<>();
        for (ObjectMarker marker : cell.objects()) {
            if (!errors.has(marker.id())) {
                missing.add(marker);
                continue;
            }
            objects.add(objectTarget(marker, atMode));
        }
        if (!missing.isEmpty()) {
            warnings.add(Warning.of(CheckWarning.OBJECTS_NOT_SEEN, Listing.and(ids(missing))));
        }
        warnOfSmallMarkers();
        warnOfLooseTurns();
    }

    private void warnOfReferencesNotSeen() {
        List<Integer> unseen = new ArrayList<>();
        for (Reference r : cell.references()) {
            if (detections.find(r.id()) == null) {
                unseen.add(r.id());
            }
        }
        if (unseen.size() == cell.references().size()) {
            throw new InputRefusedException(detections.imageName() + ": none of the references " + Listing.and(unseen)
                    + " is in the photo; check the marker family of the cell file, the light and the focus");
        }
        if (!unseen.isEmpty()) {
            warnings.add(Warning.of(CheckWarning.REFERENCES_NOT_SEEN, Listing.and(unseen)));
        }
    }

    /** One warning for all markers of the cell that the image shows too small. */
    private void warnOfSmallMarkers() {
        List<Warning> small = new ArrayList<>();
        for (MarkerObservation m : detections.markers()) {
            boolean ofCell = cell.references().stream().anyMatch(r -> r.id() == m.id())
                    || cell.objects().stream().anyMatch(o -> o.id() == m.id());
            if (ofCell && m.shortestSidePx() < SMALLEST_SIDE_PX) {
                small.add(Warning.of(CheckPhrase.SMALL_MARKER, m.id(), Decimal.of(m.shortestSidePx(), 1)));
            }
        }
        if (!small.isEmpty()) {
            warnings.add(Warning.of(CheckWarning.SMALL_MARKERS, Listing.comma(small), Decimal.of(SMALLEST_SIDE_PX, 0),
                    Decimal.of(ADVISED_SIDE_PX, 0)));
        }
    }

    /**
     * A reference turned by r shortens one side of its image by about {@code side r² / 2}: what no linear model of the
     * turn sees. Linearised at the turn that the photo shows, the rest of it is what the photo leaves open of that
     * turn.
     */
    private void warnOfLooseTurns() {
        if (settings.model() != LikelihoodModel.RIGID_MARKER) {
            return;
        }
        List<Integer> loose = new ArrayList<>();
        double most = 0;
        for (Reference reference : camera.view.references()) {
            double std = reference.placement().stdRad();
            double bend = detections.find(reference.id()).shortestSidePx() * std * std
                    / Math.sqrt(errors.meanVariancePx2(reference.id(), noiseLevel));
            if (bend > LARGEST_BEND) {
                loose.add(reference.id());
                most = Math.max(most, bend);
            }
        }
        if (!loose.isEmpty()) {
            warnings.add(Warning.of(CheckWarning.TURNS_TOO_LOOSE, Listing.and(loose), Decimal.of(most, 0),
                    Decimal.of(LARGEST_BEND, 0)));
        }
    }

    /** What is known of the corners' errors, in the terms that the model knows. */
    private CornerErrors cornerErrors() {
        CornerErrors found = CornerErrors.of(cell, detections).withOutliersSetAside();
        found.setAside().forEach((id, factor) ->
                warnings.add(Warning.of(CheckWarning.MARKER_SET_ASIDE, id, Decimal.of(factor, factor < 10 ? 1 : 0))));
        noiseLevel = found.added() == null ? 0 : found.squarenessBelief().ofMeanVariance();
        if (found.fromNothing() && settings.model() != LikelihoodModel.RIGID_MARKER) {
            warnings.add(noiseWarning(found.squarenessBelief()));
        }
        // the thesis' likelihood has no corner noise for shared errors to be a part of
        return found.isPlain() || settings.model() == LikelihoodModel.RIGID_MARKER ? found : found.fixedAt(noiseLevel);
    }

    private static Warning noiseWarning(NoiseBelief belief) {
        return Warning.of(CheckWarning.CORNER_NOISE_ESTIMATED, Decimal.of(belief.quantileStdPx(0.5), 3),
                Decimal.of(belief.quantileStdPx(0.025), 3), Decimal.of(belief.quantileStdPx(0.975), 3));
    }

    /** The target with what squareness and references say of the added noise, its modes found at the mean of that. */
    private CameraTarget withNoise(CameraTarget target) {
        if (errors.added() == null) {
            return new CameraTarget(target.view, settings, target.intrinsicsPrior, target.posePrior, target.modes,
                    target.initialWorldFromCamera, finders(target.intrinsicsPrior, target.posePrior), errors, null,
                    null);
        }
        List<Integer> others = errors.ids();
        // references that stay speak through their likelihood
        others.removeAll(ids(target.view));
        double[] logNoise = errors.logNoise(others);
        int middle = AddedNoise.node(noiseLevel);
        int count = AddedNoise.NODES;
        double[] log = new double[count];
        java.util.Arrays.fill(log, Double.NEGATIVE_INFINITY);
        log[middle] = logNoise[middle] + logMass(target, middle);
        double most = log[middle];
        for (int direction = -1; direction <= 1; direction += 2) {
            int last = middle;
            double mass = log[middle] - logNoise[middle];
            for (int node = middle + direction * NOISE_STRIDE; node >= 0 && node < count;
                    node += direction * NOISE_STRIDE) {
                if (!errors.isNegligible(AddedNoise.atNode(node))) {
                    mass = logMass(target, node);
                }
                for (int k = 1; k <= NOISE_STRIDE; k++) {
                    // what references say is smooth in the noise; what is cheap to know is not interpolated
                    int between = last + direction * k;
                    double share = (double) k / NOISE_STRIDE;
                    log[between] = logNoise[between] + (1 - share) * (log[last] - logNoise[last]) + share * mass;
                }
                most = Math.max(most, log[node]);
                last = node;
                if (log[node] < most - NEGLIGIBLE_LOG_NOISE) {
                    break;
                }
            }
        }
        NoiseBelief belief = new NoiseBelief(errors.added(), log);
        noiseLevel = belief.ofMeanVariance();
        Function<ReferenceView, CameraModeFinder> finders = finders(target.intrinsicsPrior, target.posePrior);
        List<PoseMode> modes = finders.apply(target.view)
                .modes(target.view.worldFromCamera(target.modes.get(0).state().cameraFromSet()));
        if (errors.fromNothing()) {
            warnings.add(noiseWarning(belief));
        }
        return new CameraTarget(target.view, settings, target.intrinsicsPrior, target.posePrior,
                notNegligible(modes.isEmpty() ? target.modes : modes), target.initialWorldFromCamera, finders, errors,
                belief, logNoise);
    }

    /**
     * Logarithm of the mass of the camera's posterior at an added noise, by Laplace's method: about the modes known
     * already, since the noise moves modes and weighs them and hardly makes any.
     */
    private double logMass(CameraTarget target, int node) {
        CameraModeFinder finder = new CameraModeFinder(target.view, cell.camera(), settings.model().noise(target.view,
                errors, AddedNoise.atNode(node), settings.kappa()), target.intrinsicsPrior, target.posePrior);
        List<PoseMode> modes = finder.refined(target.modes);
        if (modes.isEmpty()) {
            return Double.NEGATIVE_INFINITY;
        }
        double sum = 0;
        for (PoseMode mode : modes) {
            sum += Math.exp(mode.logWeight() - modes.get(0).logWeight());
        }
        return modes.get(0).logWeight() + Math.log(sum);
    }

    private CameraTarget cameraTarget(ReferenceView all, IntrinsicsPrior intrinsics) {
        ReferenceView view = all;
        while (true) {
            CameraTarget target = cameraTargetOf(view, intrinsics);
            int foreign = foreignReference(target);
            if (foreign < 0 || view.size() < 3) {
                return target;
            }
            warnings.add(Warning.of(CheckWarning.REFERENCE_LEFT_OUT, view.references().get(foreign).id()));
            List<Integer> kept = new ArrayList<>();
            for (int m = 0; m < view.size(); m++) {
                if (m != foreign) {
                    kept.add(m);
                }
            }
            view = view.only(kept);
        }
    }

    private CameraTarget cameraTargetOf(ReferenceView view, IntrinsicsPrior intrinsics) {
        boolean needsPosePrior = settings.posePriorAllowed() && view.size() <= 2;
        if (worldFromCameraStart != null && !needsPosePrior) {
            CameraTarget target = targetFromStart(view, intrinsics);
            if (target != null) {
                return target;
            }
        }
        RigidTransform initial = settings.initial().estimate(view, cell.camera());
        if (initial == null) {
            initial = InitialPose.PNP.estimate(view, cell.camera());
            if (initial == null) {
                throw noPose();
            }
            warnings.add(Warning.of(CheckWarning.INITIAL_ESTIMATE_FAILED, settings.initial().optionName()));
        }
        PosePrior posePrior = null;
        if (needsPosePrior) {
            posePrior = new PosePrior(CameraState.of(view.cameraFromSet(initial), cell.camera()), PRIOR_STD_MM,
                    PRIOR_STD_RAD);
            posePriorText = weakPrior().toString();
        }
        Function<ReferenceView, CameraModeFinder> finders = finders(intrinsics, posePrior);
        CameraModeFinder finder = finders.apply(view);
        List<PoseMode> modes = finder.modes(initial);
        if (modes.isEmpty() && settings.initial() != InitialPose.PNP) {
            modes = finder.modes(InitialPose.PNP.estimate(view, cell.camera()));
        }
        if (modes.isEmpty()) {
            throw noPose();
        }
        return new CameraTarget(view, settings, intrinsics, posePrior, notNegligible(modes), initial, finders);
    }

    private static Warning weakPrior() {
        return Warning.of(CheckPhrase.WEAK_PRIOR, Decimal.of(PRIOR_STD_MM, 0), Decimal.of(PRIOR_STD_RAD, 1));
    }

    private Function<ReferenceView, CameraModeFinder> finders(IntrinsicsPrior intrinsics, PosePrior posePrior) {
        double level = noiseLevel;
        return references -> new CameraModeFinder(references, cell.camera(),
                settings.model().noise(references, errors, level, settings.kappa()), intrinsics, posePrior);
    }

    /** The target by the modes that the start leads to, or null where these leave more unexplained than noise would. */
    private CameraTarget targetFromStart(ReferenceView view, IntrinsicsPrior intrinsics) {
        Function<ReferenceView, CameraModeFinder> finders = finders(intrinsics, null);
        List<PoseMode> modes = finders.apply(view).modes(worldFromCameraStart);
        if (modes.isEmpty() || 2 * modes.get(0).halfChiSquare()
                > CoverageRegion.chiSquareQuantile(EXPLAINED, 8 * view.size() - 6)) {
            return null;
        }
        return new CameraTarget(view, settings, intrinsics, null, notNegligible(modes), worldFromCameraStart, finders);
    }

    private InputRefusedException noPose() {
        return new InputRefusedException(detections.imageName() + ": no camera pose explains the corners of the "
                + "references; check their ids, positions and sizes in the cell file");
    }

    private static int foreignReference(CameraTarget target) {
        PoseMode mode = target.modes.get(0);
        int worst = -1;
        double most = 8 * FOREIGN_MEAN_SQUARE;
        for (int m = 0; m < target.view.size(); m++) {
            if (mode.chiSquareOf(m) > most) {
                most = mode.chiSquareOf(m);
                worst = m;
            }
        }
        return worst;
    }

    private static List<PoseMode> notNegligible(List<PoseMode> modes) {
        List<PoseMode> kept = new ArrayList<>();
        for (PoseMode mode : modes) {
            if (Math.exp(mode.logWeight() - modes.get(0).logWeight()) > NEGLIGIBLE_SHARE) {
                kept.add(mode);
            }
        }
        return kept;
    }

    private ObjectTarget objectTarget(ObjectMarker marker, CameraState atMode) {
        List<PoseMode> modes = ObjectTarget.modes(marker, errors, atMode);
        if (modes.isEmpty()) {
            throw new InputRefusedException(detections.imageName() + ": the corners of object " + marker.id()
                    + " are of no square in front of the camera; check the order of its corners");
        }
        boolean noisy = settings.objectNoise() == CheckSettings.ObjectNoise.DETECTION;
        modes = noisy ? notNegligible(modes) : modes.subList(0, 1);
        return new ObjectTarget(marker, errors, atMode, modes, TunedMixture.ofModes(modes));
    }

    // ---- quick look

    private CellEstimate quickLook() {
        LinearModel linear = new LinearModel(camera);
        PoseEstimate cameraPose = linear.cameraPose();
        IntrinsicsEstimate intrinsics = null;
        CameraState state = camera.modes.get(0).state();
        if (camera.intrinsicsPrior.count() > 0) {
            List<String> names = new ArrayList<>();
            double[] mean = new double[camera.intrinsicsPrior.count()];
            for (int i = 0; i < mean.length; i++) {
                names.add(CellQuantities.intrinsicName(camera, i));
                mean[i] = state.intrinsics[camera.intrinsicsPrior.index(i)];
            }
            intrinsics = new IntrinsicsEstimate(names, mean, linear.intrinsicsCovariance());
        }
        PinholeCamera lens = ImageEllipses.camera(cell.camera(), camera.intrinsicsPrior, intrinsics);
        List<ObjectEstimate> list = new ArrayList<>();
        for (ObjectTarget target : objects) {
            LinearModel.ObjectLink link = linear.new ObjectLink(target, 0);
            List<ModeEstimate> modes = new ArrayList<>();
            double[] weights = weights(target.modes);
            for (int k = 0; k < weights.length; k++) {
                modes.add(new ModeEstimate(weights[k], linear.new ObjectLink(target, k).poseEstimate()));
            }
            PoseEstimate pose = link.poseEstimate();
            PointEstimate grip = link.grip();
            list.add(new ObjectEstimate(target.marker, pose, grip, link.budget(null, noise),
                    grip == null ? null : link.budget(target.marker.gripMm(), noise),
                    ImageEllipses.of(lens, cameraPose, pose.meanTransform().translationMm(),
                            pose.positionCovarianceMm2()),
                    grip == null ? null
                            : ImageEllipses.of(lens, cameraPose, grip.meanMm(), grip.covarianceMm2()),
                    modes));
        }
        return new CellEstimate(cameraPose, Collections.singletonList(new ModeEstimate(1, cameraPose)), intrinsics,
                list);
    }

    private static double[] weights(List<PoseMode> modes) {
        double[] weights = new double[modes.size()];
        double sum = 0;
        for (int k = 0; k < weights.length; k++) {
            weights[k] = Math.exp(modes.get(k).logWeight() - modes.get(0).logWeight());
            sum += weights[k];
        }
        for (int k = 0; k < weights.length; k++) {
            weights[k] /= sum;
        }
        return weights;
    }

    // ---- verdict

    private CheckResult result(CellEstimate quickLook, CellQuantities quantities, boolean[] judged, List<Draws> draws,
            EnsembleSnapshot last) {
        diagnostics = diagnosed(draws, quantities, judged).withTails();
        CellEstimate estimate = estimates.of(last.summary(), draws);
        ReferenceCheck referenceCheck = referenceCheck();
        warnings.addAll(referenceCheck.warnings());
        if (camera.posePrior != null) {
            double share = LinearModel.priorShare(camera.modes.get(0), PRIOR_STD_MM, PRIOR_STD_RAD);
            if (!(share < LEANING_SHARE)) {
                warnings.add(Warning.of(CheckWarning.DIRECTION_OPEN, Decimal.of(100 * share, 0), weakPrior()));
            }
        }
        if (diagnostics.converged() && !settings.iterations().isPresent() && !preciseEnough(diagnostics)) {
            warnings.add(Warning.of(CheckWarning.CAP_REACHED, Decimal.of(last.iterationsPerChain(), 0),
                    diagnostics.leastPreciseParameter(), Decimal.of(100 * diagnostics.mcseStdRelMax(), 1),
                    Decimal.shortest(Math.rint(1e11 * settings.targetMcseStdRel()) / 1e9)));
        }
        if (diagnostics.converged() && diagnostics.heavyTails()) {
            warnings.add(Warning.of(CheckWarning.HEAVY_TAILS, diagnostics.heaviestParameter(),
                    Decimal.of(diagnostics.paretoKMax(), 2), Decimal.of(ParetoTail.LARGEST_FOR_STD, 2)));
        }
        return new CheckResult(cell, detections, settings, estimate, quickLook, ids(camera.view), errors, noiseLevel,
                diagnostics, last.acceptance(), warnings, draws, quantities.layout, last.iterationsPerChain(),
                posePriorText, samplerUsed, tuningEvaluations, camera, referenceCheck);
    }

    private NoiseFit noiseFit() {
        // the thesis' likelihood with corners of objects taken as exact has no corner noise at all
        if (settings.model() != LikelihoodModel.RIGID_MARKER
                && settings.objectNoise() == CheckSettings.ObjectNoise.NONE) {
            return NoiseFit.untested();
        }
        return settings.estimate() == CheckSettings.Estimate.FOCAL
                ? NoiseFit.ofUnknownFocal(cell, errors, camera.intrinsicsPrior)
                : NoiseFit.of(cell, errors, cell.camera());
    }

    private ReferenceCheck referenceCheck() {
        NoiseFit noiseFit = noiseFit();
        return ReferenceCheck.of(atNoise(noiseFit.inflation()), objects, noiseFit);
    }

    /**
     * Whether the references of one photo fit together: the part of a check that needs no chains.
     *
     * @param cell the cell
     * @param detections markers seen in its photo
     * @param settings how to go about it
     */
    static ReferenceCheck references(Cell cell, Detections detections, CheckSettings settings) {
        CellCheck check = new CellCheck(cell, detections, settings, null);
        check.prepare();
        return check.referenceCheck();
    }

    /** The camera as it is fitted where corners are noisier than stated, so that no reference is accused for them. */
    private CameraTarget atNoise(Map<Integer, Double> inflation) {
        if (inflation.isEmpty() || settings.model() != LikelihoodModel.RIGID_MARKER) {
            return camera;
        }
        CornerErrors noisier = errors.inflated(inflation);
        Function<ReferenceView, CameraModeFinder> finders = references -> new CameraModeFinder(references,
                cell.camera(), settings.model().noise(references, noisier, noiseLevel, settings.kappa()),
                camera.intrinsicsPrior, camera.posePrior);
        List<PoseMode> modes = finders.apply(camera.view).refined(camera.modes);
        return modes.isEmpty() ? camera : new CameraTarget(camera.view, settings, camera.intrinsicsPrior,
                camera.posePrior, modes, camera.initialWorldFromCamera, finders, noisier, null, null);
    }

    private static List<Integer> ids(List<ObjectMarker> markers) {
        List<Integer> ids = new ArrayList<>();
        markers.forEach(m -> ids.add(m.id()));
        return ids;
    }

    private static List<Integer> ids(ReferenceView view) {
        List<Integer> ids = new ArrayList<>();
        view.references().forEach(r -> ids.add(r.id()));
        return ids;
    }
}
