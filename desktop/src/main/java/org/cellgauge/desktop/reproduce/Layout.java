package org.cellgauge.desktop.reproduce;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalDouble;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.laplace.LayoutPrediction;
import org.cellgauge.settings.CheckSettings;

/**
 * A layout of the corrected decision table: so many references, so arranged; immutable.
 *
 * @param arrangement {@code plane}, {@code one-raised}, {@code several-raised} or {@code tilted}
 * @param references how many
 * @param stdMm how precisely they are placed along each axis, mm
 * @param sizeMm size of all markers, mm
 * @param pixelStdPx corner noise, px
 */
record Layout(String arrangement, int references, double stdMm, double sizeMm, double pixelStdPx) {
    static final List<String> ARRANGEMENTS = List.of("plane", "one-raised", "several-raised", "tilted");
    static final int FEWEST = 2;
    static final int MOST = 8;
    private static final String OBJECTS = "plane";

    /** References, and the objects of the thesis' plane. */
    Cell cell(Assumptions assumptions) {
        List<Reference> placed = new ArrayList<>();
        for (Reference reference : named(assumptions)) {
            int at = placed.size();
            RigidTransform pose = reference.worldFromMarker();
            double[] place = pose.translationMm();
            if (arrangement.equals("several-raised") && at % 2 == 1) {
                place[2] += assumptions.at("layouts").at("raised_mm").number();
                pose = RigidTransform.of(pose.rotation(), place);
            } else if (arrangement.equals("tilted")) {
                double turn = assumptions.at("layouts").at("tilted_rad").number() * (at % 4 < 2 ? 1 : -1);
                pose = RigidTransform.ofEuler(place[0], place[1], place[2], at % 2 == 0 ? turn : 0,
                        at % 2 == 0 ? 0 : turn, 0);
            }
            placed.add(new Reference(reference.id(), sizeMm, pose, assumptions.placement(stdMm)));
        }
        List<ObjectMarker> objects = assumptions.objects(OBJECTS).keySet().stream()
                .map(id -> new ObjectMarker(id, sizeMm, null)).toList();
        return new Cell(assumptions.camera(), MarkerFamily.SQUARE_BINARY, placed, objects,
                OptionalDouble.of(pixelStdPx), OptionalDouble.empty());
    }

    private List<Reference> named(Assumptions assumptions) {
        DataNode layouts = assumptions.at("layouts");
        List<String> order = layouts.at("order").texts();
        List<String> names = new ArrayList<>(order.subList(0, references));
        if (arrangement.equals("one-raised")) {
            DataNode fewest = layouts.at("one_raised");
            String most = fewest.keys().get(fewest.keys().size() - 1);
            String count = Integer.toString(references);
            names = new ArrayList<>(fewest.at(fewest.has(count) ? count : most).texts());
            names.addAll(order.subList(names.size(), Math.max(names.size(), references)));
        }
        return assumptions.references(names, stdMm);
    }

    /**
     * Deviations by Laplace's approximation: root mean squares over the objects along x, y, z, mm.
     *
     * @throws IllegalStateException if a marker would not be seen
     */
    double[] forecast(Assumptions assumptions, CheckSettings settings) {
        LayoutPrediction prediction = LayoutPrediction.of(cell(assumptions), assumptions.worldFromCamera("usual"),
                assumptions.objects(OBJECTS), settings);
        if (prediction == null || prediction.references().size() < references) {
            throw new IllegalStateException(this + " is not seen");
        }
        double[] squares = new double[3];
        for (int id : prediction.objects()) {
            double[] std = Objects.requireNonNull(prediction.object(id)).std();
            for (int i = 0; i < squares.length; i++) {
                squares[i] += std[i] * std[i] / prediction.objects().size();
            }
        }
        return roots(squares);
    }

    /** The same of converged chains on exact corners; NaN where they do not converge. */
    double[] sampled(Assumptions assumptions, CheckSettings settings) {
        Cell cell = cell(assumptions);
        Map<Integer, RigidTransform> objects = assumptions.objects(OBJECTS);
        CheckResult result = CellCheck.run(cell,
                SetUp.exact(cell, assumptions.worldFromCamera("usual"), objects, Map.of()), settings);
        double[] squares = new double[3];
        result.estimate().objects().forEach(object -> {
            double[] std = object.pose().std();
            for (int i = 0; i < squares.length; i++) {
                squares[i] += std[i] * std[i] / objects.size();
            }
        });
        return result.diagnostics().converged() ? roots(squares) : new double[] {Double.NaN, Double.NaN, Double.NaN};
    }

    private static double[] roots(double[] squares) {
        double[] roots = new double[squares.length];
        for (int i = 0; i < roots.length; i++) {
            roots[i] = Math.sqrt(squares[i]);
        }
        return roots;
    }
}
