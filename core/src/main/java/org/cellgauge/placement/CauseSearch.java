package org.cellgauge.placement;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.Lenses;
import org.cellgauge.internal.laplace.CameraFit;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.InitialPose;
import org.cellgauge.internal.pose.MarkerPoseFinder;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.internal.pose.PosePrior;
import org.cellgauge.internal.pose.ReferenceView;
import org.cellgauge.internal.statistics.CoverageRegion;
import org.cellgauge.vision.EdgeShift;
import org.jspecify.annotations.Nullable;

/**
 * Causes tried outright, where references as stated fit so badly that no linear model of the misfit holds: the camera
 * is found again as if the cell were built, or its file written, with each of them, and what is left of the misfit is
 * compared.
 *
 * <p>Evidence is chi-square at the mode and, as in Schwarz's criterion ("Estimating the dimension of a model", Annals
 * of Statistics 1978), twice the logarithm of how many likes a cause has, or of how much finer than what is usual the
 * photo tells its size.
 */
final class CauseSearch {
    /** Quantile of chi-square beyond which references as stated fit so badly that causes are tried outright. */
    private static final double SENSELESS = 1 - 1e-6;
    /** Quantile of chi-square within which a cause leaves nothing to explain. */
    private static final double EXPLAINED = 0.9999;
    /** Share of the misfit that a cause may leave: references may be off besides. */
    private static final double LEFT_OVER = 0.05;
    /** What a reference that may stand anywhere costs: six unknowns, each told some 300 times finer than usual. */
    private static final double ANYWHERE = 12 * Math.log(300);
    /** A fit is not followed to its end where its chi-square is this far beyond what is allowed. */
    private static final double MARGIN = 100;
    private static final int MOST_STEPS = 8;
    /** Steps after which a size must have taken most of the misfit away to be followed further. */
    private static final int PATIENCE = 3;
    private static final double LARGEST_STEP = 0.5;
    private static final double AGREEMENT_STDS = 0.05;
    /** Discrete causes that are followed beyond a first estimate. */
    private static final int FOLLOWED = 6;
    /** Units of length that drawings have, mm. */
    private static final double[] UNITS_MM = {10, 25.4, 1000};
    private static final double NEAR_UNIT = 0.25;
    /** A printer does not err by more than this; a scale of positions may. */
    private static final double MOST_OF_A_PRINTER = 0.15;
    /** No rotation in radians is larger, and none smaller than this is worth asking about. */
    private static final double TURN = 2 * Math.PI;
    private static final double LEAST_RADIANS = 0.2;

    private final CameraFit stated;
    /** What of chi-square is too much; 0 where no camera pose is known that it could be told of. */
    private final double misfit;
    private final int degrees;
    /** Whether something leaves nothing to explain. */
    private boolean settled;
    private final List<Explanation> found = new ArrayList<>();
    private final List<Trial> trials = new ArrayList<>();
    /** The camera as each cause that is or is not has it. */
    private final Map<Explanation, CameraFit> explained = new LinkedHashMap<>();
    /** The one or two poses of each reference in the camera frame, by its corners alone. */
    private final List<List<RigidTransform>> alone = new ArrayList<>();

    /** A cause that is or is not, with the first estimate of the camera if it is. */
    private static final class Trial {
        final Explanation cause;
        final List<Reference> references;
        final InitialPose.Estimate start;

        Trial(Explanation cause, List<Reference> references, InitialPose.Estimate start) {
            this.cause = cause;
            this.references = references;
            this.start = start;
        }
    }

    private CauseSearch(CameraFit stated) {
        this.stated = stated;
        degrees = 8 * stated.view.size() - 6;
        misfit = stated.modes.isEmpty() ? 0 : 2 * stated.mode().halfChiSquare() - degrees;
        double[] observed = stated.view.observedPx();
        MarkerPoseFinder finder = new MarkerPoseFinder();
        for (int m = 0; m < stated.view.size(); m++) {
            List<RigidTransform> poses = new ArrayList<>();
            for (PoseMode mode : finder.modes(Arrays.copyOfRange(observed, 8 * m, 8 * m + 8),
                    stated.view.references().get(m).sizeMm(), stated.lens, 1)) {
                poses.add(mode.state().cameraFromSet());
            }
            alone.add(poses);
        }
    }

