package org.cellgauge.internal.survey;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.JointPlacement;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.cell.Measurement;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.PlacementGroup;
import org.cellgauge.cell.PrintPrecision;
import org.cellgauge.cell.Reference;
import org.cellgauge.cell.RobotPrecision;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.internal.validation.SimulatedSurvey;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.Detections;
import org.junit.jupiter.api.Test;

class SurveyModelTest {
    private static final int POSE = SurveyLayout.POSE;

    private static Cell cell() {
        List<Reference> references = new ArrayList<>();
        for (int i = 0; i < 5; i++) {
            double angle = 2 * Math.PI * i / 5;
            references.add(new Reference(100 + i, 60, RigidTransform.ofEuler(350 * Math.cos(angle),
                    250 * Math.sin(angle), i == 0 ? 100 : 0, 0.1 * i, 0, 0), new Placement(5, 4, 3, 0.02)));
        }
        List<ObjectMarker> objects = List.of(new ObjectMarker(1, 60, null), new ObjectMarker(2, 60, null, true));
        Placement plate = new Placement(10, 10, 10, 0.05);
        return new Cell(PinholeCamera.ideal(1280, 720, 900, 900, 640, 360), MarkerFamily.SQUARE_BINARY, references,
                objects, OptionalDouble.of(0.3), OptionalDouble.empty(), new PrintPrecision(0.1, 0.2, 0))
                        .withJointPlacement(new JointPlacement(
                                List.of(new PlacementGroup("plate", List.of(100, 101), plate)),
                                List.of(new Measurement.Distance(100, 102, 400, 0.5),
                                        new Measurement.Height(100, 104, 98, 0.3),
                                        new Measurement.Touched(103,
                                            RigidTransform.ofEuler(-280, -148, 1, 3.1, 0.2, 0.1),
                                            new Placement(0.2, 0.3, 0.4, 0)),
                                        new Measurement.Touched(100,
                                            RigidTransform.ofEuler(351, 1, 99, 3.1, 0.2, 1),
                                            new Placement(0.2, 0.2, 0.2, 0)),
                                        new Measurement.OnePlane(List.of(101, 102, 103, 104), 0.5)),
                                new RobotPrecision(new Placement(2, 2, 2, 0.01), 1), null));
    }

    /** The one oracle for all derivatives: differences of the cost itself. */
    @Test
    void gradientIsThatOfTheCost() {
        Cell cell = cell();
        List<SurveyView> views = new ArrayList<>();
        for (Detections photo : SimulatedSurvey.of(cell, CheckSettings.builder().build(), 3, 5, 0).photos()) {
            views.add(new SurveyView(cell, photo));
        }
        IntrinsicsPrior intrinsics = IntrinsicsPrior.focal(cell.camera(), 20);
        SurveyLayout layout = new SurveyLayout(cell, List.of(cell.objects().get(0)), intrinsics);
        SurveyModel model = new SurveyModel(layout, views, new double[] {1, 1, 1, 1, 1});
        SurveyStart start = new SurveyStart(cell, views, new RigidTransform[3],
                cell.references().stream().map(Reference::worldFromMarker).toArray(RigidTransform[]::new),
                new RigidTransform[2]);
        SurveyState at = start.state(layout, model.centreMm);
        double[] shared = new double[layout.size];
        org.apache.commons.math3.random.RandomGenerator random = RandomStreams.of(3);
        for (int i = 0; i < shared.length; i++) {
            boolean turn = i < layout.firstIntrinsic && i % POSE > 2;
            shared[i] = (turn ? 0.02 : 1) * random.nextGaussian();
        }
        for (int i = layout.firstRobot + 3; i < layout.size; i++) {
            shared[i] *= 0.01;
        }
        SurveyState moved = new SurveyState(layout, views);
        moved.copyFrom(at);
        moved.moveShared(at, shared);
        double[] gradient = new double[layout.size];
        double[] information = new double[layout.size * layout.size];
        model.linearisePriors(moved, information, gradient);
        double[][] own = new double[3][];
        for (int v = 0; v < 3; v++) {
            ViewEquations equations = new ViewEquations(views.get(v).locals(), layout.size);
            own[v] = model.gradient(moved, v, equations, information, gradient);
        }
        SurveyState trial = new SurveyState(layout, views);
        for (int i = 0; i < layout.size; i++) {
            double h = i < layout.firstIntrinsic && i % POSE > 2 ? 1e-6 : 1e-5;
            double[] step = new double[layout.size];
            trial.copyFrom(moved);
            step[i] = h;
            trial.moveShared(moved, step);
            double up = model.cost(trial);
            step[i] = -h;
            trial.moveShared(moved, step);
            double slope = (up - model.cost(trial)) / (2 * h);
            assertEquals(slope, gradient[i], 1e-4 * Math.abs(slope) + 0.02, "shared " + i);
        }
        for (int v = 0; v < 3; v++) {
            for (int i = 0; i < own[v].length; i++) {
                double h = 1e-6;
                double[] step = new double[own[v].length];
                trial.copyFrom(moved);
                step[i] = h;
                trial.moveOwn(moved, v, step, 0);
                double up = model.cost(trial);
                step[i] = -h;
                trial.moveOwn(moved, v, step, 0);
                double slope = (up - model.cost(trial)) / (2 * h);
                assertEquals(slope, own[v][i], 1e-4 * Math.abs(slope) + 0.05, "own " + v + " " + i);
            }
        }
    }
}
