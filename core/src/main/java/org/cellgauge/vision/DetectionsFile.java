package org.cellgauge.vision;

import com.google.gson.JsonPrimitive;
import com.google.gson.Strictness;
import com.google.gson.stream.JsonReader;
import com.google.gson.stream.JsonToken;
import com.google.gson.stream.MalformedJsonException;
import java.io.EOFException;
import java.io.IOException;
import java.io.Reader;
import java.io.StringReader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.cellgauge.cell.CellRefusal;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.internal.cell.InputFiles;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.vision.DetectionsPhrase;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;
import org.cellgauge.warning.RefusalKind;
import org.jspecify.annotations.Nullable;

/**
 * Reads, judges and writes detections files: corners from any detector, in place of an image.
 *
 * <p>The format is JSON: {@code {"image": {"width": 1280, "height": 720, "name": "a.png"}, "markers": [{"id": 944,
 * "corners_px": [[x, y], [x, y], [x, y], [x, y]]}]}}. Corners are top-left, top-right, bottom-right, bottom-left of the
 * marker in its own frame, in px with pixel centres at +0.5. {@code name} may be left out. Every refusal names file,
 * line, column, key and remedy.
 *
 * <p>A detector that knows how precise its corners are says so: with a marker {@code "covariance_px2"}, the 8 x 8
 * covariance of the corners' errors in their order u, v of each (px²), and beside it {@code "edge_shift": {"px": 0.1,
 * "variance_px2": 0.01, "covariance_with_corners_px2": [8 values]}}, see {@link EdgeShift}; with the image's
 * {@code "light": {"tone_curve": "srgb", "edge_shift_std_px": 0.1, "blur_px": 0.7, "noise_grey": 2}}, see
 * {@link PhotoLight} (blur and noise may be left out, and so may {@code "tone_curve_estimated"}, which is then false,
 * and {@code "noise_degrees_of_freedom"}).
 */
public final class DetectionsFile {
    /** Largest detections file that is read, bytes. */
    public static final int MAX_BYTES = 10 << 20;

    private static final DetectionsPhrase WHAT = DetectionsPhrase.DETECTIONS_FILE;
    private static final int MAX_SIDE_PX = 30_000;
    private static final int MAX_ID = 999_999_999;
    /** Smallest area of a marker in the image, px²; two pixels a side, far below what any detector finds. */
    private static final double MIN_AREA_PX2 = 4;
    /** How far outside of the image a corner may lie, in its longer sides: detectors extrapolate a little. */
    private static final double MARGIN_PER_SIDE = 0.1;
    /** Share of the quadrilateral's area that a corner may point inwards by, for noise on markers seen edge-on. */
    private static final double CONCAVE_TOLERANCE = 0.05;
    /** Difference of two values that mirror each other in a covariance, in the larger of them. */
    private static final double SYMMETRY_TOLERANCE = 1e-6;
    /** Share of a corner's variance that must be left once the others are known. */
    private static final double LEAST_CONDITIONAL_SHARE = 1e-10;
    // the one public way to the reader's line: its own text, "JsonReader at line 1 column 2 path $"
    private static final Pattern POWER = Pattern.compile("(gamma|srgb) (.*)", Pattern.DOTALL);
    private static final Pattern PLACE = Pattern.compile("line (\\d+) column (\\d+)");

    private final JsonReader json;
    private final String file;
    private String imageName;
    private int widthPx;
    private int heightPx;
    private @Nullable PhotoLight light;

    private DetectionsFile(JsonReader json, String file) {
        this.json = json;
        this.file = file;
        this.imageName = file;
    }

    /**
     * Reads a detections file.
     *
     * @param file JSON in UTF-8
     * @return the detections; their image name is the file's path where the file states none
     * @throws InputRefusedException if it is missing, not readable or faulty
     */
    public static Detections read(Path file) {
        return parse(InputFiles.text(file, WHAT, MAX_BYTES), file.toString());
    }

    /**
     * The bytes of a detections file, read once: what is read from them and a checksum of them belong together, even
     * where the file changes meanwhile or is a pipe.
     *
     * @param file JSON in UTF-8
     * @return all of it
     * @throws InputRefusedException if it is missing, not readable or larger than {@value #MAX_BYTES} bytes
     */
    public static byte[] bytes(Path file) {
        return InputFiles.bytes(file, WHAT, MAX_BYTES);
    }

