package org.cellgauge.android.screen;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertTrue;

import android.app.AlertDialog;
import android.graphics.drawable.ColorDrawable;
import android.view.Surface;
import android.view.View;
import android.widget.EditText;
import android.widget.ProgressBar;
import android.widget.TextView;
import java.util.OptionalDouble;
import org.cellgauge.android.R;
import org.cellgauge.android.camera.CameraModelSource;
import org.cellgauge.android.files.CellDocument;
import org.cellgauge.android.state.CheckScreenState;
import org.cellgauge.android.state.ObjectRow;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.Requirement;
import org.cellgauge.cell.Target;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.Verdict;
import org.cellgauge.settings.Estimate;
import org.cellgauge.vision.GreyImage;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.annotation.Config;
import org.robolectric.shadows.ShadowDialog;

/** The checker in a technician's hands: what stays, what is said first, how large the picture is, what a tap tells. */
@RunWith(RobolectricTestRunner.class)
@Config(application = TestApp.class, minSdk = 27)
public class HandheldTest {
    private static final Fixture FIXTURE = Fixture.LIFTED;

    private static Screen live() {
        RuntimeEnvironment.setQualifiers(Screen.TABLET_LANDSCAPE);
        Screen.turnDisplay(Surface.ROTATION_90);
        return Screen.live(FIXTURE.document(), 90, false);
    }

    /** The picture as a camera sees it that was turned a little: all of it lies elsewhere. */
    private static GreyImage shifted(GreyImage image, int toRightPx, int downPx) {
        byte[] from = image.luminance();
        byte[] to = new byte[image.widthPx() * image.heightPx()];
        for (int y = 0; y < image.heightPx(); y++) {
            for (int x = 0; x < image.widthPx(); x++) {
                int u = Math.max(0, Math.min(image.widthPx() - 1, x - toRightPx));
                int v = Math.max(0, Math.min(image.heightPx() - 1, y - downPx));
                to[y * image.widthPx() + x] = from[v * image.widthPx() + u];
            }
        }
        return GreyImage.packed(to, image.widthPx(), image.heightPx());
    }

    private static void feedUntil(Screen screen, GreyImage image, long after) {
        screen.until("another frame", () -> {
            Screen.app().feed.frame(image);
            return screen.state().live().frameNumber() > after;
        });
    }

    private static RowTexts row(Screen screen, int objectId) {
        RowList rows = screen.find(R.id.rows);
        for (int i = 0; i < rows.getChildCount(); i++) {
            View row = rows.getChildAt(i);
            TextView title = row.findViewById(R.id.row_title);
            if (title.getText().toString().startsWith("Object " + objectId + " ")) {
                return new RowTexts(row);
            }
        }
        throw new AssertionError("no row of object " + objectId);
    }

    /** One row of the list. */
    private static final class RowTexts {
        private final View row;

        RowTexts(View row) {
            this.row = row;
        }

        String text(int id) {
            TextView view = row.findViewById(id);
            return view.getVisibility() == View.VISIBLE ? Screen.plain(view.getText()) : "";
        }
    }

    // ---- what stays

    @Test
    public void theLastVerdictStaysAndCanBeKeptWhileTheCameraMoves() {
        try (Screen screen = live()) {
            screen.holdStillUntilResult(FIXTURE);
            CheckResult found = screen.state().result();
            int green = ((ColorDrawable) screen.find(R.id.banner).getBackground()).getColor();
            // once seen elsewhere, chains have not begun
            feedUntil(screen, shifted(FIXTURE.image(), 60, 20), screen.state().live().frameNumber());
            assertNull(screen.state().result());
            assertTrue(screen.text(R.id.banner_headline),
                    screen.text(R.id.banner_headline).matches("Pass – target met \\(of \\d+ s ago\\)"));
            assertTrue("dimmed", green != ((ColorDrawable) screen.find(R.id.banner).getBackground()).getColor());
            assertTrue(screen.text(R.id.banner_next), screen.text(R.id.banner_next).startsWith("The camera has moved"));
            screen.keep("held-verdict", FIXTURE.photo());
            assertEquals(ObjectRow.Mark.OK, screen.state().objects().get(0).mark());
            screen.tap(R.id.save);
            screen.until("saved", () -> screen.state().showsSaved());
            assertSame(found, Screen.app().archive.results.get(0));
            assertEquals(found.detections().imageName(), Screen.app().archive.photos.get(0).name());
            // another target judges what is shown
            screen.session().chooseTarget(Target.ofStdMm(OptionalDouble.of(0.3)));
            screen.settle();
            assertTrue(screen.text(R.id.banner_headline),
                    screen.text(R.id.banner_headline).startsWith("Target missed"));
            // a new one takes its place
            screen.until("result", () -> {
                Screen.app().feed.frame(shifted(FIXTURE.image(), 60, 20));
                return screen.state().verdict() != null;
            });
            assertNull(screen.state().held());
            assertEquals(screen.activity().getString(Banner.of(screen.state().verdict()).headline()),
                    screen.text(R.id.banner_headline));
        }
    }

