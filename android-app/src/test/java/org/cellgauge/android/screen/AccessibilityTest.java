package org.cellgauge.android.screen;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import android.app.Activity;
import android.app.AlertDialog;
import android.content.res.Resources;
import android.graphics.Color;
import android.view.Surface;
import android.view.View;
import android.view.ViewGroup;
import android.widget.TextView;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.cellgauge.android.R;
import org.cellgauge.android.camera.CameraFault;
import org.cellgauge.android.device.ThermalLevel;
import org.cellgauge.android.state.ObjectRow;
import org.cellgauge.live.LiveState;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.annotation.Config;
import org.robolectric.shadows.ShadowDialog;

/** The screen for people who see colours, small letters or the screen itself less well, and for gloved fingers. */
@RunWith(RobolectricTestRunner.class)
@Config(application = TestApp.class, minSdk = 27)
public class AccessibilityTest {
    private static final int TOUCH_DP = 48;
    /** Web Content Accessibility Guidelines 2.1, 1.4.3 and 1.4.11. */
    private static final double TEXT_CONTRAST = 4.5;
    private static final double SIGN_CONTRAST = 3;

    private static List<View> all(View root) {
        List<View> views = new ArrayList<>();
        views.add(root);
        if (root instanceof ViewGroup) {
            for (int i = 0; i < ((ViewGroup) root).getChildCount(); i++) {
                views.addAll(all(((ViewGroup) root).getChildAt(i)));
            }
        }
        return views;
    }

    private static void assertTouchable(Screen screen, String where) {
        int clickable = assertTouchable(screen.activity(), where);
        assertTrue(where + ": " + clickable, clickable >= 7);
    }

    /** Whatever can be tapped has a label and room for a finger; how many there are. */
    static int assertTouchable(Activity activity, String where) {
        float density = activity.getResources().getDisplayMetrics().density;
        int clickable = 0;
        for (View view : all(activity.getWindow().getDecorView())) {
            // selectable texts take clicks, too, but do nothing on them
            boolean text = view instanceof TextView && ((TextView) view).isTextSelectable();
            if (!view.isClickable() || !view.isShown() || text) {
                continue;
            }
            clickable++;
            String name = where + ": " + view;
            CharSequence label = view.getContentDescription() != null ? view.getContentDescription()
                    : view instanceof TextView ? ((TextView) view).getText() : "";
            assertTrue(name + " has a label", label.toString().trim().length() > 1);
            assertTrue(name + " is " + view.getWidth() / density + " dp wide", view.getWidth() >= TOUCH_DP * density);
            assertTrue(name + " is " + view.getHeight() / density + " dp high", view.getHeight() >= TOUCH_DP * density);
        }
        return clickable;
    }

    /** Nothing is cut off: what is too long can be scrolled to. */
    static void assertWhole(Activity activity, String where) {
        for (View view : all(activity.getWindow().getDecorView())) {
            if (!(view instanceof TextView) || !view.isShown() || ((TextView) view).getLayout() == null) {
                continue;
            }
            TextView text = (TextView) view;
            String name = where + ": " + text.getText();
            int room = text.getHeight() - text.getCompoundPaddingTop() - text.getCompoundPaddingBottom();
            assertTrue(name, text.getLayout().getHeight() <= room + 1);
            for (int line = 0; line < text.getLineCount(); line++) {
                assertEquals(name, 0, text.getLayout().getEllipsisCount(line));
            }
        }
    }

    @Test
    public void everythingToTapHasALabelAndRoomForAFinger() {
        for (String qualifiers : new String[] {Screen.TABLET_LANDSCAPE, Screen.TABLET_PORTRAIT, Screen.PHONE_LANDSCAPE,
            Screen.PHONE_PORTRAIT}) {
            for (float scale : new float[] {1, 2}) {
                RuntimeEnvironment.setQualifiers(qualifiers);
                RuntimeEnvironment.setFontScale(scale);
                String where = qualifiers + " at " + scale;
                try (Screen screen = Screen.start()) {
                    assertTouchable(screen, where + ", first start");
                    screen.chooseCell(Fixture.LIFTED.document());
                    assertTouchable(screen, where + ", permission");
                }
            }
        }
        RuntimeEnvironment.setFontScale(1);
        RuntimeEnvironment.setQualifiers(Screen.PHONE_PORTRAIT);
        try (Screen screen = Screen.live(Fixture.LIFTED.document(), 90, false)) {
            screen.holdStillUntilResult(Fixture.LIFTED);
            assertTouchable(screen, "result");
            Screen.app().feed.fault(CameraFault.IN_USE);
            screen.settle();
            assertTouchable(screen, "lost camera");
        }
    }

