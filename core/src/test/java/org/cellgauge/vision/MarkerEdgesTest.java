package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.light.ToneCurve;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What the fit says of its own errors against the scatter over noisy pictures of one marker. */
class MarkerEdgesTest {
    private static final int SIZE_PX = 72;
    private static final int PICTURES = 200;
    private static final double NOISE = 3;
    private static final int SUB = 12;
    private static final double BLUR_PX = 0.7;
    private static final MarkerFamily FAMILY = MarkerFamily.SQUARE_BINARY;
    private static final int ID = 944;
    /** Turned by some 17 degrees and a little out of square, as perspective makes it. */
    private static final double[] CORNERS = {22.3, 14.6, 55.9, 24.7, 46.2, 57.8, 12.4, 48.1};

    /**
     * The marker in light: points on a grid of 1/12 px, blurred by a Gaussian between them, averaged over pixels. None
     * of it knows what the fit makes of an edge.
     */
    private static double[] light(double[] cornersPx) {
        return light(cornersPx, BLUR_PX);
    }

    private static double[] light(double[] cornersPx, double blurPx) {
        int n = SIZE_PX * SUB;
        boolean[] cells = new FamilyPatterns(FAMILY).white(ID);
        int count = new FamilyPatterns(FAMILY).grid().bands();
        double[] toImage = new double[8];
        assertTrue(Homography.ofUnitSquare(cornersPx, toImage));
        double[] h = inverse(toImage);
        double[] fine = new double[n * n];
        for (int y = 0; y < n; y++) {
            for (int x = 0; x < n; x++) {
                double u = (x + 0.5) / SUB;
                double v = (y + 0.5) / SUB;
                double w = h[6] * u + h[7] * v + h[8];
                double s = (h[0] * u + h[1] * v + h[2]) / w;
                double t = (h[3] * u + h[4] * v + h[5]) / w;
                boolean inside = s >= 0 && t >= 0 && s < 1 && t < 1;
                boolean white = !inside || cells[(int) (t * count) * count + (int) (s * count)];
                fine[y * n + x] = white ? 0.7 : 0.05;
            }
        }
        int reach = (int) Math.ceil(5 * blurPx * SUB);
        double[] kernel = new double[2 * reach + 1];
        double sum = 0;
        for (int k = -reach; k <= reach; k++) {
            kernel[k + reach] = Math.exp(-0.5 * k * k / (blurPx * SUB * blurPx * SUB));
            sum += kernel[k + reach];
        }
        // along rows, then the sum over a pixel's columns, then the same down the columns
        double[] half = pixels(fine, n, kernel, sum);
        double[] turned = new double[SIZE_PX * n];
        for (int y = 0; y < n; y++) {
            for (int x = 0; x < SIZE_PX; x++) {
                turned[x * n + y] = half[y * SIZE_PX + x];
            }
        }
        double[] columns = pixels(turned, SIZE_PX, kernel, sum);
        double[] out = new double[SIZE_PX * SIZE_PX];
        for (int x = 0; x < SIZE_PX; x++) {
            for (int y = 0; y < SIZE_PX; y++) {
                out[y * SIZE_PX + x] = columns[x * SIZE_PX + y];
            }
        }
        return out;
    }

    /** Rows of fine points, blurred and summed up to pixels. */
    private static double[] pixels(double[] in, int rows, double[] kernel, double kernelSum) {
        int n = SIZE_PX * SUB;
        int reach = kernel.length / 2;
        double[] out = new double[rows * SIZE_PX];
        for (int r = 0; r < rows; r++) {
            for (int p = 0; p < SIZE_PX; p++) {
                double sum = 0;
                for (int i = 0; i < SUB; i++) {
                    for (int k = -reach; k <= reach; k++) {
                        sum += kernel[k + reach] * in[r * n + Math.min(n - 1, Math.max(0, p * SUB + i + k))];
                    }
                }
                out[r * SIZE_PX + p] = sum / (kernelSum * SUB);
            }
        }
        return out;
    }

