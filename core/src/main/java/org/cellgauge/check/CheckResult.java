package org.cellgauge.check;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.OptionalDouble;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.Target;
import org.cellgauge.estimate.IntrinsicsEstimate;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.chains.CameraTarget;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.posterior.CameraPosterior;
import org.cellgauge.internal.statistics.ParetoTail;
import org.cellgauge.internal.warning.CheckPhrase;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.placement.NoiseFit;
import org.cellgauge.placement.ReferenceCheck;
import org.cellgauge.sampling.AcceptanceCount;
import org.cellgauge.sampling.Draws;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.sampling.QuantityLayout;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.SamplerKind;
import org.cellgauge.settings.SettingTable;
import org.cellgauge.vision.Detections;
import org.cellgauge.warning.CheckWarning;
import org.cellgauge.warning.Warning;
import org.jspecify.annotations.Nullable;

/** What a check found; immutable. */
public final class CheckResult {
    private final SampledCell sampled;
    private final CellModes modes;
    private final Cell cell;
    private final CheckSettings settings;
    private final Judgement judgement;
    private final Verdict verdict;
    private final Reason finding;
    private final NoiseEstimate noise;
    private final List<Warning> warnings;
    private final ReferenceCheck referenceCheck;

    private CheckResult(Cell cell, CheckSettings settings, SampledCell sampled, ReferenceCheck referenceCheck,
            List<Warning> warnings) {
        this.cell = cell;
        this.settings = settings;
        this.sampled = sampled;
        this.modes = sampled.quickLook.modes;
        this.referenceCheck = referenceCheck;
        this.warnings = Collections.unmodifiableList(warnings);
        this.judgement = new Judgement(cell, sampled.estimate, sampled.diagnostics, referenceCheck,
                sampled.againstLaplace(), sampled.draws, sampled.quantities.layout);
        this.verdict = judgement.verdict();
        this.finding = judgement.finding();
        this.noise = NoiseEstimate.of(modes.observed.errors, modes.camera.noiseLevel, sampled.draws,
                sampled.quantities.layout);
    }

    /**
     * The last stage of a check: whether its references fit, and the verdict.
     *
     * @param sampled draws and their convergence
     * @return the result
     */
    static CheckResult of(SampledCell sampled) {
        CellModes modes = sampled.quickLook.modes;
        CheckSettings settings = modes.observed.settings;
        Diagnostics diagnostics = sampled.diagnostics;
        ReferenceCheck referenceCheck = modes.references();
        // what is wrong with the references comes before what is told of the rest
        List<Warning> warnings = new ArrayList<>(referenceCheck.warnings());
        warnings.addAll(sampled.warnings);
        Warning open = modes.directionOpen();
        if (open != null) {
            warnings.add(open);
        }
        IntrinsicsEstimate intrinsics = sampled.estimate.intrinsics();
        List<String> notLearned = intrinsics == null ? List.of() : intrinsics.notLearned();
        if (!notLearned.isEmpty()) {
            warnings.add(Warning.of(CheckWarning.INTRINSICS_NOT_LEARNED, Listing.and(notLearned)));
        }
        Warning apart = sampled.againstLaplace().warning();
        if (apart != null) {
            warnings.add(apart);
        }
        Quantity leastPrecise = diagnostics.leastPreciseParameter();
        if (leastPrecise != null && diagnostics.converged() && !settings.sampling().iterations().isPresent()
                && !sampled.preciseEnough()) {
            warnings.add(Warning.of(CheckWarning.CAP_REACHED, Decimal.of(sampled.last.iterationsPerChain(), 0),
                    leastPrecise.name(), Decimal.of(100 * diagnostics.mcseStdRelMax(), 1),
                    Decimal.shortest(Math.rint(1e11 * settings.sampling().targetMcseStdRel()) / 1e9),
                    CheckPhrase.MORE_ITERATIONS));
        }
        Quantity heaviest = diagnostics.heaviestParameter();
        if (heaviest != null && diagnostics.converged() && diagnostics.heavyTails()) {
            warnings.add(Warning.of(CheckWarning.HEAVY_TAILS, heaviest.name(),
                    Decimal.of(diagnostics.paretoKMax(), 2), Decimal.of(ParetoTail.LARGEST_FOR_STD, 2)));
        }
        return new CheckResult(modes.observed.cell, settings, sampled, referenceCheck, warnings);
    }

