package org.cellgauge.internal.validation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.check.CheckResult;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.Rotations;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.posterior.CameraPosterior;
import org.cellgauge.internal.statistics.CoverageRegion;
import org.cellgauge.internal.statistics.RankHistogram;
import org.cellgauge.sampling.Draws;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.sampling.Quantity.Axis;
import org.jspecify.annotations.Nullable;

/**
 * The camera or one object of a cell: which regions and quantities of it are judged, and how the truth lies among the
 * draws of one check. Immutable.
 */
final class CellPart {
    private static final List<Axis> TANGENT = Collections.unmodifiableList(
            Arrays.asList(Axis.X, Axis.Y, Axis.Z, Axis.WX, Axis.WY, Axis.WZ));
    private static final List<Quantity> FOCAL = Collections.unmodifiableList(
            Arrays.asList(Quantity.intrinsic("fx_px"), Quantity.intrinsic("fy_px")));
    /** Draws looked at; chains that ran longer are thinned evenly to about as many. */
    private static final int MOST_DRAWS = 8000;

    final String name;
    final @Nullable ObjectMarker object;
    final List<String> regionNames = new ArrayList<>();
    final List<Integer> regionDimensions = new ArrayList<>();
    final List<Quantity> coordinates;
    final List<String> derived = new ArrayList<>();

    private CellPart(@Nullable ObjectMarker object, boolean focal) {
        this.object = object;
        name = object == null ? "camera" : "object " + object.id();
        coordinates = coordinatesOf(object);
        if (object != null) {
            region(name + " position", 3);
        }
        region(name + " pose", 6);
        derived.add(object == null ? "log_density" : "distance_mm");
        derived.add("norm");
        if (object == null && focal) {
            region(name + " focal lengths", 2);
            coordinates.addAll(FOCAL);
            derived.add("focal_norm");
        }
        if (object != null && object.hasGrip()) {
            region(name + " grip", 3);
            derived.add("grip_norm");
        }
    }

    /** Position, rotation vector and, where it has one, gripping point of an object; of the camera where it is null. */
    static List<Quantity> coordinatesOf(@Nullable ObjectMarker object) {
        List<Quantity> all = new ArrayList<>();
        TANGENT.forEach(axis -> all.add(of(object, axis)));
        if (object != null && object.hasGrip()) {
            TANGENT.subList(0, 3).forEach(axis -> all.add(Quantity.grip(object.id(), axis)));
        }
        return all;
    }

    private static Quantity of(@Nullable ObjectMarker object, Axis axis) {
        return object == null ? Quantity.camera(axis) : Quantity.object(object.id(), axis);
    }

    private void region(String regionName, int dimension) {
        regionNames.add(regionName);
        regionDimensions.add(dimension);
    }

    static List<CellPart> of(Cell cell, boolean focal) {
        List<CellPart> parts = new ArrayList<>();
        parts.add(new CellPart(null, focal));
        cell.objects().forEach(o -> parts.add(new CellPart(o, focal)));
        return parts;
    }

    /** How the truth lies among the draws of one check. */
    static final class Standing {
        /**
         * By region: share of the draws with a smaller Mahalanobis distance from the mean than the truth; where there
         * are several modes, share of the draws of higher density.
         */
        final double[] drawShare;
        /** By region: the truth's squared Mahalanobis distance. */
        final double[] squaredDistance;
        /** By coordinate: (truth - mean) / stated standard deviation. */
        final double[] standardisedError;
        /** By coordinate, then by derived quantity. */
        final int[] ranks;
        /** Effective share of the draws after weighting with the prior of the truth. */
        double weightShare;

        private Standing(int regions, int coordinates, int derived) {
            drawShare = new double[regions];
            squaredDistance = new double[regions];
            standardisedError = new double[coordinates];
            ranks = new int[coordinates + derived];
        }
    }

