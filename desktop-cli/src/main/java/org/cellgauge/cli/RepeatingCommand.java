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
     * @return one line for a POSIX shell in the folder that the files are named from
     */
    static String check(Path cellFile, CheckInput input, CheckSettings settings) {
        List<String> words = new ArrayList<>(List.of("cellgauge", "check", "--cell", file(cellFile)));
        for (Setting<?> setting : SettingTable.all()) {
            if (setting.isTold(settings)) {
                words.add(CheckOptions.name(setting));
                words.add(setting.text(settings));
            }
        }
        if (input.isDetections()) {
            words.add("--detections");
        }
        words.add(file(input.file()));
        return line(words);
    }

    /**
     * A command as it was given, but for options on which no figure depends.
     *
     * @param name name of the command
     * @param parsed what the user gave
     * @param without names of options to leave out
     * @return one line for a POSIX shell
     */
    static String asGiven(String name, ParseResult parsed, Set<String> without) {
        List<String> words = new ArrayList<>(List.of("cellgauge", name));
        // an option that is given twice is matched twice, each time with all its values
        for (OptionSpec option : new LinkedHashSet<>(parsed.matchedOptions())) {
            if (without.contains(option.longestName())) {
                continue;
            }
            if (option.arity().max() == 0) {
                words.add(option.longestName());
            }
            for (String value : option.arity().max() == 0 ? List.<String>of() : option.originalStringValues()) {
                words.add(option.longestName());
                words.add(value.trim());
            }
        }
        return line(words);
    }

    private static String file(Path path) {
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
