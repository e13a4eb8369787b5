package org.cellgauge.android.screen;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import android.graphics.Insets;
import android.graphics.Rect;
import android.os.Build;
import android.view.Surface;
import android.view.View;
import android.view.ViewGroup;
import android.view.WindowInsets;
import android.view.WindowInsetsController;
import android.view.WindowManager;
import android.widget.TextView;
import java.util.ArrayList;
import java.util.List;
import org.cellgauge.android.R;
import org.cellgauge.android.camera.CameraFault;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.Robolectric;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.android.controller.ActivityController;
import org.robolectric.annotation.Config;
import org.robolectric.util.ReflectionHelpers;
import org.robolectric.util.ReflectionHelpers.ClassParameter;

/** The system's bars and the camera's cutout cover nothing that is read or tapped. */
@RunWith(RobolectricTestRunner.class)
@Config(application = TestApp.class)
public class SystemBarsTest {
    private static final Rect CUTOUT_AT_THE_LEFT = new Rect(90, 48, 0, 60);
    private static final Rect BUTTONS_AT_THE_RIGHT = new Rect(0, 48, 96, 24);

    /** Bars above and below, cutout or buttons at a side, as Android tells it; px. */
    private static WindowInsets covered(Rect by) {
        if (Build.VERSION.SDK_INT < Build.VERSION_CODES.R) {
            return ReflectionHelpers.callConstructor(WindowInsets.class, ClassParameter.from(Rect.class, by));
        }
        return new WindowInsets.Builder()
                .setInsets(WindowInsets.Type.statusBars(), Insets.of(0, by.top, 0, 0))
                .setInsets(WindowInsets.Type.navigationBars(), Insets.of(0, 0, by.right, by.bottom))
                .setInsets(WindowInsets.Type.displayCutout(), Insets.of(by.left, 0, 0, 0)).build();
    }

    private static void cover(Screen screen, Rect by) {
        cover(screen.find(R.id.screen), by);
        screen.settle();
    }

    private static void cover(View root, Rect by) {
        root.dispatchApplyWindowInsets(covered(by));
        root.measure(View.MeasureSpec.makeMeasureSpec(root.getWidth(), View.MeasureSpec.EXACTLY),
                View.MeasureSpec.makeMeasureSpec(root.getHeight(), View.MeasureSpec.EXACTLY));
        root.layout(root.getLeft(), root.getTop(), root.getRight(), root.getBottom());
    }

    /** Words and buttons that are to be seen but for what lies under the bars. */
    private static void texts(View view, List<View> found) {
        if (view instanceof TextView && ((TextView) view).length() > 0 && view.isShown()
                && view.getGlobalVisibleRect(new Rect())) {
            found.add(view);
        }
        if (view instanceof ViewGroup) {
            for (int i = 0; i < ((ViewGroup) view).getChildCount(); i++) {
                texts(((ViewGroup) view).getChildAt(i), found);
            }
        }
    }

    private static void assertNothingIsCovered(Screen screen, Rect by) {
        assertNothingIsCovered(screen.find(R.id.screen), by, 5);
    }

    private static void assertNothingIsCovered(View root, Rect by, int least) {
        Rect free = new Rect();
        root.getGlobalVisibleRect(free);
        free = new Rect(free.left + by.left, free.top + by.top, free.right - by.right, free.bottom - by.bottom);
        List<View> texts = new ArrayList<>();
        texts(root, texts);
        assertTrue(texts.size() + " texts", texts.size() > least);
        for (View text : texts) {
            Rect at = new Rect();
            text.getGlobalVisibleRect(at);
            assertTrue(((TextView) text).getText() + " at " + at + " is not within " + free, free.contains(at));
        }
    }

    private static Screen live(String qualifiers) {
        RuntimeEnvironment.setQualifiers(qualifiers);
        Screen.turnDisplay(Surface.ROTATION_90);
        return Screen.live(Fixture.LIFTED.document(), 90, false);
    }

