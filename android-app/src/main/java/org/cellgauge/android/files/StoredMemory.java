package org.cellgauge.android.files;

import android.content.Context;
import android.content.SharedPreferences;

/** A memory in the app's own storage, which is in no backup: addresses of documents mean nothing on another device. */
public final class StoredMemory implements AppMemory {
    private static final String FILE = "memory";
    private static final String CELL = "cell";
    private static final String CALIBRATION = "calibration";
    private static final String TARGET = "target";
    private static final String GUIDE = "guide-shown";

    private final SharedPreferences stored;

    /**
     * The memory of an app.
     *
     * @param context of the app
     */
    public StoredMemory(Context context) {
        this.stored = context.getSharedPreferences(FILE, Context.MODE_PRIVATE);
    }

    @Override
    public Choice lastChoice() {
        String cell = stored.getString(CELL, null);
        return cell == null ? null : new Choice(cell, stored.getString(CALIBRATION, null),
                TargetText.read(stored.getString(TARGET, null)));
    }

    @Override
    public void keep(Choice choice) {
        // at once, so that it holds even where the app is ended in the next moment; a null removes
        stored.edit().putString(CELL, choice.cellUri()).putString(CALIBRATION, choice.calibrationUri())
                .putString(TARGET, choice.target() == null ? null : TargetText.of(choice.target())).commit();
    }

    @Override
    public boolean guideShown() {
        return stored.getBoolean(GUIDE, false);
    }

    @Override
    public void guideIsShown() {
        stored.edit().putBoolean(GUIDE, true).apply();
    }
}
