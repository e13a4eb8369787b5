package org.cellgauge.placement;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.laplace.CameraFit;
import org.cellgauge.internal.laplace.ObjectFit;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.internal.pose.ReferenceView;
import org.cellgauge.internal.statistics.ChiSquare;
import org.cellgauge.internal.warning.CheckPhrase;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.settings.LikelihoodModel;
import org.cellgauge.warning.CheckWarning;
import org.cellgauge.warning.Warning;
import org.jspecify.annotations.Nullable;

/**
 * Whether the references fit together, what explains it where they do not, and what hangs on it; immutable.
 *
 * <p>Every direction of every reference has its {@link DirectionScore} (a mean-shift outlier test; data snooping in
 * photogrammetry: Baarda, "A testing procedure for use in geodetic networks", 1968). So has
 * every {@link Cause} that moves the corners of all references in a pattern of its own. That for which most speaks is
 * named: a reference is left out and the pose fitted again, the size of a cause is taken as unknown; and the rest is
 * tested anew, until nothing raises an alarm.
 *
 * <p>What the camera pose can absorb cannot be noticed: two references, or three in a plane, determine it with next to
 * nothing to spare.
 */
public final class ReferenceCheck {
    /** Twice the logarithm of 20: another reference for which this much less speaks may be the one instead. */
    static final double DOUBT = 2 * Math.log(20);
    /**
     * A reference that has to be off by more than this share of its distance from the camera to be noticed is said not
     * to be noticed: no linear model holds that far, and nobody reads anything off such a number.
     */
    private static final double SENSIBLE_SHARE = 0.25;
    /** Chance that references as stated fail to fit together without any being named. */
    public static final double LEVEL_TOGETHER = 0.001;

    private final List<ReferenceFit> fits;
    private final Map<Integer, ReferenceFit> byId = new HashMap<>();
    private final List<MisplacedReference> misplaced;
    private final @Nullable WithoutMisplaced without;
    private final double chiSquare;
    private final int degreesOfFreedom;

    private final NoiseFit noise;
    private final List<CauseFit> causeFits;
    private final List<Explanation> causes;
    private final @Nullable Contradiction contradiction;
    private final List<Overlap> overlaps;

    private ReferenceCheck(List<ReferenceFit> fits, List<CauseFit> causeFits, List<MisplacedReference> misplaced,
            List<Explanation> causes, @Nullable WithoutMisplaced without, double chiSquare, int degreesOfFreedom,
            NoiseFit noise, List<Overlap> overlaps, @Nullable Contradiction contradiction) {
        this.noise = noise;
        this.causeFits = Collections.unmodifiableList(causeFits);
        this.causes = Collections.unmodifiableList(causes);
        this.contradiction = contradiction;
        this.overlaps = Collections.unmodifiableList(overlaps);
        this.chiSquare = chiSquare;
        this.degreesOfFreedom = degreesOfFreedom;
        this.fits = Collections.unmodifiableList(fits);
        fits.forEach(fit -> byId.put(fit.id(), fit));
        this.misplaced = Collections.unmodifiableList(misplaced);
        this.without = without;
    }

    /**
     * Checks the references of a photo.
     *
     * @param camera the camera from all of them, at a corner noise that the photo does not contradict
     * @param objects the objects seen
     * @param noise whether corners are as precise as stated
     * @param overlaps markers in one place
     * @param contradiction what was found where no camera makes sense of the references as stated; null where one does
     */
    public static ReferenceCheck of(CameraFit camera, List<ObjectFit> objects, NoiseFit noise,
            List<Overlap> overlaps, @Nullable Contradiction contradiction) {
        PoseMode mode = camera.modes.get(0);
        // without rigid placements in the likelihood there is nothing stated that a test could hold against them
        boolean tested = camera.settings.model().likelihood() == LikelihoodModel.RIGID_MARKER;
        Named named = new Named(camera);
        List<DirectionScore> tests = tested ? named.tests() : Collections.emptyList();
        // what no linear model of so bad a fit would name is named already
        if (tested && (contradiction == null || contradiction.explanation() == null)) {
            named.search(tests);
        }
        PlacementScores scores = named.first;
        Set<Integer> leftOut = new HashSet<>(named.leftOut);
        double[] position = camera.view.worldFromCamera(mode.state().cameraFromSet()).translationMm();
        LargestCorrelation among = new LargestCorrelation(tests, scores);
        List<List<DirectionScore>> byReference = new ArrayList<>();
        for (int m = 0; m < camera.view.size(); m++) {
            byReference.add(new ArrayList<>());
        }
        List<CauseFit> causeFits = new ArrayList<>();
        for (DirectionScore test : tests) {
            if (test.reference == null) {
                causeFits.add(test.fit(among));
            } else {
                byReference.get(test.index).add(test);
            }
        }
        List<ReferenceFit> fits = new ArrayList<>();
        for (int m = 0; m < camera.view.size(); m++) {
            Reference reference = camera.view.references().get(m);
            fits.add(new ReferenceFit(reference,
                    distance(position, reference.worldFromMarker().translationMm()), scores.chiSquare(m),
                    leftOut.contains(reference.id()), byReference.get(m), among));
        }
        CameraFit rest = named.rest;
        int degrees = rest != null && rest.view.size() >= 2 && !tests.isEmpty()
                ? 6 * rest.view.size() - 6 - named.sweptColumns : 0;
        return new ReferenceCheck(fits, causeFits, named.misplaced, named.causes,
                named.misplaced.isEmpty() || rest == null ? null
                        : WithoutMisplaced.of(named.leftOut, camera, rest, objects),
                rest != null && degrees > 0
                        ? Math.max(0, ofPlacements(rest.modes.get(0)) - named.sweptChiSquare) : Double.NaN,
                Math.max(0, degrees), noise, overlaps, contradiction);
    }

