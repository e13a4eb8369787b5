package org.cellgauge.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.cellgauge.calibration.CalibrationRefusal;
import org.cellgauge.calibration.CalibrationWarning;
import org.cellgauge.cell.CellRefusal;
import org.cellgauge.cell.TargetRefusal;
import org.cellgauge.desktop.BatchRefusal;
import org.cellgauge.desktop.BatchWarning;
import org.cellgauge.desktop.FolderRefusal;
import org.cellgauge.desktop.ImageRefusal;
import org.cellgauge.desktop.MachineRefusal;
import org.cellgauge.output.ResultRefusal;
import org.cellgauge.survey.SurveyRefusal;
import org.cellgauge.survey.SurveyWarning;
import org.cellgauge.vision.DetectionWarning;
import org.cellgauge.vision.DetectionsRefusal;
import org.cellgauge.warning.CheckRefusal;
import org.cellgauge.warning.CheckWarning;
import org.cellgauge.warning.MessageKind;
import org.junit.jupiter.api.Test;

/** Programs know warnings and refusals by their codes. */
class CodesTest {
    private static final List<MessageKind[]> KINDS = List.of(CheckWarning.values(), DetectionWarning.values(),
            BatchWarning.values(), CheckRefusal.values(), CellRefusal.values(), DetectionsRefusal.values(),
            ImageRefusal.values(), FolderRefusal.values(), ResultRefusal.values(), BatchRefusal.values(),
            MachineRefusal.values(), CalibrationWarning.values(), CalibrationRefusal.values(), TargetRefusal.values(),
            SurveyWarning.values(), SurveyRefusal.values());

    @Test
    void noTwoMessagesShareACode() {
        Map<String, MessageKind> kinds = new HashMap<>();
        for (MessageKind[] all : KINDS) {
            for (MessageKind kind : all) {
                assertTrue(kind.code().matches("[a-z0-9]+(-[a-z0-9]+)*"), kind.code());
                MessageKind other = kinds.put(kind.code(), kind);
                assertTrue(other == null, kind.code() + " is " + kind + " and " + other);
            }
        }
    }

    /** The list holds what was ever told: a code that is renamed or taken away breaks someone's script. */
    @Test
    void codesThatAreToldStayAsTheyAre() throws IOException {
        Set<String> now = new HashSet<>();
        for (MessageKind[] all : KINDS) {
            for (MessageKind kind : all) {
                now.add(kind.code());
            }
        }
        Matcher told = Pattern.compile("(?m)^- `([a-z0-9-]+)`").matcher(
                Files.readString(Path.of(System.getProperty("cellgauge.root", ".."), "docs", "codes.md")));
        Set<String> inDocs = new HashSet<>();
        while (told.find()) {
            inDocs.add(told.group(1));
        }
        Set<String> gone = new HashSet<>(inDocs);
        gone.removeAll(now);
        assertEquals(Set.of(), gone);
        // and a new one is told
        now.removeAll(inDocs);
        assertEquals(Set.of(), now);
    }

    /** What docs/troubleshooting.md quotes in its first column is said by some message. */
    @Test
    void whatTroubleshootingQuotesIsSaid() throws IOException {
        List<String> patterns = new ArrayList<>();
        KINDS.forEach(kinds -> Arrays.stream(kinds).forEach(kind -> patterns.add(kind.english())));
        Matcher quoted = Pattern.compile("\"([^\"|]+)\"").matcher("");
        int count = 0;
        for (String line : Files.readAllLines(Path.of(System.getProperty("cellgauge.root", ".."), "docs",
                "troubleshooting.md"))) {
            quoted.reset(line.startsWith("| \"") ? line.substring(0, line.indexOf(" | ", 2)) : "");
            while (quoted.find()) {
                assertTrue(patterns.stream().anyMatch(p -> p.contains(quoted.group(1))), quoted.group(1));
                count++;
            }
        }
        assertTrue(count > 40, count + " quotations");
    }
}
