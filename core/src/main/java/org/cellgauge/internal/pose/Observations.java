package org.cellgauge.internal.pose;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;

/**
 * Bodies of known place in one view or several of one camera: where their points should be in the world, relative to
 * the centroid of the bodies, and where they are in the images; immutable. A placement error is the body's and so the
 * same in all views.
 */
public class Observations {
    private final List<Body> bodies;
    private final BlockLayout blocks;
    private final double[] centroidMm;
    private final double[] pointsMm;
    private final double[] armsMm;
    private final double[] observedPx;
    private final double[] columns;
    private final int unknowns;
    private final PlacedReferences nominal;

    /**
     * Observations.
     *
     * @param bodies the bodies; copied
     * @param blocks how their image coordinates lie in arrays
     * @param observedPx the image coordinates; not copied
     * @param columns change of these by each shared unknown, coordinates x unknowns row by row; not copied
     * @param unknowns number of unknowns that markers share
     */
    Observations(List<Body> bodies, BlockLayout blocks, double[] observedPx, double[] columns, int unknowns) {
        int n = bodies.size();
        if (n == 0 || n != blocks.blocks() || observedPx.length != blocks.firstRow(n)
                || columns.length != observedPx.length * unknowns) {
            throw new IllegalArgumentException("bodies, blocks, coordinates and columns do not belong together");
        }
        this.bodies = Collections.unmodifiableList(new ArrayList<>(bodies));
        this.blocks = blocks;
        this.observedPx = observedPx;
        this.columns = columns;
        this.unknowns = unknowns;
        centroidMm = new double[3];
        for (Body body : bodies) {
            double[] t = body.worldFromBody().translationMm();
            for (int i = 0; i < 3; i++) {
                centroidMm[i] += t[i] / n;
            }
        }
        pointsMm = new double[3 * blocks.firstPoint(n)];
        armsMm = new double[pointsMm.length];
        for (int b = 0; b < n; b++) {
            double[] points = bodies.get(b).pointsMm();
            if (points.length != 3 * blocks.points(b)) {
                throw new IllegalArgumentException("body " + bodies.get(b).id() + " has " + points.length / 3
                        + " points, not " + blocks.points(b));
            }
            double[] centre = bodies.get(b).worldFromBody().translationMm();
            int first = 3 * blocks.firstPoint(b);
            for (int k = 0; k < points.length; k++) {
                pointsMm[first + k] = points[k] - centroidMm[k % 3];
                armsMm[first + k] = points[k] - centre[k % 3];
            }
        }
        nominal = PlacedReferences.of(this, new double[StateLayout.POSE * n]);
    }

    /**
     * Bodies and where their points are in the images, with corner noise of the caller's and nothing shared.
     *
     * @param bodies the bodies, not empty
     * @param blocks how their image coordinates lie in an array; one block per body
     * @param observedPx the image coordinates, px; copied
     * @return the observations
     * @throws IllegalArgumentException if these do not belong together
     */
    public static Observations of(List<Body> bodies, BlockLayout blocks, double[] observedPx) {
        return new Observations(bodies, blocks, observedPx.clone(), new double[0], 0);
    }

    /**
     * The references that several photos of one cell show, taken by the same camera.
     *
     * @param references the cell's references; one that no photo shows is left out
     * @param photos what each photo shows
     * @return the observations, a view per photo
     * @throws IllegalArgumentException if some photo shows no reference
     */
    public static Observations of(Collection<Reference> references, List<Detections> photos) {
        List<Body> bodies = new ArrayList<>();
        List<int[]> seenIn = new ArrayList<>();
        List<double[]> corners = new ArrayList<>();
        boolean[] shows = new boolean[photos.size()];
        for (Reference r : references) {
            int[] views = new int[photos.size()];
            int times = 0;
            for (int v = 0; v < photos.size(); v++) {
                MarkerObservation observation = photos.get(v).find(r.id());
                if (observation != null) {
                    corners.add(observation.cornersPx());
                    views[times++] = v;
                    shows[v] = true;
                }
            }
            if (times > 0) {
                bodies.add(Body.of(r));
                seenIn.add(Arrays.copyOf(views, times));
            }
        }
        for (boolean any : shows) {
            if (!any) {
                throw new IllegalArgumentException("no reference was seen");
            }
        }
        int[] points = new int[bodies.size()];
        Arrays.fill(points, 4);
        double[] observed = new double[8 * corners.size()];
        for (int i = 0; i < corners.size(); i++) {
            System.arraycopy(corners.get(i), 0, observed, 8 * i, 8);
        }
        return new Observations(bodies, BlockLayout.of(photos.size(), points, seenIn.toArray(new int[0][])), observed,
                new double[0], 0);
    }

    /**
     * The bodies seen.
     *
     * @return unmodifiable, not empty
     */
    public List<Body> bodies() {
        return bodies;
    }

    /**
     * How image coordinates lie in arrays.
     *
     * @return a block per body
     */
    public BlockLayout blocks() {
        return blocks;
    }

    /**
     * Number of bodies seen.
     *
     * @return at least 1
     */
    public int size() {
        return bodies.size();
    }

    /**
     * Number of views.
     *
     * @return at least 1
     */
    public int views() {
        return blocks.views();
    }

    /**
     * Centroid of the stated places of the bodies seen.
     *
     * @return a copy, 3 values in the world, mm
     */
    public double[] centroidMm() {
        return centroidMm.clone();
    }

    /** Points relative to the centroid, three values each, world axes, mm; shared within the package. */
    double[] points() {
        return pointsMm;
    }

    /**
     * Points relative to the centroid of the bodies.
     *
     * @return a copy, x, y, z of each point, body after body, world axes, mm
     */
    public double[] pointsMm() {
        return pointsMm.clone();
    }

    /** Points relative to their own body's origin, three values each, world axes, mm. */
    double[] arms() {
        return armsMm;
    }

    /** The bodies where they are stated to stand. */
    PlacedReferences nominal() {
        return nominal;
    }

    /**
     * Points as observed.
     *
     * @return a copy, in the order of {@link #blocks()}: of markers in one view 8 values (u, v of 4 corners) each, px
     */
    public double[] observedPx() {
        return observedPx.clone();
    }

    /** Points as observed, shared within the package. */
    double[] observed() {
        return observedPx;
    }

    /**
     * Number of unknowns that the bodies share with other markers.
     *
     * @return of {@link CornerErrors}; 0 where there are none
     */
    public int unknowns() {
        return unknowns;
    }

    /**
     * Change of the observed coordinates by each of these.
     *
     * @return a copy, coordinates x {@link #unknowns()} row by row, px per unit
     */
    public double[] columnsPx() {
        return columns.clone();
    }

    /** The same, shared within the package. */
    double[] columns() {
        return columns;
    }

    /**
     * The pose of the set of bodies (origin at their centroid) in the camera frame, of a camera pose.
     *
     * @param worldFromCamera camera in world
     * @return cameraFromSet
     */
    public RigidTransform cameraFromSet(RigidTransform worldFromCamera) {
        RigidTransform cameraFromWorld = worldFromCamera.inverse();
        return RigidTransform.of(cameraFromWorld.rotation(), cameraFromWorld.apply(centroidMm));
    }

    /**
     * The camera pose of a pose of the set of bodies.
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
