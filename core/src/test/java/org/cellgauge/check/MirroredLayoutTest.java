package org.cellgauge.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
import org.cellgauge.estimate.ModeEstimate;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.geometry.Rotations;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.sampling.Draws;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.junit.jupiter.api.Test;

/** A small set of references that is not quite flat, far away: the camera pose mirrored at it must not be lost. */
class MirroredLayoutTest {
    private static final PinholeCamera CAMERA = PinholeCamera.ideal(1280, 960, 1500, 1500, 640, 480);
    private static final double PIXEL_STD = 0.3;
    private static final double STD_MM = 1;
    private static final double STD_RAD = Math.toRadians(2);
    private static final double LARGEST_TILT_RAD = Math.toRadians(55);
    /** Four references of 25 mm within 60 x 48 mm, one of them 2 mm higher. */
    private static final double[][] PLACES = {{0, 0, 0}, {35, 0, 0}, {0, 23, 0}, {35, 23, 2}};

    private static Cell cell() {
        List<Reference> references = new ArrayList<>();
        for (int i = 0; i < PLACES.length; i++) {
            references.add(new Reference(i + 1, 25, RigidTransform.ofEuler(PLACES[i][0], PLACES[i][1], PLACES[i][2], 0,
                    0, 0), new Placement(STD_MM, STD_MM, STD_MM, STD_RAD)));
        }
        return new Cell(CAMERA, MarkerFamily.SQUARE_BINARY, references, new ArrayList<>(),
                OptionalDouble.of(PIXEL_STD), OptionalDouble.of(1000));
    }

    /** The camera 1.9 m away; the set is turned evenly over all rotations that tilt it less than the largest tilt. */
    private static RigidTransform worldFromCamera(RandomGenerator random) {
        double tilt = Math.acos(1 - random.nextDouble() * (1 - Math.cos(LARGEST_TILT_RAD)));
        double around = 2 * Math.PI * random.nextDouble();
        double[] tilted = new double[9];
        double[] facing = new double[9];
        double[] turned = new double[9];
        double[] product = new double[9];
        double[] r = new double[9];
        Rotations.exp(tilt * Math.cos(around), tilt * Math.sin(around), 0, tilted);
        // the set's z axis looks at the camera, whose own looks at the set
        Rotations.fromEuler(Math.PI, 0, 0, facing);
        Rotations.fromEuler(0, 0, 2 * Math.PI * random.nextDouble(), turned);
        Rotations.multiply(tilted, facing, product);
        Rotations.multiply(product, turned, r);
        return RigidTransform.of(r, new double[] {0, 0, 1900}).inverse();
    }

    private static Detections photo(Cell cell, RigidTransform worldFromCamera, RandomGenerator random) {
        List<MarkerObservation> markers = new ArrayList<>();
        for (Reference reference : cell.references()) {
            double[] t = reference.worldFromMarker().translationMm();
            double[] w = new double[3];
            for (int i = 0; i < 3; i++) {
                t[i] += STD_MM * random.nextGaussian();
                w[i] = STD_RAD * random.nextGaussian();
            }
            RigidTransform placed = RigidTransform.ofRotationVector(w, t);
            double[] corners = MarkerGeometry.cornersMm(worldFromCamera.inverse().compose(placed), 25);
            double[] px = new double[8];
            for (int k = 0; k < 4; k++) {
                double[] uv = CAMERA.project(corners[3 * k], corners[3 * k + 1], corners[3 * k + 2]);
                px[2 * k] = uv[0] + PIXEL_STD * random.nextGaussian();
                px[2 * k + 1] = uv[1] + PIXEL_STD * random.nextGaussian();
            }
            markers.add(new MarkerObservation(reference.id(), px));
        }
        return new Detections("small set", 1280, 960, markers);
    }

    /** Share of the draws at which the posterior is lower than at the true pose: uniform if the posterior is right. */
    private static double shareBelow(CheckResult result, RigidTransform truth) {
        double level = result.cameraLogDensity(truth);
        int below = 0;
        int all = 0;
        for (Draws chain : result.draws()) {
            for (double value : chain.series(0)) {
                below += value < level ? 1 : 0;
                all++;
            }
        }
        return (double) below / all;
    }

    @Test
    void theMirroredPoseIsFoundAndWeighedByItsChance() {
        Cell cell = cell();
        int photos = 60;
        int covered = 0;
        int heaviest = 0;
        int half = 0;
        int ambiguous = 0;
        double expected = 0;
        double variance = 0;
        for (int p = 0; p < photos; p++) {
            RandomGenerator random = RandomStreams.of(71, p);
            RigidTransform truth = worldFromCamera(random);
            CheckResult result = CellCheck.run(cell, photo(cell, truth, random),
                    CheckSettings.builder().seed(p).targetMcseStdRel(0.1).build());
            assertTrue(result.verdict() != Verdict.NOT_CONVERGED, "photo " + p);
            List<ModeEstimate> modes = result.estimate().cameraModes();
            int nearest = 0;
            for (int k = 1; k < modes.size(); k++) {
                if (modes.get(k).pose().meanTransform().angleRadTo(truth)
                        < modes.get(nearest).pose().meanTransform().angleRadTo(truth)) {
                    nearest = k;
                }
            }
            double weight = modes.get(0).weight();
            boolean several = 1 - weight > ModeEstimate.AMBIGUOUS_SHARE;
            assertEquals(several, result.verdict() == Verdict.AMBIGUOUS, "photo " + p);
            ambiguous += several ? 1 : 0;
            expected += weight;
            variance += weight * (1 - weight);
            heaviest += nearest == 0 ? 1 : 0;
            double d = shareBelow(result, truth);
            covered += d > 0.05 ? 1 : 0;
            half += d > 0.5 ? 1 : 0;
        }
        assertTrue(ambiguous > 20, ambiguous + " of 60 were ambiguous: too few to judge");
        // the true pose is the heaviest mode as often as the weights say
        assertEquals(expected, heaviest, 3 * Math.sqrt(variance), "true pose the heaviest mode");
        // three standard errors of a count of 60 with chances of 0.95 and 0.5
        assertTrue(covered >= 52, covered + " of 60 within their 95 % regions");
        assertEquals(30, half, 12, "of 60 within their 50 % regions");
    }
}
