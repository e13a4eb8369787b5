package org.cellgauge.internal.posterior;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.geometry.Rotations;
import org.cellgauge.internal.pose.CameraModeFinder;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.InitialPose;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.internal.pose.ReferenceView;
import org.cellgauge.internal.pose.RigidMarkerNoise;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.settings.RotationPrior;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.ejml.simple.SimpleMatrix;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The likelihood frozen at several modes against importance sampling of pose and placement errors together, which
 * linearises nothing: masses of the modes, and mean and deviation of the pose within each.
 */
class ModeMassTest {
    private static final PinholeCamera CAMERA = PinholeCamera.ideal(1280, 960, 1500, 1500, 640, 480);
    private static final double PIXEL_STD = 0.3;
    private static final double SIZE_MM = 25;
    private static final double STD_MM = 1;
    private static final double STD_RAD = Math.toRadians(2);
    private static final int DRAWS = 40_000;
    private static final double DEGREES = 12;

    private static RigidTransform placed(Reference reference, double[] errors, int at) {
        double[] t = reference.worldFromMarker().translationMm();
        for (int i = 0; i < 3; i++) {
            t[i] += errors[at + i];
        }
        return RigidTransform.ofRotationVector(new double[] {errors[at + 3], errors[at + 4], errors[at + 5]}, t)
                .compose(RigidTransform.of(reference.worldFromMarker().rotation(), new double[3]));
    }

    private static double[] project(RigidTransform cameraFromMarker) {
        double[] corners = MarkerGeometry.cornersMm(cameraFromMarker, SIZE_MM);
        double[] px = new double[8];
        for (int k = 0; k < 4; k++) {
            double[] uv = CAMERA.project(corners[3 * k], corners[3 * k + 1], corners[3 * k + 2]);
            if (uv == null) {
                return null;
            }
            px[2 * k] = uv[0];
            px[2 * k + 1] = uv[1];
        }
        return px;
    }

    private static ReferenceView view(int photo) {
        RandomGenerator random = RandomStreams.of(81, photo);
        double[] tilt = {0.35, 0.2, 0};
        RigidTransform worldFromCamera = RigidTransform.ofRotationVector(tilt, new double[] {0, 0, 1900})
                .compose(RigidTransform.ofEuler(0, 0, 0, Math.PI, 0, 0)).inverse();
        List<Reference> references = new ArrayList<>();
        List<MarkerObservation> markers = new ArrayList<>();
        for (int i = 0; i < 2; i++) {
            Reference reference = new Reference(i, SIZE_MM, RigidTransform.ofEuler(35 * i, 20 * i, 2 * i, 0, 0, 0),
                    new Placement(STD_MM, STD_MM, STD_MM, STD_RAD));
            references.add(reference);
            double[] errors = new double[6];
            for (int c = 0; c < 6; c++) {
                errors[c] = (c < 3 ? STD_MM : STD_RAD) * random.nextGaussian();
            }
            double[] px = project(worldFromCamera.inverse().compose(placed(reference, errors, 0)));
            for (int c = 0; c < 8; c++) {
                px[c] += PIXEL_STD * random.nextGaussian();
            }
            markers.add(new MarkerObservation(i, px));
        }
        return ReferenceView.of(references, new Detections("two references", 1280, 960, markers));
    }

    /** Residuals over their deviations by a step of the centred chart and a placement error of each reference. */
    private static double[] residuals(ReferenceView view, CameraState base, double[] x) {
        CameraState state = new CameraState();
        state.setMoved(base, x, 0);
        RigidTransform cameraFromWorld = view.worldFromCamera(state.cameraFromSet()).inverse();
        double[] observed = view.observedPx();
        double[] out = new double[observed.length + x.length - 6];
        for (int m = 0; m < view.size(); m++) {
            double[] px = project(cameraFromWorld.compose(placed(view.references().get(m), x, 6 + 6 * m)));
            if (px == null) {
                return null;
            }
            for (int i = 0; i < 8; i++) {
                out[8 * m + i] = (px[i] - observed[8 * m + i]) / PIXEL_STD;
            }
        }
        for (int i = 6; i < x.length; i++) {
            out[observed.length + i - 6] = x[i] / (i % 6 < 3 ? STD_MM : STD_RAD);
        }
        return out;
    }

    private interface Density {
        double at(double[] x);
    }

    /** Mass, mean and deviation of what lies nearest to one mode. */
    private static final class Part {
        double logMass;
        final double[] mean = new double[6];
        final double[] std = new double[6];
        double effective;
    }