    /**
     * The cell that was checked.
     *
     * @return as read
     */
    public Cell cell() {
        return cell;
    }

    /**
     * The markers it rests on.
     *
     * @return as detected or given
     */
    public Detections detections() {
        return modes.observed.detections;
    }

    /**
     * The settings it was run with.
     *
     * @return settings
     */
    public CheckSettings settings() {
        return settings;
    }

    /**
     * The verdict.
     *
     * @return never null
     */
    public Verdict verdict() {
        return verdict;
    }

    /**
     * Whether the verdict is pass or fail by more than twice the Monte Carlo error of every deviation that counts, so
     * that no other seed would say otherwise. Where the target lies nearer than that the verdict is fail, and this is
     * false.
     *
     * @return false as well where no target is set, or no figure is to be trusted
     */
    public boolean decided() {
        return judgement.decided();
    }

    /**
     * The same of the verdict on one object.
     *
     * @param objectId marker id
     * @return as {@link #decided()}
     */
    public boolean decided(int objectId) {
        return judgement.decided(objectId);
    }

    /**
     * Why.
     *
     * @return one sentence
     */
    public String reason() {
        return finding.english();
    }

    /**
     * Why, in parts that another language can make a sentence of.
     *
     * @return the parts of {@link #reason()}
     */
    public Reason finding() {
        return finding;
    }

    /**
     * The verdict on one object of the cell, by the same rules.
     *
     * @param objectId marker id
     * @return never null; an object that was not seen misses any target
     */
    public Verdict verdict(int objectId) {
        return judgement.verdict(objectId);
    }

    /**
     * Why one object was judged as {@link #verdict(int)} says.
     *
     * @param objectId marker id
     * @return the reason in parts, about this object alone
     */
    public Reason finding(int objectId) {
        return judgement.finding(objectId);
    }

    /**
     * The target held against the figures alone, whether they are to be trusted or not.
     *
     * @return the test
     */
    public TargetTest targetTest() {
        return judgement.target();
    }

    /**
     * The same draws held against one standard deviation as the target.
     *
     * @param targetStdMm largest allowed standard deviation of any axis, mm, positive, or empty for no target
     * @return a result that differs in its verdict and reason alone
     */
    public CheckResult withTarget(OptionalDouble targetStdMm) {
        return withTarget(Target.ofStdMm(targetStdMm));
    }

    /**
     * The same draws held against another target.
     *
     * @param target what is asked of the objects
     * @return a result that differs in its verdict and reason alone
     */
    public CheckResult withTarget(Target target) {
        if (target.equals(cell.target())) {
            return this;
        }
        // the cell holds it now
        CheckSettings others = settings.toBuilder().set(SettingTable.TARGET_STD_MM, OptionalDouble.empty()).build();
        return new CheckResult(cell.withTarget(target), others, sampled, referenceCheck, warnings);
    }

    /**
     * What the chains say.
     *
     * @return means and covariances; figures only where {@link Diagnostics#converged()}
     */
    public CellEstimate estimate() {
        return sampled.estimate;
    }

    /**
     * What Laplace's approximation at the mode says.
     *
     * @return the quick look that the chains confirm or correct
     */
    public CellEstimate quickLook() {
        return sampled.quickLook.estimate();
    }

    /**
     * References that the camera pose rests on.
     *
     * @return marker ids, in the order of the cell
     */
    public List<Integer> referencesUsed() {
        return Collections.unmodifiableList(CellModes.ids(modes.camera.view));
    }

    /**
     * Whether the references fit together.
     *
     * @return figures per reference, those that are misplaced, and what hangs on them
     */
    public ReferenceCheck referenceCheck() {
        return referenceCheck;
    }

    /**
     * Standard deviation of each corner coordinate: as stated; where it is not, the root of the mean variance of the
     * corners, added noise included.
     *
     * @return px
     */
    public double pixelStdPx() {
        return noise.usualStdPx();
    }

    /**
     * Whether corners are as precise as the cell file states.
     *
     * @return how square markers are, in stated deviations; nothing where the noise is not stated
     */
    public NoiseFit noiseFit() {
        return referenceCheck.noise();
    }

