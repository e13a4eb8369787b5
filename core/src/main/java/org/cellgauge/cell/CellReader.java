package org.cellgauge.cell;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.function.Function;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.cell.CellPhrase;
import org.cellgauge.internal.cell.InputFiles;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.warning.Refusal;
import org.jspecify.annotations.Nullable;

/**
 * Reads and judges cell files (YAML, version 1).
 *
 * <p>Lengths are mm, angles degrees as in the file. Left out, {@code rotation_deg} is [0, 0, 0], {@code pixel_std_px}
 * is {@code auto}, {@code tone_curve} what the camera file says and else {@code auto}, {@code objects} and
 * {@code target} are none; deviations of prints are those of {@link PrintPrecision#USUAL};
 * {@code plan} says nothing. {@code placement} may be
 * left out where every reference states its own; a reference's {@code placement} and a reference's or object's
 * {@code size_mm} and {@code target} replace only what they state. Every refusal names file, line, key and remedy.
 */
public final class CellReader {
    /** Largest cell file that is read, bytes. */
    public static final int MAX_BYTES = 1 << 20;
    /** Version of the format that is read. */
    public static final int VERSION = 1;

    private static final CellPhrase WHAT = CellPhrase.CELL_FILE;
    private static final String PLACEMENT_EXAMPLE = "placement: {std_mm: [5, 5, 5], std_deg: 0.5}";
    private static final String MARKERS_EXAMPLE = "markers: {family: square-binary, size_mm: 47}";
    private static final String NAMED_EXAMPLE = "camera: {file: camchain.yaml, name: cam0}";
    private static final String POSITION = "[x, y, z] in mm";
    private static final double MIN_SIZE_MM = 0.5;
    private static final double MAX_LENGTH_MM = 1e6;
    /** Ten metres: nothing of a cell is placed worse, and beyond it the reference says nothing but costs digits. */
    private static final int MAX_PLACEMENT_STD_MM = 10_000;
    private static final double MAX_STD_DEG = 90;
    private static final double MAX_ANGLE_DEG = 360;
    private static final double SAME_PLANE_COSINE = Math.cos(Math.toRadians(30));

    /** Reads the camera file that a value of the cell file names. */
    @FunctionalInterface
    private interface NamedFile {
        YamlValue read(YamlValue value, String name);
    }

    private @Nullable YamlValue generalSize;
    private @Nullable ToneCurve cameraToneCurve;
    private @Nullable CameraCalibration calibration;
    private OptionalDouble focusDistanceM = OptionalDouble.empty();

    private CellReader() {
    }

    /**
     * Reads a cell file and the camera file it names.
     *
     * @param file the cell file; a camera file's path is relative to its folder
     * @return the cell
     * @throws InputRefusedException if one of the two is missing or faulty
     */
    public static Cell read(Path file) {
        String text = InputFiles.text(file, WHAT, MAX_BYTES);
        return cell(text, file.toString(), (value, name) -> beside(file, value, name));
    }

    /**
     * Reads a cell file's text.
     *
     * @param text YAML
     * @param displayName the name that messages give it
     * @param cameras gives the camera file that the text may name
     * @return the cell
     * @throws InputRefusedException if the cell or the camera is missing or faulty
     */
    public static Cell read(String text, String displayName, CameraSource cameras) {
        return cell(text, displayName, (value, name) -> from(cameras, value, name));
    }

    /**
     * Reads a cell file's text for a camera that is known otherwise: what the file says of the camera is not read, and
     * it may say nothing.
     *
     * @param text YAML
     * @param displayName the name that messages give it
     * @param camera the camera of the cell, which counts as exact
     * @return the cell
     * @throws InputRefusedException if the cell is faulty
     */
    public static Cell read(String text, String displayName, PinholeCamera camera) {
        return new CellReader().cell(YamlValue.parse(text, displayName, WHAT, MAX_BYTES), file -> camera);
    }

    /**
     * Reads a cell file's text for a camera file that was read already, in place of what the cell file says of the
     * camera.
     *
     * @param text YAML
     * @param displayName the name that messages give it
     * @param camera the camera of the cell with what its file says of it; a tone curve of the cell file goes before
     *     its own
     * @return the cell
     * @throws InputRefusedException if the cell is faulty
     */
    public static Cell read(String text, String displayName, CameraFile camera) {
        CellReader reader = new CellReader();
        return reader.cell(YamlValue.parse(text, displayName, WHAT, MAX_BYTES), file -> reader.kept(camera));
    }

