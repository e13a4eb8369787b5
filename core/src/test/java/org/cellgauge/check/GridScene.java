package org.cellgauge.check;

import java.util.LinkedHashMap;
import java.util.Map;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.internal.validation.CellTruth;
import org.cellgauge.internal.validation.SimulatedPhoto;
import org.cellgauge.vision.Detections;

/** As many references as one likes on a grid of half a metre, and as many objects above them, in one photo. */
public final class GridScene {
    public static final RigidTransform WORLD_FROM_CAMERA = RigidTransform.ofEuler(250, 190, 900, 3.0, 0.1, 0);
    private static final PinholeCamera CAMERA = PinholeCamera.ideal(3840, 2160, 1743, 1743, 1920, 1080);
    private static final int FIRST_OBJECT = 1000;
    private static final double WIDTH_MM = 500;
    private static final double HEIGHT_MM = 380;
    private static final double HEIGHT_OF_OBJECTS_MM = 60;
    private static final double LARGEST_MM = 30;
    /** Markers of one row lie side by side if they are smaller than this by the gaps between them. */
    private static final double ROW_MM = 300;
    private static final double PIXEL_STD = 0.1;

    public final Cell cell;
    public final Detections detections;

    private GridScene(Cell cell, Detections detections) {
        this.cell = cell;
        this.detections = detections;
    }

    /** At least two references, and any number of objects. */
    public static GridScene of(int references, int objects) {
        int perRow = Math.max(2, (int) Math.ceil(Math.sqrt(references)));
        int objectsPerRow = Math.max(10, (int) Math.ceil(Math.sqrt(objects)));
        double sizeMm = Math.min(LARGEST_MM, ROW_MM / (Math.max(perRow, objectsPerRow) - 1));
        StringBuilder yaml = new StringBuilder("cellgauge: 1\nmarkers: {family: square-binary, size_mm: " + sizeMm
                + "}\nplacement: {std_mm: [1, 1, 1], std_deg: 0.2}\npixel_std_px: " + PIXEL_STD + "\nreferences:\n");
        for (int i = 0; i < references; i++) {
            yaml.append("  ").append(i + 1).append(": {position_mm: [")
                    .append(WIDTH_MM * (i % perRow) / (perRow - 1)).append(", ")
                    .append(HEIGHT_MM * (i / perRow) / (perRow - 1)).append(", 0], rotation_deg: [0, 0, 0]}\n");
        }
        yaml.append(objects > 0 ? "objects:\n" : "");
        Map<Integer, RigidTransform> worldFromObjects = new LinkedHashMap<>();
        for (int i = 0; i < objects; i++) {
            yaml.append("  ").append(FIRST_OBJECT + i).append(": {}\n");
            worldFromObjects.put(FIRST_OBJECT + i, RigidTransform.ofEuler(30 + 450.0 / objectsPerRow
                    * (i % objectsPerRow), 20 + 350.0 / objectsPerRow * (i / objectsPerRow), HEIGHT_OF_OBJECTS_MM,
                    0.3, 0.2 * (i % 3), 0.1 * i));
        }
        Cell cell = CellReader.read(yaml.toString(), "grid", CAMERA);
        CellTruth truth = new CellTruth(WORLD_FROM_CAMERA, worldFromObjects);
        return new GridScene(cell, SimulatedPhoto.of(cell, truth, PIXEL_STD, RandomStreams.of(5),
                RandomStreams.of(4)));
    }
}
