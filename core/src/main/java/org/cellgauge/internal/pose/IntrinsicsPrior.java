package org.cellgauge.internal.pose;

import java.util.Arrays;
import java.util.OptionalDouble;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.cellgauge.cell.CameraCalibration;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.geometry.Lenses;
import org.cellgauge.settings.CalibrationUse;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Estimate;
import org.cellgauge.settings.ModelSettings;
import org.cellgauge.settings.SettingTable;
import org.cellgauge.warning.CheckRefusal;
import org.cellgauge.warning.Refusal;

/**
 * Which intrinsics are unknown and what is known of them beforehand: a Gaussian; immutable.
 *
 * <p>It is kept as a chain of regressions: the deviation of unknown i from its mean, given those before it, is normal
 * about {@code sum_k b_ik d_k} with a deviation of its own. The rows of {@code (d_i - sum_k b_ik d_k) / s_i} are
 * independent and standard normal beforehand: {@code L^-1 d}, L the Cholesky factor of the covariance.
 *
 * <p>The prior of a focal length may be flat: a deviation of +infinity. References in one plane alone do not determine
 * a focal length, and leave a posterior then that cannot be normalised, which {@link #stated} refuses; nothing can be
 * drawn from such a prior.
 */
public final class IntrinsicsPrior {
    /** All intrinsics are known. */
    public static final IntrinsicsPrior KNOWN = new IntrinsicsPrior(new int[0], new double[0], new double[0],
            new double[0], new double[0], 0);

    private final int[] indices;
    private final double[] means;
    private final double[] stds;
    private final double[] slopes;
    private final double[] ownStds;
    private final int estimated;

    /**
     * A prior.
     *
     * @param slopes by how much unknown i follows those before it, count x count row by row, lower triangle
     * @param ownStds deviation of each given those before it
     * @param estimated how many are estimated, beginning with the first
     */
    private IntrinsicsPrior(int[] indices, double[] means, double[] stds, double[] slopes, double[] ownStds,
            int estimated) {
        this.estimated = estimated;
        this.indices = indices;
        this.means = means;
        this.stds = stds;
        this.slopes = slopes;
        this.ownStds = ownStds;
    }

    /**
     * What is known beforehand of the intrinsics of a cell's camera: what settings say of those that are estimated;
     * what the calibration says of all others, apart from these.
     *
     * @param cell gives the values of the camera file, and how well its calibration knows them
     * @param model which are estimated, and how well they are known
     * @return the prior
     * @throws InputRefusedException if nothing is known of the focal length and all references lie in one plane, or the
     *     lens has no coefficients of a kind that is to be estimated
     */
    public static IntrinsicsPrior stated(Cell cell, ModelSettings model) {
        IntrinsicsPrior estimated = estimated(cell.camera(), model);
        if (estimated.isFlat() && NearestPlane.holds(cell.references())) {
            throw new InputRefusedException(Refusal.of(CheckRefusal.FLAT_FOCAL_IN_PLANE));
        }
        CameraCalibration calibration = cell.calibration();
        if (calibration == null || model.get(SettingTable.CALIBRATION) == CalibrationUse.EXACT) {
            return estimated;
        }
        int[] calibrated = calibration.indices(cell.camera().lens());
        int[] others = IntStream.range(0, calibrated.length)
                .filter(i -> Arrays.stream(estimated.indices).noneMatch(index -> index == calibrated[i])).toArray();
        if (others.length == 0) {
            return estimated;
        }
        double[] all = calibration.covariance();
        int n = others.length;
        double[] covariance = new double[n * n];
        for (int i = 0; i < n; i++) {
            for (int k = 0; k < n; k++) {
                covariance[n * i + k] = all[calibrated.length * others[i] + others[k]];
            }
        }
        IntrinsicsPrior known = joint(cell.camera(), Arrays.stream(others).map(i -> calibrated[i]).toArray(),
                covariance);
        return estimated.and(known, estimated.count());
    }

