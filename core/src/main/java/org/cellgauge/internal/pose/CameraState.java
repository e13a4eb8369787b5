package org.cellgauge.internal.pose;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.Lens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.Rotations;

/**
 * Where a set of points stands before the camera in one view or several, and the camera's intrinsics: mutable plain
 * arrays for inner loops.
 *
 * <p>A point X, given relative to the centre of its set, is at {@code X_c = rotation X + offset} in the camera frame.
 * For references the set is all of them and the centre their centroid; for an object it is its own marker. Most code
 * knows one view alone, whose pose is the first of each array.
 */
public final class CameraState {
    private static final double[] NONE = {};

    /** cameraFromSet rotation, 9 values row by row for each view. */
    public final double[] rotation;
    /** Position of the centre of the set in the camera frame, 3 values for each view, mm. */
    public final double[] offset;
    /** The model of the lens. */
    public Lens lens = BrownLens.MODEL;
    /** Values of the lens's parameters. */
    public double[] intrinsics;
    /** Unknowns that markers share, of {@link CornerErrors}, unit-normal beforehand; empty where there are none. */
    public double[] unknowns = NONE;
    /** The u of {@link AddedNoise}; of no account where the noise is stated. */
    public double noise;

    /** Work space of states that are moved; most are not. */
    private double[] turn = NONE;
    private double[] product = NONE;

    /** A state of one view. */
    public CameraState() {
        this(1);
    }

    /**
     * A state of several views.
     *
     * @param views number of views, at least 1
     */
    public CameraState(int views) {
        this(views, new double[BrownLens.PARAMETERS]);
    }

    private CameraState(int views, double[] intrinsics) {
        rotation = new double[9 * views];
        offset = new double[3 * views];
        this.intrinsics = intrinsics;
    }

    /**
     * A state of a pose.
     *
     * @param cameraFromSet pose of the set in the camera frame
     * @param camera its intrinsics
     * @return a new state
     */
    public static CameraState of(RigidTransform cameraFromSet, PinholeCamera camera) {
        return of(Collections.singletonList(cameraFromSet), camera);
    }

    /**
     * A state of the poses of several views.
     *
     * @param cameraFromSets pose of the set in the camera frame, by view
     * @param camera its intrinsics
     * @return a new state
     */
    public static CameraState of(List<RigidTransform> cameraFromSets, PinholeCamera camera) {
        CameraState state = new CameraState(cameraFromSets.size(), NONE);
        for (int v = 0; v < cameraFromSets.size(); v++) {
            cameraFromSets.get(v).copyTo(state.rotation, state.offset, v);
        }
        state.lens = camera.lens();
        state.intrinsics = camera.intrinsics();
        return state;
    }

    /** Sets a state of one view to a pose before a camera; unknowns and noise are left as they are. */
    void set(RigidTransform cameraFromSet, PinholeCamera camera) {
        cameraFromSet.copyTo(rotation, offset, 0);
        lens = camera.lens();
        intrinsics = camera.intrinsics();
    }

    /**
     * Number of views.
     *
     * @return at least 1
     */
    public int views() {
        return offset.length / 3;
    }

    /**
     * A new state of the same values.
     *
     * @return a copy that shares nothing
     */
    public CameraState copy() {
        return new CameraState(views(), NONE).copyFrom(this);
    }

    /**
     * Takes over all values of another state.
     *
     * @param other the source, of as many views
     * @return this
     */
    public CameraState copyFrom(CameraState other) {
        System.arraycopy(other.rotation, 0, rotation, 0, rotation.length);
        System.arraycopy(other.offset, 0, offset, 0, offset.length);
        copyIntrinsics(other);
        copyUnknowns(other);
        return this;
    }

    /**
     * Sets this state to a step of the centred chart from a base; intrinsics and unknowns are the base's.
     *
     * @param base where the step starts, of as many views; may be this state
     * @param step (dp in mm, w in rad) of each view, from {@code at} on
     * @param at index of the first of the 6 values per view
     */
    public void setMoved(CameraState base, double[] step, int at) {
        setPoseMoved(base, step, at);
        if (base != this) {
            copyIntrinsics(base);
            copyUnknowns(base);
        }
    }

    /**
     * Sets the poses of this state to a step of the centred chart from a base, and leaves intrinsics and unknowns as
     * they are: for states that have those of the base from before.
     *
     * @param base where the step starts, of as many views; may be this state
     * @param step (dp in mm, w in rad) of each view, from {@code at} on
     * @param at index of the first of the 6 values per view
     */
    public void setPoseMoved(CameraState base, double[] step, int at) {
        if (turn.length == 0) {
            turn = new double[9];
            product = new double[9];
        }
        if (offset.length > 3) {
            moveEach(base, step, at);
        } else {
            Rotations.exp(step[at + 3], step[at + 4], step[at + 5], turn);
            Rotations.multiply(turn, base.rotation, product);
            System.arraycopy(product, 0, rotation, 0, 9);
            for (int i = 0; i < 3; i++) {
                offset[i] = base.offset[i] + step[at + i];
            }
        }
    }

    /** The same of several views; one, which is all that chains know, is moved without copying it to and fro. */
    private void moveEach(CameraState base, double[] step, int at) {
        for (int v = 0, a = at; v < views(); v++, a += StateLayout.POSE) {
            Rotations.exp(step[a + 3], step[a + 4], step[a + 5], turn);
            Rotations.multiply(turn, ofView(base.rotation, v), product);
            System.arraycopy(product, 0, rotation, 9 * v, 9);
            for (int i = 0; i < 3; i++) {
                offset[3 * v + i] = base.offset[3 * v + i] + step[a + i];
            }
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
     * @param base where the step starts, of as many views
     * @return a new array (dp in mm, w in rad) for each view, |w| at most pi
     */
    public double[] stepFrom(CameraState base) {
        double[] step = new double[StateLayout.POSE * views()];
        stepFrom(base, step, new double[9]);
        return step;
    }

    /** The same in an array of the caller's, with work space of 9 values. */
    void stepFrom(CameraState base, double[] step, double[] turned) {
        for (int v = 0; v < views(); v++) {
            for (int i = 0; i < 3; i++) {
                step[StateLayout.POSE * v + i] = offset[3 * v + i] - base.offset[3 * v + i];
            }
            Rotations.multiplyTransposed(ofView(rotation, v), ofView(base.rotation, v), turned);
            Rotations.log(turned, step, StateLayout.POSE * v + 3);
        }
    }

    private static double[] ofView(double[] rotations, int view) {
        return rotations.length == 9 ? rotations : Arrays.copyOfRange(rotations, 9 * view, 9 * view + 9);
    }

    /**
     * The pose as a transform.
     *
     * @return cameraFromSet of the first view
     */
    public RigidTransform cameraFromSet() {
        return cameraFromSet(0);
    }

    /**
     * The pose of a view as a transform.
     *
     * @param view 0 to views - 1
     * @return cameraFromSet
     */
    public RigidTransform cameraFromSet(int view) {
        return RigidTransform.of(ofView(rotation, view), views() == 1 ? offset
                : Arrays.copyOfRange(offset, 3 * view, 3 * view + 3));
    }
}
