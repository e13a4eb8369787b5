package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.apache.commons.math3.distribution.NormalDistribution;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class EdgeProfileTest {
    /** Against the blurred step averaged over a fine grid of the pixel's square, and against differences. */
    @ParameterizedTest
    @CsvSource({"0.7, 0.3, 0.5", "0.7, -0.9, 0.2", "0.1, 0.2, 0.8", "1.2, 1.5, 0.01", "2.0, -1, 1.5707"})
    void shareIsTheBlurredStepAveragedOverThePixel(double blur, double distance, double angle) {
        double nx = Math.cos(angle);
        double ny = Math.sin(angle);
        NormalDistribution step = new NormalDistribution(null, 0, blur);
        int n = 400;
        double sum = 0;
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                sum += step.cumulativeProbability(distance + nx * ((i + 0.5) / n - 0.5) + ny * ((j + 0.5) / n - 0.5));
            }
        }
        EdgeProfile profile = new EdgeProfile();
        profile.turn(nx, ny);
        profile.at(distance, blur);
        // directions along the grid are taken as if they were 0.05 off, which widens the profile by that square / 24
        assertEquals(sum / n / n, profile.share, 2e-4);

        double byDistance = profile.byDistance;
        double byBlur = profile.byBlur;
        double h = 1e-2;
        profile.at(distance + h, blur);
        double right = profile.share;
        profile.at(distance - h, blur);
        assertEquals((right - profile.share) / (2 * h), byDistance, 2e-2);
        profile.at(distance, blur + h);
        right = profile.share;
        profile.at(distance, blur - h);
        assertEquals((right - profile.share) / (2 * h), byBlur, 2e-2);
    }
}
