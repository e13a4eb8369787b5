package org.cellgauge.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.cellgauge.desktop.CheckInput;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Setting;
import org.cellgauge.settings.SettingSource;
import org.cellgauge.settings.SettingTable;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParseResult;

/** The command that makes the figures of a result again: all that determines them and is not the default. */
final class RepeatingCommand {
    /** What no shell takes for anything but itself. */
    private static final Pattern PLAIN = Pattern.compile("[A-Za-z0-9_@%+=:,./-]+");

    private RepeatingCommand() {
    }

    /**
     * The command of a check.
     *
     * @param cellFile as named by the user
     * @param input what was checked
     * @param settings how
     * @param allDraws whether all draws were asked for
     * @return one line for a POSIX shell in the folder that the files are named from
     */
    static String check(Path cellFile, CheckInput input, CheckSettings settings, boolean allDraws) {
        List<String> words = new ArrayList<>(List.of("cellgauge", "check", "--cell", file(cellFile)));
        addTold(words, SettingTable.all(), settings, CheckOptions.CHECK_USUAL);
        if (allDraws) {
            words.add(CheckCommand.DRAWS);
        }
        if (input.isDetections()) {
            words.add("--detections");
        }
        words.add(file(input.file()));
        return line(words);
    }

    /**
     * The command of a validation.
     *
     * @param cellFile as named by the user, or null for none
     * @param study what was simulated
     * @param check how it was checked
     * @param parsed what the user gave, for options besides settings
     * @param others their names
     * @return one line for a POSIX shell in the folder that the file is named from
     */
    static String validate(Path cellFile, StudySettings study, CheckSettings check, ParseResult parsed,
            Set<String> others) {
        List<String> words = new ArrayList<>(List.of("cellgauge", "validate"));
        if (cellFile != null) {
            words.addAll(List.of("--cell", file(cellFile)));
        }
        addTold(words, StudyTable.all(), study, StudySettings.USUAL);
        // an option that is given twice is matched twice, each time with all its values
        for (OptionSpec option : new LinkedHashSet<>(parsed.matchedOptions())) {
            if (others.contains(option.longestName())) {
                for (String value : option.originalStringValues()) {
                    words.add(option.longestName());
                    words.add(value.trim());
                }
            }
        }
        addTold(words, SettingTable.all(), check, CheckOptions.OfValidate.USUAL);
        return line(words);
    }

    /**
     * The command of a calibration.
     *
     * @param parsed what the user gave
     * @return one line for a POSIX shell in the folder that files are named from
     */
    static String calibrate(ParseResult parsed) {
        return asGiven("calibrate", parsed);
    }

    /**
     * The command of a survey.
     *
     * @param parsed what the user gave
     * @return one line for a POSIX shell in the folder that files are named from
     */
    static String survey(ParseResult parsed) {
        return asGiven("survey", parsed);
    }

    private static String asGiven(String command, ParseResult parsed) {
        List<String> words = new ArrayList<>(List.of("cellgauge", command));
        // several files may follow --detections: photos stand before it
        parsed.matchedPositionals().forEach(p -> words.addAll(p.originalStringValues()));
        for (OptionSpec option : new LinkedHashSet<>(parsed.matchedOptions())) {
            words.add(option.longestName());
            words.addAll(option.originalStringValues());
        }
        return line(words);
    }

    /**
     * The command of a plan.
     *
     * @param parsed what the user gave
     * @return one line for a POSIX shell in the folder that files are named from
     */
    static String plan(ParseResult parsed) {
        List<String> words = new ArrayList<>(List.of("cellgauge", "plan"));
        for (OptionSpec option : new LinkedHashSet<>(parsed.matchedOptions())) {
            // one that is repeated is named again for every value
            option.originalStringValues().forEach(value -> words.addAll(option.typeInfo().isBoolean()
                    ? List.of(option.longestName()) : List.of(option.longestName(), value.trim())));
        }
        return line(words);
    }

    private static void addTold(List<String> words, List<Setting<?>> rows, SettingSource settings,
            SettingSource usual) {
        for (Setting<?> row : rows) {
            if (row.isTold(settings, usual)) {
                words.add(SettingOptions.name(row));
                if (!row.form().isFlag()) {
                    words.add(row.text(settings));
                }
            }
        }
    }

    private static String file(Path given) {
        Path path = StandardInput.asGiven(given);
        if (StandardInput.is(path)) {
            return path.toString();
        }
        // a name that begins with a hyphen would pass for an option
        return path.toString().startsWith("-") ? Path.of(".").resolve(path).toString() : path.toString();
    }

    private static String line(List<String> words) {
        return words.stream().map(RepeatingCommand::quoted).collect(Collectors.joining(" "));
    }

    /** A word as a shell must read it to have it unchanged. */
    static String quoted(String word) {
        return PLAIN.matcher(word).matches() ? word : "'" + word.replace("'", "'\\''") + "'";
    }
}
