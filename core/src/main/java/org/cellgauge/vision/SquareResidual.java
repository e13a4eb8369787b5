package org.cellgauge.vision;

import boofcv.abst.geo.Estimate1ofPnP;
import boofcv.factory.geo.EnumPNP;
import boofcv.factory.geo.FactoryMultiView;
import boofcv.struct.geo.Point2D3D;
import georegression.struct.se.Se3_F64;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.cellgauge.geometry.Lens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.DampedGaussNewton;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.geometry.Rotations;
import org.cellgauge.internal.geometry.TangentPlane;
import org.jspecify.annotations.Nullable;

/**
 * How far four corners are from being the image of any square: what remains after the best pose.
 *
 * <p>Any four points in general position are the image of a square under some homography, so a quadrilateral alone
 * refutes nothing. Under a known camera only a pose is free: 8 coordinates less 6 degrees of freedom leave 2 residuals,
 * and those tell a marker from a quadrilateral that merely carries its pattern. The size of the square does not enter:
 * it scales the distance alone. The pose starts at the homography of the four corners, taken apart (Zhang, "A flexible
 * new technique for camera calibration", PAMI 2000, section 3.1), and is then refined by damped Gauss-Newton on the
 * distorted pixels. Where that leaves more than an ordinary marker does, it may have ended at the second pose of a
 * square seen from afar: then it starts again at IPPE (Collins and Bartoli, "Infinitesimal plane-based pose
 * estimation", IJCV 2014), which takes ten times as long and knows both. Not thread-safe.
 */
final class SquareResidual {
    private static final int POSE = 6;
    private static final int RESIDUALS = 8;
    private static final int DEGREES_OF_FREEDOM = RESIDUALS - POSE;
    private static final int MAX_STEPS = 30;
    /** Relative decrease of the sum of squares below which a step no longer matters to a gate. */
    private static final double ENOUGH = 1e-6;
    private static final double SIDE = 2;
    /** What a marker that was found and fitted leaves at most where nothing is wrong with it, px. */
    private static final double ORDINARY_STD_PX = 0.25;
    private static final double ROOT_HALF = Math.sqrt(0.5);

    private final PinholeCamera camera;
    private final Lens lens;
    private final double[] intrinsics;
    /** Where the square is looked at under a wide lens; null for others, which have one plane for all. */
    private final @Nullable TangentPlane plane;
    private final double[] square = MarkerGeometry.cornersMm(SIDE);
    private final Estimate1ofPnP ippe = FactoryMultiView.pnp_1(EnumPNP.IPPE, -1, 0);
    private final List<Point2D3D> correspondences = new ArrayList<>();
    private final Se3_F64 cameraFromSquare = new Se3_F64();
    private final DampedGaussNewton solver =
            new DampedGaussNewton(POSE, DampedGaussNewton.Damping.TENFOLD, MAX_STEPS);
    private final double[] normalised = new double[2];
    private final double[] inPlane = new double[2 * MarkerGeometry.CORNERS];
    private final double[] homography = new double[8];
    private final double[] uv = new double[2];
    private final double[] byPoint = new double[6];
    private final double[] row = new double[POSE];
    private final Pose pose = new Pose();

    SquareResidual(PinholeCamera camera) {
        this.camera = camera;
        this.lens = camera.lens();
        this.intrinsics = camera.intrinsics();
        this.plane = lens.isWide() ? new TangentPlane(camera) : null;
        for (int i = 0; i < MarkerGeometry.CORNERS; i++) {
            correspondences.add(new Point2D3D());
        }
    }

    /**
     * The residual of four corners as the pixel deviation it would take to explain it.
     *
     * @param cornersPx 8 values in the order of {@link MarkerObservation}, distorted px
     * @return square root of the sum of squared residuals over its 2 degrees of freedom, px: the usual estimate of the
     *     deviation of one corner coordinate; infinite where no pose puts a square in front of the camera
     */
    double impliedStdPx(double[] cornersPx) {
        if (plane != null && !plane.aim(cornersPx)) {
            return Double.POSITIVE_INFINITY;
        }
        for (int i = 0; i < MarkerGeometry.CORNERS; i++) {
            double u = cornersPx[2 * i];
            double v = cornersPx[2 * i + 1];
            if (plane != null ? !plane.toNormalised(u, v, normalised) : !camera.toNormalised(u, v, normalised)) {
                return Double.POSITIVE_INFINITY;
            }
            inPlane[2 * i] = normalised[0];
            inPlane[2 * i + 1] = normalised[1];
        }
        double fast = startAtHomography() ? refined(cornersPx) : Double.POSITIVE_INFINITY;
        if (fast < ORDINARY_STD_PX) {
            return fast;
        }
        return startAtIppe() ? Math.min(fast, refined(cornersPx)) : fast;
    }