    private static Cell cell(String text, String displayName, NamedFile cameraFile) {
        CellReader reader = new CellReader();
        return reader.cell(YamlValue.parse(text, displayName, WHAT, MAX_BYTES),
                file -> reader.camera(file.required("camera", CellPhrase.CAMERA), cameraFile));
    }

    /**
     * How a cell file states the camera, so that a caller can choose between that and a camera of its own.
     *
     * @param text YAML
     * @param displayName the name that messages give it
     * @return inline, by a file's name, or not at all
     * @throws InputRefusedException if it is no cell file, or neither keys nor a name stand after {@code camera:}
     */
    public static StatedCamera statedCamera(String text, String displayName) {
        YamlValue camera = cellFile(YamlValue.parse(text, displayName, WHAT, MAX_BYTES)).optional("camera");
        if (camera == null) {
            return new StatedCamera(StatedCamera.Kind.NONE, null, null);
        }
        if (isNamed(camera)) {
            YamlMapping named = camera.mapping(NAMED_EXAMPLE);
            YamlValue cameraName = named.optional("name");
            return new StatedCamera(StatedCamera.Kind.FILE, named.at("file").text(CellPhrase.CAMERA),
                    cameraName == null ? null : cameraName.text("name: cam0"));
        }
        return camera.isMapping() ? new StatedCamera(StatedCamera.Kind.INLINE, null, null)
                : new StatedCamera(StatedCamera.Kind.FILE, camera.text(CellPhrase.CAMERA), null);
    }

    /** The mapping at the top of a cell file, its kind and version judged. */
    private static YamlMapping cellFile(YamlValue top) {
        YamlMapping file = top.mapping(CellPhrase.A_CELL_FILE);
        YamlValue version = file.optional("cellgauge");
        if (version == null) {
            if (CameraFormat.of(file) != null) {
                throw top.refused(CellRefusal.IS_CAMERA_FILE);
            }
            if (file.optional("corners_px") != null || file.optional("image") != null) {
                throw top.refused(CellRefusal.IS_DETECTIONS_FILE);
            }
            throw file.missing("cellgauge", CellRefusal.MISSING, Refusal.of(CellPhrase.VERSION_LINE, VERSION));
        }
        version.whole(VERSION, VERSION, Refusal.of(CellPhrase.VERSION, VERSION));
        return file;
    }

    private Cell cell(YamlValue top, Function<YamlMapping, PinholeCamera> cameraOf) {
        YamlMapping file = cellFile(top);
        List<String> known = new ArrayList<>(Arrays.asList("cellgauge", "camera", "markers", "placement",
                "pixel_std_px", CameraReader.TONE_CURVE, "references", "objects", "target", "plan"));
        known.addAll(JointReader.KEYS);
        file.refuseUnknown(known);
        PinholeCamera camera = cameraOf.apply(file);
        YamlMapping markers = file.required("markers", MARKERS_EXAMPLE).mapping(MARKERS_EXAMPLE, "family", "size_mm",
                "size_std_mm", "flatness_mm", "print_gain_std_mm", "orientation");
        MarkerFamily family = family(markers.required("family", "family: square-binary"));
        YamlValue orientation = markers.optional("orientation");
        if (orientation != null) {
            if (!orientation.is("opencv")) {
                throw orientation.refused(CellRefusal.NO_ORIENTATION, orientation.text("orientation: opencv"));
            }
            family = family.asOpenCvDraws();
        }
        generalSize = markers.optional("size_mm");
        if (generalSize != null) {
            size(generalSize);
        }
        YamlMapping placement = file.optional("placement") == null ? null : placement(file.optional("placement"));
        OptionalDouble pixelStdPx = pixelStd(file.optional("pixel_std_px"));

        Map<Integer, YamlValue> lines = new HashMap<>();
        List<Reference> references = references(file, markers, family, placement, lines);
        YamlValue statedTarget = file.optional("target");
        Requirement target = statedTarget == null ? Requirement.NONE : requirement(statedTarget, Requirement.NONE);
        Map<Integer, Requirement> ownTargets = new HashMap<>();
        List<ObjectMarker> objects = objects(file.optional("objects"), markers, family, lines, target, ownTargets);
        YamlValue toneCurve = file.optional(CameraReader.TONE_CURVE);
        return JointReader.with(file, new Cell(camera, family, references, objects, pixelStdPx,
                OptionalDouble.empty(), prints(markers)))
                .withTarget(new Target(target, ownTargets))
                .withPlanning(planning(file.optional("plan"), objects))
                .withToneCurve(toneCurve == null ? cameraToneCurve : CameraReader.toneCurve(toneCurve))
                .withCalibration(calibration).withFocusDistanceM(focusDistanceM);
    }

