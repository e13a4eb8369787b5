package org.cellgauge.internal.plan;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.Placement;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.pose.AddedNoise;
import org.cellgauge.internal.pose.EdgeModel;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.pose.PosePrior;
import org.cellgauge.internal.vision.CornerForecast;
import org.cellgauge.vision.EdgeShift;
import org.cellgauge.vision.MarkerObservation;
import org.cellgauge.vision.PhotoLight;
import org.jspecify.annotations.Nullable;

/**
 * One photo of a cell as it is thought of: the unknowns that its markers share, and what each marker tells of them;
 * immutable.
 *
 * <p>The unknowns, in this order: the camera's shift in the world (mm) and its turn about world axes (rad); unknown
 * intrinsics; and, as unit-normal unknowns, the shift of the photo's edges and what it is wrongly told by, how far ink
 * has spread and how wrong sizes are on the markers of each size. Given these, markers err independently of each other
 * (placement and corners of one, corners of the other), so that Fisher information adds over references: a layout is a
 * sum of matrices, one for each marker, and these need be made once. The mathematics is that of the check's Laplace
 * approximation at the true poses (method notes, "What to build as the default"), arranged by marker.
 *
 * <p>An object's pose is unknown, too. Eliminating it leaves what its corners tell of the shared unknowns, and for a
 * point of it a row {@code c} and a variance {@code d}: its variance in the world is {@code c^T I^-1 c + d}, I being
 * the information of the layout (a Schur complement; Triggs et al., "Bundle adjustment - a modern synthesis", 2000,
 * section 6.1).
 */
public final class PlannedView {
    /** Unknowns of the camera's pose. */
    public static final int POSE = 6;

    private final PinholeCamera camera;
    private final RigidTransform worldFromCamera;
    private final RigidTransform cameraFromWorld;
    private final double[] rotation;
    private final double[] position;
    private final double statedStdPx;
    private final @Nullable CornerForecast forecast;
    private final double photos;
    /** Noise that a check would add to the forecast, as a share of its variance. */
    private final double addedShare;
    private final IntrinsicsPrior intrinsics;
    private final boolean shifts;
    private final double outlineStdPx;
    private final double printGainStdMm;
    private final double sizeStdMm;
    private final double flatnessMm;
    private final List<Double> sizesMm;
    private final int unknowns;

    /**
     * A photo of a cell.
     *
     * @param cell the camera, how precisely prints are made, and the noise of corners where it is stated
     * @param worldFromCamera where the camera stands
     * @param forecast what the detector would state of corners; used where the cell states no noise
     * @param photos so many photos from there are taken together: their noise averages out, placements do not
     * @param intrinsics prior of the unknown intrinsics
     * @param sizesMm sizes of markers that there may be
     * @param markers how many markers tell, by how square they are, what noise there is beside the forecast
     */
    public PlannedView(Cell cell, RigidTransform worldFromCamera, CornerForecast forecast, int photos,
            IntrinsicsPrior intrinsics, List<Double> sizesMm, int markers) {
        camera = cell.camera();
        this.worldFromCamera = worldFromCamera;
        cameraFromWorld = worldFromCamera.inverse();
        rotation = worldFromCamera.rotation();
        position = worldFromCamera.translationMm();
        statedStdPx = cell.pixelStdPx().orElse(Double.NaN);
        this.forecast = cell.pixelStdPx().isPresent() ? null : forecast;
        this.photos = photos;
        this.intrinsics = intrinsics;
        outlineStdPx = PhotoLight.usualOutlineStdPx(forecast.blurPx());
        shifts = this.forecast != null;
        addedShare = shifts ? addedShare(markers) : 0;
        printGainStdMm = shifts ? cell.prints().printGainStdMm() : 0;
        sizeStdMm = cell.prints().sizeStdMm();
        flatnessMm = cell.prints().flatnessMm();
        this.sizesMm = new ArrayList<>(sizesMm);
        unknowns = firstSize() + (sizeStdMm > 0 ? sizesMm.size() : 0);
    }

