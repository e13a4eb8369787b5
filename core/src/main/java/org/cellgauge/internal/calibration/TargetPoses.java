package org.cellgauge.internal.calibration;

import java.util.Arrays;
import java.util.List;
import org.cellgauge.geometry.Lens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.geometry.DampedGaussNewton;
import org.cellgauge.vision.TargetPoints;
import org.jspecify.annotations.Nullable;

/**
 * Where the target stood in a photo, for a camera of which little is known: from the homography between a plane of the
 * target and the image, then by least squares over all that the photo shows (Z. Zhang, "A flexible new technique for
 * camera calibration", 2000, sections 3.1 and appendix A).
 */
final class TargetPoses {
    private static final int MAX_STEPS = 20;

    private final TargetPoints points;
    private final BoardShape board;
    private final LensChoice none;

    /**
     * Poses for one target.
     *
     * @param board its shape, which does not change here
     * @param lens the lens of the photos, whose parameters do not change either
     */
    TargetPoses(TargetPoints points, BoardShape board, LensChoice lens) {
        this.points = points;
        this.board = board;
        this.none = lens.known();
    }

    /**
     * Sets a photo's pose.
     *
     * @param photo receives it
     * @param values of lens and board
     * @return sum of squared errors of the points that count, px²; infinite where no pose was found
     */
    double find(TargetPhoto photo, double[] values) {
        double best = Double.POSITIVE_INFINITY;
        double[] bestRotation = photo.rotation.clone();
        double[] bestTranslation = photo.translation.clone();
        for (TargetPoints.Patch patch : points.patches()) {
            RigidTransform start = ofPatch(photo, patch, values);
            if (start == null) {
                continue;
            }
            System.arraycopy(start.rotation(), 0, photo.rotation, 0, 9);
            System.arraycopy(start.translationMm(), 0, photo.translation, 0, 3);
            double cost = refine(photo, values);
            if (cost < best) {
                best = cost;
                System.arraycopy(photo.rotation, 0, bestRotation, 0, 9);
                System.arraycopy(photo.translation, 0, bestTranslation, 0, 3);
            }
        }
        System.arraycopy(bestRotation, 0, photo.rotation, 0, 9);
        System.arraycopy(bestTranslation, 0, photo.translation, 0, 3);
        return best;
    }

    /** Least squares over the pose alone; sum of squared errors, px². */
    double refine(TargetPhoto photo, double[] values) {
        PoseProblem problem = new PoseProblem(photo, values);
        double cost = new DampedGaussNewton(problem.locals, DampedGaussNewton.Damping.NIELSEN, MAX_STEPS)
                .minimise(problem);
        return Double.isNaN(cost) ? Double.POSITIVE_INFINITY : 2 * cost;
    }

    /** One photo, its lens and board known: the equations of the adjustment, of which only the photo's own are used. */
    private final class PoseProblem implements DampedGaussNewton.Problem {
        private final TargetPhoto photo;
        private final BundleAdjustment adjustment;
        private final int locals;
        private final double[] ignored;
        private final double[] ignoredGradient;

        PoseProblem(TargetPhoto photo, double[] values) {
            this.photo = photo;
            adjustment = new BundleAdjustment(none, board, List.of(photo), values, 1);
            locals = adjustment.locals();
            ignored = new double[adjustment.globals() * adjustment.globals()];
            ignoredGradient = new double[adjustment.globals()];
        }

        @Override
        public double linearise(double[] information, double[] gradient) {
            double cost = adjustment.linearise(ignored, ignoredGradient);
            for (int i = 0; i < locals; i++) {
                gradient[i] = photo.ownGradient[i];
                for (int j = 0; j <= i; j++) {
                    information[i * locals + j] = photo.own[i * locals + j];
                    information[j * locals + i] = photo.own[i * locals + j];
                }
            }
            return cost;
        }

        @Override
        public double at(double[] step) {
            photo.tryStep(step, locals > 6);
            return adjustment.costHere();
        }

        @Override
        public void accept() {
            photo.acceptTrial();
        }

        @Override
        public boolean isEnough(double squaredStds, double before, double after, boolean accepted) {
            return accepted && before - after <= 1e-6 * before;
        }
    }