    /** Importance sampling from a multivariate t about one mode; draws nearer to another mode do not count. */
    private static Part sample(Density density, double[] centre, SimpleMatrix covariance, List<PoseMode> modes, int own,
            long stream) {
        int n = centre.length;
        SimpleMatrix l = covariance.copy();
        DecompositionFactory_DDRM.chol(n, true).decompose(l.getDDRM());
        for (int i = 0; i < n; i++) {
            for (int j = i + 1; j < n; j++) {
                l.set(i, j, 0);
            }
        }
        double logScale = 0;
        for (int i = 0; i < n; i++) {
            logScale += Math.log(l.get(i, i));
        }
        RandomGenerator random = RandomStreams.of(82, stream, own, n);
        double[][] draws = new double[DRAWS][];
        double[] logWeights = new double[DRAWS];
        double largest = Double.NEGATIVE_INFINITY;
        CameraState moved = new CameraState();
        for (int d = 0; d < DRAWS; d++) {
            double[] z = new double[n];
            double chi = 0;
            for (int i = 0; i < DEGREES; i++) {
                double g = random.nextGaussian();
                chi += g * g;
            }
            double squares = 0;
            for (int i = 0; i < n; i++) {
                z[i] = random.nextGaussian() * Math.sqrt(DEGREES / chi);
                squares += z[i] * z[i];
            }
            double[] x = centre.clone();
            for (int i = 0; i < n; i++) {
                for (int j = 0; j <= i; j++) {
                    x[i] += l.get(i, j) * z[j];
                }
            }
            double logProposal = -logScale - 0.5 * (DEGREES + n) * Math.log(1 + squares / DEGREES);
            moved.setMoved(modes.get(own).state(), x, 0);
            int nearest = 0;
            double least = Double.POSITIVE_INFINITY;
            for (int k = 0; k < modes.size(); k++) {
                double angle = moved.cameraFromSet().angleRadTo(modes.get(k).state().cameraFromSet());
                if (angle < least) {
                    least = angle;
                    nearest = k;
                }
            }
            draws[d] = x;
            logWeights[d] = nearest == own ? density.at(x) - logProposal : Double.NEGATIVE_INFINITY;
            largest = Math.max(largest, logWeights[d]);
        }
        Part part = new Part();
        double sum = 0;
        double squares = 0;
        for (int d = 0; d < DRAWS; d++) {
            double w = Math.exp(logWeights[d] - largest);
            sum += w;
            squares += w * w;
            for (int i = 0; i < 6; i++) {
                part.mean[i] += w * draws[d][i];
            }
        }
        for (int i = 0; i < 6; i++) {
            part.mean[i] /= sum;
            for (int d = 0; d < DRAWS; d++) {
                part.std[i] += Math.exp(logWeights[d] - largest) / sum * Math.pow(draws[d][i] - part.mean[i], 2);
            }
            part.std[i] = Math.sqrt(part.std[i]);
        }
        part.logMass = largest + Math.log(sum / DRAWS);
        // the constant of the t density, which differs between dimensions, cancels between modes
        part.effective = sum * sum / squares;
        return part;
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1})
    void massesMeansAndDeviationsAreThoseOfExplicitPlacementErrors(int photo) {
        ReferenceView view = view(photo);
        RigidTransform start = InitialPose.PNP.estimate(view, CAMERA);
        List<PoseMode> modes = new CameraModeFinder(view, CAMERA, new RigidMarkerNoise(view, PIXEL_STD),
                IntrinsicsPrior.KNOWN, null).modes(start);
        assertEquals(2, modes.size());
        Part[] ours = new Part[2];
        Part[] explicit = new Part[2];
        for (int k = 0; k < 2; k++) {
            PoseMode mode = modes.get(k);
            CentredChart chart = new CentredChart(mode.state(), IntrinsicsPrior.KNOWN);
            CameraPosterior posterior = new CameraPosterior(chart, new NearestModeLikelihood(view, modes),
                    RotationPrior.UNIFORM, IntrinsicsPrior.KNOWN, null);
            ours[k] = sample(posterior::at, new double[6], new SimpleMatrix(6, 6, true, mode.covariance()), modes, k,
                    photo);
            double[] centre = new double[18];
            System.arraycopy(mode.placed().errors(), 0, centre, 6, 12);
            double[][] j = new double[28][18];
            for (int c = 0; c < 18; c++) {
                double h = c % 6 < 3 ? 0.01 : 1e-5;
                double[] plus = centre.clone();
                double[] minus = centre.clone();
                plus[c] += h;
                minus[c] -= h;
                double[] up = residuals(view, mode.state(), plus);
                double[] down = residuals(view, mode.state(), minus);
                for (int r = 0; r < 28; r++) {
                    j[r][c] = (up[r] - down[r]) / (2 * h);
                }
            }
            SimpleMatrix jacobian = new SimpleMatrix(j);
            explicit[k] = sample(x -> {
                double[] r = residuals(view, mode.state(), x);
                if (r == null) {
                    return Double.NEGATIVE_INFINITY;
                }
                double sum = Rotations.logHaarDensity(x[3], x[4], x[5]);
                for (double v : r) {
                    sum -= 0.5 * v * v;
                }
                return sum;
            }, centre, jacobian.transpose().mult(jacobian).invert(), modes, k, photo);
        }
        double logRatio = ours[1].logMass - ours[0].logMass;
        double explicitLogRatio = explicit[1].logMass - explicit[0].logMass;
        // both are estimated from thousands of effective draws: 2 to 3 %
        assertEquals(explicitLogRatio, logRatio, 0.1, "share of the second mode");
        for (int k = 0; k < 2; k++) {
            assertTrue(explicit[k].effective > 2000, "effective draws " + explicit[k].effective);
            for (int i = 0; i < 6; i++) {
                String which = "mode " + k + " coordinate " + i;
                // what is left is of second order in the spread of the pose about the mode: 0.1 deviations in depth
                assertEquals(explicit[k].mean[i], ours[k].mean[i], 0.2 * explicit[k].std[i], which);
                assertEquals(1, ours[k].std[i] / explicit[k].std[i], 0.15, which);
            }
        }
    }
}
