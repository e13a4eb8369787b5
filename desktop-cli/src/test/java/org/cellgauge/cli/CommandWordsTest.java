package org.cellgauge.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.cellgauge.cell.CellReader;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.internal.validation.ValidationRefusal;
import org.cellgauge.internal.warning.CheckPhrase;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.warning.CheckRefusal;
import org.cellgauge.warning.CheckWarning;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;
import org.cellgauge.warning.Warning;
import org.junit.jupiter.api.Test;

/** Remedies that are options are said as options. */
class CommandWordsTest {
    private static final Pattern OPTION = Pattern.compile("--[a-z-]+");

    @Test
    void everyPatternFitsItsKindAndNamesAnOptionThatThereIs() {
        Set<String> options = new HashSet<>();
        Main.commandLine().getSubcommands().values()
                .forEach(command -> command.getCommandSpec().optionsMap().keySet().forEach(options::add));
        CommandWords.PATTERNS.forEach((kind, pattern) -> {
            assertEquals(kind.english().split("%s", -1).length, pattern.split("%s", -1).length, pattern);
            Matcher named = OPTION.matcher(pattern);
            assertTrue(named.find(), pattern);
            do {
                assertTrue(options.contains(named.group()), named.group());
            } while (named.find());
        });
    }

    @Test
    void warningsNameTheOption() {
        assertEquals("the chains reached their cap of 4000 iterations before the precision asked for: the standard "
                + "deviation of camera_x has a Monte Carlo error of 1.7 % in place of 0.1 %; allow more with "
                + "--max-iterations", CommandWords.of(Warning.of(CheckWarning.CAP_REACHED, Decimal.of(4000, 0),
                        "camera_x", Decimal.of(1.66, 1), Decimal.shortest(0.1), CheckPhrase.MORE_ITERATIONS)));
    }

    @Test
    void refusalsNameTheOption() {
        assertEquals("a.png: the chains cannot start, the density is NaN at the start of the chain; check the "
                + "references' positions in the cell file or use --initial pnp",
                CommandWords.of(Refusal.at(Place.of("a.png"), CheckRefusal.CHAINS_CANNOT_START,
                        Warning.of(CheckPhrase.DENSITY_AT_START, "NaN"), CheckPhrase.INITIAL_PNP)));
        assertEquals("object 5 is not seen from the camera pose: some corner is outside the image or it shows its "
                + "back; give another --camera-pose or --object pose",
                CommandWords.of(Refusal.of(ValidationRefusal.NOT_SEEN, Refusal.of(ValidationRefusal.OBJECT, 5),
                        ValidationRefusal.OTHER_POSES)));
        InputRefusedException refused = assertThrows(InputRefusedException.class,
                () -> CellReader.statedCamera("{image: {}, markers: []}", "d.json"));
        assertEquals("d.json, line 1: this is a detections file; name a cell file, and this one after --detections",
                CommandWords.of(refused));
    }
}