    /** References and causes named one after another, each with the ones before it out of the way. */
    private static final class Named {
        final List<MisplacedReference> misplaced = new ArrayList<>();
        final List<Integer> leftOut = new ArrayList<>();
        final List<Explanation> causes = new ArrayList<>();
        final PlacementScores first;
        /** Null where the references left lead to no pose. */
        @Nullable
        CameraFit rest;
        double sweptChiSquare;
        int sweptColumns;
        private final List<CausePattern> swept = new ArrayList<>();
        private List<CausePattern> patterns;
        private PlacementScores scores;

        Named(CameraFit camera) {
            rest = camera;
            patterns = CausePattern.of(camera, camera.mode());
            scores = new PlacementScores(camera.view, camera.mode(), patterns);
            first = scores;
        }

        List<DirectionScore> tests() {
            return rest == null || rest.view.size() < 2 ? Collections.emptyList()
                    : DirectionScore.of(rest.view, patterns, scores);
        }

        void search(List<DirectionScore> tests) {
            List<DirectionScore> left = tests;
            DirectionScore worst = worst(left, Collections.emptyList(), true);
            while (worst != null) {
                List<Explanation> others = orInstead(left, worst);
                CameraFit of = Objects.requireNonNull(rest, "what is tested is left");
                if (worst.cause != null) {
                    causes.add(worst.explanation().orAlsoInstead(others));
                    swept.add(worst.cause);
                } else {
                    misplaced.add(new MisplacedReference(worst, others));
                    leftOut.add(worst.reference().id());
                    of = ReferenceCheck.without(of, worst.index);
                    rest = of;
                    if (of != null) {
                        patterns = CausePattern.of(of, of.mode());
                    }
                }
                if (of != null) {
                    sweep(of);
                }
                left = tests();
                worst = worst(left, Collections.emptyList(), true);
            }
        }

        /** The scores of what is left with the sizes of all causes named taken as unknown. */
        private void sweep(CameraFit of) {
            scores = new PlacementScores(of.view, of.mode(), patterns);
            sweptChiSquare = 0;
            sweptColumns = 0;
            int column = scores.firstOfCauses();
            for (CausePattern pattern : patterns) {
                boolean named = false;
                for (CausePattern known : swept) {
                    named |= known.isLike(pattern);
                }
                for (int c = 0; c < pattern.columnsPx.length; c++, column++) {
                    if (named && scores.explained(column) > 0) {
                        sweptChiSquare += scores.explained(column);
                        sweptColumns++;
                        scores = scores.without(column);
                    }
                }
            }
        }
    }

    /**
     * Chi-square of a fit but for what no placement explains (how square markers are has its own test,
     * {@link NoiseFit}): the two are independent, and one of them says nothing of placements.
     */
    private static double ofPlacements(PoseMode mode) {
        double sum = 2 * mode.halfChiSquare();
        for (int m = 0; m < mode.markers(); m++) {
            sum -= mode.squareChiSquare(m);
        }
        return Math.max(0, sum);
    }

    /** The test for which most speaks, of what is not excepted. */
    private static @Nullable DirectionScore worst(List<DirectionScore> tests, List<DirectionScore> excepted,
            boolean alarmsOnly) {
        DirectionScore worst = null;
        for (DirectionScore test : tests) {
            if ((test.raisesAlarm() || !alarmsOnly) && (worst == null || test.evidence() > worst.evidence())
                    && excepted.stream().noneMatch(test::isOfTheSame)) {
                worst = test;
            }
        }
        return worst;
    }

    private static List<Explanation> orInstead(List<DirectionScore> tests, DirectionScore worst) {
        List<DirectionScore> excepted = new ArrayList<>();
        excepted.add(worst);
        List<Explanation> others = new ArrayList<>();
        while (true) {
            DirectionScore next = worst(tests, excepted, false);
            if (next == null || next.evidence() < worst.evidence() - DOUBT) {
                return others;
            }
            others.add(next.explanation());
            excepted.add(next);
        }
    }

