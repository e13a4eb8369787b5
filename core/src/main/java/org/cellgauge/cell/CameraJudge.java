package org.cellgauge.cell;

import org.cellgauge.geometry.KannalaBrandtLens;
import org.cellgauge.geometry.Lens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.cell.CellPhrase;
import org.cellgauge.internal.geometry.Lenses;

/**
 * Refuses cameras that cannot be: values that no lens has, and distortion that shows one pixel twice within the image.
 *
 * @param fx where the focal length in x stands, for the refusal; the others likewise
 */
record CameraJudge(YamlValue fx, YamlValue fy, YamlValue cx, YamlValue cy, YamlValue skew, YamlValue lens) {
    /** No marker can be read in an image that is narrower, px. */
    static final int MIN_SIDE_PX = 16;
    static final int MAX_SIDE_PX = 30_000;
    /** Largest coefficient of a fisheye, measured in the first one: far beyond any lens, and finite. */
    private static final int MAX_COEFFICIENT = 1_000_000;
    private static final int BORDER_SIDES = 4;
    // 0.05 image widths is a field of view of 169 degrees, 1000 one of 0.06 degrees: no lens of this model is outside
    private static final double MIN_FOCAL_PER_SIDE = 0.05;
    private static final double MAX_FOCAL_PER_SIDE = 1000;
    private static final double MAX_FOCAL_RATIO = 3;
    /** How far from the middle the principal points of whole images are, at most, in sides. */
    private static final double MIDDLE_SHARE = 0.1;

    /**
     * The camera of values that can be.
     *
     * @param model its lens
     * @param width of its images, px
     * @param height of its images, px
     * @param values of the lens's parameters, finite
     * @throws InputRefusedException if no camera has them
     */
    PinholeCamera camera(Lens model, int width, int height, double[] values) {
        judgePinhole(values, width, height);
        PinholeCamera camera = PinholeCamera.of(model, width, height, values);
        if (model == KannalaBrandtLens.MODEL) {
            judgeFisheye(camera);
        } else if (camera.isDistorting()) {
            judgeDistortion(camera);
        }
        return camera;
    }

    /** A coefficient of a fisheye's polynomial, as a share of the first one. */
    static double ofAngle(YamlValue value, double first) {
        double coefficient = value.number(CellPhrase.SYMMETRIC) / first;
        if (!(Math.abs(coefficient) <= MAX_COEFFICIENT)) {
            throw value.refused(CellRefusal.OUT_OF_RANGE, -MAX_COEFFICIENT, MAX_COEFFICIENT, plain(coefficient),
                    CellPhrase.SYMMETRIC);
        }
        return coefficient;
    }

    private void judgePinhole(double[] k, int width, int height) {
        int side = Math.max(width, height);
        judgeFocal(fx, k[PinholeCamera.FX], side, width, height);
        judgeFocal(fy, k[PinholeCamera.FY], side, width, height);
        double ratio = k[PinholeCamera.FX] / k[PinholeCamera.FY];
        if (!(ratio <= MAX_FOCAL_RATIO && ratio >= 1 / MAX_FOCAL_RATIO)) {
            throw fy.refused(CellRefusal.FOCAL_LENGTHS_DIFFER, plain(k[PinholeCamera.FX]), plain(k[PinholeCamera.FY]));
        }
        judgePrincipalPoint(cx, k[PinholeCamera.CX], width, CellPhrase.WIDTH);
        judgePrincipalPoint(cy, k[PinholeCamera.CY], height, CellPhrase.HEIGHT);
        if (isMiddle(k[PinholeCamera.CX], height) && isMiddle(k[PinholeCamera.CY], width)
                && !isMiddle(k[PinholeCamera.CX], width) && !isMiddle(k[PinholeCamera.CY], height)) {
            throw cx.refused(CellRefusal.PRINCIPAL_POINT_TURNED, plain(k[PinholeCamera.CX]),
                    plain(k[PinholeCamera.CY]), height, width);
        }
        if (k[PinholeCamera.CX] == 0 && k[PinholeCamera.CY] == 0) {
            throw cx.refused(CellRefusal.PRINCIPAL_POINT_ZERO);
        }
        if (Math.abs(k[PinholeCamera.SKEW]) > 0.5 * k[PinholeCamera.FX]) {
            throw skew.refused(CellRefusal.SKEW, plain(k[PinholeCamera.SKEW]));
        }
    }

    private static void judgeFocal(YamlValue place, double f, int side, int width, int height) {
        if (!(f >= MIN_FOCAL_PER_SIDE * side && f <= MAX_FOCAL_PER_SIDE * side)) {
            throw place.refused(CellRefusal.FOCAL_LENGTH, plain(f), width, height);
        }
    }

    private static boolean isMiddle(double c, int side) {
        return Math.abs(c / side - 0.5) <= MIDDLE_SHARE;
    }

    private static void judgePrincipalPoint(YamlValue place, double c, int side, CellPhrase name) {
        // a part cut out of a larger image may have its principal point outside, but not by more than its own size
        if (!(c >= -side && c <= 2.0 * side)) {
            throw place.refused(CellRefusal.PRINCIPAL_POINT_OUTSIDE, plain(c), name, side);
        }
    }

    /**
     * Refuses a polynomial that turns back within the image before it reaches a right angle. Beyond that it may: a lens
     * shows a disc there, and the image's corners are black.
     */
    private void judgeFisheye(PinholeCamera camera) {
        double[] values = camera.intrinsics();
        double reach = camera.lens().reachRad(values);
        if (reach >= Math.PI / 2) {
            return;
        }
        double[] uv = new double[2];
        for (int i = 0; i < BORDER_SIDES; i++) {
            double c = Math.cos(i * Math.PI / 2);
            double s = Math.sin(i * Math.PI / 2);
            camera.lens().project(values, Math.sin(reach) * c, Math.sin(reach) * s, Math.cos(reach), uv, 0);
            if (uv[0] >= 0 && uv[1] >= 0 && uv[0] <= camera.widthPx() && uv[1] <= camera.heightPx()) {
                throw lens.refused(CellRefusal.FISHEYE_TURNS_BACK, (int) Math.round(Math.toDegrees(reach)),
                        (int) Math.round(uv[0]), (int) Math.round(uv[1]));
            }
        }
    }

    /** Refuses a distortion that shows two directions at one pixel of the image: such a lens model has no inverse. */
    private void judgeDistortion(PinholeCamera camera) {
        double[] fold = Lenses.foldWithin(camera);
        if (fold != null) {
            throw lens.refused(CellRefusal.DISTORTION_FOLDS, (int) Math.round(fold[0]), (int) Math.round(fold[1]));
        }
    }

    private static String plain(double value) {
        return CameraReader.plain(value);
    }
}