    /**
     * Reads detections from the bytes of a file.
     *
     * @param bytes JSON in UTF-8
     * @param displayName the name that messages give it; the image's name where it states none
     * @return the detections
     * @throws InputRefusedException if they are faulty
     */
    public static Detections read(byte[] bytes, String displayName) {
        return parse(InputFiles.text(bytes, displayName, WHAT, MAX_BYTES), displayName);
    }

    /**
     * Reads detections from a stream of characters.
     *
     * @param reader JSON, read to its end but not closed
     * @param displayName the name that messages give it; the image's name where it states none
     * @return the detections
     * @throws InputRefusedException if it is not readable or faulty
     */
    public static Detections read(Reader reader, String displayName) {
        StringBuilder text = new StringBuilder();
        char[] buffer = new char[8192];
        try {
            int n = reader.read(buffer);
            while (n >= 0) {
                text.append(buffer, 0, n);
                if (text.length() > MAX_BYTES) {
                    throw new InputRefusedException(displayName, CellRefusal.TOO_LARGE, MAX_BYTES / 1024, WHAT);
                }
                n = reader.read(buffer);
            }
        } catch (IOException e) {
            throw new InputRefusedException(Refusal.at(Place.of(displayName), CellRefusal.NOT_READABLE, WHAT,
                    String.valueOf(e.getMessage())), e);
        }
        return parse(text.toString(), displayName);
    }

    /**
     * Writes detections in the format that {@link #read(Path)} takes; numbers keep every digit.
     *
     * @param detections what to write
     * @param out receives the JSON, ended by a line feed; not closed
     * @throws IOException if {@code out} throws it
     */
    public static void write(Detections detections, Appendable out) throws IOException {
        out.append("{\"image\": {\"width\": ").append(String.valueOf(detections.widthPx())).append(", \"height\": ")
                .append(String.valueOf(detections.heightPx())).append(", \"name\": ")
                .append(new JsonPrimitive(detections.imageName()).toString()).append("}");
        if (detections.light() != null) {
            write(detections.light(), out);
        }
        out.append(",\n \"markers\": [");
        String separator = "";
        for (MarkerObservation marker : detections.markers()) {
            double[] c = marker.cornersPx();
            out.append(separator).append("\n  {\"id\": ").append(String.valueOf(marker.id()))
                    .append(", \"corners_px\": [");
            for (int i = 0; i < 4; i++) {
                out.append(i == 0 ? "[" : ", [").append(String.valueOf(c[2 * i])).append(", ")
                        .append(String.valueOf(c[2 * i + 1])).append("]");
            }
            out.append(']');
            if (marker.covariancePx2() != null) {
                out.append(",\n   \"covariance_px2\": [");
                for (int row = 0; row < 8; row++) {
                    out.append(row == 0 ? "" : ",\n    ");
                    write(marker.covariancePx2(), 8 * row, out);
                }
                out.append(']');
            }
            if (marker.edgeShift() != null) {
                out.append(",\n   \"edge_shift\": {\"px\": ").append(String.valueOf(marker.edgeShift().shiftPx()))
                        .append(", \"variance_px2\": ").append(String.valueOf(marker.edgeShift().variancePx2()))
                        .append(",\n    \"covariance_with_corners_px2\": ");
                write(marker.edgeShift().covarianceWithCornersPx2(), 0, out);
                out.append('}');
            }
            out.append('}');
            separator = ",";
        }
        out.append("]}\n");
    }

    private static void write(PhotoLight light, Appendable out) throws IOException {
        out.append(",\n \"light\": {\"tone_curve\": ").append(new JsonPrimitive(light.toneCurve().words()).toString())
                .append(", \"tone_curve_estimated\": ").append(String.valueOf(light.toneCurveEstimated()))
                .append(", \"edge_shift_std_px\": ").append(String.valueOf(light.edgeShiftStdPx()))
                .append(", \"outline_std_px\": ").append(String.valueOf(light.outlineStdPx()));
        String[] keys = {"blur_px", "noise_grey", "noise_degrees_of_freedom"};
        double[] values = {light.blurPx(), light.noiseGrey(), light.noiseDegreesOfFreedom()};
        for (int i = 0; i < keys.length; i++) {
            if (Double.isFinite(values[i])) {
                out.append(", \"").append(keys[i]).append("\": ").append(String.valueOf(values[i]));
            }
        }
        out.append('}');
    }

