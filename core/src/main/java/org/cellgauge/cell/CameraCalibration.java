package org.cellgauge.cell;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import org.cellgauge.geometry.Lens;
import org.cellgauge.internal.geometry.Cholesky;
import org.jspecify.annotations.Nullable;

/**
 * How well a calibration knows a camera's intrinsics: the joint covariance of some of them about the values of the
 * camera file; immutable. What it does not name is known exactly.
 *
 * <p>It belongs to the camera of its file: another camera is as uncertain as its own calibration says.
 */
public final class CameraCalibration {
    /** Digits that a file may have rounded away, as a share of the deviations. */
    private static final double SYMMETRY = 1e-6;
    /** Every lens begins with these. */
    private static final Set<String> IN_PIXELS = Set.of("fx", "fy", "cx", "cy", "skew");

    private final List<String> parameters;
    private final double[] covariance;
    private final int photos;

    /**
     * What a calibration leaves open.
     *
     * @param parameters names of intrinsics as {@link #name} has them, each once, not empty; copied
     * @param covariance their covariance, count x count row by row, in the products of their units, positive definite;
     *     copied
     * @param photos how many photos it rests on; 0 where that is not known
     * @throws IllegalArgumentException if the covariance has another size, is not symmetric or not positive definite
     */
    public CameraCalibration(List<String> parameters, double[] covariance, int photos) {
        if (!isCovariance(covariance, parameters.size())) {
            throw new IllegalArgumentException("no covariance of " + parameters);
        }
        this.parameters = List.copyOf(parameters);
        this.covariance = covariance.clone();
        this.photos = photos;
    }

    /** Whether values are a covariance: symmetric to rounding, and every variance positive whatever the others are. */
    static boolean isCovariance(double[] values, int n) {
        if (n == 0 || values.length != n * n) {
            return false;
        }
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < i; j++) {
                double size = Math.sqrt(values[i * n + i] * values[j * n + j]);
                if (!(Math.abs(values[i * n + j] - values[j * n + i]) <= SYMMETRY * size)) {
                    return false;
                }
            }
        }
        return Cholesky.factor(values.clone(), n);
    }

    /**
     * The same calibration where the camera's images are delivered in another size.
     *
     * @param factor new size over old one, positive
     * @return what the scaled camera leaves open: focal lengths, principal point and skew grow by the factor, what
     *     bends the rays stays, since it is about directions
     */
    CameraCalibration scaled(double factor) {
        int n = parameters.size();
        double[] scaled = covariance.clone();
        for (int i = 0; i < n; i++) {
            if (IN_PIXELS.contains(parameters.get(i))) {
                for (int j = 0; j < n; j++) {
                    scaled[n * i + j] *= factor;
                    scaled[n * j + i] *= factor;
                }
            }
        }
        return new CameraCalibration(parameters, scaled, photos);
    }

    /**
     * The name of a lens's parameter in camera files.
     *
     * @param parameter a name of {@link Lens#parameterNames()}
     * @return the name without its unit: {@code fx}, {@code k1}
     */
    public static String name(String parameter) {
        return parameter.endsWith("_px") ? parameter.substring(0, parameter.length() - 3) : parameter;
    }

    /**
     * Which parameters of a lens it is about.
     *
     * @param lens a lens
     * @return indices in the lens's order of parameters, one for each of {@link #parameters()}
     * @throws IllegalArgumentException if the lens has no parameter of one of the names
     */
    public int[] indices(Lens lens) {
        int[] indices = new int[parameters.size()];
        for (int i = 0; i < indices.length; i++) {
            indices[i] = index(lens, parameters.get(i));
            if (indices[i] < 0) {
                throw new IllegalArgumentException(lens.modelName() + " has no " + parameters.get(i));
            }
        }
        return indices;
    }

    /** Where a lens has the parameter of a name; -1 where it has none. */
    static int index(Lens lens, String name) {
        for (int i = 0; i < lens.parameterCount(); i++) {
            if (name(lens.parameterNames().get(i)).equals(name)) {
                return i;
            }
        }
        return -1;
    }

    /**
     * The intrinsics that it leaves open.
     *
     * @return names, unmodifiable, not empty
     */
    public List<String> parameters() {
        return parameters;
    }

    /**
     * Their joint covariance.
     *
     * @return count x count row by row, a copy, in the products of their units (px, or none)
     */
    public double[] covariance() {
        return covariance.clone();
    }

    /**
     * Standard deviation of one of them.
     *
     * @param i index into {@link #parameters()}
     * @return in its unit
     */
    public double std(int i) {
        return Math.sqrt(covariance[(parameters.size() + 1) * i]);
    }

    /**
     * How many photos it rests on.
     *
     * @return 0 where that is not known
     */
    public int photos() {
        return photos;
    }

    @Override
    public boolean equals(@Nullable Object other) {
        return other instanceof CameraCalibration c && parameters.equals(c.parameters)
                && Arrays.equals(covariance, c.covariance) && photos == c.photos;
    }

    @Override
    public int hashCode() {
        return Objects.hash(parameters, Arrays.hashCode(covariance), photos);
    }
}
