package org.cellgauge.android.device;

import android.content.Context;
import android.os.Build;
import android.os.PowerManager;
import android.util.Log;
import io.reactivex.rxjava3.core.BackpressureStrategy;
import io.reactivex.rxjava3.core.Flowable;

/**
 * How warm the device is, as Android says it (API 29 and newer). Older devices throttle as well but say nothing: there
 * the level stays normal.
 */
public final class ThermalWatch {
    private final Context context;

    /**
     * A watch.
     *
     * @param context of the app; its application context is kept
     */
    public ThermalWatch(Context context) {
        this.context = context.getApplicationContext();
    }

    /**
     * The levels, the present one at once. The device is listened to while somebody is subscribed.
     *
     * @return never the same twice in a row; does not end where the device says anything at all; changes come on the
     *     main thread
     */
    public Flowable<ThermalLevel> levels() {
        PowerManager power = context.getSystemService(PowerManager.class);
        if (Build.VERSION.SDK_INT < Build.VERSION_CODES.Q || power == null) {
            return Flowable.just(ThermalLevel.NORMAL);
        }
        return Flowable.<ThermalLevel>create(levels -> {
            PowerManager.OnThermalStatusChangedListener listener = status -> levels.onNext(ThermalLevel.of(status));
            try {
                levels.onNext(ThermalLevel.of(power.getCurrentThermalStatus()));
                power.addThermalStatusListener(listener);
                levels.setCancellable(() -> power.removeThermalStatusListener(listener));
            } catch (RuntimeException e) {
                // a device without the service behind it: it says nothing, as older ones do
                Log.w("ThermalWatch", "this device does not say how warm it is", e);
                levels.onNext(ThermalLevel.NORMAL);
            }
        }, BackpressureStrategy.LATEST).distinctUntilChanged();
    }
}
