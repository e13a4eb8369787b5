package org.cellgauge.check;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.function.Function;
import org.cellgauge.cell.Requirement;
import org.cellgauge.cell.Target;
import org.cellgauge.internal.laplace.ObjectFit;
import org.cellgauge.placement.Misfit;
import org.cellgauge.placement.Misplacement;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.statistics.ChainDiagnostics;
import org.jspecify.annotations.Nullable;

/**
 * A target held against the deviations of a result whose figures are to be trusted; immutable. It needs the figures
 * alone, whether a check has just found them or a file has kept them.
 */
public final class TargetTest {
    /**
     * A deviation meets a target, or misses it, if it does by more than this many of its Monte Carlo errors: a guard
     * band as in JCGM 106:2012, section 8.3, so that no seed decides.
     */
    static final double GUARD_ERRORS = 2;

    private final List<JudgedObject> objects;
    private final Map<Integer, JudgedObject> byId = new HashMap<>();
    private final List<Integer> notSeen;
    private final List<Integer> misplaced;
    private final boolean poseWithoutMisplaced;
    private final @Nullable Misfit misfit;
    private final Target target;

    /**
     * A test.
     *
     * @param objects the objects seen, in the order of the cell
     * @param notSeen marker ids of the others; those of which the target asks nothing do not count
     * @param misplaced ids of references that seem misplaced, the worst first
     * @param poseWithoutMisplaced whether the other references lead to a camera pose; of no meaning where none seems
     *     misplaced
     * @param misfit what the photo contradicts of what the figures rest on, or null
     * @param target what is asked of the objects
     */
    public TargetTest(List<JudgedObject> objects, List<Integer> notSeen, List<Integer> misplaced,
            boolean poseWithoutMisplaced, @Nullable Misfit misfit, Target target) {
        this.objects = Collections.unmodifiableList(new ArrayList<>(objects));
        objects.forEach(object -> byId.put(object.id(), object));
        List<Integer> missed = new ArrayList<>(notSeen);
        // of an object of which nothing is asked, nothing is missed where it is not seen
        missed.removeIf(id -> target.isAny() && !target.of(id).isAny());
        this.notSeen = Collections.unmodifiableList(missed);
        this.misplaced = Collections.unmodifiableList(new ArrayList<>(misplaced));
        this.poseWithoutMisplaced = poseWithoutMisplaced;
        this.misfit = misfit;
        this.target = target;
    }

    /** Where deviations stand against the target, given that they are known to within a Monte Carlo error. */
    private enum Standing {
        /** All are within the target by more than {@link #GUARD_ERRORS} of their errors. */
        WITHIN,
        /** One lies within so many errors of the target, and none beyond. */
        UNDECIDED,
        /** One is beyond it by more. */
        BEYOND
    }

    /**
     * The same target held against one object alone.
     *
     * @param objectId marker id of an object of the cell
     * @return the test
     */
    public TargetTest of(int objectId) {
        JudgedObject object = object(objectId);
        return new TargetTest(object == null ? Collections.emptyList() : Collections.singletonList(object),
                object == null ? Collections.singletonList(objectId) : Collections.emptyList(), misplaced,
                poseWithoutMisplaced, misfit,
                new Target(target.of(objectId), Collections.emptyMap()));
    }

    /**
     * What it is held against of one object.
     *
     * @param objectId marker id
     * @return null where the object was not seen
     */
    public @Nullable JudgedObject object(int objectId) {
        return byId.get(objectId);
    }

    /**
     * The verdict.
     *
     * @return pass, fail, or no target
     */
    public Verdict verdict() {
        if (!target.isAny() || (objects.isEmpty() && notSeen.isEmpty())) {
            return Verdict.NO_TARGET;
        }
        // deviations rest on what the photo contradicts, and no figure says what they are instead
        return misfit == null && notSeen.isEmpty() && standing() == Standing.WITHIN ? Verdict.PASS : Verdict.FAIL;
    }

    /**
     * How one point alone stands against what is asked of its object, errors of misplaced references included; no
     * allowance is made for the Monte Carlo error.
     *
     * @param object one of the objects
     * @param point its position or its gripping point
     * @return pass, fail, or no target
     */
    public Verdict verdict(JudgedObject object, JudgedPoint point) {
        Requirement asked = target.of(object.id());
        if (!asked.isAny()) {
            return Verdict.NO_TARGET;
        }
        boolean within = misfit == null && !errorTellsAgainst(asked, point);
        for (int axis = 0; axis < 3; axis++) {
            within &= point.stdMm(axis) <= asked.stdMm().of(axis);
        }
        for (Conformity conformity : point.conformities()) {
            within &= conformity.isKept();
        }
        return within ? Verdict.PASS : Verdict.FAIL;
    }

    /** Whether a position would be too far off if references are misplaced. */
    private boolean errorTellsAgainst(Requirement asked, JudgedPoint point) {
        if (misplaced.isEmpty() || !asked.isAny()) {
            return false;
        }
        // where nothing says how far off it would be, that is infinite; probabilities include what is said
        boolean against = Double.isInfinite(point.largestErrorMm());
        for (int axis = 0; axis < 3; axis++) {
            against |= point.errorMm(axis) > asked.stdMm().of(axis);
        }
        return against;
    }

