package org.cellgauge.internal.posterior;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.OptionalDouble;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.PrintPrecision;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.pose.AddedNoise;
import org.cellgauge.internal.pose.CameraModeFinder;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.internal.pose.InitialPose;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.internal.pose.ReferenceView;
import org.cellgauge.internal.pose.RigidMarkerNoise;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.EdgeShift;
import org.cellgauge.vision.MarkerObservation;
import org.cellgauge.vision.PhotoLight;
import org.ejml.simple.SimpleMatrix;
import org.junit.jupiter.api.Test;

/**
 * Two references that may be seen mirrored, turned off their places, of a size and edges in doubt and with a noise that
 * nobody states: all that is unknown of a photo, at both modes.
 */
class SharedModesTest {
    private static final PinholeCamera CAMERA = PinholeCamera.ideal(1280, 960, 1500, 1500, 640, 480);
    private static final double SIZE_MM = 25;
    private static final double STD_MM = 1;
    private static final double STD_RAD = Math.toRadians(2);
    private static final double NOISE_PX = 0.2;
    private static final double DOUBT_PX = 0.15;
    private static final int NODE = AddedNoise.node(0.4);

    private final Cell cell = cell();
    private final CornerErrors errors = CornerErrors.of(cell, detections());
    private final ReferenceView view = ReferenceView.of(cell.references(), errors);

    private static Cell cell() {
        List<Reference> references = new ArrayList<>();
        for (int i = 0; i < 2; i++) {
            references.add(new Reference(i, SIZE_MM, RigidTransform.ofEuler(35 * i, 20 * i, 2 * i, 0, 0, 0),
                    new Placement(STD_MM, STD_MM, STD_MM, STD_RAD)));
        }
        return new Cell(CAMERA, MarkerFamily.SQUARE_BINARY, references, Collections.emptyList(),
                OptionalDouble.empty(), OptionalDouble.empty(), new PrintPrecision(0.2, 0.1, 0));
    }

    private Detections detections() {
        RandomGenerator random = RandomStreams.of(83);
        RigidTransform cameraFromWorld = RigidTransform.ofRotationVector(new double[] {0.35, 0.2, 0},
                new double[] {0, 0, 1900}).compose(RigidTransform.ofEuler(0, 0, 0, Math.PI, 0, 0));
        double shift = DOUBT_PX * random.nextGaussian();
        List<MarkerObservation> markers = new ArrayList<>();
        for (int m = 0; m < 2; m++) {
            double[] d = new double[6];
            for (int c = 0; c < 6; c++) {
                d[c] = (c < 3 ? STD_MM : STD_RAD) * random.nextGaussian();
            }
            double[] px = project(cameraFromWorld.compose(placed(cell.references().get(m), d, 0)));
            double[] by = EdgeShift.ofCorners(px);
            double[] covariance = new double[64];
            for (int i = 0; i < 8; i++) {
                px[i] += shift * by[i] + NOISE_PX * random.nextGaussian();
                covariance[9 * i] = NOISE_PX * NOISE_PX * (0.8 + 0.05 * i);
            }
            markers.add(new MarkerObservation(m, px, covariance, null));
        }
        return new Detections("two references", 1280, 960, markers, Collections.emptyList(),
                new PhotoLight(ToneCurve.SRGB, true, 0.7, 1, 100, DOUBT_PX));
    }

    private static RigidTransform placed(Reference reference, double[] d, int at) {
        double[] t = reference.worldFromMarker().translationMm();
        for (int i = 0; i < 3; i++) {
            t[i] += d[at + i];
        }
        return RigidTransform.ofRotationVector(new double[] {d[at + 3], d[at + 4], d[at + 5]}, t)
                .compose(RigidTransform.of(reference.worldFromMarker().rotation(), new double[3]));
    }

    private static double[] project(RigidTransform cameraFromMarker) {
        double[] corners = MarkerGeometry.cornersMm(cameraFromMarker, SIZE_MM);
        double[] px = new double[8];
        for (int k = 0; k < 4; k++) {
            System.arraycopy(CAMERA.project(corners[3 * k], corners[3 * k + 1], corners[3 * k + 2]), 0, px, 2 * k, 2);
        }
        return px;
    }

    private CameraModeFinder finder(int node) {
        return new CameraModeFinder(view, CAMERA, new RigidMarkerNoise(view, errors, AddedNoise.atNode(node)),
                IntrinsicsPrior.KNOWN, null);
    }

    private List<PoseMode> modes(int node) {
        List<PoseMode> modes = finder(node).modes(InitialPose.PNP.estimate(view, CAMERA));
        assertEquals(2, modes.size());
        return modes;
    }

