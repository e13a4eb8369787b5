package org.cellgauge.check;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.OptionalDouble;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;

/**
 * The verdict on figures that are there already, and why. Nothing here is sampled, so that another target can be held
 * against the same draws.
 */
final class Judgement {
    private final CellEstimate estimate;
    private final Diagnostics diagnostics;
    private final ReferenceCheck references;
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
        if (ambiguous(estimate.cameraModes())) {
            return Verdict.AMBIGUOUS;
        }
        for (ObjectEstimate object : objects) {
            if (ambiguous(object.modes())) {
                return Verdict.AMBIGUOUS;
            }
        }
        if (!targetStdMm.isPresent()) {
            return Verdict.NO_TARGET;
        }
        for (ObjectEstimate object : objects) {
            if (!references.meets(object, targetStdMm.getAsDouble())) {
                return Verdict.FAIL;
            }
        }
        return Verdict.PASS;
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
        if (ambiguous(estimate.cameraModes())) {
            return Reason.twoCameraPoses(estimate.cameraModes().get(1).weight());
        }
        for (ObjectEstimate object : objects) {
            if (ambiguous(object.modes())) {
                return Reason.twoObjectPoses(object.id(), object.modes().get(1).weight());
            }
        }
        return Reason.largestDeviation(objects, verdict == Verdict.FAIL ? notSeen : Collections.emptyList(),
                targetStdMm, references.misplacement(verdict == Verdict.PASS, objects));
    }

    private static List<ObjectEstimate> only(ObjectEstimate object) {
        return object == null ? Collections.emptyList() : Collections.singletonList(object);
    }

    /** Whether a second pose holds too much of the posterior to be left aside. */
    static boolean ambiguous(List<ModeEstimate> modes) {
        return modes.size() > 1 && modes.get(1).weight() > CellCheck.AMBIGUOUS_SHARE;
    }
}
