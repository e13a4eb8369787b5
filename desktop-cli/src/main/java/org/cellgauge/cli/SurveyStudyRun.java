package org.cellgauge.cli;

import com.google.gson.GsonBuilder;
import java.io.PrintWriter;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import org.cellgauge.cell.Cell;
import org.cellgauge.desktop.CheckText;
import org.cellgauge.desktop.TextTable;
import org.cellgauge.internal.statistics.BinomialBand;
import org.cellgauge.internal.validation.DetectionSource;
import org.cellgauge.internal.validation.DriftStudy;
import org.cellgauge.internal.validation.SurveyStudy;
import org.cellgauge.settings.CheckSettings;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine;

/** {@code validate --photos-per-cell}: are stated regions of surveys right? */
final class SurveyStudyRun {
    private static final double PROBABILITY = 0.95;
    private static final double CONFIDENCE = 0.99;
    private static final double MOST_FALSE_ALARMS = 0.01;

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
     * @param source what photos are seen by; null where corners are drawn
     * @param json whether counts are printed as JSON
     * @return the exit code
     */
    static int run(CommandLine command, Cell cell, CheckSettings check, int photos, int cells,
            @Nullable DetectionSource source, boolean json) {
        boolean sampled = check.sampling().iterations().isPresent();
        SurveyStudy.Result result = SurveyStudy.of(cell, check, photos, cells, check.sampling().seed(),
                check.sampling().threads(), sampled, source);
        PrintWriter out = command.getOut();
        out.print(json ? json(result, photos) : text(result));
        out.flush();
        boolean covers = result.figures().stream().allMatch(f ->
                f.held() >= BinomialBand.of(f.regions(), PROBABILITY, CONFIDENCE).lower());
        return 2 * result.refused() > cells ? ExitCodes.NO_FIGURE : covers ? ExitCodes.OK : ExitCodes.TARGET_MISSED;
    }

    /**
     * Surveys each cell twice and prints what was called moved.
     *
     * @param command where it was asked for
     * @param cell the cell
     * @param check how it is surveyed
     * @param photos number of photos of each survey
     * @param pairs number of cells
     * @param movedMm how far a reference is moved; 0 for none
     * @param json whether counts are printed as JSON
     * @return the exit code
     */
    static int drift(CommandLine command, Cell cell, CheckSettings check, int photos, int pairs, double movedMm,
            boolean json) {
        DriftStudy.Result result = DriftStudy.of(cell, check, photos, pairs, movedMm, check.sampling().seed(),
                check.sampling().threads());
        PrintWriter out = command.getOut();
        if (json) {
            out.println(new GsonBuilder().setPrettyPrinting().create().toJson(result));
        } else {
            out.printf(Locale.ROOT, "%d pairs of surveys of %d photos, %d without a figure%n", result.pairs(), photos,
                    result.refused());
            out.printf(Locale.ROOT, "something was called moved that was not: in %d%n", result.falseAlarms());
            if (movedMm > 0) {
                out.printf(Locale.ROOT, "the reference that was moved by %s mm was named: in %d%n",
                        CheckText.plain(movedMm), result.named());
            }
            out.printf(Locale.ROOT, "chi-square of what stood: %.2f by all photos, %.2f by single ones (%d is right)%n",
                    result.meanChiSquare(), result.meanPhotoChiSquare(), DriftStudy.freedom());
        }
        out.flush();
        return 2 * result.refused() > pairs ? ExitCodes.NO_FIGURE
                : result.falseAlarms() <= BinomialBand.of(pairs, MOST_FALSE_ALARMS, CONFIDENCE).upper() ? ExitCodes.OK
                        : ExitCodes.TARGET_MISSED;
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