    private double refined(double[] cornersPx) {
        pose.start(cornersPx);
        return Math.sqrt(solver.minimise(pose) / DEGREES_OF_FREEDOM);
    }

    private boolean startAtIppe() {
        for (int i = 0; i < MarkerGeometry.CORNERS; i++) {
            correspondences.get(i).setTo(inPlane[2 * i], inPlane[2 * i + 1], square[3 * i], square[3 * i + 1],
                    square[3 * i + 2]);
        }
        return ippe.process(correspondences, cameraFromSquare);
    }

    /** False where corners have no homography, or one that puts the square behind the camera. */
    private boolean startAtHomography() {
        double[] h = homography;
        if (!Homography.ofUnitSquare(inPlane, h)) {
            return false;
        }
        // from the unit square, whose axes are the sides from the first corner on, to the square about its middle
        double byX = 1 / (square[3] - square[0]);
        double byY = 1 / (square[10] - square[1]);
        double x0 = h[0] * byX;
        double x1 = h[3] * byX;
        double x2 = h[6] * byX;
        double y0 = h[1] * byY;
        double y1 = h[4] * byY;
        double y2 = h[7] * byY;
        double perLength = 2 / (Math.sqrt(x0 * x0 + x1 * x1 + x2 * x2) + Math.sqrt(y0 * y0 + y1 * y1 + y2 * y2));
        double depth = (1 - square[0] * x2 - square[1] * y2) * perLength;
        if (!(depth > 0) || depth == Double.POSITIVE_INFINITY) {
            return false;
        }
        cameraFromSquare.T.setTo((h[2] - square[0] * x0 - square[1] * y0) * perLength,
                (h[5] - square[0] * x1 - square[1] * y1) * perLength, depth);
        return setNearestRotation(x0, x1, x2, y0, y1, y2);
    }

    /** The rotation whose first two columns lie about two vectors alike. */
    private boolean setNearestRotation(double x0, double x1, double x2, double y0, double y1, double y2) {
        double ofX = 1 / Math.sqrt(x0 * x0 + x1 * x1 + x2 * x2);
        double ofY = 1 / Math.sqrt(y0 * y0 + y1 * y1 + y2 * y2);
        double c0 = x0 * ofX + y0 * ofY;
        double c1 = x1 * ofX + y1 * ofY;
        double c2 = x2 * ofX + y2 * ofY;
        double d0 = x0 * ofX - y0 * ofY;
        double d1 = x1 * ofX - y1 * ofY;
        double d2 = x2 * ofX - y2 * ofY;
        // sum and difference of two unit vectors stand at right angles
        double c = ROOT_HALF / Math.sqrt(c0 * c0 + c1 * c1 + c2 * c2);
        double d = ROOT_HALF / Math.sqrt(d0 * d0 + d1 * d1 + d2 * d2);
        double[] r = cameraFromSquare.R.data;
        r[0] = c0 * c + d0 * d;
        r[3] = c1 * c + d1 * d;
        r[6] = c2 * c + d2 * d;
        r[1] = c0 * c - d0 * d;
        r[4] = c1 * c - d1 * d;
        r[7] = c2 * c - d2 * d;
        r[2] = r[3] * r[7] - r[6] * r[4];
        r[5] = r[6] * r[1] - r[0] * r[7];
        r[8] = r[0] * r[4] - r[3] * r[1];
        return c < Double.POSITIVE_INFINITY && d < Double.POSITIVE_INFINITY && c + d > 0;
    }