    private static PrintPrecision prints(YamlMapping markers) {
        return new PrintPrecision(
                std(markers, "size_std_mm", CellPhrase.SIZE_STD,
                        PrintPrecision.USUAL.sizeStdMm()),
                std(markers, "flatness_mm", CellPhrase.FLATNESS_STD,
                        PrintPrecision.USUAL.flatnessMm()),
                std(markers, "print_gain_std_mm", CellPhrase.PRINT_GAIN_STD,
                        PrintPrecision.USUAL.printGainStdMm()));
    }

    private static double std(YamlMapping markers, String key, CellPhrase remedy, double usual) {
        YamlValue value = markers.optional(key);
        if (value == null) {
            return usual;
        }
        double std = value.number(remedy);
        if (!(std >= 0)) {
            throw value.refused(CellRefusal.NEGATIVE_DEVIATION, remedy);
        }
        return bounded(value, std, remedy);
    }

    /** The camera of an inline mapping or of the file it names, what is said of its tone curve kept aside. */
    private PinholeCamera camera(YamlValue value, NamedFile cameraFile) {
        CameraFile camera;
        if (isNamed(value)) {
            YamlMapping named = value.mapping(NAMED_EXAMPLE, "file", "name");
            YamlValue file = named.required("file", NAMED_EXAMPLE);
            YamlValue name = named.optional("name");
            camera = CameraReader.file(cameraFile.read(file, file.text(CellPhrase.CAMERA)),
                    name == null ? null : name.text("name: cam0"));
        } else {
            camera = CameraReader.file(value.isMapping() ? value
                    : cameraFile.read(value, value.text(CellPhrase.CAMERA)), null);
        }
        return kept(camera);
    }

    private PinholeCamera kept(CameraFile camera) {
        cameraToneCurve = camera.toneCurve();
        calibration = camera.calibration();
        focusDistanceM = camera.focusDistanceM();
        return camera.camera();
    }

    /** Whether what stands after {@code camera:} names a file and perhaps one of several cameras in it. */
    private static boolean isNamed(YamlValue camera) {
        return camera.isMapping() && camera.mapping(NAMED_EXAMPLE).optional("file") != null;
    }

    private static YamlValue from(CameraSource cameras, YamlValue value, String name) {
        try {
            return CameraReader.parse(cameras.read(name), name);
        } catch (IOException e) {
            throw noCamera(value, name, e);
        }
    }

    private static YamlValue beside(Path cellFile, YamlValue value, String name) {
        Path path;
        try {
            path = cellFile.resolveSibling(name);
        } catch (InvalidPathException e) {
            throw value.refused(CellRefusal.NO_FILE_NAME, name, CellPhrase.CAMERA);
        }
        if (!Files.exists(path)) {
            throw noCamera(value, path.toString(), new FileNotFoundException());
        }
        String text;
        try {
            text = InputFiles.text(path, CellPhrase.CAMERA_FILE, CameraReader.MAX_BYTES);
        } catch (InputRefusedException e) {
            throw new InputRefusedException(value.refusal(CellRefusal.CAMERA_FILE, e.refusal()), e);
        }
        return CameraReader.parse(text, path.toString());
    }

    private static InputRefusedException noCamera(YamlValue value, String name, IOException e) {
        return new InputRefusedException(e instanceof FileNotFoundException || e instanceof NoSuchFileException
                ? value.refusal(CellRefusal.NO_CAMERA_FILE, name)
                : value.refusal(CellRefusal.CAMERA_FILE_NOT_OPENED, name,
                        InputFiles.reason(e, CellPhrase.CAMERA_FILE)), e);
    }

    private static MarkerFamily family(YamlValue value) {
        String name = value.text("family: square-binary");
        MarkerFamily family = MarkerFamily.find(name);
        if (family == null) {
            throw value.refused(CellRefusal.NO_FAMILY, name, MarkerFamily.suggestion(name));
        }
        return family;
    }

