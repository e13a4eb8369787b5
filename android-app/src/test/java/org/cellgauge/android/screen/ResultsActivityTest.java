package org.cellgauge.android.screen;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;
import static org.robolectric.Shadows.shadowOf;

import android.app.AlertDialog;
import android.content.Intent;
import android.net.Uri;
import android.os.Looper;
import android.view.View;
import android.widget.ImageView;
import android.widget.TextView;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.time.Clock;
import java.time.Instant;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;
import org.cellgauge.android.R;
import org.cellgauge.android.files.FolderArchive;
import org.cellgauge.android.files.SavedResult;
import org.cellgauge.cell.Cell;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.output.ResultView;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.BoofMarkerDetector;
import org.junit.After;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.Robolectric;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.android.controller.ActivityController;
import org.robolectric.annotation.Config;
import org.robolectric.shadows.ShadowDialog;

/** Kept results on the screen, as the app's own archive keeps them. */
@RunWith(RobolectricTestRunner.class)
@Config(application = TestApp.class, qualifiers = Screen.TABLET_LANDSCAPE, minSdk = 27)
public class ResultsActivityTest {
    private static final Fixture FIXTURE = Fixture.LIFTED;
    private static final int PATIENCE_MS = 30_000;

    private ActivityController<ResultsActivity> controller;

    @After
    public void close() {
        if (controller != null) {
            controller.pause().stop().destroy();
        }
    }

    private static FolderArchive archive(String time) {
        FolderArchive archive = new FolderArchive(Screen.app(), OverlayPainter::paint, new ScreenWords(Screen.app()),
                Clock.fixed(Instant.parse(time), ZoneOffset.UTC), "1");
        Screen.app().folders = archive;
        return archive;
    }

    private static CheckResult check(Cell cell, CheckSettings settings) {
        return CellCheck.run(cell, BoofMarkerDetector.forCell(cell).detect(FIXTURE.image(), "photo"), settings);
    }

    private static SavedResult keep(CheckResult result, String time, String cellName) throws IOException {
        SavedResult saved = archive(time).save(FIXTURE.photo(), result, cellName);
        // one second is as long as a folder's time may be coarse
        File folder = new File(Screen.app().getFilesDir(), "results/" + saved.name());
        assertTrue(folder.setLastModified(Instant.parse(time).toEpochMilli()));
        return saved;
    }

    /** Corners as noisy as stated: before the light was better, and after it. */
    private static CheckResult noisy(double pixelStdPx, double targetMm) {
        return check(Fixture.with(FIXTURE.cell(), pixelStdPx, OptionalDouble.of(targetMm)),
                CheckSettings.builder().build());
    }

    private void keepBeforeAndAfter() throws IOException {
        keep(noisy(0.04, 0.3), "2024-05-17T12:30:05Z", "kitchen.yaml");
        keep(noisy(0.02, 3), "2024-05-18T08:00:00Z", "kitchen.yaml");
    }

    private void open() {
        Screen.backIsOwn();
        controller = Robolectric.buildActivity(ResultsActivity.class).setup();
        until("results", () -> !"Reading the results…".contentEquals(text(R.id.results_empty))
                || find(R.id.results_empty).getVisibility() == View.GONE);
    }

    private <T extends View> T find(int id) {
        return controller.get().findViewById(id);
    }

    private String text(int id) {
        return Screen.plain(((TextView) find(id)).getText());
    }

