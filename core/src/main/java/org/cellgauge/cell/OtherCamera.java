package org.cellgauge.cell;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.KannalaBrandtLens;
import org.cellgauge.geometry.Lens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RationalLens;
import org.cellgauge.internal.cell.CellPhrase;
import org.cellgauge.internal.warning.Listing;
import org.jspecify.annotations.Nullable;

/**
 * Cameras as other programs write them. Keys that say nothing of the camera itself may stand beside those that are
 * read: such files hold much else. What is asked of each form stands in its method; all of them end in the lens models
 * of OpenCV (k1, k2, p1, p2, k3, k4, k5, k6, s1, s2, s3, s4, tau x, tau y), or are a fisheye of Kannala and Brandt.
 */
final class OtherCamera {
    private static final List<String> MATRIX = List.of("camera_matrix", "Camera_Matrix", "cameraMatrix", "K", "k");
    private static final List<String> DISTORTION = List.of("distortion_coefficients", "Distortion_Coefficients",
            "distCoeffs", "dist_coeffs", "D", "d");
    private static final List<String> WIDTH = List.of("image_width", "image_Width", "width");
    private static final List<String> HEIGHT = List.of("image_height", "image_Height", "height");
    private static final List<String> DEVIATIONS = List.of("std_intrinsics", "std_deviations_intrinsics",
            "stdDeviationsIntrinsics");
    private static final String MATRIX_EXAMPLE = "{rows: 3, cols: 3, data: [fx, 0, cx, 0, fy, cy, 0, 0, 1]}";
    private static final String FOUR_EXAMPLE = "[fx, fy, cx, cy]";
    private static final String SIZE_EXAMPLE = "[1280, 720]";
    private static final int NINE = 9;
    /** Coefficients of OpenCV's model up to the thin prism, which is all but the tilt of the sensor. */
    private static final int UP_TO_PRISM = 12;
    private static final List<Integer> COUNTS = List.of(4, 5, 8, UP_TO_PRISM, UP_TO_PRISM + 2);
    private static final int FISHEYE_COUNT = 4;

    /** What bends the rays, by the words of the files. */
    private enum Bend {
        OPENCV, FISHEYE
    }

    private final CameraFormat format;
    private final YamlMapping file;
    private int width;
    private int height;
    /** fx, fy, cx, cy, skew as they stand in the file, px, and where. */
    private final double[] pinhole = new double[5];
    private final YamlValue[] places = new YamlValue[5];
    private Bend bend = Bend.OPENCV;
    private List<YamlValue> coefficients = List.of();
    private YamlValue lensPlace;

    private OtherCamera(YamlMapping file, CameraFormat format) {
        this.file = file;
        this.format = format;
        this.lensPlace = file.self();
        Arrays.fill(places, file.self());
    }

    /** Whether a mapping has the matrix of OpenCV's and ROS's files. */
    static boolean hasMatrix(YamlMapping file) {
        return first(file, MATRIX) != null;
    }

    /** Whether a mapping states deviations of its intrinsics without what they share, as OpenCV's calibration gives. */
    static boolean statesDeviationsAlone(YamlMapping file) {
        return first(file, DEVIATIONS) != null;
    }

    private static @Nullable YamlValue first(YamlMapping file, List<String> keys) {
        for (String key : keys) {
            YamlValue value = file.optional(key);
            if (value != null) {
                return value;
            }
        }
        return null;
    }

    /**
     * The camera of a mapping in the form of another program.
     *
     * @throws InputRefusedException if something is missing or cannot be, or the lens is none of ours
     */
    static PinholeCamera of(YamlMapping file, CameraFormat format) {
        OtherCamera camera = new OtherCamera(file, format);
        switch (format) {
            case OPENCV, ROS -> camera.readMatrices();
            case KALIBR -> camera.readKalibr();
            case PHOTONVISION -> camera.readPhotonVision();
            case REALSENSE -> camera.readRealSense();
            case MRCAL -> camera.readMrcal();
            default -> throw new IllegalArgumentException("not of another program: " + format);
        }
        return camera.camera();
    }

