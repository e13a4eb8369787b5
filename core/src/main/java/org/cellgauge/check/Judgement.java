package org.cellgauge.check;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.OptionalDouble;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.estimate.ModeEstimate;
import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.internal.laplace.ObjectFit;
import org.cellgauge.placement.Misfit;
import org.cellgauge.placement.ReferenceCheck;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.sampling.Quantity.Axis;
import org.cellgauge.statistics.ChainDiagnostics;

/**
 * The verdict on figures that are there already, and why. Nothing here is sampled, so that another target can be held
 * against the same draws.
 */
final class Judgement {
    /**
     * A deviation meets a target, or misses it, if it does by more than this many of its Monte Carlo errors: a guard
     * band as in JCGM 106:2012, section 8.3, so that no seed decides.
     */
    static final double GUARD_ERRORS = 2;
    private static final List<Axis> POSITION = Collections.unmodifiableList(Arrays.asList(Axis.X, Axis.Y, Axis.Z));

    private final CellEstimate estimate;
    private final Diagnostics diagnostics;
    private final ReferenceCheck references;
    private final Misfit misfit;
    private final OptionalDouble targetStdMm;
    private final List<Integer> missing;

    /**
     * A judgement.
     *
     * @param cell the cell with its target
     * @param estimate what the chains say
     * @param diagnostics their convergence
     * @param references whether the references fit together: a target must hold whether they are right or not
     */
    Judgement(Cell cell, CellEstimate estimate, Diagnostics diagnostics, ReferenceCheck references) {
        this.misfit = references.misfit();
        this.estimate = estimate;
        this.diagnostics = diagnostics;
        this.references = references;
        this.targetStdMm = cell.targetStdMm();
        this.missing = new ArrayList<>();
        for (ObjectMarker marker : cell.objects()) {
            if (estimate.object(marker.id()) == null) {
                missing.add(marker.id());
            }
        }
    }

    /** The verdict on all objects of the cell. */
    Verdict verdict() {
        Verdict verdict = verdict(estimate.objects());
        return verdict == Verdict.PASS && !missing.isEmpty() ? Verdict.FAIL : verdict;
    }

    /** The verdict on one object; an object that was not seen misses its target. */
    Verdict verdict(int objectId) {
        ObjectEstimate object = estimate.object(objectId);
        Verdict verdict = verdict(only(object));
        return verdict == Verdict.PASS && object == null ? Verdict.FAIL : verdict;
    }

    private Verdict verdict(List<ObjectEstimate> objects) {
        if (!diagnostics.converged()) {
            return Verdict.NOT_CONVERGED;
        }
        if (ModeEstimate.areAmbiguous(estimate.cameraModes())) {
            return Verdict.AMBIGUOUS;
        }
        for (ObjectEstimate object : objects) {
            if (ModeEstimate.areAmbiguous(object.modes())) {
                return Verdict.AMBIGUOUS;
            }
        }
        if (!targetStdMm.isPresent()) {
            return Verdict.NO_TARGET;
        }
        // deviations rest on what the photo contradicts, and no figure says what they are instead
        return misfit == null && standing(objects) == Standing.WITHIN ? Verdict.PASS : Verdict.FAIL;
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

    private Standing standing(List<ObjectEstimate> objects) {
        double target = targetStdMm.getAsDouble();
        Standing standing = Standing.WITHIN;
        for (ObjectEstimate object : objects) {
            if (references.errorMm(object) > target) {
                return Standing.BEYOND;
            }
            standing = worse(standing, standing(diagnostics, object.id(), object.grip() != null, target));
        }
        return standing;
    }

    private static Standing worse(Standing a, Standing b) {
        return a.compareTo(b) >= 0 ? a : b;
    }

    /** Where the deviations of one object and its gripping point stand. */
    private static Standing standing(Diagnostics diagnostics, int objectId, boolean grip, double target) {
        Standing standing = Standing.WITHIN;
        for (Quantity quantity : deviations(objectId, grip)) {
            ChainDiagnostics d = diagnostics.of(quantity);
            double error = GUARD_ERRORS * d.mcseSd();
            standing = worse(standing, d.std() - error > target ? Standing.BEYOND
                    : d.std() + error <= target ? Standing.WITHIN : Standing.UNDECIDED);
        }
        return standing;
    }

    /** What is held against a target. */
    private static List<Quantity> deviations(int objectId, boolean grip) {
        List<Quantity> all = new ArrayList<>();
        for (Axis axis : POSITION) {
            all.add(Quantity.object(objectId, axis));
            if (grip) {
                all.add(Quantity.grip(objectId, axis));
            }
        }
        return all;
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
            standing = worse(standing, standing(diagnostics, object.marker.id(), object.marker.hasGrip(), target));
        }
        return standing == Standing.UNDECIDED;
    }

