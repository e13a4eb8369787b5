package org.cellgauge.cell;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.KannalaBrandtLens;
import org.cellgauge.geometry.Lens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.cell.CalibratedCameraText;
import org.cellgauge.internal.cell.CameraWriter;
import org.cellgauge.internal.cell.CellPhrase;
import org.cellgauge.internal.cell.InputFiles;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.warning.Refusal;
import org.jspecify.annotations.Nullable;

/**
 * Reads and judges BoofCV's calibration files (YAML) of the models {@code pinhole}, {@code pinhole_radial_tangential}
 * and {@code kannala_brandt} (a fisheye); the same keys may stand in a cell file.
 *
 * <p>A key that BoofCV does not write may stand beside them: {@code tone_curve}, how the camera makes grey values of
 * light ({@code auto}, {@code srgb}, {@code linear} or {@code gamma G}). {@code skew}, the radial coefficients (up to
 * 3) and {@code t1}, {@code t2} are 0 where they are left out. Of a fisheye, {@code symmetric} holds up to 5
 * coefficients of the angle's odd powers; the first is taken into the focal lengths and the skew. Its asymmetric part
 * ({@code radial} and {@code tangent} with their {@code _trig}) is refused where it is not 0.
 */
public final class CameraReader {
    /** Largest camera file that is read, bytes. */
    public static final int MAX_BYTES = 1 << 20;

    /** The key of a camera file, and of a cell file, that states the tone curve. */
    public static final String TONE_CURVE = "tone_curve";

    private static final CellPhrase WHAT = CellPhrase.CAMERA_FILE;
    private static final String PINHOLE_EXAMPLE =
            "pinhole: {fx: 581, fy: 581, cx: 640, cy: 360, width: 1280, height: 720}";
    private static final Refusal EXAMPLE = Refusal.of(CellPhrase.CAMERA_KEYS, PINHOLE_EXAMPLE);
    private static final String WITH_DISTORTION = BrownLens.MODEL.modelName();
    private static final String WITHOUT_DISTORTION = CameraWriter.WITHOUT_DISTORTION;
    private static final String FISHEYE = KannalaBrandtLens.MODEL.modelName();
    private static final int MAX_SYMMETRIC = 5;
    private static final int BORDER_SIDES = 4;
    /** Largest coefficient of a fisheye, measured in the first one: far beyond any lens, and finite. */
    private static final int MAX_COEFFICIENT = 1_000_000;
    private static final String SYMMETRIC = "symmetric";
    private static final String SYMMETRIC_EXAMPLE = "symmetric: [1, k1, k2, k3, k4]";
    /** No marker can be read in an image that is narrower, px. */
    private static final int MIN_SIDE_PX = 16;
    private static final int MAX_SIDE_PX = 30_000;
    // 0.05 image widths is a field of view of 169 degrees, 1000 one of 0.06 degrees: no lens of this model is outside
    private static final double MIN_FOCAL_PER_SIDE = 0.05;
    private static final double MAX_FOCAL_PER_SIDE = 1000;
    private static final double MAX_FOCAL_RATIO = 3;
    /** How far from the middle the principal points of whole images are, at most, in sides. */
    private static final double MIDDLE_SHARE = 0.1;
    private static final int BORDER_POINTS = 16;
    private static final int STEPS_FROM_CENTRE = 32;

    private CameraReader() {
    }

    /**
     * Reads a camera file.
     *
     * @param file BoofCV calibration file
     * @return the camera
     * @throws InputRefusedException if it is missing, not readable, of another model or contradicts itself
     */
    public static PinholeCamera read(Path file) {
        return read(InputFiles.text(file, WHAT, MAX_BYTES), file.toString());
    }

    /**
     * Reads a camera file's text.
     *
     * @param text YAML
     * @param displayName the name that messages give it
     * @return the camera
     * @throws InputRefusedException if it is of another model or contradicts itself
     */
    public static PinholeCamera read(String text, String displayName) {
        return of(parse(text, displayName));
    }

    /**
     * What a camera file's text says of the camera's tone curve.
     *
     * @param text YAML
     * @param displayName the name that messages give it
     * @return the stated curve, or null where there is none or {@code auto}
     * @throws InputRefusedException if it is none, or not readable
     */
    public static @Nullable ToneCurve toneCurve(String text, String displayName) {
        return toneCurveOf(parse(text, displayName));
    }