    /** The pose as the solver sees it: steps turn it by a rotation vector in the camera frame, and shift it. */
    private final class Pose implements DampedGaussNewton.Problem {
        private final double[] observed = new double[2 * MarkerGeometry.CORNERS];
        private final double[] rotation = new double[9];
        private final double[] translation = new double[3];
        private final double[] turn = new double[9];
        private final double[] trialRotation = new double[9];
        private final double[] trialTranslation = new double[3];

        /** Stands where {@link #cameraFromSquare} is. */
        void start(double[] cornersPx) {
            System.arraycopy(cornersPx, 0, observed, 0, observed.length);
            System.arraycopy(cameraFromSquare.R.data, 0, rotation, 0, 9);
            translation[0] = cameraFromSquare.T.x;
            translation[1] = cameraFromSquare.T.y;
            translation[2] = cameraFromSquare.T.z;
            if (plane != null) {
                RigidTransform inCamera = plane.inCamera(RigidTransform.of(rotation, translation));
                System.arraycopy(inCamera.rotation(), 0, rotation, 0, 9);
                System.arraycopy(inCamera.translationMm(), 0, translation, 0, 3);
            }
        }

        @Override
        public double linearise(double[] information, double[] gradient) {
            return SquareResidual.this.linearise(observed, rotation, translation, information, gradient);
        }

        @Override
        public double at(double[] step) {
            Rotations.exp(step[0], step[1], step[2], turn);
            Rotations.multiply(turn, rotation, trialRotation);
            for (int k = 0; k < 3; k++) {
                trialTranslation[k] = translation[k] + step[3 + k];
            }
            return sumOfSquares(observed, trialRotation, trialTranslation);
        }

        @Override
        public void accept() {
            System.arraycopy(trialRotation, 0, rotation, 0, 9);
            System.arraycopy(trialTranslation, 0, translation, 0, 3);
        }

        @Override
        public boolean isEnough(double squaredStds, double before, double after, boolean accepted) {
            return accepted && before - after <= ENOUGH * before;
        }
    }

    private double sumOfSquares(double[] cornersPx, double[] r, double[] t) {
        double sum = 0;
        for (int i = 0; i < MarkerGeometry.CORNERS; i++) {
            double x = r[0] * square[3 * i] + r[1] * square[3 * i + 1] + t[0];
            double y = r[3] * square[3 * i] + r[4] * square[3 * i + 1] + t[1];
            double z = r[6] * square[3 * i] + r[7] * square[3 * i + 1] + t[2];
            if (!lens.project(intrinsics, x, y, z, uv, 0)) {
                return Double.POSITIVE_INFINITY;
            }
            double du = uv[0] - cornersPx[2 * i];
            double dv = uv[1] - cornersPx[2 * i + 1];
            sum += du * du + dv * dv;
        }
        return sum;
    }

    /** Fills the normal equations at a pose, rotation vector (in the camera frame) before translation. */
    private double linearise(double[] cornersPx, double[] r, double[] t, double[] normal, double[] gradient) {
        Arrays.fill(normal, 0);
        Arrays.fill(gradient, 0);
        double sum = 0;
        for (int i = 0; i < MarkerGeometry.CORNERS; i++) {
            double px = r[0] * square[3 * i] + r[1] * square[3 * i + 1];
            double py = r[3] * square[3 * i] + r[4] * square[3 * i + 1];
            double pz = r[6] * square[3 * i] + r[7] * square[3 * i + 1];
            if (!lens.projectWithDerivatives(intrinsics, px + t[0], py + t[1], pz + t[2], uv, byPoint, null)) {
                return Double.POSITIVE_INFINITY;
            }
            for (int k = 0; k < 2; k++) {
                double a = byPoint[3 * k];
                double b = byPoint[3 * k + 1];
                double c = byPoint[3 * k + 2];
                // a small rotation w moves the point by w x p
                row[0] = c * py - b * pz;
                row[1] = a * pz - c * px;
                row[2] = b * px - a * py;
                row[3] = a;
                row[4] = b;
                row[5] = c;
                double residual = uv[k] - cornersPx[2 * i + k];
                sum += residual * residual;
                for (int m = 0; m < POSE; m++) {
                    gradient[m] += row[m] * residual;
                    for (int n = 0; n < POSE; n++) {
                        normal[POSE * m + n] += row[m] * row[n];
                    }
                }
            }
        }
        return sum;
    }
}