    /** OpenCV's FileStorage of its calibration sample, and ROS's camera_info as file and as printed message. */
    private void readMatrices() {
        YamlValue size = file.optional("image_size");
        if (size != null) {
            readSize(size);
        } else {
            width = side(required(WIDTH, CellPhrase.IMAGE_WIDTH), CellPhrase.CALIBRATED_WIDTH);
            height = side(required(HEIGHT, CellPhrase.IMAGE_HEIGHT), CellPhrase.CALIBRATED_HEIGHT);
        }
        readMatrix(required(MATRIX, MATRIX_EXAMPLE));
        YamlValue distortion = first(file, DISTORTION);
        if (distortion != null && !distortion.isEmpty()) {
            lensPlace = distortion;
            coefficients = entries(distortion);
        }
        // the key of OpenCV's calibration sample
        YamlValue fisheye = file.optional("fisheye_model");
        if (fisheye != null && fisheye.is("1")) {
            bend = Bend.FISHEYE;
        }
        YamlValue model = file.optional("distortion_model");
        if (model != null && !model.isEmpty()) {
            switch (model.text("plumb_bob")) {
                case "plumb_bob", "rational_polynomial", "thin_prism" -> bend = Bend.OPENCV;
                case "equidistant", "fisheye" -> bend = Bend.FISHEYE;
                default -> throw noLens(model, "plumb_bob", "rational_polynomial", "equidistant");
            }
        }
    }

    /** Kalibr: models of camera and distortion by name, their values as lists. */
    private void readKalibr() {
        YamlValue model = file.required("camera_model", "camera_model: pinhole");
        if (!model.is("pinhole")) {
            throw noLens(model, "pinhole");
        }
        readSize(file.required("resolution", "resolution: " + SIZE_EXAMPLE));
        readFour(file.required("intrinsics", FOUR_EXAMPLE), FISHEYE_COUNT);
        YamlValue distortion = file.optional("distortion_model");
        if (distortion == null || distortion.is("none")) {
            return;
        }
        switch (distortion.text("radtan")) {
            case "radtan" -> bend = Bend.OPENCV;
            case "equidistant" -> bend = Bend.FISHEYE;
            default -> throw noLens(distortion, "radtan", "equidistant");
        }
        lensPlace = file.required("distortion_coeffs", "distortion_coeffs: [k1, k2, p1, p2]");
        coefficients = lensPlace.items();
    }

    private void readPhotonVision() {
        YamlMapping resolution = file.required("resolution", "{\"width\": 1280, \"height\": 720}")
                .mapping("{\"width\": 1280, \"height\": 720}");
        width = side(resolution.required("width", CellPhrase.IMAGE_WIDTH), CellPhrase.CALIBRATED_WIDTH);
        height = side(resolution.required("height", CellPhrase.IMAGE_HEIGHT), CellPhrase.CALIBRATED_HEIGHT);
        readMatrix(file.required("cameraIntrinsics", MATRIX_EXAMPLE));
        YamlValue model = file.optional("lensmodel");
        if (model != null && !model.isEmpty() && !model.text("LENSMODEL_OPENCV").startsWith("LENSMODEL_OPENCV")) {
            throw noLens(model, "LENSMODEL_OPENCV");
        }
        lensPlace = file.required("distCoeffs", "{rows: 1, cols: 5, data: [k1, k2, p1, p2, k3]}");
        coefficients = entries(lensPlace);
    }