    /** The value at the top of a camera file. */
    static YamlValue parse(String text, String displayName) {
        return YamlValue.parse(text, displayName, WHAT, MAX_BYTES);
    }

    /** What a mapping with a calibration file's keys says of the tone curve; null where nothing or {@code auto}. */
    static @Nullable ToneCurve toneCurveOf(YamlValue camera) {
        return toneCurve(camera.mapping(EXAMPLE).optional(TONE_CURVE));
    }

    /** The tone curve of its words; null for {@code auto} and where nothing stands. */
    static @Nullable ToneCurve toneCurve(@Nullable YamlValue value) {
        if (value == null) {
            return null;
        }
        String words = value.text(CellPhrase.TONE_CURVE).trim();
        if (words.equalsIgnoreCase("auto")) {
            return null;
        }
        try {
            return ToneCurve.of(words);
        } catch (IllegalArgumentException e) {
            Object hint = words.matches("[\\d.]+") ? Refusal.of(CellPhrase.GAMMA_HINT, words) : "";
            throw value.refused(CellRefusal.NO_TONE_CURVE, words, CellPhrase.TONE_CURVE, plain(ToneCurve.LEAST_GAMMA),
                    plain(ToneCurve.LARGEST_GAMMA), hint);
        }
    }

    /** The camera of a mapping with a calibration file's keys. */
    static PinholeCamera of(YamlValue value) {
        YamlMapping file = value.mapping(EXAMPLE);
        if (file.optional("cellgauge") != null) {
            throw file.at("cellgauge").refused(CellRefusal.IS_CELL_FILE);
        }
        String model = file.required("model", "model: " + WITH_DISTORTION).text("model: " + WITH_DISTORTION);
        boolean distorted = model.equals(WITH_DISTORTION);
        boolean fisheye = model.equals(FISHEYE);
        if (!distorted && !fisheye && !model.equals(WITHOUT_DISTORTION)) {
            throw file.at("model").refused(CellRefusal.CAMERA_MODEL, model,
                    Listing.or(Arrays.asList(WITH_DISTORTION, WITHOUT_DISTORTION)), FISHEYE);
        }
        file.refuseUnknown(fisheye
                ? Arrays.asList("model", "pinhole", SYMMETRIC, "radial", "radial_trig", "tangent", "tangent_trig",
                        "version", TONE_CURVE, CalibratedCameraText.KEY)
                : Arrays.asList("model", "pinhole", "radial_tangential", "version", TONE_CURVE,
                        CalibratedCameraText.KEY));
        toneCurve(file.optional(TONE_CURVE));
        YamlValue version = file.optional("version");
        if (version != null) {
            version.whole(0, 0, CellPhrase.BOOFCV_VERSION);
        }

        YamlMapping pinhole = file.required("pinhole", PINHOLE_EXAMPLE)
                .mapping(PINHOLE_EXAMPLE, "fx", "fy", "cx", "cy", "width", "height", "skew");
        Lens lens = fisheye ? KannalaBrandtLens.MODEL : BrownLens.MODEL;
        double[] k = new double[lens.parameterCount()];
        k[PinholeCamera.FX] = pinhole.required("fx", CellPhrase.FOCAL_LENGTH).positive(CellPhrase.FOCAL_LENGTH);
        k[PinholeCamera.FY] = pinhole.required("fy", CellPhrase.FOCAL_LENGTH).positive(CellPhrase.FOCAL_LENGTH);
        k[PinholeCamera.CX] = pinhole.required("cx", CellPhrase.PRINCIPAL_POINT).number(CellPhrase.PRINCIPAL_POINT);
        k[PinholeCamera.CY] = pinhole.required("cy", CellPhrase.PRINCIPAL_POINT).number(CellPhrase.PRINCIPAL_POINT);
        YamlValue skew = pinhole.optional("skew");
        k[PinholeCamera.SKEW] = skew == null ? 0 : skew.number(CellPhrase.SKEW);
        int width = pinhole.required("width", CellPhrase.IMAGE_WIDTH)
                .whole(MIN_SIDE_PX, MAX_SIDE_PX, CellPhrase.CALIBRATED_WIDTH);
        int height = pinhole.required("height", CellPhrase.IMAGE_HEIGHT)
                .whole(MIN_SIDE_PX, MAX_SIDE_PX, CellPhrase.CALIBRATED_HEIGHT);
        if (fisheye) {
            readFisheye(file, k);
        }
        judgePinhole(pinhole, k, width, height);
        if (fisheye) {
            PinholeCamera camera = PinholeCamera.of(lens, width, height, k);
            judgeFisheye(file.at(SYMMETRIC), camera);
            return camera;
        }

        YamlValue block = file.optional("radial_tangential");
        if (block != null && !block.isEmpty()) {
            if (!distorted) {
                throw block.refused(CellRefusal.DISTORTION_CONTRADICTS_MODEL, WITH_DISTORTION);
            }
            readDistortion(block, k);
        }
        PinholeCamera camera = PinholeCamera.of(width, height, k);
        if (camera.isDistorting()) {
            judgeDistortion(file.at("radial_tangential"), camera);
        }
        return camera;
    }

