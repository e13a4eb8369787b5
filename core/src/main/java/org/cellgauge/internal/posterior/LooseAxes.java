package org.cellgauge.internal.posterior;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.internal.pose.ReferenceView;

/**
 * World axes along which no reference is placed precisely enough for a model that is linear in placement errors, as
 * where "height not known" is stated as 1000 mm; immutable.
 *
 * <p>Along them camera and references may all move together, by far more than corners can tell one of them from the
 * others, and the photo stays what it is. With derivatives frozen at the mode, a camera off by c and references that
 * follow it linearly would not give the same photo: a stated 500 mm of its height came out as 245, and 770 mm too
 * large. So likelihoods take the references along: they are linear not about the mode's places, but about these moved
 * by the shift d, along the loose axes, that keeps the centroid of the references where the mode has it before the
 * camera, {@code d = L R^T (p_mode - p)}. The residual {@code projection(d_m + d) - J (d_m + d) - observed} has the
 * same distribution for any d where the model is linear, and the right one where it is not. What is left for
 * derivatives to bridge is how far references are off against each other, which corners tell to some millimetres.
 */
final class LooseAxes {
    /** Stated deviation, as a share of the distance from the camera, from which on an axis is loose. */
    private static final double LOOSE_SHARE = 0.02;

    private final int[] axes;
    private final double[] base = new double[3];

    /**
     * The loose axes of the references of a view.
     *
     * @param view references, with the precision of their placement
     * @param mode a mode of the camera pose that shows them
     */
    LooseAxes(ReferenceView view, PoseMode mode) {
        CameraState state = mode.state();
        System.arraycopy(state.offset, 0, base, 0, 3);
        List<Integer> loose = new ArrayList<>();
        for (int axis = 0; axis < 3; axis++) {
            boolean all = true;
            for (int m = 0; m < view.size(); m++) {
                all &= share(view.references().get(m), axis, view.worldFromCamera(state.cameraFromSet()))
                        > LOOSE_SHARE;
            }
            if (all) {
                loose.add(axis);
            }
        }
        axes = loose.stream().mapToInt(Integer::intValue).toArray();
    }

    private static double share(Reference reference, int axis, RigidTransform worldFromCamera) {
        double[] camera = worldFromCamera.translationMm();
        double[] place = reference.worldFromMarker().translationMm();
        double squares = 0;
        for (int i = 0; i < 3; i++) {
            squares += (camera[i] - place[i]) * (camera[i] - place[i]);
        }
        return reference.placement().stdMm(axis) / Math.sqrt(squares);
    }

    int count() {
        return axes.length;
    }

    /**
     * The shift that the references are taken along by at a state, and their centroid before the camera after it.
     *
     * @param state pose and intrinsics
     * @param shift receives mm along each loose axis
     * @param offset receives the centroid in the camera frame, mm
     */
    void shift(CameraState state, double[] shift, double[] offset) {
        double[] r = state.rotation;
        System.arraycopy(state.offset, 0, offset, 0, 3);
        for (int a = 0; a < axes.length; a++) {
            int axis = axes[a];
            shift[a] = r[axis] * (base[0] - state.offset[0]) + r[3 + axis] * (base[1] - state.offset[1])
                    + r[6 + axis] * (base[2] - state.offset[2]);
            for (int i = 0; i < 3; i++) {
                offset[i] += r[3 * i + axis] * shift[a];
            }
        }
    }

    /**
     * Derivatives of projected points by a common shift along each loose axis.
     *
     * @param points relative to the centroid, 3 values per point, world axes, mm
     * @param state pose and intrinsics
     * @return two rows per point, a column per loose axis, px per mm
     */
    double[] columns(double[] points, CameraState state) {
        double[] out = new double[points.length / 3 * 2 * axes.length];
        double[] r = state.rotation;
        double[] x = new double[3];
        double[] uv = new double[2];
        double[] byPoint = new double[6];
        int o = 0;
        for (int p = 0; p < points.length; p += 3) {
            for (int i = 0; i < 3; i++) {
                x[i] = r[3 * i] * points[p] + r[3 * i + 1] * points[p + 1] + r[3 * i + 2] * points[p + 2]
                        + state.offset[i];
            }
            state.lens.projectWithDerivatives(state.intrinsics, x[0], x[1], x[2], uv, byPoint, null);
            for (int b = 0; b < 6; b += 3) {
                for (int axis : axes) {
                    out[o++] = byPoint[b] * r[axis] + byPoint[b + 1] * r[3 + axis] + byPoint[b + 2] * r[6 + axis];
                }
            }
        }
        return out;
    }
}
