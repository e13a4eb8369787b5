package org.cellgauge.laplace;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.estimate.PointEstimate;
import org.cellgauge.estimate.PoseEstimate;
import org.cellgauge.estimate.VarianceBudget;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.laplace.CameraFit;
import org.cellgauge.internal.laplace.LinearModel;
import org.cellgauge.internal.laplace.ObjectFit;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.internal.pose.PosePrior;
import org.cellgauge.internal.pose.ReferenceView;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.SettingTable;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.jspecify.annotations.Nullable;

/**
 * How precisely a photo of a layout would tell where camera and objects are, from poses alone, without any photo:
 * Laplace's approximation at the true poses, which the Fisher information there gives whatever the corners turn out to
 * be; immutable.
 *
 * <p>It is what a check finds on corners without errors, and to first order the mean of what checks find on real ones.
 * Markers that the camera does not see from the front and wholly in the image are left out, as they would be from the
 * photo; whether a detector would read them is not the question here, nor whether small markers have a second pose.
 */
public final class LayoutPrediction {
    private final CameraFit camera;
    private final PoseEstimate cameraPose;
    private final double[][] intrinsicsCovariance;
    private final Map<Integer, ObjectFit> objects = new LinkedHashMap<>();
    private final Map<Integer, PoseEstimate> poses = new LinkedHashMap<>();
    private final Map<Integer, PointEstimate> grips = new LinkedHashMap<>();

    private LayoutPrediction(CameraFit camera, List<ObjectFit> fits) {
        this.camera = camera;
        LinearModel linear = new LinearModel(camera);
        cameraPose = linear.cameraPose();
        intrinsicsCovariance = linear.intrinsicsCovariance();
        for (ObjectFit fit : fits) {
            LinearModel.ObjectLink link = linear.new ObjectLink(fit, 0);
            objects.put(fit.marker.id(), fit);
            poses.put(fit.marker.id(), link.poseEstimate());
            PointEstimate grip = link.grip();
            if (grip != null) {
                grips.put(fit.marker.id(), grip);
            }
        }
    }

    /**
     * Predicts what a photo would tell.
     *
     * @param cell camera, references, objects and corner noise, which has to be stated
     * @param worldFromCamera where the camera would stand
     * @param worldFromObjects where objects would stand, by id; objects of the cell that are not in it are left out
     * @param settings how the cell is modelled
     * @return the prediction; null where the references that would be seen, if any, do not determine the camera pose
     * @throws IllegalArgumentException if the cell states no corner noise
     */
    public static @Nullable LayoutPrediction of(Cell cell, RigidTransform worldFromCamera,
            Map<Integer, RigidTransform> worldFromObjects, CheckSettings settings) {
        if (!cell.pixelStdPx().isPresent()) {
            throw new IllegalArgumentException("nothing is predicted without a stated corner noise");
        }
        RigidTransform cameraFromWorld = worldFromCamera.inverse();
        Map<Integer, RigidTransform> cameraFromMarkers = new LinkedHashMap<>();
        List<MarkerObservation> seen = new ArrayList<>();
        for (Reference reference : cell.references()) {
            see(cell, reference.id(), reference.sizeMm(), cameraFromWorld.compose(reference.worldFromMarker()),
                    cameraFromMarkers, seen);
        }
        if (seen.isEmpty()) {
            return null;
        }
        for (ObjectMarker object : cell.objects()) {
            RigidTransform worldFromObject = worldFromObjects.get(object.id());
            if (worldFromObject != null) {
                see(cell, object.id(), object.sizeMm(), cameraFromWorld.compose(worldFromObject), cameraFromMarkers,
                        seen);
            }
        }
        CornerErrors errors = CornerErrors.of(cell,
                new Detections("layout", cell.camera().widthPx(), cell.camera().heightPx(), seen), cameraFromMarkers);
        ReferenceView view = ReferenceView.of(cell.references(), errors);
        PosePrior posePrior = settings.model().posePriorAllowed() && PosePrior.isNeededFor(view.size())
                ? PosePrior.weak(CameraState.of(view.cameraFromSet(worldFromCamera), cell.camera())) : null;
        // corners are where the cell's own camera has them: nothing is searched for
        CheckSettings asKnown = settings.toBuilder().set(SettingTable.INITIAL_FOCAL_PX, OptionalDouble.empty())
                .set(SettingTable.FIELD_OF_VIEW_DEG, OptionalDouble.empty()).build();
        CameraFit fit = new CameraFit(cell.camera(), asKnown, view,
                IntrinsicsPrior.stated(cell, settings.model()), posePrior, errors, 0);
        PoseMode mode = fit.finder(view).at(Collections.singletonList(worldFromCamera));
        if (mode == null) {
            return null;
        }
        CameraState state = mode.state();
        List<ObjectFit> objects = new ArrayList<>();
        for (ObjectMarker object : cell.objects()) {
            RigidTransform cameraFromObject = cameraFromMarkers.get(object.id());
            ObjectFit exact = cameraFromObject == null ? null
                    : ObjectFit.at(object, errors, state, cameraFromObject);
            if (exact != null) {
                objects.add(exact);
            }
        }
        return new LayoutPrediction(fit.at(Collections.singletonList(mode), worldFromCamera), objects);
    }

