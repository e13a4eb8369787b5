package org.cellgauge.cli;

import com.google.gson.GsonBuilder;
import java.io.PrintWriter;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import org.cellgauge.cell.Cell;
import org.cellgauge.desktop.TextTable;
import org.cellgauge.internal.statistics.BinomialBand;
import org.cellgauge.internal.validation.SurveyStudy;
import org.cellgauge.settings.CheckSettings;
import picocli.CommandLine;

/** {@code validate --photos-per-cell}: are stated regions of surveys right? */
final class SurveyStudyRun {
    private static final double PROBABILITY = 0.95;
    private static final double CONFIDENCE = 0.99;

    private SurveyStudyRun() {
    }

    /**
     * Runs the study and prints its table.
     *
     * @param command where it was asked for
     * @param cell the cell
     * @param check how it is surveyed; regions are of draws where it says how many
     * @param photos number of photos of each cell
     * @param cells number of cells
     * @param json whether counts are printed as JSON
     * @return the exit code
     */
    static int run(CommandLine command, Cell cell, CheckSettings check, int photos, int cells, boolean json) {
        boolean sampled = check.sampling().iterations().isPresent();
        SurveyStudy.Result result = SurveyStudy.of(cell, check, photos, cells, check.sampling().seed(),
                check.sampling().threads(), sampled);
        PrintWriter out = command.getOut();
        out.print(json ? json(result, photos) : text(result));
        out.flush();
        boolean covers = result.figures().stream().allMatch(f ->
                f.held() >= BinomialBand.of(f.regions(), PROBABILITY, CONFIDENCE).lower());
        return 2 * result.refused() > cells ? ExitCodes.NO_FIGURE : covers ? ExitCodes.OK : ExitCodes.TARGET_MISSED;
    }

    private static String text(SurveyStudy.Result result) {
        TextTable table = new TextTable(1).row("95 % regions of", "regions", "hold the truth", "mean square",
                "should be");
        for (SurveyStudy.Figures f : result.figures()) {
            table.row(f.part().toString(), String.valueOf(f.regions()),
                    String.format(Locale.ROOT, "%.1f %%", 100.0 * f.held() / f.regions()),
                    String.format(Locale.ROOT, "%.2f", f.meanSquare()), String.valueOf(f.dimension()));
        }
        return table.text("") + result.cells() + " cells, " + result.refused() + " without a figure, in "
                + result.falseAlarms() + " something was called misplaced that is not\n";
    }

    private static String json(SurveyStudy.Result result, int photos) {
        Map<String, Object> all = new LinkedHashMap<>();
        all.put("cells", result.cells());
        all.put("photos_per_cell", photos);
        all.put("refused", result.refused());
        all.put("false_alarms", result.falseAlarms());
        for (SurveyStudy.Figures f : result.figures()) {
            Map<String, Object> one = new LinkedHashMap<>();
            one.put("regions", f.regions());
            one.put("held", f.held());
            one.put("mean_square", f.meanSquare());
            one.put("dimension", f.dimension());
            all.put(f.part().name().toLowerCase(Locale.ROOT), one);
        }
        return new GsonBuilder().setPrettyPrinting().create().toJson(all) + "\n";
    }
}
