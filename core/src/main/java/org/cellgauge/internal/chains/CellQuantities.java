package org.cellgauge.internal.chains;

import java.util.List;
import java.util.function.Function;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.geometry.Rotations;
import org.cellgauge.internal.laplace.CameraFit;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.sampling.Quantity.Axis;
import org.cellgauge.sampling.QuantityLayout;

/**
 * The quantities of a draw: log density, camera pose, unknown intrinsics, what markers share (shift of edges in px,
 * spread of ink and sizes of prints in mm, added noise in px), and for each object its pose in the world,
 * its gripping point and, where it has two modes, which one the draw is near.
 *
 * <p>A pose takes 9 columns: x, y, z in mm; psi, theta, phi in rad; the rotation vector from the pose's reference
 * rotation in world axes in rad.
 */
public final class CellQuantities {
    /** Where a pose's moments stand in a summary: angles about their mean directions, and rotation vectors. */
    public static final class PoseGroups {
        /** Index of the group x, y, z, mm, psi, theta, phi, rad. */
        public final int euler;
        /** Index of the group x, y, z, mm, rotation vector in world axes, rad. */
        public final int tangent;

        PoseGroups(int euler, int tangent) {
            this.euler = euler;
            this.tangent = tangent;
        }
    }

    /** Columns and groups of a draw. */
    public final QuantityLayout layout;
    /** The camera at its modes. */
    public final CameraFit camera;
    /** The objects seen, in the order of the cell. */
    public final List<ObjectTarget> objects;
    /** worldFromCamera rotation that the camera's rotation vectors start from, 3x3 row by row. */
    public final double[] cameraReference;
    /** worldFromObject rotation that each object's rotation vectors start from, 3x3 row by row. */
    public final double[][] objectReferences;
    /** Groups of the camera's pose. */
    public final PoseGroups cameraPose;
    /** Groups of each object's pose. */
    public final PoseGroups[] objectPoses;
    /** Where the moments of each object's gripping point stand in a summary; -1 where it has none. */
    public final int[] grips;
    /** Where the moments of the unknown intrinsics stand; -1 where there are none. */
    public final int intrinsics;
    private final CornerErrors errors;

    /**
     * The quantities of a photo.
     *
     * @param camera the camera at its modes
     * @param objects the objects seen; kept
     */
    public CellQuantities(CameraFit camera, List<ObjectTarget> objects) {
        this.camera = camera;
        this.objects = objects;
        QuantityLayout.Builder b = new QuantityLayout.Builder();
        b.add(Quantity.LOG_DENSITY);
        CameraState state = camera.modes.get(0).state();
        cameraReference = new double[9];
        Rotations.transpose(state.rotation, cameraReference);
        cameraPose = addPose(b, Quantity::camera, cameraReference);
        if (camera.modes.size() > 1) {
            b.add(Quantity.CAMERA_MODE);
        }
        int[] unknown = new int[camera.intrinsicsPrior.count()];
        for (int i = 0; i < unknown.length; i++) {
            unknown[i] = b.add(Quantity.intrinsic(state.lens.parameterNames().get(camera.intrinsicsPrior.index(i))));
        }
        intrinsics = unknown.length > 0 ? b.group(unknown) : -1;
        errors = camera.view.unknowns() > 0 || camera.belief != null ? camera.errors : null;
        addShared(b);
        objectReferences = new double[objects.size()][9];
        objectPoses = new PoseGroups[objects.size()];
        grips = new int[objects.size()];
        for (int o = 0; o < objects.size(); o++) {
            ObjectTarget object = objects.get(o);
            Rotations.multiply(cameraReference, object.fit.modes.get(0).state().rotation, objectReferences[o]);
            int id = object.fit.marker.id();
            objectPoses[o] = addPose(b, axis -> Quantity.object(id, axis), objectReferences[o]);
            if (object.fit.modes.size() > 1) {
                b.add(Quantity.objectMode(id));
            }
            grips[o] = !object.fit.marker.hasGrip() ? -1 : b.group(b.add(Quantity.grip(id, Axis.X)),
                    b.add(Quantity.grip(id, Axis.Y)), b.add(Quantity.grip(id, Axis.Z)));
        }
        layout = b.build();
    }

