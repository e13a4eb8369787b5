package org.cellgauge.check;

import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.cellgauge.cell.Target;
import org.cellgauge.estimate.IntrinsicsEstimate;
import org.cellgauge.estimate.ModeEstimate;
import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.estimate.PoseEstimate;
import org.jspecify.annotations.Nullable;

/** Camera, unknown intrinsics and objects with their uncertainties, at whatever stage of a check; immutable. */
public final class CellEstimate {
    private final PoseEstimate camera;
    private final List<ModeEstimate> cameraModes;
    private final @Nullable IntrinsicsEstimate intrinsics;
    private final List<ObjectEstimate> objects;
    private final Map<Integer, ObjectEstimate> byId = new HashMap<>();

    CellEstimate(PoseEstimate camera, List<ModeEstimate> cameraModes, @Nullable IntrinsicsEstimate intrinsics,
            List<ObjectEstimate> objects) {
        this.camera = camera;
        this.cameraModes = Collections.unmodifiableList(cameraModes);
        this.intrinsics = intrinsics;
        this.objects = Collections.unmodifiableList(objects);
        objects.forEach(object -> byId.put(object.id(), object));
    }

    /**
     * Camera pose in the world.
     *
     * @return mean and covariance
     */
    public PoseEstimate camera() {
        return camera;
    }

    /**
     * The camera poses that explain the references.
     *
     * @return one mode, or two where the pose is ambiguous, heavier first
     */
    public List<ModeEstimate> cameraModes() {
        return cameraModes;
    }

    /**
     * Unknown intrinsics.
     *
     * @return their estimate, or null where all are known
     */
    public @Nullable IntrinsicsEstimate intrinsics() {
        return intrinsics;
    }

    /**
     * Objects seen.
     *
     * @return unmodifiable, in the order of the cell
     */
    public List<ObjectEstimate> objects() {
        return objects;
    }

    /**
     * The estimate of one object.
     *
     * @param id marker id
     * @return its estimate, or null where it was not seen
     */
    public @Nullable ObjectEstimate object(int id) {
        return byId.get(id);
    }

    /**
     * Whether no single figure describes an object: two poses of the camera, or of the object, explain the photo.
     *
     * @param objectId marker id
     * @return true if the second one holds more than {@link ModeEstimate#AMBIGUOUS_SHARE}; false for an object not seen
     */
    public boolean isAmbiguous(int objectId) {
        ObjectEstimate object = object(objectId);
        return object != null && (ModeEstimate.areAmbiguous(cameraModes) || ModeEstimate.areAmbiguous(object.modes()));
    }

    /**
     * The largest standard deviation of one object and its gripping point, and what causes most of it.
     *
     * @param objectId marker id
     * @return a reason of the kind {@link Reason.Kind#LARGEST_DEVIATION} without a target, or null for an object not
     *     seen
     */
    public @Nullable Reason largestDeviation(int objectId) {
        ObjectEstimate object = object(objectId);
        return object == null ? null
                : Reason.largestDeviation(Collections.singletonList(JudgedObject.of(object)), Collections.emptyList(),
                        Target.NONE, null, null, OptionalDouble.empty());
    }
}
