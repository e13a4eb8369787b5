package org.cellgauge.internal.laplace;

import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.cellgauge.estimate.PointEstimate;
import org.cellgauge.estimate.PoseEstimate;
import org.cellgauge.estimate.VarianceBudget;
import org.cellgauge.estimate.VarianceSource;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.estimate.Matrices;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.geometry.Rotations;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.internal.pose.Observations;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.internal.pose.ReferenceNoise;
import org.cellgauge.internal.pose.StateLayout;
import org.cellgauge.settings.ObjectNoise;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.ejml.interfaces.decomposition.EigenDecomposition_F64;
import org.jspecify.annotations.Nullable;

/**
 * The model linearised at its modes: Laplace covariances carried to the world, and where the variance of each object
 * comes from (propagation of uncertainty, GUM, JCGM 100:2008, section 5.1).
 *
 * <p>With the references at {@code x_c = R (x_w - g) + p} a step (dp, dw) of the camera's chart and a step (dt, de) of
 * the object's move a point of the object, at v from the centroid in camera axes, by
 * {@code dx_w = R^T (dt + de x a - dp + v x dw)}, a being its arm from the marker's centre in camera axes.
 *
 * <p>Not thread-safe: it holds work space. Budgets that are asked for later are worked out one at a time.
 */
public final class LinearModel {
    private static final double NEXT_TO_NOTHING = 1e-9;
    /** Unknown intrinsics, those that are estimated and those that a calibration leaves open. */
    private static final List<VarianceSource> OF_INTRINSICS = List.of(VarianceSource.INTRINSICS,
            VarianceSource.CALIBRATION);
    private static final List<VarianceSource> SHARED_BY_MARKERS = Collections.unmodifiableList(
            Arrays.asList(VarianceSource.EDGES, VarianceSource.SIZE_OF_PRINTS, VarianceSource.COMMON_PLACEMENT));

    private final CameraFit camera;
    private final PoseMode mode;
    private final CameraState state;
    private final double[] worldFromCamera = new double[9];
    private final int columns;
    private final double[] covariance;
    private final ObjectFit.AnswerSpace answers;
    /** Work space: rows by the camera and by an object of a pose, the same of a point, and what comes of them. */
    private final double[][] poseByCamera;
    private final double[][] poseByObject = new double[StateLayout.POSE][StateLayout.POSE];
    private final double[][] pointByCamera;
    private final double[][] pointByObject = new double[3][StateLayout.POSE];
    private final double[][] tangent = new double[StateLayout.POSE][StateLayout.POSE];
    private final double[] row;
    private final PoseSpace poseSpace = new PoseSpace();
    /** What all budgets need of the references; filled when one is asked for. */
    private @Nullable OfReferences ofReferences;

    /**
     * The model about the heaviest mode.
     *
     * @param camera the camera at its modes
     */
    public LinearModel(CameraFit camera) {
        this.camera = camera;
        mode = camera.modes.get(0);
        state = mode.state();
        columns = mode.dimension();
        covariance = mode.covariance();
        answers = new ObjectFit.AnswerSpace(camera.errors, camera.intrinsicsPrior);
        poseByCamera = new double[StateLayout.POSE][columns];
        pointByCamera = new double[3][columns];
        row = new double[columns];
        Rotations.transpose(state.rotation, worldFromCamera);
    }

    /** Camera pose at the mode with its Laplace covariance. */
    public PoseEstimate cameraPose() {
        return cameraPose(camera.view, mode, 0);
    }