    /** Whether a fit is so bad that causes must be tried outright. */
    static boolean isCalledFor(CameraFit fit) {
        return fit.view.size() > 1 && 2 * fit.mode().halfChiSquare()
                > CoverageRegion.chiSquareQuantile(SENSELESS, 8 * fit.view.size() - 6);
    }

    /**
     * What explains the misfit best, with what else may.
     *
     * @param stated the camera from references as stated, at a corner noise that the photo does not contradict
     * @return what was found, without an explanation where nothing explains it
     */
    static Contradiction of(CameraFit stated) {
        CauseSearch search = new CauseSearch(stated);
        search.discrete();
        // what has nothing to fit and leaves nothing to explain is beaten by nothing that has
        if (!search.settled) {
            search.sizes();
        }
        if (!search.settled) {
            search.oneElsewhere();
        }
        return search.result();
    }

    /**
     * What explains corners that no camera pose fits as the references are stated: only what is or is not, as there is
     * no pose to start from with what has a size.
     *
     * @param stated the camera from references as stated, without modes
     * @return null where nothing does; otherwise what does, with the camera as it would be if that were so
     */
    static @Nullable Contradiction ofNoPose(CameraFit stated) {
        CauseSearch search = new CauseSearch(stated);
        search.discrete();
        return search.found.isEmpty() ? null : search.result();
    }

    /** That for which most speaks, with what may be instead. */
    private Contradiction result() {
        found.sort(Comparator.comparingDouble(e -> -e.evidence()));
        if (found.isEmpty()) {
            return Contradiction.UNEXPLAINED;
        }
        Explanation best = found.get(0);
        List<Explanation> others = new ArrayList<>();
        for (Explanation other : found.subList(1, found.size())) {
            if (other.evidence() > best.evidence() - ReferenceCheck.DOUBT) {
                others.add(other);
            }
        }
        return new Contradiction(best.orInstead(others), explained.get(best));
    }

    // ---- causes that are or are not

    private void discrete() {
        List<Reference> as = stated.view.references();
        int n = as.size();
        for (int a = 0; a < n; a++) {
            for (int b = 0; b < a; b++) {
                List<Reference> changed = new ArrayList<>(as);
                changed.set(a, placedAs(as.get(a), as.get(b)));
                changed.set(b, placedAs(as.get(b), as.get(a)));
                add(Cause.EXCHANGED, Arrays.asList(as.get(b).id(), as.get(a).id()), -1, 0, n * (n - 1) / 2, changed);
            }
        }
        for (int quarters = 1; quarters < 4; quarters++) {
            List<Reference> all = new ArrayList<>();
            for (int m = 0; m < n; m++) {
                List<Reference> changed = new ArrayList<>(as);
                changed.set(m, turned(as.get(m), quarters));
                all.add(turned(as.get(m), quarters));
                add(Cause.TURNED, Collections.singletonList(as.get(m).id()), -1, quarters, 3 * n, changed);
            }
            add(Cause.ALL_TURNED, Collections.emptyList(), -1, quarters, 3, all);
        }
        for (int axis = 0; axis < 3; axis++) {
            List<Reference> changed = new ArrayList<>();
            for (Reference r : as) {
                double[] t = r.worldFromMarker().translationMm();
                t[axis] = -t[axis];
                changed.add(at(r, RigidTransform.of(r.worldFromMarker().rotation(), t)));
            }
            add(Cause.MIRRORED, Collections.emptyList(), axis, 0, 3, changed);
        }
        radians(as);
        units(as);
        trials.sort(Comparator.comparingDouble(t -> t.start.costPx2()));
        for (Trial trial : trials.subList(0, Math.min(FOLLOWED, trials.size()))) {
            CameraFit fit = fit(trial.references, stated.lens, stated.view.observedPx(),
                    trial.start.worldFromCamera(), allowed(degrees) + MARGIN);
            if (fit != null && explains(fit)) {
                Explanation cause = Explanation.outright(trial.cause.cause(), trial.cause.references(),
                        trial.cause.axis(), trial.cause.size()[0],
                        trial.cause.evidence() - 2 * fit.mode().halfChiSquare());
                found.add(cause);
                explained.put(cause, fit);
            }
        }
    }