    @Test
    public void saveKeepsWhatWasOnTheScreenWhenItWasTapped() {
        try (Screen screen = live()) {
            screen.holdStillUntilResult(FIXTURE);
            CheckScreenState seen = screen.shown();
            screen.session().chooseTarget(Target.ofStdMm(OptionalDouble.of(0.3)));
            assertTrue("the session is further", seen.result() != screen.state().result());
            screen.session().save(seen);
            screen.until("saved", () -> screen.state().saved() != null);
            assertSame(seen.result(), Screen.app().archive.results.get(0));
            assertEquals(Verdict.PASS, Screen.app().archive.results.get(0).verdict());
        }
    }

    @Test
    public void whatIsDrawnGoesWithTheHand() {
        try (Screen screen = live()) {
            screen.holdStillUntilResult(FIXTURE);
            CheckResult found = screen.state().result();
            feedUntil(screen, shifted(FIXTURE.image(), 7, -3), screen.state().live().frameNumber());
            assertSame("some pixels are no other view", found, screen.state().result());
            double[] shift = screen.state().overlayShiftPx();
            // the sensor's picture lies as the display does at this turn
            assertEquals(7, shift[0], 0.2);
            assertEquals(-3, shift[1], 0.2);
        }
    }

    // ---- what is said first

    @Test
    public void whatToDoNextStandsUnderTheVerdict() {
        Cell doubtful = FIXTURE.doubtful();
        try (Screen screen = Screen.start()) {
            screen.chooseCell(FIXTURE.document(doubtful));
            screen.openPhoto(FIXTURE.photo());
            screen.until("result", () -> screen.state().verdict() != null);
            String next = screen.text(R.id.banner_next);
            assertTrue(next, next.matches("Reference 22 seems off by 2\\d\\.\\d mm: measure it again\\."));
        }
    }

    @Test
    public void aMissedTargetComesWithWhatWouldMeetIt() {
        try (Screen screen = live()) {
            screen.holdStillUntilResult(FIXTURE);
            screen.session().chooseTarget(Target.ofStdMm(OptionalDouble.of(0.6)));
            screen.until("advice", () -> screen.state().advice() != null);
            String next = screen.text(R.id.banner_next);
            screen.tap(R.id.figures);
            screen.keep("figures-and-advice", FIXTURE.photo());
            assertTrue(next, next.matches("To meet the target: .* \\(largest deviation of .* → \\d\\.\\d\\d mm\\)\\."));
            assertTrue(screen.state().advice().view().worstStdMm() <= 0.6);
            screen.session().chooseTarget(Target.ofStdMm(OptionalDouble.of(3)));
            screen.settle();
            assertNull("nothing is to be met any more", screen.state().advice());
            assertEquals("", screen.text(R.id.banner_next));
        }
    }

    @Test
    public void aBarSaysHowMuchOfTheTargetIsTaken() {
        try (Screen screen = live()) {
            screen.holdStillUntilResult(FIXTURE);
            ObjectRow object = screen.state().objects().get(0);
            double[] std = object.stdMm();
            double most = Math.max(std[0], Math.max(std[1], std[2]));
            RowTexts row = row(screen, object.id());
            assertTrue(row.text(R.id.row_bar_text),
                    row.text(R.id.row_bar_text).startsWith(String.format("σ %.1f of 3 mm", most)));
            ProgressBar bar = row.row.findViewById(R.id.row_bar);
            assertEquals(most / 3, (double) bar.getProgress() / bar.getMax(), 0.001);
            // what the picture's ellipse holds
            assertTrue(row.text(R.id.row_figures), row.text(R.id.row_figures)
                    .contains(String.format("95%% within x ±%.2f", 1.96 * std[0])));
        }
    }

    // ---- lenses that nobody measured