    /**
     * Camera pose of a view at a mode of any number of views, with its Laplace covariance.
     *
     * @param seen what the mode was fitted to
     * @param mode the mode
     * @param view 0 to views - 1
     * @return pose in the world
     */
    public static PoseEstimate cameraPose(Observations seen, PoseMode mode, int view) {
        RigidTransform cameraFromSet = mode.state().cameraFromSet(view);
        double[] worldFromCamera = new double[9];
        Rotations.transpose(cameraFromSet.rotation(), worldFromCamera);
        double[] p = cameraFromSet.translationMm();
        int columns = mode.dimension();
        int dp = mode.layout().pose(view);
        int dw = dp + 3;
        double[][] a = new double[StateLayout.POSE][columns];
        for (int i = 0; i < 3; i++) {
            double rx = worldFromCamera[3 * i];
            double ry = worldFromCamera[3 * i + 1];
            double rz = worldFromCamera[3 * i + 2];
            a[i][dp] = -rx;
            a[i][dp + 1] = -ry;
            a[i][dp + 2] = -rz;
            // minus R^T (p x dw)
            a[i][dw] = -(ry * p[2] - rz * p[1]);
            a[i][dw + 1] = -(rz * p[0] - rx * p[2]);
            a[i][dw + 2] = -(rx * p[1] - ry * p[0]);
            a[3 + i][dw] = -rx;
            a[3 + i][dw + 1] = -ry;
            a[3 + i][dw + 2] = -rz;
        }
        double[][] tangent = new double[StateLayout.POSE][StateLayout.POSE];
        Matrices.addSandwich(a, mode.covariance(), columns, tangent);
        return pose("camera in world", seen.worldFromCamera(cameraFromSet), tangent);
    }

    /** A pose of its transform and tangent covariance. */
    public static PoseEstimate pose(String frame, RigidTransform pose, double[][] tangent) {
        return new PoseSpace().pose(frame, pose, tangent);
    }

    /** Work space in which poses are made one after another. */
    private static final class PoseSpace {
        private final double[][] covariance = new double[6][6];
        private final double[] flat = new double[36];
        private final double[][] byTangent = new double[6][6];
        private final double[] row = new double[6];

        PoseEstimate pose(String frame, RigidTransform pose, double[][] tangent) {
            double[] euler = pose.eulerRad();
            double[] t = pose.translationMm();
            for (int i = 0; i < 6; i++) {
                System.arraycopy(tangent[i], 0, flat, 6 * i, 6);
            }
            Matrices.clear(covariance);
            eulerFromTangent(euler, byTangent);
            Matrices.addSandwich(byTangent, flat, 6, covariance, row);
            return new PoseEstimate(frame, new double[] {t[0], t[1], t[2], euler[0], euler[1], euler[2]}, covariance,
                    tangent, pose);
        }
    }

    /**
     * Derivative of (position, psi, theta, phi) by (position, rotation vector in world axes); infinite at gimbal lock.
     */
    private static void eulerFromTangent(double[] euler, double[][] j) {
        double st = Math.sin(euler[1]);
        double ct = Math.cos(euler[1]);
        double sf = Math.sin(euler[2]);
        double cf = Math.cos(euler[2]);
        // the other entries are 0, always
        for (int i = 0; i < 3; i++) {
            j[i][i] = 1;
        }
        // inverse of the rates w = phi' ez + theta' Rz ey + psi' Rz Ry ex
        j[3][3] = cf / ct;
        j[3][4] = sf / ct;
        j[4][3] = -sf;
        j[4][4] = cf;
        j[5][3] = cf * st / ct;
        j[5][4] = sf * st / ct;
        j[5][5] = 1;
    }