    /** Eight values as a list. */
    private static void write(double[] values, int from, Appendable out) throws IOException {
        for (int i = 0; i < 8; i++) {
            out.append(i == 0 ? "[" : ", ").append(String.valueOf(values[from + i]));
        }
        out.append(']');
    }

    private static Detections parse(String text, String file) {
        if (text.trim().isEmpty()) {
            throw new InputRefusedException(file, CellRefusal.EMPTY, WHAT);
        }
        JsonReader json = new JsonReader(new StringReader(text));
        json.setStrictness(Strictness.STRICT);
        DetectionsFile reader = new DetectionsFile(json, file);
        try {
            return reader.detections();
        } catch (EOFException e) {
            throw reader.unreadable(e, DetectionsRefusal.CUT_SHORT);
        } catch (MalformedJsonException e) {
            throw reader.unreadable(e, DetectionsRefusal.JSON_SYNTAX);
        } catch (IOException e) {
            throw reader.unreadable(e, DetectionsRefusal.NOT_JSON, String.valueOf(e.getMessage()));
        }
    }

    private Detections detections() throws IOException {
        expect(JsonToken.BEGIN_OBJECT, DetectionsPhrase.OBJECT, DetectionsPhrase.BEGIN);
        json.beginObject();
        Set<String> keys = new HashSet<>();
        List<MarkerObservation> markers = new ArrayList<>();
        List<Place> places = new ArrayList<>();
        while (json.hasNext()) {
            switch (key(keys, "image", "light", "markers")) {
                case "image":
                    image();
                    break;
                case "light":
                    light();
                    break;
                default:
                    markers(markers, places);
            }
        }
        require(keys, "image", "\"image\": {\"width\": 1280, \"height\": 720}");
        require(keys, "markers", "\"markers\": [...]");
        json.endObject();
        if (json.peek() != JsonToken.END_DOCUMENT) {
            throw refused(DetectionsRefusal.MORE_TEXT);
        }
        for (int i = 0; i < markers.size(); i++) {
            judge(markers.get(i), places.get(i));
        }
        return new Detections(imageName, widthPx, heightPx, markers, new ArrayList<>(), light);
    }

    private void image() throws IOException {
        expect(JsonToken.BEGIN_OBJECT, DetectionsPhrase.OBJECT,
                write("{\"width\": 1280, \"height\": 720, \"name\": \"a.png\"}"));
        json.beginObject();
        Set<String> keys = new HashSet<>();
        while (json.hasNext()) {
            switch (key(keys, "width", "height", "name")) {
                case "width":
                    widthPx = whole(1, MAX_SIDE_PX, DetectionsPhrase.WIDTH);
                    break;
                case "height":
                    heightPx = whole(1, MAX_SIDE_PX, DetectionsPhrase.HEIGHT);
                    break;
                default:
                    expect(JsonToken.STRING, DetectionsPhrase.TEXT, DetectionsPhrase.FILE_NAME);
                    imageName = json.nextString();
            }
        }
        require(keys, "width", "\"width\": 1280");
        require(keys, "height", "\"height\": 720");
        json.endObject();
    }