    @Test
    public void noGreenForALensThatNobodyMeasured() {
        RuntimeEnvironment.setQualifiers(Screen.TABLET_LANDSCAPE);
        Screen.allowCamera();
        try (Screen screen = Screen.start()) {
            screen.chooseCell(new CellDocument("bare.yaml", "content://cells/bare",
                    FIXTURE.cell().withTarget(Target.ofStdMm(OptionalDouble.of(100))), null));
            Screen.app().feed.opened(FIXTURE.cell().camera(), CameraModelSource.DEVICE_CALIBRATION, 90, false);
            screen.settle();
            screen.holdStillUntilResult(FIXTURE);
            assertEquals(Verdict.PASS, screen.state().verdict());
            assertEquals(Banner.PASS_UNMEASURED, Banner.of(screen.shown()));
            assertEquals("Target met – but the lens is not calibrated", screen.text(R.id.banner_headline));
            int colour = ((ColorDrawable) screen.find(R.id.banner).getBackground()).getColor();
            assertTrue(colour != screen.activity().getColor(R.color.banner_pass));
            assertTrue(screen.text(R.id.banner_next),
                    screen.text(R.id.banner_next).startsWith("Calibrate this camera"));
            screen.keep("lens-not-calibrated", FIXTURE.photo());
            screen.tap(R.id.save);
            screen.until("saved", () -> screen.state().showsSaved());
            assertTrue(screen.text(R.id.caption), screen.text(R.id.caption).startsWith("Saved as lifted-4-1"));
            assertEquals(Estimate.INTRINSICS, Screen.app().archive.results.get(0).settings().model().estimate());
        }
    }

    // ---- targets

    private static void set(AlertDialog dialog, int id, String text) {
        ((EditText) dialog.findViewById(id)).setText(text);
    }

    @Test
    public void aTargetIsAToleranceWithAProbability() {
        try (Screen screen = live()) {
            screen.holdStillUntilResult(FIXTURE);
            screen.tap(R.id.target);
            AlertDialog dialog = (AlertDialog) ShadowDialog.getLatestDialog();
            set(dialog, R.id.target_tolerance, "2.5");
            set(dialog, R.id.target_probability, "100");
            set(dialog, R.id.target_field, "");
            dialog.getButton(AlertDialog.BUTTON_POSITIVE).performClick();
            screen.settle();
            assertNotNull(((EditText) dialog.findViewById(R.id.target_probability)).getError());
            set(dialog, R.id.target_probability, "90");
            dialog.getButton(AlertDialog.BUTTON_POSITIVE).performClick();
            screen.settle();
            assertFalse(dialog.isShowing());
            Requirement asked = screen.state().target().general();
            assertEquals(Requirement.Axes.all(2.5), asked.toleranceMm());
            assertEquals(0.9, asked.probability(), 1e-12);
            assertFalse(asked.stdMm().isAny());
            assertEquals(Verdict.PASS, screen.state().verdict());
            RowTexts row = row(screen, 5);
            assertTrue(row.text(R.id.row_bar_text), row.text(R.id.row_bar_text)
                    .matches("(gripping point: )?[\\d.]+ % within 2.5 mm along [xyz]; 90 % asked for"));
            assertEquals("Object 5 – target met", row.text(R.id.row_title));
            // it survives the end of the process
            try (Screen again = Screen.start(screen.killed())) {
                assertEquals(asked, again.state().target().general());
            }
        }
    }

    // ---- the picture

    private static double share(Screen screen, int id) {
        View picture = screen.find(id);
        View all = screen.activity().getWindow().getDecorView();
        return (double) picture.getWidth() * picture.getHeight() / all.getWidth() / all.getHeight();
    }

    @Test
    public void thePictureFillsTheScreenUntilFiguresAreAskedFor() {
        for (String qualifiers : new String[] {Screen.TABLET_LANDSCAPE, Screen.TABLET_PORTRAIT}) {
            RuntimeEnvironment.setQualifiers(qualifiers);
            Screen.turnDisplay(qualifiers.contains("-land") ? Surface.ROTATION_90 : Surface.ROTATION_0);
            try (Screen screen = Screen.live(FIXTURE.document(), 90, false)) {
                screen.holdStillUntilResult(FIXTURE);
                assertTrue(qualifiers + ": " + share(screen, R.id.viewport), share(screen, R.id.viewport) > 0.6);
                screen.tap(R.id.figures);
                assertTrue(screen.find(R.id.rows).isShown());
                assertTrue(share(screen, R.id.viewport) < 0.6);
                screen.recreate();
                assertTrue("asked for is asked for", screen.find(R.id.rows).isShown());
                screen.tap(R.id.figures);
                assertFalse(screen.find(R.id.rows).isShown());
            }
        }
    }

