package org.cellgauge.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** {@code cellgauge plan} as users call it. */
class PlanCommandTest {
    private static final String CELL = "cellgauge: 1\n"
            + "camera: {model: pinhole, pinhole: {fx: 581, fy: 581, cx: 640, cy: 360, width: 1280, height: 720}}\n"
            + "markers: {family: square-binary, size_mm: 47}\n"
            + "placement: {std_mm: [1, 1, 1], std_deg: 0.2}\n"
            + "pixel_std_px: 0.1\n"
            + "references:\n"
            + "  944:  {position_mm: [492, 380, 0], rotation_deg: [0, 0, 0]}\n"
            + "  1234: {position_mm: [0, 380, 0], rotation_deg: [0, 0, 0]}\n"
            + "  911:  {position_mm: [492, 0, 0], rotation_deg: [0, 0, 0]}\n"
            + "objects:\n"
            + "  5: {}\n";

    @TempDir
    private Path folder;
    private String out;
    private String err;

    private int plan(String... more) throws IOException {
        Path cell = Files.writeString(folder.resolve("cell.yaml"), CELL);
        List<String> args = new ArrayList<>(List.of("--cell", cell.toString(), "--camera-pose",
                "418,106,1070,3.08rad,0.10rad,0.02rad"));
        args.addAll(List.of(more));
        StringWriter outText = new StringWriter();
        StringWriter errText = new StringWriter();
        int code = new CommandLine(new PlanCommand()).setOut(new PrintWriter(outText))
                .setErr(new PrintWriter(errText)).execute(args.toArray(new String[0]));
        out = outText.toString();
        err = errText.toString();
        return code;
    }

    private static double worst(JsonElement forecast) {
        return forecast.getAsJsonObject().get("worst_std_mm").getAsDouble();
    }

    @Test
    void whatIsProposedMeetsTheTargetWhenItIsPlannedAnew() throws IOException {
        assertEquals(ExitCodes.TARGET_MISSED, plan("--object", "5=240,200,0", "--target-std-mm", "3", "--json"));
        JsonObject plan = JsonParser.parseString(out).getAsJsonObject();
        assertEquals("fail", plan.get("verdict").getAsString());
        assertTrue(worst(plan.get("now")) > 3, out);
        assertTrue(plan.getAsJsonArray("proposals").size() > 0, out);
        double before = 0;
        for (JsonElement proposal : plan.getAsJsonArray("proposals")) {
            JsonObject p = proposal.getAsJsonObject();
            assertTrue(p.get("meets_target").getAsBoolean(), p.toString());
            assertTrue(worst(p.get("forecast")) <= 3);
            assertTrue(p.get("cost").getAsDouble() >= before, "cheapest first");
            before = p.get("cost").getAsDouble();
        }
        // along the front less costs more
        double cost = -1;
        double reached = Double.POSITIVE_INFINITY;
        for (JsonElement point : plan.getAsJsonArray("front")) {
            assertTrue(point.getAsJsonObject().get("cost").getAsDouble() > cost);
            assertTrue(worst(point.getAsJsonObject().get("forecast")) < reached);
            cost = point.getAsJsonObject().get("cost").getAsDouble();
            reached = worst(point.getAsJsonObject().get("forecast"));
        }
        for (JsonElement certificate : plan.getAsJsonArray("certificates")) {
            JsonObject c = certificate.getAsJsonObject();
            assertTrue(c.get("bound_ratio").getAsDouble() <= c.get("found_ratio").getAsDouble() * (1 + 1e-9));
        }
        // a cost that is raised beyond the others puts its change behind them
        String cheapest = plan.getAsJsonArray("proposals").get(0).getAsJsonObject().getAsJsonArray("changes").get(0)
                .getAsJsonObject().get("code").getAsString();
        plan("--object", "5=240,200,0", "--target-std-mm", "3", "--json", "--cost", cheapest + "=100000");
        String other = JsonParser.parseString(out).getAsJsonObject().getAsJsonArray("proposals").get(0)
                .getAsJsonObject().getAsJsonArray("changes").toString();
        assertTrue(!other.contains('"' + cheapest + '"'), other);
    }

    @Test
    void anObjectThatMayLieAnywhereIsJudgedWhereItIsWorst() throws IOException {
        assertEquals(ExitCodes.OK, plan("--target-std-mm", "100", "--json"));
        double anywhere = worst(JsonParser.parseString(out).getAsJsonObject().get("now"));
        plan("--object", "5=0,0,0", "--json");
        double corner = worst(JsonParser.parseString(out).getAsJsonObject().get("now"));
        plan("--object", "5=246,190,0", "--json");
        double middle = worst(JsonParser.parseString(out).getAsJsonObject().get("now"));
        assertTrue(anywhere >= corner && corner > middle, anywhere + " " + corner + " " + middle);
    }

    @Test
    void whatNoReferenceCanMendIsSaid() throws IOException {
        assertEquals(ExitCodes.TARGET_MISSED, plan("--object", "5=240,200,0", "--target-std-mm", "0.5"));
        assertTrue(out.contains("No reference can mend that"), out);
        assertTrue(out.contains("What does not help:"), out);
        assertEquals("", err);
    }

    @Test
    void faultyOptionsAreRefused() throws IOException {
        assertEquals(ExitCodes.USAGE, plan("--cost", "raise=3"));
        assertTrue(err.contains("raise-reference=20"), err);
        assertEquals(ExitCodes.USAGE, plan("--free", "1,2,3"));
        assertEquals(ExitCodes.USAGE, plan("--target-std-mm", "-1"));
        assertEquals(ExitCodes.USAGE, plan("--blur-px", "0"));
        assertEquals(ExitCodes.USAGE, plan("--object", "6=1,2,3"));
        assertEquals(ExitCodes.INPUT_REFUSED, plan("--photo-like", folder.resolve("none.json").toString()));
        assertTrue(err.contains("none.json"), err);
    }
}
