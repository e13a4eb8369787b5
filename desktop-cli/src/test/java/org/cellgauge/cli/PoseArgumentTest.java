package org.cellgauge.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine.TypeConversionException;

class PoseArgumentTest {
    @Test
    void anglesAreDegreesUnlessTheySayRadians() {
        assertArrayEquals(new double[] {Math.PI / 2, 0.25, -Math.PI / 6},
                PoseArgument.parse("1,-2,3e2, 90, 0.25rad, -30").pose().eulerRad(), 1e-12);
        assertArrayEquals(new double[] {1, -2, 300}, PoseArgument.parse("1,-2,3e2,90,0,0").pose().translationMm());
    }

    @Test
    void anglesLeftOutAreZero() {
        assertArrayEquals(new double[3], PoseArgument.parse("1,2,3").pose().eulerRad());
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "1,2", "1,2,3,4", "1,2,3,4,5,6,7", "1,2,x", "1,2,NaN", "1,2,3,Infinity,0,0", "1;2;3",
        "1rad,2,3"})
    void anythingElseIsRefusedWithTheForm(String text) {
        Exception e = assertThrows(TypeConversionException.class, () -> PoseArgument.parse(text));
        assertTrue(e.getMessage().contains("X,Y,Z[,PSI,THETA,PHI]"), e.getMessage());
    }
}
