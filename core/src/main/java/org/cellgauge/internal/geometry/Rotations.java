package org.cellgauge.internal.geometry;

/**
 * Rotation matrices as {@code double[9]} (row by row), their Euler angles and rotation vectors.
 *
 * <p>Nothing here allocates unless its documentation says so: results go to arrays of the caller.
 *
 * <p>Euler angles are Slabaugh's: {@code R = Rz(phi) Ry(theta) Rx(psi)} (G. G. Slabaugh, "Computing Euler angles from a
 * rotation matrix", 1999), always in the order (psi, theta, phi), that is about x, y, z. Rotation vectors are axis
 * times angle; exponential and logarithm follow Rodrigues' formula.
 */
public final class Rotations {
    /** Below this value of cos(theta) psi and phi turn about the same axis and cannot be told apart. */
    private static final double GIMBAL_LOCK_COSINE = 1e-12;
    /** Below this angle (rad) the trigonometric quotients are replaced by their Taylor series. */
    private static final double SMALL_ANGLE = 1e-4;

    private Rotations() {
    }

    /**
     * Rotation matrix of Euler angles, {@code Rz(phi) Ry(theta) Rx(psi)}.
     *
     * @param psiRad angle about x, any finite value
     * @param thetaRad angle about y, any finite value
     * @param phiRad angle about z, any finite value
     * @param out the matrix, 9 values row by row
     */
    public static void fromEuler(double psiRad, double thetaRad, double phiRad, double[] out) {
        double cx = Math.cos(psiRad);
        double sx = Math.sin(psiRad);
        double cy = Math.cos(thetaRad);
        double sy = Math.sin(thetaRad);
        double cz = Math.cos(phiRad);
        double sz = Math.sin(phiRad);
        out[0] = cz * cy;
        out[1] = cz * sy * sx - sz * cx;
        out[2] = cz * sy * cx + sz * sx;
        out[3] = sz * cy;
        out[4] = sz * sy * sx + cz * cx;
        out[5] = sz * sy * cx - cz * sx;
        out[6] = -sy;
        out[7] = cy * sx;
        out[8] = cy * cx;
    }

    /**
     * Euler angles of a rotation matrix (Slabaugh 1999, pseudo-code of section 3), each in (-pi, pi], theta in
     * [-pi/2, pi/2]. At gimbal lock (cos theta = 0) only psi -/+ phi is determined; phi is then 0.
     *
     * @param rotation 9 values row by row, orthonormal
     * @param out psi, theta, phi in rad, written from {@code offset} on
     * @param offset index of psi in {@code out}
     */
    public static void toEuler(double[] rotation, double[] out, int offset) {
        double cosTheta = Math.hypot(rotation[0], rotation[3]);
        // atan2 and not asin: asin loses half of the digits close to +-pi/2
        out[offset + 1] = Math.atan2(-rotation[6], cosTheta);
        double phi = cosTheta < GIMBAL_LOCK_COSINE ? 0 : Math.atan2(rotation[3], rotation[0]);
        double sine = Math.sin(phi);
        double cosine = Math.cos(phi);
        // psi from the rows that stay long at gimbal lock, turned back by phi: whatever rounding made of phi there, the
        // three angles together still stand for the matrix
        double psi = Math.atan2(sine * rotation[2] - cosine * rotation[5], cosine * rotation[4] - sine * rotation[1]);
        out[offset] = psi == -Math.PI ? Math.PI : psi;
        out[offset + 2] = phi == -Math.PI ? Math.PI : phi;
    }

    /**
     * Rotation matrix of a rotation vector (Rodrigues' formula).
     *
     * @param wx x of axis times angle, rad
     * @param wy y of axis times angle, rad
     * @param wz z of axis times angle, rad
     * @param out the matrix, 9 values row by row
     */
    public static void exp(double wx, double wy, double wz, double[] out) {
        double squared = wx * wx + wy * wy + wz * wz;
        double a;
        double b;
        if (squared < SMALL_ANGLE * SMALL_ANGLE) {
            a = 1 - squared / 6;
            b = 0.5 - squared / 24;
        } else {
            double angle = Math.sqrt(squared);
            a = Math.sin(angle) / angle;
            double s = Math.sin(angle / 2) / angle;
            b = 2 * s * s;
        }
        out[0] = 1 - b * (wy * wy + wz * wz);
        out[1] = b * wx * wy - a * wz;
        out[2] = b * wx * wz + a * wy;
        out[3] = b * wx * wy + a * wz;
        out[4] = 1 - b * (wx * wx + wz * wz);
        out[5] = b * wy * wz - a * wx;
        out[6] = b * wx * wz - a * wy;
        out[7] = b * wy * wz + a * wx;
        out[8] = 1 - b * (wx * wx + wy * wy);
    }

