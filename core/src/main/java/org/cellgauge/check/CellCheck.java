package org.cellgauge.check;

import io.reactivex.rxjava3.core.Flowable;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.pose.CameraModeFinder;
import org.cellgauge.pose.CameraState;
import org.cellgauge.pose.InitialPose;
import org.cellgauge.pose.IntrinsicsPrior;
import org.cellgauge.pose.MarkerPoseFinder;
import org.cellgauge.pose.PoseMode;
import org.cellgauge.pose.PosePrior;
import org.cellgauge.pose.ReferenceNoise;
import org.cellgauge.pose.ReferenceView;
import org.cellgauge.sampling.ChainEnsemble;
import org.cellgauge.sampling.Draws;
import org.cellgauge.sampling.EnsembleSnapshot;
import org.cellgauge.sampling.RandomStreams;
import org.cellgauge.sampling.RunLength;
import org.cellgauge.statistics.ChainDiagnostics;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;

/**
 * The check of one photo: from its detections to camera and object poses with uncertainties and a verdict.
 *
 * <p>Modes first (damped Gauss-Newton), Laplace's approximation as a quick look, then chains until the Monte Carlo error
 * of every standard deviation is small enough. The same cell, detections, settings and seed give the same result whatever
 * the number of threads.
 */
public final class CellCheck {
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
    /** Mean square of whitened residuals (8 per reference) beyond which a reference is no misplaced one but a wrong one. */
    private static final double FOREIGN_MEAN_SQUARE = 50;
    private static final double PRIOR_STD_MM = 1000;
    private static final double PRIOR_STD_RAD = 0.7;
    /** Share of the pose prior in any direction above which the result is said to lean on it. */
    private static final double LEANING_SHARE = 0.01;
    private static final int FIRST_ROUND = 1000;
    private static final double SMALLEST_SIDE_PX = 25;
    private static final double ADVISED_SIDE_PX = 32;

    private final Cell cell;
    private final Detections detections;
    private final CheckSettings settings;
    private final List<String> warnings = new ArrayList<>();
    private double pixelStdPx;
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