    private static void see(Cell cell, int id, double sizeMm, RigidTransform cameraFromMarker,
            Map<Integer, RigidTransform> cameraFromMarkers, List<MarkerObservation> seen) {
        double[] px = MarkerGeometry.seenPx(cell.camera(), cameraFromMarker, sizeMm);
        if (px != null) {
            cameraFromMarkers.put(id, cameraFromMarker);
            seen.add(new MarkerObservation(id, px));
        }
    }

    /**
     * The references that would be seen.
     *
     * @return unmodifiable, in the order of the cell
     */
    public List<Reference> references() {
        return camera.view.references();
    }

    /**
     * The camera.
     *
     * @return its pose in the world as it was given, with the covariance and deviations that the photo would leave
     */
    public PoseEstimate camera() {
        return cameraPose;
    }

    /**
     * Covariance of the unknown intrinsics.
     *
     * @return a copy, in the order of their prior and in their units; empty where all are known
     */
    public double[][] intrinsicsCovariance() {
        double[][] copy = new double[intrinsicsCovariance.length][];
        for (int i = 0; i < copy.length; i++) {
            copy[i] = intrinsicsCovariance[i].clone();
        }
        return copy;
    }

    /**
     * The objects that would be seen.
     *
     * @return unmodifiable ids, in the order of the cell
     */
    public Set<Integer> objects() {
        return Collections.unmodifiableSet(objects.keySet());
    }

    /**
     * An object.
     *
     * @param id id of the object
     * @return its pose in the world as it was given, with covariance and deviations; null where it would not be seen
     */
    public @Nullable PoseEstimate object(int id) {
        return poses.get(id);
    }

    /**
     * The gripping point of an object.
     *
     * @param id id of the object
     * @return the point in the world with its covariance; null where there is none, or the object would not be seen
     */
    public @Nullable PointEstimate grip(int id) {
        return grips.get(id);
    }

    /**
     * Where the variance of an object's position comes from. Found when asked for: it takes longer than the rest.
     *
     * @param id id of an object that would be seen
     * @return variances along world x, y, z by source
     * @throws IllegalArgumentException if it would not be seen
     */
    public VarianceBudget budget(int id) {
        return budget(id, new double[3]);
    }

    /**
     * Where the variance of an object's gripping point comes from.
     *
     * @param id id of an object that would be seen
     * @return variances along world x, y, z by source; null where it has no gripping point
     * @throws IllegalArgumentException if it would not be seen
     */
    public @Nullable VarianceBudget gripBudget(int id) {
        double[] grip = fit(id).marker.gripMm();
        return grip == null ? null : budget(id, grip);
    }

    private VarianceBudget budget(int id, double[] pointMm) {
        return new LinearModel(camera).new ObjectLink(fit(id), 0).budget(pointMm,
                camera.noise(camera.view, camera.noiseLevel));
    }

    private ObjectFit fit(int id) {
        ObjectFit fit = objects.get(id);
        if (fit == null) {
            throw new IllegalArgumentException("object " + id + " would not be seen");
        }
        return fit;
    }
}