    /**
     * Rotation vector of a rotation matrix, its length in [0, pi]. At an angle of pi the sign of the axis is free.
     *
     * <p>Goes through the quaternion (Shepperd's choice of the largest component), so that it is accurate at every
     * angle; the usual formula by the trace loses all digits close to pi.
     *
     * @param r 9 values row by row, orthonormal
     * @param out axis times angle in rad, written from {@code offset} on
     * @param offset index of x in {@code out}
     */
    public static void log(double[] r, double[] out, int offset) {
        double qw;
        double qx;
        double qy;
        double qz;
        double trace = r[0] + r[4] + r[8];
        if (trace > 0) {
            qw = 1 + trace;
            qx = r[7] - r[5];
            qy = r[2] - r[6];
            qz = r[3] - r[1];
        } else if (r[0] >= r[4] && r[0] >= r[8]) {
            qw = r[7] - r[5];
            qx = 1 + r[0] - r[4] - r[8];
            qy = r[1] + r[3];
            qz = r[2] + r[6];
        } else if (r[4] >= r[8]) {
            qw = r[2] - r[6];
            qx = r[1] + r[3];
            qy = 1 - r[0] + r[4] - r[8];
            qz = r[5] + r[7];
        } else {
            qw = r[3] - r[1];
            qx = r[2] + r[6];
            qy = r[5] + r[7];
            qz = 1 - r[0] - r[4] + r[8];
        }
        if (qw < 0) {
            qw = -qw;
            qx = -qx;
            qy = -qy;
            qz = -qz;
        }
        double sine = Math.sqrt(qx * qx + qy * qy + qz * qz);
        // for a tiny rotation angle/sine tends to 2/qw; atan2 keeps that accurate down to the last bit but for 0/0
        double factor = sine < 1e-150 ? 2 / qw : 2 * Math.atan2(sine, qw) / sine;
        out[offset] = factor * qx;
        out[offset + 1] = factor * qy;
        out[offset + 2] = factor * qz;
    }

    /**
     * Angle between two rotations.
     *
     * @param a 9 values row by row, orthonormal
     * @param b likewise
     * @param product work space of 9 values
     * @param vector work space of 3 values or more
     * @return the angle of {@code a b^T}, rad, in [0, pi]
     */
    public static double angle(double[] a, double[] b, double[] product, double[] vector) {
        multiplyTransposed(a, b, product);
        log(product, vector, 0);
        return Math.sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
    }

    /**
     * Logarithm of the density of the uniform (Haar) measure over rotations in coordinates of a rotation vector,
     * {@code 2 log(sin(|w|/2) / (|w|/2))}, up to a constant (0 at w = 0).
     *
     * <p>It is the determinant of the left Jacobian of SO(3) (Chirikjian, "Stochastic Models, Information Theory, and
     * Lie Groups", vol. 2, 2011, section 10.6). A prior uniform over rotations has this density in the chart.
     *
     * @param wx x of the rotation vector, rad
     * @param wy y of the rotation vector, rad
     * @param wz z of the rotation vector, rad
     * @return the logarithm; -infinity at |w| = 2 pi
     */
    public static double logHaarDensity(double wx, double wy, double wz) {
        double squared = wx * wx + wy * wy + wz * wz;
        if (squared < SMALL_ANGLE * SMALL_ANGLE) {
            return -squared / 12;
        }
        double half = Math.sqrt(squared) / 2;
        return 2 * Math.log(Math.abs(Math.sin(half)) / half);
    }

