package org.cellgauge.cli;

import com.google.gson.GsonBuilder;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.IntConsumer;
import org.cellgauge.desktop.TextTable;
import org.cellgauge.internal.validation.CauseStudy;
import org.cellgauge.internal.validation.CellSource;
import org.cellgauge.placement.Cause;
import org.cellgauge.settings.CheckSettings;
import picocli.CommandLine;
import picocli.CommandLine.ParameterException;

/** {@code validate --cause}: how often what is wrong with a cell is named. */
final class CauseStudyRun {
    /** Nothing is wrong: what is counted are false alarms. */
    static final String NONE = "none";
    /** Everything in turn. */
    static final String ALL = "all";
    /** Sizes of causes in their standard deviations: by so many they must show, and twice that. */
    static final NumberPair DEVIATIONS = new NumberPair(5, 10);
    /** Share of cells in which it must be named first then, and in which anything may be said if nothing is wrong. */
    private static final double NAMED = 0.9;
    private static final double FALSE_ALARMS = 0.01;

    private final CommandLine command;
    private final CellSource cells;
    private final CheckSettings check;
    private final int simulations;

    CauseStudyRun(CommandLine command, CellSource cells, CheckSettings check, int simulations) {
        this.command = command;
        this.cells = cells;
        this.check = check;
        this.simulations = simulations;
    }

    /**
     * Runs the study and prints its table.
     *
     * @param name key of a cause, or {@link #NONE} or {@link #ALL}
     * @param deviations least and largest size of a cause that has one, in its standard deviations
     * @param marginal whether deviations are those of a cause that is known to be the only one possible
     * @param json whether counts are printed as JSON
     * @param progress told what is done
     * @return the exit code
     */
    int run(String name, NumberPair deviations, boolean marginal, boolean json, IntConsumer progress) {
        Map<String, CauseStudy.Figures> figures = new LinkedHashMap<>();
        boolean well = true;
        for (Cause cause : causes(name)) {
            CauseStudy.Figures of = new CauseStudy(cells, cause, deviations.first(), deviations.second(), !marginal,
                    check).run(simulations, progress);
            figures.put(cause == null ? NONE : cause.key(), of);
            well &= cause == null ? of.alarms() <= FALSE_ALARMS * of.cells() : of.first() >= NAMED * of.cells();
        }
        PrintWriter out = command.getOut();
        out.print(json ? json(figures) : text(figures));
        out.flush();
        return well ? ExitCodes.OK : ExitCodes.TARGET_MISSED;
    }

    private List<Cause> causes(String name) {
        List<Cause> causes = new ArrayList<>();
        List<String> names = new ArrayList<>(List.of(NONE, ALL));
        if (name.equals(NONE) || name.equals(ALL)) {
            causes.add(null);
        }
        for (Cause cause : Cause.values()) {
            // these two are what others are called where no more is said of them
            boolean simulated = cause != Cause.POSITION_SCALE && cause != Cause.REFERENCE_ELSEWHERE;
            if (simulated) {
                names.add(cause.key());
            }
            if (simulated && (name.equals(ALL) || name.equals(cause.key()))) {
                causes.add(cause);
            }
        }
        if (causes.isEmpty()) {
            throw new ParameterException(command, "--cause: '" + name + "' is none of " + String.join(", ", names));
        }
        return causes;
    }

    private static String text(Map<String, CauseStudy.Figures> figures) {
        TextTable table = new TextTable(1);
        table.row("what is wrong", "cells", "named first", "or listed", "nothing said", "first instead");
        figures.forEach((name, of) -> {
            List<String> instead = new ArrayList<>();
            of.instead().forEach((cause, count) -> instead.add(count + " " + cause.key()));
            table.row(name, String.valueOf(of.cells()), name.equals(NONE) ? "-" : percent(of.first(), of.cells()),
                    name.equals(NONE) ? "-" : percent(of.listed(), of.cells()), percent(of.silent(), of.cells()),
                    String.join(", ", instead));
        });
        return table.text("");
    }

    private static String percent(int count, int of) {
        return of == 0 ? "-" : String.format(Locale.ROOT, "%.1f %%", 100.0 * count / of);
    }

    private static String json(Map<String, CauseStudy.Figures> figures) {
        Map<String, Object> all = new LinkedHashMap<>();
        figures.forEach((name, of) -> {
            Map<String, Object> counts = new LinkedHashMap<>();
            counts.put("cells", of.cells());
            counts.put("left_out", of.skipped());
            counts.put("named_first", of.first());
            counts.put("named_or_listed", of.listed());
            counts.put("nothing_said", of.silent());
            Map<String, Integer> instead = new LinkedHashMap<>();
            of.instead().forEach((cause, count) -> instead.put(cause.key(), count));
            counts.put("first_instead", instead);
            all.put(name, counts);
        });
        return new GsonBuilder().setPrettyPrinting().create().toJson(all) + "\n";
    }
}
