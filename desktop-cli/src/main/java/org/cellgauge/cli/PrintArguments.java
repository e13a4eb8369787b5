package org.cellgauge.cli;

import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.cellgauge.cell.Cell;
import org.cellgauge.desktop.render.Misprints;
import picocli.CommandLine;
import picocli.CommandLine.ParameterException;

/** Options that say what is wrong with simulated prints. */
final class PrintArguments {
    private static final String ALL = "all";

    private PrintArguments() {
    }

    /** The misprints that options state; what is not given is null or empty. */
    static Misprints misprints(CommandLine command, Cell cell, String inverted, String mirrored, List<String> turned,
            List<String> exchanged, Double ink) {
        Set<Integer> known = new LinkedHashSet<>();
        cell.references().forEach(r -> known.add(r.id()));
        cell.objects().forEach(o -> known.add(o.id()));
        Map<Integer, Integer> quarters = new HashMap<>();
        for (String text : turned) {
            String[] parts = text.split("=", -1);
            if (parts.length != 2) {
                throw usage(command, "--turned", text, "ID=QUARTERS, as in 944=1, or all=2");
            }
            int count = whole(command, "--turned", text, parts[1]);
            ids(command, "--turned", parts[0], known).forEach(id -> quarters.put(id, count));
        }
        Map<Integer, Integer> pairs = new HashMap<>();
        for (String text : exchanged) {
            List<Integer> pair = List.copyOf(ids(command, "--exchanged", text, known));
            if (pair.size() != 2 || text.equals(ALL)) {
                throw usage(command, "--exchanged", text, "two different ids, as in 944,22");
            }
            pairs.put(pair.get(0), pair.get(1));
        }
        if (ink != null && !(ink >= 0 && ink <= 1)) {
            throw new ParameterException(command, "--ink: must be between 0 and 1, not " + ink);
        }
        return new Misprints(inverted == null ? Set.of() : ids(command, "--inverted", inverted, known),
                mirrored == null ? Set.of() : ids(command, "--mirrored", mirrored, known), quarters, pairs,
                ink == null ? Misprints.NONE.inkReflectance() : ink);
    }

    private static Set<Integer> ids(CommandLine command, String option, String text, Set<Integer> known) {
        if (text.equals(ALL)) {
            return known;
        }
        Set<Integer> ids = new LinkedHashSet<>();
        for (String part : text.split(",", -1)) {
            int id = whole(command, option, text, part);
            if (!known.contains(id)) {
                throw new ParameterException(command, option + ": marker " + id + " is not in the cell file");
            }
            ids.add(id);
        }
        return ids;
    }

    private static int whole(CommandLine command, String option, String text, String part) {
        try {
            return Integer.parseInt(part.trim());
        } catch (NumberFormatException e) {
            throw usage(command, option, text, "whole numbers of markers in the cell file, or all");
        }
    }

    private static ParameterException usage(CommandLine command, String option, String text, String remedy) {
        return new ParameterException(command, option + ": '" + text + "' is not understood; write " + remedy);
    }
}