    @Test
    public void barsAndCutoutCoverNothingThatIsReadOrTapped() {
        for (String qualifiers : new String[] {Screen.TABLET_LANDSCAPE, Screen.TABLET_PORTRAIT, Screen.PHONE_LANDSCAPE,
            Screen.PHONE_PORTRAIT}) {
            try (Screen screen = live(qualifiers)) {
                for (Rect by : new Rect[] {CUTOUT_AT_THE_LEFT, BUTTONS_AT_THE_RIGHT, new Rect()}) {
                    cover(screen, by);
                    assertNothingIsCovered(screen, by);
                }
                screen.tap(R.id.figures);
                cover(screen, BUTTONS_AT_THE_RIGHT);
                assertNothingIsCovered(screen, BUTTONS_AT_THE_RIGHT);
                Screen.app().feed.fault(CameraFault.DISCONNECTED);
                screen.settle();
                cover(screen, CUTOUT_AT_THE_LEFT);
                assertNothingIsCovered(screen, CUTOUT_AT_THE_LEFT);
            }
        }
    }

    @Test
    public void pagesBelowAHeadingKeepClearAsWell() {
        for (String qualifiers : new String[] {Screen.TABLET_LANDSCAPE, Screen.PHONE_LANDSCAPE,
            Screen.PHONE_PORTRAIT}) {
            RuntimeEnvironment.setQualifiers(qualifiers);
            for (Rect by : new Rect[] {CUTOUT_AT_THE_LEFT, BUTTONS_AT_THE_RIGHT}) {
                try (ActivityController<GuideActivity> guide = Robolectric.buildActivity(GuideActivity.class);
                        ActivityController<ResultsActivity> results =
                                Robolectric.buildActivity(ResultsActivity.class)) {
                    View page = guide.setup().get().findViewById(R.id.guide_screen);
                    cover(page, by);
                    assertNothingIsCovered(page, by, 3);
                    assertEquals("the heading goes on behind the bar", 0, page.findViewById(R.id.heading).getTop());
                    View list = results.setup().get().findViewById(R.id.results_screen);
                    cover(list, by);
                    assertNothingIsCovered(list, by, 1);
                }
            }
        }
    }

    @Test
    public void thePictureAndTheBannersColourGoOnBehindThem() {
        try (Screen screen = live(Screen.PHONE_LANDSCAPE)) {
            cover(screen, CUTOUT_AT_THE_LEFT);
            View root = screen.find(R.id.screen);
            assertEquals(root.getWidth(), screen.find(R.id.view_area).getWidth());
            assertEquals(0, screen.find(R.id.banner).getTop());
            assertEquals(root.getHeight(), screen.find(R.id.bar).getBottom());
        }
    }

    /** The banner behind the status bar is dark by day and night, the bar behind the navigation is a card. */
    @Test
    @Config(minSdk = Build.VERSION_CODES.R)
    public void signsOfTheBarsStandOutByDayAndNight() {
        int both = WindowInsetsController.APPEARANCE_LIGHT_STATUS_BARS
                | WindowInsetsController.APPEARANCE_LIGHT_NAVIGATION_BARS;
        for (boolean night : new boolean[] {false, true}) {
            RuntimeEnvironment.setQualifiers(Screen.TABLET_LANDSCAPE.replace("notnight", night ? "night" : "notnight"));
            try (Screen screen = Screen.start()) {
                int appearance = screen.activity().getWindow().getInsetsController().getSystemBarsAppearance() & both;
                assertEquals(night ? 0 : WindowInsetsController.APPEARANCE_LIGHT_NAVIGATION_BARS, appearance);
                assertEquals(WindowManager.LayoutParams.LAYOUT_IN_DISPLAY_CUTOUT_MODE_ALWAYS,
                        screen.activity().getWindow().getAttributes().layoutInDisplayCutoutMode);
            }
        }
    }
}
