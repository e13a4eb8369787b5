package org.cellgauge.light;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ToneCurveTest {
    /** Grey 118, 188 and 10 of 255, by the formula of IEC 61966-2-1 (tables of any colour handbook have them). */
    @Test
    void srgbIsTheStandards() {
        assertEquals(0.1812, ToneCurve.SRGB.light(118 / 255.0), 1e-4);
        assertEquals(0.5029, ToneCurve.SRGB.light(188 / 255.0), 1e-4);
        assertEquals(0.003035, ToneCurve.SRGB.light(10 / 255.0), 1e-6);
    }

    @ParameterizedTest
    @ValueSource(strings = {"linear", "srgb", "gamma 1.8", "gamma 2.2", "srgb 2.1"})
    void lightAndGreyUndoEachOther(String words) {
        ToneCurve curve = ToneCurve.of(words);
        assertEquals(words, curve.words());
        for (double light = 0; light <= 1; light += 1 / 64.0) {
            assertEquals(light, curve.light(curve.grey(light)), 1e-6);
        }
        assertEquals(1, curve.grey(1), 1e-12);
        assertEquals(0, curve.grey(-1));
    }

    @Test
    void halfTheGreyIsAFifthOfTheLight() {
        assertEquals(0.2176, ToneCurve.gamma(2.2).light(0.5), 1e-4);
    }

    @ParameterizedTest
    @ValueSource(strings = {"linear", "srgb", "gamma 2.2", "srgb 1.7"})
    void derivativeByThePowerIsTheDifference(String words) {
        ToneCurve curve = ToneCurve.of(words);
        double dark = 0.2;
        double bright = 0.9;
        double h = 1e-5;
        for (double share = 0.01; share < 1; share += 0.14) {
            double[] grey = new double[2];
            for (int k = 0; k < 2; k++) {
                ToneCurve other = curve.withPower(curve.power() + (2 * k - 1) * h);
                grey[k] = other.grey(other.light(dark) + (other.light(bright) - other.light(dark)) * share);
            }
            assertEquals((grey[1] - grey[0]) / (2 * h), curve.greyByPower(dark, bright, share), 1e-6);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"linear", "srgb", "gamma 2.2", "srgb 1.7"})
    void derivativeOfTheLightIsTheDifference(String words) {
        ToneCurve curve = ToneCurve.of(words);
        double h = 1e-6;
        for (double grey = 0.01; grey < 1.2; grey += 0.01) {
            assertEquals((curve.light(grey + h) - curve.light(grey - h)) / (2 * h),
                    curve.lightByGrey(grey, curve.light(grey)), 1e-6, words + " " + grey);
        }
        assertEquals(0, curve.lightByGrey(-0.1, 0));
    }

    @Test
    void onlySrgbHasAToe() {
        assertTrue(ToneCurve.SRGB.isToe(0.04));
        assertFalse(ToneCurve.SRGB.isToe(0.05));
        assertFalse(ToneCurve.gamma(2.2).isToe(0.01));
    }

    @Test
    void gammaOneIsLinear() {
        assertSame(ToneCurve.LINEAR, ToneCurve.of("gamma 1"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "gamma", "gamma x", "gamma 0", "gamma 9", "gamma NaN", "rec709"})
    void otherWordsAreRefused(String words) {
        assertThrows(IllegalArgumentException.class, () -> ToneCurve.of(words));
    }
}