    private void until(String what, BooleanSupplier condition) {
        long end = System.currentTimeMillis() + PATIENCE_MS;
        shadowOf(Looper.getMainLooper()).idle();
        while (!condition.getAsBoolean()) {
            if (System.currentTimeMillis() > end) {
                fail(what + " does not come: " + rows());
            }
            try {
                Thread.sleep(5);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
            shadowOf(Looper.getMainLooper()).idle();
        }
    }

    private List<String> rows() {
        RowList list = find(R.id.results_rows);
        List<String> rows = new ArrayList<>();
        for (int i = 0; i < list.getChildCount(); i++) {
            StringBuilder text = new StringBuilder();
            for (int id : new int[] {R.id.row_title, R.id.row_figures, R.id.row_text}) {
                TextView view = list.getChildAt(i).findViewById(id);
                text.append(view.getVisibility() == View.VISIBLE ? Screen.plain(view.getText()) + "\n" : "");
            }
            rows.add(text.toString());
        }
        return rows;
    }

    private void tapRow(int place) {
        ((RowList) find(R.id.results_rows)).getChildAt(place).performClick();
        shadowOf(Looper.getMainLooper()).idle();
    }

    private void tap(int id) {
        assertTrue(find(id).isShown() && find(id).isEnabled());
        find(id).performClick();
        shadowOf(Looper.getMainLooper()).idle();
    }

    private static String row(List<String> rows, String beginning) {
        for (String row : rows) {
            if (row.startsWith(beginning)) {
                return row;
            }
        }
        throw new AssertionError("no row " + beginning + " in " + rows);
    }

    private static String mm(double value) {
        return String.format(Locale.ROOT, "%.2f", value);
    }

    // ---- the list and one of it

    @Test
    @Config(minSdk = 26)
    public void listTellsTimeVerdictCellAndName() throws IOException {
        keepBeforeAndAfter();
        open();
        assertEquals("Kept results", text(R.id.heading_title));
        assertEquals(2, rows().size());
        assertTrue(rows().get(0), rows().get(0).matches("May 18, 2024,? 8:00:00.AM\nPass – target met\n"
                + "kitchen.yaml · cellgauge-20240518-080000\n"));
        assertTrue(rows().get(1), rows().get(1).matches("May 17, 2024,? 12:30:05.PM\nTarget missed\n"
                + "kitchen.yaml · cellgauge-20240517-123005\n"));
        assertFalse(find(R.id.results_bar).isShown());
    }

    @Test
    public void emptyListSaysHowToKeepOne() {
        archive("2024-05-17T12:30:05Z");
        open();
        assertTrue(text(R.id.results_empty), text(R.id.results_empty).startsWith("No result was kept yet. Save keeps"));
    }

    @Test
    @Config(minSdk = 26)
    public void openedResultShowsItsPictureAndItsFigures() throws IOException {
        CheckResult result = noisy(0.02, 3);
        keep(result, "2024-05-18T08:00:00Z", "kitchen.yaml");
        open();
        tapRow(0);
        ImageView picture = find(R.id.results_picture);
        until("picture", () -> picture.getDrawable() != null);
        assertEquals(FIXTURE.image().widthPx(), picture.getDrawable().getIntrinsicWidth());
        assertTrue(find(R.id.results_zoom).isShown());
        double[] std = result.estimate().object(5).pose().std();
        String object = row(rows(), "Object 5 – deviation within 3 mm\n");
        assertTrue(object, object.contains("x " + mm(std[0]) + " · y " + mm(std[1]) + " · z " + mm(std[2]) + " mm"));
        assertTrue(object, object.contains("What the variance of its position comes from:"));
        assertTrue(rows().get(0), rows().get(0).contains("Target: a standard deviation of at most 3 mm"));
        assertTrue("back has a use", Screen.back(controller.get()));
        assertFalse(find(R.id.results_zoom).isShown());
        assertEquals(1, rows().size());
        // from the list it is the system's, which ends the screen; before Android 13 the screen ends itself
        assertTrue(!Screen.back(controller.get()) || controller.get().isFinishing());
    }

    @Test
    public void resultWithoutFiguresToTrustShowsNone() throws IOException {
        keep(check(FIXTURE.cell(), CheckSettings.builder().iterations(260).build()), "2024-05-18T08:00:00Z", "a.yaml");
        open();
        tapRow(0);
        String all = String.join("", rows());
        assertTrue(all, all.contains("Not converged – no figure to trust"));
        assertTrue(all, all.contains("Object 5 – not converged"));
        assertFalse(all, all.contains("σ"));
    }

    @Test
    public void damagedResultIsListedAndCanBeDeleted() throws IOException {
        SavedResult saved = keep(noisy(0.02, 3), "2024-05-18T08:00:00Z", "kitchen.yaml");
        File folder = new File(Screen.app().getFilesDir(), "results/" + saved.name());
        Files.write(new File(folder, saved.name() + ".result.json").toPath(), new byte[] {'{'});
        open();
        assertTrue(rows().get(0), rows().get(0).contains("the result file is missing, damaged or of another version"));
        tapRow(0);
        assertFalse(find(R.id.results_compare).isEnabled());
        delete(AlertDialog.BUTTON_POSITIVE);
        until("deletion", () -> rows().isEmpty());
        assertFalse(folder.exists());
    }

    // ---- before and after

    @Test
    @Config(minSdk = 26)
    public void twoResultsAreComparedObjectByObject() throws IOException {
        CheckResult first = noisy(0.04, 0.3);
        CheckResult second = noisy(0.02, 3);
        keep(first, "2024-05-17T12:30:05Z", "kitchen.yaml");
        keep(second, "2024-05-18T08:00:00Z", "kitchen.yaml");
        open();
        // the earlier one stands first, whichever was opened first
        tapRow(0);
        tap(R.id.results_compare);
        assertEquals("Compare with which one?", text(R.id.heading_title));
        assertEquals("the opened one is not offered", 1, rows().size());
        tapRow(0);
        assertEquals("Before and after", text(R.id.heading_title));
        assertTrue(rows().get(0), rows().get(0).startsWith("Before: May 17, 2024"));
        assertTrue(rows().get(0), rows().get(0).contains("Target missed\n"));
        assertTrue(rows().get(1), rows().get(1).startsWith("After: May 18, 2024"));
        assertTrue(rows().get(1), rows().get(1).contains("Pass – target met\n"));
        for (int id : new int[] {5, 20, 30}) {
            double[] was = first.estimate().object(id).pose().std();
            double[] is = second.estimate().object(id).pose().std();
            String row = row(rows(), "Object " + id + " – ");
            assertTrue(row, row.contains("before\nσ  x " + mm(was[0]) + " · y " + mm(was[1]) + " · z " + mm(was[2])));
            assertTrue(row, row.contains("after\nσ  x " + mm(is[0]) + " · y " + mm(is[1]) + " · z " + mm(is[2])));
            ResultView before = ResultView.of(first);
            ResultView after = ResultView.of(second);
            double largestBefore = before.worstStdMm(before.object(id));
            double largestAfter = after.worstStdMm(after.object(id));
            assertTrue(row, row.contains("Largest deviation: before " + mm(largestBefore) + ", after "
                    + mm(largestAfter) + " mm."));
            boolean smaller = largestAfter < 0.9 * largestBefore;
            assertEquals(row, smaller, row.startsWith("Object " + id + " – smaller after\n"));
            assertTrue(row, row.contains("Before: deviation beyond 0.3 mm. After: deviation within 3 mm."));
        }
        assertTrue("better light helps at least one", String.join("", rows()).contains("smaller after"));
        assertTrue("back has a use", Screen.back(controller.get()));
        assertTrue("back to the one that was opened", find(R.id.results_bar).isShown());
    }

    @Test
    public void sameFiguresAreNoDifference() throws IOException {
        CheckResult result = noisy(0.02, 3);
        keep(result, "2024-05-17T12:30:05Z", "kitchen.yaml");
        keep(check(result.cell(), CheckSettings.builder().seed(99).build()), "2024-05-18T08:00:00Z", "kitchen.yaml");
        open();
        tapRow(1);
        tap(R.id.results_compare);
        tapRow(0);
        for (int id : new int[] {5, 20, 30}) {
            assertTrue(rows().toString(), row(rows(), "Object " + id).startsWith(
                    "Object " + id + " – no difference beyond the Monte Carlo error\n"));
        }
    }

    @Test
    public void resultWithoutFiguresIsComparedWithoutFigures() throws IOException {
        keep(noisy(0.02, 3), "2024-05-17T12:30:05Z", "kitchen.yaml");
        keep(check(FIXTURE.doubtful(), CheckSettings.builder().iterations(260).build()), "2024-05-18T08:00:00Z",
                "hall.yaml");
        open();
        tapRow(0);
        tap(R.id.results_compare);
        tapRow(0);
        String row = row(rows(), "Object 5");
        assertTrue(row, row.startsWith("Object 5 – cannot be compared\nbefore\nσ "));
        assertFalse(row, row.contains("\nafter\n"));
        assertTrue(row, row.contains("Before: deviation within 3 mm. After: not converged."));
        assertTrue(row(rows(), "Object 77"), row(rows(), "Object 77").contains(
                "Before: not in the cell file. After: not in view."));
    }

    // ---- sharing, deleting, turning

    @Test
    @SuppressWarnings("deprecation")
    public void openedResultIsSharedWithAllItsFiles() throws IOException {
        SavedResult saved = keep(noisy(0.02, 3), "2024-05-18T08:00:00Z", "kitchen.yaml");
        open();
        tapRow(0);
        tap(R.id.results_share);
        Intent shared = shadowOf(controller.get()).getNextStartedActivity().getParcelableExtra(Intent.EXTRA_INTENT);
        List<Uri> uris = shared.getParcelableArrayListExtra(Intent.EXTRA_STREAM);
        assertEquals(4, uris.size());
        assertEquals(saved.uris().get(0), uris.get(0).toString());
        assertTrue((shared.getFlags() & Intent.FLAG_GRANT_READ_URI_PERMISSION) != 0);
    }

    private void delete(int answer) {
        tap(R.id.results_delete);
        AlertDialog dialog = (AlertDialog) ShadowDialog.getLatestDialog();
        assertTrue(dialog.isShowing());
        dialog.getButton(answer).performClick();
        shadowOf(Looper.getMainLooper()).idle();
    }

    @Test
    public void resultIsDeletedAfterAQuestionAlone() throws IOException {
        keepBeforeAndAfter();
        open();
        tapRow(0);
        delete(AlertDialog.BUTTON_NEGATIVE);
        assertTrue(find(R.id.results_bar).isShown());
        assertEquals(2, Screen.app().folders.saved().size());
        delete(AlertDialog.BUTTON_POSITIVE);
        until("deletion", () -> rows().size() == 1);
        assertFalse(find(R.id.results_bar).isShown());
        assertEquals("cellgauge-20240517-123005", Screen.app().folders.saved().get(0).name());
    }

    @Test
    public void deletedResultIsNotOfferedForSharingAnyMore() {
        archive("2024-05-18T08:00:00Z");
        try (Screen screen = Screen.start()) {
            screen.tap(R.id.message_second);
            screen.until("result", () -> screen.state().verdict() != null);
            screen.tap(R.id.save);
            screen.tap(R.id.results);
            assertEquals(ResultsActivity.class.getName(), shadowOf(screen.activity()).getNextStartedActivity()
                    .getComponent().getClassName());
            screen.pause();
            screen.resume();
            assertTrue(screen.find(R.id.share).isEnabled());
            assertTrue(Screen.app().folders.delete(screen.state().saved().name()));
            screen.pause();
            screen.resume();
            assertFalse(screen.find(R.id.share).isEnabled());
            assertTrue("it can be kept again", screen.find(R.id.save).isEnabled());
        }
    }

    @Test
    public void turningKeepsWhatWasOpened() throws IOException {
        keepBeforeAndAfter();
        open();
        tapRow(0);
        tap(R.id.results_compare);
        tapRow(0);
        RuntimeEnvironment.setQualifiers(Screen.TABLET_PORTRAIT);
        controller.recreate();
        until("results", () -> rows().size() > 2);
        assertEquals("Before and after", text(R.id.heading_title));
        assertTrue("back has a use", Screen.back(controller.get()));
        assertNotNull(row(rows(), "Object 20 – deviation within 3 mm"));
    }

    // ---- what it looks like

    private void picture(String name) {
        AccessibilityTest.assertTouchable(controller.get(), name);
        AccessibilityTest.assertWhole(controller.get(), name);
        Screen.write(name, Screen.picture(controller.get().getWindow().getDecorView()));
    }

    @Test
    public void pictures() throws IOException {
        pictures("", Screen.TABLET_LANDSCAPE, 1);
        pictures("-portrait-dark", Screen.TABLET_PORTRAIT.replace("notnight", "night"), 1);
        pictures("-german-phone", "de-" + Screen.PHONE_PORTRAIT, 1);
        pictures("-large-letters-phone-landscape", Screen.PHONE_LANDSCAPE, 2);
    }

    private void pictures(String name, String qualifiers, float fontScale) throws IOException {
        RuntimeEnvironment.setQualifiers(qualifiers);
        RuntimeEnvironment.setFontScale(fontScale);
        if (Screen.app().folders == null) {
            keepBeforeAndAfter();
            keep(check(FIXTURE.doubtful(), CheckSettings.builder().build()), "2024-05-19T16:20:00Z", "hall.yaml");
        }
        Screen.backIsOwn();
        controller = Robolectric.buildActivity(ResultsActivity.class).setup();
        until("results", () -> rows().size() == 3);
        picture("results-list" + name);
        tapRow(1);
        ImageView picture = find(R.id.results_picture);
        until("picture", () -> picture.getDrawable() != null);
        picture("results-opened" + name);
        tap(R.id.results_compare);
        tapRow(1);
        picture("results-compared" + name);
        find(R.id.results_page).scrollTo(0, 100_000);
        picture("results-compared-scrolled" + name);
        controller.pause().stop().destroy();
        controller = null;
    }
}
