package org.cellgauge.internal.pose;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.function.Predicate;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.geometry.Rotations;
import org.jspecify.annotations.Nullable;

/**
 * Pose of one marker in the camera frame from its four corners, with both of its modes.
 *
 * <p>A small square seen nearly frontally has two poses that explain its corners almost equally well: its normal may be
 * mirrored about the line of sight (Schweighofer and Pinz, "Robust pose estimation from a planar target", PAMI 2006).
 *
 * <p>Not thread-safe: it holds work space, so that the markers of a photo are fitted in the same arrays, one after the
 * other. A pose does not depend on those found before it; poses found last are not searched for again.
 */
public final class MarkerPoseFinder {
    /** Two fits closer than this angle are one mode, rad. */
    private static final double SAME_MODE_RAD = 1e-3;
    private static final int BASINS = 3;
    private static final int REMEMBERED = 16;

    private final double[] points = new double[3 * MarkerGeometry.CORNERS];
    private final double[] observed = new double[2 * MarkerGeometry.CORNERS];
    private final ReprojectionFit fit = new ReprojectionFit(points, observed, IntrinsicsPrior.KNOWN, null);
    private final TargetPnp pnp = new TargetPnp();
    private final CameraState state = new CameraState();
    private final double[] covariance = new double[StateLayout.POSE * StateLayout.POSE];
    /** What the last search found, in the order of the first {@link #found} of {@link #order}. */
    private final double[][] rotations = new double[BASINS][9];
    private final double[][] offsets = new double[BASINS][3];
    private final @Nullable PoseMode[] modes = new @Nullable PoseMode[BASINS];
    private final double[] logWeights = new double[BASINS];
    private final double[] squares = new double[BASINS];
    private final int[] order = new int[BASINS];
    private int found;
    private final Predicate<CameraState> isFound = this::isKnown;
    /** The last searches with unit weights, in turn. */
    private final @Nullable Searched[] searched = new @Nullable Searched[REMEMBERED];
    private int next;
    private final double[] turn = new double[9];
    private final double[] product = new double[9];
    private final double[] all = new double[64];
    private final Squareness.Space space = new Squareness.Space();

    /** Poses of a marker, weighed with one pixel for each coordinate, and what they were found from. */
    private static final class Searched {
        private final double[] cornersPx = new double[2 * MarkerGeometry.CORNERS];
        private double sizeMm;
        private @Nullable PinholeCamera camera;
        private final double[][] rotations = new double[2][9];
        private final double[][] offsets = new double[2][3];
        private int found;

        boolean isOf(double[] corners, double size, PinholeCamera before) {
            return camera == before && sizeMm == size && Arrays.equals(cornersPx, corners);
        }
    }

    /** A finder for one thread. */
    public MarkerPoseFinder() {
        // nothing is known of any marker yet
    }

    /**
     * The best pose of one marker, by least squares with equal weights.
     *
     * @param cornersPx 8 values, px
     * @param sizeMm outer edge of the marker, mm
     * @param camera intrinsics
     * @return cameraFromMarker, or null if the corners are of no pose at all
     */
    public @Nullable RigidTransform best(double[] cornersPx, double sizeMm, PinholeCamera camera) {
        PoseMode best = null;
        // the smallest residuals decide: weights depend on a corner noise that is not stated here
        for (PoseMode mode : modes(cornersPx, sizeMm, camera, 1)) {
            if (best == null || mode.halfChiSquare() < best.halfChiSquare()) {
                best = mode;
            }
        }
        return best == null ? null : best.cameraFromSet();
    }

    /**
     * The modes of the posterior of one marker's pose, flat prior.
     *
     * @param cornersPx 8 values, px
     * @param sizeMm outer edge of the marker, mm
     * @param camera intrinsics
     * @param pixelStdPx standard deviation of each corner coordinate, px
     * @return one or two modes, the heavier (by {@link PoseMode#logWeight()}) first; empty if the corners are of no
     *     pose
     */
    public List<PoseMode> modes(double[] cornersPx, double sizeMm, PinholeCamera camera, double pixelStdPx) {
        fit.setIsotropic(pixelStdPx);
        List<PoseMode> list = modes(cornersPx, sizeMm, camera);
        if (pixelStdPx == 1) {
            remember(cornersPx, sizeMm, camera);
        }
        return list;
    }