    private void radians(List<Reference> as) {
        List<Reference> changed = new ArrayList<>();
        double largest = 0;
        for (Reference r : as) {
            double[] t = r.worldFromMarker().translationMm();
            double[] euler = r.worldFromMarker().eulerRad();
            for (int i = 0; i < 3; i++) {
                euler[i] = Math.toDegrees(Math.IEEEremainder(euler[i], TURN));
                largest = Math.max(largest, Math.abs(euler[i]));
            }
            changed.add(at(r, RigidTransform.ofEuler(t[0], t[1], t[2], euler[0], euler[1], euler[2])));
        }
        if (largest > LEAST_RADIANS && largest < TURN) {
            add(Cause.RADIANS, Collections.emptyList(), -1, 0, 1, changed);
        }
    }

    /** Another unit of positions or of sizes, where distances between markers, told by their sizes, speak for one. */
    private void units(List<Reference> as) {
        double scale = scale();
        for (double mm : UNITS_MM) {
            if (Math.abs(Math.log(scale / mm)) < NEAR_UNIT) {
                List<Reference> changed = new ArrayList<>();
                as.forEach(r -> changed.add(stretched(r, new double[] {mm, mm, mm})));
                add(Cause.POSITION_UNIT, Collections.emptyList(), -1, mm, 2 * UNITS_MM.length, changed);
            }
            if (Math.abs(Math.log(scale * mm)) < NEAR_UNIT) {
                List<Reference> changed = new ArrayList<>();
                as.forEach(r -> changed.add(ofSize(r, mm * r.sizeMm())));
                add(Cause.SIZE_UNIT, Collections.emptyList(), -1, mm, 2 * UNITS_MM.length, changed);
            }
        }
    }

    /** How many times farther apart markers are, by their own poses, than stated: the median over all pairs. */
    private double scale() {
        List<Reference> as = stated.view.references();
        List<Double> ratios = new ArrayList<>();
        for (int a = 0; a < as.size(); a++) {
            for (int b = 0; b < a; b++) {
                if (!alone.get(a).isEmpty() && !alone.get(b).isEmpty()) {
                    ratios.add(distance(alone.get(a).get(0), alone.get(b).get(0))
                            / distance(as.get(a).worldFromMarker(), as.get(b).worldFromMarker()));
                }
            }
        }
        Collections.sort(ratios);
        return ratios.isEmpty() ? 1 : ratios.get(ratios.size() / 2);
    }