    private static double[] inverse(double[] h) {
        double[] m = {h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7], 1};
        return new double[] {m[4] * m[8] - m[5] * m[7], m[2] * m[7] - m[1] * m[8], m[1] * m[5] - m[2] * m[4],
            m[5] * m[6] - m[3] * m[8], m[0] * m[8] - m[2] * m[6], m[2] * m[3] - m[0] * m[5],
            m[3] * m[7] - m[4] * m[6], m[1] * m[6] - m[0] * m[7], m[0] * m[4] - m[1] * m[3]};
    }

    private static GreyImage photo(double[] light, ToneCurve curve, RandomGenerator random) {
        byte[] grey = new byte[light.length];
        for (int i = 0; i < grey.length; i++) {
            double level = 255 * curve.grey(light[i]) + NOISE * random.nextGaussian();
            grey[i] = (byte) Math.max(0, Math.min(255, Math.round(level)));
        }
        return GreyImage.packed(grey, SIZE_PX, SIZE_PX);
    }

    /**
     * A variance from 200 pictures has a relative deviation of {@code sqrt(2/199)} = 0.10. The eight of the corners
     * together are judged by their sum, whose deviation is below that of one (0.10), each of them and the shift's by
     * four of their own; means by four deviations of a mean and 0.004 px for what the model leaves out.
     */
    @ParameterizedTest
    @ValueSource(strings = {"linear", "srgb"})
    void covarianceOfCornersAndShiftIsTheirScatter(String words) {
        ToneCurve curve = ToneCurve.of(words);
        double[] light = light(CORNERS);
        RandomGenerator random = new Well19937c(5);
        BoofMarkerDetector detector = new BoofMarkerDetector(PinholeCamera.ideal(SIZE_PX, SIZE_PX, 300, 300, 36, 36),
                FAMILY, List.of(ID), 1, curve);
        double[] sum = new double[9];
        double[] squares = new double[81];
        double[] stated = new double[81];
        for (int i = 0; i < PICTURES; i++) {
            MarkerObservation seen = detector.detect(photo(light, curve, random), "noisy").find(ID);
            assertTrue(seen != null, "picture " + i);
            double[] e = new double[9];
            double[] corners = seen.cornersPx();
            for (int k = 0; k < 8; k++) {
                e[k] = corners[k] - CORNERS[k];
            }
            e[8] = seen.edgeShift().shiftPx();
            double[] covariance = seen.covariancePx2();
            double[] withShift = seen.edgeShift().covarianceWithCornersPx2();
            for (int r = 0; r < 9; r++) {
                sum[r] += e[r] / PICTURES;
                for (int c = 0; c < 9; c++) {
                    squares[9 * r + c] += e[r] * e[c] / (PICTURES - 1);
                    stated[9 * r + c] += (r < 8 && c < 8 ? covariance[8 * r + c] : r < 8 ? withShift[r] : c < 8
                            ? withShift[c] : seen.edgeShift().variancePx2()) / PICTURES;
                }
            }
        }
        double ratio = 0;
        for (int r = 0; r < 9; r++) {
            double std = Math.sqrt(stated[10 * r]);
            assertEquals(0, sum[r], 4 * std / Math.sqrt(PICTURES) + 0.004, words + ": mean of " + r);
            for (int c = 0; c <= r; c++) {
                double found = squares[9 * r + c] - sum[r] * sum[c] * PICTURES / (PICTURES - 1);
                // a correlation has a deviation of at most 1/sqrt(200), a variance's is sqrt(2) times that
                double scatter = std * Math.sqrt(stated[10 * c]);
                assertEquals(stated[9 * r + c], found, (r == c ? 0.4 : 0.28) * scatter, words + ": " + r + ", " + c);
                ratio += r == c && r < 8 ? found / stated[10 * r] / 8 : 0;
            }
        }
        assertEquals(1, ratio, 0.2, words);
    }

    /**
     * Corners and shift share noise of the white and of the blur. In the dark these are poorly known, and a part that
     * is counted for one and not for the other states variances that nothing can have: corners less what they share
     * with the shift, as a check takes them, then have none.
     */
    @Test
    void covarianceOfCornersAndShiftTogetherIsOneInTheDark() {
        double[] large = {12, 12, 60, 12, 60, 60, 12, 60};
        double[] light = light(large, 0.2);
        for (int i = 0; i < light.length; i++) {
            light[i] *= 0.1;
        }
        BoofMarkerDetector detector = new BoofMarkerDetector(PinholeCamera.ideal(SIZE_PX, SIZE_PX, 300, 300, 36, 36),
                FAMILY, List.of(ID), 1, ToneCurve.LINEAR);
        RandomGenerator random = new Well19937c(8);
        for (int i = 0; i < 25; i++) {
            MarkerObservation seen = detector.detect(photo(light, ToneCurve.LINEAR, random), "dark").find(ID);
            EdgeShift shift = seen.edgeShift();
            double[] joint = new double[81];
            for (int a = 0; a < 8; a++) {
                System.arraycopy(seen.covariancePx2(), 8 * a, joint, 9 * a, 8);
                joint[9 * a + 8] = shift.covarianceWithCornersPx2()[a];
                joint[72 + a] = shift.covarianceWithCornersPx2()[a];
            }
            joint[80] = shift.variancePx2();
            assertTrue(Cholesky.factor(joint, 9), "picture " + i);
        }
    }

    /** Means of corners' errors and the shift, less four of their own standard errors. */
    private static double[] beyondChance(double[] light, double[] cornersPx, int pictures) {
        RandomGenerator random = new Well19937c(7);
        BoofMarkerDetector detector = new BoofMarkerDetector(PinholeCamera.ideal(SIZE_PX, SIZE_PX, 300, 300, 36, 36),
                FAMILY, List.of(ID), 1, ToneCurve.LINEAR);
        double[] mean = new double[9];
        double[] variance = new double[9];
        for (int i = 0; i < pictures; i++) {
            MarkerObservation seen = detector.detect(photo(light, ToneCurve.LINEAR, random), "noisy").find(ID);
            for (int k = 0; k < 8; k++) {
                mean[k] += (seen.cornersPx()[k] - cornersPx[k]) / pictures;
                variance[k] += seen.covariancePx2()[9 * k] / pictures;
            }
            mean[8] += seen.edgeShift().shiftPx() / pictures;
            variance[8] += seen.edgeShift().variancePx2() / pictures;
        }
        for (int k = 0; k < 9; k++) {
            mean[k] = Math.max(0, Math.abs(mean[k]) - 4 * Math.sqrt(variance[k] / pictures));
        }
        return mean;
    }

    /** A lamp that is brighter by a seventh at one end of the marker turns no side and feigns no shift. */
    @Test
    void lightThatChangesOverTheMarkerMovesNoCorner() {
        double[] light = light(CORNERS);
        for (int y = 0; y < SIZE_PX; y++) {
            for (int x = 0; x < SIZE_PX; x++) {
                light[y * SIZE_PX + x] *= 1 + 0.004 * (x + 0.5 - 36) - 0.001 * (y + 0.5 - 36);
            }
        }
        for (double e : beyondChance(light, CORNERS, 40)) {
            assertEquals(0, e, 0.002);
        }
    }

    /** Seen so far aslant that its angles are off by 19 degrees, a marker as it should be shows no shift of edges. */
    @Test
    void slantedMarkerFeignsNoShift() {
        double[] slanted = {8.2, 16.1, 46.4, 10.3, 66.1, 50.2, 30.3, 58.4};
        for (double e : beyondChance(light(slanted), slanted, 60)) {
            assertEquals(0, e, 0.002);
        }
    }

    /**
     * At a blur of 0.4 cells BoofCV reads the marker as another one. It tells the photo's light all the same: left out
     * of that, its edges were sought at a curve that nothing had tested, and lay off by half a pixel.
     */
    @Test
    void markerThatBoofCvMisreadsTellsTheCurve() {
        double[] corners = {15.3, 16.4, 55.1, 15.2, 56.4, 55.9, 16.2, 56.6};
        double[] light = light(corners, 2.1);
        BoofMarkerDetector detector = new BoofMarkerDetector(PinholeCamera.ideal(SIZE_PX, SIZE_PX, 300, 300, 36, 36),
                FAMILY, List.of(ID), 1);
        Detections seen = detector.detect(photo(light, ToneCurve.SRGB, new Well19937c(9)), "blurred");
        assertEquals(2.2, seen.light().toneCurve().power(), 0.4);
        assertEquals(0, seen.find(ID).edgeShift().shiftPx(), 0.05);
        for (int k = 0; k < 8; k++) {
            assertEquals(corners[k], seen.find(ID).cornersPx()[k], 0.15);
        }
    }

    /** No threads, no state: the same picture through one detector and through another gives the same bits. */
    @Test
    void samePictureGivesTheSameWhateverWasSeenBefore() {
        double[] light = light(CORNERS);
        GreyImage first = photo(light, ToneCurve.SRGB, new Well19937c(1));
        GreyImage second = photo(light, ToneCurve.LINEAR, new Well19937c(2));
        PinholeCamera camera = PinholeCamera.ideal(SIZE_PX, SIZE_PX, 300, 300, 36, 36);
        BoofMarkerDetector detector = new BoofMarkerDetector(camera, FAMILY, List.of(ID), 1);
        MarkerObservation once = detector.detect(first, "first").find(ID);
        detector.detect(second, "second");
        for (MarkerObservation again : List.of(detector.detect(first, "again").find(ID),
                detector.detect(first, "at once again").find(ID),
                new BoofMarkerDetector(camera, FAMILY, List.of(ID), 1).detect(first, "fresh").find(ID))) {
            for (int k = 0; k < 8; k++) {
                assertEquals(once.cornersPx()[k], again.cornersPx()[k], 0);
                assertEquals(once.edgeShift().covarianceWithCornersPx2()[k],
                        again.edgeShift().covarianceWithCornersPx2()[k], 0);
            }
            assertEquals(once.edgeShift().shiftPx(), again.edgeShift().shiftPx(), 0);
            assertEquals(once.covariancePx2()[0], again.covariancePx2()[0], 0);
        }
    }
}