    private static void readDistortion(YamlValue block, double[] k) {
        YamlMapping distortion = block.mapping("{radial: [k1, k2], t1: 0, t2: 0}", "radial", "t1", "t2");
        YamlValue radial = distortion.optional("radial");
        if (radial != null && !radial.isEmpty()) {
            List<YamlValue> coefficients = radial.items();
            if (coefficients.size() > 3) {
                throw radial.refused(CellRefusal.TOO_MANY_COEFFICIENTS, coefficients.size());
            }
            for (int i = 0; i < coefficients.size(); i++) {
                k[BrownLens.K1 + i] = coefficients.get(i).number(CellPhrase.RADIAL);
            }
        }
        YamlValue t1 = distortion.optional("t1");
        YamlValue t2 = distortion.optional("t2");
        k[BrownLens.P1] = t1 == null ? 0 : t1.number(CellPhrase.TANGENTIAL);
        k[BrownLens.P2] = t2 == null ? 0 : t2.number(CellPhrase.TANGENTIAL);
    }

    /** The polynomial of a fisheye; its first coefficient goes into the scale of the image. */
    private static void readFisheye(YamlMapping file, double[] k) {
        for (String part : new String[] {"radial", "tangent"}) {
            if (holdsMoreThanZeros(file.optional(part)) && holdsMoreThanZeros(file.optional(part + "_trig"))) {
                throw file.at(part).refused(CellRefusal.ASYMMETRIC_LENS);
            }
        }
        YamlValue symmetric = file.required(SYMMETRIC, SYMMETRIC_EXAMPLE);
        List<YamlValue> coefficients = symmetric.items();
        if (coefficients.isEmpty() || coefficients.size() > MAX_SYMMETRIC) {
            throw symmetric.refused(CellRefusal.SYMMETRIC_COEFFICIENTS, MAX_SYMMETRIC, coefficients.size(),
                    MAX_SYMMETRIC);
        }
        double first = coefficients.get(0).positive(CellPhrase.COEFFICIENT_OF_ANGLE);
        for (int i = 1; i < coefficients.size(); i++) {
            double coefficient = coefficients.get(i).number(CellPhrase.SYMMETRIC) / first;
            if (!(Math.abs(coefficient) <= MAX_COEFFICIENT)) {
                throw coefficients.get(i).refused(CellRefusal.OUT_OF_RANGE, -MAX_COEFFICIENT, MAX_COEFFICIENT,
                        plain(coefficient), CellPhrase.SYMMETRIC);
            }
            k[KannalaBrandtLens.K1 + i - 1] = coefficient;
        }
        k[PinholeCamera.FX] *= first;
        k[PinholeCamera.FY] *= first;
        k[PinholeCamera.SKEW] *= first;
    }

    private static boolean holdsMoreThanZeros(@Nullable YamlValue list) {
        if (list == null || list.isEmpty()) {
            return false;
        }
        boolean any = false;
        for (YamlValue value : list.items()) {
            any |= value.number(CellPhrase.COEFFICIENT) != 0;
        }
        return any;
    }

