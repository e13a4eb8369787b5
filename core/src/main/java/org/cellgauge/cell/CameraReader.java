package org.cellgauge.cell;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.cellgauge.geometry.Lens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.cell.CalibratedCameraText;
import org.cellgauge.internal.cell.CellPhrase;
import org.cellgauge.internal.cell.InputFiles;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.warning.Refusal;
import org.jspecify.annotations.Nullable;

/**
 * Reads and judges camera files, the form told by what is in them: BoofCV's calibration files (YAML) of the models
 * {@code pinhole}, {@code pinhole_radial_tangential} and {@code kannala_brandt} (a fisheye), and those of other
 * programs ({@link CameraFormat}). The keys of any of them may stand in a cell file.
 *
 * <p>Three keys may stand beside theirs: {@code tone_curve}, how the camera makes grey values of light ({@code auto},
 * {@code srgb}, {@code linear} or {@code gamma G}); {@code focus_distance_m}, the distance that the lens was focused at
 * when the camera was calibrated (0.01 to 1000 m); and {@code cellgauge_calibration}, how well the intrinsics are
 * known ({@code parameters}, {@code covariance}, {@link CameraCalibration}). Of BoofCV's, {@code skew}, the radial
 * coefficients (up to 3) and {@code t1}, {@code t2} are 0 where they are left out. Of a fisheye, {@code symmetric}
 * holds up to 5 coefficients of the angle's odd powers; the first is taken into the focal lengths and the skew. Its
 * asymmetric part ({@code radial} and {@code tangent} with their {@code _trig}) is refused where it is not 0. The model
 * {@code pinhole_rational}, which BoofCV has not, takes {@code rational} with {@code radial} (k1 to k6), {@code t1},
 * {@code t2} and {@code prism} (s1 to s4).
 */
public final class CameraReader {
    /** Largest camera file that is read, bytes; without pictures and solutions that stand in it, a megabyte. */
    public static final int MAX_BYTES = 1 << 24;

    /** The key of a camera file, and of a cell file, that states the tone curve. */
    public static final String TONE_CURVE = "tone_curve";

    /** The key of a camera file that states the distance which its lens was focused at. */
    public static final String FOCUS_DISTANCE = "focus_distance_m";
    /** Nearest distance that a lens is focused at, m. */
    public static final double LEAST_FOCUS_DISTANCE_M = 0.01;
    /** Farthest distance that is told from infinity, m. */
    public static final double LARGEST_FOCUS_DISTANCE_M = 1000;

    private static final CellPhrase WHAT = CellPhrase.CAMERA_FILE;
    private static final Refusal EXAMPLE = Refusal.of(CellPhrase.CAMERA_KEYS, BoofCamera.example());
    private static final String COVARIANCE_EXAMPLE = "{parameters: [fx, fy], covariance: [[4, 3.9], [3.9, 4]]}";

    private CameraReader() {
    }

    /**
     * Reads a camera file that holds one camera.
     *
     * @param file camera file of any form
     * @return the camera
     * @throws InputRefusedException if it is missing, not readable, of another lens or contradicts itself
     */
    public static PinholeCamera read(Path file) {
        return file(file, null).camera();
    }

    /**
     * Reads the text of a camera file that holds one camera.
     *
     * @param text the text
     * @param displayName the name that messages give it
     * @return the camera
     * @throws InputRefusedException if it is of another lens or contradicts itself
     */
    public static PinholeCamera read(String text, String displayName) {
        return file(text, displayName, null).camera();
    }

    /**
     * All that a camera file says.
     *
     * @param file camera file of any form
     * @param camera which camera, where the file holds several; null where it holds one
     * @return the camera, and what is known of it
     * @throws InputRefusedException as {@link #file(String, String, String)}, or if it is missing or not readable
     */
    public static CameraFile file(Path file, @Nullable String camera) {
        return file(InputFiles.text(file, WHAT, MAX_BYTES), file.toString(), camera);
    }

    /**
     * All that a camera file's text says.
     *
     * @param text the text
     * @param displayName the name that messages give it
     * @param camera which camera, where the file holds several; null where it holds one
     * @return the camera, and what is known of it
     * @throws InputRefusedException if it is of another lens, contradicts itself, or holds no such camera or several
     */
    public static CameraFile file(String text, String displayName, @Nullable String camera) {
        return file(parse(text, displayName), camera);
    }

    /** All that the value at the top of a camera file, or the keys in a cell file, say. */
    static CameraFile file(YamlValue top, @Nullable String name) {
        YamlValue value = chosen(top, name);
        YamlMapping keys = value.mapping(EXAMPLE);
        CameraFormat format = CameraFormat.of(keys);
        if (format == null) {
            throw value.refused(CellRefusal.NO_CAMERA,
                    Listing.or(Arrays.stream(CameraFormat.values()).map(CameraFormat::words)
                            .collect(Collectors.toList())));
        }
        PinholeCamera camera = format == CameraFormat.BOOFCV ? BoofCamera.of(keys) : OtherCamera.of(keys, format);
        return new CameraFile(camera, format,
                calibrationOf(keys, camera.lens()), toneCurve(keys.optional(TONE_CURVE)),
                focusDistanceM(keys.optional(FOCUS_DISTANCE)),
                OtherCamera.statesDeviationsAlone(keys));
    }

