package org.cellgauge.internal.validation;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;

/** Where the camera and the objects of a cell really stand, and what lens the camera really has; immutable. */
public final class CellTruth {
    /** How far from the centroid of the references to the line between two of them a default object stands. */
    private static final double INWARDS = 0.6;
    /** Fractional part of the golden ratio: its multiples spread evenly over the unit interval. */
    private static final double GOLDEN = 0.6180339887498949;
    private static final double TURN_RAD = Math.toRadians(40);

    private final RigidTransform worldFromCamera;
    private final Map<Integer, RigidTransform> worldFromObjects;
    /** Null where the camera is the one of the cell file. */
    private final PinholeCamera camera;

    /**
     * A truth in which the camera is as the cell file has it.
     *
     * @param worldFromCamera pose of the camera in the world
     * @param worldFromObjects poses of the objects in the world, by id; copied
     */
    public CellTruth(RigidTransform worldFromCamera, Map<Integer, RigidTransform> worldFromObjects) {
        this(worldFromCamera, worldFromObjects, null);
    }

    /**
     * A truth with a camera of its own.
     *
     * @param worldFromCamera pose of the camera in the world
     * @param worldFromObjects poses of the objects in the world, by id; copied
     * @param camera intrinsics and image size that the photo is taken with; null for those of the cell file
     */
    public CellTruth(RigidTransform worldFromCamera, Map<Integer, RigidTransform> worldFromObjects,
            PinholeCamera camera) {
        this.worldFromCamera = worldFromCamera;
        this.worldFromObjects = Collections.unmodifiableMap(new LinkedHashMap<>(worldFromObjects));
        this.camera = camera;
    }

    /**
     * What the photo is taken with.
     *
     * @param cell what the check is told
     * @return the true camera; that of the cell where the truth has none of its own
     */
    public PinholeCamera camera(Cell cell) {
        return camera == null ? cell.camera() : camera;
    }

    /**
     * Poses for all objects of a cell: those given, and for the others places spread inside the hull of the references.
     *
     * <p>The k-th object of the file (from 0) stands on the way from the centroid of the references to the point at the
     * share frac(0.618 (k + 1)) between the references k and k + 1 of the file (counted around), at 0.6 of it; it is
     * turned like reference k, and by a further 40 k degrees about its own normal. With a single reference objects
     * stand in a row beside it, two of its widths apart.
     *
     * @param cell the cell
     * @param given poses in the world, by id; each id must be an object of the cell
     * @return worldFromObject of every object, in the order of the cell
     * @throws IllegalArgumentException if an id is not an object of the cell
     */
    public static Map<Integer, RigidTransform> objectPoses(Cell cell, Map<Integer, RigidTransform> given) {
        List<Integer> unknown = new ArrayList<>(given.keySet());
        Map<Integer, RigidTransform> poses = new LinkedHashMap<>();
        List<Reference> references = cell.references();
        int n = references.size();
        double[] centroid = new double[3];
        for (Reference r : references) {
            for (int i = 0; i < 3; i++) {
                centroid[i] += r.worldFromMarker().translationMm()[i] / n;
            }
        }
        int k = 0;
        for (ObjectMarker object : cell.objects()) {
            unknown.remove((Integer) object.id());
            RigidTransform pose = given.get(object.id());
            poses.put(object.id(), pose != null ? pose : place(references, centroid, k));
            k++;
        }
        if (!unknown.isEmpty()) {
            throw new IllegalArgumentException("marker " + unknown.get(0) + " is no object of the cell");
        }
        return poses;
    }

    private static RigidTransform place(List<Reference> references, double[] centroid, int k) {
        int n = references.size();
        RigidTransform first = references.get(k % n).worldFromMarker();
        double[] place;
        if (n == 1) {
            place = first.apply(2.0 * (k + 1) * references.get(0).sizeMm(), 0, 0);
        } else {
            double[] from = first.translationMm();
            double[] to = references.get((k + 1) % n).worldFromMarker().translationMm();
            double share = GOLDEN * (k + 1);
            share -= Math.floor(share);
            place = new double[3];
            for (int i = 0; i < 3; i++) {
                double edge = from[i] + share * (to[i] - from[i]);
                place[i] = centroid[i] + INWARDS * (edge - centroid[i]);
            }
        }
        RigidTransform turned = RigidTransform.of(first.rotation(), new double[3])
                .compose(RigidTransform.ofEuler(0, 0, 0, 0, 0, TURN_RAD * k));
        return RigidTransform.of(turned.rotation(), place);
    }

    /**
     * Pose of the camera.
     *
     * @return camera in world
     */
    public RigidTransform worldFromCamera() {
        return worldFromCamera;
    }

    /**
     * Poses of the objects.
     *
     * @return unmodifiable, object in world by id
     */
    public Map<Integer, RigidTransform> worldFromObjects() {
        return worldFromObjects;
    }
}
