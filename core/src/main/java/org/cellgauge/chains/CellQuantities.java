package org.cellgauge.chains;

import java.util.List;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.Rotations;
import org.cellgauge.laplace.CameraFit;
import org.cellgauge.pose.CameraState;
import org.cellgauge.pose.CornerErrors;
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
    /** Shift of the photo's edges into the dark, px. */
    static final String EDGE_SHIFT = "edge_shift_px";
    /** Noise of corners on top of what the detector says, px. */
    static final String ADDED_NOISE = "added_noise_px";

    public final QuantityLayout layout;
    public final CameraFit camera;
    public final List<ObjectTarget> objects;
    public final double[] cameraReference;
    public final double[][] objectReferences;
    private final CornerErrors errors;

    public CellQuantities(CameraFit camera, List<ObjectTarget> objects) {
        this.camera = camera;
        this.objects = objects;
        QuantityLayout.Builder b = new QuantityLayout.Builder();
        b.add("lp__");
        CameraState state = camera.modes.get(0).state();
        cameraReference = new double[9];
        Rotations.transpose(state.rotation, cameraReference);
        addPose(b, "camera", cameraReference);
        if (camera.modes.size() > 1) {
            b.add("camera_mode");
        }
        int[] intrinsics = new int[camera.intrinsicsPrior.count()];
        for (int i = 0; i < intrinsics.length; i++) {
            intrinsics[i] = b.add(state.lens.parameterNames().get(camera.intrinsicsPrior.index(i)));
        }
        if (intrinsics.length > 0) {
            b.group("intrinsics", intrinsics);
        }
        errors = camera.view.unknowns() > 0 || camera.belief != null ? camera.errors : null;
        addShared(b);
        objectReferences = new double[objects.size()][9];
        for (int o = 0; o < objects.size(); o++) {
            ObjectTarget object = objects.get(o);
            Rotations.multiply(cameraReference, object.fit.modes.get(0).state().rotation, objectReferences[o]);
            String name = "object_" + object.fit.marker.id();
            addPose(b, name, objectReferences[o]);
            if (object.fit.modes.size() > 1) {
                b.add(name + "_mode");
            }
            if (object.fit.marker.hasGrip()) {
                int x = b.add(name + "_grip_x_mm");
                int y = b.add(name + "_grip_y_mm");
                int z = b.add(name + "_grip_z_mm");
                b.group(name + "_grip", x, y, z);
            }
        }
        layout = b.build();
    }

    private void addShared(QuantityLayout.Builder b) {
        if (errors == null) {
            return;
        }
        if (errors.edges() != null) {
            b.add(EDGE_SHIFT);
            errors.edges().sizesMm().forEach(size -> b.add("print_gain_of_" + inName(size) + "_mm"));
        }
        errors.sizesMm().forEach(size -> b.add("size_of_" + inName(size) + "_mm"));
        if (camera.belief != null) {
            b.add(ADDED_NOISE);
        }
    }

    /** A size in a name, where a point would mean an index to readers of Stan's files. */
    private static String inName(double sizeMm) {
        return (sizeMm == Math.rint(sizeMm) ? String.valueOf((long) sizeMm) : String.valueOf(sizeMm)).replace('.', '_');
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

    private static void addPose(QuantityLayout.Builder b, String name, double[] reference) {
        double[] euler = new double[3];
        Rotations.toEuler(reference, euler, 0);
        int x = b.add(name + "_x_mm");
        int y = b.add(name + "_y_mm");
        int z = b.add(name + "_z_mm");
        int psi = b.addAngle(name + "_psi_rad", euler[0]);
        int theta = b.addAngle(name + "_theta_rad", euler[1]);
        int phi = b.addAngle(name + "_phi_rad", euler[2]);
        int wx = b.add(name + "_wx_rad");
        int wy = b.add(name + "_wy_rad");
        int wz = b.add(name + "_wz_rad");
        b.group(name, x, y, z, psi, theta, phi);
        b.group(name + "_tangent", x, y, z, wx, wy, wz);
    }

    /**
     * Which quantities decide on convergence: all but Euler angles (the rotation vectors stand for them, and are
     * defined where they are not), the log density and the mode labels.
     */
    public boolean[] judged() {
        boolean[] judged = new boolean[layout.size()];
        for (int i = 0; i < judged.length; i++) {
            String name = layout.names().get(i);
            judged[i] = !layout.isAngle(i) && i > 0 && !name.endsWith("_mode");
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
            int first = layout.indexOf("camera_x_mm");
            java.util.Arrays.fill(measured, first, first + 9, false);
        }
        if (camera.belief != null) {
            // its deviation is that of a long tail, and no figure of a pose
            measured[layout.indexOf(ADDED_NOISE)] = false;
        }
        for (ObjectTarget object : objects) {
            if (object.fit.modes.size() > 1) {
                int first = layout.indexOf("object_" + object.fit.marker.id() + "_wx_rad");
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