    /**
     * What the check says of the corners themselves.
     *
     * @return their noise, the shift of edges, markers set aside
     */
    public NoiseEstimate noise() {
        return noise;
    }

    /**
     * Convergence of the chains.
     *
     * @return per quantity and overall
     */
    public Diagnostics diagnostics() {
        return sampled.diagnostics;
    }

    /**
     * Accepted and rejected suggestions per named proposal, all chains together.
     *
     * @return unmodifiable
     */
    public List<AcceptanceCount> acceptance() {
        return Collections.unmodifiableList(sampled.last.acceptance());
    }

    /**
     * What the user should know besides.
     *
     * @return unmodifiable; may be empty
     */
    public List<Warning> warnings() {
        return warnings;
    }

    /**
     * What to do first where something does not fit: what an overview of many photos has room for.
     *
     * @return one of the warnings, or null where nothing is to be done about the references
     */
    public @Nullable Warning action() {
        List<Warning> ofReferences = referenceCheck.warnings();
        if (!ofReferences.isEmpty()) {
            return ofReferences.get(0);
        }
        for (Warning warning : warnings) {
            if (warning.kind() == CheckWarning.REFERENCE_LEFT_OUT) {
                return warning;
            }
        }
        return null;
    }

    /**
     * The kept draws of each chain.
     *
     * @return one per chain, not to be changed
     */
    public List<Draws> draws() {
        return sampled.draws;
    }

    /**
     * The quantities of a draw.
     *
     * @return names and angles
     */
    public QuantityLayout layout() {
        return sampled.quantities.layout;
    }

    /**
     * Iterations each chain ran, warm-up included.
     *
     * @return number of iterations
     */
    public int iterationsPerChain() {
        return sampled.last.iterationsPerChain();
    }

    /**
     * The weak prior that was put on the camera pose.
     *
     * @return in words, or null where it was flat in position and uniform over rotations
     */
    public @Nullable String posePrior() {
        return modes.posePriorText();
    }

    /**
     * The sampler that made the draws.
     *
     * @return the one asked for, unless the posterior was too far from Gaussian for it
     */
    public SamplerKind samplerUsed() {
        return sampled.samplerUsed;
    }

    /**
     * How often the camera's posterior was evaluated before the chains, to fit their proposal.
     *
     * @return the count; that of the chains is one for each of their steps
     */
    public long tuningEvaluations() {
        return sampled.tuningEvaluations;
    }

    /**
     * Iterations of each chain that were not kept.
     *
     * @return the settings' number for the sampler that was used
     */
    public int warmup() {
        return settings.sampling().warmup(sampled.samplerUsed);
    }

    /**
     * Logarithm of the posterior density of the camera pose, up to the constant of {@code lp__} among the draws and in
     * the same coordinates, so that any pose can be compared with the draws. Intrinsics are those of the mode.
     *
     * @param worldFromCamera the pose
     * @return the logarithm; negative infinity where the posterior has no density
     */
    public double cameraLogDensity(RigidTransform worldFromCamera) {
        return cameraLogDensity(worldFromCamera, modes.camera.mode().state().intrinsics);
    }

    /**
     * The same at any intrinsics. Those that are not unknown are the camera's whatever is given for them.
     *
     * @param worldFromCamera the pose
     * @param intrinsics in the order of {@link org.cellgauge.geometry.PinholeCamera}
     * @return the logarithm; negative infinity where the posterior has no density
     */
    public double cameraLogDensity(RigidTransform worldFromCamera, double[] intrinsics) {
        CameraTarget target = new CameraTarget(modes.camera);
        CameraPosterior posterior =
                sampled.samplerUsed == SamplerKind.THESIS_MIXTURE ? target.euler() : target.centred();
        CameraState state = modes.camera.mode().state();
        System.arraycopy(intrinsics, 0, state.intrinsics, 0, state.intrinsics.length);
        RigidTransform cameraFromSet = modes.camera.view.cameraFromSet(worldFromCamera);
        System.arraycopy(cameraFromSet.rotation(), 0, state.rotation, 0, 9);
        System.arraycopy(cameraFromSet.translationMm(), 0, state.offset, 0, 3);
        return posterior.at(posterior.chart().encode(state));
    }
}