    @Test
    public void twoFingersEnlargeThePictureAboutTheirMiddle() {
        try (Screen screen = live()) {
            screen.holdStillUntilResult(FIXTURE);
            ZoomLayout room = screen.find(R.id.view_area);
            View picture = screen.find(R.id.viewport);
            float x = picture.getLeft() + picture.getWidth() / 2f + 100;
            float y = picture.getTop() + picture.getHeight() / 2f + 50;
            room.zoom(3, x, y);
            assertEquals(3, picture.getScaleX(), 1e-6);
            // the point under the fingers has stayed: it was 100 px right of the middle, and is enlarged 300
            assertEquals(x, picture.getLeft() + picture.getWidth() / 2f + picture.getTranslationX() + 300, 0.01);
            assertEquals(y, picture.getTop() + picture.getHeight() / 2f + picture.getTranslationY() + 150, 0.01);
            room.zoom(0.1f, x, y);
            assertEquals("never smaller than whole", 1, picture.getScaleX(), 0);
            assertEquals(0, picture.getTranslationX(), 0);
            room.zoom(100, x, y);
            assertEquals(ZoomLayout.LARGEST, picture.getScaleX(), 0);
        }
    }

    @Test
    public void aTapOnAnObjectTellsAllOfItAndLetsItNotCount() {
        try (Screen screen = live()) {
            screen.holdStillUntilResult(FIXTURE);
            double[] corners = screen.state().live().keyFrame().find(20).cornersPx();
            double u = (corners[0] + corners[2] + corners[4] + corners[6]) / 4;
            double v = (corners[1] + corners[3] + corners[5] + corners[7]) / 4;
            ZoomLayout room = screen.find(R.id.view_area);
            View picture = screen.find(R.id.viewport);
            // frames of 1280 px fill the view as they come at this turn of the display
            float scale = picture.getWidth() / 1280f;
            room.zoom(2, room.getWidth() / 2f, room.getHeight() / 2f);
            float middleX = picture.getLeft() + picture.getWidth() / 2f;
            float middleY = picture.getTop() + picture.getHeight() / 2f;
            room.tap((float) (middleX + 2 * (u * scale - picture.getWidth() / 2f)),
                    (float) (middleY + 2 * (v * scale - picture.getHeight() / 2f)));
            screen.settle();
            AlertDialog dialog = (AlertDialog) ShadowDialog.getLatestDialog();
            String text = Screen.plain(((TextView) dialog.findViewById(android.R.id.message)).getText());
            Screen.write("object-dialog", Screen.picture(dialog.getWindow().getDecorView()));
            screen.keep("enlarged", FIXTURE.photo());
            assertTrue(text, text.contains("95% ellipse: semi-axes"));
            assertTrue(text, text.contains("What the variance of its position comes from:"));
            assertTrue(text, text.contains("noise in the object's own corners"));
            assertTrue(text, text.contains("What that of the gripping point comes from:"));
            dialog.getButton(AlertDialog.BUTTON_NEUTRAL).performClick();
            screen.settle();
            assertEquals("Object 20 – does not count", row(screen, 20).text(R.id.row_title));
            assertEquals(Requirement.NONE, screen.state().target().of(20));
            assertTrue(screen.state().target().of(5).isAny());
            screen.session().count(20, true);
            screen.settle();
            assertEquals(screen.state().cell().cell().target(), screen.state().target());
        }
    }

    @Test
    public void anObjectHasATargetOfItsOwn() {
        try (Screen screen = live()) {
            screen.holdStillUntilResult(FIXTURE);
            row(screen, 30).row.performClick();
            screen.settle();
            ((AlertDialog) ShadowDialog.getLatestDialog()).getButton(AlertDialog.BUTTON_POSITIVE).performClick();
            screen.settle();
            AlertDialog dialog = (AlertDialog) ShadowDialog.getLatestDialog();
            set(dialog, R.id.target_field, "0.2");
            dialog.getButton(AlertDialog.BUTTON_POSITIVE).performClick();
            screen.settle();
            assertEquals(Verdict.FAIL, screen.state().verdict());
            assertEquals("Object 30 – deviation beyond 0.2 mm", row(screen, 30).text(R.id.row_title));
            assertEquals("Object 5 – deviation within 3 mm", row(screen, 5).text(R.id.row_title));
        }
    }
}
