package org.cellgauge.android;

import static org.junit.Assert.assertEquals;

import android.app.Application;
import android.content.pm.ApplicationInfo;
import android.content.pm.PackageManager;
import android.os.Build;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.annotation.Config;

/** Tests see the Android and the app that they are meant to see: Android behaves by the version an app was made for. */
@RunWith(RobolectricTestRunner.class)
public class PlatformTest {

    @Test
    public void appIsTheOneThatIsBuilt() throws PackageManager.NameNotFoundException {
        Application app = RuntimeEnvironment.getApplication();
        ApplicationInfo info = app.getApplicationInfo();
        assertEquals(36, info.targetSdkVersion);
        assertEquals(26, info.minSdkVersion);
        assertEquals("org.cellgauge.android", app.getPackageName());
        assertEquals(System.getProperty("cellgauge.version"),
                app.getPackageManager().getPackageInfo(app.getPackageName(), 0).versionName);
    }

    @Test
    @Config(maxSdk = 33)
    public void oldestAndroidIsTheOldestThatTheAppIsFor() {
        assertEquals(26, Build.VERSION.SDK_INT);
    }

    @Test
    @Config(minSdk = 27)
    public void newestAndroidIsTheNewestThatRunsOnJava17() {
        assertEquals(35, Build.VERSION.SDK_INT);
    }

    /** As on a tablet: asked for in the manifest, not given until the user says so. */
    @Test
    public void cameraIsNotGrantedUnasked() {
        assertEquals(PackageManager.PERMISSION_DENIED,
                RuntimeEnvironment.getApplication().checkSelfPermission(android.Manifest.permission.CAMERA));
    }
}
