package org.cellgauge.android.screen;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;
import static org.robolectric.Shadows.shadowOf;

import android.app.Activity;
import android.app.AlertDialog;
import android.content.Intent;
import android.net.Uri;
import android.os.Looper;
import android.view.View;
import android.view.ViewGroup;
import android.widget.ImageView;
import android.widget.TextView;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import org.cellgauge.android.R;
import org.cellgauge.android.files.AppMemory;
import org.cellgauge.android.files.CellDocument;
import org.cellgauge.android.files.StoredMemory;
import org.junit.After;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.Robolectric;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.android.controller.ActivityController;
import org.robolectric.annotation.Config;
import org.robolectric.shadows.ShadowActivity;
import org.robolectric.shadows.ShadowDialog;
import org.robolectric.shadows.ShadowToast;

/** The first run says what to do, with the files that it takes. */
@RunWith(RobolectricTestRunner.class)
@Config(application = TestApp.class, qualifiers = Screen.TABLET_LANDSCAPE)
public class GuideActivityTest {
    private static final Uri PLACE = Uri.parse("content://org.example.documents/new");
    private static final int PATIENCE_MS = 30_000;
    private static final int STEPS = 4;

    private ActivityController<GuideActivity> controller;

    @After
    public void close() {
        if (controller != null) {
            controller.pause().stop().destroy();
        }
    }

    private void open() {
        controller = Robolectric.buildActivity(GuideActivity.class).setup();
        shadowOf(Looper.getMainLooper()).idle();
    }

    private List<View> cards() {
        List<View> cards = new ArrayList<>();
        ViewGroup steps = controller.get().findViewById(R.id.guide_steps);
        for (int i = 0; i < steps.getChildCount(); i++) {
            ViewGroup row = (ViewGroup) steps.getChildAt(i);
            for (int k = 0; k < row.getChildCount(); k++) {
                cards.add(row.getChildAt(k));
            }
        }
        return cards;
    }

    private void tap(int step) {
        cards().get(step).findViewById(R.id.guide_step_button).performClick();
        shadowOf(Looper.getMainLooper()).idle();
    }

    /** What is written to the place that the user chooses. */
    private byte[] saved(int step, String type, String name) throws InterruptedException {
        tap(step);
        ShadowActivity.IntentForResult asked = shadowOf(controller.get()).getNextStartedActivityForResult();
        assertEquals(Intent.ACTION_CREATE_DOCUMENT, asked.intent.getAction());
        assertEquals(type, asked.intent.getType());
        assertEquals(name, asked.intent.getStringExtra(Intent.EXTRA_TITLE));
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        answer(asked, out, "Saved.");
        return out.toByteArray();
    }

    private void answer(ShadowActivity.IntentForResult asked, OutputStream out, String said)
            throws InterruptedException {
        shadowOf(controller.get().getContentResolver()).registerOutputStream(PLACE, out);
        ShadowToast.reset();
        shadowOf(controller.get()).receiveResult(asked.intent, Activity.RESULT_OK, new Intent().setData(PLACE));
        long end = System.currentTimeMillis() + PATIENCE_MS;
        while (ShadowToast.shownToastCount() == 0) {
            if (System.currentTimeMillis() > end) {
                fail("nothing is said of the document");
            }
            Thread.sleep(5);
            shadowOf(Looper.getMainLooper()).idle();
        }
        assertEquals(said, ShadowToast.getTextOfLatestToast());
    }

    @Test
    public void firstStartShowsItOnceAndTheListLater() {
        Screen.app().memory = new StoredMemory(Screen.app());
        try (Screen screen = Screen.start()) {
            assertEquals(GuideActivity.class.getName(), shadowOf(screen.activity()).getNextStartedActivity()
                    .getComponent().getClassName());
        }
        Screen.app().memory = new StoredMemory(Screen.app());
        try (Screen screen = Screen.start()) {
            assertNull(shadowOf(screen.activity()).getNextStartedActivity());
            RowList rows = screen.find(R.id.rows);
            View button = rows.getChildAt(rows.getChildCount() - 2).findViewById(R.id.row_action);
            assertEquals("Show the steps", ((TextView) button).getText());
            button.performClick();
            assertEquals(GuideActivity.class.getName(), shadowOf(screen.activity()).getNextStartedActivity()
                    .getComponent().getClassName());
        }
    }