    /**
     * What a check is left to believe of noise beside that of fits, on photos that have none of it: the mean over its
     * prior times the likelihood of squares, two degrees of freedom for each marker, that are as large as is usual.
     */
    private static double addedShare(int markers) {
        AddedNoise ofUnit = AddedNoise.toFits(1);
        double total = 0;
        double mean = 0;
        for (int node = 0; node < AddedNoise.NODES; node++) {
            double u = AddedNoise.atNode(node);
            double share = ofUnit.variancePx2(u);
            double log = -0.5 * u * u - markers * (Math.log1p(share) + 1 / (1 + share) - 1);
            double weight = Math.exp(log);
            total += weight;
            mean += weight * share;
        }
        return mean / total;
    }

    private int firstShift() {
        return POSE + intrinsics.count();
    }

    private int firstGain() {
        return firstShift() + (shifts ? 2 : 0);
    }

    private int firstSize() {
        return firstGain() + (printGainStdMm > 0 ? sizesMm.size() : 0);
    }

    /**
     * Number of shared unknowns.
     *
     * @return n: at least six
     */
    public int unknowns() {
        return unknowns;
    }

    /**
     * Whether an unknown is one of every photo for itself, as the pose and the shift of edges are, and not of the
     * camera and the prints.
     *
     * @param unknown 0 to {@link #unknowns()} - 1
     * @return false for intrinsics, ink and sizes
     */
    boolean isOfPhoto(int unknown) {
        return unknown < POSE || unknown >= firstShift() && unknown < firstGain();
    }

    /**
     * Where the camera stands.
     *
     * @return x_world = worldFromCamera · x_camera
     */
    public RigidTransform worldFromCamera() {
        return worldFromCamera;
    }

    /**
     * What is known before any marker is seen.
     *
     * @param references number of references that will be; with few of them the check's weak prior of the pose counts
     * @param centroidMm centroid of these in the world, mm, which that prior is about
     * @return information, n x n
     */
    public double[] prior(int references, double[] centroidMm) {
        int n = unknowns;
        double[] out = new double[n * n];
        if (PosePrior.isNeededFor(references)) {
            double[] arm = new double[3];
            double[] axis = new double[3];
            double[] row = new double[POSE];
            for (int i = 0; i < 3; i++) {
                arm[i] = centroidMm[i] - position[i];
                out[(3 + i) * (n + 1)] = 1 / (PosePrior.WEAK_STD_RAD * PosePrior.WEAK_STD_RAD);
            }
            for (int i = 0; i < 3; i++) {
                for (int j = 0; j < 3; j++) {
                    axis[j] = rotation[3 * j + i];
                    row[j] = -axis[j];
                }
                setCross(arm, axis, row, 3, -1);
                for (int a = 0; a < POSE; a++) {
                    for (int b = 0; b < POSE; b++) {
                        out[a * n + b] += row[a] * row[b] / (PosePrior.WEAK_STD_MM * PosePrior.WEAK_STD_MM);
                    }
                }
            }
        }
        for (int i = 0; i < intrinsics.count(); i++) {
            for (int j = 0; j < intrinsics.count(); j++) {
                out[(POSE + i) * n + POSE + j] = intrinsics.information(i, j);
            }
        }
        for (int i = firstShift(); i < n; i++) {
            out[i * (n + 1)] = 1;
        }
        return out;
    }

    /** Rows of one marker: eight corner coordinates and, where shifts are measured, that. */
    private final class Rows {
        final double[] px;
        final int count;
        /** Derivative of the corners by their places in the camera frame, 8 x 3. */
        final double[] byPoint = new double[24];
        /** Change of the rows by the unknowns after the pose. */
        final double[] shared;
        /** Covariance of the rows' own errors, count x count. */
        final double[] covariance;
        final double[] cornersMm;

