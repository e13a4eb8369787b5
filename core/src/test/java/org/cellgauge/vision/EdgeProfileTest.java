package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.apache.commons.math3.distribution.NormalDistribution;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class EdgeProfileTest {
    /** Against the blurred step averaged over a fine grid of the pixel's square, and against differences. */
    @ParameterizedTest
    @CsvSource({
        // the exact formula
        "0.1, 0.2, 0.8", "0.3, 0.6, 0.4", "0.49, -0.4, 1.1",
        // the series, from its least blur on, along the grid, across it and between
        "0.5, 0, 0.7854", "0.5, 0.4, 0", "0.5, 0.9, 0.3", "0.5, -1.4, 0.7854", "0.6, 0.7, 1.5707", "0.7, 0.3, 0.5",
        "0.7, -0.9, 0.2", "1.2, 1.5, 0.01", "2.0, -1, 1.5707"})
    void shareIsTheBlurredStepAveragedOverThePixel(double blur, double distance, double angle) {
        double nx = Math.cos(angle);
        double ny = Math.sin(angle);
        EdgeProfile profile = new EdgeProfile();
        profile.turn(nx, ny);
        profile.at(distance, blur);
        double byDistance = profile.byDistance;
        double byBlur = profile.byBlur;
        // directions along the grid are taken as if they were 0.05 off: that adds 0.05 squared / 12 to the variance of
        // the profile, which moves the share by at most 0.24 / 2 of that over the squared width
        boolean alongGrid = Math.min(Math.abs(nx), Math.abs(ny)) < 0.05;
        double widened = alongGrid ? 0.12 * 0.05 * 0.05 / 12 / (blur * blur + 1.0 / 12) : 0;
        assertEquals(average(blur, distance, nx, ny), profile.share, 1e-4 + widened);
        double h = 1e-3;
        // the differences of averages: 1e-4 of the widest slope is what the series may leave in them, too
        assertEquals((average(blur, distance + h, nx, ny) - average(blur, distance - h, nx, ny)) / (2 * h), byDistance,
                1e-3);
        assertEquals((average(blur + h, distance, nx, ny) - average(blur - h, distance, nx, ny)) / (2 * h), byBlur,
                1e-3);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.3, 0.5, 0.9, 2.5})
    void manyAtOnceAreEachAsAlone(double blur) {
        EdgeProfile profile = new EdgeProfile();
        profile.turn(0.6, 0.8);
        int n = 301;
        double[] distances = new double[n];
        for (int i = 0; i < n; i++) {
            distances[i] = 0.1 * (i - n / 2);
        }
        double[] shares = new double[n];
        double[] byDistances = new double[n];
        double[] byBlurs = new double[n];
        profile.at(distances, n, blur, shares, byDistances, byBlurs);
        for (int i = 0; i < n; i++) {
            profile.at(distances[i], blur);
            assertEquals(profile.share, shares[i]);
            // zero has no sign here
            assertEquals(profile.byDistance + 0.0, byDistances[i] + 0.0);
            assertEquals(profile.byBlur + 0.0, byBlurs[i] + 0.0);
        }
    }

    /** The blurred step averaged over the pixel's square by Simpson's rule in both directions. */
    private static double average(double blur, double distance, double nx, double ny) {
        NormalDistribution step = new NormalDistribution(null, 0, blur);
        int n = 100;
        double sum = 0;
        for (int i = 0; i <= n; i++) {
            for (int j = 0; j <= n; j++) {
                sum += simpson(i, n) * simpson(j, n) * step.cumulativeProbability(distance
                        + nx * ((double) i / n - 0.5) + ny * ((double) j / n - 0.5));
            }
        }
        return sum;
    }

    private static double simpson(int i, int n) {
        return (i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2) / (3.0 * n);
    }
}
