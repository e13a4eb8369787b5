package org.cellgauge.check;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
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
    private final List<Integer> notSeen;
    private final List<Integer> misplaced;
    private final boolean poseWithoutMisplaced;
    private final @Nullable Misfit misfit;
    private final OptionalDouble targetStdMm;

    /**
     * A test.
     *
     * @param objects the objects seen, in the order of the cell
     * @param notSeen marker ids of the others
     * @param misplaced ids of references that seem misplaced, the worst first
     * @param poseWithoutMisplaced whether the other references lead to a camera pose; of no meaning where none seems
     *     misplaced
     * @param misfit what the photo contradicts of what the figures rest on, or null
     * @param targetStdMm largest allowed standard deviation of any axis, mm, or empty for none
     */
    public TargetTest(List<JudgedObject> objects, List<Integer> notSeen, List<Integer> misplaced,
            boolean poseWithoutMisplaced, @Nullable Misfit misfit, OptionalDouble targetStdMm) {
        this.objects = Collections.unmodifiableList(new ArrayList<>(objects));
        this.notSeen = Collections.unmodifiableList(new ArrayList<>(notSeen));
        this.misplaced = Collections.unmodifiableList(new ArrayList<>(misplaced));
        this.poseWithoutMisplaced = poseWithoutMisplaced;
        this.misfit = misfit;
        this.targetStdMm = targetStdMm;
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
                poseWithoutMisplaced, misfit, targetStdMm);
    }

    /**
     * What it is held against of one object.
     *
     * @param objectId marker id
     * @return null where the object was not seen
     */
    public @Nullable JudgedObject object(int objectId) {
        for (JudgedObject object : objects) {
            if (object.id() == objectId) {
                return object;
            }
        }
        return null;
    }

    /**
     * The verdict.
     *
     * @return pass, fail, or no target
     */
    public Verdict verdict() {
        if (!targetStdMm.isPresent() || (objects.isEmpty() && notSeen.isEmpty())) {
            return Verdict.NO_TARGET;
        }
        // deviations rest on what the photo contradicts, and no figure says what they are instead
        return misfit == null && notSeen.isEmpty() && standing() == Standing.WITHIN ? Verdict.PASS : Verdict.FAIL;
    }

    /**
     * How the deviations of one point alone stand against the target, errors of misplaced references included; no
     * allowance is made for the Monte Carlo error.
     *
     * @param point of one of the objects
     * @return pass, fail, or no target
     */
    public Verdict verdict(JudgedPoint point) {
        if (!targetStdMm.isPresent()) {
            return Verdict.NO_TARGET;
        }
        double target = targetStdMm.getAsDouble();
        return misfit == null && point.largestStdMm() <= target
                && (misplaced.isEmpty() || point.largestErrorMm() <= target) ? Verdict.PASS : Verdict.FAIL;
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
        double target = targetStdMm.getAsDouble();
        Standing standing = Standing.WITHIN;
        for (JudgedObject object : objects) {
            if (!misplaced.isEmpty() && object.largestErrorMm() > target) {
                return Standing.BEYOND;
            }
            for (JudgedPoint point : object.points()) {
                for (int axis = 0; axis < 3; axis++) {
                    standing = worse(standing,
                            standing(point.sampledStdMm(axis), point.mcseStdMm(axis), target));
                }
            }
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
     * Whether more draws could change which side of a target the deviations are on.
     *
     * @param diagnostics of the draws so far
     * @param objects the objects seen
     * @param target mm
     */
    static boolean undecided(Diagnostics diagnostics, List<ObjectFit> objects, double target) {
        Standing standing = Standing.WITHIN;
        for (ObjectFit object : objects) {
            int id = object.marker.id();
            for (Quantity.Axis axis : JudgedObject.AXES) {
                standing = worse(standing, standing(diagnostics.of(Quantity.object(id, axis)), target));
                if (object.marker.hasGrip()) {
                    standing = worse(standing, standing(diagnostics.of(Quantity.grip(id, axis)), target));
                }
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

    /** The Monte Carlo error of the deviation that reaches farthest beyond the target. */
    private double undecidedMm() {
        double farthest = 0;
        double error = Double.NaN;
        for (JudgedObject object : objects) {
            for (int axis = 0; axis < 3; axis++) {
                for (JudgedPoint point : object.points()) {
                    double reach = point.sampledStdMm(axis) + GUARD_ERRORS * point.mcseStdMm(axis);
                    if (reach > farthest) {
                        farthest = reach;
                        error = point.mcseStdMm(axis);
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
                targetStdMm, misplacement(verdict == Verdict.PASS), misfit,
                verdict == Verdict.FAIL && !decided() ? OptionalDouble.of(undecidedMm()) : OptionalDouble.empty());
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
