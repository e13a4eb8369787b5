package org.cellgauge.cell;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.cellgauge.cell.CalibrationTarget.Grid;
import org.cellgauge.cell.CalibrationTarget.Markers;
import org.cellgauge.cell.CalibrationTarget.Pattern;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.cell.InputFiles;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.internal.warning.Listing;
import org.jspecify.annotations.Nullable;

/**
 * Reads and judges target files (YAML, version 1): what was photographed to calibrate a camera.
 *
 * <p>A file holds {@code cellgauge_target: 1} and one of
 * <pre>
 * chessboard: {rows: 7, columns: 5, square_mm: 30}
 * ecocheck: {rows: 10, columns: 7, square_mm: 30}
 * circle_grid: {rows: 8, columns: 10, diameter_mm: 20, spacing_mm: 40}
 * hexagonal_circle_grid: {rows: 8, columns: 10, diameter_mm: 20, spacing_mm: 40}
 * charuco: {rows: 8, columns: 11, square_mm: 24, marker_mm: 18, family: aruco-mip-36h12}
 * marker_plate: {family: apriltag-36h11, size_mm: 40, positions_mm: {0: [0, 0], 1: [60, 0]}}
 * cell: {file: cell.yaml}
 * </pre>
 * Rows and columns count squares, not corners. Positions are those of markers' centres, x to the right and y up as the
 * plate is seen. BoofCV's own target files are read too; a length of theirs counts as mm, which no intrinsic depends
 * on.
 */
public final class CalibrationTargetReader {
    /** Largest target file that is read, bytes. */
    public static final int MAX_BYTES = 1 << 20;
    /** Version of the format that is read. */
    public static final int VERSION = 1;

    private static final String BOOFCV = "boofcv.alg.fiducial.calib.ConfigCalibrationTarget";
    private static final String CHARUCO = "charuco";
    private static final String MARKER_PLATE = "marker_plate";
    private static final String CELL = "cell";
    private static final List<String> TARGETS = Arrays.asList(Pattern.CHESSBOARD.key(), Pattern.ECOCHECK.key(),
            Pattern.CIRCLE_GRID.key(), Pattern.HEXAGONAL_CIRCLE_GRID.key(), CHARUCO, MARKER_PLATE, CELL);
    private static final int MAX_COUNT = 1000;
    private static final String CENTRE = "[x, y] of its centre in mm";
    /** A surveyed reference is known at least so well, mm. */
    private static final double SURVEYED_STD_MM = 1;
    /** Places of no marker do not count: any will do. */
    private static final Placement EXACT = new Placement(0.01, 0.01, 0.01, 1e-4);

    private CalibrationTargetReader() {
    }

    /**
     * Reads a target file, and the cell file that it may name.
     *
     * @param file the target file
     * @return the target
     * @throws InputRefusedException if one of the two is missing or faulty
     */
    public static CalibrationTarget read(Path file) {
        YamlValue top = YamlValue.parse(InputFiles.text(file, TargetRefusal.TARGET_FILE, MAX_BYTES), file.toString(),
                TargetRefusal.TARGET_FILE, MAX_BYTES);
        YamlMapping keys = top.mapping(TargetRefusal.A_TARGET_FILE);
        if (keys.optional(BOOFCV) != null) {
            return ofBoofCv(keys.required(BOOFCV, BOOFCV));
        }
        YamlValue version = keys.optional("cellgauge_target");
        if (version == null) {
            if (keys.optional("cellgauge") != null) {
                throw top.refused(TargetRefusal.IS_CELL_FILE);
            }
            throw keys.missing("cellgauge_target", CellRefusal.MISSING, "cellgauge_target: " + VERSION);
        }
        version.whole(VERSION, VERSION, "cellgauge_target: " + VERSION);
        List<String> known = new ArrayList<>(TARGETS);
        known.add("cellgauge_target");
        keys.refuseUnknown(known);
        List<String> stated = new ArrayList<>(keys.keys());
        stated.retainAll(TARGETS);
        if (stated.size() != 1) {
            throw top.refused(TargetRefusal.NOT_ONE_TARGET, Listing.comma(new ArrayList<>(TARGETS)));
        }
        String kind = stated.get(0);
        YamlValue value = keys.required(kind, kind);
        switch (kind) {
            case CHARUCO:
                return charuco(value);
            case MARKER_PLATE:
                return plate(value);
            case CELL:
                return surveyed(value, file);
            default:
                return grid(value, kind);
        }
    }