    /** Minus the logarithm of the joint posterior of a step of the pose, placement errors and shared unknowns. */
    private double joint(CameraState base, double[] x) {
        CameraState state = new CameraState();
        state.setMoved(base, x, 0);
        RigidTransform cameraFromWorld = view.worldFromCamera(state.cameraFromSet()).inverse();
        double sum = 0;
        for (int m = 0; m < 2; m++) {
            double[] px = project(cameraFromWorld.compose(placed(cell.references().get(m), x, 6 + 6 * m)));
            double[] seen = errors.cornersPx(m, java.util.Arrays.copyOfRange(x, 18, x.length));
            SimpleMatrix residual = new SimpleMatrix(8, 1);
            for (int i = 0; i < 8; i++) {
                residual.set(i, px[i] - seen[i]);
            }
            double[] covariance = new double[64];
            errors.covariance(m, AddedNoise.atNode(NODE), covariance);
            sum += 0.5 * residual.dot(new SimpleMatrix(8, 8, true, covariance).solve(residual));
        }
        for (int i = 6; i < x.length; i++) {
            double std = i >= 18 ? 1 : i % 6 < 3 ? STD_MM : STD_RAD;
            sum += 0.5 * x[i] * x[i] / (std * std);
        }
        return sum;
    }

    /** No unknown alone can be moved to where the joint posterior is higher: nu and d take no part of each other. */
    @Test
    void modesAreThoseOfPosePlacementErrorsAndSharedUnknownsTogether() {
        assertTrue(errors.unknowns() >= 2, "edges and a size");
        for (PoseMode mode : modes(NODE)) {
            CameraState state = mode.state();
            double[] x = new double[18 + errors.unknowns()];
            System.arraycopy(mode.placed().errors(), 0, x, 6, 12);
            System.arraycopy(state.unknowns, 0, x, 18, errors.unknowns());
            double largestShared = 0;
            for (int i = 0; i < x.length; i++) {
                double std = i < 6 ? Math.sqrt(mode.covariance()[i * (mode.dimension() + 1)])
                        : i >= 18 ? 1 : i % 6 < 3 ? STD_MM : STD_RAD;
                double[] up = x.clone();
                double[] down = x.clone();
                up[i] += 1e-3 * std;
                down[i] -= 1e-3 * std;
                assertEquals(0, (joint(state, up) - joint(state, down)) / 2e-3, 1e-3, "unknown " + i);
                largestShared = Math.max(largestShared, i >= 18 ? Math.abs(x[i]) : 0);
            }
            assertTrue(largestShared > 0.05, "shared unknowns must be of account: " + largestShared);
            assertEquals(mode.halfChiSquare(), joint(state, x), 1e-6 * mode.halfChiSquare());
        }
    }

    /** A noise that is sampled, where it is that of the modes: the density with the modes' own whitening. */
    @Test
    void sampledNoiseWhitensAsTheModesDo() {
        List<PoseMode> modes = modes(NODE);
        CameraLikelihood frozen = new NearestModeLikelihood(view, modes);
        CameraLikelihood sampled = new NearestModeLikelihood(view, modes, errors);
        RandomGenerator random = RandomStreams.of(84);
        CameraState moved = new CameraState();
        for (PoseMode mode : modes) {
            double priors = 0;
            for (double nu : mode.state().unknowns) {
                priors += 0.5 * nu * nu;
            }
            double logDiagonal = 0;
            for (int i = 0; i < 128; i += i % 64 == 63 ? 1 : 9) {
                logDiagonal += Math.log(mode.whitening()[i]);
            }
            assertEquals(logDiagonal - mode.halfChiSquare() + priors, sampled.at(mode.state()), 1e-9);
            for (int k = 0; k < 50; k++) {
                double[] step = new double[6];
                for (int i = 0; i < 6; i++) {
                    step[i] = Math.sqrt(mode.covariance()[i * (mode.dimension() + 1)]) * random.nextGaussian();
                }
                moved.setMoved(mode.state(), step, 0);
                for (int j = 0; j < moved.unknowns.length; j++) {
                    moved.unknowns[j] = random.nextGaussian();
                }
                assertEquals(frozen.at(moved), sampled.at(moved), 1e-8 * Math.abs(frozen.at(moved)));
                double before = sampled.at(moved);
                moved.noise += 0.5;
                assertTrue(Math.abs(sampled.at(moved) - before) > 1e-3, "more noise is another density");
            }
        }
    }

    /** From the modes of little noise those of much are found, and back. */
    @Test
    void modesOfAnotherNoiseAreFoundFromKnownOnes() {
        int[] nodes = {AddedNoise.node(-2), AddedNoise.node(1)};
        for (int i = 0; i < 2; i++) {
            List<PoseMode> searched = modes(nodes[i]);
            List<PoseMode> refined = finder(nodes[i]).refined(modes(nodes[1 - i]));
            assertEquals(2, refined.size());
            for (int k = 0; k < 2; k++) {
                assertEquals(searched.get(k).logWeight(), refined.get(k).logWeight(), 1e-4);
                assertEquals(AddedNoise.atNode(nodes[i]), refined.get(k).state().noise);
            }
        }
    }
}