    private static double size(YamlValue value) {
        double size = value.positive(CellPhrase.MARKER_SIZE);
        if (size < MIN_SIZE_MM) {
            throw value.refused(CellRefusal.MARKER_TOO_SMALL, CameraReader.plain(size));
        }
        return bounded(value, size, CellPhrase.MARKER_SIZE);
    }

    /** A length that is no more than a kilometre, so that sums of many stay finite. */
    static double bounded(YamlValue value, double lengthMm, Object remedy) {
        if (!(Math.abs(lengthMm) <= MAX_LENGTH_MM)) {
            throw value.refused(CellRefusal.TOO_LONG, CameraReader.plain(lengthMm), remedy);
        }
        return lengthMm;
    }

    static double[] point(YamlValue value) {
        double[] point = value.numbers(3, POSITION);
        for (double v : point) {
            bounded(value, v, POSITION);
        }
        return point;
    }

    /** A placement, its parts judged: a fault is reported where it stands and not where it is inherited. */
    private static YamlMapping placement(YamlValue value) {
        YamlMapping placement = value.mapping("{std_mm: [5, 5, 5], std_deg: 0.5}", "std_mm", "std_deg");
        if (placement.optional("std_mm") != null) {
            placementStdMm(placement.optional("std_mm"));
        }
        if (placement.optional("std_deg") != null) {
            placementStdDeg(placement.optional("std_deg"));
        }
        return placement;
    }

    static double[] placementStdMm(YamlValue value) {
        double[] std = value.numbers(3, CellPhrase.PLACEMENT_STDS);
        for (YamlValue item : value.items()) {
            double stdMm = bounded(item, item.positive(CellPhrase.PLACEMENT_STD), CellPhrase.PLACEMENT_STDS);
            if (stdMm > MAX_PLACEMENT_STD_MM) {
                throw item.refused(CellRefusal.OUT_OF_RANGE, 0, MAX_PLACEMENT_STD_MM, CameraReader.plain(stdMm),
                        CellPhrase.PLACEMENT_STDS);
            }
        }
        return std;
    }

    private static double placementStdDeg(YamlValue value) {
        double std = value.positive(CellPhrase.TURN_STD);
        if (std > MAX_STD_DEG) {
            throw value.refused(CellRefusal.DIRECTION_UNKNOWN, CameraReader.plain(std),
                    CameraReader.plain(MAX_STD_DEG));
        }
        return std;
    }

    private static OptionalDouble pixelStd(@Nullable YamlValue value) {
        if (value == null || value.is("auto")) {
            return OptionalDouble.empty();
        }
        return OptionalDouble.of(value.positive(CellPhrase.PIXEL_STD));
    }

    private List<Reference> references(YamlMapping file, YamlMapping markers, MarkerFamily family,
            @Nullable YamlMapping general, Map<Integer, YamlValue> lines) {
        YamlValue value = file.required("references", CellPhrase.REFERENCES);
        if (value.isEmpty() || value.isList() && value.items().isEmpty()) {
            throw value.refused(CellRefusal.NO_REFERENCE, CellPhrase.REFERENCES);
        }
        YamlMapping mapping = value.mapping(CellPhrase.REFERENCES);
        if (mapping.keys().isEmpty()) {
            throw value.refused(CellRefusal.NO_REFERENCE, CellPhrase.REFERENCES);
        }
        List<Reference> references = new ArrayList<>();
        for (Map.Entry<String, YamlValue> e : mapping.values().entrySet()) {
            int id = id(e.getKey(), e.getValue(), family, lines);
            YamlMapping entry = e.getValue().mapping("{position_mm: [x, y, z], rotation_deg: [psi, theta, phi]}",
                    "position_mm", "rotation_deg", "placement", "size_mm");
            YamlValue positionValue = entry.required("position_mm", "position_mm: " + POSITION);
            double[] position = point(positionValue);
            double[] rotation = rotation(entry.optional("rotation_deg"));
            RigidTransform worldFromMarker = RigidTransform.ofEuler(position[0], position[1], position[2],
                    Math.toRadians(rotation[0]), Math.toRadians(rotation[1]), Math.toRadians(rotation[2]));
            Reference reference = new Reference(id, size(entry, markers), worldFromMarker,
                    placement(file, entry, general));
            for (Reference other : references) {
                refuseSamePlace(reference, positionValue, other,
                        Objects.requireNonNull(lines.get(other.id()), "every reference read so far has its line"));
            }
            references.add(reference);
        }
        return references;
    }