    private static int count(YamlMapping keys, String key, int least) {
        return keys.required(key, key + ": 7").whole(least, MAX_COUNT, TargetRefusal.COUNT);
    }

    private static double length(YamlMapping keys, String key) {
        YamlValue value = keys.required(key, key + ": 30");
        return CellReader.bounded(value, value.positive(TargetRefusal.LENGTH), TargetRefusal.LENGTH);
    }

    private static Grid grid(YamlValue value, String kind) {
        Pattern pattern = Arrays.stream(Pattern.values()).filter(p -> p.key().equals(kind)).findFirst().orElseThrow();
        if (pattern.isOfCircles()) {
            YamlMapping keys = value.mapping("{rows: 8, columns: 10, diameter_mm: 20, spacing_mm: 40}", "rows",
                    "columns", "diameter_mm", "spacing_mm");
            double diameter = length(keys, "diameter_mm");
            double spacing = length(keys, "spacing_mm");
            if (!(diameter < spacing)) {
                throw keys.at("spacing_mm").refused(TargetRefusal.CIRCLES_TOUCH, Decimal.shortest(diameter),
                        Decimal.shortest(spacing));
            }
            return new Grid(pattern, count(keys, "rows", 2), count(keys, "columns", 2), diameter, spacing);
        }
        YamlMapping keys = value.mapping("{rows: 7, columns: 5, square_mm: 30}", "rows", "columns", "square_mm");
        double square = length(keys, "square_mm");
        return new Grid(pattern, count(keys, "rows", 3), count(keys, "columns", 3), square, square);
    }

    private static MarkerFamily family(YamlMapping keys) {
        YamlValue value = keys.required("family", "family: aruco-mip-36h12");
        String name = value.text("family: aruco-mip-36h12");
        MarkerFamily family = MarkerFamily.find(name);
        if (family == null) {
            throw value.refused(CellRefusal.NO_FAMILY, name, MarkerFamily.suggestion(name));
        }
        return family;
    }