    /** Draws of one quantity, chain by chain. */
    static double[] column(CheckResult result, Quantity quantity) {
        int q = result.layout().indexOf(quantity);
        int total = 0;
        for (Draws chain : result.draws()) {
            total += chain.count();
        }
        int stride = Math.max(1, total / MOST_DRAWS);
        double[] values = new double[total];
        int at = 0;
        for (Draws chain : result.draws()) {
            for (int i = 0; i < chain.count(); i += stride) {
                values[at++] = chain.get(q, i);
            }
        }
        return Arrays.copyOf(values, at);
    }

    /** Rotation matrices of all draws of a pose, 9 values each. */
    static double[] rotations(CheckResult result, @Nullable ObjectMarker object) {
        double[] psi = column(result, of(object, Axis.PSI));
        double[] theta = column(result, of(object, Axis.THETA));
        double[] phi = column(result, of(object, Axis.PHI));
        double[] all = new double[9 * psi.length];
        double[] r = new double[9];
        for (int i = 0; i < psi.length; i++) {
            Rotations.fromEuler(psi[i], theta[i], phi[i], r);
            System.arraycopy(r, 0, all, 9 * i, 9);
        }
        return all;
    }

    private static RigidTransform pose(double[] rotations, double[][] columns, int i) {
        return RigidTransform.of(Arrays.copyOfRange(rotations, 9 * i, 9 * i + 9),
                new double[] {columns[0][i], columns[1][i], columns[2][i]});
    }

    private double[][] columns(CheckResult result) {
        double[][] columns = new double[coordinates.size()][];
        for (int c = 0; c < columns.length; c++) {
            columns[c] = column(result, coordinates.get(c));
        }
        return columns;
    }

    /** What the draws of the camera say, shared by all parts. */
    static final class CameraDraws {
        final double[] rotations;
        final double[][] columns;
        final RigidTransform[] cameraFromWorld;
        final double[] logWeights;
        final PinholeCamera[] lenses;

        CameraDraws(CheckResult result, TruthPrior prior) {
            rotations = rotations(result, null);
            columns = new double[][] {column(result, Quantity.camera(Axis.X)), column(result, Quantity.camera(Axis.Y)),
                column(result, Quantity.camera(Axis.Z))};
            int n = columns[0].length;
            logWeights = new double[n];
            cameraFromWorld = new RigidTransform[n];
            lenses = lenses(result, n);
            CameraState state = new CameraState();
            for (int i = 0; i < n; i++) {
                RigidTransform pose = pose(rotations, columns, i);
                cameraFromWorld[i] = pose.inverse();
                if (!prior.isPoint()) {
                    System.arraycopy(cameraFromWorld[i].rotation(), 0, state.rotation, 0, 9);
                    logWeights[i] = prior.logCamera(lenses[i], pose)
                            - CameraPosterior.logDensity(result.settings().model().rotationPrior(), state);
                }
            }
        }
    }

    private static PinholeCamera[] lenses(CheckResult result, int n) {
        PinholeCamera stated = result.cell().camera();
        PinholeCamera[] lenses = new PinholeCamera[n];
        Arrays.fill(lenses, stated);
        IntrinsicsPrior unknown = IntrinsicsPrior.stated(result.cell(), result.settings().model());
        if (unknown.count() > 0) {
            double[][] values = new double[unknown.count()][];
            for (int k = 0; k < values.length; k++) {
                values[k] = column(result,
                        Quantity.intrinsic(stated.lens().parameterNames().get(unknown.index(k))));
            }
            for (int i = 0; i < n; i++) {
                double[] intrinsics = stated.intrinsics();
                for (int k = 0; k < values.length; k++) {
                    intrinsics[unknown.index(k)] = values[k][i];
                }
                lenses[i] = stated.withIntrinsics(intrinsics);
            }
        }
        return lenses;
    }