    static double[] rotation(@Nullable YamlValue value) {
        if (value == null) {
            return new double[3];
        }
        double[] rotation = value.numbers(3, CellPhrase.ROTATION);
        for (double angle : rotation) {
            if (!(Math.abs(angle) <= MAX_ANGLE_DEG)) {
                throw value.refused(CellRefusal.MORE_THAN_A_TURN, CameraReader.plain(angle), CellPhrase.ROTATION);
            }
        }
        return rotation;
    }

    /** A placement that states both of its deviations. */
    static Placement placementOf(YamlValue value) {
        YamlMapping placement = placement(value);
        double[] stdMm = placementStdMm(stated("std_mm", placement, placement));
        return new Placement(stdMm[0], stdMm[1], stdMm[2],
                Math.toRadians(placementStdDeg(stated("std_deg", placement, placement))));
    }

    private static Placement placement(YamlMapping file, YamlMapping entry, @Nullable YamlMapping general) {
        YamlMapping own = entry.optional("placement") == null ? null : placement(entry.optional("placement"));
        YamlMapping last = general == null ? own : general;
        if (last == null) {
            throw file.missing("placement", CellRefusal.MISSING_AND_NO_OWN, entry.self().path(), entry.self().line(),
                    PLACEMENT_EXAMPLE);
        }
        YamlMapping first = own == null ? last : own;
        double[] stdMm = placementStdMm(stated("std_mm", first, last));
        return new Placement(stdMm[0], stdMm[1], stdMm[2],
                Math.toRadians(placementStdDeg(stated("std_deg", first, last))));
    }

    /** What the first of two mappings states that does; one must. */
    private static YamlValue stated(String key, YamlMapping first, YamlMapping last) {
        for (YamlMapping mapping : Arrays.asList(first, last)) {
            YamlValue value = mapping.optional(key);
            if (value != null) {
                return value;
            }
        }
        throw last.missing(key, CellRefusal.MISSING,
                key.equals("std_mm") ? "std_mm: [5, 5, 5]" : "std_deg: 0.5");
    }

    private double size(YamlMapping entry, YamlMapping markers) {
        YamlValue own = entry.optional("size_mm");
        YamlValue stated = own == null ? generalSize : own;
        if (stated == null) {
            throw markers.missing("size_mm", CellRefusal.MISSING_AND_NO_OWN, entry.self().path(),
                    entry.self().line(), CellPhrase.MARKER_SIZE_KEY);
        }
        return size(stated);
    }

    /** What is asked of objects; one of its own inherits what it leaves out. */
    private static Requirement requirement(YamlValue value, Requirement general) {
        YamlMapping stated = value.mapping(Refusal.of(CellPhrase.OR_DELETE, "{std_mm: 1.0}"), "std_mm", "tolerance_mm",
                "distance_mm", "tolerance_deg", "probability");
        Requirement found = new Requirement(limits(stated, "std_mm", CellPhrase.TARGET_STD, general.stdMm()),
                limits(stated, "tolerance_mm", CellPhrase.TARGET_TOLERANCE, general.toleranceMm()),
                limit(stated, "distance_mm", CellPhrase.TARGET_DISTANCE, general.distanceMm()),
                limit(stated, "tolerance_deg", CellPhrase.TARGET_TURN, general.toleranceDeg()),
                probability(stated, general.probability()));
        if (!found.isAny()) {
            throw stated.missing("std_mm", CellRefusal.MISSING, "std_mm: 1.0");
        }
        if (!found.asksForProbability() && stated.optional("probability") != null) {
            throw stated.missing("tolerance_mm", CellRefusal.MISSING, "tolerance_mm: 1.0");
        }
        return found;
    }

    private static Requirement.Axes limits(YamlMapping stated, String key, CellPhrase remedy,
            Requirement.Axes general) {
        YamlValue value = stated.optional(key);
        if (value == null) {
            return general;
        }
        if (!value.isList()) {
            return Requirement.Axes.all(value.positive(remedy));
        }
        value.numbers(3, remedy);
        double[] limits = value.items().stream().mapToDouble(item -> item.positive(remedy)).toArray();
        return new Requirement.Axes(limits[0], limits[1], limits[2]);
    }

