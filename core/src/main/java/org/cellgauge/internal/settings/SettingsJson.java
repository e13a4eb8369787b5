package org.cellgauge.internal.settings;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.util.LinkedHashMap;
import java.util.Map;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Setting;
import org.cellgauge.settings.SettingRefusal;
import org.cellgauge.settings.SettingRefusedException;
import org.cellgauge.settings.SettingTable;
import org.cellgauge.warning.Refusal;

/** Settings as files hold them, by key; what stands in a file makes the same settings again. */
public final class SettingsJson {
    private SettingsJson() {
    }

    /**
     * All settings that determine figures.
     *
     * @param settings what to write
     * @return keys in the order of {@link SettingTable}, and Strings, Numbers, Booleans, or null for what is open or
     *     does not apply
     */
    public static Map<String, Object> plain(CheckSettings settings) {
        Map<String, Object> values = new LinkedHashMap<>();
        for (Setting<?> row : SettingTable.all()) {
            if (row.determinesFigures()) {
                values.put(row.key(), row.plain(settings));
            }
        }
        return values;
    }

    /**
     * Settings from a file. What the file does not name, and what does not apply, is the default; keys that belong to
     * no setting (a result tells of itself among them) do not count.
     *
     * @param object the value of the key {@code settings}, as {@link #plain} has it
     * @return the settings
     * @throws SettingRefusedException if a value is none of its setting or out of range
     */
    public static CheckSettings read(JsonObject object) {
        CheckSettings.Builder builder = CheckSettings.builder();
        for (Setting<?> row : SettingTable.all()) {
            JsonElement value = object.get(row.key());
            if (value == null || value.isJsonNull()) {
                continue;
            }
            if (!value.isJsonPrimitive()) {
                throw new SettingRefusedException(row, Refusal.of(SettingRefusal.NOT_ONE_VALUE));
            }
            row.read(value.getAsString(), builder);
        }
        // what a null means is told by the others: open, or of no meaning among them
        CheckSettings stated = builder.build();
        for (Setting<?> row : SettingTable.all()) {
            if (object.has(row.key()) && object.get(row.key()).isJsonNull() && row.appliesTo(stated)) {
                row.readOpen(builder);
            }
        }
        return builder.build();
    }
}