    /** The camera from all references of a target but one; null if they lead to no pose. */
    static @Nullable CameraFit without(CameraFit target, int leftOut) {
        List<Integer> kept = new ArrayList<>();
        for (int m = 0; m < target.view.size(); m++) {
            if (m != leftOut) {
                kept.add(m);
            }
        }
        ReferenceView view = target.view.only(kept);
        RigidTransform start = target.view.worldFromCamera(target.modes.get(0).state().cameraFromSet());
        List<PoseMode> modes = target.finder(view).modes(start);
        return modes.isEmpty() ? null : target.with(view, modes);
    }

    /**
     * How each reference fits the others.
     *
     * @return those that the camera pose rests on, in the order of the cell
     */
    public List<ReferenceFit> fits() {
        return fits;
    }

    /**
     * How one reference fits the others.
     *
     * @param id marker id
     * @return its figures, or null where the camera pose does not rest on it
     */
    public @Nullable ReferenceFit fit(int id) {
        return byId.get(id);
    }

    /**
     * References that stand farther off than their stated precision allows.
     *
     * @return the worst first, each after those before it were left out; mostly none
     */
    public List<MisplacedReference> misplaced() {
        return misplaced;
    }

    /**
     * Causes that move the corners of all references, or of many, and that the photo speaks for.
     *
     * @return the likeliest first, each after those before it were allowed for; mostly none
     */
    public List<Explanation> causes() {
        return contradiction != null && contradiction.explanation() != null
                ? Collections.singletonList(contradiction.explanation()) : causes;
    }

    /**
     * What the photo says of each cause that has a size.
     *
     * @return one per cause that a size of could show; of a principal point one per direction
     */
    public List<CauseFit> causeFits() {
        return causeFits;
    }

    /**
     * Whether the references contradict each other so that no figure is to be trusted: taken as stated no camera pose
     * makes sense of them, or what is named leaves them in contradiction.
     *
     * @return mostly false
     */
    public boolean contradictory() {
        return contradiction != null || !fitTogether();
    }

    /**
     * Misfit of all references together that are not named as misplaced, but for how square they are.
     *
     * @return chi-square distributed with {@link #degreesOfFreedom()} if placement and corner noise are as stated; NaN
     *     where there are fewer than two, or references are not tested
     */
    public double chiSquare() {
        return chiSquare;
    }

    /**
     * Six per reference, less the six of the camera pose.
     *
     * @return 0 where there is no {@link #chiSquare()}
     */
    public int degreesOfFreedom() {
        return degreesOfFreedom;
    }

    /**
     * Chance of a misfit as large as this if the cell is as stated.
     *
     * @return between 0 and 1; NaN where there is none
     */
    public double pValue() {
        return ChiSquare.pValue(chiSquare, degreesOfFreedom);
    }

    /**
     * Whether the references, but for misplaced ones, fit together as stated.
     *
     * @return true as well where that is not tested
     */
    public boolean fitTogether() {
        return !(pValue() < LEVEL_TOGETHER);
    }

    /** How many times worse than stated they fit. */
    private double timesWorse() {
        return Math.sqrt(chiSquare / degreesOfFreedom);
    }

    /**
     * Whether the photo contradicts what all figures rest on, so that none of them can meet a target: corners are
     * noisier than stated or of no square, two markers are in one place, or the references together fit worse than
     * stated.
     *
     * @return the noise first; mostly null
     */
    public boolean contradicted() {
        return misfit() != null;
    }

    /**
     * What that adds to a reason: the likeliest cause, markers in one place, or how badly all fit; null where nothing
     * is contradicted.
     */
    public @Nullable Misfit misfit() {
        return !causes().isEmpty() ? Misfit.ofCause(causes().get(0))
                : !overlaps.isEmpty() ? overlaps.get(0).misfit()
                : contradiction != null ? Misfit.ofContradiction()
                : !fitTogether() ? Misfit.ofReferences(timesWorse()) : noise.misfit();
    }

    /**
     * Markers in one place.
     *
     * @return unmodifiable, mostly empty
     */
    public List<Overlap> overlaps() {
        return overlaps;
    }

    /**
     * Whether corners are as precise as stated.
     *
     * @return how square markers are, in stated deviations; nothing where the noise is not stated
     */
    public NoiseFit noise() {
        return noise;
    }

    /**
     * Camera and objects without them.
     *
     * @return null where no reference is misplaced, or the others lead to no pose
     */
    public @Nullable WithoutMisplaced without() {
        return without;
    }

