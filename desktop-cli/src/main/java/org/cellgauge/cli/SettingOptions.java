package org.cellgauge.cli;

import java.util.List;
import org.cellgauge.settings.Setting;
import org.cellgauge.settings.SettingRefusedException;
import org.cellgauge.settings.SettingSource;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;

/** Options made from the rows of a table of settings: each is called after its setting. */
final class SettingOptions {
    private SettingOptions() {
    }

    /** The option of a setting. */
    static String name(Setting<?> setting) {
        return "--" + setting.name();
    }

    /**
     * Adds an option for each setting.
     *
     * @param spec the command
     * @param rows the settings
     * @param usual values where nothing is given, for the help
     */
    static void add(CommandSpec spec, List<Setting<?>> rows, SettingSource usual) {
        for (Setting<?> setting : rows) {
            OptionSpec.Builder option = OptionSpec.builder(name(setting)).description(description(setting, usual));
            spec.addOption(setting.form().isFlag() ? option.type(boolean.class).build()
                    : option.type(String.class).paramLabel(setting.form().placeholder())
                            .preprocessor(new PoseArgument.MayBeNegative()).build());
        }
    }

    private static String description(Setting<?> setting, SettingSource usual) {
        String words = setting.form().isFlag() ? "" : usual.get(setting).equals(setting.usual())
                ? setting.usualWords() : setting.text(usual);
        // a per cent sign begins a variable there
        return (setting.description() + (words.isEmpty() ? "" : " (" + words + ")") + ".").replace("%", "%%");
    }

    /** What was given for a setting; null where nothing was, or where the command has no such option. */
    static String given(CommandLine command, Setting<?> setting) {
        if (command.getCommandSpec().findOption(name(setting)) == null
                || !command.getParseResult().hasMatchedOption(name(setting))) {
            return null;
        }
        Object value = command.getParseResult().matchedOptionValue(name(setting), (Object) null);
        return value == null ? null : value.toString();
    }

    /**
     * The error that tells of a refused value.
     *
     * @param command where it was given
     * @param e the refusal
     * @return an error that names the option
     */
    static ParameterException refused(CommandLine command, SettingRefusedException e) {
        return new ParameterException(command, name(e.setting()) + ": " + CommandWords.of(e.refusal()));
    }
}
