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
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.cellgauge.cell.InputFiles;
import org.cellgauge.cell.InputRefusedException;

/**
 * Reads, judges and writes detections files: corners from any detector, in place of an image.
 *
 * <p>The format is JSON: {@code {"image": {"width": 1280, "height": 720, "name": "a.png"}, "markers": [{"id": 944,
 * "corners_px": [[x, y], [x, y], [x, y], [x, y]]}]}}. Corners are top-left, top-right, bottom-right, bottom-left of the
 * marker in its own frame, in px with pixel centres at +0.5. {@code name} may be left out. Every refusal names file,
 * line, column, key and remedy.
 */
public final class DetectionsFile {
    /** Largest detections file that is read, bytes. */
    public static final int MAX_BYTES = 10 << 20;

    private static final String WHAT = "detections file";
    private static final int MAX_SIDE_PX = 30_000;
    private static final int MAX_ID = 999_999_999;
    private static final String CORNERS_REMEDY =
            "write the corners as [[x, y], [x, y], [x, y], [x, y]]: top-left, top-right, bottom-right, bottom-left";
    /** Smallest area of a marker in the image, px²; two pixels a side, far below what any detector finds. */
    private static final double MIN_AREA_PX2 = 4;
    /** How far outside of the image a corner may lie, in its longer sides: detectors extrapolate a little. */
    private static final double MARGIN_PER_SIDE = 0.1;
    /** Share of the quadrilateral's area that a corner may point inwards by, for noise on markers seen edge-on. */
    private static final double CONCAVE_TOLERANCE = 0.05;
    // the one public way to the reader's line: its own text, "JsonReader at line 1 column 2 path $"
    private static final Pattern PLACE = Pattern.compile("line (\\d+) column (\\d+)");

