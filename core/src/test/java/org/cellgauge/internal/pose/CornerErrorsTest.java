package org.cellgauge.internal.pose;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.OptionalDouble;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.PrintPrecision;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.EdgeShift;
import org.cellgauge.vision.MarkerObservation;
import org.cellgauge.vision.PhotoLight;
import org.ejml.simple.SimpleMatrix;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What is made of covariances, measured shifts of edges and the precision of prints. */
class CornerErrorsTest {
    private static final PinholeCamera CAMERA = PinholeCamera.ideal(1280, 720, 900, 900, 640, 360);
    private static final int[] IDS = {1, 2, 3, 7};
    private static final double[] SIZES = {40, 40, 60, 60};
    private static final RigidTransform[] POSES = {RigidTransform.ofEuler(-200, -100, 1000, 3.3, 0.3, 0.2),
        RigidTransform.ofEuler(150, -80, 1100, 2.8, -0.2, 1), RigidTransform.ofEuler(0, 120, 900, 3.0, 0.4, 2),
        RigidTransform.ofEuler(200, 100, 1200, 2.7, -0.4, -1)};

    private static Cell cell(OptionalDouble pixelStdPx, PrintPrecision prints) {
        List<Reference> references = new ArrayList<>();
        for (int m = 0; m < 3; m++) {
            references.add(new Reference(IDS[m], SIZES[m], RigidTransform.ofEuler(100 * m, 0, 0, 0, 0, 0),
                    new Placement(1, 1, 1, 0.01)));
        }
        return new Cell(CAMERA, MarkerFamily.SQUARE_BINARY, references,
                Collections.singletonList(new ObjectMarker(IDS[3], SIZES[3], null)), pixelStdPx,
                OptionalDouble.empty(), prints);
    }

    private static double[] corners(RigidTransform pose, double sizeMm) {
        double[] points = MarkerGeometry.cornersMm(pose, sizeMm);
        double[] px = new double[8];
        for (int k = 0; k < 4; k++) {
            System.arraycopy(CAMERA.project(points[3 * k], points[3 * k + 1], points[3 * k + 2]), 0, px, 2 * k, 2);
        }
        return px;
    }

    private static Detections detections(List<MarkerObservation> markers, double edgeShiftStdPx) {
        return new Detections("test", 1280, 720, markers, Collections.emptyList(),
                new PhotoLight(ToneCurve.SRGB, true, 0.7, 1, 100, edgeShiftStdPx));
    }

    private static double[] add(double[] a, double[] b, double factor) {
        double[] sum = a.clone();
        for (int i = 0; i < sum.length; i++) {
            sum[i] += factor * b[i];
        }
        return sum;
    }

    /** A covariance of 9 errors, eight corners and the shift, that share some of them. */
    private static SimpleMatrix jointFactor() {
        RandomGenerator random = RandomStreams.of(5);
        SimpleMatrix a = new SimpleMatrix(9, 9);
        for (int i = 0; i < 9; i++) {
            for (int j = 0; j <= i; j++) {
                a.set(i, j, 0.05 * (i == j ? 1 : 0.4 * random.nextGaussian()));
            }
        }
        return a;
    }