    /**
     * Finds how the truth lies among the draws.
     *
     * @param result a check
     * @param camera its draws of the camera
     * @param truth the truth of its photo
     * @param prior where the truth was drawn from
     * @param ranked number of draws to rank the truth among
     * @param random picks these draws
     */
    Standing standing(CheckResult result, CameraDraws camera, CellTruth truth, TruthPrior prior, int ranked,
            RandomGenerator random) {
        double[][] columns = columns(result);
        double[] rotations = object == null ? camera.rotations : rotations(result, object);
        int n = columns[0].length;
        RigidTransform truePose = object == null ? truth.worldFromCamera() : truth.worldFromObject(object.id());
        double[] trueValues = trueCoordinates(truePose, truth.camera(result.cell()),
                referenceRotation(columns, rotations));

        Standing standing = new Standing(regionNames.size(), coordinates.size(), derived.size());
        double[] mean = new double[columns.length];
        double[] std = new double[columns.length];
        for (int c = 0; c < columns.length; c++) {
            for (double v : columns[c]) {
                mean[c] += v / n;
            }
            for (double v : columns[c]) {
                std[c] += (v - mean[c]) * (v - mean[c]) / (n - 1);
            }
            std[c] = Math.sqrt(std[c]);
            standing.standardisedError[c] = (trueValues[c] - mean[c]) / std[c];
        }

        // regions
        int[] labels = CoverageStudy.labels(result, object);
        int regions = regionNames.size();
        double[][] distances = new double[regions][n];
        for (int k = 0; k < regions; k++) {
            int d = regionDimensions.get(k);
            // what a pose has beside it comes after its six coordinates
            int first = k > regionNames.indexOf(name + " pose") ? 6 : 0;
            double[][] covariance = covariance(columns, mean, first, d);
            CoverageRegion region = CoverageRegion.of(Arrays.copyOfRange(mean, first, first + d), covariance, 0.95);
            standing.squaredDistance[k] = region.mahalanobisSquared(Arrays.copyOfRange(trueValues, first, first + d));
            double[] x = new double[d];
            int smaller = 0;
            for (int i = 0; i < n; i++) {
                for (int j = 0; j < d; j++) {
                    x[j] = columns[first + j][i];
                }
                distances[k][i] = region.mahalanobisSquared(x);
                smaller += distances[k][i] < standing.squaredDistance[k] ? 1 : 0;
            }
            // where there are two poses, one ellipsoid over both lies mostly where neither is
            standing.drawShare[k] = labels == null ? (double) smaller / n
                    : new MixtureRegion(columns, first, d, labels)
                            .shareOf(Arrays.copyOfRange(trueValues, first, first + d));
        }

        // ranks, among draws weighted to the prior that the truth is from
        double[] logWeights = camera.logWeights.clone();
        double[] second = new double[n];
        double trueSecond;
        if (object == null) {
            second = column(result, Quantity.LOG_DENSITY);
            trueSecond = result.cameraLogDensity(truePose, truth.camera(result.cell()).intrinsics());
        } else {
            for (int i = 0; i < n; i++) {
                RigidTransform pose = camera.cameraFromWorld[i].compose(pose(rotations, columns, i));
                second[i] = length(pose.translationMm());
                if (!prior.isPoint()) {
                    logWeights[i] += prior.logObject(camera.lenses[i], object, pose);
                }
            }
            trueSecond = length(truth.worldFromCamera().inverse().compose(truePose).translationMm());
        }
        double[] cumulative = cumulativeWeights(logWeights);
        standing.weightShare = effectiveShare(logWeights);
        int[] picked = new int[ranked];
        for (int i = 0; i < ranked; i++) {
            picked[i] = pick(cumulative, random.nextDouble());
        }
        int at = 0;
        for (int c = 0; c < columns.length; c++) {
            standing.ranks[at++] = rank(trueValues[c], columns[c], picked);
        }
        standing.ranks[at++] = rank(trueSecond, second, picked);
        int pose = regionNames.indexOf(name + " pose");
        standing.ranks[at++] = rank(standing.squaredDistance[pose], distances[pose], picked);
        if (at < standing.ranks.length) {
            standing.ranks[at] = rank(standing.squaredDistance[pose + 1], distances[pose + 1], picked);
        }
        return standing;
    }