    private void addShared(QuantityLayout.Builder b) {
        if (errors == null) {
            return;
        }
        if (errors.edges() != null) {
            b.add(Quantity.EDGE_SHIFT);
            errors.edges().sizesMm().forEach(size -> b.add(Quantity.printGain(size)));
        }
        errors.sizesMm().forEach(size -> b.add(Quantity.printSize(size)));
        if (camera.belief != null) {
            b.add(Quantity.ADDED_NOISE);
        }
    }

    /** What markers share in a state, in the order of the layout. */
    int readShared(CameraState state, double[] out, int at) {
        int next = at;
        if (errors == null) {
            return next;
        }
        int ofEdges = 0;
        if (errors.edges() != null) {
            ofEdges = errors.edges().unknowns();
            for (int i = 0; i < ofEdges; i++) {
                out[next++] = errors.edges().value(i, state.unknowns);
            }
        }
        for (int i = 0; i < errors.sizesMm().size(); i++) {
            out[next++] = errors.sizesMm().get(i) + errors.sizeStdMm() * state.unknowns[ofEdges + i];
        }
        if (camera.belief != null) {
            out[next++] = Math.sqrt(errors.added().variancePx2(state.noise));
        }
        return next;
    }

    private static PoseGroups addPose(QuantityLayout.Builder b, Function<Axis, Quantity> of, double[] reference) {
        double[] euler = new double[3];
        Rotations.toEuler(reference, euler, 0);
        int x = b.add(of.apply(Axis.X));
        int y = b.add(of.apply(Axis.Y));
        int z = b.add(of.apply(Axis.Z));
        int psi = b.addAngle(of.apply(Axis.PSI), euler[0]);
        int theta = b.addAngle(of.apply(Axis.THETA), euler[1]);
        int phi = b.addAngle(of.apply(Axis.PHI), euler[2]);
        int wx = b.add(of.apply(Axis.WX));
        int wy = b.add(of.apply(Axis.WY));
        int wz = b.add(of.apply(Axis.WZ));
        return new PoseGroups(b.group(x, y, z, psi, theta, phi), b.group(x, y, z, wx, wy, wz));
    }

    /**
     * Which quantities decide on convergence: all but Euler angles (the rotation vectors stand for them, and are
     * defined where they are not), the log density and the mode labels.
     */
    public boolean[] judged() {
        boolean[] judged = new boolean[layout.size()];
        for (int i = 0; i < judged.length; i++) {
            Quantity.Kind kind = layout.quantities().get(i).kind();
            judged[i] = !layout.isAngle(i) && kind != Quantity.Kind.LOG_DENSITY
                    && kind != Quantity.Kind.CAMERA_MODE && kind != Quantity.Kind.OBJECT_MODE;
        }
        return judged;
    }

    /**
     * Which quantities' deviations must be known to the precision asked for: all judged ones, but for the rotation of
     * an object with a second mode and the pose of a camera with one, whose deviations hang on how often a rare mode is
     * visited, and the added noise.
     * Its gripping point swings with that rotation and stays in all the same: a target is held against it.
     */
    public boolean[] measured() {
        boolean[] measured = judged();
        if (camera.modes.size() > 1) {
            int first = layout.indexOf(Quantity.camera(Axis.X));
            java.util.Arrays.fill(measured, first, first + 9, false);
        }
        if (camera.belief != null) {
            // its deviation is that of a long tail, and no figure of a pose
            measured[layout.indexOf(Quantity.ADDED_NOISE)] = false;
        }
        for (ObjectTarget object : objects) {
            if (object.fit.modes.size() > 1) {
                int first = layout.indexOf(Quantity.object(object.fit.marker.id(), Axis.WX));
                java.util.Arrays.fill(measured, first, first + 3, false);
            }
        }
        return measured;
    }

    /** Unknown intrinsics of a state, in the order of the layout. */
    int readIntrinsics(CameraState state, double[] out, int at) {
        int next = at;
        for (int i = 0; i < camera.intrinsicsPrior.count(); i++) {
            out[next++] = state.intrinsics[camera.intrinsicsPrior.index(i)];
        }
        return next;
    }

    static boolean focalIsUnknown(CameraFit camera) {
        for (int i = 0; i < camera.intrinsicsPrior.count(); i++) {
            if (camera.intrinsicsPrior.index(i) == PinholeCamera.FX) {
                return true;
            }
        }
        return false;
    }
}