    private void light() throws IOException {
        expect(JsonToken.BEGIN_OBJECT, DetectionsPhrase.OBJECT, DetectionsPhrase.LIGHT);
        json.beginObject();
        Set<String> keys = new HashSet<>();
        ToneCurve toneCurve = ToneCurve.LINEAR;
        boolean estimated = false;
        double edgeShiftStdPx = 0;
        double outlineStdPx = Double.NaN;
        double blurPx = Double.NaN;
        double noiseGrey = Double.NaN;
        double degreesOfFreedom = Double.NaN;
        while (json.hasNext()) {
            switch (key(keys, "tone_curve", "tone_curve_estimated", "edge_shift_std_px", "blur_px", "noise_grey",
                    "noise_degrees_of_freedom", "outline_std_px")) {
                case "tone_curve":
                    toneCurve = toneCurve();
                    break;
                case "tone_curve_estimated":
                    expect(JsonToken.BOOLEAN, DetectionsPhrase.TRUE_OR_FALSE,
                            DetectionsPhrase.WRITE_TRUE_OR_FALSE);
                    estimated = json.nextBoolean();
                    break;
                case "edge_shift_std_px":
                    edgeShiftStdPx = notNegative(DetectionsPhrase.EDGE_SHIFT_STD);
                    break;
                case "outline_std_px":
                    outlineStdPx = notNegative(DetectionsPhrase.EDGE_SHIFT_STD);
                    break;
                case "blur_px":
                    blurPx = notNegative(DetectionsPhrase.BLUR);
                    break;
                case "noise_grey":
                    noiseGrey = notNegative(DetectionsPhrase.NOISE);
                    break;
                default:
                    degreesOfFreedom = notNegative(DetectionsPhrase.WRITE_NUMBER);
            }
        }
        require(keys, "tone_curve", "\"tone_curve\": \"srgb\"");
        require(keys, "edge_shift_std_px", "\"edge_shift_std_px\": 0.1");
        json.endObject();
        light = new PhotoLight(toneCurve, estimated, blurPx, noiseGrey, degreesOfFreedom, edgeShiftStdPx);
        light = Double.isNaN(outlineStdPx) ? light : light.withOutlineStdPx(outlineStdPx);
    }

    private ToneCurve toneCurve() throws IOException {
        expect(JsonToken.STRING, DetectionsPhrase.TEXT, DetectionsPhrase.TONE_CURVE);
        Place place = place();
        String words = json.nextString();
        try {
            return ToneCurve.of(words);
        } catch (IllegalArgumentException e) {
            throw new InputRefusedException(noToneCurve(place, words), e);
        }
    }

    /** A word that is none, or the power of one that no camera has. */
    private static Refusal noToneCurve(Place place, String words) {
        Matcher m = POWER.matcher(words.trim().toLowerCase(Locale.ROOT));
        if (m.matches()) {
            try {
                return Refusal.at(place, DetectionsRefusal.TONE_CURVE_OUT_OF_RANGE,
                        m.group(1).equals("srgb") ? DetectionsPhrase.POWER : DetectionsPhrase.GAMMA,
                        String.valueOf(ToneCurve.LEAST_GAMMA), String.valueOf(ToneCurve.LARGEST_GAMMA),
                        String.valueOf(Double.parseDouble(m.group(2))));
            } catch (NumberFormatException e) {
                return Refusal.at(place, DetectionsRefusal.NO_TONE_CURVE, words);
            }
        }
        return Refusal.at(place, DetectionsRefusal.NO_TONE_CURVE, words);
    }

    private void markers(List<MarkerObservation> markers, List<Place> places) throws IOException {
        expect(JsonToken.BEGIN_ARRAY, DetectionsPhrase.LIST, write("[{\"id\": 944, \"corners_px\": [...]}]"));
        json.beginArray();
        Map<Integer, String> seen = new HashMap<>();
        while (json.hasNext()) {
            expect(JsonToken.BEGIN_OBJECT, DetectionsPhrase.OBJECT, write("{\"id\": 944, \"corners_px\": [...]}"));
            Place place = place();
            json.beginObject();
            Set<String> keys = new HashSet<>();
            int id = 0;
            double[] corners = new double[8];
            double @Nullable [] covariance = null;
            @Nullable EdgeShift shift = null;
            Place covariancePlace = place;
            Place shiftPlace = place;
            while (json.hasNext()) {
                switch (key(keys, "id", "corners_px", "covariance_px2", "edge_shift")) {
                    case "id":
                        id = whole(0, MAX_ID, DetectionsPhrase.ID);
                        String earlier = seen.putIfAbsent(id, json.getPath());
                        if (earlier != null) {
                            throw refused(DetectionsRefusal.MARKER_TWICE, id, shown(earlier));
                        }
                        break;
                    case "covariance_px2":
                        covariancePlace = place();
                        covariance = covariance();
                        break;
                    case "edge_shift":
                        shiftPlace = place();
                        shift = edgeShift();
                        break;
                    default:
                        place = place();
                        corners = corners();
                }
            }
            require(keys, "id", "\"id\": 944");
            require(keys, "corners_px", "\"corners_px\": [[x, y], [x, y], [x, y], [x, y]]");
            json.endObject();
            judgePrecision(id, covariance, covariancePlace, shift, shiftPlace);
            markers.add(new MarkerObservation(id, corners, covariance, shift));
            places.add(place);
        }
        json.endArray();
    }