    /** Nothing is cut off at twice the size of letters: what is too long can be scrolled to. */
    @Test
    public void noTextIsCutOffAtTwiceTheSize() {
        for (String qualifiers : new String[] {Screen.TABLET_LANDSCAPE, Screen.PHONE_LANDSCAPE, Screen.PHONE_PORTRAIT,
            "de-" + Screen.PHONE_PORTRAIT, "de-" + Screen.PHONE_LANDSCAPE}) {
            RuntimeEnvironment.setQualifiers(qualifiers);
            RuntimeEnvironment.setFontScale(2);
            Screen.turnDisplay(qualifiers.contains("-land") ? Surface.ROTATION_90 : Surface.ROTATION_0);
            try (Screen screen = Screen.live(Fixture.LIFTED.document(), 90, false)) {
                screen.holdStillUntilResult(Fixture.LIFTED);
                assertWhole(screen.activity(), qualifiers);
                View picture = screen.find(R.id.viewport);
                assertTrue(qualifiers + ": the picture is " + picture.getHeight() + " px high",
                        picture.getHeight() > 100 && picture.getWidth() > 100);
            }
        }
    }

    @Test
    public void licencesAreReadableAtTwiceTheSize() {
        for (String qualifiers : new String[] {Screen.TABLET_LANDSCAPE, Screen.PHONE_PORTRAIT,
            "de-" + Screen.PHONE_LANDSCAPE}) {
            RuntimeEnvironment.setQualifiers(qualifiers);
            RuntimeEnvironment.setFontScale(2);
            try (Screen screen = Screen.start()) {
                RowList rows = screen.find(R.id.rows);
                rows.getChildAt(rows.getChildCount() - 1).findViewById(R.id.row_action).performClick();
                AlertDialog dialog = (AlertDialog) ShadowDialog.getLatestDialog();
                TextView text = dialog.findViewById(R.id.licences_text);
                screen.until("licences", () -> text.length() > 1000);
                View page = dialog.findViewById(R.id.licences_page);
                float density = screen.activity().getResources().getDisplayMetrics().density;
                // Android 14 enlarges letters the less the larger they are
                assertTrue(qualifiers + ": " + text.getTextSize(), text.getTextSize() >= 1.8 * 14 * density);
                assertTrue(qualifiers + ": " + page.getHeight() / density + " dp of it are seen",
                        page.getHeight() >= 120 * density);
                assertTrue(qualifiers + ": what is below can be scrolled to", page.canScrollVertically(1));
                int room = text.getHeight() - text.getCompoundPaddingTop() - text.getCompoundPaddingBottom();
                assertTrue(qualifiers, text.getLayout().getHeight() <= room + 1);
                for (int line = 0; line < text.getLineCount(); line++) {
                    assertTrue(qualifiers + ", line " + line,
                            text.getLayout().getLineMax(line) <= text.getLayout().getWidth() + 1);
                }
                View close = dialog.getButton(AlertDialog.BUTTON_POSITIVE);
                assertTrue(qualifiers, close.isShown() && close.getHeight() >= TOUCH_DP * density);
                dialog.dismiss();
            }
        }
    }

