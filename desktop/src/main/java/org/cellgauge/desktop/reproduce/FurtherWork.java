package org.cellgauge.desktop.reproduce;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CellEstimate;
import org.cellgauge.check.CheckResult;
import org.cellgauge.estimate.IntrinsicsEstimate;
import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Estimate;
import org.cellgauge.settings.InitialEstimate;
import org.cellgauge.settings.LikelihoodModel;
import org.cellgauge.settings.ObjectNoise;
import org.cellgauge.vision.Detections;

/** The further work that the thesis asks for: exact corners, of a fine noise as it is stated. */
final class FurtherWork {
    static final double[] GRIP_MM = {0, 0, 100};
    /** How far one reference stands off, mm, and how precisely all are said to be placed. */
    static final double OFF_MM = 50;
    static final double OFF_OF_MM = 5;
    static final int OFF_ID = 944;
    /** So wide that it says nothing: the thesis states no prior. */
    private static final double FLAT_PX = 1e5;
    private static final List<String> IN_ORDER = List.of("944", "1234", "911", "22", "5th", "6th", "7th", "8th", "9th",
            "10th", "11th", "12th");

    private final Assumptions assumptions;
    private final Effort effort;
    private final Map<String, SetUp> setUps;

    FurtherWork(Assumptions usual, Map<String, SetUp> setUps, Effort effort) {
        this.assumptions = usual.withExactCorners(usual.finePixelStdPx());
        this.setUps = setUps;
        this.effort = effort;
    }

    /** Focal lengths to start with, px. */
    List<Double> startsPx() {
        return effort.isQuick() ? List.of(250.0, 1200.0) : List.of(250.0, 400.0, 581.0, 800.0, 1200.0);
    }

    /** Experiments whose focal length is started elsewhere. */
    List<String> started() {
        return effort.isQuick() ? List.of("focal-plane-3") : List.of("focal-plane-3", "focal-raised-6");
    }

    /** Numbers of references, four and twelve among them. */
    List<Integer> counts() {
        return effort.isQuick() ? List.of(2, 4, 12) : List.of(2, 3, 4, 6, 8, 10, 12);
    }

    /** How precisely they are placed, mm; 1 and 20 among them. */
    List<Double> placedMm() {
        return effort.isQuick() ? List.of(1.0, 20.0) : List.of(1.0, 5.0, 20.0);
    }

    /** Experiments of the thesis with more references than it had. */
    List<Integer> more() {
        return effort.isQuick() ? List.of(12) : List.of(8, 10, 12);
    }

    List<Work> all() {
        List<Work> all = new ArrayList<>();
        all.add(work("further-corners", this::corners));
        all.add(work("further-grip", this::grip));
        all.add(work("further-intrinsics", this::intrinsics));
        all.add(work("further-start", this::starts));
        for (boolean raised : new boolean[] {false, true}) {
            for (double placed : placedMm()) {
                all.add(work(moreName(raised, placed), () -> more(raised, placed)));
            }
        }
        all.add(work("further-misplaced", this::misplaced));
        for (int count : more()) {
            all.add(SetUpWork.of("further-thesis-" + count, withReferences("focal-plane-6", count), assumptions,
                    effort));
        }
        return all;
    }

    static String moreName(boolean raised, double placedMm) {
        return "further-more-" + (raised ? "raised-" : "plane-") + Words.number(placedMm);
    }

    private Work work(String name, Supplier<Figures> figures) {
        return new Work(name, effort + "\n" + assumptions.identity(), figures);
    }

    private SetUp setUp(String name) {
        return Objects.requireNonNull(setUps.get(name), name);
    }

    private SetUp withReferences(String name, int count) {
        SetUp like = setUp(name);
        List<String> names = new ArrayList<>(IN_ORDER.subList(0, count));
        if (like.raised()) {
            if (count == 2) {
                names = new ArrayList<>(setUp("focal-raised-2").references());
            } else if (count == 3) {
                names = new ArrayList<>(setUp("focal-raised-3").references());
            } else {
                names.set(names.indexOf("22"), "22-raised");
            }
        } else if (count == 2) {
            names = new ArrayList<>(setUp("focal-plane-2").references());
        }
        return like.with(name + "-of-" + count, names);
    }