    /**
     * What the photo contradicts of what the figures rest on, so that no target counts as met.
     *
     * @return mostly null
     */
    public @Nullable Misfit misfit() {
        return misfit;
    }

    private Standing standing() {
        Standing standing = Standing.WITHIN;
        for (JudgedObject object : objects) {
            Requirement asked = target.of(object.id());
            for (JudgedPoint point : object.points()) {
                if (errorTellsAgainst(asked, point)) {
                    return Standing.BEYOND;
                }
                for (int axis = 0; axis < 3; axis++) {
                    standing = worse(standing, standing(point.sampledStdMm(axis), point.mcseStdMm(axis),
                            asked.stdMm().of(axis)));
                }
                standing = worse(standing, standing(point.conformities()));
            }
        }
        return standing;
    }

    private static Standing standing(List<Conformity> conformities) {
        Standing standing = Standing.WITHIN;
        for (Conformity c : conformities) {
            standing = worse(standing, !c.isDecided() ? Standing.UNDECIDED
                    : c.isKept() ? Standing.WITHIN : Standing.BEYOND);
        }
        return standing;
    }

    private static Standing worse(Standing a, Standing b) {
        return a.compareTo(b) >= 0 ? a : b;
    }

    private static Standing standing(double stdMm, double mcseMm, double target) {
        double error = GUARD_ERRORS * mcseMm;
        return stdMm - error > target ? Standing.BEYOND
                : stdMm + error <= target ? Standing.WITHIN : Standing.UNDECIDED;
    }

    /**
     * Whether more draws could change which side of a target the deviations and probabilities are on.
     *
     * @param diagnostics of the draws so far
     * @param objects the objects seen
     * @param target what is asked of them
     * @param conformities how probable it is with these draws that an object keeps its tolerances
     */
    static boolean undecided(Diagnostics diagnostics, List<ObjectFit> objects, Target target,
            Function<ObjectFit, List<Conformity>> conformities) {
        Standing standing = Standing.WITHIN;
        for (ObjectFit object : objects) {
            int id = object.marker.id();
            Requirement asked = target.of(id);
            for (int i = 0; i < JudgedObject.AXES.size(); i++) {
                Quantity.Axis axis = JudgedObject.AXES.get(i);
                double limit = asked.stdMm().of(i);
                standing = worse(standing, standing(diagnostics.of(Quantity.object(id, axis)), limit));
                if (object.marker.hasGrip()) {
                    standing = worse(standing, standing(diagnostics.of(Quantity.grip(id, axis)), limit));
                }
            }
            if (asked.asksForProbability()) {
                standing = worse(standing, standing(conformities.apply(object)));
            }
        }
        return standing == Standing.UNDECIDED;
    }

    private static Standing standing(ChainDiagnostics d, double target) {
        return standing(d.std(), d.mcseSd(), target);
    }

    /**
     * Whether the verdict is pass or fail, and would be with any number of draws.
     *
     * @return as {@link CheckResult#decided()}
     */
    public boolean decided() {
        return verdict() != Verdict.NO_TARGET
                && (misfit != null || !notSeen.isEmpty() || standing() != Standing.UNDECIDED);
    }

    /** The Monte Carlo error of the deviation that reaches farthest beyond its target, if one is undecided. */
    private OptionalDouble undecidedMm() {
        double farthest = 0;
        OptionalDouble error = OptionalDouble.empty();
        for (JudgedObject object : objects) {
            Requirement asked = target.of(object.id());
            for (int axis = 0; axis < 3; axis++) {
                double limit = asked.stdMm().of(axis);
                for (JudgedPoint point : object.points()) {
                    double reach = (point.sampledStdMm(axis) + GUARD_ERRORS * point.mcseStdMm(axis)) / limit;
                    if (reach > farthest && standing(point.sampledStdMm(axis), point.mcseStdMm(axis), limit)
                            != Standing.WITHIN) {
                        farthest = reach;
                        error = OptionalDouble.of(point.mcseStdMm(axis));
                    }
                }
            }
        }
        return error;
    }

    /**
     * Why the verdict is what it is.
     *
     * @return the reason in parts
     */
    public Reason reason() {
        Verdict verdict = verdict();
        return Reason.largestDeviation(objects, verdict == Verdict.FAIL ? notSeen : Collections.emptyList(),
                target, misplacement(verdict == Verdict.PASS), misfit,
                verdict == Verdict.FAIL && !decided() ? undecidedMm() : OptionalDouble.empty());
    }

    /** The largest error that a stated position has if references are misplaced; null where none seems to be. */
    private @Nullable Misplacement misplacement(boolean targetMet) {
        if (misplaced.isEmpty()) {
            return null;
        }
        Misplacement worst = new Misplacement(misplaced, targetMet, OptionalInt.empty(), false, 0,
                poseWithoutMisplaced ? 0 : Double.POSITIVE_INFINITY);
        for (JudgedObject object : objects) {
            for (JudgedPoint point : object.points()) {
                for (int axis = 0; axis < 3; axis++) {
                    if (point.errorMm(axis) > worst.errorMm()) {
                        worst = new Misplacement(misplaced, targetMet, OptionalInt.of(object.id()),
                                point == object.grip(), axis, point.errorMm(axis));
                    }
                }
            }
        }
        return worst;
    }
}