        Rows(RigidTransform cameraFromMarker, double sizeMm, double[] px) {
            this.px = px;
            int after = unknowns - POSE;
            count = shifts ? 9 : 8;
            shared = new double[count * after];
            cornersMm = MarkerGeometry.cornersMm(cameraFromMarker, sizeMm);
            double[] centre = cameraFromMarker.translationMm();
            double[] normal = cameraFromMarker.rotation();
            int parameters = camera.intrinsics().length;
            double[] byParameters = new double[2 * parameters];
            double[] byCorner = new double[6];
            double[] uv = new double[2];
            double[] bySize = new double[8];
            double[] byHeight = new double[8];
            for (int k = 0; k < 4; k++) {
                camera.lens().projectWithDerivatives(camera.intrinsics(), cornersMm[3 * k], cornersMm[3 * k + 1],
                        cornersMm[3 * k + 2], uv, byCorner, byParameters);
                System.arraycopy(byCorner, 0, byPoint, 6 * k, 6);
                for (int c = 0; c < 2; c++) {
                    for (int i = 0; i < 3; i++) {
                        bySize[2 * k + c] += byCorner[3 * c + i] * (cornersMm[3 * k + i] - centre[i]) / sizeMm;
                        byHeight[2 * k + c] += byCorner[3 * c + i] * normal[3 * i + 2];
                    }
                    for (int i = 0; i < intrinsics.count(); i++) {
                        shared[(2 * k + c) * after + i] = byParameters[c * parameters + intrinsics.index(i)];
                    }
                }
            }
            covariance = new double[count * count];
            if (forecast == null) {
                for (int i = 0; i < 8; i++) {
                    covariance[i * (count + 1)] = statedStdPx * statedStdPx / photos;
                }
            } else {
                setForecast(forecast.of(0, px), sizeMm, after);
            }
            for (int k = 0; k < 8 && flatnessMm > 0; k += 2) {
                for (int i = k; i < k + 2; i++) {
                    for (int j = k; j < k + 2; j++) {
                        covariance[i * count + j] += byHeight[i] * byHeight[j] * flatnessMm * flatnessMm;
                    }
                }
            }
            if (sizeStdMm > 0) {
                int column = firstSize() - POSE + sizesMm.indexOf(sizeMm);
                for (int i = 0; i < 8; i++) {
                    shared[i * after + column] = bySize[i] * sizeStdMm;
                }
            }
        }

        private void setForecast(MarkerObservation told, double sizeMm, int after) {
            double[] own = told.covariancePx2();
            EdgeShift shift = told.edgeShift();
            if (own == null || shift == null) {
                throw new IllegalStateException("a forecast has both");
            }
            double mean = 0;
            for (int i = 0; i < 8; i++) {
                mean += own[9 * i] / 8;
                for (int j = 0; j < 8; j++) {
                    covariance[i * count + j] = own[8 * i + j] / photos;
                }
            }
            double added = addedShare * mean;
            double[] both = shift.covarianceWithCornersPx2();
            for (int i = 0; i < 8; i++) {
                covariance[i * (count + 1)] += added / photos;
                covariance[i * count + 8] = both[i] / photos;
                covariance[8 * count + i] = both[i] / photos;
            }
            covariance[8 * count + 8] = shift.variancePx2() / photos + EdgeModel.DISCREPANCY_STD_PX
                    * EdgeModel.DISCREPANCY_STD_PX;
            double[] byShift = EdgeShift.ofCorners(px);
            double perimeter = 0;
            for (int i = 0; i < 4; i++) {
                int j = (i + 1) % 4;
                perimeter += Math.hypot(px[2 * j] - px[2 * i], px[2 * j + 1] - px[2 * i + 1]);
            }
            double pxPerMm = perimeter / 4 / sizeMm;
            int column = firstShift() - POSE;
            for (int i = 0; i < 9; i++) {
                shared[i * after + column] = (i < 8 ? byShift[i] : 1) * CornerForecast.EDGE_SHIFT_STD_PX;
            }
            shared[8 * after + column + 1] = outlineStdPx;
            if (printGainStdMm > 0) {
                double[] byInk = EdgeShift.byInk(px, sizeMm);
                int gain = firstGain() - POSE + sizesMm.indexOf(sizeMm);
                for (int i = 0; i < 9; i++) {
                    shared[i * after + gain] = (i < 8 ? byInk[i] : -pxPerMm) * printGainStdMm;
                }
            }
        }
    }