    /**
     * The poses of these modes, weighed alike with one pixel for each coordinate: for those who need nothing else of
     * them.
     *
     * @param cornersPx 8 values, px
     * @param sizeMm outer edge of the marker, mm
     * @param camera intrinsics
     * @return one or two cameraFromMarker, the heavier first; empty if the corners are of no pose
     */
    List<RigidTransform> poses(double[] cornersPx, double sizeMm, PinholeCamera camera) {
        List<RigidTransform> list = new ArrayList<>(2);
        for (@Nullable Searched last : searched) {
            if (last != null && last.isOf(cornersPx, sizeMm, camera)) {
                for (int k = 0; k < last.found; k++) {
                    list.add(RigidTransform.of(last.rotations[k], last.offsets[k]));
                }
                return list;
            }
        }
        fit.setIsotropic(1);
        search(cornersPx, sizeMm, camera, false, null);
        for (int k = 0; k < found; k++) {
            list.add(RigidTransform.of(rotations[order[k]], offsets[order[k]]));
        }
        return list;
    }

    /** Keeps what the last search with unit weights has found. */
    private void remember(double[] cornersPx, double sizeMm, PinholeCamera camera) {
        Searched last = searched[next];
        if (last == null) {
            last = new Searched();
            searched[next] = last;
        }
        next = (next + 1) % REMEMBERED;
        System.arraycopy(cornersPx, 0, last.cornersPx, 0, cornersPx.length);
        last.sizeMm = sizeMm;
        last.camera = camera;
        last.found = found;
        for (int k = 0; k < found; k++) {
            System.arraycopy(rotations[order[k]], 0, last.rotations[k], 0, 9);
            System.arraycopy(offsets[order[k]], 0, last.offsets[k], 0, 3);
        }
    }

    /**
     * Squared length of what no pose of the marker explains of its corners, in deviations, of the mode that fits best:
     * {@link Squareness#chiSquare} of modes that nobody else needs.
     *
     * @param errors what is known of the corners' errors but for what is added to each; all of them count
     * @param unknowns number of unknowns that they share with other markers
     * @param sizeMm outer edge of the marker, mm
     * @param camera intrinsics
     * @return not negative; NaN where the corners are of no pose
     */
    double squareChiSquare(MarkerErrors errors, int unknowns, double sizeMm, PinholeCamera camera) {
        System.arraycopy(errors.covariancePx2, 0, all, 0, all.length);
        double[] columns = errors.columns;
        for (int i = 0; i < 8; i++) {
            for (int k = 0; k < 8; k++) {
                for (int j = 0; j < unknowns; j++) {
                    all[8 * i + k] += columns[i * unknowns + j] * columns[k * unknowns + j];
                }
            }
        }
        fit.setIsotropic(1);
        search(errors.cornersPx, sizeMm, camera, false, all);
        remember(errors.cornersPx, sizeMm, camera);
        double least = found == 0 ? Double.NaN : Double.POSITIVE_INFINITY;
        for (int k = 0; k < found; k++) {
            least = Math.min(least, squares[order[k]]);
        }
        return least;
    }

    /**
     * The same with a covariance of the corners.
     *
     * @param cornersPx 8 values, px
     * @param sizeMm outer edge of the marker, mm
     * @param camera intrinsics
     * @param whitening inverse of the Cholesky factor of the covariance, 8x8 row by row, lower triangular, 1/px
     * @return one or two modes, the heavier first; empty if the corners are of no pose
     */
    public List<PoseMode> modes(double[] cornersPx, double sizeMm, PinholeCamera camera, double[] whitening) {
        fit.setWhitening(whitening);
        return modes(cornersPx, sizeMm, camera);
    }

    private List<PoseMode> modes(double[] cornersPx, double sizeMm, PinholeCamera camera) {
        search(cornersPx, sizeMm, camera, true, null);
        List<PoseMode> list = new ArrayList<>(2);
        for (int k = 0; k < found; k++) {
            list.add(Objects.requireNonNull(modes[order[k]], "it was asked for"));
        }
        Arrays.fill(modes, null);
        return list;
    }