    @Test
    public void fourStepsHaveAPictureWordsAndAButtonEach() {
        open();
        assertEquals(STEPS, cards().size());
        for (View card : cards()) {
            ImageView picture = card.findViewById(R.id.guide_picture);
            assertNotNull(picture.getDrawable());
            assertTrue(picture.getContentDescription().toString().startsWith("Picture: "));
            for (int id : new int[] {R.id.guide_step_title, R.id.guide_step_first, R.id.guide_step_second,
                R.id.guide_step_button}) {
                assertTrue(((TextView) card.findViewById(id)).length() > 3);
            }
        }
        controller.get().findViewById(R.id.guide_done).performClick();
        assertTrue(controller.get().isFinishing());
    }

    @Test
    public void exampleCellFileIsSavedAsItIs() throws Exception {
        open();
        File bundled = new File(System.getProperty("cellgauge.root"), "android-app/src/main/assets/guide/cell.yaml");
        assertArrayEquals(Files.readAllBytes(bundled.toPath()), saved(2, "application/octet-stream", "cell.yaml"));
    }

    @Test
    public void markersOfTheLastCellAreOnTheSheetElseTheExamples() throws Exception {
        open();
        byte[] example = saved(0, "application/pdf", "cellgauge-markers.pdf");
        String text = new String(example, StandardCharsets.US_ASCII);
        assertTrue(text.startsWith("%PDF-1."));
        assertTrue(text.contains("(1234   47 mm)"));
        assertFalse(text.contains("(77   47 mm)"));
        AppMemory memory = new StoredMemory(Screen.app());
        CellDocument own = Fixture.LIFTED.document(Fixture.LIFTED.doubtful());
        Screen.app().library.cells.put(own.uri(), () -> own);
        memory.keep(new AppMemory.Choice(own.uri(), null, null));
        Screen.app().memory = memory;
        String mine = new String(saved(0, "application/pdf", "cellgauge-markers.pdf"), StandardCharsets.US_ASCII);
        assertTrue(mine.contains("(77   47 mm)"));
        assertNotEquals(text, mine);
    }

    @Test
    public void placeThatCannotBeWrittenIsSaid() throws Exception {
        open();
        tap(2);
        answer(shadowOf(controller.get()).getNextStartedActivityForResult(), new OutputStream() {
            @Override
            public void write(int b) throws IOException {
                throw new IOException("the card is full");
            }
        }, "It could not be saved there. Choose another place.");
    }

    @Test
    public void howToIsReadAndStaysThroughATurn() {
        open();
        tap(1);
        AlertDialog dialog = (AlertDialog) ShadowDialog.getLatestDialog();
        TextView text = dialog.findViewById(android.R.id.message);
        assertTrue(text.getText().toString().contains("std_mm of placement"));
        RuntimeEnvironment.setQualifiers(Screen.TABLET_PORTRAIT);
        controller.recreate();
        assertFalse(dialog.isShowing());
        dialog = (AlertDialog) ShadowDialog.getLatestDialog();
        assertTrue(dialog.isShowing());
        dialog.dismiss();
        tap(3);
        text = ((AlertDialog) ShadowDialog.getLatestDialog()).findViewById(android.R.id.message);
        assertTrue(text.getText().toString().contains("cellgauge calibrate --target target.yaml"));
    }

    @Test
    public void picturesForPeopleToLookAt() {
        picture("guide", Screen.TABLET_LANDSCAPE, 1);
        picture("guide-german-portrait-dark", "de-" + Screen.TABLET_PORTRAIT.replace("notnight", "night"), 1);
        picture("guide-german-phone", "de-" + Screen.PHONE_PORTRAIT, 1);
        picture("guide-large-letters-phone-landscape", Screen.PHONE_LANDSCAPE, 2);
    }

    private void picture(String name, String qualifiers, float fontScale) {
        RuntimeEnvironment.setQualifiers(qualifiers);
        RuntimeEnvironment.setFontScale(fontScale);
        open();
        assertEquals(name, STEPS + 2, AccessibilityTest.assertTouchable(controller.get(), name));
        AccessibilityTest.assertWhole(controller.get(), name);
        Screen.write(name, Screen.picture(controller.get().getWindow().getDecorView()));
        controller.get().findViewById(R.id.guide_page).scrollTo(0, 100_000);
        Screen.write(name + "-scrolled", Screen.picture(controller.get().getWindow().getDecorView()));
        controller.pause().stop().destroy();
        controller = null;
    }
}