    /** The prior of those that settings call unknown. */
    private static IntrinsicsPrior estimated(PinholeCamera file, ModelSettings model) {
        if (model.estimate() == Estimate.NONE) {
            return KNOWN;
        }
        PinholeCamera camera = known(file, model);
        double focalStdPx = model.get(SettingTable.FOCAL_PRIOR_SHARE).isPresent()
                ? model.get(SettingTable.FOCAL_PRIOR_SHARE).getAsDouble() * camera.get(PinholeCamera.FX)
                : model.focalPriorStdPx();
        IntrinsicsPrior focal = Double.isInfinite(model.aspectPriorStd()) ? focal(camera, focalStdPx)
                : focalAndAspect(camera, focalStdPx, model.aspectPriorStd());
        if (model.estimate() == Estimate.FOCAL) {
            return focal;
        }
        double principal = model.get(SettingTable.PRINCIPAL_PRIOR_STD_PX);
        double radial = model.get(SettingTable.RADIAL_PRIOR_STD);
        IntrinsicsPrior all = focal.and(of(camera, new int[] {PinholeCamera.CX, PinholeCamera.CY, Lenses.FIRST_RADIAL,
            Lenses.FIRST_RADIAL + 1}, new double[] {principal, principal, radial, radial}), 6);
        all = all.and(camera, model.get(SettingTable.HIGHER_RADIAL_PRIOR_STD), "k[3-9]");
        IntrinsicsPrior withTangential = all.and(camera, model.get(SettingTable.TANGENTIAL_PRIOR_STD), "p[12]");
        if (withTangential == all && model.get(SettingTable.TANGENTIAL_PRIOR_STD).isPresent()) {
            throw new InputRefusedException(Refusal.of(CheckRefusal.NO_TANGENTIAL_COEFFICIENTS,
                    camera.lens().modelName()));
        }
        return withTangential;
    }

    /**
     * The camera as it is known before the photo is seen: that of the file, with the focal length of the field of view
     * where settings state one. A lens that is not wide sees {@code 2 atan(width / 2 fx)}, a wide one about
     * {@code width / fx}.
     *
     * @param file the camera of the cell file
     * @param model settings
     * @return another camera where a field of view is stated and focal lengths are estimated
     */
    private static PinholeCamera known(PinholeCamera file, ModelSettings model) {
        OptionalDouble degrees = model.get(SettingTable.FIELD_OF_VIEW_DEG);
        if (model.estimate() == Estimate.NONE || degrees.isEmpty()) {
            return file;
        }
        double half = Math.toRadians(degrees.getAsDouble()) / 2;
        return withFocal(file, file.widthPx() / 2.0 / (file.lens().isWide() ? half : Math.tan(half)));
    }

    /**
     * Where a search for the unknown intrinsics starts.
     *
     * @param file the camera of the cell file
     * @param settings may state a focal length for it
     * @return the prior's means, exact values where there are none, with the focal length stated
     */
    public static PinholeCamera start(PinholeCamera file, CheckSettings settings) {
        OptionalDouble focalPx = settings.sampling().get(SettingTable.INITIAL_FOCAL_PX);
        return settings.model().estimate() == Estimate.NONE || focalPx.isEmpty() ? known(file, settings.model())
                : withFocal(file, focalPx.getAsDouble());
    }

    private static PinholeCamera withFocal(PinholeCamera camera, double focalPx) {
        double[] values = camera.intrinsics();
        values[PinholeCamera.FY] *= focalPx / values[PinholeCamera.FX];
        values[PinholeCamera.FX] = focalPx;
        return camera.withIntrinsics(values);
    }

    /** This prior and that of all parameters whose names fit, of one deviation; this one where there is none. */
    private IntrinsicsPrior and(PinholeCamera camera, OptionalDouble std, String names) {
        int[] more = IntStream.range(0, camera.lens().parameterCount())
                .filter(i -> camera.lens().parameterNames().get(i).matches(names)).toArray();
        if (std.isEmpty() || more.length == 0) {
            return this;
        }
        double[] stds = new double[more.length];
        Arrays.fill(stds, std.getAsDouble());
        return and(of(camera, more, stds), count() + more.length);
    }

    /**
     * This prior and that of other intrinsics, each independent of the other.
     *
     * @param ofBoth how many of them are estimated, beginning with the first
     */
    private IntrinsicsPrior and(IntrinsicsPrior other, int ofBoth) {
        int mine = count();
        int all = mine + other.count();
        double[] joined = new double[all * all];
        for (int i = 0; i < all; i++) {
            for (int k = 0; k < i; k++) {
                if (i < mine) {
                    joined[all * i + k] = slopes[mine * i + k];
                } else if (k >= mine) {
                    joined[all * i + k] = other.slopes[other.count() * (i - mine) + k - mine];
                }
            }
        }
        return new IntrinsicsPrior(
                IntStream.concat(Arrays.stream(indices), Arrays.stream(other.indices)).toArray(),
                joined(means, other.means), joined(stds, other.stds), joined, joined(ownStds, other.ownStds),
                ofBoth);
    }

    private static double[] joined(double[] first, double[] second) {
        return DoubleStream.concat(Arrays.stream(first), Arrays.stream(second)).toArray();
    }

