package org.cellgauge.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.concurrent.TimeUnit;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.PrintPrecision;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.validation.SimulatedSurvey;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.survey.Survey;
import org.cellgauge.survey.SurveyResult;
import org.cellgauge.vision.Detections;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** Photos of a cell of twelve references and five objects: one more, all of them, and what they say. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class SurveyBenchmark {
    private static final CheckSettings SETTINGS = CheckSettings.builder().threads(1).build();
    private static final int REFERENCES = 12;
    private static final int OBJECTS = 5;
    private static final int FEW = 20;
    private static final int MANY = 50;

    private Cell cell;
    private List<Detections> photos;
    private Survey few;
    private Survey many;

    @Setup
    public void prepare() {
        List<Reference> placed = new ArrayList<>();
        for (int i = 0; i < REFERENCES; i++) {
            double angle = 2 * Math.PI * i / REFERENCES;
            placed.add(new Reference(100 + i, 60, RigidTransform.ofEuler(450 * Math.cos(angle), 300 * Math.sin(angle),
                    i % 3 == 0 ? 100 : 0, 0, 0, 0), new Placement(5, 5, 5, Math.toRadians(0.5))));
        }
        List<ObjectMarker> objects = new ArrayList<>();
        for (int i = 0; i < OBJECTS; i++) {
            objects.add(new ObjectMarker(i + 1, 60, null));
        }
        cell = new Cell(PinholeCamera.ideal(1280, 720, 900, 900, 640, 360), MarkerFamily.SQUARE_BINARY, placed, objects,
                OptionalDouble.of(0.3), OptionalDouble.empty(), new PrintPrecision(0, 0, 0));
        photos = SimulatedSurvey.of(cell, SETTINGS, MANY, 3, 0).photos();
        few = Survey.of(cell, photos.subList(0, FEW), SETTINGS);
        many = Survey.of(cell, photos.subList(0, MANY - 1), SETTINGS);
    }

    /** The 21st photo as it arrives. */
    @Benchmark
    public Survey oneMoreThanTwenty() {
        return few.with(photos.get(FEW));
    }

    /** The 50th. */
    @Benchmark
    public Survey oneMoreThanFortyNine() {
        return many.with(photos.get(MANY - 1));
    }

    /** Fifty photos at once, first poses included. */
    @Benchmark
    public Survey fifty() {
        return Survey.of(cell, photos, SETTINGS);
    }

    /** What twenty photos say: tests, budgets, curves. */
    @Benchmark
    public SurveyResult whatTwentySay() {
        return few.estimate();
    }
}
