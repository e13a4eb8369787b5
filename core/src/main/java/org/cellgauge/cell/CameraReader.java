package org.cellgauge.cell;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.Projection;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.warning.Listing;
import org.cellgauge.warning.Refusal;

/**
 * Reads and judges BoofCV's calibration files (YAML) of the models {@code pinhole} and
 * {@code pinhole_radial_tangential}; the same keys may stand in a cell file.
 *
 * <p>A key that BoofCV does not write may stand beside them: {@code tone_curve}, how the camera makes grey values of
 * light ({@code auto}, {@code srgb}, {@code linear} or {@code gamma G}). {@code skew}, the radial coefficients (up to
 * 3) and {@code t1}, {@code t2} are 0 where they are left out.
 */
public final class CameraReader {
    /** Largest camera file that is read, bytes. */
    public static final int MAX_BYTES = 1 << 20;

    /** The key of a camera file, and of a cell file, that states the tone curve. */
    static final String TONE_CURVE = "tone_curve";

    private static final CellPhrase WHAT = CellPhrase.CAMERA_FILE;
    private static final String PINHOLE_EXAMPLE =
            "pinhole: {fx: 581, fy: 581, cx: 640, cy: 360, width: 1280, height: 720}";
    private static final Refusal EXAMPLE = Refusal.of(CellPhrase.CAMERA_KEYS, PINHOLE_EXAMPLE);
    private static final String WITH_DISTORTION = "pinhole_radial_tangential";
    private static final String WITHOUT_DISTORTION = "pinhole";
    private static final int MAX_SIDE_PX = 30_000;
    // 0.05 image widths is a field of view of 169 degrees, 1000 one of 0.06 degrees: no lens of this model is outside
    private static final double MIN_FOCAL_PER_SIDE = 0.05;
    private static final double MAX_FOCAL_PER_SIDE = 1000;
    private static final double MAX_FOCAL_RATIO = 3;
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
        return of(YamlValue.parse(text, displayName, WHAT, MAX_BYTES));
    }

    /**
     * What a camera file's text says of the camera's tone curve.
     *
     * @param text YAML
     * @param displayName the name that messages give it
     * @return the stated curve, or null where there is none or {@code auto}
     * @throws InputRefusedException if it is none, or not readable
     */
    public static ToneCurve toneCurve(String text, String displayName) {
        return toneCurveOf(YamlValue.parse(text, displayName, WHAT, MAX_BYTES));
    }

    /** What a mapping with a calibration file's keys says of the tone curve; null where nothing or {@code auto}. */
    static ToneCurve toneCurveOf(YamlValue camera) {
        return toneCurve(camera.mapping(EXAMPLE).optional(TONE_CURVE));
    }

    /** The tone curve of its words; null for {@code auto} and where nothing stands. */
    static ToneCurve toneCurve(YamlValue value) {
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
            throw file.optional("cellgauge").refused(CellRefusal.IS_CELL_FILE);
        }
        String model = file.required("model", "model: " + WITH_DISTORTION).text("model: " + WITH_DISTORTION);
        boolean distorted = model.equals(WITH_DISTORTION);
        if (!distorted && !model.equals(WITHOUT_DISTORTION)) {
            throw file.optional("model").refused(CellRefusal.CAMERA_MODEL, model,
                    Listing.or(Arrays.asList(WITH_DISTORTION, WITHOUT_DISTORTION)));
        }
        file.refuseUnknown(Arrays.asList("model", "pinhole", "radial_tangential", "version", TONE_CURVE));
        toneCurve(file.optional(TONE_CURVE));
        YamlValue version = file.optional("version");
        if (version != null) {
            version.whole(0, 0, CellPhrase.BOOFCV_VERSION);
        }

        YamlMapping pinhole = file.required("pinhole", PINHOLE_EXAMPLE)
                .mapping(PINHOLE_EXAMPLE, "fx", "fy", "cx", "cy", "width", "height", "skew");
        double[] k = new double[PinholeCamera.INTRINSICS];
        k[PinholeCamera.FX] = pinhole.required("fx", CellPhrase.FOCAL_LENGTH).positive(CellPhrase.FOCAL_LENGTH);
        k[PinholeCamera.FY] = pinhole.required("fy", CellPhrase.FOCAL_LENGTH).positive(CellPhrase.FOCAL_LENGTH);
        k[PinholeCamera.CX] = pinhole.required("cx", CellPhrase.PRINCIPAL_POINT).number(CellPhrase.PRINCIPAL_POINT);
        k[PinholeCamera.CY] = pinhole.required("cy", CellPhrase.PRINCIPAL_POINT).number(CellPhrase.PRINCIPAL_POINT);
        YamlValue skew = pinhole.optional("skew");
        k[PinholeCamera.SKEW] = skew == null ? 0 : skew.number(CellPhrase.SKEW);
        int width = pinhole.required("width", CellPhrase.IMAGE_WIDTH)
                .whole(1, MAX_SIDE_PX, CellPhrase.CALIBRATED_WIDTH);
        int height = pinhole.required("height", CellPhrase.IMAGE_HEIGHT)
                .whole(1, MAX_SIDE_PX, CellPhrase.CALIBRATED_HEIGHT);
        judgePinhole(pinhole, k, width, height);

        YamlValue block = file.optional("radial_tangential");
        if (block != null && !block.isEmpty()) {
            if (!distorted) {
                throw block.refused(CellRefusal.DISTORTION_CONTRADICTS_MODEL, WITH_DISTORTION);
            }
            readDistortion(block, k);
        }
        PinholeCamera camera = PinholeCamera.of(width, height, k);
        if (camera.hasDistortion()) {
            judgeDistortion(block, camera);
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
                k[PinholeCamera.K1 + i] = coefficients.get(i).number(CellPhrase.RADIAL);
            }
        }
        YamlValue t1 = distortion.optional("t1");
        YamlValue t2 = distortion.optional("t2");
        k[PinholeCamera.P1] = t1 == null ? 0 : t1.number(CellPhrase.TANGENTIAL);
        k[PinholeCamera.P2] = t2 == null ? 0 : t2.number(CellPhrase.TANGENTIAL);
    }

    private static void judgePinhole(YamlMapping pinhole, double[] k, int width, int height) {
        int side = Math.max(width, height);
        for (String key : new String[] {"fx", "fy"}) {
            double f = k[key.equals("fx") ? PinholeCamera.FX : PinholeCamera.FY];
            if (!(f >= MIN_FOCAL_PER_SIDE * side && f <= MAX_FOCAL_PER_SIDE * side)) {
                throw pinhole.optional(key).refused(CellRefusal.FOCAL_LENGTH, plain(f), width, height);
            }
        }
        double ratio = k[PinholeCamera.FX] / k[PinholeCamera.FY];
        if (!(ratio <= MAX_FOCAL_RATIO && ratio >= 1 / MAX_FOCAL_RATIO)) {
            throw pinhole.optional("fy").refused(CellRefusal.FOCAL_LENGTHS_DIFFER, plain(k[PinholeCamera.FX]),
                    plain(k[PinholeCamera.FY]));
        }
        judgePrincipalPoint(pinhole, "cx", k[PinholeCamera.CX], width, CellPhrase.WIDTH);
        judgePrincipalPoint(pinhole, "cy", k[PinholeCamera.CY], height, CellPhrase.HEIGHT);
        if (k[PinholeCamera.CX] == 0 && k[PinholeCamera.CY] == 0) {
            throw pinhole.optional("cx").refused(CellRefusal.PRINCIPAL_POINT_ZERO);
        }
        if (Math.abs(k[PinholeCamera.SKEW]) > 0.5 * k[PinholeCamera.FX]) {
            throw pinhole.optional("skew").refused(CellRefusal.SKEW, plain(k[PinholeCamera.SKEW]));
        }
    }

    private static void judgePrincipalPoint(YamlMapping pinhole, String key, double c, int side, CellPhrase name) {
        // a part cut out of a larger image may have its principal point outside, but not by more than its own size
        if (!(c >= -side && c <= 2.0 * side)) {
            throw pinhole.optional(key).refused(CellRefusal.PRINCIPAL_POINT_OUTSIDE, plain(c), name, side);
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
            Projection.projectWithDerivatives(camera.intrinsics(), s * point[0], s * point[1], 1, uv, d, null);
            // rows of the 2x3 derivative; at z = 1 the first two columns are those by the normalised point
            if (!(d[0] * d[4] - d[1] * d[3] > 0)) {
                return true;
            }
        }
        return false;
    }

    /** A number as a person would write it. */
    static String plain(double value) {
        if (value == Math.rint(value) && Math.abs(value) < 1e15) {
            return String.valueOf((long) value);
        }
        return String.valueOf(value);
    }
}