    /**
     * Shift, ink and errors drawn as the model has them: corrected corners are off by what the columns and covariances
     * say, jointly over all markers (e' S^-1 e of 32 coordinates is chi-square), without a bias in the shift.
     */
    @Test
    void correctedCornersAreOffByWhatIsStated() {
        Cell cell = cell(OptionalDouble.empty(), new PrintPrecision(0, 0, 0.2));
        SimpleMatrix factor = jointFactor();
        SimpleMatrix joint = factor.mult(factor.transpose());
        RandomGenerator random = RandomStreams.of(6);
        int photos = 1500;
        double sum = 0;
        double alongSum = 0;
        double alongVariance = 0;
        for (int p = 0; p < photos; p++) {
            double shift = 0.3 * random.nextGaussian();
            double[] ink = {0.2 * random.nextGaussian(), 0.2 * random.nextGaussian()};
            List<MarkerObservation> markers = new ArrayList<>();
            double[] truth = new double[32];
            for (int m = 0; m < 4; m++) {
                double[] corners = corners(POSES[m], SIZES[m]);
                System.arraycopy(corners, 0, truth, 8 * m, 8);
                double perMm = 0;
                for (int i = 0; i < 4; i++) {
                    int j = (i + 1) % 4;
                    perMm += Math.hypot(corners[2 * i] - corners[2 * j], corners[2 * i + 1] - corners[2 * j + 1]) / 4
                            / SIZES[m];
                }
                double delta = shift - ink[m / 2] * perMm;
                SimpleMatrix normal = new SimpleMatrix(9, 1);
                for (int i = 0; i < 9; i++) {
                    normal.set(i, random.nextGaussian());
                }
                SimpleMatrix errors = factor.mult(normal);
                // ink makes the square larger on the paper, light makes its image smaller
                double[] seen = add(corners(POSES[m], SIZES[m] + 2 * ink[m / 2]), EdgeShift.ofCorners(corners), shift);
                double[] covariance = new double[64];
                double[] shared = new double[8];
                for (int i = 0; i < 8; i++) {
                    seen[i] += errors.get(i);
                    shared[i] = joint.get(i, 8);
                    for (int j = 0; j < 8; j++) {
                        covariance[8 * i + j] = joint.get(i, j);
                    }
                }
                // marker 2 has no measured shift
                markers.add(new MarkerObservation(IDS[m], seen, covariance,
                        m == 1 ? null : new EdgeShift(delta + errors.get(8), joint.get(8, 8), shared)));
            }
            CornerErrors found = CornerErrors.of(cell, detections(markers, 0.3));
            int q = found.unknowns();
            assertEquals(3, q);
            SimpleMatrix s = new SimpleMatrix(32, 32);
            SimpleMatrix columns = new SimpleMatrix(32, q);
            SimpleMatrix e = new SimpleMatrix(32, 1);
            double[] own = new double[64];
            for (int m = 0; m < 4; m++) {
                found.covariance(IDS[m], -4, own);
                double[] corrected = found.cornersPx(IDS[m]);
                for (int i = 0; i < 8; i++) {
                    e.set(8 * m + i, corrected[i] - truth[8 * m + i]);
                    for (int j = 0; j < 8; j++) {
                        s.set(8 * m + i, 8 * m + j, own[8 * i + j]);
                    }
                    for (int j = 0; j < q; j++) {
                        columns.set(8 * m + i, j, found.columns(IDS[m])[i * q + j]);
                    }
                }
            }
            s = s.plus(columns.mult(columns.transpose()));
            sum += e.transpose().mult(s.solve(e)).get(0);
            // all markers' corners along a common shift
            double along = 0;
            SimpleMatrix d = new SimpleMatrix(32, 1);
            for (int m = 0; m < 4; m++) {
                double[] by = EdgeShift.ofCorners(corners(POSES[m], SIZES[m]));
                for (int i = 0; i < 8; i++) {
                    d.set(8 * m + i, by[i] / 64);
                }
            }
            along = d.transpose().mult(e).get(0);
            alongSum += along;
            alongVariance += d.transpose().mult(s).mult(d).get(0);
        }
        // chi-square of 32: deviation 8, of the mean of 1500 0.2; the model allows for a little more than was drawn
        assertEquals(32, sum / photos, 0.8);
        assertEquals(0, alongSum / photos, 4 * Math.sqrt(alongVariance / photos / photos));
    }

    /**
     * Outlines that lie off where inner edges say, all alike, move corners by all of it, whatever corners share with
     * inner edges: inner edges do not show it.
     */
    @Test
    void outlinesOffMoveCornersInFull() {
        double outlineStdPx = 0.5;
        double[] corners = corners(POSES[0], SIZES[0]);
        double[] by = EdgeShift.ofCorners(corners);
        double[] covariance = new double[64];
        double[] shared = new double[8];
        for (int i = 0; i < 8; i++) {
            shared[i] = 0.5 * by[i] * 1e-4;
            for (int j = 0; j < 8; j++) {
                covariance[8 * i + j] = (i == j ? 1e-4 : 0) + 0.5 * by[i] * 0.5 * by[j] * 1e-4;
            }
        }
        PhotoLight light = new PhotoLight(ToneCurve.SRGB, true, 0.7, 1, 100, 0.3).withOutlineStdPx(outlineStdPx);
        CornerErrors found = CornerErrors.of(cell(OptionalDouble.empty(), new PrintPrecision(0, 0, 0)),
                new Detections("test", 1280, 720, Collections.singletonList(new MarkerObservation(IDS[0], corners,
                        covariance, new EdgeShift(0, 1e-4, shared))), Collections.emptyList(), light));
        assertEquals(1, found.unknowns());
        // beside 0.5 px what inner edges leave open, 0.01 px, is nothing
        assertArrayEquals(Arrays.stream(by).map(d -> outlineStdPx * d).toArray(), found.columns(IDS[0]),
                outlineStdPx * 0.005);
    }