    private double[] corners() throws IOException {
        expect(JsonToken.BEGIN_ARRAY, DetectionsPhrase.FOUR_CORNERS, DetectionsPhrase.CORNERS);
        Place place = place();
        json.beginArray();
        double[] corners = new double[8];
        int count = 0;
        while (json.hasNext()) {
            expect(JsonToken.BEGIN_ARRAY, DetectionsPhrase.CORNER, DetectionsPhrase.CORNERS);
            Place cornerPlace = place();
            json.beginArray();
            int values = 0;
            while (json.hasNext()) {
                double value = number();
                if (count < 4 && values < 2) {
                    corners[2 * count + values] = value;
                }
                values++;
            }
            json.endArray();
            if (values != 2) {
                throw expected(cornerPlace, DetectionsPhrase.TWO_NUMBERS, values, DetectionsPhrase.WRITE_CORNER);
            }
            count++;
        }
        json.endArray();
        if (count != 4) {
            throw expected(place, DetectionsPhrase.FOUR_CORNERS, count, DetectionsPhrase.CORNERS);
        }
        return corners;
    }

    private double[] covariance() throws IOException {
        expect(JsonToken.BEGIN_ARRAY, DetectionsPhrase.EIGHT_ROWS_OF_NUMBERS, DetectionsPhrase.COVARIANCE);
        Place place = place();
        json.beginArray();
        double[] covariance = new double[64];
        int rows = 0;
        while (json.hasNext()) {
            double[] row = eight(DetectionsPhrase.COVARIANCE);
            if (rows < 8) {
                System.arraycopy(row, 0, covariance, 8 * rows, 8);
            }
            rows++;
        }
        json.endArray();
        if (rows != 8) {
            throw expected(place, DetectionsPhrase.EIGHT_ROWS, rows, DetectionsPhrase.COVARIANCE);
        }
        return covariance;
    }

    private double[] eight(DetectionsPhrase remedy) throws IOException {
        expect(JsonToken.BEGIN_ARRAY, DetectionsPhrase.EIGHT_NUMBERS, remedy);
        Place place = place();
        json.beginArray();
        double[] values = new double[8];
        int count = 0;
        while (json.hasNext()) {
            double v = number();
            if (count < 8) {
                values[count] = v;
            }
            count++;
        }
        json.endArray();
        if (count != 8) {
            throw expected(place, DetectionsPhrase.EIGHT_NUMBERS, count, remedy);
        }
        return values;
    }

    private EdgeShift edgeShift() throws IOException {
        expect(JsonToken.BEGIN_OBJECT, DetectionsPhrase.OBJECT, DetectionsPhrase.SHIFT);
        json.beginObject();
        Set<String> keys = new HashSet<>();
        double px = 0;
        double variance = 0;
        double[] withCorners = new double[8];
        while (json.hasNext()) {
            switch (key(keys, "px", "variance_px2", "covariance_with_corners_px2")) {
                case "px":
                    px = number();
                    break;
                case "variance_px2":
                    Place place = place();
                    variance = number();
                    if (!(variance > 0)) {
                        throw expected(place, DetectionsPhrase.POSITIVE_NUMBER, String.valueOf(variance),
                                DetectionsPhrase.SHIFT_VARIANCE);
                    }
                    break;
                default:
                    withCorners = eight(DetectionsPhrase.SHIFT);
            }
        }
        require(keys, "px", "\"px\": 0.1");
        require(keys, "variance_px2", "\"variance_px2\": 0.01");
        require(keys, "covariance_with_corners_px2",
                DetectionsPhrase.SHIFT_WITH_CORNERS);
        json.endObject();
        return new EdgeShift(px, variance, withCorners);
    }