    /** Errors of objects in deviations stated of them, root mean squares: across, then in depth. */
    private Figures corners() {
        Map<String, CheckSettings> models = new LinkedHashMap<>();
        models.put("cube 0.5", CheckSettings.builder().likelihood(LikelihoodModel.CORNER_CUBE).kappa(0.5)
                .objectNoise(ObjectNoise.NONE).build());
        models.put("cube 1", CheckSettings.builder().likelihood(LikelihoodModel.CORNER_CUBE).kappa(1)
                .objectNoise(ObjectNoise.NONE).build());
        models.put("rigid", CheckSettings.builder().objectNoise(ObjectNoise.NONE).build());
        SetUp setUp = setUp("plane-4-low");
        Cell cell = setUp.cell(assumptions);
        Map<Integer, RigidTransform> objects = assumptions.objects(setUp.objects());
        Figures.Builder figures = new Figures.Builder();
        models.forEach((name, settings) -> {
            double across = 0;
            double deep = 0;
            int count = 0;
            for (int i = 0; i < effort.cells(); i++) {
                Detections drawn = SetUp.drawn(cell, assumptions.worldFromCamera(setUp.cameraPose()), objects, i + 1L);
                CellEstimate estimate = CellCheck.quickLook(cell, drawn, settings, null).update().estimate();
                for (ObjectEstimate object : estimate.objects()) {
                    double[] truth = Objects.requireNonNull(objects.get(object.id())).translationMm();
                    double[] mean = object.pose().mean();
                    double[] std = object.pose().std();
                    across += (square((mean[0] - truth[0]) / std[0]) + square((mean[1] - truth[1]) / std[1])) / 2;
                    deep += square((mean[2] - truth[2]) / std[2]);
                    count++;
                }
            }
            figures.put(name, Math.sqrt(across / count), Math.sqrt(deep / count));
        });
        return figures.build();
    }

    private static double square(double value) {
        return value * value;
    }

    /** Deviations of objects and of points 100 mm above them: the worst axis, over all objects. */
    private Figures grip() {
        Figures.Builder figures = new Figures.Builder();
        for (String name : List.of("lifted-plane-4-high", "lifted-raised-4-high")) {
            for (double placed : placedMm()) {
                SetUp setUp = setUp(name).placedTo(placed);
                Cell cell = setUp.cell(assumptions);
                List<ObjectMarker> gripped = cell.objects().stream()
                        .map(object -> new ObjectMarker(object.id(), object.sizeMm(), GRIP_MM)).toList();
                CheckResult result = CellCheck.run(cell.withObjects(gripped), setUp.detections(assumptions),
                        effort.untilPrecise().build());
                double[] position = new double[gripped.size()];
                double[] grip = new double[gripped.size()];
                double[] rotation = new double[gripped.size()];
                for (int i = 0; i < grip.length; i++) {
                    ObjectEstimate object = result.estimate().objects().get(i);
                    position[i] = DecisionTable.worst(object.pose().std());
                    grip[i] = Words.max(Objects.requireNonNull(object.grip()).stdMm());
                    double[][] tangent = object.pose().tangentCovariance();
                    rotation[i] = Math.sqrt(Math.max(tangent[3][3], tangent[4][4]));
                }
                figures.put(name + " " + Words.number(placed), Words.max(position), Words.max(grip),
                        Words.max(rotation), result.diagnostics().converged() ? 1 : 0);
            }
        }
        return figures.build();
    }

    /** Worst axis of the objects, deviation of fx and of cx, by what is explored. */
    private Figures intrinsics() {
        Figures.Builder figures = new Figures.Builder();
        for (String name : List.of("focal-plane-6", "focal-raised-6")) {
            for (double placed : placedMm()) {
                for (Estimate explored : Estimate.values()) {
                    SetUp setUp = setUp(name).placedTo(placed).exploring(explored);
                    CheckResult result = CellCheck.run(setUp.cell(assumptions), setUp.detections(assumptions),
                            SetUpWork.right(assumptions, effort, setUp).build());
                    figures.put(name + " " + Words.number(placed) + " " + explored.word(),
                            DecisionTable.worst(rms(result.estimate())), deviation(result.estimate(), "fx"),
                            deviation(result.estimate(), "cx"), result.diagnostics().converged() ? 1 : 0);
                }
            }
        }
        return figures.build();
    }

    private static double deviation(CellEstimate estimate, String parameter) {
        IntrinsicsEstimate intrinsics = estimate.intrinsics();
        if (intrinsics != null) {
            for (int i = 0; i < intrinsics.names().size(); i++) {
                if (intrinsics.names().get(i).startsWith(parameter)) {
                    return Math.sqrt(intrinsics.covariance()[i][i]);
                }
            }
        }
        return Double.NaN;
    }

    /** Root mean squares over the objects, x, y, z. */
    private static double[] rms(CellEstimate estimate) {
        double[] rms = new double[3];
        for (int i = 0; i < rms.length; i++) {
            int axis = i;
            rms[i] = Words.rms(estimate.objects().stream().mapToDouble(o -> o.pose().std()[axis]).toArray());
        }
        return rms;
    }