    /**
     * What a reference would tell of the shared unknowns.
     *
     * @param worldFromMarker where it stands
     * @param sizeMm its size, one of those named
     * @param placement how precisely it is placed there
     * @return information, n x n; null where it would not be seen from the front and wholly in the image
     */
    public double @Nullable [] information(RigidTransform worldFromMarker, double sizeMm, Placement placement) {
        Jacobians seen = jacobians(worldFromMarker, sizeMm);
        if (seen == null) {
            return null;
        }
        double[] variances = {placement.stdMm(0), placement.stdMm(1), placement.stdMm(2), placement.stdRad(),
            placement.stdRad(), placement.stdRad()};
        int m = seen.rows.count;
        double[] covariance = seen.rows.covariance;
        double[] byPlace = seen.byPlace;
        for (int i = 0; i < 8; i++) {
            for (int j = 0; j < 8; j++) {
                for (int p = 0; p < POSE; p++) {
                    covariance[i * m + j] += byPlace[i * POSE + p] * byPlace[j * POSE + p] * variances[p]
                            * variances[p];
                }
            }
        }
        return gram(covariance, m, seen.byUnknown, unknowns);
    }

    /**
     * What a marker tells of the shared unknowns and of its own place together.
     *
     * @param worldFromMarker where it stands
     * @param sizeMm its size, one of those named
     * @return information, (n + 6) x (n + 6): the shared unknowns, then the marker's shift in the world (mm) and its
     *     turn about world axes (rad); null where it would not be seen from the front and wholly in the image
     */
    public double @Nullable [] withPlace(RigidTransform worldFromMarker, double sizeMm) {
        Jacobians seen = jacobians(worldFromMarker, sizeMm);
        if (seen == null) {
            return null;
        }
        int n = unknowns;
        int m = seen.rows.count;
        double[] both = new double[m * (n + POSE)];
        for (int row = 0; row < m; row++) {
            System.arraycopy(seen.byUnknown, row * n, both, row * (n + POSE), n);
            System.arraycopy(seen.byPlace, row * POSE, both, row * (n + POSE) + n, POSE);
        }
        return gram(seen.rows.covariance, m, both, n + POSE);
    }

    /** A marker's rows and their changes by the shared unknowns, and by its own place. */
    private static final class Jacobians {
        final Rows rows;
        final double[] byUnknown;
        final double[] byPlace;

        Jacobians(Rows rows, double[] byUnknown, double[] byPlace) {
            this.rows = rows;
            this.byUnknown = byUnknown;
            this.byPlace = byPlace;
        }
    }

    private @Nullable Jacobians jacobians(RigidTransform worldFromMarker, double sizeMm) {
        RigidTransform cameraFromMarker = cameraFromWorld.compose(worldFromMarker);
        double[] px = MarkerGeometry.seenPx(camera, cameraFromMarker, sizeMm);
        if (px == null) {
            return null;
        }
        Rows rows = new Rows(cameraFromMarker, sizeMm, px);
        int n = unknowns;
        int m = rows.count;
        double[] byUnknown = new double[m * n];
        double[] byPlace = new double[m * POSE];
        double[] centreMm = worldFromMarker.translationMm();
        double[] inWorld = new double[3];
        double[] arm = new double[3];
        for (int row = 0; row < 8; row++) {
            int k = row / 2;
            // derivative by the corner's place in the world: that by its place in the camera frame, turned
            for (int i = 0; i < 3; i++) {
                inWorld[i] = 0;
                for (int j = 0; j < 3; j++) {
                    inWorld[i] += rows.byPoint[3 * row + j] * rotation[3 * i + j];
                }
            }
            worldArm(rows.cornersMm, k, arm);
            for (int i = 0; i < 3; i++) {
                byUnknown[row * n + i] = -inWorld[i];
                byPlace[row * POSE + i] = inWorld[i];
            }
            // turning the camera by w moves what it sees by -w x arm; turning the marker, by w x its own arm
            setCross(arm, inWorld, byUnknown, row * n + 3, -1);
            for (int i = 0; i < 3; i++) {
                arm[i] += position[i] - centreMm[i];
            }
            setCross(arm, inWorld, byPlace, row * POSE + 3, 1);
        }
        for (int row = 0; row < m; row++) {
            System.arraycopy(rows.shared, row * (n - POSE), byUnknown, row * n + POSE, n - POSE);
        }
        return new Jacobians(rows, byUnknown, byPlace);
    }

    /** From the camera to a corner, in world axes. */
    private void worldArm(double[] cornersMm, int corner, double[] out) {
        for (int i = 0; i < 3; i++) {
            out[i] = 0;
            for (int j = 0; j < 3; j++) {
                out[i] += rotation[3 * i + j] * cornersMm[3 * corner + j];
            }
        }
    }

