package org.cellgauge.android;

import android.content.Context;
import android.content.pm.PackageManager;

/** Which version of the app runs. */
public final class AppVersion {
    private AppVersion() {
    }

    /**
     * The version, as the package states it.
     *
     * @param context of the app
     * @return its name, such as 1.2.3
     */
    public static String of(Context context) {
        try {
            return context.getPackageManager().getPackageInfo(context.getPackageName(), 0).versionName;
        } catch (PackageManager.NameNotFoundException e) {
            throw new IllegalStateException("the app is not installed", e);
        }
    }
}
