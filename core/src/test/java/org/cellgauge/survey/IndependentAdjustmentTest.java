package org.cellgauge.survey;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.apache.commons.math3.fitting.leastsquares.LeastSquaresBuilder;
import org.apache.commons.math3.fitting.leastsquares.LeastSquaresOptimizer;
import org.apache.commons.math3.fitting.leastsquares.LevenbergMarquardtOptimizer;
import org.apache.commons.math3.fitting.leastsquares.MultivariateJacobianFunction;
import org.apache.commons.math3.geometry.euclidean.threed.Rotation;
import org.apache.commons.math3.geometry.euclidean.threed.RotationConvention;
import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.util.Pair;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.PrintPrecision;
import org.cellgauge.cell.Reference;
import org.cellgauge.estimate.PoseEstimate;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.validation.SimulatedSurvey;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.junit.jupiter.api.Test;

/**
 * The survey's mode and deviations against an adjustment that shares no code with it: dense Levenberg-Marquardt by
 * Apache Commons Math over all unknowns at once, rotations of the same library, derivatives by differences.
 */
class IndependentAdjustmentTest {
    private static final double FOCAL = 900;
    private static final double CENTRE_X = 640;
    private static final double CENTRE_Y = 360;
    private static final double STD_PX = 0.3;
    private static final double STD_MM = 5;
    private static final double STD_RAD = Math.toRadians(0.5);
    private static final double SIZE_MM = 60;
    private static final int POSE = 6;
    private static final double[][] SQUARE = {{-30, 30}, {30, 30}, {30, -30}, {-30, -30}};

    /** A pose as start and six numbers about it: a shift in the axes of the frame, a turn about the own origin. */
    private record About(Rotation rotation, Vector3D origin) {
        static About of(RigidTransform pose) {
            double[] r = pose.rotation();
            double[] t = pose.translationMm();
            return new About(new Rotation(new double[][] {{r[0], r[1], r[2]}, {r[3], r[4], r[5]}, {r[6], r[7], r[8]}},
                    1e-9), new Vector3D(t));
        }

        /** Where a point of the thing is. */
        Vector3D apply(double[] x, int from, Vector3D point) {
            return turn(x, from).applyTo(rotation.applyTo(point)).add(origin)
                    .add(new Vector3D(x[from], x[from + 1], x[from + 2]));
        }

        /** Where a point of the frame is as the thing sees it. */
        Vector3D applyInverse(double[] x, int from, Vector3D point) {
            Vector3D relative = point.subtract(origin).subtract(new Vector3D(x[from], x[from + 1], x[from + 2]));
            return rotation.applyInverseTo(turn(x, from).applyInverseTo(relative));
        }

        private static Rotation turn(double[] x, int from) {
            Vector3D w = new Vector3D(x[from + 3], x[from + 4], x[from + 5]);
            double angle = w.getNorm();
            return angle == 0 ? Rotation.IDENTITY : new Rotation(w, angle, RotationConvention.VECTOR_OPERATOR);
        }
    }