    /**
     * Refuses a polynomial that turns back within the image before it reaches a right angle. Beyond that it may: a lens
     * shows a disc there, and the image's corners are black.
     */
    private static void judgeFisheye(YamlValue symmetric, PinholeCamera camera) {
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
                throw symmetric.refused(CellRefusal.FISHEYE_TURNS_BACK, (int) Math.round(Math.toDegrees(reach)),
                        (int) Math.round(uv[0]), (int) Math.round(uv[1]));
            }
        }
    }

    private static void judgePinhole(YamlMapping pinhole, double[] k, int width, int height) {
        int side = Math.max(width, height);
        for (String key : new String[] {"fx", "fy"}) {
            double f = k[key.equals("fx") ? PinholeCamera.FX : PinholeCamera.FY];
            if (!(f >= MIN_FOCAL_PER_SIDE * side && f <= MAX_FOCAL_PER_SIDE * side)) {
                throw pinhole.at(key).refused(CellRefusal.FOCAL_LENGTH, plain(f), width, height);
            }
        }
        double ratio = k[PinholeCamera.FX] / k[PinholeCamera.FY];
        if (!(ratio <= MAX_FOCAL_RATIO && ratio >= 1 / MAX_FOCAL_RATIO)) {
            throw pinhole.at("fy").refused(CellRefusal.FOCAL_LENGTHS_DIFFER, plain(k[PinholeCamera.FX]),
                    plain(k[PinholeCamera.FY]));
        }
        judgePrincipalPoint(pinhole, "cx", k[PinholeCamera.CX], width, CellPhrase.WIDTH);
        judgePrincipalPoint(pinhole, "cy", k[PinholeCamera.CY], height, CellPhrase.HEIGHT);
        if (isMiddle(k[PinholeCamera.CX], height) && isMiddle(k[PinholeCamera.CY], width)
                && !isMiddle(k[PinholeCamera.CX], width) && !isMiddle(k[PinholeCamera.CY], height)) {
            throw pinhole.at("cx").refused(CellRefusal.PRINCIPAL_POINT_TURNED, plain(k[PinholeCamera.CX]),
                    plain(k[PinholeCamera.CY]), height, width);
        }
        if (k[PinholeCamera.CX] == 0 && k[PinholeCamera.CY] == 0) {
            throw pinhole.at("cx").refused(CellRefusal.PRINCIPAL_POINT_ZERO);
        }
        if (Math.abs(k[PinholeCamera.SKEW]) > 0.5 * k[PinholeCamera.FX]) {
            throw pinhole.at("skew").refused(CellRefusal.SKEW, plain(k[PinholeCamera.SKEW]));
        }
    }

    private static boolean isMiddle(double c, int side) {
        return Math.abs(c / side - 0.5) <= MIDDLE_SHARE;
    }

    private static void judgePrincipalPoint(YamlMapping pinhole, String key, double c, int side, CellPhrase name) {
        // a part cut out of a larger image may have its principal point outside, but not by more than its own size
        if (!(c >= -side && c <= 2.0 * side)) {
            throw pinhole.at(key).refused(CellRefusal.PRINCIPAL_POINT_OUTSIDE, plain(c), name, side);
        }
    }

    /** Refuses a distortion that shows two directions at one pixel of the image: such a lens model has no inverse. */
    private static void judgeDistortion(YamlValue block, PinholeCamera camera) {
        double[] point = new double[2];
        for (int i = 0; i < BORDER_POINTS; i++) {
            double s = i / (double) BORDER_POINTS;
            double w = camera.widthPx();
            double h = camera.heightPx();
            double[][] border = {{s * w, 0}, {w, s * h}, {w - s * w, h}, {0, h - s * h}};
            for (double[] uv : border) {
                if (!camera.toNormalised(uv[0], uv[1], point) || foldsBefore(camera, point)) {
                    throw block.refused(CellRefusal.DISTORTION_FOLDS, (int) Math.round(uv[0]),
                            (int) Math.round(uv[1]));
                }
            }
        }
    }

    private static boolean foldsBefore(PinholeCamera camera, double[] point) {
        double[] uv = new double[2];
        double[] d = new double[6];
        for (int i = 1; i <= STEPS_FROM_CENTRE; i++) {
            double s = i / (double) STEPS_FROM_CENTRE;
            camera.lens().projectWithDerivatives(camera.intrinsics(), s * point[0], s * point[1], 1, uv, d, null);
            // rows of the 2x3 derivative; at z = 1 the first two columns are those by the normalised point
            if (!(d[0] * d[4] - d[1] * d[3] > 0)) {
                return true;
            }
        }
        return false;
    }

    /**
     * A number as a person would write it.
     *
     * @param value any, NaN included
     * @return without a decimal point where it is whole and below 10^15
     */
    public static String plain(double value) {
        if (value == Math.rint(value) && Math.abs(value) < 1e15) {
            return String.valueOf((long) value);
        }
        return String.valueOf(value);
    }
}