    private static Reference marker(int id, double sizeMm, double x, double y) {
        return new Reference(id, sizeMm, RigidTransform.of(new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1},
                new double[] {x, y, 0}), EXACT);
    }

    /** OpenCV's board: the squares where row and column are both even or both odd are black, ids run along rows. */
    private static Markers charuco(YamlValue value) {
        YamlMapping keys = value.mapping("{rows: 8, columns: 11, square_mm: 24, marker_mm: 18, family: "
                + "aruco-mip-36h12}", "rows", "columns", "square_mm", "marker_mm", "family", "first_id", "legacy");
        MarkerFamily family = family(keys);
        int rows = count(keys, "rows", 2);
        int columns = count(keys, "columns", 2);
        double square = length(keys, "square_mm");
        double size = length(keys, "marker_mm");
        if (!(size < square)) {
            throw keys.at("marker_mm").refused(TargetRefusal.MARKER_OVER_SQUARE, Decimal.shortest(size),
                    Decimal.shortest(square));
        }
        YamlValue first = keys.optional("first_id");
        YamlValue legacy = keys.optional("legacy");
        int id = first == null ? 0 : first.whole(0, family.size() - 1, "first_id: 0");
        int white = legacy != null && legacy.is("true") && rows % 2 == 0 ? 0 : 1;
        List<Reference> markers = new ArrayList<>();
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                if ((row + column) % 2 == white) {
                    requireId(value, family, id);
                    markers.add(marker(id++, size, (column + 0.5 - columns / 2.0) * square,
                            (rows / 2.0 - row - 0.5) * square));
                }
            }
        }
        return new Markers(CHARUCO, family, markers, true);
    }

    private static void requireId(YamlValue value, MarkerFamily family, int id) {
        if (!family.has(id)) {
            throw value.refused(TargetRefusal.NO_SUCH_ID, id, family.size() - 1);
        }
    }

    private static Markers plate(YamlValue value) {
        YamlMapping keys = value.mapping("{family: apriltag-36h11, size_mm: 40, positions_mm: {0: [0, 0], 1: [60, 0]}}",
                "family", "size_mm", "positions_mm");
        MarkerFamily family = family(keys);
        double size = length(keys, "size_mm");
        YamlMapping positions = keys.required("positions_mm", "positions_mm: {0: [0, 0], 1: [60, 0]}")
                .mapping("{0: [0, 0], 1: [60, 0]}");
        List<Reference> markers = new ArrayList<>();
        for (Map.Entry<String, YamlValue> entry : positions.values().entrySet()) {
            int id = entry.getKey().matches("\\d{1,6}") ? Integer.parseInt(entry.getKey()) : -1;
            requireId(entry.getValue(), family, id);
            double[] at = entry.getValue().numbers(2, CENTRE);
            markers.add(marker(id, size, CellReader.bounded(entry.getValue(), at[0], CENTRE),
                    CellReader.bounded(entry.getValue(), at[1], CENTRE)));
        }
        return new Markers(MARKER_PLATE, family, markers, true);
    }

    private static Markers surveyed(YamlValue value, Path targetFile) {
        YamlMapping keys = value.mapping("{file: cell.yaml}", "file");
        YamlValue name = keys.required("file", "file: cell.yaml");
        String stated = name.text("cell.yaml");
        Path file;
        try {
            file = targetFile.resolveSibling(stated);
        } catch (InvalidPathException e) {
            throw name.refused(TargetRefusal.NO_CELL_FILE, stated);
        }
        if (!Files.exists(file)) {
            throw name.refused(TargetRefusal.NO_CELL_FILE, file.toString());
        }
        // the camera is what is sought: any stands in for it
        Cell cell = CellReader.read(InputFiles.text(file, TargetRefusal.TARGET_FILE, CellReader.MAX_BYTES),
                file.toString(), PinholeCamera.fromFieldOfView(1, 1, 1));
        for (Reference reference : cell.references()) {
            double std = Math.max(reference.placement().stdMm(0), Math.max(reference.placement().stdMm(1),
                    reference.placement().stdMm(2)));
            if (std > SURVEYED_STD_MM) {
                throw name.refused(TargetRefusal.NOT_SURVEYED, reference.id(), Decimal.shortest(std));
            }
        }
        return new Markers(CELL, cell.family(), cell.references(), false);
    }

    /** What BoofCV's programs write beside printed targets: a type, a chessboard where none stands, and its sizes. */
    private static Grid ofBoofCv(YamlValue value) {
        YamlMapping keys = value.mapping("the keys that BoofCV writes");
        YamlValue type = keys.optional("type");
        String name = type == null ? "CHESSBOARD" : type.text("CHESSBOARD");
        switch (name) {
            case "CHESSBOARD":
                return boofGrid(keys, Pattern.CHESSBOARD);
            case "CIRCLE_GRID":
                return boofGrid(keys, Pattern.CIRCLE_GRID);
            case "CIRCLE_HEX":
                return boofGrid(keys, Pattern.HEXAGONAL_CIRCLE_GRID);
            case "ECOCHECK":
                YamlMapping eco = keys.required("ecocheck", "ecocheck:")
                        .mapping("markerShapes: and the shape of one marker");
                List<YamlValue> shapes = eco.required("markerShapes", "markerShapes:").items();
                if (shapes.isEmpty()) {
                    throw eco.missing("markerShapes", CellRefusal.MISSING, "markerShapes: and the shape of one marker");
                }
                YamlMapping shape = shapes.get(0).mapping("{numRows: 10, numCols: 7, squareSize: 30}");
                double square = length(shape, "squareSize");
                return new Grid(Pattern.ECOCHECK, count(shape, "numRows", 3), count(shape, "numCols", 3), square,
                        square);
            default:
                throw refusedType(type, value, name);
        }
    }

    private static InputRefusedException refusedType(@Nullable YamlValue type, YamlValue value, String name) {
        return (type == null ? value : type).refused(TargetRefusal.OTHER_TYPE, name);
    }

    private static Grid boofGrid(YamlMapping keys, Pattern pattern) {
        YamlMapping grid = keys.required("grid", "grid:").mapping("{numRows: 7, numCols: 5, shapeSize: 30}");
        double size = length(grid, "shapeSize");
        double spacing = pattern.isOfCircles() ? length(grid, "shapeDistance") : size;
        return new Grid(pattern, count(grid, "numRows", 2), count(grid, "numCols", 2), size, spacing);
    }
}