    /**
     * How many unknowns are estimated, beginning with the first: those after them are as well known as a calibration
     * says, and independent of these.
     *
     * @return 0 to count
     */
    public int estimatedCount() {
        return estimated;
    }

    /**
     * Whether nothing is known beforehand of one of them.
     *
     * @return true for a flat prior of the focal length
     */
    public boolean isFlat() {
        return Arrays.stream(stds).anyMatch(Double::isInfinite);
    }

    /**
     * The same with a wide deviation in the place of a flat one, for searches that go by deviations.
     *
     * @return half of the mean where nothing is known
     */
    public IntrinsicsPrior proper() {
        return new IntrinsicsPrior(indices, means, proper(stds), slopes, proper(ownStds), estimated);
    }

    private double[] proper(double[] deviations) {
        return IntStream.range(0, deviations.length)
                .mapToDouble(i -> Double.isInfinite(deviations[i]) ? means[i] / 2 : deviations[i]).toArray();
    }

    /**
     * Whether an intrinsic is unknown.
     *
     * @param index index of {@link PinholeCamera}
     * @return false if it is exact
     */
    public boolean has(int index) {
        return Arrays.stream(indices).anyMatch(i -> i == index);
    }

    /**
     * Unknown focal lengths fx and fy that know nothing of each other, each N(camera's value, std²): as in the thesis.
     *
     * @param camera gives the means
     * @param stdPx standard deviation, px, positive; +infinity for a flat prior
     * @return the prior
     * @throws IllegalArgumentException if the deviation is not positive
     */
    public static IntrinsicsPrior focal(PinholeCamera camera, double stdPx) {
        return of(camera, new int[] {PinholeCamera.FX, PinholeCamera.FY}, new double[] {stdPx, stdPx});
    }

    /**
     * One unknown focal length, N(camera's fx, std²), and an unknown aspect ratio: {@code fy / fx} is the camera's,
     * give or take a share of it. To first order in that share: {@code fy - fy0 = (fy0 / fx0) (fx - fx0) + fy0 t}.
     *
     * <p>Pixels are square, or as the calibration has them, far better than the focal length is known. Two independent
     * focal lengths leave room for shapes of pixels that no camera has, and their posterior lies off the truth.
     *
     * @param camera gives the means and the ratio
     * @param stdPx standard deviation of fx, px, positive; +infinity for a flat prior
     * @param aspectStd standard deviation of {@code fy / fx} as a share of the camera's, positive
     * @return the prior of fx and fy
     * @throws IllegalArgumentException if a deviation is not positive, or that of the aspect ratio infinite
     */
    public static IntrinsicsPrior focalAndAspect(PinholeCamera camera, double stdPx, double aspectStd) {
        if (Double.isInfinite(aspectStd)) {
            throw new IllegalArgumentException("two independent focal lengths have no aspect ratio");
        }
        double fx = camera.get(PinholeCamera.FX);
        double fy = camera.get(PinholeCamera.FY);
        double ofAspect = fy * aspectStd;
        double byFocal = fy / fx;
        IntrinsicsPrior apart = of(camera, new int[] {PinholeCamera.FX, PinholeCamera.FY},
                new double[] {stdPx, ofAspect});
        return new IntrinsicsPrior(apart.indices, apart.means,
                new double[] {stdPx, Math.hypot(byFocal * stdPx, ofAspect)}, new double[] {0, 0, byFocal, 0},
                apart.ownStds, 2);
    }

    /**
     * Unknown intrinsics of any choice, each Gaussian about the camera's value.
     *
     * @param camera gives the means
     * @param indices indices of {@link PinholeCamera}; copied
     * @param stds standard deviations in the units of the values, positive; +infinity of a focal length where nothing
     *     is known of it; copied
     * @return the prior
     * @throws IllegalArgumentException if a deviation is not positive, or infinite and not a focal length's
     */
    public static IntrinsicsPrior of(PinholeCamera camera, int[] indices, double[] stds) {
        double[] means = new double[indices.length];
        for (int i = 0; i < indices.length; i++) {
            means[i] = camera.get(indices[i]);
            if (!(stds[i] > 0) || Double.isInfinite(stds[i]) && indices[i] > PinholeCamera.FY) {
                throw new IllegalArgumentException("prior deviation must be positive, not " + stds[i]);
            }
        }
        return new IntrinsicsPrior(indices.clone(), means, stds.clone(), new double[indices.length * indices.length],
                stds.clone(), indices.length);
    }

