package org.cellgauge.android.screen;

import android.app.Activity;
import android.os.Build;
import android.window.OnBackInvokedCallback;
import android.window.OnBackInvokedDispatcher;

/**
 * Back as Android 13 and newer have it: the system is told beforehand whether the app has a use for it, and else shows
 * where it leads while the finger still moves. Older ones call {@link Activity#onBackPressed()}.
 */
final class BackGesture {
    private final Activity activity;
    private final Runnable action;
    /** An {@link OnBackInvokedCallback} while the system is told of it; before Android 13 there is no such type. */
    private Object registered;

    /**
     * Back that is the system's.
     *
     * @param activity the screen
     * @param action what back does where the app has a use for it
     */
    BackGesture(Activity activity, Runnable action) {
        this.activity = activity;
        this.action = action;
    }

    /**
     * Tells the system whose back is.
     *
     * @param own whether the app has a use for it
     */
    void own(boolean own) {
        if (Build.VERSION.SDK_INT < Build.VERSION_CODES.TIRAMISU || own == (registered != null)) {
            return;
        }
        OnBackInvokedDispatcher dispatcher = activity.getOnBackInvokedDispatcher();
        if (own) {
            OnBackInvokedCallback callback = action::run;
            dispatcher.registerOnBackInvokedCallback(OnBackInvokedDispatcher.PRIORITY_DEFAULT, callback);
            registered = callback;
        } else {
            dispatcher.unregisterOnBackInvokedCallback((OnBackInvokedCallback) registered);
            registered = null;
        }
    }
}