    /** Covariance of the unknown intrinsics. */
    public double[][] intrinsicsCovariance() {
        int n = mode.layout().intrinsicsCount();
        int first = mode.layout().intrinsics();
        double[][] out = new double[n][n];
        double[] c = covariance;
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                out[i][j] = c[(first + i) * columns + first + j];
            }
        }
        return out;
    }

    /** The first unknown intrinsic that the budget gives to a source. */
    private int firstOf(VarianceSource source) {
        return source.equals(VarianceSource.CALIBRATION) ? camera.intrinsicsPrior.estimatedCount() : 0;
    }

    /** The end of these. */
    private int endOf(VarianceSource source) {
        return source.equals(VarianceSource.CALIBRATION) ? camera.intrinsicsPrior.count()
                : camera.intrinsicsPrior.estimatedCount();
    }

    /** What the budget calls one of the unknowns that markers of a photo share. */
    private static VarianceSource sourceOf(CornerErrors errors, int unknown) {
        return errors.isPlacement(unknown) ? VarianceSource.COMMON_PLACEMENT
                : errors.isSizeOfPrints(unknown) ? VarianceSource.SIZE_OF_PRINTS : VarianceSource.EDGES;
    }

    /** How one object answers to the camera's chart and to its own. */
    public final class ObjectLink {
        private final ObjectFit target;
        private final PoseMode objectMode;
        private final CameraState object;
        /** 6 rows of what the unknowns do that the object shares with the camera. */
        private final double[] byShared;
        private final double[] ownCovariance;
        private final boolean noisy;

        public ObjectLink(ObjectFit target, int modeIndex) {
            this.target = target;
            objectMode = target.modes.get(modeIndex);
            object = objectMode.state();
            noisy = camera.settings.model().objectNoise() == ObjectNoise.DETECTION;
            ownCovariance = objectMode.covariance();
            byShared = target.answers(modeIndex, answers);
        }

        public RigidTransform pose() {
            return camera.view.worldFromCamera(state.cameraFromSet()).compose(object.cameraFromSet());
        }

        /** Rows x, y, z of a point of the object (and of its rotation vector) by the camera's chart and intrinsics. */
        private double[][] byCamera(double[] arm, boolean withRotation) {
            double[][] byObject = byObject(arm, withRotation);
            double[][] a = withRotation ? poseByCamera : pointByCamera;
            Matrices.clear(a);
            double vx = object.offset[0] + arm[0] - state.offset[0];
            double vy = object.offset[1] + arm[1] - state.offset[1];
            double vz = object.offset[2] + arm[2] - state.offset[2];
            for (int i = 0; i < 3; i++) {
                double rx = worldFromCamera[3 * i];
                double ry = worldFromCamera[3 * i + 1];
                double rz = worldFromCamera[3 * i + 2];
                a[i][0] = -rx;
                a[i][1] = -ry;
                a[i][2] = -rz;
                // R^T (v x dw)
                a[i][3] = ry * vz - rz * vy;
                a[i][4] = rz * vx - rx * vz;
                a[i][5] = rx * vy - ry * vx;
                if (withRotation) {
                    a[3 + i][3] = -rx;
                    a[3 + i][4] = -ry;
                    a[3 + i][5] = -rz;
                }
            }
            int poses = mode.layout().poses();
            for (int f = poses; f < columns; f++) {
                for (int i = 0; i < a.length; i++) {
                    for (int k = 0; k < 6; k++) {
                        a[i][f] += byObject[i][k] * byShared[k * (columns - poses) + f - poses];
                    }
                }
            }
            return a;
        }

        private double[][] byObject(double[] arm, boolean withRotation) {
            // what is not set here is 0, always
            double[][] b = withRotation ? poseByObject : pointByObject;
            for (int i = 0; i < 3; i++) {
                double rx = worldFromCamera[3 * i];
                double ry = worldFromCamera[3 * i + 1];
                double rz = worldFromCamera[3 * i + 2];
                b[i][0] = rx;
                b[i][1] = ry;
                b[i][2] = rz;
                // R^T (de x arm)
                b[i][3] = rz * arm[1] - ry * arm[2];
                b[i][4] = rx * arm[2] - rz * arm[0];
                b[i][5] = ry * arm[0] - rx * arm[1];
                if (withRotation) {
                    b[3 + i][3] = rx;
                    b[3 + i][4] = ry;
                    b[3 + i][5] = rz;
                }
            }
            return b;
        }

        private double[] arm(double[] pointMm) {
            double[] r = object.rotation;
            return new double[] {
                r[0] * pointMm[0] + r[1] * pointMm[1] + r[2] * pointMm[2],
                r[3] * pointMm[0] + r[4] * pointMm[1] + r[5] * pointMm[2],
                r[6] * pointMm[0] + r[7] * pointMm[1] + r[8] * pointMm[2]};
        }

        /** Pose in the world with its Laplace covariance. */
        public PoseEstimate poseEstimate() {
            double[] arm = new double[3];
            Matrices.clear(tangent);
            Matrices.addSandwich(byCamera(arm, true), covariance, columns, tangent, row);
            if (noisy) {
                Matrices.addSandwich(byObject(arm, true), ownCovariance, 6, tangent, row);
            }
            return poseSpace.pose("object in world", pose(), tangent);
        }

        /** Gripping point in the world with its Laplace covariance; null where there is none. */
        public @Nullable PointEstimate grip() {
            double[] grip = target.marker.gripMm();
            if (grip == null) {
                return null;
            }
            double[] arm = arm(grip);
            double[][] ofPoint = new double[3][3];
            Matrices.addSandwich(byCamera(arm, false), covariance, columns, ofPoint, row);
            if (noisy) {
                Matrices.addSandwich(byObject(arm, false), ownCovariance, 6, ofPoint, row);
            }
            return new PointEstimate(pose().apply(grip), ofPoint);
        }

        /** The same, worked out when it is asked for, on whatever thread: most of a moving camera's never are. */
        public VarianceBudget budgetWhenAsked(double[] pointMm) {
            double[] point = pointMm.clone();
            return VarianceBudget.whenAsked(() -> {
                synchronized (LinearModel.this) {
                    return budget(point, camera.noise(camera.view, camera.noiseLevel));
                }
            });
        }

        /**
         * Variance along each world axis of a point of the object, by source.
         *
         * @param pointMm in the marker's frame; zeros for its centre
         */
        public VarianceBudget budget(double[] pointMm, ReferenceNoise noise) {
            double[] arm = arm(pointMm);
            double[][] a = byCamera(arm, false);
            Map<VarianceSource, double[]> variances = new LinkedHashMap<>();
            Map<VarianceSource, double[]> left = new LinkedHashMap<>();
            CornerErrors errors = target.errors;
            if (ofReferences == null) {
                ofReferences = new OfReferences(noise.about(mode.placed()), errors);
            }
            OfReferences references = ofReferences;
            references.placement.forEach((source, part) -> variances.put(source, diagonal(a, part, columns)));
            double[] cornerNoise = diagonal(a, references.cornerNoise, columns);
            double[] bent = diagonal(a, references.bent, columns);
            double[] own = ownVariance(arm, null);
            double[] ofObject = own.clone();
            if (errors.hasFlatness()) {
                subtract(cornerNoise, bent);
                if (noisy) {
                    double[] ownBent = diagonal(timesGain(byObject(arm, false), objectMode.gain(0)),
                            errors.flatness(target.marker.id()), 8);
                    subtract(ofObject, ownBent);
                    add(bent, ownBent);
                }
            }
            variances.put(VarianceSource.CORNER_NOISE_OF_REFERENCES, cornerNoise);
            variances.put(VarianceSource.CORNER_NOISE_OF_OBJECT, ofObject);
            if (errors.hasFlatness()) {
                variances.put(VarianceSource.FLATNESS_OF_PRINTS, bent);
            }
            references.refitted.forEach((source, part) -> {
                double[] variance = diagonal(a, part, columns);
                add(variance, source.equals(VarianceSource.FLATNESS_OF_PRINTS)
                        ? ownVariance(arm, VarianceSource.FLATNESS_OF_PRINTS) : own);
                left.put(source, variance);
            });
            double[] exactCorners = diagonal(a, covariance, columns);
            add(exactCorners, ownVariance(arm, VarianceSource.CORNER_NOISE_OF_OBJECT));
            left.put(VarianceSource.CORNER_NOISE_OF_OBJECT, exactCorners);
            StateLayout layout = mode.layout();
            int shared = layout.shared();
            for (VarianceSource source : OF_INTRINSICS) {
                int from = firstOf(source);
                int to = endOf(source);
                if (to <= from) {
                    continue;
                }
                double[] prior = new double[columns * columns];
                int first = layout.intrinsics();
                for (int f = from; f < to; f++) {
                    for (int g = from; g < to; g++) {
                        prior[(first + f) * columns + first + g] = camera.intrinsicsPrior.information(f, g);
                    }
                }
                variances.put(source, priorPart(a, prior));
            }
            for (VarianceSource source : SHARED_BY_MARKERS) {
                double[] prior = new double[columns * columns];
                boolean any = false;
                for (int f = shared; f < columns; f++) {
                    if (sourceOf(errors, f - shared).equals(source)) {
                        prior[f * columns + f] = 1;
                        any = true;
                    }
                }
                if (any) {
                    variances.put(source, priorPart(a, prior));
                }
            }
            if (camera.posePrior != null) {
                double[] prior = new double[columns * columns];
                for (int i = 0; i < 6; i++) {
                    double std = i < 3 ? camera.posePrior.stdMm() : camera.posePrior.stdRad();
                    prior[i * columns + i] = 1 / (std * std);
                }
                variances.put(VarianceSource.POSE_PRIOR, priorPart(a, prior));
            }
            return new VarianceBudget(variances, left);
        }

        /**
         * What the object's own corners contribute if one of the sources of their errors is zero.
         *
         * @param without corner noise, flatness, or null for neither
         */
        private double[] ownVariance(double[] arm, @Nullable VarianceSource without) {
            if (!noisy || (VarianceSource.CORNER_NOISE_OF_OBJECT.equals(without) && !target.errors.hasFlatness())) {
                return new double[3];
            }
            double @Nullable [] ofMode = ownCovariance;
            if (without != null) {
                double[] bent = target.errors.flatness(target.marker.id());
                double[] noise = new double[64];
                target.errors.covariance(target.marker.id(), state.noise, noise);
                for (int i = 0; i < 64; i++) {
                    noise[i] -= bent[i];
                }
                double[] information = informationOf(objectMode);
                Exchange exchange = new Exchange(objectMode);
                boolean stays = without.equals(VarianceSource.FLATNESS_OF_PRINTS);
                exchange.change(information, 0, stays ? noise : bent, stays ? bent : noise);
                ofMode = Cholesky.inverse(information, 6);
            }
            return ofMode == null ? new double[] {Double.NaN, Double.NaN, Double.NaN}
                    : diagonal(byObject(arm, false), ofMode, 6);
        }

        /** What a Gaussian prior of the given information contributes: a C I C a^T. */
        private double[] priorPart(double[][] a, double[] information) {
            return diagonal(times(a, covariance, columns), information, columns);
        }
    }

    /**
     * What the errors of references do to the camera's unknowns, source by source: the same whatever object is looked
     * at, so that a budget is a few products for each of them.
     */
    private final class OfReferences {
        /** Covariance of the unknowns that comes from where one reference stands. */
        final Map<VarianceSource, double[]> placement = new LinkedHashMap<>();
        /** From noise in the corners of all, and from their prints that are not flat. */
        final double[] cornerNoise = new double[columns * columns];
        final double[] bent = new double[columns * columns];
        /** Covariance that a fit has which knows a source to be zero. */
        final Map<VarianceSource, double[]> refitted;

        OfReferences(ReferenceNoise atMode, CornerErrors errors) {
            double[] ofPlacement = new double[64];
            double[] ofPixels = new double[64];
            for (int m = 0; m < camera.view.size(); m++) {
                int id = camera.view.references().get(m).id();
                double[] gain = mode.gain(m);
                atMode.covariance(state, m, ofPlacement, ofPixels);
                double[] own = new double[columns * columns];
                addCarried(gain, ofPlacement, own);
                placement.put(VarianceSource.placementOf(id), own);
                addCarried(gain, ofPixels, cornerNoise);
                if (errors.hasFlatness()) {
                    addCarried(gain, errors.flatness(id), bent);
                }
            }
            refitted = refitted(atMode, errors);
        }

        /** A covariance of eight residuals carried to the unknowns and added: gain, covariance, gain^T. */
        private void addCarried(double[] gain, double[] covariance, double[] sum) {
            double[] carried = new double[8];
            for (int a = 0; a < columns; a++) {
                for (int j = 0; j < 8; j++) {
                    double s = 0;
                    for (int i = 0; i < 8; i++) {
                        s += gain[8 * a + i] * covariance[8 * i + j];
                    }
                    carried[j] = s;
                }
                for (int b = 0; b <= a; b++) {
                    double s = 0;
                    for (int j = 0; j < 8; j++) {
                        s += carried[j] * gain[8 * b + j];
                    }
                    sum[a * columns + b] += s;
                    sum[b * columns + a] = sum[a * columns + b];
                }
            }
        }
    }

    private static double[] informationOf(PoseMode mode) {
        return Objects.requireNonNull(Cholesky.inverse(mode.covariance(), mode.dimension()),
                "a mode's covariance is the inverse of its information");
    }

    /**
     * The linear model fitted again with one source's variance set to zero, all of the camera's in turn but for a prior
     * of its pose.
     */
    private Map<VarianceSource, double[]> refitted(ReferenceNoise atMode, CornerErrors errors) {
        Map<VarianceSource, double[]> out = new LinkedHashMap<>();
        double[] information = informationOf(mode);
        Exchange exchange = new Exchange(mode);
        int n = camera.view.size();
        double[] placement = new double[64];
        double[] pixel = new double[64];
        double[] others = new double[64];
        double[] exactCorners = information.clone();
        double[] flat = information.clone();
        double[] exact = information.clone();
        double[] none = new double[64];
        for (int m = 0; m < n; m++) {
            int id = camera.view.references().get(m).id();
            double[] bent = errors.hasFlatness() ? errors.flatness(id) : none;
            atMode.covariance(state, m, placement, pixel);
            System.arraycopy(information, 0, exact, 0, exact.length);
            exchange.change(exact, m, pixel, placement);
            put(out, VarianceSource.placementOf(id), exact);
            for (int i = 0; i < 64; i++) {
                pixel[i] -= bent[i];
                others[i] = placement[i] + bent[i];
            }
            exchange.change(exactCorners, m, others, pixel);
            for (int i = 0; i < 64; i++) {
                others[i] = placement[i] + pixel[i];
            }
            if (errors.hasFlatness()) {
                exchange.change(flat, m, others, bent);
            }
        }
        put(out, VarianceSource.CORNER_NOISE_OF_REFERENCES, exactCorners);
        if (errors.hasFlatness()) {
            put(out, VarianceSource.FLATNESS_OF_PRINTS, flat);
        }
        int shared = mode.layout().shared();
        boolean[] known = new boolean[columns];
        int intrinsics = mode.layout().intrinsics();
        for (VarianceSource source : OF_INTRINSICS) {
            Arrays.fill(known, false);
            Arrays.fill(known, intrinsics + firstOf(source), intrinsics + endOf(source), true);
            putKnown(out, source, information, known);
        }
        for (VarianceSource source : SHARED_BY_MARKERS) {
            for (int f = 0; f < columns; f++) {
                known[f] = f >= shared && sourceOf(errors, f - shared).equals(source);
            }
            putKnown(out, source, information, known);
        }
        return out;
    }

    /** Known unknowns: their part of an information stays out, and so does their covariance. */
    private void putKnown(Map<VarianceSource, double[]> out, VarianceSource source, double[] information,
            boolean[] known) {
        int[] left = java.util.stream.IntStream.range(0, columns).filter(f -> !known[f]).toArray();
        int n = left.length;
        if (n == columns) {
            return;
        }
        double[] part = new double[n * n];
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                part[i * n + j] = information[left[i] * columns + left[j]];
            }
        }
        double[] covariance = Cholesky.inverse(part, n);
        if (covariance == null) {
            return;
        }
        double[] full = new double[columns * columns];
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                full[left[i] * columns + left[j]] = covariance[i * n + j];
            }
        }
        out.put(source, full);
    }

    /** Destroys the information. */
    private void put(Map<VarianceSource, double[]> out, VarianceSource source, double[] information) {
        double[] inverse = new double[information.length];
        if (Cholesky.inverse(information, columns, new double[information.length], inverse)) {
            out.put(source, inverse);
        }
    }

    /**
     * Exchanges what one marker contributes to an information for what it contributes with other residuals: a part
     * of their covariance that stays and one that goes, all but a billionth of it, which keeps the rest definite.
     */
    private static final class Exchange {
        private final PoseMode mode;
        private final int columns;
        private final double[] whitened;
        private final double[] plain;
        private final double[] factor = new double[64];
        private final double[] column = new double[8];

        Exchange(PoseMode mode) {
            this.mode = mode;
            columns = mode.dimension();
            whitened = new double[8 * columns];
            plain = new double[8 * columns];
        }

        void change(double[] information, int marker, double[] stays, double[] goes) {
            mode.copyJacobian(marker, whitened);
            System.arraycopy(whitened, 0, plain, 0, plain.length);
            for (int i = 0; i < 64; i++) {
                factor[i] = stays[i] + NEXT_TO_NOTHING * goes[i];
            }
            if (!Cholesky.factor(factor, 8)) {
                return;
            }
            for (int c = 0; c < columns; c++) {
                // undo the whitening row by row, then whiten by the other covariance
                for (int i = 0; i < 8; i++) {
                    double s = whitened[i * columns + c];
                    for (int k = 0; k < i; k++) {
                        s -= mode.whitening(marker, i, k) * plain[k * columns + c];
                    }
                    plain[i * columns + c] = s / mode.whitening(marker, i, i);
                    column[i] = plain[i * columns + c];
                }
                Cholesky.solveLower(factor, 8, column);
                for (int i = 0; i < 8; i++) {
                    plain[i * columns + c] = column[i];
                }
                // columns before this one are whitened already, so both products are complete up to here
                for (int d = 0; d <= c; d++) {
                    double change = 0;
                    for (int i = 0; i < 8; i++) {
                        change += plain[i * columns + c] * plain[i * columns + d]
                                - whitened[i * columns + c] * whitened[i * columns + d];
                    }
                    information[c * columns + d] += change;
                    if (d < c) {
                        information[d * columns + c] += change;
                    }
                }
            }
        }
    }

    private double[][] times(double[][] a, double[] b, int width) {
        double[][] out = new double[a.length][width];
        for (int i = 0; i < a.length; i++) {
            for (int k = 0; k < columns; k++) {
                for (int j = 0; j < width; j++) {
                    out[i][j] += a[i][k] * b[k * width + j];
                }
            }
        }
        return out;
    }

    /** The first three of the diagonal of a b a^T. */
    private static double[] diagonal(double[][] a, double[] b, int n) {
        double[] out = new double[3];
        for (int i = 0; i < out.length; i++) {
            double[] row = a[i];
            for (int l = 0; l < n; l++) {
                double s = 0;
                for (int k = 0; k < n; k++) {
                    s += row[k] * b[k * n + l];
                }
                out[i] += s * row[l];
            }
        }
        return out;
    }

    private static double[][] timesGain(double[][] a, double[] gain) {
        double[][] out = new double[a.length][8];
        for (int i = 0; i < a.length; i++) {
            for (int k = 0; k < 6; k++) {
                for (int j = 0; j < 8; j++) {
                    out[i][j] += a[i][k] * gain[8 * k + j];
                }
            }
        }
        return out;
    }

    private static void subtract(double[] from, double[] part) {
        for (int i = 0; i < from.length; i++) {
            // shares are not negative: what is left of a difference is rounding
            from[i] = Math.max(0, from[i] - part[i]);
        }
    }

    private static void add(double[] sum, double[] more) {
        for (int i = 0; i < sum.length; i++) {
            sum[i] += more[i];
        }
    }

    /** Largest share of the pose prior in the information of any direction: what the data leave open. */
    public static double priorShare(PoseMode mode, double stdMm, double stdRad) {
        double[] covariance = mode.covariance();
        int n = mode.dimension();
        double[][] scaled = new double[6][6];
        for (int i = 0; i < 6; i++) {
            for (int j = 0; j < 6; j++) {
                scaled[i][j] = covariance[i * n + j] / (i < 3 ? stdMm : stdRad) / (j < 3 ? stdMm : stdRad);
            }
        }
        EigenDecomposition_F64<DMatrixRMaj> eigen = DecompositionFactory_DDRM.eig(6, false, true);
        if (!eigen.decompose(new DMatrixRMaj(scaled))) {
            return Double.NaN;
        }
        double largest = 0;
        for (int i = 0; i < 6; i++) {
            largest = Math.max(largest, eigen.getEigenvalue(i).getReal());
        }
        return largest;
    }
}