    private static double limit(YamlMapping stated, String key, CellPhrase remedy, double general) {
        YamlValue value = stated.optional(key);
        return value == null ? general : value.positive(remedy);
    }

    private static Planning planning(@Nullable YamlValue value, List<ObjectMarker> objects) {
        if (value == null) {
            return Planning.NONE;
        }
        YamlMapping plan = value.mapping(Refusal.of(CellPhrase.OR_DELETE, "{max_height_mm: 200}"), "camera_pose",
                "camera_range", "regions_mm", "free_mm", "walls_mm", "max_height_mm", "costs");
        YamlValue height = plan.optional("max_height_mm");
        return new Planning(cameraPose(plan.optional("camera_pose")), cameraRange(plan.optional("camera_range")),
                regions(plan.optional("regions_mm"), objects), areas(plan.optional("free_mm")),
                walls(plan.optional("walls_mm")), height == null ? OptionalDouble.empty()
                        : OptionalDouble.of(notNegative(height, CellPhrase.MAX_HEIGHT)), costs(plan.optional("costs")));
    }

    private static double notNegative(YamlValue value, CellPhrase remedy) {
        double number = value.number(remedy);
        if (!(number >= 0)) {
            throw value.refused(CellRefusal.NEGATIVE, CameraReader.plain(number), remedy);
        }
        return number;
    }

    private static @Nullable RigidTransform cameraPose(@Nullable YamlValue value) {
        if (value == null) {
            return null;
        }
        double[] v = value.numbers(6, CellPhrase.CAMERA_POSE);
        return RigidTransform.ofEuler(v[0], v[1], v[2], Math.toRadians(v[3]), Math.toRadians(v[4]),
                Math.toRadians(v[5]));
    }

    private static CameraRange cameraRange(@Nullable YamlValue value) {
        if (value == null) {
            return CameraRange.NONE;
        }
        YamlMapping range = value.mapping("{position_mm: [50, 50, 50], turn_deg: 5}", "position_mm", "turn_deg");
        double[] mm = new double[3];
        YamlValue position = range.optional("position_mm");
        if (position != null) {
            position.numbers(3, CellPhrase.RANGE);
            mm = position.items().stream().mapToDouble(v -> notNegative(v, CellPhrase.RANGE)).toArray();
        }
        YamlValue turn = range.optional("turn_deg");
        return new CameraRange(mm[0], mm[1], mm[2], turn == null ? 0 : notNegative(turn, CellPhrase.RANGE));
    }

    private static Map<Integer, Area> regions(@Nullable YamlValue value, List<ObjectMarker> objects) {
        Map<Integer, Area> regions = new LinkedHashMap<>();
        if (value != null) {
            for (Map.Entry<String, YamlValue> e : value.mapping("{5: [0, 0, 500, 400]}").values().entrySet()) {
                ObjectMarker object = objects.stream().filter(o -> String.valueOf(o.id()).equals(e.getKey()))
                        .findFirst().orElseThrow(() -> e.getValue().refused(CellRefusal.NO_SUCH_OBJECT, e.getKey()));
                regions.put(object.id(), area(e.getValue()));
            }
        }
        return regions;
    }

    private static Area area(YamlValue value) {
        return Area.ofCorners(value.numbers(4, CellPhrase.AREA));
    }

    private static List<Area> areas(@Nullable YamlValue value) {
        List<Area> areas = new ArrayList<>();
        if (value != null) {
            value.items().forEach(item -> areas.add(area(item)));
        }
        return areas;
    }

    private static List<Wall> walls(@Nullable YamlValue value) {
        List<Wall> walls = new ArrayList<>();
        if (value != null) {
            for (YamlValue item : value.items()) {
                double[] v = item.numbers(5, CellPhrase.WALL);
                if (!(v[4] > 0) || v[0] == v[2] && v[1] == v[3]) {
                    throw item.refused(CellRefusal.NO_WALL, CellPhrase.WALL);
                }
                walls.add(new Wall(v[0], v[1], v[2], v[3], v[4]));
            }
        }
        return walls;
    }

