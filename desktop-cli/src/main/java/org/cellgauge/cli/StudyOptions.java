package org.cellgauge.cli;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.cellgauge.settings.Setting;
import org.cellgauge.settings.SettingRefusedException;
import picocli.CommandLine;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/** Options of {@code validate} that say what is simulated: those of {@link StudyTable}, and two of the grid's table. */
final class StudyOptions {
    /** What the grid goes through itself. */
    private static final List<Setting<?>> OF_GRID = List.of(StudyTable.TONE_CURVE, StudyTable.BLUR_PX,
            StudyTable.MARKER_PX, StudyTable.EXPOSURE, StudyTable.JPEG_QUALITY, StudyTable.UNSHARP,
            StudyTable.PRINT_GAIN_MM, StudyTable.GRADIENT);
    /** What random layouts draw themselves. */
    private static final List<Setting<?>> DRAWN = List.of(StudyTable.GRID, StudyTable.MARKER_PX);

    @Option(names = "--only", paramLabel = "WORDS",
            description = "With --grid: only rows whose name holds all these words, as in \"srgb 24px\".")
    private String only;

    @Option(names = "--out", paramLabel = "FILE",
            description = "With --grid: adds each row to this file once it is done, and skips those that stand in it.")
    private Path out;

    /** Words that the names of the grid's rows must hold, perhaps none. */
    List<String> onlyWords() {
        return only == null || only.isBlank() ? List.of() : List.of(only.trim().toLowerCase(Locale.ROOT).split("\\s+"));
    }

    /** File for the grid's rows, or null. */
    Path out() {
        return out;
    }

    /**
     * What the options ask for.
     *
     * @param command the command, parsed
     * @return the settings
     * @throws ParameterException if an option has no such value, or options do not go together
     */
    StudySettings settings(CommandLine command) {
        Map<Setting<?>, Object> values = new HashMap<>();
        for (Setting<?> row : StudyTable.all()) {
            String text = SettingOptions.given(command, row);
            if (text != null) {
                try {
                    values.put(row, row.read(text));
                } catch (SettingRefusedException e) {
                    throw SettingOptions.refused(command, e);
                }
            }
        }
        StudySettings settings = new StudySettings(values);
        for (Setting<?> row : StudyTable.all()) {
            if (values.containsKey(row) && !row.appliesTo(settings)) {
                throw new ParameterException(command, outOfPlace(row));
            }
        }
        boolean grid = settings.get(StudyTable.GRID);
        if (!grid && (only != null || out != null)) {
            throw new ParameterException(command, (only != null ? "--only" : "--out") + " is about the rows of "
                    + SettingOptions.name(StudyTable.GRID));
        }
        if (settings.get(StudyTable.RANDOM_LAYOUTS)) {
            forbid(command, DRAWN, values, "--random-layouts draws the size of markers: leave out ", "");
        }
        if (grid) {
            forbid(command, OF_GRID, values, "--grid goes through ",
                    " itself: leave it out, or pick rows with --only");
        }
        return settings;
    }

    private static String outOfPlace(Setting<?> row) {
        String name = SettingOptions.name(row);
        if (row == StudyTable.PIXEL_STD_PX) {
            return name + " is the noise of drawn corners; with --photos it is the detector's: leave it out, or say "
                    + "what the check is told with " + SettingOptions.name(StudyTable.STATED_PIXEL_STD_PX);
        }
        if (row == StudyTable.OUTLIERS) {
            return name + " draws corners, and with --photos the detector finds them: leave it out";
        }
        return row == StudyTable.SPREAD ? "--random-layouts makes its own cells: leave out " + name
                : name + " is about photos: give --photos, too";
    }

    private static void forbid(CommandLine command, List<Setting<?>> rows, Map<Setting<?>, Object> given,
            String before, String after) {
        rows.stream().filter(given::containsKey).findFirst().ifPresent(row -> {
            throw new ParameterException(command, before + SettingOptions.name(row) + after);
        });
    }
}
