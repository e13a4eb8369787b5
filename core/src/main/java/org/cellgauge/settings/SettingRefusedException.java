package org.cellgauge.settings;

import org.cellgauge.warning.Refusal;

/** A value of a setting cannot be used: which setting, and why, as data. */
public final class SettingRefusedException extends IllegalArgumentException {
    private static final long serialVersionUID = 1L;

    private final transient Setting<?> setting;
    private final transient Refusal refusal;

    /**
     * A refusal.
     *
     * @param setting whose value it is
     * @param refusal why: a sentence without its subject
     */
    public SettingRefusedException(Setting<?> setting, Refusal refusal) {
        super(setting.key() + ": " + refusal);
        this.setting = setting;
        this.refusal = refusal;
    }

    /**
     * Whose value it is.
     *
     * @return a row of a table
     */
    public Setting<?> setting() {
        return setting;
    }

    /**
     * Why it cannot be used, as data; {@link #getMessage()} is the same in English after the setting's key.
     *
     * @return a sentence without its subject, which is the setting
     */
    public Refusal refusal() {
        return refusal;
    }
}