    /** The camera of a name in a file that holds several; the value itself in one that holds one. */
    private static YamlValue chosen(YamlValue top, @Nullable String name) {
        YamlMapping file = top.mapping(EXAMPLE);
        if (file.optional("cellgauge") != null) {
            throw file.at("cellgauge").refused(CellRefusal.IS_CELL_FILE);
        }
        Map<String, YamlValue> cameras = new LinkedHashMap<>();
        if (CameraFormat.of(file) == null) {
            file.values().forEach((key, value) -> {
                if (value.isMapping() && value.mapping(EXAMPLE).optional("camera_model") != null) {
                    cameras.put(key, value);
                }
            });
        }
        List<String> names = List.copyOf(cameras.keySet());
        if (name == null && names.size() > 1) {
            throw top.refused(CellRefusal.SEVERAL_CAMERAS, Listing.comma(names), names.get(0));
        }
        if (name != null && !names.contains(name)) {
            throw top.refused(CellRefusal.NO_SUCH_CAMERA, name, names.isEmpty() ? CellPhrase.ONE_CAMERA
                    : Refusal.of(CellPhrase.ITS_CAMERAS, Listing.comma(names)));
        }
        return names.isEmpty() ? top : Objects.requireNonNull(cameras.get(name == null ? names.get(0) : name));
    }

    /** What a mapping with a calibration file's keys says of the covariance of its intrinsics; null where nothing. */
    private static @Nullable CameraCalibration calibrationOf(YamlMapping camera, Lens lens) {
        YamlValue block = camera.optional(CalibratedCameraText.KEY);
        if (block == null) {
            return null;
        }
        // figures of the calibration that a check needs not stand there as well
        YamlMapping stated = block.mapping(COVARIANCE_EXAMPLE);
        List<String> names = new ArrayList<>();
        for (YamlValue value : stated.required("parameters", "parameters: [fx, fy]").items()) {
            String name = value.text("fx");
            if (CameraCalibration.index(lens, name) < 0 || names.contains(name)) {
                List<String> known = new ArrayList<>();
                lens.parameterNames().forEach(p -> known.add(CameraCalibration.name(p)));
                throw value.refused(CellRefusal.CALIBRATED_PARAMETER, name, Listing.comma(known));
            }
            names.add(name);
        }
        YamlValue matrix = stated.required("covariance", "covariance: [[4, 3.9], [3.9, 4]]");
        List<YamlValue> rows = matrix.items();
        int n = names.size();
        if (rows.size() != n) {
            throw matrix.refused(CellRefusal.NO_COVARIANCE, n);
        }
        double[] covariance = new double[n * n];
        for (int i = 0; i < n; i++) {
            List<YamlValue> row = rows.get(i).items();
            if (row.size() != n) {
                throw rows.get(i).refused(CellRefusal.NO_COVARIANCE, n);
            }
            for (int j = 0; j < n; j++) {
                covariance[n * i + j] = row.get(j).number(CellPhrase.VARIANCE);
            }
        }
        if (!CameraCalibration.isCovariance(covariance, n)) {
            throw matrix.refused(CellRefusal.NO_COVARIANCE, n);
        }
        YamlValue photos = stated.optional("photos");
        return new CameraCalibration(names, covariance,
                photos == null ? 0 : photos.whole(0, Integer.MAX_VALUE, CellPhrase.PHOTOS_OF_CALIBRATION));
    }

    /** The distance that a lens was focused at, m; empty where nothing stands. */
    static OptionalDouble focusDistanceM(@Nullable YamlValue value) {
        if (value == null) {
            return OptionalDouble.empty();
        }
        double distance = value.number(CellPhrase.FOCUS_DISTANCE);
        if (!isFocusDistance(distance)) {
            throw value.refused(CellRefusal.OUT_OF_RANGE, plain(LEAST_FOCUS_DISTANCE_M),
                    plain(LARGEST_FOCUS_DISTANCE_M), plain(distance), CellPhrase.FOCUS_DISTANCE);
        }
        return OptionalDouble.of(distance);
    }

    /**
     * Whether a lens can be focused at a distance, as far as camera files go.
     *
     * @param distanceM in m
     * @return false where a camera file that states it is refused
     */
    public static boolean isFocusDistance(double distanceM) {
        return distanceM >= LEAST_FOCUS_DISTANCE_M && distanceM <= LARGEST_FOCUS_DISTANCE_M;
    }

    /** The value at the top of a camera file. */
    static YamlValue parse(String text, String displayName) {
        return CameraText.parse(text, displayName);
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
