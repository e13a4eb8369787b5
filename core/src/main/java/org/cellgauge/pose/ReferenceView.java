package org.cellgauge.pose;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.MarkerGeometry;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;

/**
 * The references that one photo shows: where their corners should be in the world, relative to the centroid of the
 * references, and where they are in the image; immutable.
 */
public final class ReferenceView {
    private final List<Reference> references;
    private final double[] centroidMm;
    private final double[] pointsMm;
    private final double[] armsMm;
    private final double[] observedPx;
    private final double[] columns;
    private final int unknowns;

    private ReferenceView(List<Reference> references, double[] observedPx, double[] columns, int unknowns) {
        this.references = Collections.unmodifiableList(references);
        this.observedPx = observedPx;
        this.columns = columns;
        this.unknowns = unknowns;
        int n = references.size();
        centroidMm = new double[3];
        for (Reference r : references) {
            double[] t = r.worldFromMarker().translationMm();
            for (int i = 0; i < 3; i++) {
                centroidMm[i] += t[i] / n;
            }
        }
        pointsMm = new double[12 * n];
        armsMm = new double[12 * n];
        for (int m = 0; m < n; m++) {
            Reference r = references.get(m);
            double[] corners = MarkerGeometry.cornersMm(r.worldFromMarker(), r.sizeMm());
            double[] centre = r.worldFromMarker().translationMm();
            for (int k = 0; k < 12; k++) {
                pointsMm[12 * m + k] = corners[k] - centroidMm[k % 3];
                armsMm[12 * m + k] = corners[k] - centre[k % 3];
            }
        }
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
        double[] keptColumns = new double[8 * unknowns * kept.size()];
        for (int i = 0; i < kept.size(); i++) {
            left.add(references.get(kept.get(i)));
            System.arraycopy(observedPx, 8 * kept.get(i), observed, 8 * i, 8);
            System.arraycopy(columns, 8 * unknowns * kept.get(i), keptColumns, 8 * unknowns * i, 8 * unknowns);
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
        if (otherPx.length != observedPx.length) {
            throw new IllegalArgumentException("needs " + observedPx.length + " values, not " + otherPx.length);
        }
        return new ReferenceView(references, otherPx.clone(), columns, unknowns);
    }

    /**
     * The references seen.
     *
     * @return unmodifiable, in the order of the cell, not empty
     */
    public List<Reference> references() {
        return references;
    }

    /**
     * Number of references seen.
     *
     * @return at least 1
     */
    public int size() {
        return references.size();
    }

    /**
     * Centroid of the nominal centres of the references seen.
     *
     * @return a copy, 3 values in the world, mm
     */
    public double[] centroidMm() {
        return centroidMm.clone();
    }

    /** Corners relative to the centroid, 12 values per reference, world axes, mm; shared within the package. */
    double[] points() {
        return pointsMm;
    }

    /**
     * Corners relative to the centroid of the references.
     *
     * @return a copy, 12 values (x, y, z of 4 corners) per reference, world axes, mm
     */
    public double[] pointsMm() {
        return pointsMm.clone();
    }

    /** Corners relative to their own marker's centre, 12 values per reference, world axes, mm. */
    double[] arms() {
        return armsMm;
    }

    /**
     * Corners as observed.
     *
     * @return a copy, 8 values (u, v of 4 corners) per reference, px
     */
    public double[] observedPx() {
        return observedPx.clone();
    }

    /**
     * Number of unknowns that the references share with other markers.
     *
     * @return of {@link CornerErrors}; 0 where there are none
     */
    public int unknowns() {
        return unknowns;
    }

    /**
     * Change of the observed corners by each of these.
     *
     * @return a copy, 8 x {@link #unknowns()} row by row for each reference, px per unit
     */
    public double[] columnsPx() {
        return columns.clone();
    }

    /** The same, shared within the package. */
    double[] columns() {
        return columns;
    }

    /** Corners as observed, shared within the package. */
    double[] observed() {
        return observedPx;
    }

    /**
     * The pose of the set of references (origin at their centroid) in the camera frame, of a camera pose.
     *
     * @param worldFromCamera camera in world
     * @return cameraFromSet
     */
    public RigidTransform cameraFromSet(RigidTransform worldFromCamera) {
        RigidTransform cameraFromWorld = worldFromCamera.inverse();
        return RigidTransform.of(cameraFromWorld.rotation(), cameraFromWorld.apply(centroidMm));
    }

    /**
     * The camera pose of a pose of the set of references.
     *
     * @param cameraFromSet pose of the set, origin at the centroid, in the camera frame
     * @return worldFromCamera
     */
    public RigidTransform worldFromCamera(RigidTransform cameraFromSet) {
        RigidTransform setFromCamera = cameraFromSet.inverse();
        double[] t = setFromCamera.translationMm();
        for (int i = 0; i < 3; i++) {
            t[i] += centroidMm[i];
        }
        return RigidTransform.of(setFromCamera.rotation(), t);
    }
}