    private CellCheck(Cell cell, Detections detections, CheckSettings settings) {
        this.cell = cell;
        this.detections = detections;
        this.settings = settings;
        warnings.addAll(detections.warnings());
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
        return Flowable.defer(() -> new CellCheck(cell, detections, settings).updates()).onBackpressureLatest();
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

    private Flowable<CheckUpdate> updates() {
        prepare();
        CellEstimate quickLook = quickLook();
        return Flowable.just(new CheckUpdate(CheckUpdate.Phase.QUICK_LOOK, quickLook, 0, null))
                .concatWith(Flowable.defer(() -> sampling(quickLook)));
    }

    private Flowable<CheckUpdate> sampling(CellEstimate quickLook) {
        tuneObjects();
        CellQuantities quantities = new CellQuantities(camera, objects);
        estimates = new Estimates(cell, quantities, quickLook);
        CameraSampler.Tuned tuned = tunedSampler();
        List<CellProcess> processes = new ArrayList<>();
        try {
            for (int c = 0; c < settings.chains(); c++) {
                processes.add(new CellProcess(quantities, tuned, settings.seed(), c));
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
                draws -> preciseEnough(diagnosed(draws, quantities, judged)), settings.threads());
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
            warnings.add("the posterior is far from Gaussian (" + tuned.misfit() + "): adaptive Metropolis was used "
                    + "instead of independence");
            samplerUsed = SamplerKind.ADAPTIVE;
            return tuned(samplerUsed);
        }
        return tuned;
    }

    private CameraSampler.Tuned tuned(SamplerKind kind) {
        CameraSampler.Tuned tuned = kind.sampler().tune(camera, RandomStreams.of(settings.seed(), STREAM_TUNING));
        tuningEvaluations += tuned.evaluations();
        return tuned;
    }

    /** Fits each object's proposal, once the quick look is out. */
    private void tuneObjects() {
        if (settings.objectNoise() == CheckSettings.ObjectNoise.NONE) {
            return;
        }
        objects.replaceAll(o -> o.withProposal(TunedMixture.tune(o.posterior(), o.modes,
                RandomStreams.of(settings.seed(), STREAM_OBJECT_TUNING, o.marker.id())).proposal()));
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

    // ---- from detections to modes

    private void prepare() {
        ReferenceView view = references();
        pixelStdPx = cell.pixelStdPx().isPresent() ? cell.pixelStdPx().getAsDouble() : estimatePixelStdPx();
        IntrinsicsPrior intrinsics = settings.estimate() == CheckSettings.Estimate.FOCAL
                ? IntrinsicsPrior.focal(cell.camera(), settings.focalPriorStdPx())
                : IntrinsicsPrior.KNOWN;
        camera = cameraTarget(view, intrinsics);
        noise = settings.model().noise(camera.view, pixelStdPx, settings.kappa());
        PinholeCamera atMode = PinholeCamera.of(cell.camera().widthPx(), cell.camera().heightPx(),
                camera.modes.get(0).state().intrinsics);
        objects = new ArrayList<>();
        missing = new ArrayList<>();
        for (ObjectMarker marker : cell.objects()) {
            MarkerObservation observation = detections.find(marker.id());
            if (observation == null) {
                missing.add(marker);
                continue;
            }
            objects.add(objectTarget(marker, observation, atMode));
        }
        if (!missing.isEmpty()) {
            warnings.add("not seen in the photo: object " + join(ids(missing)));
        }
        warnOfSmallMarkers();
        if (settings.model() == LikelihoodModel.RIGID_MARKER) {
            warnings.addAll(MisplacedReferences.warnings(camera));
        }
    }

    private ReferenceView references() {
        List<Integer> unseen = new ArrayList<>();
        for (Reference r : cell.references()) {
            if (detections.find(r.id()) == null) {
                unseen.add(r.id());
            }
        }
        if (unseen.size() == cell.references().size()) {
            throw new InputRefusedException(detections.imageName() + ": none of the references " + join(unseen)
                    + " is in the photo; check the marker family of the cell file, the light and the focus");
        }
        if (!unseen.isEmpty()) {
            warnings.add("not seen in the photo: reference " + join(unseen));
        }
        return ReferenceView.of(cell.references(), detections);
    }

    /** One warning for all markers of the cell that the image shows too small. */
    private void warnOfSmallMarkers() {
        StringBuilder small = new StringBuilder();
        for (MarkerObservation m : detections.markers()) {
            boolean ofCell = cell.references().stream().anyMatch(r -> r.id() == m.id())
                    || cell.objects().stream().anyMatch(o -> o.id() == m.id());
            if (ofCell && m.shortestSidePx() < SMALLEST_SIDE_PX) {
                small.append(small.length() == 0 ? "" : ", ")
                        .append(String.format(Locale.ROOT, "%d (%.1f px)", m.id(), m.shortestSidePx()));
            }
        }
        if (small.length() > 0) {
            warnings.add(String.format(Locale.ROOT, "small in the image: marker %s; below %.0f px of side corners get "
                    + "imprecise and markers are missed, plan for %.0f px: larger markers or a closer camera", small,
                    SMALLEST_SIDE_PX, ADVISED_SIDE_PX));
        }
    }

    /**
     * Corner noise from how well each marker alone is a square: 8 coordinates, 6 unknowns, so 2 degrees of freedom per
     * marker, whatever the placement errors are.
     */
    private double estimatePixelStdPx() {
        double sumOfSquares = 0;
        int markers = 0;
        for (Reference r : cell.references()) {
            double squares = squaresOf(r.id(), r.sizeMm());
            sumOfSquares += Double.isNaN(squares) ? 0 : squares;
            markers += Double.isNaN(squares) ? 0 : 1;
        }
        for (ObjectMarker o : cell.objects()) {
            double squares = squaresOf(o.id(), o.sizeMm());
            sumOfSquares += Double.isNaN(squares) ? 0 : squares;
            markers += Double.isNaN(squares) ? 0 : 1;
        }
        double std = Math.sqrt(sumOfSquares / (2.0 * Math.max(1, markers)));
        if (markers == 0 || !(std > 0)) {
            throw new InputRefusedException(detections.imageName() + ": the corner noise cannot be estimated from these "
                    + "corners; state pixel_std_px in the cell file");
        }
        warnings.add(String.format(Locale.ROOT, "pixel_std_px is estimated as %.3f px from %d degrees of freedom, good to "
                + "about %.0f %%", std, 2 * markers, 100 / Math.sqrt(4.0 * markers)));
        return std;
    }

    private double squaresOf(int id, double sizeMm) {
        MarkerObservation observation = detections.find(id);
        if (observation == null) {
            return Double.NaN;
        }
        List<PoseMode> modes = MarkerPoseFinder.modes(observation.cornersPx(), sizeMm, cell.camera(), 1);
        double least = Double.NaN;
        for (PoseMode mode : modes) {
            least = Double.isNaN(least) ? mode.halfChiSquare() : Math.min(least, mode.halfChiSquare());
        }
        return 2 * least;
    }

    private CameraTarget cameraTarget(ReferenceView all, IntrinsicsPrior intrinsics) {
        ReferenceView view = all;
        while (true) {
            CameraTarget target = cameraTargetOf(view, intrinsics);
            int foreign = foreignReference(target);
            if (foreign < 0 || view.size() < 3) {
                return target;
            }
            warnings.add("reference " + view.references().get(foreign).id() + " is left out: its corners are nowhere near "
                    + "where the other references put it; check its id and position in the cell file");
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
        RigidTransform initial = settings.initial().estimate(view, cell.camera());
        if (initial == null) {
            initial = InitialPose.PNP.estimate(view, cell.camera());
            if (initial == null) {
                throw noPose();
            }
            warnings.add("the " + settings.initial().optionName() + " estimate found no camera pose; pnp was used instead");
        }
        PosePrior posePrior = null;
        if (settings.posePriorAllowed() && view.size() <= 2) {
            posePrior = new PosePrior(CameraState.of(view.cameraFromSet(initial), cell.camera()), PRIOR_STD_MM,
                    PRIOR_STD_RAD);
            posePriorText = String.format(Locale.ROOT, "N(initial estimate, %.0f mm, %.1f rad)", PRIOR_STD_MM,
                    PRIOR_STD_RAD);
        }
        PosePrior prior = posePrior;
        Function<ReferenceView, CameraModeFinder> finders = references -> new CameraModeFinder(references, cell.camera(),
                settings.model().noise(references, pixelStdPx, settings.kappa()), intrinsics, prior);
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

    private InputRefusedException noPose() {
        return new InputRefusedException(detections.imageName() + ": no camera pose explains the corners of the references; "
                + "check their ids, positions and sizes in the cell file");
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

    private ObjectTarget objectTarget(ObjectMarker marker, MarkerObservation observation, PinholeCamera atMode) {
        double[] corners = observation.cornersPx();
        List<PoseMode> modes = MarkerPoseFinder.modes(corners, marker.sizeMm(), atMode, pixelStdPx);
        if (modes.isEmpty()) {
            throw new InputRefusedException(detections.imageName() + ": the corners of object " + marker.id()
                    + " are of no square in front of the camera; check the order of its corners");
        }
        boolean noisy = settings.objectNoise() == CheckSettings.ObjectNoise.DETECTION;
        modes = noisy ? notNegligible(modes) : modes.subList(0, 1);
        return new ObjectTarget(marker, corners, pixelStdPx, modes, TunedMixture.ofModes(modes));
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
                names.add(CellQuantities.intrinsicName(camera.intrinsicsPrior.index(i)));
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
        return new CellEstimate(cameraPose, Collections.singletonList(new ModeEstimate(1, cameraPose)), intrinsics, list);
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
        diagnosed(draws, quantities, judged);
        CellEstimate estimate = estimates.of(last.summary(), draws);
        if (camera.posePrior != null) {
            double share = LinearModel.priorShare(camera.modes.get(0), PRIOR_STD_MM, PRIOR_STD_RAD);
            if (!(share < LEANING_SHARE)) {
                warnings.add(String.format(Locale.ROOT, "the references leave a direction of the camera pose open: %.0f %% of "
                        + "what is known there is the weak prior %s; add a reference", 100 * share, posePriorText));
            }
        }
        if (diagnostics.converged() && !settings.iterations().isPresent() && !preciseEnough(diagnostics)) {
            warnings.add(String.format(Locale.ROOT, "the chains reached their cap of %d iterations before the precision "
                    + "asked for: the standard deviation of %s has a Monte Carlo error of %.1f %% in place of %s %%; "
                    + "allow more with --max-iterations", last.iterationsPerChain(), diagnostics.leastPreciseParameter(),
                    100 * diagnostics.mcseStdRelMax(), plain(1e-9 * Math.rint(1e11 * settings.targetMcseStdRel()))));
        }
        Verdict verdict = verdict(estimate, diagnostics);
        return new CheckResult(cell, detections, settings, verdict, reason(verdict, estimate, diagnostics), estimate,
                quickLook, ids(camera.view), pixelStdPx, diagnostics, last.acceptance(), warnings, draws,
                quantities.layout, last.iterationsPerChain(), posePriorText, samplerUsed, tuningEvaluations, camera);
    }

    private Verdict verdict(CellEstimate estimate, Diagnostics diagnostics) {
        if (!diagnostics.converged()) {
            return Verdict.NOT_CONVERGED;
        }
        if (ambiguous(estimate.cameraModes())) {
            return Verdict.AMBIGUOUS;
        }
        for (ObjectEstimate object : estimate.objects()) {
            if (ambiguous(object.modes())) {
                return Verdict.AMBIGUOUS;
            }
        }
        if (!cell.targetStdMm().isPresent()) {
            return Verdict.NO_TARGET;
        }
        if (!missing.isEmpty()) {
            return Verdict.FAIL;
        }
        for (ObjectEstimate object : estimate.objects()) {
            if (!(object.worstStdMm() <= cell.targetStdMm().getAsDouble())) {
                return Verdict.FAIL;
            }
        }
        return Verdict.PASS;
    }

    private static boolean ambiguous(List<ModeEstimate> modes) {
        return modes.size() > 1 && modes.get(1).weight() > AMBIGUOUS_SHARE;
    }

    private String reason(Verdict verdict, CellEstimate estimate, Diagnostics diagnostics) {
        switch (verdict) {
            case NOT_CONVERGED:
                return "The chains have not converged (" + worstOf(diagnostics) + "): no accuracy can be read off them.";
            case AMBIGUOUS:
                return ambiguity(estimate);
            case NO_TARGET:
                return "No target is set. " + worst(estimate);
            case FAIL:
                if (!missing.isEmpty()) {
                    return "Object " + join(ids(missing)) + " was not seen in the photo. " + worst(estimate);
                }
                return worst(estimate);
            default:
                return worst(estimate);
        }
    }

    private static String worstOf(Diagnostics diagnostics) {
        String name = diagnostics.worstParameter();
        ChainDiagnostics worst = diagnostics.parameters().get(name);
        switch (worst.status()) {
            case CONSTANT:
                return name + " never moved in at least one of them";
            case NON_FINITE:
                return name + " became infinite or NaN";
            case TOO_SHORT:
                return "fewer than " + ChainDiagnostics.MIN_DRAWS + " draws each";
            default:
                return String.format(Locale.ROOT, "worst: %s, R-hat %s, effective draws %s", name, number(worst.rHat(), 3),
                        number(Math.min(worst.essBulk(), worst.essTail()), 0));
        }
    }

    private static String ambiguity(CellEstimate estimate) {
        if (ambiguous(estimate.cameraModes())) {
            return String.format(Locale.ROOT, "Two camera poses explain the references (the second holds %.0f %%): add a "
                    + "reference out of their plane.", 100 * estimate.cameraModes().get(1).weight());
        }
        for (ObjectEstimate object : estimate.objects()) {
            if (ambiguous(object.modes())) {
                return String.format(Locale.ROOT, "Two poses explain the corners of object %d (the second holds %.0f %%): use "
                        + "a larger marker, come closer or look at it from the side.", object.id(),
                        100 * object.modes().get(1).weight());
            }
        }
        return "Two poses explain the photo.";
    }

    /** The sentence about the largest deviation: where it is, how it stands to the target and what causes most of it. */
    private String worst(CellEstimate estimate) {
        String name = null;
        int axis = 0;
        double std = -1;
        VarianceBudget budget = null;
        for (ObjectEstimate object : estimate.objects()) {
            for (int i = 0; i < 3; i++) {
                if (object.pose().std()[i] > std) {
                    name = "object " + object.id();
                    axis = i;
                    std = object.pose().std()[i];
                    budget = object.budget();
                }
                if (object.grip() != null && object.grip().stdMm()[i] > std) {
                    name = "the gripping point of object " + object.id();
                    axis = i;
                    std = object.grip().stdMm()[i];
                    budget = object.gripBudget();
                }
            }
        }
        if (name == null) {
            return "No object is in the photo.";
        }
        String source = "";
        double share = -1;
        for (Map.Entry<String, Double> e : budget.shares(axis).entrySet()) {
            if (e.getValue() > share) {
                share = e.getValue();
                source = e.getKey();
            }
        }
        String axisName = "xyz".substring(axis, axis + 1);
        String target = cell.targetStdMm().isPresent()
                ? String.format(Locale.ROOT, " against a target of %s mm", plain(cell.targetStdMm().getAsDouble())) : "";
        return String.format(Locale.ROOT, "Largest deviation: %.2f mm in %s of %s%s; %.0f %% of this variance comes from %s.",
                std, axisName, name, target, 100 * share, inWords(source));
    }

    private static String inWords(String source) {
        switch (source) {
            case "corner noise of object":
                return "noise in the object's own corners";
            case "corner noise of references":
                return "noise in the references' corners";
            case "intrinsics":
                return "the unknown intrinsics";
            default:
                return "the " + source;
        }
    }

    private static String plain(double value) {
        return value == Math.rint(value) ? String.format(Locale.ROOT, "%.0f", value) : Double.toString(value);
    }

    private static String number(double value, int digits) {
        return Double.isNaN(value) ? "undefined" : String.format(Locale.ROOT, "%." + digits + "f", value);
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

    private static String join(List<Integer> ids) {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < ids.size(); i++) {
            text.append(i == 0 ? "" : i == ids.size() - 1 ? " and " : ", ").append(ids.get(i));
        }
        return text.toString();
    }
}