    /**
     * Finds the poses and leaves them in the fields, the two heaviest in order.
     *
     * @param wholeModes whether all is wanted that Laplace's method needs
     * @param covariancePx2 what squares are measured by; null where they are not wanted
     */
    private void search(double[] cornersPx, double sizeMm, PinholeCamera camera, boolean wholeModes,
            double @Nullable [] covariancePx2) {
        MarkerGeometry.cornersMm(sizeMm, points);
        System.arraycopy(cornersPx, 0, observed, 0, observed.length);
        found = 0;
        RigidTransform start = pnp.planar(camera, points, observed);
        if (start == null) {
            start = pnp.general(camera, points, observed);
        }
        if (start == null) {
            return;
        }
        state.set(start, camera);
        // from each mode found the mirrored pose is tried; a third round comes back to the first
        for (int i = 0; i < BASINS; i++) {
            double cost = !camera.lens().isWide() && !(state.offset[2] > 0) ? Double.NaN
                    : fit.fit(state, found == 0 ? null : isFound);
            if (Double.isNaN(cost)) {
                break;
            }
            // what Laplace's method needs is not worked out for a pose that is known
            if (!isKnown(state)) {
                if (!fit.invertInformation(covariance)) {
                    break;
                }
                if (wholeModes) {
                    modes[found] = new PoseMode(fit, state, cost, null, covariance.clone());
                }
                logWeights[found] = fit.logWeight(cost, covariance);
                if (covariancePx2 != null) {
                    squares[found] = space.chiSquare(fit.jacobian(), fit.residuals(), covariancePx2);
                }
                System.arraycopy(state.rotation, 0, rotations[found], 0, 9);
                System.arraycopy(state.offset, 0, offsets[found], 0, 3);
                found++;
            }
            mirror(state.rotation, state.offset, turn, product);
        }
        sort();
    }

    /** The heaviest first, no more than two. */
    private void sort() {
        for (int k = 0; k < found; k++) {
            int at = k;
            for (; at > 0 && Double.compare(logWeights[order[at - 1]], logWeights[k]) < 0; at--) {
                order[at] = order[at - 1];
            }
            order[at] = k;
        }
        found = Math.min(found, 2);
    }

    private boolean isKnown(CameraState pose) {
        for (int k = 0; k < found; k++) {
            if (Rotations.angle(pose.rotation, rotations[k], product, turn) < SAME_MODE_RAD) {
                return true;
            }
        }
        return false;
    }

    /**
     * The pose whose normal is mirrored about the line of sight to the centre.
     *
     * @param cameraFromPlane pose of a planar set, normal along its z
     * @return the mirrored pose, same centre
     */
    static RigidTransform mirrored(RigidTransform cameraFromPlane) {
        double[] rotation = cameraFromPlane.rotation();
        double[] offset = cameraFromPlane.translationMm();
        mirror(rotation, offset, new double[9], new double[9]);
        return RigidTransform.of(rotation, offset);
    }

    /** The same in place, with work space of 9 values each. */
    private static void mirror(double[] r, double[] t, double[] turn, double[] product) {
        double length = Math.sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
        double sx = t[0] / length;
        double sy = t[1] / length;
        double sz = t[2] / length;
        double along = r[2] * sx + r[5] * sy + r[8] * sz;
        // turning by twice the angle between normal and sight, about their common perpendicular
        double ax = r[5] * sz - r[8] * sy;
        double ay = r[8] * sx - r[2] * sz;
        double az = r[2] * sy - r[5] * sx;
        double sine = Math.sqrt(ax * ax + ay * ay + az * az);
        if (sine < 1e-9) {
            return;
        }
        // the face looks towards the camera, so its normal is nearer to minus the line of sight
        double angle = 2 * (along < 0 ? Math.atan2(sine, along) - Math.PI : Math.atan2(sine, along));
        Rotations.exp(ax / sine * angle, ay / sine * angle, az / sine * angle, turn);
        Rotations.multiply(turn, r, product);
        System.arraycopy(product, 0, r, 0, 9);
    }
}