    /** Whether {@link #verdict()} is pass or fail, and would be with any number of draws. */
    boolean decided() {
        return decided(verdict(), estimate.objects(), missing);
    }

    /** Whether {@link #verdict(int)} is. */
    boolean decided(int objectId) {
        ObjectEstimate object = estimate.object(objectId);
        return decided(verdict(objectId), only(object),
                object == null ? Collections.singletonList(objectId) : Collections.emptyList());
    }

    private boolean decided(Verdict verdict, List<ObjectEstimate> objects, List<Integer> notSeen) {
        return (verdict == Verdict.PASS || verdict == Verdict.FAIL)
                && (misfit != null || !notSeen.isEmpty() || standing(objects) != Standing.UNDECIDED);
    }

    /** The Monte Carlo error of the deviation that reaches farthest beyond the target. */
    private double undecidedMm(List<ObjectEstimate> objects) {
        double farthest = 0;
        double error = Double.NaN;
        for (ObjectEstimate object : objects) {
            for (Quantity quantity : deviations(object.id(), object.grip() != null)) {
                ChainDiagnostics d = diagnostics.of(quantity);
                if (d.std() + GUARD_ERRORS * d.mcseSd() > farthest) {
                    farthest = d.std() + GUARD_ERRORS * d.mcseSd();
                    error = d.mcseSd();
                }
            }
        }
        return error;
    }

    /** Why {@link #verdict()} is what it is. */
    Reason finding() {
        return finding(verdict(), estimate.objects(), missing);
    }

    /** Why {@link #verdict(int)} is what it is. */
    Reason finding(int objectId) {
        ObjectEstimate object = estimate.object(objectId);
        return finding(verdict(objectId), only(object),
                object == null ? Collections.singletonList(objectId) : Collections.emptyList());
    }

    private Reason finding(Verdict verdict, List<ObjectEstimate> objects, List<Integer> notSeen) {
        if (verdict == Verdict.NOT_CONVERGED) {
            return Reason.notConverged(diagnostics);
        }
        if (ModeEstimate.areAmbiguous(estimate.cameraModes())) {
            return Reason.twoCameraPoses(estimate.cameraModes().get(1).weight());
        }
        for (ObjectEstimate object : objects) {
            if (ModeEstimate.areAmbiguous(object.modes())) {
                return Reason.twoObjectPoses(object.id(), object.modes().get(1).weight());
            }
        }
        return Reason.largestDeviation(objects, verdict == Verdict.FAIL ? notSeen : Collections.emptyList(),
                targetStdMm, references.misplacement(verdict == Verdict.PASS, objects), misfit,
                verdict == Verdict.FAIL && !decided(verdict, objects, notSeen)
                        ? OptionalDouble.of(undecidedMm(objects)) : OptionalDouble.empty());
    }

    private static List<ObjectEstimate> only(ObjectEstimate object) {
        return object == null ? Collections.emptyList() : Collections.singletonList(object);
    }
}