    /**
     * How far off a reference would have to be to be noticed, for people.
     *
     * @return a sentence or two with full stops; empty where references are not tested
     */
    public String noticeable() {
        double[] worstMm = new double[3];
        double most = 0;
        boolean tested = false;
        for (ReferenceFit fit : fits) {
            tested |= fit.tested();
            for (int axis = 0; axis < 3; axis++) {
                double mm = fit.detectable()[axis];
                boolean sensible = mm <= SENSIBLE_SHARE * fit.distanceMm();
                worstMm[axis] = Math.max(worstMm[axis], sensible ? mm : Double.POSITIVE_INFINITY);
                most = Math.max(most, sensible ? mm / fit.statedStdMm(axis) : 0);
            }
        }
        if (!tested) {
            return "";
        }
        List<String> sizes = new ArrayList<>();
        List<String> never = new ArrayList<>();
        for (int axis = 0; axis < 3; axis++) {
            String name = "xyz".substring(axis, axis + 1);
            if (Double.isInfinite(worstMm[axis])) {
                never.add(name);
            } else {
                sizes.add(String.format(Decimal.POINT, worstMm[axis] < 100 ? "%.1f mm in %s" : "%.0f mm in %s",
                        worstMm[axis], name));
            }
        }
        String text = sizes.isEmpty() ? ""
                : "To be noticed in 19 of 20 photos a reference would have to be off by up to "
                + Listing.or(sizes) + ".";
        text += never.isEmpty() ? "" : (text.isEmpty() ? "" : " ") + "A reference that is off in "
                + Listing.or(never) + " would not be noticed.";
        if (most > DirectionScore.LOOKED_FOR) {
            text += String.format(Decimal.POINT, never.isEmpty() ? " That is more than %.0f times what is stated: more "
                    + "references would show less."
                    : " More references would show less than %.0f times what is stated.", DirectionScore.LOOKED_FOR);
        } else if (!never.isEmpty()) {
            text += " More references would show it.";
        }
        return text;
    }

    /** Warnings to the user. */
    public List<Warning> warnings() {
        List<Warning> warnings = new ArrayList<>();
        causes().forEach(cause -> warnings.add(cause.warning()));
        overlaps.forEach(overlap -> warnings.add(overlap.warning()));
        if (contradiction != null && contradiction.explanation() == null) {
            warnings.add(Warning.of(CheckWarning.REFERENCES_CONTRADICT));
        }
        warnings.addAll(noise.warnings());
        for (MisplacedReference reference : misplaced) {
            warnings.add(reference.warning());
        }
        if (!misplaced.isEmpty()) {
            warnings.add(whatRestsOnThem());
        }
        if (contradiction == null && !fitTogether()) {
            warnings.add(Warning.of(CheckWarning.REFERENCES_DO_NOT_FIT, Decimal.of(timesWorse(), 1),
                    Decimal.of(chiSquare, 0), degreesOfFreedom));
        }
        return warnings;
    }

    /** What leaving out the misplaced references changes, largest change first. */
    private Warning whatRestsOnThem() {
        boolean one = misplaced.size() == 1;
        if (without == null) {
            return Warning.of(one ? CheckWarning.NO_POSE_WITHOUT_IT : CheckWarning.NO_POSE_WITHOUT_THEM);
        }
        Warning moved = Warning.of(CheckPhrase.CAMERA);
        double[] move = without.cameraMoveMm();
        double most = -1;
        for (WithoutMisplaced.ObjectWithout object : without.objects()) {
            if (length(object.moveMm()) > most) {
                most = length(object.moveMm());
                move = object.moveMm();
                moved = Warning.of(CheckPhrase.OBJECT, object.id());
            }
            double[] gripMove = object.gripMoveMm();
            if (gripMove != null && length(gripMove) > most) {
                most = length(gripMove);
                move = gripMove;
                moved = Warning.of(CheckPhrase.GRIP, object.id());
            }
        }
        List<Integer> ids = new ArrayList<>();
        misplaced.forEach(reference -> ids.add(reference.id()));
        return Warning.of(one ? CheckWarning.FIGURES_REST_ON_IT : CheckWarning.FIGURES_REST_ON_THEM, Listing.and(ids),
                moved, Decimal.of(move[0], 1), Decimal.of(move[1], 1), Decimal.of(move[2], 1),
                without.objects().size() > 1 ? Warning.of(CheckPhrase.MORE_THAN_ANY_OTHER) : "",
                without.objects().isEmpty() ? "" : Warning.of(CheckPhrase.LARGEST_DEVIATION,
                        Decimal.of(without.worstStdMm(), 2), Decimal.of(without.worstStdWithAllMm(), 2)));
    }

    private static double distance(double[] a, double[] b) {
        return length(new double[] {a[0] - b[0], a[1] - b[1], a[2] - b[2]});
    }

    private static double length(double[] v) {
        return Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
}