    private static double distance(RigidTransform a, RigidTransform b) {
        double[] p = a.translationMm();
        double[] q = b.translationMm();
        return Math.sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1])
                + (p[2] - q[2]) * (p[2] - q[2]));
    }

    private void add(Cause cause, List<Integer> references, int axis, double size, int likes,
            List<Reference> changed) {
        ReferenceView view = view(changed, stated.view.observedPx());
        InitialPose.Estimate start = InitialPose.best(view, stated.lens, candidates(changed));
        if (start != null) {
            trials.add(new Trial(Explanation.outright(cause, references, axis, size, -2 * Math.log(likes)), changed,
                    start));
        }
    }

    /** Poses of the camera that one reference each speaks for, if they stand as in a changed cell. */
    private List<RigidTransform> candidates(List<Reference> changed) {
        List<RigidTransform> out = new ArrayList<>();
        for (int m = 0; m < changed.size(); m++) {
            Reference r = changed.get(m);
            // a marker of another size is seen along the same line, so much farther away
            double factor = r.sizeMm() / stated.view.references().get(m).sizeMm();
            for (RigidTransform pose : alone.get(m)) {
                double[] t = pose.translationMm();
                for (int i = 0; i < 3; i++) {
                    t[i] *= factor;
                }
                out.add(r.worldFromMarker().compose(RigidTransform.of(pose.rotation(), t).inverse()));
            }
        }
        return out;
    }

    // ---- causes that have a size

    private void sizes() {
        double logScale = Math.log(scale());
        for (CausePattern pattern : CausePattern.of(stated, stated.mode())) {
            int unknowns = pattern.columnsPx.length;
            double[] start = new double[unknowns];
            if (pattern.cause == Cause.MARKER_SIZE && Math.abs(logScale) > MOST_OF_A_PRINTER) {
                start[0] = -logScale;
            }
            follow(pattern, start);
        }
    }

    /** Finds the size of a cause by Newton's method on the score, the camera found anew at every size. */
    private void follow(CausePattern pattern, double[] start) {
        double[] size = start.clone();
        CameraFit fit = null;
        RigidTransform from = null;
        double std = Double.NaN;
        for (int step = 0; step < MOST_STEPS; step++) {
            fit = changed(pattern, size, from);
            if (fit == null) {
                return;
            }
            from = fit.worldFromCamera();
            double left = 2 * fit.mode().halfChiSquare() - degrees;
            if (step >= PATIENCE && left > misfit / 2) {
                return;
            }
            List<CausePattern> patterns = CausePattern.of(fit, fit.mode());
            PlacementScores scores = new PlacementScores(fit.view, fit.mode(), patterns);
            int first = scores.firstOfCauses();
            CausePattern same = null;
            for (CausePattern other : patterns) {
                if (other.cause == pattern.cause && other.axis == pattern.axis
                        && other.references.equals(pattern.references)) {
                    same = other;
                    break;
                }
                first += other.columnsPx.length;
            }
            double[] change = same == null ? null : scores.best(first, size.length);
            if (same == null || change == null) {
                return;
            }
            double longest = 0;
            for (int i = 0; i < size.length; i++) {
                change[i] *= same.typical;
                longest = Math.max(longest, Math.abs(change[i]) / (isShare(pattern.cause) ? LARGEST_STEP
                        : 20 * same.typical));
            }
            for (int i = 0; i < size.length; i++) {
                size[i] += change[i] / Math.max(1, longest);
            }
            std = same.typical * scores.bestStd(first, size.length);
            if (length(change) < AGREEMENT_STDS * std) {
                break;
            }
        }
        fit = changed(pattern, size, from);
        if (fit != null && explains(fit)) {
            double finer = Math.max(1, pattern.typical / std);
            double evidence = -2 * fit.mode().halfChiSquare() - 2 * size.length * Math.log(finer)
                    + 2 * Math.log(pattern.weight);
            add(pattern, size, std, evidence);
        }
    }

    private void add(CausePattern pattern, double[] size, double std, double evidence) {
        if (pattern.cause != Cause.MARKER_SIZE) {
            double[] shown = size.clone();
            for (int i = 0; i < shown.length && isShare(pattern.cause); i++) {
                shown[i] = Math.expm1(size[i]);
            }
            found.add(Explanation.ofSize(pattern.cause, pattern.references, pattern.axis, shown, std,
                    pattern.statedMm, evidence));
            return;
        }
        // markers that are larger, and positions that are closer together, are one and the same to every photo
        boolean printer = Math.abs(size[0]) < MOST_OF_A_PRINTER;
        found.add(Explanation.ofSize(Cause.MARKER_SIZE, pattern.references, -1,
                new double[] {Math.expm1(size[0])}, std, pattern.statedMm, evidence - (printer ? 0 : 1)));
        found.add(Explanation.ofSize(Cause.POSITION_SCALE, pattern.references, -1,
                new double[] {Math.exp(-size[0])}, std, Double.NaN, evidence - (printer ? 1 : 0)));
    }

    /** Whether the size of a cause is a share of what is stated. */
    static boolean isShare(Cause cause) {
        return cause != Cause.EDGE_SHIFT && cause != Cause.PRINCIPAL_POINT && cause != Cause.DISTORTION;
    }

    private static double length(double[] v) {
        double sum = 0;
        for (double x : v) {
            sum += x * x;
        }
        return Math.sqrt(sum);
    }

    /** The camera as if a cause had a size, from a start if there is one; null where that leads to no pose. */
    private @Nullable CameraFit changed(CausePattern pattern, double[] size, @Nullable RigidTransform from) {
        List<Reference> references = new ArrayList<>();
        double[] observed = stated.view.observedPx();
        double[] intrinsics = stated.lens.intrinsics();
        double factor = Math.exp(size[0]);
        switch (pattern.cause) {
            case FOCAL_LENGTH:
                intrinsics[PinholeCamera.FX] *= factor;
                intrinsics[PinholeCamera.FY] *= factor;
                break;
            case PRINCIPAL_POINT:
                intrinsics[PinholeCamera.CX] += size[0];
                intrinsics[PinholeCamera.CY] += size[1];
                break;
            case DISTORTION:
                intrinsics[Lenses.FIRST_RADIAL] += size[0];
                break;
            case EDGE_SHIFT:
                for (int m = 0; m < stated.view.size(); m++) {
                    double[] by = EdgeShift.ofCorners(Arrays.copyOfRange(observed, 8 * m, 8 * m + 8));
                    for (int i = 0; i < 8; i++) {
                        observed[8 * m + i] -= size[0] * by[i];
                    }
                }
                break;
            default:
                break;
        }
        for (Reference r : stated.view.references()) {
            if (pattern.cause == Cause.MARKER_SIZE
                    || (pattern.cause == Cause.SIZE_OF_SOME && pattern.references.contains(r.id()))) {
                references.add(ofSize(r, factor * r.sizeMm()));
            } else if (pattern.cause == Cause.STRETCH) {
                double[] factors = {1, 1, 1};
                factors[pattern.axis] = factor;
                references.add(stretched(r, factors));
            } else {
                references.add(r);
            }
        }
        PinholeCamera lens = stated.lens.withIntrinsics(intrinsics);
        RigidTransform worldFromCamera = from;
        if (worldFromCamera == null) {
            InitialPose.Estimate start = InitialPose.best(view(references, observed), lens, candidates(references));
            worldFromCamera = start == null ? null : start.worldFromCamera();
        }
        return worldFromCamera == null ? null
                : fit(references, lens, observed, worldFromCamera, Double.POSITIVE_INFINITY);
    }

    // ---- one reference that is somewhere else

    private void oneElsewhere() {
        int n = stated.view.size();
        for (int m = 0; m < n && n > 2; m++) {
            CameraFit rest = ReferenceCheck.without(stated, m);
            if (rest == null) {
                continue;
            }
            double chiSquare = 2 * rest.mode().halfChiSquare();
            if (isExplained(chiSquare, degrees - 8)) {
                found.add(Explanation.outright(Cause.REFERENCE_ELSEWHERE,
                        Collections.singletonList(stated.view.references().get(m).id()), -1, 0,
                        -chiSquare - 2 - ANYWHERE - 2 * Math.log(n)));
            }
        }
    }

    // ---- the camera of a changed cell

    private boolean explains(@Nullable CameraFit fit) {
        return fit != null && isExplained(2 * fit.mode().halfChiSquare(), degrees);
    }

    private double allowed(int of) {
        return Math.max(CoverageRegion.chiSquareQuantile(EXPLAINED, of), of + LEFT_OVER * misfit);
    }

    private boolean isExplained(double chiSquare, int of) {
        settled |= chiSquare < CoverageRegion.chiSquareQuantile(EXPLAINED, of);
        return chiSquare < allowed(of);
    }

    private ReferenceView view(List<Reference> references, double[] observedPx) {
        return ReferenceView.of(references, stated.errors).withObservations(observedPx);
    }

    private @Nullable CameraFit fit(List<Reference> references, PinholeCamera lens, double[] observedPx,
            RigidTransform start, double hopeless) {
        ReferenceView view = view(references, observedPx);
        PosePrior prior = stated.posePrior == null ? null
                : PosePrior.weak(CameraState.of(view.cameraFromSet(start), lens));
        CameraFit fit = new CameraFit(lens, stated.settings, view, stated.intrinsicsPrior, prior, stated.errors,
                stated.noiseLevel);
        PoseMode mode = fit.finder(view).mode(start, hopeless / 2);
        return mode == null ? null : fit.at(Collections.singletonList(mode), start);
    }

    private static Reference at(Reference r, RigidTransform worldFromMarker) {
        return new Reference(r.id(), r.sizeMm(), worldFromMarker, r.placement());
    }

    private static Reference placedAs(Reference r, Reference other) {
        return new Reference(r.id(), r.sizeMm(), other.worldFromMarker(), other.placement());
    }

    private static Reference ofSize(Reference r, double sizeMm) {
        return new Reference(r.id(), sizeMm, r.worldFromMarker(), r.placement());
    }

    private static Reference turned(Reference r, int quarters) {
        return at(r, r.worldFromMarker().compose(RigidTransform.ofEuler(0, 0, 0, 0, 0, quarters * Math.PI / 2)));
    }

    private static Reference stretched(Reference r, double[] factors) {
        double[] t = r.worldFromMarker().translationMm();
        for (int i = 0; i < 3; i++) {
            t[i] *= factors[i];
        }
        return at(r, RigidTransform.of(r.worldFromMarker().rotation(), t));
    }
}