    /** Against whole fits weighed by each covariance; these bend with the pose, by some hundredths. */
    @ParameterizedTest
    @CsvSource({"0, 0.01, 0.09", "2, 0.02, 0.5"})
    void squarenessIsWhatFitsSay(int marker, double from, double to) {
        RandomGenerator random = RandomStreams.of(8);
        double[] seen = corners(POSES[marker], SIZES[marker]);
        for (int i = 0; i < 8; i++) {
            seen[i] += 0.2 * random.nextGaussian();
        }
        SimpleMatrix factor = jointFactor().scale(2);
        double[] covariance = factor.mult(factor.transpose()).extractMatrix(0, 8, 0, 8).getDDRM().getData();
        List<PoseMode> modes = new MarkerPoseFinder().modes(seen, SIZES[marker], CAMERA, 1);
        Squareness squareness = new Squareness(modes, covariance);
        assertEquals(byFits(seen, marker, covariance, to) - byFits(seen, marker, covariance, from),
                squareness.logLikelihood(to, 1) - squareness.logLikelihood(from, 1), 0.1);
    }

    private static double byFits(double[] seen, int marker, double[] covariance, double added) {
        double[] sum = covariance.clone();
        for (int i = 0; i < 8; i++) {
            sum[9 * i] += added;
        }
        SimpleMatrix lower = new SimpleMatrix(8, 8, true, sum);
        double[] whitening = new double[64];
        org.cellgauge.internal.geometry.Cholesky.factor(sum, 8);
        org.cellgauge.internal.geometry.Cholesky.invertLower(sum, 8, whitening);
        assertTrue(lower.determinant() > 0);
        double mass = 0;
        for (PoseMode mode : new MarkerPoseFinder().modes(seen, SIZES[marker], CAMERA, whitening)) {
            mass += Math.exp(mode.logWeight());
        }
        return Math.log(mass);
    }

    /** Size and flatness: by how much corners move if the marker is larger, or one of its corners is lifted. */
    @Test
    void sizesAndFlatnessMoveCornersAsGeometryHasIt() {
        Cell cell = cell(OptionalDouble.of(0.1), new PrintPrecision(0.2, 0.5, 0.05));
        List<MarkerObservation> markers = new ArrayList<>();
        for (int m = 0; m < 4; m++) {
            markers.add(new MarkerObservation(IDS[m], corners(POSES[m], SIZES[m])));
        }
        CornerErrors errors = CornerErrors.of(cell, new Detections("test", 1280, 720, markers));
        assertEquals(2, errors.unknowns());
        assertFalse(errors.isPlain());
        double[] covariance = new double[64];
        for (int m = 0; m < 4; m++) {
            double[] larger = add(corners(POSES[m], SIZES[m] + 0.01), corners(POSES[m], SIZES[m] - 0.01), -1);
            errors.covariance(IDS[m], 0, covariance);
            double[] lifted = MarkerGeometry.cornersMm(SIZES[m]);
            for (int k = 0; k < 4; k++) {
                double[] up = POSES[m].apply(lifted[3 * k], lifted[3 * k + 1], 0.01);
                double[] down = POSES[m].apply(lifted[3 * k], lifted[3 * k + 1], -0.01);
                double[] a = CAMERA.project(up[0], up[1], up[2]);
                double[] b = CAMERA.project(down[0], down[1], down[2]);
                for (int c = 0; c < 2; c++) {
                    int i = 2 * k + c;
                    assertEquals(larger[i] / 0.02 * 0.2, errors.columns(IDS[m])[2 * i + m / 2], 1e-4);
                    assertEquals(0, errors.columns(IDS[m])[2 * i + 1 - m / 2], 0);
                    double by = (a[c] - b[c]) / 0.02 * 0.5;
                    assertEquals(0.01 + by * by, covariance[9 * i], 1e-4 * (0.01 + by * by));
                }
            }
        }
        assertTrue(errors.isSizeOfPrints(1));
    }

