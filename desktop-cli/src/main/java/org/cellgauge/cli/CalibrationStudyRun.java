package org.cellgauge.cli;

import com.google.gson.Gson;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntConsumer;
import org.cellgauge.desktop.CheckText;
import org.cellgauge.desktop.TextTable;
import org.cellgauge.internal.calibration.CalibrationStudy;
import picocli.CommandLine;

/** {@code cellgauge validate --calibration}: are deviations of calibrations right? */
final class CalibrationStudyRun {
    /** Errors are this far from their deviations at most, for the scenes whose model is right. */
    private static final double LEAST = 0.9;
    private static final double MOST = 1.1;
    private static final List<CalibrationStudy.Scene> JUDGED = List.of(CalibrationStudy.Scene.GOOD,
            CalibrationStudy.Scene.POOR, CalibrationStudy.Scene.BENT);

    private CalibrationStudyRun() {
    }

    /**
     * Runs all scenes and prints one table.
     *
     * @return the exit code
     */
    static int run(CommandLine command, double noisePx, int simulations, long seed, boolean json,
            IntConsumer progress) {
        CalibrationStudy study = new CalibrationStudy(noisePx, seed);
        List<CalibrationStudy.Outcome> outcomes = new ArrayList<>();
        boolean right = true;
        for (CalibrationStudy.Scene scene : CalibrationStudy.Scene.values()) {
            CalibrationStudy.Outcome outcome = study.run(scene, simulations, progress);
            outcomes.add(outcome);
            if (JUDGED.contains(scene)) {
                List<Double> all = new ArrayList<>(outcome.ratios());
                all.addAll(outcome.places());
                right &= all.stream().allMatch(r -> r >= LEAST && r <= MOST) && outcome.failed() == 0;
            }
        }
        PrintWriter out = command.getOut();
        out.print(json ? json(outcomes, noisePx, simulations, seed) : text(outcomes, noisePx, simulations));
        out.flush();
        return right ? ExitCodes.OK : ExitCodes.TARGET_MISSED;
    }

    private static String text(List<CalibrationStudy.Outcome> outcomes, double noisePx, int simulations) {
        TextTable table = new TextTable(1);
        List<String> header = new ArrayList<>(List.of("error / std"));
        for (CalibrationStudy.Scene scene : CalibrationStudy.Scene.values()) {
            header.add(scene.words());
        }
        table.row(header.toArray(String[]::new));
        CalibrationStudy.Outcome first = outcomes.get(0);
        for (int k = 0; k < first.names().size(); k++) {
            int at = k;
            row(table, first.names().get(k),
                    outcomes.stream().map(o -> CheckText.fixed(o.ratios().get(at), 2)).toList());
        }
        for (int k = 0; k < 9; k++) {
            int at = k;
            row(table, "projection, row " + (k / 3 + 1) + " column " + (k % 3 + 1),
                    outcomes.stream().map(o -> CheckText.fixed(o.places().get(at), 2)).toList());
        }
        row(table, "stated std of projection, px", outcomes.stream().map(o -> CheckText.fixed(o.meanStdPx(), 3))
                .toList());
        row(table, "odd against even beyond 2, %", outcomes.stream()
                .map(o -> CheckText.fixed(100 * o.beyondTwo(), 0)).toList());
        row(table, "board called bent otherwise, %", outcomes.stream()
                .map(o -> CheckText.fixed(100 * o.bent(), 1)).toList());
        return simulations + " calibrations each, noise of a corner's coordinate " + CheckText.plain(noisePx)
                + " px\n" + table.text("");
    }

    private static void row(TextTable table, String name, List<String> values) {
        List<String> cells = new ArrayList<>(List.of(name));
        cells.addAll(values);
        table.row(cells.toArray(String[]::new));
    }

    private static String json(List<CalibrationStudy.Outcome> outcomes, double noisePx, int simulations, long seed) {
        JsonObject out = new JsonObject();
        out.addProperty("simulations", simulations);
        out.addProperty("pixel_std_px", noisePx);
        out.addProperty("seed", seed);
        JsonArray scenes = new JsonArray();
        Gson gson = new Gson();
        CalibrationStudy.Scene[] all = CalibrationStudy.Scene.values();
        for (int k = 0; k < all.length; k++) {
            CalibrationStudy.Outcome o = outcomes.get(k);
            JsonObject one = new JsonObject();
            one.addProperty("scene", all[k].words());
            one.add("parameters", gson.toJsonTree(o.names()));
            one.add("error_over_std", gson.toJsonTree(o.ratios()));
            one.add("projection_error_over_std", gson.toJsonTree(o.places()));
            one.addProperty("projection_std_px", o.meanStdPx());
            one.addProperty("cross_validation_beyond_2", o.beyondTwo());
            one.addProperty("called_bent", o.bent());
            one.addProperty("failed", o.failed());
            scenes.add(one);
        }
        out.add("scenes", scenes);
        return out + "\n";
    }
}