    /** The rotation that the rotation vectors of the draws start from: undone from the first draw. */
    static double[] referenceRotation(double[][] columns, double[] rotations) {
        double[] back = new double[9];
        double[] reference = new double[9];
        Rotations.exp(-columns[3][0], -columns[4][0], -columns[5][0], back);
        Rotations.multiply(back, Arrays.copyOf(rotations, 9), reference);
        return reference;
    }

    private double[] trueCoordinates(RigidTransform pose, PinholeCamera lens, double[] referenceRotation) {
        double[] values = new double[coordinates.size()];
        System.arraycopy(pose.translationMm(), 0, values, 0, 3);
        double[] turned = new double[9];
        Rotations.multiplyTransposed(pose.rotation(), referenceRotation, turned);
        Rotations.log(turned, values, 3);
        double[] gripMm = object == null ? null : object.gripMm();
        if (gripMm != null) {
            System.arraycopy(pose.apply(gripMm), 0, values, 6, 3);
        } else if (values.length > 6) {
            values[6] = lens.get(PinholeCamera.FX);
            values[7] = lens.get(PinholeCamera.FY);
        }
        return values;
    }

    private static double[][] covariance(double[][] columns, double[] mean, int first, int d) {
        int n = columns[0].length;
        double[][] covariance = new double[d][d];
        for (int i = 0; i < d; i++) {
            for (int j = 0; j <= i; j++) {
                double sum = 0;
                for (int k = 0; k < n; k++) {
                    sum += (columns[first + i][k] - mean[first + i]) * (columns[first + j][k] - mean[first + j]);
                }
                covariance[i][j] = sum / (n - 1);
                covariance[j][i] = covariance[i][j];
            }
        }
        return covariance;
    }

    private static double length(double[] v) {
        return Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }

    private static int rank(double truth, double[] values, int[] picked) {
        double[] draws = new double[picked.length];
        for (int i = 0; i < picked.length; i++) {
            draws[i] = values[picked[i]];
        }
        return RankHistogram.rankOf(truth, draws);
    }

    private static double largest(double[] values) {
        double largest = Double.NEGATIVE_INFINITY;
        for (double v : values) {
            largest = Math.max(largest, v);
        }
        // where no draw has any weight all count alike; the effective share then says 0
        return largest == Double.NEGATIVE_INFINITY ? 0 : largest;
    }

    private static double[] cumulativeWeights(double[] logWeights) {
        double largest = largest(logWeights);
        double[] cumulative = new double[logWeights.length];
        double sum = 0;
        for (int i = 0; i < cumulative.length; i++) {
            sum += Math.exp(logWeights[i] - largest);
            cumulative[i] = sum;
        }
        if (!(sum > 0)) {
            for (int i = 0; i < cumulative.length; i++) {
                cumulative[i] = i + 1;
            }
        }
        return cumulative;
    }

    /** Kish's effective sample size of the weights over their number. */
    private static double effectiveShare(double[] logWeights) {
        double largest = largest(logWeights);
        double sum = 0;
        double squares = 0;
        for (double log : logWeights) {
            double w = Math.exp(log - largest);
            sum += w;
            squares += w * w;
        }
        return squares > 0 ? sum * sum / (squares * logWeights.length) : 0;
    }

    private static int pick(double[] cumulative, double uniform) {
        int i = Arrays.binarySearch(cumulative, uniform * cumulative[cumulative.length - 1]);
        int at = i >= 0 ? i + 1 : -i - 1;
        return Math.min(at, cumulative.length - 1);
    }
}
