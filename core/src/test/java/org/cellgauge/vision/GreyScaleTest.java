package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import org.apache.commons.math3.distribution.NormalDistribution;
import org.cellgauge.light.ToneCurve;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class GreyScaleTest {
    private static GreyScale scale(String words, double noise) {
        GreyScale scale = new GreyScale();
        scale.set(ToneCurve.of(words));
        scale.setNoise(noise);
        return scale;
    }

    /** Expectation of min(255, max(0, grey + noise)) by the midpoint rule over the noise. */
    @ParameterizedTest
    @CsvSource({"linear, 2", "linear, 6", "srgb, 2", "gamma 2.2, 4"})
    void greyIsTheExpectationOfWhatTheSensorCutsOff(String words, double noise) {
        GreyScale scale = scale(words, noise);
        ToneCurve curve = ToneCurve.of(words);
        NormalDistribution normal = new NormalDistribution(null, 0, noise);
        double h = noise / 100;
        for (double light : new double[] {0.0005, 0.004, 0.02, 0.3, 0.97, 0.995, 1, 1.01, 1.04, 1.3}) {
            double level = 255 * curve.grey(light);
            double expected = 0;
            for (double e = -8 * noise + h / 2; e < 8 * noise; e += h) {
                expected += h * normal.density(e) * Math.min(255, Math.max(0, level + e));
            }
            scale.at(light);
            // beyond three deviations nothing is taken to be cut off, which leaves 0.0004 of the deviation; the table
            // of the curve is linear between its nodes, and near black a power is not
            double table = light < 0.01 && !curve.isLinear() ? 0.1 : 0.01;
            assertEquals(expected, scale.grey, 4e-4 * noise + table, words + " at light " + light);
        }
    }

    @ParameterizedTest
    @CsvSource({"linear, 2", "srgb, 2", "gamma 2.2, 4", "gamma 1.8, 1"})
    void derivativeByLightIsTheDifference(String words, double noise) {
        GreyScale scale = scale(words, noise);
        for (double light : new double[] {0.05, 0.2, 0.5, 0.9, 0.99, 1, 1.02}) {
            double h = 0.001;
            scale.at(light + h);
            double above = scale.grey;
            scale.at(light - h);
            double difference = (above - scale.grey) / (2 * h);
            scale.at(light);
            // the table's slope is that over two nodes, the difference one between them: a hundredth at the ends
            assertEquals(difference, scale.byLight, 0.02 * Math.abs(difference) + 3, words + " at light " + light);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"linear", "srgb", "gamma 2.2", "srgb 1.7"})
    void lightIsTheCurves(String words) {
        GreyScale scale = scale(words, 1);
        ToneCurve curve = ToneCurve.of(words);
        for (int level = 1; level <= 255; level++) {
            assertEquals(curve.light(level / 255.0), scale.light(level), 1e-12);
            assertEquals(curve.light(level / 255.0), scale.tabulatedLight(level), 1e-12);
            double h = 1e-4;
            assertEquals((curve.light((level + h) / 255) - curve.light((level - h) / 255)) / (2 * h),
                    scale.lightByGrey(level), 1e-5);
        }
    }

    /** Within the scale, over its ends, and without light; curve and noise are those that were set last. */
    @ParameterizedTest
    @ValueSource(strings = {"linear", "srgb", "gamma 2.2"})
    void manyAtOnceAreEachAsAlone(String words) {
        GreyScale first = new GreyScale();
        GreyScale scale = first.another();
        first.set(ToneCurve.of(words));
        first.setNoise(4);
        double[] lights = {-0.2, 0, 1e-8, 1e-7, 1e-4, 0.01, 0.3, 0.97, 1, 1.2, 2.9, 3.5};
        int n = lights.length;
        double[] floors = new double[n];
        double[] caps = new double[n];
        Arrays.fill(caps, 255);
        floors[6] = 200;
        caps[5] = 3;
        double[] greys = new double[n];
        double[] byLights = new double[n];
        double[] insides = new double[n];
        scale.at(lights, floors, caps, n, greys, byLights, insides);
        for (int i = 0; i < n; i++) {
            first.at(lights[i], floors[i], caps[i]);
            assertEquals(first.grey, greys[i], "at " + lights[i]);
            assertEquals(first.byLight, byLights[i], "at " + lights[i]);
            assertEquals(first.inside, insides[i], "at " + lights[i]);
        }
    }

    /** The same derivative as the tone curve's own, with the greys of black and white held. */
    @Test
    void derivativeByThePowerIsTheDifference() {
        double dark = 30;
        double bright = 220;
        for (String kind : new String[] {"gamma ", "srgb "}) {
            GreyScale scale = scale(kind + 2.1, 1);
            scale.setEnds(dark, bright);
            for (double share : new double[] {0.05, 0.3, 0.5, 0.8}) {
                double h = 1e-4;
                double difference = (between(kind + (2.1 + h), dark, bright, share)
                        - between(kind + (2.1 - h), dark, bright, share)) / (2 * h);
                assertEquals(difference, scale.byPower(share), 1e-3, kind + share);
            }
        }
    }

    /** Also where the table is too coarse, within a toe, and beyond white. */
    @ParameterizedTest
    @CsvSource({"linear, 30, 220", "gamma 2.2, 30, 220", "gamma 2.2, 1, 90", "srgb, 4, 250", "srgb 1.3, 8, 300"})
    void derivativesByThePowerAreEachAsAlone(String words, double dark, double bright) {
        GreyScale scale = scale(words, 1);
        scale.setEnds(dark, bright);
        double[] shares = new double[1101];
        for (int i = 0; i < shares.length; i++) {
            shares[i] = i / 1000.0 - 0.05;
        }
        double[] byPower = new double[shares.length];
        scale.byPower(shares, shares.length, byPower);
        for (int i = 0; i < shares.length; i++) {
            double expected = scale.byPower(shares[i]);
            assertEquals(expected, byPower[i], 1e-4 + 1e-9 * Math.abs(expected), words + " " + shares[i]);
        }
    }

    private static double between(String words, double dark, double bright, double share) {
        ToneCurve curve = ToneCurve.of(words);
        double light = curve.light(dark / 255);
        return 255 * curve.grey(light + share * (curve.light(bright / 255) - light));
    }
}
