package org.cellgauge.placement;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.cellgauge.estimate.PointEstimate;
import org.cellgauge.estimate.PoseEstimate;
import org.cellgauge.internal.laplace.CameraFit;
import org.cellgauge.internal.laplace.LinearModel;
import org.cellgauge.internal.laplace.ObjectFit;
import org.jspecify.annotations.Nullable;

/**
 * Camera and objects estimated again without the references that are named as misplaced, by Laplace's approximation;
 * immutable.
 *
 * <p>Result figures keep all references: a test may name the wrong one, and what a cell file states is not for a
 * program to correct. This second estimate says how much hangs on that. If the named references are off, a position as
 * stated differs from the true one by a bias, its move to here, and by what this estimate leaves open: root of the sum
 * of squares is its error then.
 */
public final class WithoutMisplaced {
    private final List<Integer> leftOut;
    private final PoseEstimate camera;
    private final double[] cameraMoveMm;
    private final List<ObjectWithout> objects;
    private final Map<Integer, ObjectWithout> byId = new HashMap<>();
    private final double worstStdWithAllMm;

    private WithoutMisplaced(List<Integer> leftOut, PoseEstimate camera, double[] cameraMoveMm,
            List<ObjectWithout> objects, double worstStdWithAllMm) {
        this.leftOut = Collections.unmodifiableList(leftOut);
        this.camera = camera;
        this.cameraMoveMm = cameraMoveMm;
        this.objects = Collections.unmodifiableList(objects);
        objects.forEach(object -> byId.put(object.id, object));
        this.worstStdWithAllMm = worstStdWithAllMm;
    }

    /**
     * Compares two estimates.
     *
     * @param leftOut ids of the references left out
     * @param all the camera from all references
     * @param without the camera from the others
     * @param objects the objects seen
     */
    static WithoutMisplaced of(List<Integer> leftOut, CameraFit all, CameraFit without,
            List<ObjectFit> objects) {
        LinearModel linear = new LinearModel(without);
        PoseEstimate camera = linear.cameraPose();
        LinearModel before = new LinearModel(all);
        List<ObjectWithout> moved = new ArrayList<>();
        double worst = 0;
        for (ObjectFit object : objects) {
            LinearModel.ObjectLink was = before.new ObjectLink(object, 0);
            LinearModel.ObjectLink is = linear.new ObjectLink(at(object, without), 0);
            worst = Math.max(worst, largest(was.poseEstimate().std()));
            PointEstimate gripBefore = was.grip();
            PointEstimate grip = is.grip();
            worst = gripBefore == null ? worst : Math.max(worst, largest(gripBefore.stdMm()));
            moved.add(new ObjectWithout(object.marker.id(), is.poseEstimate(), grip,
                    difference(is.pose().translationMm(), was.pose().translationMm()),
                    grip == null || gripBefore == null ? null : difference(grip.meanMm(), gripBefore.meanMm())));
        }
        return new WithoutMisplaced(leftOut, camera, difference(camera.meanTransform().translationMm(),
                before.cameraPose().meanTransform().translationMm()), moved, worst);
    }

    /** The object fitted at the intrinsics and shared unknowns of another camera estimate; the same without any. */
    private static ObjectFit at(ObjectFit object, CameraFit camera) {
        if (camera.intrinsicsPrior.count() == 0 && camera.view.unknowns() == 0) {
            return object;
        }
        return object.at(camera.modes.get(0).state());
    }

    private static double[] difference(double[] a, double[] b) {
        return new double[] {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    }

    /** What becomes of one object; immutable. */
    public static final class ObjectWithout {
        private final int id;
        private final PoseEstimate pose;
        private final @Nullable PointEstimate grip;
        private final double[] moveMm;
        private final double @Nullable [] gripMoveMm;

        private ObjectWithout(int id, PoseEstimate pose, @Nullable PointEstimate grip, double[] moveMm,
                double @Nullable [] gripMoveMm) {
            this.id = id;
            this.pose = pose;
            this.grip = grip;
            this.moveMm = moveMm;
            this.gripMoveMm = gripMoveMm;
        }

        /**
         * The object.
         *
         * @return marker id
         */
        public int id() {
            return id;
        }

        /**
         * Its pose.
         *
         * @return in the world, with its Laplace covariance
         */
        public PoseEstimate pose() {
            return pose;
        }

        /**
         * Its gripping point.
         *
         * @return in the world, or null if it has none
         */
        public @Nullable PointEstimate grip() {
            return grip;
        }

        /**
         * How far it moves when the references are left out.
         *
         * @return a copy, along world x, y, z, mm
         */
        public double[] moveMm() {
            return moveMm.clone();
        }

        /**
         * How far its gripping point moves.
         *
         * @return a copy, along world x, y, z, mm; null if it has none
         */
        public double @Nullable [] gripMoveMm() {
            return gripMoveMm == null ? null : gripMoveMm.clone();
        }

        /**
         * Root mean square error of the position that the result states, if the references are misplaced.
         *
         * @return a copy, along world x, y, z, mm
         */
        public double[] errorMm() {
            return error(moveMm, pose.std());
        }

        /**
         * The same of its gripping point.
         *
         * @return along world x, y, z, mm; null if it has none
         */
        public double @Nullable [] gripErrorMm() {
            return grip == null || gripMoveMm == null ? null : error(gripMoveMm, grip.stdMm());
        }

        /**
         * The largest of these errors.
         *
         * @return mm
         */
        public double worstErrorMm() {
            double worst = largest(errorMm());
            double[] gripErrorMm = gripErrorMm();
            return gripErrorMm == null ? worst : Math.max(worst, largest(gripErrorMm));
        }
    }

    private static double[] error(double[] moveMm, double[] stdMm) {
        return new double[] {Math.hypot(moveMm[0], stdMm[0]), Math.hypot(moveMm[1], stdMm[1]),
            Math.hypot(moveMm[2], stdMm[2])};
    }

    static double largest(double[] values) {
        return Math.max(values[0], Math.max(values[1], values[2]));
    }

    /**
     * The references left out.
     *
     * @return marker ids, the worst first
     */
    public List<Integer> leftOut() {
        return leftOut;
    }

    /**
     * The camera from the others.
     *
     * @return its pose in the world, with its Laplace covariance
     */
    public PoseEstimate camera() {
        return camera;
    }

    /**
     * How far the camera moves when the references are left out.
     *
     * @return a copy, along world x, y, z, mm
     */
    public double[] cameraMoveMm() {
        return cameraMoveMm.clone();
    }

    /**
     * The objects seen.
     *
     * @return in the order of the cell
     */
    public List<ObjectWithout> objects() {
        return objects;
    }

    /**
     * Largest standard deviation of any object or gripping point from all references.
     *
     * @return mm, by Laplace's approximation; 0 where no object was seen
     */
    public double worstStdWithAllMm() {
        return worstStdWithAllMm;
    }

    /**
     * Largest standard deviation of any object or gripping point without the misplaced references.
     *
     * @return mm, by Laplace's approximation; 0 where no object was seen
     */
    public double worstStdMm() {
        double worst = 0;
        for (ObjectWithout object : objects) {
            worst = Math.max(worst, largest(object.pose.std()));
            PointEstimate grip = object.grip;
            worst = grip == null ? worst : Math.max(worst, largest(grip.stdMm()));
        }
        return worst;
    }

    /**
     * One object.
     *
     * @param id marker id
     * @return what becomes of it, or null where it was not seen
     */
    public @Nullable ObjectWithout object(int id) {
        return byId.get(id);
    }
}
