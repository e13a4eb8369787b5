package org.cellgauge.internal.laplace;

import java.util.Arrays;
import java.util.List;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.estimate.Matrices;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.pose.MarkerPoseFinder;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.internal.pose.ReprojectionFit;
import org.jspecify.annotations.Nullable;

/**
 * One object of a photo: its corners less what they share with others at the camera's mode, and the modes of its pose
 * before the camera. Immutable.
 */
public final class ObjectFit {
    /** The object as the cell file has it. */
    public final ObjectMarker marker;
    /** Errors of the photo's corners, px. */
    public final CornerErrors errors;
    /** Its corners less what they share with others at the camera's mode, 8 values, px. */
    public final double[] cornersPx;
    /** Modes of its pose in the camera frame, heaviest first. */
    public final List<PoseMode> modes;
    /** Mode of the camera: intrinsics, shared unknowns and noise that the modes were found at. */
    public final CameraState camera;

    /**
     * An object.
     *
     * @param camera mode of the camera: intrinsics, shared unknowns and noise that the modes were found at
     */
    public ObjectFit(ObjectMarker marker, CornerErrors errors, CameraState camera, List<PoseMode> modes) {
        this.marker = marker;
        this.errors = errors;
        this.camera = camera;
        this.modes = modes;
        cornersPx = errors.cornersPx(marker.id(), camera.unknowns);
    }

    /**
     * The modes of an object's pose at the intrinsics, shared unknowns and noise of a camera; empty where none is.
     *
     * @param finder of the caller's thread
     */
    public static List<PoseMode> modes(ObjectMarker marker, CornerErrors errors, CameraState camera,
            MarkerPoseFinder finder) {
        PinholeCamera lens = PinholeCamera.of(camera.lens, 1, 1, camera.intrinsics);
        double[] corners = errors.cornersPx(marker.id(), camera.unknowns);
        return errors.isPlain() ? finder.modes(corners, marker.sizeMm(), lens, errors.statedStdPx())
                : finder.modes(corners, marker.sizeMm(), lens, errors.whitening(marker.id(), camera.noise));
    }

    /**
     * An object whose corners are exactly where its pose has them: nothing is searched for.
     *
     * @param cameraFromObject its pose in the camera frame
     * @return the object; null where the corners do not determine that pose
     */
    public static @Nullable ObjectFit at(ObjectMarker marker, CornerErrors errors, CameraState camera,
            RigidTransform cameraFromObject) {
        PinholeCamera lens = PinholeCamera.of(camera.lens, 1, 1, camera.intrinsics);
        ObjectFit unfitted = new ObjectFit(marker, errors, camera, List.of());
        PoseMode mode = unfitted.fitTo(unfitted.cornersPx).modeAt(CameraState.of(cameraFromObject, lens));
        return mode == null ? null : new ObjectFit(marker, errors, camera, List.of(mode));
    }

    /** The same object before another camera; the same where that leads to no pose. */
    public ObjectFit at(CameraState other) {
        List<PoseMode> found = modes(marker, errors, other, new MarkerPoseFinder());
        return found.isEmpty() ? this : new ObjectFit(marker, errors, other, found);
    }

    /** A fit of the pose to corners of the caller's (not copied) at the caller's intrinsics, for one thread. */
    public ReprojectionFit fitTo(double[] corners) {
        ReprojectionFit fit = new ReprojectionFit(MarkerGeometry.cornersMm(marker.sizeMm()), corners,
                IntrinsicsPrior.KNOWN, null);
        weigh(fit);
        return fit;
    }

    private void weigh(ReprojectionFit fit) {
        if (errors.isPlain()) {
            fit.setIsotropic(errors.statedStdPx());
        } else {
            fit.setWhitening(errors.whitening(marker.id(), camera.noise));
        }
    }

    /**
     * Change of the fitted pose by each unknown intrinsic and each unknown that markers share: {@code -(J^T J)^-1 J^T
     * J_f} of the whitened derivatives.
     *
     * @param space of the caller's thread, of these unknowns
     * @return 6 rows, row by row
     */
    public double[] answers(int modeIndex, AnswerSpace space) {
        int n = space.count;
        double[] out = new double[6 * n];
        if (n == 0) {
            return out;
        }
        space.set(this);
        CameraState object = modes.get(modeIndex).state();
        object.unknowns = space.none;
        ReprojectionFit fit = space.fit;
        double[] j = space.jacobian;
        fit.jacobianAt(object, j);
        double[] normal = space.normal;
        double[][] right = space.right;
        Arrays.fill(normal, 0);
        Matrices.clear(right);
        int all = fit.columns();
        for (int row = 0; row < 8; row++) {
            for (int a = 0; a < 6; a++) {
                for (int b = 0; b < 6; b++) {
                    normal[6 * a + b] += j[row * all + a] * j[row * all + b];
                }
                for (int f = 0; f < n; f++) {
                    right[f][a] -= j[row * all + a] * j[row * all + fit.layout().intrinsics() + f];
                }
            }
        }
        Cholesky.factor(normal, 6);
        for (int f = 0; f < n; f++) {
            Cholesky.solveLower(normal, 6, right[f]);
            Cholesky.solveUpper(normal, 6, right[f]);
            for (int a = 0; a < 6; a++) {
                out[a * n + f] = right[f][a];
            }
        }
        return out;
    }

    /** Work space in which objects of a photo are asked for {@link #answers} one after another; for one thread. */
    public static final class AnswerSpace {
        private final int count;
        private final double[] points = new double[12];
        private final double[] corners = new double[8];
        private final double[] byUnknowns;
        private final double[] none;
        private final ReprojectionFit fit;
        private final double[] jacobian;
        private final double[] normal = new double[36];
        private final double[][] right;
        private @Nullable ObjectFit last;

        /**
         * Work space.
         *
         * @param errors of the photo's corners
         * @param intrinsicsPrior unknown intrinsics
         */
        public AnswerSpace(CornerErrors errors, IntrinsicsPrior intrinsicsPrior) {
            none = new double[errors.unknowns()];
            byUnknowns = new double[8 * none.length];
            count = intrinsicsPrior.count() + none.length;
            fit = new ReprojectionFit(points, corners, byUnknowns, none.length, intrinsicsPrior, null);
            jacobian = new double[fit.rows() * fit.columns()];
            right = new double[count][6];
        }

        private void set(ObjectFit object) {
            if (object == last) {
                return;
            }
            if (object.errors.unknowns() != none.length) {
                throw new IllegalArgumentException("an object of a photo with other shared unknowns");
            }
            last = object;
            MarkerGeometry.cornersMm(object.marker.sizeMm(), points);
            System.arraycopy(object.cornersPx, 0, corners, 0, corners.length);
            System.arraycopy(object.errors.columns(object.marker.id()), 0, byUnknowns, 0, byUnknowns.length);
            object.weigh(fit);
        }
    }

    /** Which of the modes a state is turned the least from: rotation alone tells mirrored poses apart. */
    public static int nearest(List<PoseMode> modes, CameraState state) {
        int nearest = 0;
        double most = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < modes.size(); k++) {
            double likeness = modes.get(k).likeness(state);
            if (likeness > most) {
                most = likeness;
                nearest = k;
            }
        }
        return nearest;
    }
}