    /**
     * librealsense. Its plain Brown-Conrady is that of OpenCV. Its "modified" one bends tangentially by what was bent
     * radially already, so that the two are one only without tangential coefficients, and its "inverse" one goes from
     * the image to the direction: both are read where they come to the same (rsutil.h of librealsense).
     */
    private void readRealSense() {
        width = side(file.required("width", CellPhrase.IMAGE_WIDTH), CellPhrase.CALIBRATED_WIDTH);
        height = side(file.required("height", CellPhrase.IMAGE_HEIGHT), CellPhrase.CALIBRATED_HEIGHT);
        String[] keys = {"fx", "fy", "ppx", "ppy"};
        for (int i = 0; i < keys.length; i++) {
            Object remedy = i <= PinholeCamera.FY ? CellPhrase.FOCAL_LENGTH : CellPhrase.PRINCIPAL_POINT;
            set(i, file.required(keys[i], remedy), remedy);
        }
        lensPlace = file.required("coeffs", "\"coeffs\": [k1, k2, p1, p2, k3]");
        coefficients = lensPlace.items();
        YamlValue model = file.required("model", "\"model\": \"brown_conrady\"");
        String name = model.text("brown_conrady").toLowerCase(Locale.ROOT).replace(' ', '_')
                .replaceFirst("^(rs2_)?distortion[._]", "");
        boolean bends = false;
        for (YamlValue coefficient : coefficients) {
            bends |= coefficient.number(CellPhrase.COEFFICIENT) != 0;
        }
        boolean tangential = coefficients.size() > 3 && (coefficients.get(2).number(CellPhrase.TANGENTIAL) != 0
                || coefficients.get(3).number(CellPhrase.TANGENTIAL) != 0);
        if (!bends) {
            coefficients = List.of();
        } else if (name.equals("kannala_brandt4")) {
            bend = Bend.FISHEYE;
            coefficients = coefficients.subList(0, Math.min(FISHEYE_COUNT, coefficients.size()));
        } else if (name.equals("inverse_brown_conrady")) {
            throw model.refused(CellRefusal.LENS_OTHER_WAY_ROUND, name);
        } else if (!name.equals("brown_conrady") && !(name.equals("modified_brown_conrady") && !tangential)) {
            throw noLens(model, "none", "brown_conrady", "kannala_brandt4");
        }
    }

    private void readMrcal() {
        readSize(file.required("imagersize", "'imagersize': " + SIZE_EXAMPLE));
        YamlValue model = file.required("lensmodel", "'lensmodel': 'LENSMODEL_OPENCV8'");
        String name = model.text("LENSMODEL_OPENCV8");
        YamlValue values = file.required("intrinsics", FOUR_EXAMPLE);
        int count = switch (name) {
            case "LENSMODEL_PINHOLE" -> 0;
            case "LENSMODEL_OPENCV4" -> 4;
            case "LENSMODEL_OPENCV5" -> 5;
            case "LENSMODEL_OPENCV8" -> 8;
            case "LENSMODEL_OPENCV12" -> UP_TO_PRISM;
            default -> throw noLens(model, "LENSMODEL_PINHOLE", "LENSMODEL_OPENCV4", "LENSMODEL_OPENCV5",
                    "LENSMODEL_OPENCV8", "LENSMODEL_OPENCV12");
        };
        readFour(values, FISHEYE_COUNT + count);
        lensPlace = values;
        coefficients = values.items().subList(FISHEYE_COUNT, FISHEYE_COUNT + count);
    }

    private static InputRefusedException noLens(YamlValue model, String... known) {
        return model.refused(CellRefusal.LENS_OF_ANOTHER, model.text(known[0]), Listing.or(Arrays.asList(known)));
    }

    private YamlValue required(List<String> keys, Object remedy) {
        YamlValue value = first(file, keys);
        return value != null ? value : file.required(keys.get(0), remedy);
    }

    private void readSize(YamlValue size) {
        List<YamlValue> sides = size.items();
        size.numbers(2, SIZE_EXAMPLE);
        width = side(sides.get(0), CellPhrase.CALIBRATED_WIDTH);
        height = side(sides.get(1), CellPhrase.CALIBRATED_HEIGHT);
    }

    /** A side of the image, which some programs write as 1280.0. */
    private static int side(YamlValue value, CellPhrase remedy) {
        double side = value.number(remedy);
        if (side != Math.rint(side) || !(side >= CameraJudge.MIN_SIDE_PX && side <= CameraJudge.MAX_SIDE_PX)) {
            return value.whole(CameraJudge.MIN_SIDE_PX, CameraJudge.MAX_SIDE_PX, remedy);
        }
        return (int) side;
    }

    private void set(int index, YamlValue place, Object remedy) {
        places[index] = place;
        pinhole[index] = index <= PinholeCamera.FY ? place.positive(remedy) : place.number(remedy);
    }

    private void readFour(YamlValue values, int count) {
        values.numbers(count, FOUR_EXAMPLE);
        List<YamlValue> items = values.items();
        for (int i = 0; i < FISHEYE_COUNT; i++) {
            set(i, items.get(i), FOUR_EXAMPLE);
        }
    }

