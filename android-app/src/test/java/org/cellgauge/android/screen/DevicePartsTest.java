package org.cellgauge.android.screen;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;
import static org.robolectric.Shadows.shadowOf;

import android.os.Looper;
import org.cellgauge.android.R;
import org.cellgauge.android.state.ImageSource;
import org.cellgauge.check.Verdict;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.Robolectric;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.android.controller.ActivityController;

/** The app as it is packed, nothing of a test in it but the machine: it checks its example and keeps it. */
@RunWith(RobolectricTestRunner.class)
public class DevicePartsTest {
    private static final int PATIENCE_MS = 60_000;

    @Test
    public void exampleIsCheckedAndKeptByTheAppItself() throws Exception {
        try (ActivityController<MainActivity> controller = Robolectric.buildActivity(MainActivity.class).setup()) {
            MainActivity activity = controller.get();
            settle();
            activity.findViewById(R.id.message_second).performClick();
            long end = System.currentTimeMillis() + PATIENCE_MS;
            while (activity.session().state().verdict() == null && System.currentTimeMillis() < end) {
                Thread.sleep(5);
                settle();
            }
            settle();
            assertEquals(Verdict.PASS, activity.session().state().verdict());
            assertEquals(ImageSource.PHOTO, activity.session().state().source());
            activity.findViewById(R.id.save).performClick();
            while (activity.session().state().saved() == null && System.currentTimeMillis() < end) {
                Thread.sleep(5);
                settle();
            }
            assertTrue(activity.session().state().saveProblem() == null
                    ? "saved" : activity.session().state().saveProblem().message(),
                    activity.session().state().saved() != null);
            assertEquals("photo, result, overlay, cell", 4, activity.session().state().saved().uris().size());
        }
    }

    private static void settle() {
        shadowOf(Looper.getMainLooper()).idle();
    }
}
