package org.cellgauge.settings;

/** What has a value for each setting of a table. */
public interface SettingSource {
    /**
     * Value of any setting.
     *
     * @param setting its row
     * @param <T> type of its values
     * @return the value, never null
     */
    <T> T get(Setting<T> setting);
}
