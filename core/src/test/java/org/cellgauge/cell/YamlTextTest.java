package org.cellgauge.cell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.cellgauge.internal.cell.CellPhrase;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Texts that a YAML parser stumbles over are read, or refused with file and line. */
class YamlTextTest {
    private static YamlMapping parsed(String text) {
        return YamlValue.parse(text, "cell.yaml", CellPhrase.CELL_FILE, 1 << 20).mapping("a: b");
    }

    /** The parser reads 1024 characters at a time: a character of two halves stands in every position around that. */
    @Test
    void charactersOutsideOfTheBasicPlaneMayStandAnywhere() {
        for (int before = 1015; before < 1030; before++) {
            String text = "#" + "x".repeat(before) + "\ud83d\ude00\nkey: \"\ud83d\ude00\"\n";
            assertEquals("\ud83d\ude00", parsed(text).optional("key").text("a text"), before + " characters before");
        }
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "'a: \"\\u' | 1",
        "'a: 1~b: \"\\UDDDDDDDD\"' | 2",
        "'a: 1~~!%20 x: 1' | 3",
        "'a: \"\\xG0\"' | 1",
        "'!<%20> b' | 1"})
    void escapesAndTagsThatAreNoneAreRefusedWithTheirLine(String text, int line) {
        InputRefusedException refused = assertThrows(InputRefusedException.class,
                () -> parsed(text.replace('~', '\n')));
        assertTrue(refused.getMessage().startsWith("cell.yaml, line " + line + ", "), refused.getMessage());
    }
}