    /** Rows of a matrix as OpenCV stores it, as a list of rows or as one list. */
    private static List<YamlValue> entries(YamlValue matrix) {
        if (matrix.isMapping()) {
            return matrix.mapping(MATRIX_EXAMPLE).required("data", MATRIX_EXAMPLE).items();
        }
        List<YamlValue> entries = new ArrayList<>();
        for (YamlValue row : matrix.items()) {
            entries.addAll(row.isList() ? row.items() : Collections.singletonList(row));
        }
        return entries;
    }

    private void readMatrix(YamlValue matrix) {
        List<YamlValue> entries = entries(matrix);
        if (entries.size() != NINE) {
            throw matrix.refused(CellRefusal.NO_CAMERA_MATRIX);
        }
        double[] rest = {entries.get(3).number(MATRIX_EXAMPLE), entries.get(6).number(MATRIX_EXAMPLE),
            entries.get(7).number(MATRIX_EXAMPLE), entries.get(8).number(MATRIX_EXAMPLE)};
        if (rest[0] != 0 || rest[1] != 0 || rest[2] != 0 || rest[3] != 1) {
            throw matrix.refused(CellRefusal.NO_CAMERA_MATRIX);
        }
        set(PinholeCamera.FX, entries.get(0), CellPhrase.FOCAL_LENGTH);
        set(PinholeCamera.SKEW, entries.get(1), CellPhrase.SKEW);
        set(PinholeCamera.CX, entries.get(2), CellPhrase.PRINCIPAL_POINT);
        set(PinholeCamera.FY, entries.get(4), CellPhrase.FOCAL_LENGTH);
        set(PinholeCamera.CY, entries.get(5), CellPhrase.PRINCIPAL_POINT);
    }

    private PinholeCamera camera() {
        Lens lens = bend == Bend.FISHEYE ? KannalaBrandtLens.MODEL : BrownLens.MODEL;
        double[] bent = {};
        if (bend == Bend.FISHEYE && !coefficients.isEmpty()) {
            if (coefficients.size() != FISHEYE_COUNT) {
                throw lensPlace.refused(CellRefusal.COEFFICIENTS, FISHEYE_COUNT, coefficients.size());
            }
            bent = coefficients.stream().mapToDouble(c -> CameraJudge.ofAngle(c, 1)).toArray();
        } else if (!coefficients.isEmpty()) {
            double[] c = openCvCoefficients();
            boolean rational = false;
            for (int i = 5; i < UP_TO_PRISM; i++) {
                rational |= c[i] != 0;
            }
            lens = rational ? RationalLens.MODEL : BrownLens.MODEL;
            bent = rational ? new double[] {c[0], c[1], c[4], c[5], c[6], c[7], c[2], c[3], c[8], c[9], c[10], c[11]}
                    : new double[] {c[0], c[1], c[4], c[2], c[3]};
        }
        double[] values = new double[lens.parameterCount()];
        System.arraycopy(pinhole, 0, values, 0, pinhole.length);
        System.arraycopy(bent, 0, values, pinhole.length, bent.length);
        values[PinholeCamera.CX] += format.principalPointShiftPx();
        values[PinholeCamera.CY] += format.principalPointShiftPx();
        return new CameraJudge(places[PinholeCamera.FX], places[PinholeCamera.FY], places[PinholeCamera.CX],
                places[PinholeCamera.CY], places[PinholeCamera.SKEW], lensPlace).camera(lens, width, height, values);
    }

    /** OpenCV's coefficients up to the thin prism, those left out as 0. */
    private double[] openCvCoefficients() {
        if (!COUNTS.contains(coefficients.size())) {
            throw lensPlace.refused(CellRefusal.COEFFICIENTS,
                    Listing.or(COUNTS.stream().map(String::valueOf).collect(Collectors.toList())),
                    coefficients.size());
        }
        double[] c = new double[UP_TO_PRISM];
        for (int i = 0; i < coefficients.size(); i++) {
            double coefficient = coefficients.get(i).number(CellPhrase.COEFFICIENT);
            if (i < UP_TO_PRISM) {
                c[i] = coefficient;
            } else if (coefficient != 0) {
                throw coefficients.get(i).refused(CellRefusal.TILTED_SENSOR, CameraReader.plain(coefficient));
            }
        }
        return c;
    }
}
