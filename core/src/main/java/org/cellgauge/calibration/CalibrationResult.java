package org.cellgauge.calibration;

import java.util.List;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.warning.Warning;
import org.jspecify.annotations.Nullable;

/**
 * A calibrated camera and all that tells how far it can be relied on; immutable.
 *
 * <p>Deviations are those of Laplace's approximation with the noise that the corners themselves show; where odd and
 * even photos contradict each other they are widened by {@link #widenedBy()}.
 *
 * @param camera the camera
 * @param lens name of the lens model among {@link Calibration#lenses()}
 * @param parameters the unknowns of the lens, and those that a richer one has which explains the photos about as well
 * @param covariance their joint covariance about their values, row by row in their order, widened as said; where the
 *     lens was chosen by the photos, it has in it what other lenses say that explain them about as well
 * @param widenedBy factor of all deviations, at least 1
 * @param board unknowns of the board
 * @param figures figures of all photos together
 * @param photos photos that showed the target
 * @param residuals errors of all points
 * @param places deviations over the image, row by row
 * @param placesPerRow how many places a row has
 * @param ladder lens models tried, the leanest first; empty where there were too few photos
 * @param warnings what users should know
 * @param nextPhoto the photo that would help most
 * @param inQuestion whether so much had to be left out that no figure can be trusted
 */
public record CalibrationResult(PinholeCamera camera, String lens, List<Parameter> parameters,
        List<List<Double>> covariance, double widenedBy, List<Parameter> board, Figures figures, List<Photo> photos,
        List<Residual> residuals, List<Place> places, int placesPerRow, List<LensTrial> ladder,
        List<Warning> warnings, @Nullable Warning nextPhoto, boolean inQuestion) {
    /**
     * An unknown.
     *
     * @param name with its unit where it has one: {@code fx_px}, {@code k1}, {@code warp_1_mm}
     * @param value what was found
     * @param std its standard deviation, in the same unit
     */
    public record Parameter(String name, double value, double std) {
    }

    /**
     * One photo.
     *
     * @param name as given
     * @param points points of the target that were found
     * @param outliers how many of these were left out
     * @param rmsPx root mean square distance of those that count between image and projection, px
     * @param tiltDeg angle between the target's normal and the line of sight to its middle, degrees
     * @param distanceMm from the camera to the target's middle, mm
     * @param gain by what share the mean variance of the projection would grow without this photo
     * @param contradicts whether it is off by more than the others' noise allows
     * @param addsLittle whether the calibration would be nearly as good without it
     */
    public record Photo(String name, int points, int outliers, double rmsPx, double tiltDeg, double distanceMm,
            double gain, boolean contradicts, boolean addsLittle) {
    }

    /**
     * The error of one point.
     *
     * @param photo index into {@link #photos()}
     * @param u where it was seen, px
     * @param v where it was seen, px
     * @param du projection minus observation, px
     * @param dv projection minus observation, px
     * @param outlier whether it was left out
     */
    public record Residual(int photo, double u, double v, double du, double dv, boolean outlier) {
    }

    /**
     * A place of the image.
     *
     * @param u px
     * @param v px
     * @param stdPx deviation of the projection there in the direction where it is largest, px: what a turn of the
     *     camera cannot make good, since poses are estimated with every photo
     * @param crossPx difference of the calibrations from odd and from even photos, px, likewise; NaN where there are
     *     none
     * @param crossRatio that difference over its own stated deviation; NaN where there is none
     */
    public record Place(double u, double v, double stdPx, double crossPx, double crossRatio) {
    }

    /**
     * One lens model, tried.
     *
     * @param lens its name
     * @param unknowns how many parameters it has
     * @param heldOutRmsPx error of a coordinate in photos that its fit did not see, px; odd and even ones in turn
     * @param weight its share in the covariance, by these errors; 0 where it was not to be chosen, or is of another
     *     model than the one that was
     */
    public record LensTrial(String lens, int unknowns, double heldOutRmsPx, double weight) {
    }

    /**
     * Figures of all photos together.
     *
     * @param points points that count
     * @param outliers points left out
     * @param rmsPx root mean square distance between image and projection, px
     * @param noisePx deviation of a coordinate, degrees of freedom taken into account, px
     * @param iterationsMs time of the adjustment, ms
     * @param coveredShare share of the image that the target covered in some photo
     * @param horizontalDeg field of view between the middles of the left and the right edge, degrees; NaN where the
     *     lens model ends before
     * @param verticalDeg likewise from top to bottom
     * @param distanceMm distance at which deviations are stated in mm
     * @param crossRatio difference of odd and even photos over its stated deviation; NaN where there are too few photos
     */
    public record Figures(int points, int outliers, double rmsPx, double noisePx, double iterationsMs,
            double coveredShare, double horizontalDeg, double verticalDeg, double distanceMm, double crossRatio) {
    }

    /** Copies lists. */
    public CalibrationResult {
        parameters = List.copyOf(parameters);
        covariance = covariance.stream().map(List::copyOf).toList();
        board = List.copyOf(board);
        photos = List.copyOf(photos);
        residuals = List.copyOf(residuals);
        places = List.copyOf(places);
        ladder = List.copyOf(ladder);
        warnings = List.copyOf(warnings);
    }
}