    @Test
    public void pictureIsSpokenPolitelyAndOnlyWhenSomethingMatters() {
        Screen.app().levels.onNext(ThermalLevel.HOT);
        RuntimeEnvironment.setQualifiers(Screen.TABLET_LANDSCAPE);
        try (Screen screen = Screen.live(Fixture.LIFTED.document(), 90, false)) {
            OverlayView overlay = screen.find(R.id.overlay);
            assertEquals(View.ACCESSIBILITY_LIVE_REGION_POLITE, overlay.getAccessibilityLiveRegion());
            Screen.app().feed.frame(Fixture.LIFTED.image());
            screen.until("quick look", () -> screen.state().phase() == LiveState.Phase.QUICK_LOOK);
            assertEquals("Picture. Preliminary – quick look. Object 5 preliminary. Object 20 preliminary. "
                    + "Object 30 preliminary.", Screen.plain(overlay.getContentDescription()));
            CharSequence before = overlay.getContentDescription();
            screen.until("another frame", () -> {
                // a hot device drops most of them
                Screen.app().feed.frame(Fixture.LIFTED.image());
                return screen.state().live().frameNumber() > 1;
            });
            assertTrue("said once", before == overlay.getContentDescription());
            Screen.app().levels.onNext(ThermalLevel.NORMAL);
            Screen.app().feed.frame(Fixture.LIFTED.image());
            screen.until("result", () -> screen.state().verdict() != null);
            assertEquals("Picture. Pass – target met. Object 5 deviation within 3 mm. Object 20 deviation within 3 mm. "
                    + "Object 30 deviation within 3 mm.", Screen.plain(overlay.getContentDescription()));
        }
    }

    /** A verdict is known by its word and by its sign, whatever its colour. */
    @Test
    public void verdictsDifferInWordAndSign() {
        Set<Integer> words = new HashSet<>();
        Set<Integer> signs = new HashSet<>();
        Banner[] verdicts = {Banner.PASS, Banner.FAIL, Banner.NOT_CONVERGED, Banner.AMBIGUOUS, Banner.NO_TARGET};
        for (Banner verdict : verdicts) {
            words.add(verdict.headline());
            signs.add(verdict.mark());
        }
        assertEquals(verdicts.length, words.size());
        assertEquals(verdicts.length, signs.size());
        Map<ObjectRow.Mark, Integer> marks = new EnumMap<>(ObjectRow.Mark.class);
        for (ObjectRow.Mark mark : ObjectRow.Mark.values()) {
            marks.put(mark, ObjectRows.drawable(mark));
        }
        assertEquals(marks.size(), new HashSet<>(marks.values()).size());
    }

    @Test
    public void textsAndSignsStandOutInBothThemes() {
        for (String night : new String[] {"notnight", "night"}) {
            RuntimeEnvironment.setQualifiers(Screen.TABLET_LANDSCAPE.replace("notnight", night));
            try (Screen screen = Screen.start()) {
                Resources resources = screen.activity().getResources();
                for (int surface : new int[] {R.color.surface, R.color.card}) {
                    for (int text : new int[] {R.color.text, R.color.text_secondary, R.color.accent}) {
                        assertContrast(resources, night, text, surface, TEXT_CONTRAST);
                    }
                    for (int sign : new int[] {R.color.mark_pass, R.color.mark_fail, R.color.mark_not_converged,
                        R.color.mark_ambiguous, R.color.mark_neutral}) {
                        assertContrast(resources, night, sign, surface, SIGN_CONTRAST);
                    }
                }
                for (int banner : new int[] {R.color.banner_pass, R.color.banner_fail, R.color.banner_not_converged,
                    R.color.banner_ambiguous, R.color.banner_neutral, R.color.banner_idle}) {
                    assertContrast(resources, night, R.color.on_banner, banner, TEXT_CONTRAST);
                }
                assertContrast(resources, night, R.color.on_accent, R.color.accent, TEXT_CONTRAST);
                assertContrast(resources, night, R.color.on_viewport, R.color.viewport, TEXT_CONTRAST);
            }
        }
    }

    private static void assertContrast(Resources resources, String night, int front, int back, double least) {
        double a = Color.luminance(resources.getColor(front, null));
        double b = Color.luminance(resources.getColor(back, null));
        double contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
        assertTrue(night + " " + resources.getResourceEntryName(front) + " on "
                + resources.getResourceEntryName(back) + ": " + contrast, contrast >= least);
    }
}