    /** A stated noise is exact, whatever a detector says of corners. */
    @Test
    void statedNoiseIsTakenAsItIs() {
        double[] covariance = new double[64];
        for (int i = 0; i < 8; i++) {
            covariance[9 * i] = 0.7;
        }
        List<MarkerObservation> markers = new ArrayList<>();
        for (int m = 0; m < 4; m++) {
            markers.add(new MarkerObservation(IDS[m], corners(POSES[m], SIZES[m]), covariance, null));
        }
        CornerErrors errors = CornerErrors.of(cell(OptionalDouble.of(0.3), PrintPrecision.USUAL),
                new Detections("test", 1280, 720, markers));
        assertTrue(errors.isPlain());
        assertEquals(0.3, errors.usualStdPx(1), 0);
        assertSame(errors, errors.withOutliersSetAside());
        double[] out = new double[64];
        errors.covariance(IDS[0], 2, out);
        double[] expected = new double[64];
        for (int i = 0; i < 8; i++) {
            expected[9 * i] = 0.3 * 0.3;
        }
        assertArrayEquals(expected, out, 0);
        assertArrayEquals(corners(POSES[0], SIZES[0]), errors.cornersPx(IDS[0]), 0);
    }

    /** Where all corners are alike, hardly a marker is taken for one with an outlier: widths grow by less than 3 %. */
    @ParameterizedTest
    @CsvSource({"true", "false"})
    void lookingForOutliersCostsLittle(boolean told) {
        RandomGenerator random = RandomStreams.of(13);
        Cell cell = cell(OptionalDouble.empty(), PrintPrecision.USUAL);
        double[] covariance = new double[64];
        for (int i = 0; i < 8; i++) {
            covariance[9 * i] = 0.05 * 0.05;
        }
        int photos = 1000;
        double logWidth = 0;
        for (int p = 0; p < photos; p++) {
            List<MarkerObservation> markers = new ArrayList<>();
            for (int m = 0; m < 4; m++) {
                double[] seen = corners(POSES[m], SIZES[m]);
                for (int i = 0; i < 8; i++) {
                    seen[i] += 0.05 * random.nextGaussian();
                }
                markers.add(new MarkerObservation(IDS[m], seen, told ? covariance : null, null));
            }
            CornerErrors errors = CornerErrors.of(cell, new Detections("test", 1280, 720, markers));
            CornerErrors robust = errors.withOutliersSetAside();
            for (int id : robust.setAside().keySet()) {
                logWidth += 0.5 * Math.log(robust.meanVariancePx2(id, 0)
                        / errors.meanVariancePx2(id, robust.squarenessBelief().ofMeanVariance())) / photos / 4;
            }
        }
        assertTrue(logWidth < 0.03, "width grows by " + logWidth);
    }

    /** One corner far off: its marker alone is set aside, and the others' noise is learned without it. */
    @ParameterizedTest
    @CsvSource({"0, 0", "3, 2"})
    void aMarkerWithAnOutlierIsSetAside(int marker, int corner) {
        RandomGenerator random = RandomStreams.of(12);
        List<MarkerObservation> markers = new ArrayList<>();
        for (int m = 0; m < 4; m++) {
            double[] seen = corners(POSES[m], SIZES[m]);
            for (int i = 0; i < 8; i++) {
                seen[i] += 0.05 * random.nextGaussian();
            }
            if (m == marker) {
                seen[2 * corner] += 1;
            }
            markers.add(new MarkerObservation(IDS[m], seen));
        }
        CornerErrors errors = CornerErrors.of(cell(OptionalDouble.empty(), PrintPrecision.USUAL),
                new Detections("test", 1280, 720, markers));
        CornerErrors robust = errors.withOutliersSetAside();
        assertEquals(Collections.singleton(IDS[marker]), robust.setAside().keySet());
        // its corners are off by 1 px / sqrt(8) in the root mean square; sqrt(2) of that is stated
        assertEquals(0.5, Math.sqrt(robust.meanVariancePx2(IDS[marker], 0)), 0.15);
        double[] before = {errors.squarenessBelief().quantileStdPx(0.5), robust.squarenessBelief().quantileStdPx(0.5)};
        assertTrue(before[0] > 0.12 && before[1] < 0.11, Arrays.toString(before));
    }
}
