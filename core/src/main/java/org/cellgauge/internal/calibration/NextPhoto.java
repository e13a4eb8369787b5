package org.cellgauge.internal.calibration;

import java.util.Arrays;
import org.cellgauge.calibration.CalibrationWarning;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.geometry.Rotations;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.vision.TargetObservation;
import org.cellgauge.warning.Warning;
import org.jspecify.annotations.Nullable;

/**
 * The photo that would help most: of many places, distances and tilts of the target that after which the projection is
 * surest over the image.
 */
final class NextPhoto {
    private static final PhotoPhrase[] ROW_NAMES = {PhotoPhrase.TOP, PhotoPhrase.MIDDLE_ROW,
        PhotoPhrase.BOTTOM};
    private static final PhotoPhrase[] COLUMN_NAMES = {PhotoPhrase.LEFT, PhotoPhrase.CENTRE,
        PhotoPhrase.RIGHT};
    private static final double TILT_DEG = 40;
    /** Shares of the image's smaller side that the target takes. */
    private static final double[] SHARES = {0.8, 0.5, 0.3};
    private static final int FEWEST_POINTS = 8;

    private NextPhoto() {
    }

    /**
     * Looks for it.
     *
     * @param information about lens and board so far
     * @return what to do, in words; null where no photo of the target fits
     */
    static @Nullable Warning of(CalibrationFit fit, ProjectionMap map, double[] information, int widthPx,
            int heightPx) {
        double best = Double.POSITIVE_INFINITY;
        Warning words = null;
        double[] middle = middle(fit.board.xyzMm);
        double size = 2 * middle[3];
        double focal = fit.values[0];
        for (double share : SHARES) {
            double distance = focal * size / (share * Math.min(widthPx, heightPx));
            for (int place = 0; place < 9; place++) {
                for (int tilt = 0; tilt < 5; tilt++) {
                    TargetPhoto photo = photo(fit, middle, distance, place, tilt, widthPx, heightPx);
                    if (photo == null) {
                        continue;
                    }
                    double[] sum = fit.informationOf(photo);
                    for (int i = 0; i < sum.length; i++) {
                        sum[i] += information[i];
                    }
                    double variance = map.meanVariance(Cholesky.inverse(sum, fit.globals), fit.globals);
                    if (variance < best) {
                        best = variance;
                        words = Warning.of(CalibrationWarning.NEXT_PHOTO, place(place), Warning.of(
                                PhotoPhrase.AT_DISTANCE, Decimal.of(distance, 0)), tilted(tilt));
                    }
                }
            }
        }
        return words;
    }

    private static Warning place(int place) {
        return place == 4 ? Warning.of(PhotoPhrase.IN_MIDDLE)
                : ofNinth(place);
    }

    /** A ninth of the image in words. */
    static Warning ofNinth(int place) {
        return Warning.of(PhotoPhrase.AT_PLACE, ROW_NAMES[place / 3], COLUMN_NAMES[place % 3]);
    }

    private static Warning tilted(int tilt) {
        PhotoPhrase[] edges = {PhotoPhrase.FACING, PhotoPhrase.LEFT_EDGE,
            PhotoPhrase.RIGHT_EDGE, PhotoPhrase.UPPER_EDGE, PhotoPhrase.LOWER_EDGE};
        return tilt == 0 ? Warning.of(PhotoPhrase.FACING)
                : Warning.of(PhotoPhrase.TILTED, (int) TILT_DEG, edges[tilt]);
    }

    /** Middle of the target and half its largest side, mm. */
    private static double[] middle(double[] xyz) {
        double[] out = new double[4];
        for (int k = 0; k < 3; k++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int i = k; i < xyz.length; i += 3) {
                low = Math.min(low, xyz[i]);
                high = Math.max(high, xyz[i]);
            }
            out[k] = (low + high) / 2;
            out[3] = Math.max(out[3], (high - low) / 2);
        }
        return out;
    }

    /** The target as such a photo would show it; null where hardly any of it would be seen. */
    private static @Nullable TargetPhoto photo(CalibrationFit fit, double[] middle, double distanceMm, int place,
            int tilt, int widthPx, int heightPx) {
        double angle = Math.toRadians(TILT_DEG);
        double[] ray = new double[3];
        int row = place / 3;
        if (!fit.choice.lens().toRay(fit.values, widthPx * (place % 3 + 0.75) / 3.5, heightPx * (row + 0.75) / 3.5,
                ray)) {
            return null;
        }
        // y of targets is up or down: the pose found first tells
        double[] like = fit.photos.get(0).rotation;
        double flip = like[8] < 0 ? Math.PI : 0;
        double[] turn = new double[9];
        double[] up = new double[9];
        double[] rotation = new double[9];
        // the left edge comes nearer where x to the right goes with z away
        Rotations.exp(tilt == 3 ? -angle : tilt == 4 ? angle : 0, tilt == 1 ? -angle : tilt == 2 ? angle : 0, 0,
                turn);
        Rotations.exp(flip, 0, 0, up);
        TargetPhoto.multiply(turn, up, rotation);
        double[] t = new double[3];
        for (int k = 0; k < 3; k++) {
            t[k] = distanceMm * ray[k] / ray[2] - rotation[3 * k] * middle[0] - rotation[3 * k + 1] * middle[1]
                    - rotation[3 * k + 2] * middle[2];
        }
        int count = fit.board.xyzMm.length / 3;
        int[] points = new int[count];
        double[] uv = new double[2 * count];
        double[] at = new double[2];
        double[] point = new double[3];
        int n = 0;
        for (int i = 0; i < count; i++) {
            fit.board.point(i, fit.values, fit.choice.lens().parameterCount(), point);
            double[] r = rotation;
            if (fit.choice.lens().project(fit.values, r[0] * point[0] + r[1] * point[1] + r[2] * point[2] + t[0],
                    r[3] * point[0] + r[4] * point[1] + r[5] * point[2] + t[1],
                    r[6] * point[0] + r[7] * point[1] + r[8] * point[2] + t[2], at, 0)
                    && at[0] > 0 && at[0] < widthPx && at[1] > 0 && at[1] < heightPx) {
                points[n] = i;
                uv[2 * n] = at[0];
                uv[2 * n++ + 1] = at[1];
            }
        }
        if (n < FEWEST_POINTS) {
            return null;
        }
        TargetPhoto photo = new TargetPhoto(new TargetObservation("", widthPx, heightPx,
                Arrays.copyOf(points, n), Arrays.copyOf(uv, 2 * n)),
                fit.points.areCornersOfMarkers() && n == count);
        System.arraycopy(rotation, 0, photo.rotation, 0, 9);
        System.arraycopy(t, 0, photo.translation, 0, 3);
        return photo;
    }
}
