package org.cellgauge.android.files;

import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Setting;
import org.cellgauge.settings.SettingTable;

/** The command by which the command line makes the figures of a kept result again. */
final class DesktopCommand {
    private DesktopCommand() {
    }

    /**
     * The command. Its options are called after the settings; neither these nor the names of results hold anything that
     * a shell would take for more than a letter.
     *
     * @param name common beginning of the result's files
     * @param settings the check's
     * @return one line for a shell, with all settings that determine figures and differ from the defaults
     */
    static String of(String name, CheckSettings settings) {
        StringBuilder command = new StringBuilder("cellgauge check --cell ").append(name).append(".cell.yaml");
        for (Setting<?> setting : SettingTable.all()) {
            if (setting.isTold(settings)) {
                command.append(" --").append(setting.name()).append(' ').append(setting.text(settings));
            }
        }
        return command.append(' ').append(name).append(".png").toString();
    }
}
