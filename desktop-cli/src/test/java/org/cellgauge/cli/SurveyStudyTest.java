package org.cellgauge.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** Coverage of surveys from rendered photos, detection included. */
class SurveyStudyTest {
    private static final String CELL = Path.of(System.getProperty("cellgauge.root", "."), "fixtures", "lifted-4",
            "cell.yaml").toString();

    /** Four cells, twelve objects: were deviations half or twice what they are, the mean square would be 24 or 1.5. */
    @Test
    void whatPhotosSayIsAsPreciseAsStated() {
        CommandCall run = CommandCall.of("validate", "--cell", CELL, "--photos", "--photos-per-cell", "3",
                "--simulations", "4", "--tone-curve", "srgb", "--json");
        assertEquals(ExitCodes.OK, run.code(), run.err());
        JsonObject json = JsonParser.parseString(run.out()).getAsJsonObject();
        assertEquals(0, json.get("refused").getAsInt());
        JsonObject objects = json.getAsJsonObject("objects");
        assertEquals(12, objects.get("regions").getAsInt());
        double square = objects.get("mean_square").getAsDouble();
        assertTrue(square > 2.5 && square < 12, "mean square " + square);
        CommandCall drawn = CommandCall.of("validate", "--cell", CELL, "--photos-per-cell", "3", "--simulations", "4",
                "--pixel-std", "0.3", "--json");
        assertTrue(!drawn.out().equals(run.out()), "corners of photos are not drawn ones");
    }

    @Test
    void photosThatCannotBeReadLeaveNothingToSurvey() {
        CommandCall run = CommandCall.of("survey", "--cell", CELL, "no-such-photo.png");
        assertEquals(ExitCodes.INPUT_REFUSED, run.code());
        assertTrue(run.err().contains("no-such-photo.png: there is no such file"), run.err());
        assertTrue(!run.err().contains("none of 0"), run.err());
    }
}
