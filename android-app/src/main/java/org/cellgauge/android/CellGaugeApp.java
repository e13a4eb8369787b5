package org.cellgauge.android;

import android.app.Application;

/** The app: puts its parts together. */
public class CellGaugeApp extends Application {
    private AppParts parts;

    /**
     * What the screen works with.
     *
     * @return the same parts each time
     */
    public final synchronized AppParts parts() {
        if (parts == null) {
            parts = makeParts();
        }
        return parts;
    }

    /**
     * Makes the parts; a test makes others.
     *
     * @return those of the device
     */
    protected AppParts makeParts() {
        return new DeviceParts(this);
    }
}