    /** The derivative by a turn w of a value whose derivative by a point is g, the point moving by w x arm. */
    private static void setCross(double[] arm, double[] g, double[] out, int at, double sign) {
        out[at] = sign * (arm[1] * g[2] - arm[2] * g[1]);
        out[at + 1] = sign * (arm[2] * g[0] - arm[0] * g[2]);
        out[at + 2] = sign * (arm[0] * g[1] - arm[1] * g[0]);
    }

    /** {@code J^T C^-1 J} of rows J, m x n; C is destroyed, and J whitened. */
    private static double[] gram(double[] covariance, int m, double[] jacobian, int n) {
        if (!Cholesky.factor(covariance, m)) {
            throw new IllegalStateException("the covariance of corners is not positive definite");
        }
        for (int i = 0; i < m; i++) {
            for (int c = 0; c < n; c++) {
                double s = jacobian[i * n + c];
                for (int k = 0; k < i; k++) {
                    s -= covariance[i * m + k] * jacobian[k * n + c];
                }
                jacobian[i * n + c] = s / covariance[i * m + i];
            }
        }
        double[] out = new double[n * n];
        for (int a = 0; a < n; a++) {
            for (int b = 0; b <= a; b++) {
                double s = 0;
                for (int i = 0; i < m; i++) {
                    s += jacobian[i * n + a] * jacobian[i * n + b];
                }
                out[a * n + b] = s;
                out[b * n + a] = s;
            }
        }
        return out;
    }

    /**
     * An object in the photo.
     *
     * @param worldFromObject where it stands
     * @param sizeMm size of its marker, one of those named
     * @return what its marker tells; null where it would not be seen from the front and wholly in the image, or its
     *     corners do not tell its pose
     */
    public @Nullable SeenObject object(RigidTransform worldFromObject, double sizeMm) {
        RigidTransform cameraFromObject = cameraFromWorld.compose(worldFromObject);
        double[] px = MarkerGeometry.seenPx(camera, cameraFromObject, sizeMm);
        if (px == null) {
            return null;
        }
        Rows rows = new Rows(cameraFromObject, sizeMm, px);
        int m = rows.count;
        int after = unknowns - POSE;
        int columns = POSE + after;
        double[] jacobian = new double[m * columns];
        double[] centreMm = cameraFromObject.translationMm();
        double[] byPoint = new double[3];
        double[] arm = new double[3];
        for (int row = 0; row < 8; row++) {
            System.arraycopy(rows.byPoint, 3 * row, byPoint, 0, 3);
            for (int i = 0; i < 3; i++) {
                arm[i] = rows.cornersMm[3 * (row / 2) + i] - centreMm[i];
                jacobian[row * columns + i] = byPoint[i];
            }
            setCross(arm, byPoint, jacobian, row * columns + 3, 1);
        }
        for (int row = 0; row < m; row++) {
            System.arraycopy(rows.shared, row * after, jacobian, row * columns + POSE, after);
        }
        double[] joint = gram(rows.covariance, m, jacobian, columns);
        double[] ofPose = new double[POSE * POSE];
        for (int i = 0; i < POSE; i++) {
            System.arraycopy(joint, i * columns, ofPose, i * POSE, POSE);
        }
        double[] covariance = Cholesky.inverse(ofPose, POSE);
        return covariance == null ? null : new SeenObject(joint, covariance, cameraFromObject);
    }

    /** An object's marker in the photo, its pose in the camera frame eliminated; immutable. */
    public final class SeenObject {
        private final double[] information;
        /** Change of the estimated pose in the camera frame by errors of the unknowns after the camera's pose. */
        private final double[] byShared;
        private final double[] covariance;
        private final RigidTransform cameraFromObject;

