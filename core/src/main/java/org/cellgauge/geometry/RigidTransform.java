package org.cellgauge.geometry;

import java.util.Arrays;
import org.cellgauge.internal.geometry.Rotations;

/**
 * A rigid motion {@code x_a = R x_b + t} between two frames; immutable. Variables are named {@code aFromB}.
 *
 * <p>It is the value that travels between packages. Inner loops work on plain arrays with {@link Rotations} instead.
 */
public final class RigidTransform {
    /** The transform that moves nothing. */
    public static final RigidTransform IDENTITY = new RigidTransform(new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1}, 0, 0, 0);
    private static final double ORTHONORMAL_TOLERANCE = 1e-6;

    private final double[] rotation;
    private final double tx;
    private final double ty;
    private final double tz;

    private RigidTransform(double[] rotation, double tx, double ty, double tz) {
        this.rotation = rotation;
        this.tx = tx;
        this.ty = ty;
        this.tz = tz;
    }

    /**
     * A transform of its rotation matrix and translation.
     *
     * @param rotation 9 values row by row, orthonormal with determinant 1 (checked to 1e-6); copied
     * @param translationMm 3 values, mm; copied
     * @return the transform
     * @throws IllegalArgumentException if a value is not finite or the matrix is no rotation
     */
    public static RigidTransform of(double[] rotation, double[] translationMm) {
        if (rotation.length != 9 || translationMm.length != 3) {
            throw new IllegalArgumentException("a rigid transform takes 9 rotation and 3 translation values");
        }
        double[] r = rotation.clone();
        for (int i = 0; i < 3; i++) {
            for (int j = i; j < 3; j++) {
                double dot = r[3 * i] * r[3 * j] + r[3 * i + 1] * r[3 * j + 1] + r[3 * i + 2] * r[3 * j + 2];
                if (!(Math.abs(dot - (i == j ? 1 : 0)) <= ORTHONORMAL_TOLERANCE)) {
                    throw new IllegalArgumentException("not a rotation matrix: " + Arrays.toString(rotation));
                }
            }
        }
        double det = r[0] * (r[4] * r[8] - r[5] * r[7]) - r[1] * (r[3] * r[8] - r[5] * r[6])
                + r[2] * (r[3] * r[7] - r[4] * r[6]);
        if (det < 0) {
            throw new IllegalArgumentException("a reflection, not a rotation: " + Arrays.toString(rotation));
        }
        for (double t : translationMm) {
            if (!Double.isFinite(t)) {
                throw new IllegalArgumentException("translation is not finite: " + Arrays.toString(translationMm));
            }
        }
        return new RigidTransform(r, translationMm[0], translationMm[1], translationMm[2]);
    }

    /**
     * A transform of a position and Euler angles (see {@link Rotations#fromEuler}).
     *
     * @param xMm translation x, mm
     * @param yMm translation y, mm
     * @param zMm translation z, mm
     * @param psiRad angle about x, rad
     * @param thetaRad angle about y, rad
     * @param phiRad angle about z, rad
     * @return the transform
     * @throws IllegalArgumentException if a value is not finite
     */
    public static RigidTransform ofEuler(double xMm, double yMm, double zMm, double psiRad, double thetaRad,
            double phiRad) {
        double[] r = new double[9];
        Rotations.fromEuler(psiRad, thetaRad, phiRad, r);
        return of(r, new double[] {xMm, yMm, zMm});
    }

    /**
     * A transform of a rotation vector and a translation.
     *
     * @param rotationVectorRad axis times angle, 3 values, rad
     * @param translationMm 3 values, mm
     * @return the transform
     * @throws IllegalArgumentException if a value is not finite
     */
    public static RigidTransform ofRotationVector(double[] rotationVectorRad, double[] translationMm) {
        double[] r = new double[9];
        Rotations.exp(rotationVectorRad[0], rotationVectorRad[1], rotationVectorRad[2], r);
        return of(r, translationMm);
    }

    /**
     * The chain {@code this · other}: with this {@code aFromB} and other {@code bFromC} it is {@code aFromC}.
     *
     * @param other the motion applied first
     * @return the chained motion
     */
    public RigidTransform compose(RigidTransform other) {
        double[] r = new double[9];
        Rotations.multiply(rotation, other.rotation, r);
        double[] t = apply(other.tx, other.ty, other.tz);
        return new RigidTransform(r, t[0], t[1], t[2]);
    }

    /**
     * The inverse motion.
     *
     * @return {@code bFromA} where this is {@code aFromB}
     */
    public RigidTransform inverse() {
        double[] r = new double[9];
        Rotations.transpose(rotation, r);
        return new RigidTransform(r, -(r[0] * tx + r[1] * ty + r[2] * tz), -(r[3] * tx + r[4] * ty + r[5] * tz),
                -(r[6] * tx + r[7] * ty + r[8] * tz));
    }

    /**
     * The pose moved in frame a: shifted along its axes, and turned about the pose's own origin.
     *
     * @param shiftMm 3 values along the axes of a, mm
     * @param turnRad rotation vector in the axes of a, 3 values, rad
     * @return {@code aFromB} of the moved b
     */
    public RigidTransform displaced(double[] shiftMm, double[] turnRad) {
        RigidTransform turned = ofRotationVector(turnRad, new double[3]).compose(new RigidTransform(rotation, 0, 0, 0));
        return of(turned.rotation, new double[] {tx + shiftMm[0], ty + shiftMm[1], tz + shiftMm[2]});
    }

    /**
     * Moves a point.
     *
     * @param x x in frame b, mm
     * @param y y in frame b, mm
     * @param z z in frame b, mm
     * @return the point in frame a, 3 values, mm
     */
    public double[] apply(double x, double y, double z) {
        return new double[] {rotation[0] * x + rotation[1] * y + rotation[2] * z + tx,
            rotation[3] * x + rotation[4] * y + rotation[5] * z + ty,
            rotation[6] * x + rotation[7] * y + rotation[8] * z + tz};
    }

    /**
     * Moves a point.
     *
     * @param point 3 values in frame b, mm
     * @return the point in frame a, 3 values, mm
     */
    public double[] apply(double[] point) {
        return apply(point[0], point[1], point[2]);
    }

    /**
     * The rotation matrix.
     *
     * @return a copy, 9 values row by row
     */
    public double[] rotation() {
        return rotation.clone();
    }

    /**
     * The translation: the origin of frame b in frame a.
     *
     * @return a new array of 3 values, mm
     */
    public double[] translationMm() {
        return new double[] {tx, ty, tz};
    }

    /**
     * Writes rotation and translation into arrays of the caller's, for inner loops.
     *
     * @param rotationTo receives the rotation matrix, 9 values row by row
     * @param translationToMm receives the translation, 3 values, mm
     * @param place how many poses stand before it in both
     */
    public void copyTo(double[] rotationTo, double[] translationToMm, int place) {
        System.arraycopy(rotation, 0, rotationTo, 9 * place, 9);
        translationToMm[3 * place] = tx;
        translationToMm[3 * place + 1] = ty;
        translationToMm[3 * place + 2] = tz;
    }

    /**
     * The Euler angles of the rotation.
     *
     * @return psi, theta, phi in rad, each in (-pi, pi]; see {@link Rotations#toEuler}
     */
    public double[] eulerRad() {
        double[] e = new double[3];
        Rotations.toEuler(rotation, e, 0);
        return e;
    }

    /**
     * The rotation vector of the rotation.
     *
     * @return axis times angle, 3 values, rad, length in [0, pi]
     */
    public double[] rotationVectorRad() {
        double[] w = new double[3];
        Rotations.log(rotation, w, 0);
        return w;
    }

    /**
     * The angle between this rotation and another.
     *
     * @param other a transform between the same frames
     * @return the angle of {@code R_this R_other^T}, rad, in [0, pi]
     */
    public double angleRadTo(RigidTransform other) {
        return Rotations.angle(rotation, other.rotation, new double[9], new double[3]);
    }

    @Override
    public String toString() {
        double[] e = eulerRad();
        return String.format(java.util.Locale.ROOT, "(%.3f, %.3f, %.3f) mm, (%.5f, %.5f, %.5f) rad", tx, ty, tz, e[0],
                e[1], e[2]);
    }
}