    @Test
    void modeAndDeviationsAreThoseOfAnotherAdjustment() {
        List<Reference> references = new ArrayList<>();
        for (int i = 0; i < 5; i++) {
            double angle = 2 * Math.PI * i / 5;
            references.add(new Reference(100 + i, SIZE_MM, RigidTransform.ofEuler(350 * Math.cos(angle),
                    250 * Math.sin(angle), i % 3 == 0 ? 100 : 0, 0.1 * i, 0.2, 0.3),
                    new Placement(STD_MM, STD_MM, STD_MM, STD_RAD)));
        }
        List<ObjectMarker> objects = List.of(new ObjectMarker(1, SIZE_MM, null), new ObjectMarker(2, SIZE_MM, null));
        Cell cell = new Cell(PinholeCamera.ideal(1280, 720, FOCAL, FOCAL, CENTRE_X, CENTRE_Y),
                MarkerFamily.SQUARE_BINARY, references, objects, OptionalDouble.of(STD_PX), OptionalDouble.empty(),
                new PrintPrecision(0, 0, 0));
        CheckSettings settings = CheckSettings.builder().build();
        SimulatedSurvey simulated = SimulatedSurvey.of(cell, settings, 10, 7, 0);

        List<About> things = new ArrayList<>();
        List<Integer> ids = new ArrayList<>();
        for (Reference r : references) {
            things.add(About.of(r.worldFromMarker()));
            ids.add(r.id());
        }
        for (ObjectMarker o : objects) {
            things.add(About.of(simulated.objects().get(o.id())));
            ids.add(o.id());
        }
        simulated.cameras().forEach(c -> things.add(About.of(c)));
        int firstCamera = ids.size();

        LeastSquaresOptimizer.Optimum optimum = new LevenbergMarquardtOptimizer().optimize(new LeastSquaresBuilder()
                .start(new double[POSE * things.size()])
                .target(new double[residuals(new double[POSE * things.size()], things, ids, firstCamera,
                        references.size(), simulated.photos()).length])
                .model(differences(x -> residuals(x, things, ids, firstCamera, references.size(), simulated.photos())))
                .maxEvaluations(100).maxIterations(100).build());
        double[] x = optimum.getPoint().toArray();
        RealMatrix covariance = optimum.getCovariances(1e-14);

        SurveyResult survey = Survey.of(cell, simulated.photos(), settings).estimate();
        assertEquals(10, survey.used());
        List<PoseEstimate> found = new ArrayList<>();
        survey.references().forEach(r -> found.add(r.pose()));
        survey.objects().forEach(o -> found.add(o.pose()));
        double worstMean = 0;
        double worstStd = 0;
        for (int m = 0; m < found.size(); m++) {
            About about = things.get(m);
            double[] mean = found.get(m).mean();
            Vector3D centre = about.apply(x, POSE * m, Vector3D.ZERO);
            double[] other = centre.toArray();
            for (int i = 0; i < 3; i++) {
                double std = Math.sqrt(covariance.getEntry(POSE * m + i, POSE * m + i));
                worstMean = Math.max(worstMean, Math.abs(mean[i] - other[i]) / std);
                worstStd = Math.max(worstStd, Math.abs(found.get(m).std()[i] / std - 1));
            }
            // a turn by the way a corner goes
            double[] corner = found.get(m).meanTransform().apply(SIZE_MM / 2, 0, 0);
            double turnStd = Math.sqrt(covariance.getEntry(POSE * m + 5, POSE * m + 5));
            double way = new Vector3D(corner).subtract(new Vector3D(mean[0], mean[1], mean[2]))
                    .distance(about.apply(x, POSE * m, new Vector3D(SIZE_MM / 2, 0, 0)).subtract(centre));
            worstMean = Math.max(worstMean, way / (SIZE_MM / 2) / turnStd);
        }
        assertTrue(worstMean < 0.01, "modes differ by deviations: " + worstMean);
        assertTrue(worstStd < 0.001, "deviations differ by shares: " + worstStd);
    }

    private static double[] residuals(double[] x, List<About> things, List<Integer> ids, int firstCamera,
            int references, List<Detections> photos) {
        List<Double> out = new ArrayList<>();
        for (int i = 0; i < POSE * references; i++) {
            out.add(x[i] / (i % POSE < 3 ? STD_MM : STD_RAD));
        }
        for (int v = 0; v < photos.size(); v++) {
            int camera = firstCamera + v;
            for (MarkerObservation seen : photos.get(v).markers()) {
                int m = ids.indexOf(seen.id());
                double[] px = seen.cornersPx();
                for (int k = 0; k < SQUARE.length; k++) {
                    Vector3D world = things.get(m).apply(x, POSE * m, new Vector3D(SQUARE[k][0], SQUARE[k][1], 0));
                    Vector3D p = things.get(camera).applyInverse(x, POSE * camera, world);
                    out.add((FOCAL * p.getX() / p.getZ() + CENTRE_X - px[2 * k]) / STD_PX);
                    out.add((FOCAL * p.getY() / p.getZ() + CENTRE_Y - px[2 * k + 1]) / STD_PX);
                }
            }
        }
        return out.stream().mapToDouble(Double::doubleValue).toArray();
    }

    private static MultivariateJacobianFunction differences(java.util.function.UnaryOperator<double[]> function) {
        return point -> {
            double[] x = point.toArray();
            double[] value = function.apply(x);
            RealMatrix jacobian = new Array2DRowRealMatrix(value.length, x.length);
            for (int j = 0; j < x.length; j++) {
                double h = j % POSE < 3 ? 1e-4 : 1e-7;
                double[] up = x.clone();
                double[] down = x.clone();
                up[j] += h;
                down[j] -= h;
                double[] a = function.apply(up);
                double[] b = function.apply(down);
                for (int i = 0; i < value.length; i++) {
                    jacobian.setEntry(i, j, (a[i] - b[i]) / (2 * h));
                }
            }
            return new Pair<>(new ArrayRealVector(value, false), jacobian);
        };
    }
}
