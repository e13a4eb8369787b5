package org.cellgauge.statistics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleUnaryOperator;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.cellgauge.statistics.ChainDiagnostics.Status;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ChainDiagnosticsTest {
    /** Relative. Both sides compute in double precision; what differs is the order of summation. */
    private static final double TOLERANCE = 1e-8;

    /** Draws and values were written by make_reference.py, with ArviZ. */
    @ParameterizedTest
    @ValueSource(strings = {"normal", "autoregressive", "antithetic", "capped", "cauchy", "shifted", "scaled",
        "rounded", "odd", "single", "sticky", "offset", "trend"})
    void agreesWithArviz(String name) throws IOException {
        ChainDiagnostics d = ChainDiagnostics.of(draws(name));
        assertEquals(Status.OK, d.status());
        Map<String, Double> expected = reference(name);
        assertEquals(27, expected.size());
        for (Map.Entry<String, Double> e : expected.entrySet()) {
            double actual = value(d, e.getKey());
            assertEquals(e.getValue(), actual, TOLERANCE * Math.abs(e.getValue()), name + " " + e.getKey());
        }
    }

    private static double value(ChainDiagnostics d, String quantity) {
        String[] parts = quantity.split(":");
        switch (parts[0]) {
            case "mean":
                return d.mean();
            case "std":
                return d.std();
            case "r_hat_bulk":
                return d.rHatBulk();
            case "r_hat_folded":
                return d.rHatFolded();
            case "r_hat":
                return d.rHat();
            case "ess_bulk":
                return d.essBulk();
            case "ess_tail":
                return d.essTail();
            case "ess_mean":
                return d.essMean();
            case "ess_sd":
                return d.essSd();
            case "ess_squared":
                return d.essSquaredDeviation();
            case "mcse_mean":
                return d.mcseMean();
            case "mcse_sd":
                return d.mcseSd();
            case "quantile":
                return d.quantile(Double.parseDouble(parts[1]));
            case "ess_quantile":
                return d.essQuantile(Double.parseDouble(parts[1]));
            case "mcse_quantile":
                return d.mcseQuantile(Double.parseDouble(parts[1]));
            default:
                throw new AssertionError("unknown quantity " + quantity);
        }
    }

    @Test
    void rHatOfTwoShortChainsIsThatByHand() {
        // Halves (1,2), (3,4), (5,6), (7,8) of ranks 1..8. With z_i the normal quantiles of (i - 3/8)/8.25, opposite in
        // pairs: z = -a, -b, -c, -d, d, c, b, a. Half means -(a+b)/2, -(c+d)/2, ...; variances (a-b)^2/2, (c-d)^2/2.
        double a = 1.434200159686;
        double b = 0.852495034275;
        double c = 0.472789120992;
        double d = 0.152505974246;
        double within = ((a - b) * (a - b) + (c - d) * (c - d)) / 4;
        double outer = (a + b) / 2;
        double inner = (c + d) / 2;
        double between = 2 * (outer * outer + inner * inner) / 3;
        double expected = Math.sqrt(0.5 + between / within);
        ChainDiagnostics diagnostics = ChainDiagnostics.of(new double[][] {{10, 20, 30, 40}, {50, 60, 70, 80}});
        assertEquals(expected, diagnostics.rHatBulk(), 1e-10);
        assertTrue(Double.isNaN(diagnostics.essBulk()), "two draws per half give no autocorrelation");
        assertEquals(Convergence.NOT_CONVERGED, diagnostics.convergence());
    }

    @ParameterizedTest
    @CsvSource({"0.9, 1", "0.5, 2", "0, 3", "-0.5, 4"})
    void effectiveSizeOfAutoregressionIsTheClosedForm(double rho, long seed) {
        // For an AR(1) process, the mean of S draws has the variance of S (1 - rho) / (1 + rho) independent ones.
        // The estimate of the integrated time from S draws, with a window of W lags, has a relative error of about
        // sqrt(2 (2 W + 1) / S) (Sokal 1997, section 3); W = 50 for rho = 0.9 and 10 elsewhere, four such errors.
        int draws = 10000;
        ChainDiagnostics d = ChainDiagnostics.of(autoregression(4, draws, rho, seed));
        double total = 4.0 * draws;
        double expected = total * (1 - rho) / (1 + rho);
        int window = rho > 0.8 ? 50 : 10;
        double bound = 4 * Math.sqrt(2 * (2 * window + 1) / total);
        assertEquals(1, d.essMean() / expected, bound);
        assertEquals(1, d.essBulk() / expected, bound);
        // Squares of a normal AR(1) process have autocorrelation rho^2 to the lag
        double squares = total * (1 - rho * rho) / (1 + rho * rho);
        assertEquals(1, d.essSquaredDeviation() / squares, bound);
        // Standard error of the mean of unit normal draws, and of their deviation: 1 / sqrt(2 S)
        assertEquals(1 / Math.sqrt(expected), d.mcseMean(), bound / Math.sqrt(expected));
        assertEquals(1 / Math.sqrt(2 * squares), d.mcseSd(), bound / Math.sqrt(2 * squares));
    }

    @Test
    void quantileErrorOfIndependentNormalDrawsIsTheAsymptoticOne() {
        // sd of the sample median of S normal draws: sqrt(pi / (2 S)). Each order statistic that is one such error
        // away from the median is itself uncertain by the sampling of the few hundred draws between: about 6 % of it.
        ChainDiagnostics d = ChainDiagnostics.of(autoregression(4, 10000, 0, 7));
        double expected = Math.sqrt(Math.PI / 2 / 40000);
        assertEquals(expected, d.mcseQuantile(0.5), 0.25 * expected);
        assertEquals(0, d.quantile(0.5), 4 * expected);
    }

    @Test
    void antitheticChainsMayHaveMoreEffectiveDrawsThanDrawsUpToTheCap() {
        ChainDiagnostics d = ChainDiagnostics.of(autoregression(4, 1000, -0.5, 3));
        assertTrue(d.essMean() > 8000);
        // The half-chain alternates exactly: the estimated time would be zero or negative
        double[][] alternating = autoregression(4, 500, 0, 4);
        for (double[] chain : alternating) {
            for (int i = 0; i < chain.length; i++) {
                chain[i] = (i % 2 == 0 ? 1 : -1) + 1e-3 * chain[i];
            }
        }
        assertEquals(2000 * Math.log10(2000), ChainDiagnostics.of(alternating).essMean(), 1e-9);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void rankBasedDiagnosticsDoNotSeeMonotoneTransforms(long seed) {
        double[][] draws = autoregression(3, 301, 0.7, seed);
        ChainDiagnostics before = ChainDiagnostics.of(draws);
        for (DoubleUnaryOperator f : List.<DoubleUnaryOperator>of(Math::exp, x -> x * x * x, Math::atan)) {
            ChainDiagnostics after = ChainDiagnostics.of(map(draws, f));
            assertEquals(before.rHatBulk(), after.rHatBulk(), 0);
            assertEquals(before.essBulk(), after.essBulk(), 0);
        }
        ChainDiagnostics mirrored = ChainDiagnostics.of(map(draws, x -> -x));
        assertEquals(before.rHat(), mirrored.rHat(), 1e-12);
        assertEquals(before.essBulk(), mirrored.essBulk(), 1e-9 * before.essBulk());
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-200, 1e-6, 1024, 1e200})
    void unitOfTheDrawsScalesErrorsAndNothingElse(double unit) {
        double[][] draws = autoregression(4, 200, 0.5, 6);
        ChainDiagnostics a = ChainDiagnostics.of(draws);
        ChainDiagnostics b = ChainDiagnostics.of(map(draws, x -> unit * x));
        assertEquals(a.rHat(), b.rHat(), 1e-12);
        assertEquals(a.essTail(), b.essTail(), 1e-9);
        assertEquals(a.essMean(), b.essMean(), 1e-8);
        assertEquals(a.essSd(), b.essSd(), 1e-8);
        assertEquals(a.essSquaredDeviation(), b.essSquaredDeviation(), 1e-8);
        assertEquals(a.mcseQuantile(0.3), b.mcseQuantile(0.3) / unit, 1e-12);
        if (unit > 1e-100 && unit < 1e100) {
            // Beyond, the variance itself leaves the range of double precision
            assertEquals(a.mcseMean(), b.mcseMean() / unit, 1e-12);
            assertEquals(a.mcseSd(), b.mcseSd() / unit, 1e-12);
        }
    }

    @Test
    void orderOfChainsDoesNotMatter() {
        double[][] d = autoregression(3, 100, 0.4, 12);
        ChainDiagnostics a = ChainDiagnostics.of(d);
        ChainDiagnostics b = ChainDiagnostics.of(new double[][] {d[2], d[0], d[1]});
        assertEquals(a.rHat(), b.rHat(), 1e-12);
        assertEquals(a.essBulk(), b.essBulk(), 1e-9);
        assertEquals(a.essTail(), b.essTail(), 1e-9);
    }

    @Test
    void middleOfAnOddNumberOfDrawsTakesNoPartInBulk() {
        double[][] d = autoregression(2, 101, 0.4, 13);
        ChainDiagnostics a = ChainDiagnostics.of(d);
        d[0][50] = 1000;
        ChainDiagnostics b = ChainDiagnostics.of(d);
        assertEquals(a.rHatBulk(), b.rHatBulk(), 0);
        assertEquals(a.essBulk(), b.essBulk(), 0);
        assertTrue(b.mean() > a.mean());
    }

    @Test
    void chainsThatDisagreeInSpreadAloneAreSeenByTheFoldedPart() throws IOException {
        ChainDiagnostics d = ChainDiagnostics.of(draws("scaled"));
        assertTrue(d.rHatBulk() < 1.01);
        assertTrue(d.rHat() > 1.05);
        assertEquals(Convergence.NOT_CONVERGED, d.convergence());
        assertEquals(Convergence.NOT_CONVERGED, ChainDiagnostics.of(draws("shifted")).convergence());
        assertEquals(Convergence.CONVERGED, ChainDiagnostics.of(draws("normal")).convergence());
    }

    @Test
    void drawsThatCannotBeJudgedHaveNoDiagnosticsAndNeverOne() {
        double[] moving = autoregression(1, 50, 0.4, 14)[0];
        double[] still = new double[50];
        Arrays.fill(still, 3);
        double[] zeros = new double[50];
        zeros[7] = -0.0;
        double[] broken = moving.clone();
        broken[20] = Double.NaN;
        double[] unbounded = moving.clone();
        unbounded[49] = Double.NEGATIVE_INFINITY;
        requireNothing(Status.CONSTANT, still, still);
        requireNothing(Status.CONSTANT, moving, still);
        requireNothing(Status.CONSTANT, still, moving);
        requireNothing(Status.CONSTANT, still);
        requireNothing(Status.CONSTANT, moving, zeros);
        requireNothing(Status.NON_FINITE, moving, broken);
        requireNothing(Status.NON_FINITE, unbounded, still);
        requireNothing(Status.TOO_SHORT, new double[] {1, 2, 3}, new double[] {1, 2, 3});
        requireNothing(Status.TOO_SHORT, new double[] {});
    }

    private static void requireNothing(Status status, double[]... chains) {
        ChainDiagnostics d = ChainDiagnostics.of(chains);
        assertEquals(status, d.status());
        for (double v : new double[] {d.rHat(), d.rHatBulk(), d.rHatFolded(), d.essBulk(), d.essTail(), d.essMean(),
            d.essSd(), d.essSquaredDeviation(), d.mcseMean(), d.mcseSd(), d.essQuantile(0.5), d.mcseQuantile(0.5)}) {
            assertTrue(Double.isNaN(v));
        }
        assertEquals(Convergence.NOT_CONVERGED, d.convergence());
    }

    @Test
    void meanOfConstantChainsIsStillKnown() {
        ChainDiagnostics d = ChainDiagnostics.of(new double[][] {{2, 2, 2, 2}, {4, 4, 4, 4}});
        assertEquals(3, d.mean(), 0);
        assertEquals(Math.sqrt(8.0 / 7), d.std(), 1e-15);
        assertEquals(3, d.quantile(0.5), 0);
        assertEquals(2, d.chainCount());
        assertEquals(4, d.drawsPerChain());
    }

    @Test
    void halvesThatStandStillApartHaveInfiniteRHat() {
        double[] step = new double[40];
        for (int i = 0; i < 40; i++) {
            step[i] = i < 20 ? 1 : 2;
        }
        ChainDiagnostics d = ChainDiagnostics.of(new double[][] {step});
        assertEquals(Double.POSITIVE_INFINITY, d.rHatBulk(), 0);
        assertEquals(Convergence.NOT_CONVERGED, d.convergence());
    }

    @Test
    void tiesThatFillTheUpperTailLeaveNoTailSize() {
        double[][] d = autoregression(4, 100, 0, 15);
        ChainDiagnostics clipped = ChainDiagnostics.of(map(d, x -> Math.min(x, 0.5)));
        assertTrue(Double.isNaN(clipped.essTail()));
        assertTrue(clipped.essBulk() > 100);
        assertEquals(Convergence.NOT_CONVERGED, clipped.convergence());
    }

    @Test
    void sizesBeginAtTwelveDrawsPerChain() {
        assertTrue(Double.isNaN(ChainDiagnostics.of(autoregression(4, 11, 0, 17)).essMean()));
        double size = ChainDiagnostics.of(autoregression(4, 12, 0, 17)).essMean();
        assertTrue(size > 1 && size <= 48 * Math.log10(48), "size " + size);
    }

    @Test
    void laterChangesOfTheCallersArrayDoNotReachTheResult() {
        double[][] d = autoregression(2, 100, 0, 16);
        ChainDiagnostics a = ChainDiagnostics.of(d);
        double before = a.essQuantile(0.3);
        Arrays.fill(d[0], 0);
        assertEquals(before, a.essQuantile(0.3), 0);
    }

    @Test
    void wrongInputIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> ChainDiagnostics.of(new double[0][]));
        assertThrows(IllegalArgumentException.class,
                () -> ChainDiagnostics.of(new double[][] {{1, 2, 3, 4}, {1, 2, 3}}));
        ChainDiagnostics d = ChainDiagnostics.of(new double[][] {{1, 2, 3, 4}});
        for (double p : new double[] {0, 1, -0.1, 1.1, Double.NaN}) {
            assertThrows(IllegalArgumentException.class, () -> d.quantile(p));
            assertThrows(IllegalArgumentException.class, () -> d.mcseQuantile(p));
        }
    }

    @ParameterizedTest
    @CsvSource({"1.009, 400, 400, CONVERGED", "1.01, 5000, 5000, DOUBTFUL", "1.0, 399.9, 5000, DOUBTFUL",
        "1.0, 5000, 399.9, DOUBTFUL", "1.05, 5000, 5000, DOUBTFUL", "1.0501, 5000, 5000, NOT_CONVERGED",
        "NaN, 5000, 5000, NOT_CONVERGED", "1.0, NaN, 5000, NOT_CONVERGED", "1.0, 5000, NaN, NOT_CONVERGED",
        "Infinity, 5000, 5000, NOT_CONVERGED", "0.999, 5000, 5000, CONVERGED"})
    void verdictFollowsTheThresholds(double rHat, double bulk, double tail, Convergence expected) {
        assertEquals(expected, Convergence.of(rHat, bulk, tail));
    }

    @Test
    void worstParameterDecides() {
        assertEquals(Convergence.DOUBTFUL, Convergence.CONVERGED.worse(Convergence.DOUBTFUL));
        assertEquals(Convergence.NOT_CONVERGED, Convergence.NOT_CONVERGED.worse(Convergence.CONVERGED));
    }

    private static double[][] autoregression(int chains, int draws, double rho, long seed) {
        RandomGenerator random = new Well19937c(seed);
        double[][] out = new double[chains][draws];
        for (double[] chain : out) {
            double x = random.nextGaussian();
            for (int i = 0; i < draws; i++) {
                chain[i] = x;
                x = rho * x + Math.sqrt(1 - rho * rho) * random.nextGaussian();
            }
        }
        return out;
    }

    private static double[][] map(double[][] draws, DoubleUnaryOperator f) {
        double[][] out = new double[draws.length][];
        for (int c = 0; c < draws.length; c++) {
            out[c] = Arrays.stream(draws[c]).map(f).toArray();
        }
        return out;
    }

    private static double[][] draws(String name) throws IOException {
        List<String> lines = lines("draws-" + name + ".csv");
        int chains = lines.get(0).split(",").length;
        double[][] out = new double[chains][lines.size()];
        for (int i = 0; i < lines.size(); i++) {
            String[] cells = lines.get(i).split(",");
            for (int c = 0; c < chains; c++) {
                out[c][i] = Double.parseDouble(cells[c]);
            }
        }
        return out;
    }

    private static Map<String, Double> reference(String name) throws IOException {
        Map<String, Double> out = new LinkedHashMap<>();
        for (String line : lines("reference.csv")) {
            String[] cells = line.split(",");
            if (cells[0].equals(name)) {
                out.put(cells[1], Double.parseDouble(cells[2]));
            }
        }
        return out;
    }

    private static List<String> lines(String file) throws IOException {
        try (InputStream in = ChainDiagnosticsTest.class.getResourceAsStream(file);
                BufferedReader reader = new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8))) {
            List<String> out = new ArrayList<>();
            for (String line = reader.readLine(); line != null; line = reader.readLine()) {
                out.add(line);
            }
            return out;
        }
    }
}