    /**
     * Left Jacobian of SO(3): {@code exp(w + d) = exp(J d) exp(w)} for small d.
     *
     * <p>{@code J = I + (1 - cos|w|)/|w|² [w] + (|w| - sin|w|)/|w|³ [w]²} (Chirikjian 2011, section 10.6).
     *
     * @param wx x of the rotation vector, rad
     * @param wy y of the rotation vector, rad
     * @param wz z of the rotation vector, rad
     * @param out J, 9 values row by row
     */
    public static void leftJacobian(double wx, double wy, double wz, double[] out) {
        double squared = wx * wx + wy * wy + wz * wz;
        double b;
        double c;
        if (squared < SMALL_ANGLE * SMALL_ANGLE) {
            b = 0.5 - squared / 24;
            c = 1.0 / 6 - squared / 120;
        } else {
            double angle = Math.sqrt(squared);
            double s = Math.sin(angle / 2) / angle;
            b = 2 * s * s;
            c = (angle - Math.sin(angle)) / (squared * angle);
        }
        out[0] = 1 - c * (wy * wy + wz * wz);
        out[1] = c * wx * wy - b * wz;
        out[2] = c * wx * wz + b * wy;
        out[3] = c * wx * wy + b * wz;
        out[4] = 1 - c * (wx * wx + wz * wz);
        out[5] = c * wy * wz - b * wx;
        out[6] = c * wx * wz - b * wy;
        out[7] = c * wy * wz + b * wx;
        out[8] = 1 - c * (wx * wx + wy * wy);
    }

    /**
     * Inverse of the left Jacobian of SO(3): {@code log(exp(d) exp(w)) = w + J d} for small d.
     *
     * <p>{@code J = I - [w]/2 + (1/|w|² - (1 + cos|w|) / (2 |w| sin|w|)) [w]²} (Chirikjian 2011, section 10.6).
     *
     * @param wx x of the rotation vector, rad
     * @param wy y of the rotation vector, rad
     * @param wz z of the rotation vector, rad; |w| less than 2 pi
     * @param out J, 9 values row by row
     */
    public static void inverseLeftJacobian(double wx, double wy, double wz, double[] out) {
        double squared = wx * wx + wy * wy + wz * wz;
        double c;
        if (squared < SMALL_ANGLE * SMALL_ANGLE) {
            c = 1.0 / 12;
        } else {
            double half = Math.sqrt(squared) / 2;
            // (1 + cos a) / (2 a sin a) = cot(a/2) / (2 a)
            c = (1 - half * Math.cos(half) / Math.sin(half)) / squared;
        }
        out[0] = 1 - c * (wy * wy + wz * wz);
        out[1] = c * wx * wy + wz / 2;
        out[2] = c * wx * wz - wy / 2;
        out[3] = c * wx * wy - wz / 2;
        out[4] = 1 - c * (wx * wx + wz * wz);
        out[5] = c * wy * wz + wx / 2;
        out[6] = c * wx * wz + wy / 2;
        out[7] = c * wy * wz - wx / 2;
        out[8] = 1 - c * (wx * wx + wy * wy);
    }

    /**
     * Product of two 3x3 matrices.
     *
     * @param a left factor, 9 values row by row
     * @param b right factor, 9 values row by row
     * @param out a b; must be neither a nor b
     */
    public static void multiply(double[] a, double[] b, double[] out) {
        for (int i = 0; i < 9; i += 3) {
            double a0 = a[i];
            double a1 = a[i + 1];
            double a2 = a[i + 2];
            out[i] = a0 * b[0] + a1 * b[3] + a2 * b[6];
            out[i + 1] = a0 * b[1] + a1 * b[4] + a2 * b[7];
            out[i + 2] = a0 * b[2] + a1 * b[5] + a2 * b[8];
        }
    }

    /**
     * Product of a 3x3 matrix with the transpose of another.
     *
     * @param a left factor, 9 values row by row
     * @param b right factor before transposition, 9 values row by row
     * @param out a b^T; must be neither a nor b
     */
    public static void multiplyTransposed(double[] a, double[] b, double[] out) {
        for (int i = 0; i < 9; i += 3) {
            double a0 = a[i];
            double a1 = a[i + 1];
            double a2 = a[i + 2];
            out[i] = a0 * b[0] + a1 * b[1] + a2 * b[2];
            out[i + 1] = a0 * b[3] + a1 * b[4] + a2 * b[5];
            out[i + 2] = a0 * b[6] + a1 * b[7] + a2 * b[8];
        }
    }

    /**
     * Transpose, which for a rotation is the inverse.
     *
     * @param a 9 values row by row
     * @param out the transpose; must not be a
     */
    public static void transpose(double[] a, double[] out) {
        out[0] = a[0];
        out[1] = a[3];
        out[2] = a[6];
        out[3] = a[1];
        out[4] = a[4];
        out[5] = a[7];
        out[6] = a[2];
        out[7] = a[5];
        out[8] = a[8];
    }
}