    /** Refuses what cannot be the covariance of corners, or of corners and shift. */
    private static void judgePrecision(int id, double @Nullable [] covariance, Place place, @Nullable EdgeShift shift,
            Place shiftPlace) {
        if (covariance == null) {
            if (shift != null) {
                throw refused(shiftPlace, DetectionsRefusal.SHIFT_WITHOUT_COVARIANCE, id);
            }
            return;
        }
        for (int i = 0; i < 8; i++) {
            for (int j = 0; j < i; j++) {
                double below = covariance[8 * i + j];
                double above = covariance[8 * j + i];
                if (Math.abs(below - above) > SYMMETRY_TOLERANCE * Math.max(Math.abs(below), Math.abs(above))) {
                    throw refused(place, DetectionsRefusal.NOT_SYMMETRIC, id, String.valueOf(above), j + 1, i + 1,
                            String.valueOf(below), i + 1, j + 1, DetectionsPhrase.COVARIANCE);
                }
            }
        }
        if (!isCovariance(covariance, 8)) {
            throw refused(place, DetectionsRefusal.NOT_POSITIVE_DEFINITE, id, DetectionsPhrase.COVARIANCE);
        }
        if (shift != null && !isCovariance(joint(covariance, shift), 9)) {
            throw refused(shiftPlace, DetectionsRefusal.COVARIANCES_CONTRADICT, id, DetectionsPhrase.SHIFT);
        }
    }

    /** Lower triangle of the covariance of corners and, as a ninth coordinate, of the shift. */
    private static double[] joint(double[] covariance, EdgeShift shift) {
        double[] joint = new double[81];
        for (int i = 0; i < 8; i++) {
            System.arraycopy(covariance, 8 * i, joint, 9 * i, 8);
        }
        System.arraycopy(shift.covarianceWithCornersPx2(), 0, joint, 72, 8);
        joint[80] = shift.variancePx2();
        return joint;
    }

    /** Whether a symmetric matrix of n rows, of which the lower triangle counts, is a covariance. */
    private static boolean isCovariance(double[] covariance, int n) {
        double[] factor = covariance.clone();
        if (!Cholesky.factor(factor, n)) {
            return false;
        }
        for (int i = 0; i < n; i++) {
            // what is left of a variance once the values before it are known; rounding alone leaves 1e-16 of it
            if (!(factor[n * i + i] * factor[n * i + i] > LEAST_CONDITIONAL_SHARE * covariance[n * i + i])) {
                return false;
            }
        }
        return true;
    }

    /** Refuses corners that no picture of a marker's front can have. */
    private void judge(MarkerObservation marker, Place place) {
        double[] c = marker.cornersPx();
        double margin = MARGIN_PER_SIDE * Math.max(widthPx, heightPx);
        double area = 0;
        for (int i = 0; i < 4; i++) {
            int j = (i + 1) % 4;
            double u = c[2 * i];
            double v = c[2 * i + 1];
            if (!(u >= -margin && u <= widthPx + margin && v >= -margin && v <= heightPx + margin)) {
                throw refused(place, DetectionsRefusal.CORNER_OUTSIDE, String.valueOf(u), String.valueOf(v),
                        marker.id(), widthPx, heightPx);
            }
            area += 0.5 * (u * c[2 * j + 1] - c[2 * j] * v);
        }
        // v points down, so a front seen from before runs clockwise and has each of these cross products positive
        int negative = 0;
        double least = Double.POSITIVE_INFINITY;
        double reach = 0;
        for (int i = 0; i < 4; i++) {
            int j = (i + 1) % 4;
            int k = (i + 2) % 4;
            double ax = c[2 * j] - c[2 * i];
            double ay = c[2 * j + 1] - c[2 * i + 1];
            double bx = c[2 * k] - c[2 * j];
            double by = c[2 * k + 1] - c[2 * j + 1];
            double cross = ax * by - ay * bx;
            negative += cross < 0 ? 1 : 0;
            least = Math.min(least, cross);
            reach = Math.max(reach, Math.abs(cross));
        }
        if (reach < MIN_AREA_PX2) {
            throw refused(place, DetectionsRefusal.NO_AREA, marker.id(), DetectionsPhrase.CORNERS);
        }
        if (negative == 4) {
            throw refused(place, DetectionsRefusal.MIRRORED, marker.id(), DetectionsPhrase.CORNERS);
        }
        if (negative == 2) {
            throw refused(place, DetectionsRefusal.CROSSES_ITSELF, marker.id(), DetectionsPhrase.CORNERS);
        }
        if (area < MIN_AREA_PX2 || least < -CONCAVE_TOLERANCE * area) {
            throw refused(place, DetectionsRefusal.NO_SQUARE, marker.id(), DetectionsPhrase.CORNERS);
        }
    }

