package org.cellgauge.pose;

import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.Lens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.geometry.Rotations;

/**
 * Where a set of points stands before the camera, and the camera's intrinsics: mutable plain arrays for inner loops.
 *
 * <p>A point X, given relative to the centre of its set, is at {@code X_c = rotation X + offset} in the camera frame.
 * For references the set is all of them and the centre their centroid; for an object it is its own marker.
 */
public final class CameraState {
    private static final double[] NONE = {};

    /** cameraFromSet rotation, 9 values row by row. */
    public final double[] rotation = new double[9];
    /** Position of the centre of the set in the camera frame, 3 values, mm. */
    public final double[] offset = new double[3];
    /** The model of the lens. */
    public Lens lens = BrownLens.MODEL;
    /** Values of the lens's parameters. */
    public double[] intrinsics = new double[BrownLens.PARAMETERS];
    /** Unknowns that markers share, of {@link CornerErrors}, unit-normal beforehand; empty where there are none. */
    public double[] unknowns = NONE;
    /** The u of {@link AddedNoise}; of no account where the noise is stated. */
    public double noise;

    private final double[] turn = new double[9];
    private final double[] product = new double[9];

    /**
     * A state of a pose.
     *
     * @param cameraFromSet pose of the set in the camera frame
     * @param camera its intrinsics
     * @return a new state
     */
    public static CameraState of(RigidTransform cameraFromSet, PinholeCamera camera) {
        CameraState state = new CameraState();
        System.arraycopy(cameraFromSet.rotation(), 0, state.rotation, 0, 9);
        System.arraycopy(cameraFromSet.translationMm(), 0, state.offset, 0, 3);
        state.lens = camera.lens();
        state.intrinsics = camera.intrinsics();
        return state;
    }

    /**
     * Takes over all values of another state.
     *
     * @param other the source
     * @return this
     */
    public CameraState copyFrom(CameraState other) {
        System.arraycopy(other.rotation, 0, rotation, 0, 9);
        System.arraycopy(other.offset, 0, offset, 0, 3);
        copyIntrinsics(other);
        copyUnknowns(other);
        return this;
    }

    /**
     * Sets this state to a step of the centred chart from a base; intrinsics and unknowns are the base's.
     *
     * @param base where the step starts; may be this state
     * @param step (dp in mm, w in rad) from {@code at} on
     * @param at index of the first of the 6 values
     */
    public void setMoved(CameraState base, double[] step, int at) {
        Rotations.exp(step[at + 3], step[at + 4], step[at + 5], turn);
        Rotations.multiply(turn, base.rotation, product);
        System.arraycopy(product, 0, rotation, 0, 9);
        for (int i = 0; i < 3; i++) {
            offset[i] = base.offset[i] + step[at + i];
        }
        if (base != this) {
            copyIntrinsics(base);
            copyUnknowns(base);
        }
    }

    /**
     * Takes over lens and intrinsics of another state.
     *
     * @param other the source
     */
    public void copyIntrinsics(CameraState other) {
        lens = other.lens;
        // as with the unknowns, a length changes once at most
        if (intrinsics.length != other.intrinsics.length) {
            intrinsics = new double[other.intrinsics.length];
        }
        System.arraycopy(other.intrinsics, 0, intrinsics, 0, intrinsics.length);
    }

    private void copyUnknowns(CameraState other) {
        // a length changes once at most: a state that is used again and again allocates nothing
        if (unknowns.length != other.unknowns.length) {
            unknowns = new double[other.unknowns.length];
        }
        System.arraycopy(other.unknowns, 0, unknowns, 0, unknowns.length);
        noise = other.noise;
    }

    /**
     * The step of the centred chart that leads from a base to this state.
     *
     * @param base where the step starts
     * @return a new array (dp in mm, w in rad), |w| at most pi
     */
    public double[] stepFrom(CameraState base) {
        double[] step = new double[6];
        for (int i = 0; i < 3; i++) {
            step[i] = offset[i] - base.offset[i];
        }
        double[] turned = new double[9];
        Rotations.multiplyTransposed(rotation, base.rotation, turned);
        Rotations.log(turned, step, 3);
        return step;
    }

    /**
     * The pose as a transform.
     *
     * @return cameraFromSet
     */
    public RigidTransform cameraFromSet() {
        return RigidTransform.of(rotation, offset);
    }
}