    /**
     * Focal lengths that chains of the thesis end with (means of each chain, then deviations) where they start with
     * another than the true one, and what the default says of the same.
     */
    private Figures starts() {
        Figures.Builder figures = new Figures.Builder();
        for (String name : started()) {
            SetUp setUp = setUp(name);
            Detections detections = setUp.detections(assumptions);
            for (double start : startsPx()) {
                PinholeCamera camera = assumptions.camera();
                Cell cell = setUp.cell(assumptions).withCamera(PinholeCamera.ideal(camera.widthPx(), camera.heightPx(),
                        start, start, camera.get(PinholeCamera.CX), camera.get(PinholeCamera.CY)));
                Figures chains = ThesisChains.run(cell, detections, assumptions.asInThesis().estimate(Estimate.FOCAL)
                        .focalPriorStdPx(FLAT_PX), effort.seeds());
                String key = name + " " + Words.number(start);
                figures.put(key + " mean", chains.column("focal.mean", 2, 0));
                figures.put(key + " std", chains.column("focal.std", 2, 0));
                Figures right = SetUpWork.converged(cell, detections,
                        SetUpWork.right(assumptions, effort, setUp).build());
                figures.put(key + " right", right.all("focal.mean")[0], right.all("focal.std")[0],
                        right.one("converged"));
            }
        }
        return figures.build();
    }

    /** Worst axis by the number of references, with the focal length known and explored; NaN where not converged. */
    private Figures more(boolean raised, double placedMm) {
        Figures.Builder figures = new Figures.Builder();
        for (int count : counts()) {
            for (Estimate explored : List.of(Estimate.NONE, Estimate.FOCAL)) {
                SetUp setUp = withReferences(raised ? "focal-raised-6" : "focal-plane-6", count).placedTo(placedMm)
                        .exploring(explored);
                CheckResult result = CellCheck.run(setUp.cell(assumptions), setUp.detections(assumptions),
                        SetUpWork.right(assumptions, effort, setUp).build());
                double[] rms = rms(result.estimate());
                figures.append(explored.word(), result.diagnostics().converged() ? DecisionTable.worst(rms)
                        : Double.NaN);
                figures.append(explored.word() + " lateral", result.diagnostics().converged()
                        ? DecisionTable.lateral(rms) : Double.NaN);
            }
        }
        return figures.build();
    }

    /**
     * Errors of objects (root mean square over objects and x, y, z, mm) and what was stated of them, where one
     * reference stands off: of every chain of the thesis by its start, and of the default.
     */
    private Figures misplaced() {
        SetUp setUp = setUp("focal-raised-6").placedTo(OFF_OF_MM).exploring(Estimate.NONE);
        Cell cell = setUp.cell(assumptions).withPixelStdPx(OptionalDouble.of(assumptions.finePixelStdPx()));
        Map<Integer, RigidTransform> objects = assumptions.objects(setUp.objects());
        Reference off = cell.references().stream().filter(r -> r.id() == OFF_ID).findFirst().orElseThrow();
        double[] place = off.worldFromMarker().translationMm();
        place[0] += OFF_MM;
        Detections detections = SetUp.exact(cell, assumptions.worldFromCamera(setUp.cameraPose()), objects,
                Map.of(OFF_ID, RigidTransform.of(off.worldFromMarker().rotation(), place)));
        Figures.Builder figures = new Figures.Builder();
        for (InitialEstimate initial : List.of(InitialEstimate.AVERAGE, InitialEstimate.RANSAC)) {
            for (int seed = 1; seed <= effort.seeds(); seed++) {
                CheckResult result = CellCheck.run(cell, detections,
                        assumptions.asInThesis().initial(initial).seed(seed).threads(1).build());
                figures.append(initial.word(), error(result, objects), stated(result));
            }
        }
        CheckResult right = CellCheck.run(cell, detections, effort.untilPrecise().build());
        figures.put("right", error(right, objects), stated(right));
        right.referenceCheck().misplaced().forEach(reference -> figures.append("named", reference.id()));
        return figures.build();
    }

    private static double error(CheckResult result, Map<Integer, RigidTransform> objects) {
        double sum = 0;
        for (ObjectEstimate object : result.estimate().objects()) {
            double[] truth = Objects.requireNonNull(objects.get(object.id())).translationMm();
            double[] mean = object.pose().mean();
            for (int i = 0; i < truth.length; i++) {
                sum += square(mean[i] - truth[i]) / truth.length;
            }
        }
        return Math.sqrt(sum / objects.size());
    }

    private static double stated(CheckResult result) {
        return Words.rms(rms(result.estimate()));
    }
}