    private String key(Set<String> keys, String... known) throws IOException {
        String key = json.nextName();
        for (String k : known) {
            if (k.equals(key)) {
                if (!keys.add(key)) {
                    throw refused(DetectionsRefusal.KEY_TWICE);
                }
                return key;
            }
        }
        throw refused(DetectionsRefusal.UNKNOWN_KEY, Listing.comma(Arrays.asList(known)));
    }

    private void require(Set<String> keys, String key, Object example) {
        if (!keys.contains(key)) {
            String path = json.getPath();
            throw refused(place(path.substring(0, path.lastIndexOf('.') + 1) + key), DetectionsRefusal.MISSING,
                    example);
        }
    }

    private void expect(JsonToken token, DetectionsPhrase what, Object remedy) throws IOException {
        if (json.peek() != token) {
            throw expected(place(), what, described(json.peek()), remedy);
        }
    }

    private double number() throws IOException {
        expect(JsonToken.NUMBER, DetectionsPhrase.NUMBER, DetectionsPhrase.UNQUOTED_NUMBER);
        Place place = place();
        String text = json.nextString();
        double value = Double.parseDouble(text);
        if (Double.isInfinite(value)) {
            throw expected(place, DetectionsPhrase.FINITE_NUMBER, text, DetectionsPhrase.WRITE_PX);
        }
        return value;
    }

    private double notNegative(DetectionsPhrase remedy) throws IOException {
        Place place = place();
        double value = number();
        if (!(value >= 0)) {
            throw expected(place, DetectionsPhrase.NUMBER_FROM_0, String.valueOf(value), remedy);
        }
        return value;
    }

    private int whole(int min, int max, DetectionsPhrase remedy) throws IOException {
        expect(JsonToken.NUMBER, DetectionsPhrase.WHOLE_NUMBER, remedy);
        Place place = place();
        String text = json.nextString();
        double value = Double.parseDouble(text);
        if (!text.matches("\\d+") || !(value >= min && value <= max)) {
            throw expected(place, Refusal.of(DetectionsPhrase.WHOLE_NUMBER_WITHIN, min, max), text, remedy);
        }
        return (int) value;
    }

    private static DetectionsPhrase described(JsonToken token) {
        switch (token) {
            case BEGIN_ARRAY:
                return DetectionsPhrase.LIST;
            case BEGIN_OBJECT:
                return DetectionsPhrase.OBJECT;
            case STRING:
                return DetectionsPhrase.TEXT_IN_QUOTES;
            case NUMBER:
                return DetectionsPhrase.NUMBER;
            case BOOLEAN:
                return DetectionsPhrase.TRUE_OR_FALSE;
            case NULL:
                return DetectionsPhrase.NULL;
            default:
                return DetectionsPhrase.NOTHING;
        }
    }

    private InputRefusedException refused(RefusalKind kind, Object... arguments) {
        return refused(place(), kind, arguments);
    }

    private static InputRefusedException refused(Place place, RefusalKind kind, Object... arguments) {
        return new InputRefusedException(Refusal.at(place, kind, arguments));
    }

    private InputRefusedException unreadable(IOException e, RefusalKind kind, Object... arguments) {
        return new InputRefusedException(Refusal.at(place(), kind, arguments), e);
    }

    private static InputRefusedException expected(Place place, Object what, Object got, Object remedy) {
        return refused(place, DetectionsRefusal.EXPECTED, what, got, remedy);
    }

    private static Refusal write(String json) {
        return Refusal.of(DetectionsPhrase.WRITE, json);
    }

    /** File, line, column and key path of what comes next. */
    private Place place() {
        return place(json.getPath());
    }

    private Place place(String jsonPath) {
        Matcher m = PLACE.matcher(json.toString());
        boolean found = m.find();
        return Place.of(file, found ? Integer.parseInt(m.group(1)) : 0, found ? Integer.parseInt(m.group(2)) : 0,
                shown(jsonPath));
    }

    private static String shown(String path) {
        return path.replaceFirst("^\\$\\.?", "").replaceFirst("\\.$", "");
    }
}
