package org.cellgauge.check;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.estimate.ModeEstimate;
import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.placement.Misfit;
import org.cellgauge.placement.MisplacedReference;
import org.cellgauge.placement.ReferenceCheck;
import org.cellgauge.sampling.Draws;
import org.cellgauge.sampling.QuantityLayout;
import org.jspecify.annotations.Nullable;

/**
 * The verdict on figures that are there already, and why: whether they are to be trusted, and if so, where they stand
 * against the target. Nothing here is sampled, so that another target can be held against the same draws.
 */
final class Judgement {
    private final CellEstimate estimate;
    private final Diagnostics diagnostics;
    private final TargetTest target;
    /** What references contradict each other by, so that there is no figure; null where they do not. */
    private final @Nullable Misfit contradiction;

    /**
     * A judgement.
     *
     * @param cell the cell with its target
     * @param estimate what the chains say
     * @param diagnostics their convergence
     * @param references whether the references fit together: a target must hold whether they are right or not
     * @param againstLaplace how far the chains are from Laplace's approximation
     * @param draws of all chains, which probabilities are counted in
     * @param layout of their quantities
     */
    Judgement(Cell cell, CellEstimate estimate, Diagnostics diagnostics, ReferenceCheck references,
            ChainsAgainstLaplace againstLaplace, List<Draws> draws, QuantityLayout layout) {
        this.estimate = estimate;
        this.diagnostics = diagnostics;
        List<JudgedObject> objects = new ArrayList<>();
        for (ObjectEstimate object : estimate.objects()) {
            objects.add(JudgedObject.of(object, diagnostics, references.without(),
                    new Conformities(draws, layout, cell.target().of(object.id()))));
        }
        List<Integer> notSeen = new ArrayList<>();
        for (ObjectMarker marker : cell.objects()) {
            if (estimate.object(marker.id()) == null) {
                notSeen.add(marker.id());
            }
        }
        List<Integer> misplaced = new ArrayList<>();
        for (MisplacedReference reference : references.misplaced()) {
            misplaced.add(reference.id());
        }
        Misfit misfit = references.contradicted() ? references.misfit() : againstLaplace.misfit();
        contradiction = references.contradictory() ? misfit : null;
        target = new TargetTest(objects, notSeen, misplaced, references.without() != null, misfit,
                cell.target());
    }

    /** The target held against the figures, whether they are to be trusted or not. */
    TargetTest target() {
        return target;
    }

    /** The verdict on all objects of the cell. */
    Verdict verdict() {
        return trusted(estimate.objects()) ? target.verdict() : untrusted();
    }

    /** The verdict on one object; an object that was not seen misses its target. */
    Verdict verdict(int objectId) {
        return trusted(only(objectId)) ? target.of(objectId).verdict() : untrusted();
    }

    private boolean trusted(List<ObjectEstimate> objects) {
        return contradiction == null && diagnostics.converged() && !ModeEstimate.areAmbiguous(estimate.cameraModes())
                && objects.stream().noneMatch(object -> ModeEstimate.areAmbiguous(object.modes()));
    }

    private Verdict untrusted() {
        // whatever the chains do, they rest on what cannot be true
        return contradiction != null ? Verdict.CONTRADICTED
                : diagnostics.converged() ? Verdict.AMBIGUOUS : Verdict.NOT_CONVERGED;
    }

    /** Whether {@link #verdict()} is pass or fail, and would be with any number of draws. */
    boolean decided() {
        return trusted(estimate.objects()) && target.decided();
    }

    /** Whether {@link #verdict(int)} is. */
    boolean decided(int objectId) {
        return trusted(only(objectId)) && target.of(objectId).decided();
    }

    /** Why {@link #verdict()} is what it is. */
    Reason finding() {
        return trusted(estimate.objects()) ? target.reason() : untrusted(estimate.objects());
    }

    /** Why {@link #verdict(int)} is what it is. */
    Reason finding(int objectId) {
        return trusted(only(objectId)) ? target.of(objectId).reason() : untrusted(only(objectId));
    }

    private Reason untrusted(List<ObjectEstimate> objects) {
        if (contradiction != null) {
            return Reason.contradicted(contradiction);
        }
        if (!diagnostics.converged()) {
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
        throw new IllegalStateException("these figures are to be trusted");
    }

    private List<ObjectEstimate> only(int objectId) {
        ObjectEstimate object = estimate.object(objectId);
        return object == null ? Collections.emptyList() : Collections.singletonList(object);
    }
}
