package org.cellgauge.bench;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.internal.validation.CellTruth;
import org.cellgauge.internal.validation.SimulatedPhoto;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.Detections;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** How a whole check of 700 iterations grows with the markers of a cell: references by objects. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 2, time = 2)
@Measurement(iterations = 3, time = 2)
public class GrowthBenchmark {
    private static final int FIRST_OBJECT = 1000;
    private static final double WIDTH_MM = 500;
    private static final double HEIGHT_MM = 380;

    /** References on a grid, and objects above them. */
    @Param({"2 1", "6 1", "25 1", "100 1", "4 1", "4 6", "4 25", "4 100"})
    public String markers = "2 1";

    private Cell cell;
    private Detections detections;
    private CheckSettings settings;

    @Setup
    public void prepare() {
        int space = markers.indexOf(' ');
        int references = Integer.parseInt(markers.substring(0, space));
        int objects = Integer.parseInt(markers.substring(space + 1));
        int perRow = (int) Math.ceil(Math.sqrt(references));
        StringBuilder yaml = new StringBuilder("cellgauge: 1\nmarkers: {family: square-binary, size_mm: 30}\n"
                + "placement: {std_mm: [1, 1, 1], std_deg: 0.2}\npixel_std_px: 0.1\nreferences:\n");
        for (int i = 0; i < references; i++) {
            yaml.append("  ").append(i + 1).append(": {position_mm: [")
                    .append(WIDTH_MM * (i % perRow) / (perRow - 1)).append(", ")
                    .append(HEIGHT_MM * (i / perRow) / (perRow - 1)).append(", 0], rotation_deg: [0, 0, 0]}\n");
        }
        yaml.append("objects:\n");
        Map<Integer, RigidTransform> worldFromObjects = new LinkedHashMap<>();
        for (int i = 0; i < objects; i++) {
            yaml.append("  ").append(FIRST_OBJECT + i).append(": {}\n");
            worldFromObjects.put(FIRST_OBJECT + i, RigidTransform.ofEuler(30 + 45 * (i % 10), 20 + 35 * (i / 10), 60,
                    0.3, 0.2 * (i % 3), 0.1 * i));
        }
        cell = CellReader.read(yaml.toString(), "grid", ThesisScene.CAMERA);
        CellTruth truth = new CellTruth(RigidTransform.ofEuler(250, 190, 900, Math.PI, 0, 0), worldFromObjects);
        detections = SimulatedPhoto.of(cell, truth, 0.1, RandomStreams.of(3), RandomStreams.of(4));
        settings = CheckSettings.builder().threads(1).seed(1).iterations(700).build();
    }

    @Benchmark
    public CheckResult wholeCheck() {
        return CellCheck.run(cell, detections, settings);
    }
}