    /**
     * Unknown intrinsics of any choice with a joint Gaussian prior about the camera's values, as a calibration leaves
     * them.
     *
     * @param camera gives the means
     * @param indices indices of its intrinsics; copied
     * @param covariance their covariance, count x count row by row, in the products of their units
     * @return the prior
     * @throws IllegalArgumentException if the covariance has another size or is not positive definite
     */
    public static IntrinsicsPrior joint(PinholeCamera camera, int[] indices, double[] covariance) {
        int n = indices.length;
        double[] root = covariance.clone();
        if (root.length != n * n || !Cholesky.factor(root, n)) {
            throw new IllegalArgumentException("a prior of " + n + " intrinsics needs a positive definite covariance");
        }
        double[] whitening = new double[n * n];
        Cholesky.invertLower(root, n, whitening);
        double[] means = new double[n];
        double[] stds = new double[n];
        double[] ownStds = new double[n];
        double[] slopes = new double[n * n];
        for (int i = 0; i < n; i++) {
            means[i] = camera.get(indices[i]);
            stds[i] = Math.sqrt(covariance[(n + 1) * i]);
            ownStds[i] = root[(n + 1) * i];
            for (int k = 0; k < i; k++) {
                slopes[n * i + k] = -whitening[n * i + k] * ownStds[i];
            }
        }
        return new IntrinsicsPrior(indices.clone(), means, stds, slopes, ownStds, n);
    }

    /**
     * Number of unknown intrinsics.
     *
     * @return 0 where all are known
     */
    public int count() {
        return indices.length;
    }

    /**
     * Which intrinsic the i-th unknown is.
     *
     * @param i 0 to count - 1
     * @return index of {@link PinholeCamera}
     */
    public int index(int i) {
        return indices[i];
    }

    /**
     * Prior mean of the i-th unknown.
     *
     * @param i 0 to count - 1
     * @return in the unit of the value
     */
    public double mean(int i) {
        return means[i];
    }

    /**
     * Prior standard deviation of the i-th unknown.
     *
     * @param i 0 to count - 1
     * @return in the unit of the value; +infinity where it is flat
     */
    public double std(int i) {
        return stds[i];
    }

    /**
     * Change of the i-th independent row by an unknown: an entry of {@code L^-1}.
     *
     * @param i row, 0 to count - 1
     * @param k unknown, 0 to count - 1
     * @return in the inverse of the unknown's unit
     */
    public double whitening(int i, int k) {
        return i == k ? 1 / ownStds[i] : -slopes[i * indices.length + k] / ownStds[i];
    }

    /**
     * An entry of the inverse of the covariance.
     *
     * @param i unknown, 0 to count - 1
     * @param k unknown, 0 to count - 1
     * @return in the inverse of the product of their units
     */
    public double information(int i, int k) {
        double sum = 0;
        for (int row = Math.max(i, k); row < indices.length; row++) {
            sum += whitening(row, i) * whitening(row, k);
        }
        return sum;
    }

    /**
     * The i-th independent row at a state, standard normal beforehand. Allocates nothing.
     *
     * @param i 0 to count - 1
     * @param intrinsics in the order of {@link PinholeCamera}
     * @return deviations
     */
    public double whitened(int i, double[] intrinsics) {
        double d = intrinsics[indices[i]] - means[i];
        for (int k = 0; k < i; k++) {
            d -= slopes[i * indices.length + k] * (intrinsics[indices[k]] - means[k]);
        }
        return d / ownStds[i];
    }

    /**
     * The intrinsics that have given independent rows: the inverse of {@link #whitened}. Standard normal ones give a
     * draw of the prior, which may have a focal length that is not positive.
     *
     * @param rows count values
     * @param intrinsics in the order of {@link PinholeCamera}; receives the unknown ones
     */
    public void setWhitened(double[] rows, double[] intrinsics) {
        for (int i = 0; i < indices.length; i++) {
            double d = ownStds[i] * rows[i];
            for (int k = 0; k < i; k++) {
                d += slopes[i * indices.length + k] * (intrinsics[indices[k]] - means[k]);
            }
            intrinsics[indices[i]] = means[i] + d;
        }
    }

    /**
     * Logarithm of the prior density at a state, up to a constant.
     *
     * @param intrinsics in the order of {@link PinholeCamera}
     * @return the logarithm; -infinity where a focal length is not positive
     */
    public double logDensity(double[] intrinsics) {
        double sum = 0;
        for (int i = 0; i < indices.length; i++) {
            double d = whitened(i, intrinsics);
            sum -= 0.5 * d * d;
        }
        return intrinsics[PinholeCamera.FX] > 0 && intrinsics[PinholeCamera.FY] > 0 ? sum : Double.NEGATIVE_INFINITY;
    }
}