        SeenObject(double[] joint, double[] covariance, RigidTransform cameraFromObject) {
            this.covariance = covariance;
            this.cameraFromObject = cameraFromObject;
            int n = unknowns;
            int after = n - POSE;
            byShared = new double[POSE * after];
            for (int i = 0; i < POSE; i++) {
                for (int c = 0; c < after; c++) {
                    for (int k = 0; k < POSE; k++) {
                        byShared[i * after + c] -= covariance[i * POSE + k] * joint[k * n + POSE + c];
                    }
                }
            }
            information = new double[n * n];
            for (int a = 0; a < after; a++) {
                for (int b = 0; b < after; b++) {
                    double s = joint[(POSE + a) * n + POSE + b];
                    for (int k = 0; k < POSE; k++) {
                        s += joint[k * n + POSE + a] * byShared[k * after + b];
                    }
                    information[(POSE + a) * n + POSE + b] = s;
                }
            }
        }

        /**
         * What its corners tell of the shared unknowns: how far they are from a square.
         *
         * @return n x n, nothing about the camera's pose
         */
        public double[] information() {
            return information.clone();
        }

        /**
         * The orientation of the object.
         *
         * @return how its turn about world axes hangs together with the shared unknowns, in rad
         */
        public PointRows turn() {
            int n = unknowns;
            double[] rows = new double[3 * n];
            double[] byPose = new double[3 * POSE];
            for (int i = 0; i < 3; i++) {
                rows[i * n + 3 + i] = 1;
                for (int j = 0; j < 3; j++) {
                    byPose[i * POSE + 3 + j] = rotation[3 * i + j];
                }
            }
            return joined(rows, byPose);
        }

        /**
         * A point of the object.
         *
         * @param pointMm its place in the frame of the object's marker, mm
         * @return how its place in the world hangs together with the shared unknowns
         */
        public PointRows point(double[] pointMm) {
            double[] inCamera = cameraFromObject.apply(pointMm);
            double[] arm = new double[3];
            double[] fromCamera = new double[3];
            double[] centre = cameraFromObject.translationMm();
            for (int i = 0; i < 3; i++) {
                arm[i] = inCamera[i] - centre[i];
                for (int j = 0; j < 3; j++) {
                    fromCamera[i] += rotation[3 * i + j] * inCamera[j];
                }
            }
            int n = unknowns;
            double[] rows = new double[3 * n];
            double[] byPose = new double[3 * POSE];
            double[] axis = new double[3];
            for (int i = 0; i < 3; i++) {
                rows[i * n + i] = 1;
                // the turn of the camera by w moves the point by w x (point - camera)
                double[] unit = new double[3];
                unit[i] = 1;
                setCross(fromCamera, unit, rows, i * n + 3, 1);
                for (int j = 0; j < 3; j++) {
                    axis[j] = rotation[3 * i + j];
                    byPose[i * POSE + j] = axis[j];
                }
                setCross(arm, axis, byPose, i * POSE + 3, 1);
            }
            return joined(rows, byPose);
        }

        /** Rows that have the camera's pose, completed by what changes with the object's pose in the camera frame. */
        private PointRows joined(double[] rows, double[] byPose) {
            int n = unknowns;
            int after = n - POSE;
            double[] own = new double[9];
            for (int i = 0; i < 3; i++) {
                for (int c = 0; c < after; c++) {
                    for (int k = 0; k < POSE; k++) {
                        rows[i * n + POSE + c] += byPose[i * POSE + k] * byShared[k * after + c];
                    }
                }
                for (int j = 0; j < 3; j++) {
                    for (int a = 0; a < POSE; a++) {
                        for (int b = 0; b < POSE; b++) {
                            own[3 * i + j] += byPose[i * POSE + a] * covariance[a * POSE + b] * byPose[j * POSE + b];
                        }
                    }
                }
            }
            return new PointRows(rows, own);
        }
    }

    /**
     * A point in the world, or a turn about its axes, as far as it depends on what is shared: its error is
     * {@code rows · (error of the unknowns)} plus an error of its own.
     */
    public static final class PointRows {
        private final double[] rows;
        private final double[] ownMm2;

        PointRows(double[] rows, double[] ownMm2) {
            this.rows = rows;
            this.ownMm2 = ownMm2;
        }

        /**
         * Its change by the unknowns.
         *
         * @return 3 x n, mm per unit of the unknowns; not to be changed
         */
        public double[] rows() {
            return rows;
        }

        /**
         * Covariance of its own error: what its own corners leave.
         *
         * @return 3 x 3, mm²; not to be changed
         */
        public double[] ownMm2() {
            return ownMm2;
        }
    }
}