    private final JsonReader json;
    private final String file;
    private String imageName;
    private int widthPx;
    private int heightPx;

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
                    throw new InputRefusedException(displayName + ": larger than " + MAX_BYTES / 1024
                            + " KiB, which no " + WHAT + " is; check the name of the file");
                }
                n = reader.read(buffer);
            }
        } catch (IOException e) {
            throw new InputRefusedException(displayName + ": the " + WHAT + " cannot be read (" + e.getMessage()
                    + "); check the disk or copy the file elsewhere", e);
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
                .append(new JsonPrimitive(detections.imageName()).toString()).append("},\n \"markers\": [");
        String separator = "";
        for (MarkerObservation marker : detections.markers()) {
            double[] c = marker.cornersPx();
            out.append(separator).append("\n  {\"id\": ").append(String.valueOf(marker.id()))
                    .append(", \"corners_px\": [");
            for (int i = 0; i < 4; i++) {
                out.append(i == 0 ? "[" : ", [").append(String.valueOf(c[2 * i])).append(", ")
                        .append(String.valueOf(c[2 * i + 1])).append("]");
            }
            out.append("]}");
            separator = ",";
        }
        out.append("]}\n");
    }

    private static Detections parse(String text, String file) {
        if (text.trim().isEmpty()) {
            throw new InputRefusedException(file + ": the file is empty; name a filled " + WHAT);
        }
        JsonReader json = new JsonReader(new StringReader(text));
        json.setStrictness(Strictness.STRICT);
        DetectionsFile reader = new DetectionsFile(json, file);
        try {
            return reader.detections();
        } catch (EOFException e) {
            throw reader.refused("the file ends in the middle of it; write it again in full", e);
        } catch (MalformedJsonException e) {
            throw reader.refused("not valid JSON; check commas, quotes and brackets near this place, and that numbers "
                    + "are finite", e);
        } catch (IOException e) {
            throw reader.refused("not readable as JSON (" + e.getMessage() + "); write it again", e);
        }
    }

    private Detections detections() throws IOException {
        expect(JsonToken.BEGIN_OBJECT, "an object", "begin with {\"image\": ..., \"markers\": [...]}");
        json.beginObject();
        Set<String> keys = new HashSet<>();
        List<MarkerObservation> markers = new ArrayList<>();
        List<String> places = new ArrayList<>();
        while (json.hasNext()) {
            switch (key(keys, "image", "markers")) {
                case "image":
                    image();
                    break;
                default:
                    markers(markers, places);
            }
        }
        require(keys, "image", "\"image\": {\"width\": 1280, \"height\": 720}");
        require(keys, "markers", "\"markers\": [...]");
        json.endObject();
        if (json.peek() != JsonToken.END_DOCUMENT) {
            throw refused("more text follows after the end; delete it", null);
        }
        for (int i = 0; i < markers.size(); i++) {
            judge(markers.get(i), places.get(i));
        }
        return new Detections(imageName, widthPx, heightPx, markers);
    }

    private void image() throws IOException {
        String example = "write {\"width\": 1280, \"height\": 720, \"name\": \"a.png\"}";
        expect(JsonToken.BEGIN_OBJECT, "an object", example);
        json.beginObject();
        Set<String> keys = new HashSet<>();
        while (json.hasNext()) {
            switch (key(keys, "width", "height", "name")) {
                case "width":
                    widthPx = whole(1, MAX_SIDE_PX, "write the image's width in px");
                    break;
                case "height":
                    heightPx = whole(1, MAX_SIDE_PX, "write the image's height in px");
                    break;
                default:
                    expect(JsonToken.STRING, "a text", "write the image's file name, or leave the key out");
                    imageName = json.nextString();
            }
        }
        require(keys, "width", "\"width\": 1280");
        require(keys, "height", "\"height\": 720");
        json.endObject();
    }

    private void markers(List<MarkerObservation> markers, List<String> places) throws IOException {
        expect(JsonToken.BEGIN_ARRAY, "a list", "write [{\"id\": 944, \"corners_px\": [...]}]");
        json.beginArray();
        Map<Integer, String> seen = new HashMap<>();
        while (json.hasNext()) {
            expect(JsonToken.BEGIN_OBJECT, "an object", "write {\"id\": 944, \"corners_px\": [...]}");
            String place = place();
            json.beginObject();
            Set<String> keys = new HashSet<>();
            int id = 0;
            double[] corners = null;
            while (json.hasNext()) {
                switch (key(keys, "id", "corners_px")) {
                    case "id":
                        id = whole(0, MAX_ID, "write the marker's id");
                        String earlier = seen.putIfAbsent(id, json.getPath());
                        if (earlier != null) {
                            throw refused("marker " + id + " was already given as " + shown(earlier)
                                    + "; keep the true one of the two", null);
                        }
                        break;
                    default:
                        place = place();
                        corners = corners();
                }
            }
            require(keys, "id", "\"id\": 944");
            require(keys, "corners_px", "\"corners_px\": [[x, y], [x, y], [x, y], [x, y]]");
            json.endObject();
            markers.add(new MarkerObservation(id, corners));
            places.add(place);
        }
        json.endArray();
    }

    private double[] corners() throws IOException {
        expect(JsonToken.BEGIN_ARRAY, "4 corners", CORNERS_REMEDY);
        String place = place();
        json.beginArray();
        double[] corners = new double[8];
        int count = 0;
        while (json.hasNext()) {
            expect(JsonToken.BEGIN_ARRAY, "a corner", CORNERS_REMEDY);
            String cornerPlace = place();
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
                throw new InputRefusedException(cornerPlace + ": expected 2 numbers, got " + values
                        + "; write a corner as [x, y] in px");
            }
            count++;
        }
        json.endArray();
        if (count != 4) {
            throw new InputRefusedException(place + ": expected 4 corners, got " + count + "; " + CORNERS_REMEDY);
        }
        return corners;
    }

    /** Refuses corners that no picture of a marker's front can have. */
    private void judge(MarkerObservation marker, String place) {
        double[] c = marker.cornersPx();
        double margin = MARGIN_PER_SIDE * Math.max(widthPx, heightPx);
        double area = 0;
        for (int i = 0; i < 4; i++) {
            int j = (i + 1) % 4;
            double u = c[2 * i];
            double v = c[2 * i + 1];
            if (!(u >= -margin && u <= widthPx + margin && v >= -margin && v <= heightPx + margin)) {
                throw new InputRefusedException(place + ": corner (" + u + ", " + v + ") of marker " + marker.id()
                        + " lies far outside of the image of " + widthPx + " x " + heightPx
                        + " px; check the image's size and that corners are in px of this image");
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
            throw new InputRefusedException(place + ": the corners of marker " + marker.id() + " enclose no area; "
                    + CORNERS_REMEDY + ", in px and not as shares of the image");
        }
        if (negative == 4) {
            throw new InputRefusedException(place + ": the corners of marker " + marker.id()
                    + " run counter-clockwise, as in a mirror; " + CORNERS_REMEDY);
        }
        if (negative == 2) {
            throw new InputRefusedException(place + ": the outline of marker " + marker.id() + " crosses itself; "
                    + CORNERS_REMEDY);
        }
        if (area < MIN_AREA_PX2 || least < -CONCAVE_TOLERANCE * area) {
            throw new InputRefusedException(place + ": the corners of marker " + marker.id()
                    + " are no picture of a square; " + CORNERS_REMEDY);
        }
    }

    private String key(Set<String> keys, String... known) throws IOException {
        String key = json.nextName();
        for (String k : known) {
            if (k.equals(key)) {
                if (!keys.add(key)) {
                    throw refused("stands twice; keep one of the two", null);
                }
                return key;
            }
        }
        throw refused("unknown key; known here: " + String.join(", ", known), null);
    }

    private void require(Set<String> keys, String key, String example) {
        if (!keys.contains(key)) {
            String path = json.getPath();
            throw new InputRefusedException(place(path.substring(0, path.lastIndexOf('.') + 1) + key)
                    + ": is missing; add " + example);
        }
    }

    private void expect(JsonToken token, String what, String remedy) throws IOException {
        if (json.peek() != token) {
            throw refused("expected " + what + ", got " + described(json.peek()) + "; " + remedy, null);
        }
    }

    private double number() throws IOException {
        expect(JsonToken.NUMBER, "a number", "write a number in px, without quotes");
        String place = place();
        String text = json.nextString();
        double value = Double.parseDouble(text);
        if (Double.isInfinite(value)) {
            throw new InputRefusedException(place + ": expected a finite number, got " + text
                    + "; write a number in px");
        }
        return value;
    }

    private int whole(int min, int max, String remedy) throws IOException {
        expect(JsonToken.NUMBER, "a whole number", remedy);
        String place = place();
        String text = json.nextString();
        double value = Double.parseDouble(text);
        if (!text.matches("\\d+") || !(value >= min && value <= max)) {
            throw new InputRefusedException(place + ": expected a whole number from " + min + " to " + max + ", got "
                    + text + "; " + remedy);
        }
        return (int) value;
    }

    private static String described(JsonToken token) {
        switch (token) {
            case BEGIN_ARRAY:
                return "a list";
            case BEGIN_OBJECT:
                return "an object";
            case STRING:
                return "a text in quotes";
            case NUMBER:
                return "a number";
            case BOOLEAN:
                return "true or false";
            case NULL:
                return "null";
            default:
                return "nothing";
        }
    }

    private InputRefusedException refused(String problem, Throwable cause) {
        return new InputRefusedException(place() + ": " + problem, cause);
    }

    /** File, line, column and key path of what comes next. */
    private String place() {
        return place(json.getPath());
    }

    private String place(String jsonPath) {
        Matcher m = PLACE.matcher(json.toString());
        String where = m.find() ? ", line " + m.group(1) + ", column " + m.group(2) : "";
        String path = shown(jsonPath);
        return file + where + (path.isEmpty() ? "" : ", " + path);
    }

    private static String shown(String path) {
        return path.replaceFirst("^\\$\\.?", "").replaceFirst("\\.$", "");
    }
}
