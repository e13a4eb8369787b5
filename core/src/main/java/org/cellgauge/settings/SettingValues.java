package org.cellgauge.settings;

import java.util.HashMap;
import java.util.Map;

/** Values of settings by row: the default where none was set; immutable. */
final class SettingValues {
    private final Map<Setting<?>, Object> values;

    /** Values that were set; copied. */
    SettingValues(Map<Setting<?>, Object> values) {
        this.values = new HashMap<>(values);
    }

    Map<Setting<?>, Object> copy() {
        return new HashMap<>(values);
    }

    @SuppressWarnings("unchecked")
    <T> T get(Setting<T> setting) {
        Object value = values.get(setting);
        return value == null ? setting.usual() : (T) value;
    }

    <T> T get(Setting<T> setting, Setting.Part part) {
        if (setting.part() != part) {
            throw new IllegalArgumentException(setting + " belongs to the other half of the settings");
        }
        return get(setting);
    }

    /** The text of all that differ from their defaults. */
    @Override
    public String toString() {
        StringBuilder text = new StringBuilder();
        SettingTable.all().forEach(setting -> append(text, setting));
        return text.toString().trim();
    }

    private <T> void append(StringBuilder text, Setting<T> setting) {
        if (!get(setting).equals(setting.usual())) {
            text.append(setting.name()).append('=').append(setting.form().text(get(setting))).append(' ');
        }
    }
}
