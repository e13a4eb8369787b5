package org.cellgauge.cell;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.KannalaBrandtLens;
import org.cellgauge.geometry.Lens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RationalLens;
import org.cellgauge.internal.cell.CalibratedCameraText;
import org.cellgauge.internal.cell.CameraWriter;
import org.cellgauge.internal.cell.CellPhrase;
import org.cellgauge.internal.warning.Listing;
import org.jspecify.annotations.Nullable;

/** Reads the keys of BoofCV's calibration files, and those of a {@link RationalLens}, which BoofCV has not. */
final class BoofCamera {
    private static final String PINHOLE_EXAMPLE =
            "pinhole: {fx: 581, fy: 581, cx: 640, cy: 360, width: 1280, height: 720}";
    private static final String WITH_DISTORTION = BrownLens.MODEL.modelName();
    private static final String WITHOUT_DISTORTION = CameraWriter.WITHOUT_DISTORTION;
    private static final String FISHEYE = KannalaBrandtLens.MODEL.modelName();
    private static final String RATIONAL = RationalLens.MODEL.modelName();
    private static final int MAX_SYMMETRIC = 5;
    private static final String SYMMETRIC = "symmetric";
    private static final String SYMMETRIC_EXAMPLE = "symmetric: [1, k1, k2, k3, k4]";
    private static final String RATIONAL_EXAMPLE =
            "rational: {radial: [k1, k2, k3, k4, k5, k6], t1: 0, t2: 0, prism: [0, 0, 0, 0]}";
    private static final int RATIONAL_RADIAL = 6;
    private static final int PRISM = 4;

    private BoofCamera() {
    }

    /** How to write such keys. */
    static String example() {
        return PINHOLE_EXAMPLE;
    }

    /** The camera of a mapping with a calibration file's keys. */
    static PinholeCamera of(YamlMapping file) {
        String model = file.required("model", "model: " + WITH_DISTORTION).text("model: " + WITH_DISTORTION);
        boolean undistorted = model.equals(WITHOUT_DISTORTION);
        Lens lens = model.equals(FISHEYE) ? KannalaBrandtLens.MODEL
                : model.equals(RATIONAL) ? RationalLens.MODEL : BrownLens.MODEL;
        if (!undistorted && !lens.modelName().equals(model)) {
            throw file.at("model").refused(CellRefusal.CAMERA_MODEL, model,
                    Listing.or(Arrays.asList(WITH_DISTORTION, WITHOUT_DISTORTION)), FISHEYE);
        }
        List<String> known = new ArrayList<>(List.of("model", "pinhole", "version", CameraReader.TONE_CURVE,
                CameraReader.FOCUS_DISTANCE, CalibratedCameraText.KEY));
        String block = lens == KannalaBrandtLens.MODEL ? SYMMETRIC
                : lens == RationalLens.MODEL ? "rational" : "radial_tangential";
        known.add(block);
        if (lens == KannalaBrandtLens.MODEL) {
            known.addAll(List.of("radial", "radial_trig", "tangent", "tangent_trig"));
        }
        file.refuseUnknown(known);
        CameraReader.toneCurve(file.optional(CameraReader.TONE_CURVE));
        YamlValue version = file.optional("version");
        if (version != null) {
            version.whole(0, 0, CellPhrase.BOOFCV_VERSION);
        }

        YamlMapping pinhole = file.required("pinhole", PINHOLE_EXAMPLE)
                .mapping(PINHOLE_EXAMPLE, "fx", "fy", "cx", "cy", "width", "height", "skew");
        double[] k = new double[lens.parameterCount()];
        k[PinholeCamera.FX] = pinhole.required("fx", CellPhrase.FOCAL_LENGTH).positive(CellPhrase.FOCAL_LENGTH);
        k[PinholeCamera.FY] = pinhole.required("fy", CellPhrase.FOCAL_LENGTH).positive(CellPhrase.FOCAL_LENGTH);
        k[PinholeCamera.CX] = pinhole.required("cx", CellPhrase.PRINCIPAL_POINT).number(CellPhrase.PRINCIPAL_POINT);
        k[PinholeCamera.CY] = pinhole.required("cy", CellPhrase.PRINCIPAL_POINT).number(CellPhrase.PRINCIPAL_POINT);
        YamlValue skew = pinhole.optional("skew");
        k[PinholeCamera.SKEW] = skew == null ? 0 : skew.number(CellPhrase.SKEW);
        int width = pinhole.required("width", CellPhrase.IMAGE_WIDTH)
                .whole(CameraJudge.MIN_SIDE_PX, CameraJudge.MAX_SIDE_PX, CellPhrase.CALIBRATED_WIDTH);
        int height = pinhole.required("height", CellPhrase.IMAGE_HEIGHT)
                .whole(CameraJudge.MIN_SIDE_PX, CameraJudge.MAX_SIDE_PX, CellPhrase.CALIBRATED_HEIGHT);
        YamlValue distortion = file.optional(block);
        if (lens == KannalaBrandtLens.MODEL) {
            readFisheye(file, k);
        } else if (lens == RationalLens.MODEL) {
            readRational(file.required(block, RATIONAL_EXAMPLE), k);
        } else if (distortion != null && !distortion.isEmpty()) {
            if (undistorted) {
                throw distortion.refused(CellRefusal.DISTORTION_CONTRADICTS_MODEL, WITH_DISTORTION);
            }
            readDistortion(distortion, k);
        }
        return new CameraJudge(pinhole.at("fx"), pinhole.at("fy"), pinhole.at("cx"), pinhole.at("cy"),
                pinhole.at("skew"), file.at(block)).camera(lens, width, height, k);
    }

    private static void readRational(YamlValue block, double[] k) {
        YamlMapping rational = block.mapping(RATIONAL_EXAMPLE, "radial", "t1", "t2", "prism");
        double[] radial = rational.required("radial", RATIONAL_EXAMPLE).numbers(RATIONAL_RADIAL, CellPhrase.RADIAL);
        System.arraycopy(radial, 0, k, RationalLens.K1, RATIONAL_RADIAL);
        readTangential(rational, k, RationalLens.P1);
        YamlValue prism = rational.optional("prism");
        if (prism != null) {
            System.arraycopy(prism.numbers(PRISM, CellPhrase.COEFFICIENT), 0, k, RationalLens.S1, PRISM);
        }
    }

    private static void readTangential(YamlMapping distortion, double[] k, int first) {
        YamlValue t1 = distortion.optional("t1");
        YamlValue t2 = distortion.optional("t2");
        k[first] = t1 == null ? 0 : t1.number(CellPhrase.TANGENTIAL);
        k[first + 1] = t2 == null ? 0 : t2.number(CellPhrase.TANGENTIAL);
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
        readTangential(distortion, k, BrownLens.P1);
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
            k[KannalaBrandtLens.K1 + i - 1] = CameraJudge.ofAngle(coefficients.get(i), first);
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
}