    private @Nullable RigidTransform ofPatch(TargetPhoto photo, TargetPoints.Patch patch, double[] values) {
        Lens lens = none.lens();
        RigidTransform patchFromTarget = patch.targetFromPatch().inverse();
        double[] xy = new double[2 * photo.count];
        double[] image = new double[2 * photo.count];
        double[] ray = new double[3];
        double[] point = new double[3];
        int n = 0;
        for (int i = 0; i < photo.count; i++) {
            int index = photo.points[i];
            if (!photo.active[i] || index < patch.first() || index >= patch.first() + patch.count()
                    || !lens.toRay(values, photo.uv[2 * i], photo.uv[2 * i + 1], ray) || !(ray[2] > 0.05)) {
                continue;
            }
            board.point(index, values, lens.parameterCount(), point);
            double[] inPatch = patchFromTarget.apply(point);
            xy[2 * n] = inPatch[0];
            xy[2 * n + 1] = inPatch[1];
            image[2 * n] = ray[0] / ray[2];
            image[2 * n++ + 1] = ray[1] / ray[2];
        }
        double[] h = n < 4 ? null : homography(xy, image, n);
        return h == null ? null : pose(h, patchFromTarget);
    }

    /** cameraFromTarget of the homography from a plane to the image at z = 1. */
    private static @Nullable RigidTransform pose(double[] h, RigidTransform patchFromTarget) {
        double n1 = Math.sqrt(h[0] * h[0] + h[3] * h[3] + h[6] * h[6]);
        double n2 = Math.sqrt(h[1] * h[1] + h[4] * h[4] + h[7] * h[7]);
        double scale = 2 / (n1 + n2) * Math.signum(h[8]);
        if (!Double.isFinite(scale) || scale == 0) {
            return null;
        }
        // the nearest pair at a right angle: both are turned towards each other alike
        double[] a = {h[0] / n1, h[3] / n1, h[6] / n1};
        double[] b = {h[1] / n2, h[4] / n2, h[7] / n2};
        double[] sum = unit(a[0] + b[0], a[1] + b[1], a[2] + b[2]);
        double[] difference = unit(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
        double sign = Math.signum(scale);
        double[] r = new double[9];
        for (int k = 0; k < 3; k++) {
            r[3 * k] = sign * (sum[k] + difference[k]) / Math.sqrt(2);
            r[3 * k + 1] = sign * (sum[k] - difference[k]) / Math.sqrt(2);
        }
        r[2] = r[3] * r[7] - r[6] * r[4];
        r[5] = r[6] * r[1] - r[0] * r[7];
        r[8] = r[0] * r[4] - r[3] * r[1];
        for (double v : r) {
            if (!Double.isFinite(v)) {
                return null;
            }
        }
        return RigidTransform.of(r, new double[] {scale * h[2], scale * h[5], scale * h[8]})
                .compose(patchFromTarget);
    }

    private static double[] unit(double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        return new double[] {x / length, y / length, z / length};
    }

    /**
     * The homography of point pairs by least squares, coordinates normalised first (R. Hartley and A. Zisserman,
     * "Multiple view geometry", 2nd ed. 2003, section 4.4.4), its last element being 1 there.
     *
     * @return 9 values row by row; null where the points lie on a line
     */
    static double @Nullable [] homography(double[] from, double[] to, int count) {
        double[] f = normalisation(from, count);
        double[] t = normalisation(to, count);
        double[] ata = new double[64];
        double[] atb = new double[8];
        double[] row = new double[8];
        for (int i = 0; i < count; i++) {
            double x = (from[2 * i] - f[0]) * f[2];
            double y = (from[2 * i + 1] - f[1]) * f[2];
            for (int k = 0; k < 2; k++) {
                double u = (to[2 * i + k] - t[k]) * t[2];
                Arrays.fill(row, 0);
                row[3 * k] = x;
                row[3 * k + 1] = y;
                row[3 * k + 2] = 1;
                row[6] = -u * x;
                row[7] = -u * y;
                for (int a = 0; a < 8; a++) {
                    atb[a] += row[a] * u;
                    for (int b = 0; b < 8; b++) {
                        ata[8 * a + b] += row[a] * row[b];
                    }
                }
            }
        }
        if (!Cholesky.factor(ata, 8)) {
            return null;
        }
        Cholesky.solveLower(ata, 8, atb);
        Cholesky.solveUpper(ata, 8, atb);
        double[] n = {atb[0], atb[1], atb[2], atb[3], atb[4], atb[5], atb[6], atb[7], 1};
        // undo both normalisations
        double[] h = new double[9];
        for (int i = 0; i < 3; i++) {
            double a = n[3 * i] * f[2];
            double b = n[3 * i + 1] * f[2];
            h[3 * i] = a;
            h[3 * i + 1] = b;
            h[3 * i + 2] = n[3 * i + 2] - a * f[0] - b * f[1];
        }
        for (int j = 0; j < 3; j++) {
            h[j] = h[j] / t[2] + t[0] * h[6 + j];
            h[3 + j] = h[3 + j] / t[2] + t[1] * h[6 + j];
        }
        return h;
    }

    /** Centroid and scale that brings points to a mean distance of about 1. */
    private static double[] normalisation(double[] xy, int count) {
        double x = 0;
        double y = 0;
        for (int i = 0; i < count; i++) {
            x += xy[2 * i] / count;
            y += xy[2 * i + 1] / count;
        }
        double distance = 0;
        for (int i = 0; i < count; i++) {
            distance += Math.hypot(xy[2 * i] - x, xy[2 * i + 1] - y) / count;
        }
        return new double[] {x, y, 1 / distance};
    }

    /**
     * The focal length that homographies of planes tell, pixels being square and the principal point in the middle.
     *
     * @return px; NaN where they tell none
     */
    static double focalPx(TargetPoints points, List<TargetPhoto> photos, int widthPx, int heightPx) {
        double top = 0;
        double bottom = 0;
        double[] xyz = points.xyzMm();
        for (TargetPhoto photo : photos) {
            for (TargetPoints.Patch patch : points.patches()) {
                RigidTransform patchFromTarget = patch.targetFromPatch().inverse();
                double[] from = new double[2 * photo.count];
                double[] to = new double[2 * photo.count];
                int n = 0;
                for (int i = 0; i < photo.count; i++) {
                    int index = photo.points[i];
                    if (index >= patch.first() && index < patch.first() + patch.count()) {
                        double[] p = patchFromTarget.apply(xyz[3 * index], xyz[3 * index + 1], xyz[3 * index + 2]);
                        from[2 * n] = p[0];
                        from[2 * n + 1] = p[1];
                        to[2 * n] = (photo.uv[2 * i] - widthPx / 2.0) / widthPx;
                        to[2 * n++ + 1] = (photo.uv[2 * i + 1] - heightPx / 2.0) / widthPx;
                    }
                }
                double[] h = n < 4 ? null : homography(from, to, n);
                if (h == null) {
                    continue;
                }
                double norm = h[0] * h[0] + h[3] * h[3] + h[1] * h[1] + h[4] * h[4];
                double[] a = {(h[0] * h[1] + h[3] * h[4]) / norm,
                    (h[0] * h[0] + h[3] * h[3] - h[1] * h[1] - h[4] * h[4]) / norm};
                double[] b = {h[6] * h[7] / norm, (h[6] * h[6] - h[7] * h[7]) / norm};
                // a / f² + b = 0
                top -= a[0] * b[0] + a[1] * b[1];
                bottom += a[0] * a[0] + a[1] * a[1];
            }
        }
        return top > 0 && bottom > 0 ? widthPx * Math.sqrt(bottom / top) : Double.NaN;
    }

    /** The values of a lens that only a focal length is known of, with those of a flat board. */
    static double[] values(Lens lens, BoardShape board, double focalPx, int widthPx, int heightPx) {
        double[] values = new double[lens.parameterCount() + board.unknowns()];
        values[PinholeCamera.FX] = focalPx;
        values[PinholeCamera.FY] = focalPx;
        values[PinholeCamera.CX] = widthPx / 2.0;
        values[PinholeCamera.CY] = heightPx / 2.0;
        return values;
    }
}
