package org.cellgauge.android.device;

import static org.junit.Assert.assertEquals;

import android.content.Context;
import android.os.Build;
import android.os.PowerManager;
import io.reactivex.rxjava3.subscribers.TestSubscriber;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.Shadows;
import org.robolectric.annotation.Config;
import org.robolectric.shadows.ShadowPowerManager;

/** Android's thermal status as levels. */
@RunWith(RobolectricTestRunner.class)
public class ThermalWatchTest {
    private final Context context = RuntimeEnvironment.getApplication();
    private final ShadowPowerManager power = Shadows.shadowOf(context.getSystemService(PowerManager.class));

    @Test
    @Config(minSdk = Build.VERSION_CODES.Q)
    public void thePresentLevelComesAtOnceAndThenEveryChange() {
        power.setCurrentThermalStatus(PowerManager.THERMAL_STATUS_MODERATE);
        TestSubscriber<ThermalLevel> seen = new ThermalWatch(context).levels().test();
        seen.assertValues(ThermalLevel.WARM);
        power.setCurrentThermalStatus(PowerManager.THERMAL_STATUS_SEVERE);
        power.setCurrentThermalStatus(PowerManager.THERMAL_STATUS_CRITICAL);
        power.setCurrentThermalStatus(PowerManager.THERMAL_STATUS_EMERGENCY);
        power.setCurrentThermalStatus(PowerManager.THERMAL_STATUS_LIGHT);
        power.setCurrentThermalStatus(PowerManager.THERMAL_STATUS_NONE);
        seen.assertValues(ThermalLevel.WARM, ThermalLevel.HOT, ThermalLevel.CRITICAL, ThermalLevel.NORMAL);
        seen.assertNotComplete();
    }

    @Test
    @Config(minSdk = Build.VERSION_CODES.Q)
    public void nobodyIsListenedToAfterTheLastHasGone() {
        TestSubscriber<ThermalLevel> seen = new ThermalWatch(context).levels().test();
        assertEquals(1, power.getThermalStatusListeners().size());
        seen.cancel();
        assertEquals(0, power.getThermalStatusListeners().size());
    }

    @Test
    @Config(maxSdk = Build.VERSION_CODES.P)
    public void olderAndroidsSayNothingAndStayNormal() {
        new ThermalWatch(context).levels().test().assertResult(ThermalLevel.NORMAL);
    }

    @Test
    public void everyStatusHasItsLevelAndAnUnknownOneIsTheWorst() {
        ThermalLevel[] expected = {ThermalLevel.NORMAL, ThermalLevel.NORMAL, ThermalLevel.WARM, ThermalLevel.HOT,
            ThermalLevel.CRITICAL, ThermalLevel.CRITICAL, ThermalLevel.CRITICAL, ThermalLevel.CRITICAL};
        for (int status = 0; status < expected.length; status++) {
            assertEquals(expected[status], ThermalLevel.of(status));
        }
    }
}
