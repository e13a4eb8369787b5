package org.cellgauge.android.screen;

import static org.junit.Assert.assertEquals;

import android.view.Surface;
import org.cellgauge.android.R;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.annotation.Config;

/** Pictures of the main screens, for people to look at: build/screenshots. */
@RunWith(RobolectricTestRunner.class)
@Config(application = TestApp.class)
public class ScreenshotTest {

    @Test
    public void firstStart() {
        RuntimeEnvironment.setQualifiers(Screen.TABLET_LANDSCAPE);
        try (Screen screen = Screen.start()) {
            screen.keep("first-start", null);
            assertEquals("No cell chosen", screen.text(R.id.banner_headline));
        }
    }

    @Test
    public void pass() {
        RuntimeEnvironment.setQualifiers(Screen.TABLET_LANDSCAPE);
        try (Screen screen = Screen.live(Fixture.LIFTED.document(), 0, false)) {
            screen.holdStillUntilResult(Fixture.LIFTED);
            screen.keep("live-pass", Fixture.LIFTED.photo());
            assertEquals("Pass – target met", screen.text(R.id.banner_headline));
        }
    }
}
