package org.cellgauge.android;

import android.app.Application;
import org.cellgauge.internal.vision.BoofThreads;

/** The app: puts its parts together. */
public class CellGaugeApp extends Application {
    private AppParts parts;

    @Override
    public void onCreate() {
        super.onCreate();
        // frames are searched on the camera's thread: more of them at a time would only heat the device
        BoofThreads.useOne();
    }

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
