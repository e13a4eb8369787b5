package org.cellgauge.internal.pose;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.stream.Collectors;
import org.cellgauge.cell.Reference;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;

/**
 * The references that one photo shows: where their corners should be in the world, relative to the centroid of the
 * references, and where they are in the image; immutable.
 */
public final class ReferenceView extends Observations {
    private final List<Reference> references;

    private ReferenceView(List<Reference> references, double[] observedPx, double[] columns, int unknowns) {
        super(references.stream().map(Body::of).collect(Collectors.toList()),
                BlockLayout.ofMarkers(references.size()), observedPx, columns, unknowns);
        this.references = Collections.unmodifiableList(references);
    }

    /**
     * The view of the references that were detected.
     *
     * @param references the cell's references
     * @param detections what the photo shows; references that it does not show are left out
     * @return the view
     * @throws IllegalArgumentException if it shows none of them
     */
    public static ReferenceView of(Collection<Reference> references, Detections detections) {
        List<Reference> seen = new ArrayList<>();
        List<double[]> corners = new ArrayList<>();
        for (Reference r : references) {
            MarkerObservation observation = detections.find(r.id());
            if (observation != null) {
                seen.add(r);
                corners.add(observation.cornersPx());
            }
        }
        if (seen.isEmpty()) {
            throw new IllegalArgumentException("no reference was seen");
        }
        double[] observed = new double[8 * seen.size()];
        for (int m = 0; m < seen.size(); m++) {
            System.arraycopy(corners.get(m), 0, observed, 8 * m, 8);
        }
        return new ReferenceView(seen, observed, new double[0], 0);
    }

    /**
     * The view of the references that were detected, their corners as the errors of the photo have them.
     *
     * @param references the cell's references
     * @param errors errors of the photo's corners; references that the photo does not show are left out
     * @return the view
     * @throws IllegalArgumentException if it shows none of them
     */
    public static ReferenceView of(Collection<Reference> references, CornerErrors errors) {
        List<Reference> seen = new ArrayList<>();
        for (Reference r : references) {
            if (errors.has(r.id())) {
                seen.add(r);
            }
        }
        if (seen.isEmpty()) {
            throw new IllegalArgumentException("no reference was seen");
        }
        double[] observed = new double[8 * seen.size()];
        for (int m = 0; m < seen.size(); m++) {
            System.arraycopy(errors.cornersPx(seen.get(m).id()), 0, observed, 8 * m, 8);
        }
        return new ReferenceView(seen, observed, errors.columns(seen), errors.unknowns());
    }

    /**
     * The same view with some references left out.
     *
     * @param kept indices of the references to keep, ascending
     * @return a view of those alone, with their own centroid
     */
    public ReferenceView only(List<Integer> kept) {
        List<Reference> left = new ArrayList<>();
        double[] observed = new double[8 * kept.size()];
        int unknowns = unknowns();
        double[] keptColumns = new double[8 * unknowns * kept.size()];
        for (int i = 0; i < kept.size(); i++) {
            left.add(references.get(kept.get(i)));
            System.arraycopy(observed(), 8 * kept.get(i), observed, 8 * i, 8);
            System.arraycopy(columns(), 8 * unknowns * kept.get(i), keptColumns, 8 * unknowns * i, 8 * unknowns);
        }
        return new ReferenceView(left, observed, keptColumns, unknowns);
    }

    /**
     * The same references with other image corners: what a simulation observes.
     *
     * @param otherPx 8 values per reference, px; copied
     * @return a view with those corners
     */
    public ReferenceView withObservations(double[] otherPx) {
        if (otherPx.length != observed().length) {
            throw new IllegalArgumentException("needs " + observed().length + " values, not " + otherPx.length);
        }
        return new ReferenceView(references, otherPx.clone(), columns(), unknowns());
    }

    /**
     * The references seen.
     *
     * @return unmodifiable, in the order of the cell, not empty
     */
    public List<Reference> references() {
        return references;
    }
}