    private static Map<ChangeKind, Double> costs(@Nullable YamlValue value) {
        Map<ChangeKind, Double> costs = new EnumMap<>(ChangeKind.class);
        if (value != null) {
            YamlMapping stated = value.mapping("{raise-reference: 40}",
                    Arrays.stream(ChangeKind.values()).map(ChangeKind::code).toArray(String[]::new));
            for (ChangeKind kind : ChangeKind.values()) {
                YamlValue cost = stated.optional(kind.code());
                if (cost != null) {
                    costs.put(kind, notNegative(cost, CellPhrase.COST));
                }
            }
        }
        return costs;
    }

    private static double probability(YamlMapping stated, double general) {
        YamlValue value = stated.optional("probability");
        if (value == null) {
            return general;
        }
        double probability = value.positive(CellPhrase.TARGET_PROBABILITY);
        if (!(probability < 1)) {
            throw value.refused(CellRefusal.NOT_BELOW_ONE, CameraReader.plain(probability),
                    CellPhrase.TARGET_PROBABILITY);
        }
        return probability;
    }

    private List<ObjectMarker> objects(@Nullable YamlValue value, YamlMapping markers, MarkerFamily family,
            Map<Integer, YamlValue> lines, Requirement target, Map<Integer, Requirement> ownTargets) {
        List<ObjectMarker> objects = new ArrayList<>();
        if (value == null || value.isEmpty()) {
            return objects;
        }
        for (Map.Entry<String, YamlValue> e : value.mapping(CellPhrase.OBJECTS).values()
                .entrySet()) {
            int id = id(e.getKey(), e.getValue(), family, lines);
            double @Nullable [] grip = null;
            double size;
            boolean moves = false;
            if (e.getValue().isEmpty()) {
                // "5:" says the same as "5: {}"
                if (generalSize == null) {
                    throw markers.missing("size_mm", CellRefusal.MISSING_AND_NO_OWN, e.getValue().path(),
                            e.getValue().line(), "size_mm: 47");
                }
                size = size(generalSize);
            } else {
                YamlMapping entry = e.getValue().mapping(CellPhrase.OBJECT, "grip_mm", "size_mm", "target", "moves");
                grip = entry.optional("grip_mm") == null ? null : point(entry.optional("grip_mm"));
                size = size(entry, markers);
                YamlValue own = entry.optional("target");
                if (own != null) {
                    ownTargets.put(id, requirement(own, target));
                }
                YamlValue moving = entry.optional("moves");
                moves = moving != null && moving.is("true");
                if (moving != null && !moves && !moving.is("false")) {
                    throw moving.refused(CellRefusal.NO_YES_OR_NO, "moves");
                }
            }
            objects.add(new ObjectMarker(id, size, grip, moves));
        }
        return objects;
    }

    private static int id(String key, YamlValue value, MarkerFamily family, Map<Integer, YamlValue> lines) {
        if (!key.matches("0|[1-9]\\d{0,8}")) {
            throw value.refused(CellRefusal.NO_ID, key, family.size() - 1);
        }
        int id = Integer.parseInt(key);
        if (!family.has(id)) {
            throw value.refused(CellRefusal.ID_NOT_IN_FAMILY, family.toString(), id, family.size() - 1);
        }
        if (family.isAmbiguous(id)) {
            throw value.refused(CellRefusal.ID_AMBIGUOUS, id, family.toString());
        }
        YamlValue earlier = lines.putIfAbsent(id, value);
        if (earlier != null) {
            throw value.refused(CellRefusal.MARKER_TWICE, id, earlier.line(), earlier.path());
        }
        return id;
    }

    private static void refuseSamePlace(Reference reference, YamlValue position, Reference other, YamlValue otherLine) {
        double[] a = reference.worldFromMarker().translationMm();
        double[] b = other.worldFromMarker().translationMm();
        double distance = Math.sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1])
                + (a[2] - b[2]) * (a[2] - b[2]));
        double[] ra = reference.worldFromMarker().rotation();
        double[] rb = other.worldFromMarker().rotation();
        double cosine = ra[2] * rb[2] + ra[5] * rb[5] + ra[8] * rb[8];
        // two faces of a thin plate lie at one place too, but look away from each other
        if (distance < 0.5 * Math.max(reference.sizeMm(), other.sizeMm()) && cosine > SAME_PLANE_COSINE) {
            throw position.refused(CellRefusal.SAME_PLACE, other.id(), otherLine.line(), reference.id(),
                    Decimal.of(distance, 1));
        }
    }
}
