package org.cellgauge.android.screen;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;
import static org.robolectric.Shadows.shadowOf;

import android.content.ComponentName;
import android.content.Context;
import android.content.Intent;
import android.content.pm.PackageManager;
import android.content.pm.ResolveInfo;
import android.content.res.XmlResourceParser;
import android.net.Uri;
import android.os.Bundle;
import android.os.Looper;
import android.widget.TextView;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.cellgauge.android.R;
import org.cellgauge.android.files.CellDocument;
import org.cellgauge.android.files.Photo;
import org.cellgauge.android.state.ImageSource;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.Robolectric;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.android.controller.ActivityController;
import org.robolectric.annotation.Config;
import org.robolectric.shadows.ShadowToast;
import org.xmlpull.v1.XmlPullParser;
import org.xmlpull.v1.XmlPullParserException;

/** Cell files and photos that other apps open with this one or share with it. */
@RunWith(RobolectricTestRunner.class)
@Config(application = TestApp.class, qualifiers = Screen.TABLET_LANDSCAPE)
public class GivenDocumentTest {
    private static final Fixture FIXTURE = Fixture.LIFTED;
    private static final String PHOTO = "content://gallery/7";

    private final Context app = RuntimeEnvironment.getApplication();

    private static Intent view(String uri, String type) {
        return new Intent(Intent.ACTION_VIEW).setDataAndType(Uri.parse(uri), type);
    }

    private static Intent send(String uri, String type) {
        return new Intent(Intent.ACTION_SEND).setType(type).putExtra(Intent.EXTRA_STREAM, Uri.parse(uri));
    }

    private static void answer(CellDocument cell, Photo photo) {
        Screen.app().library.cells.put(cell.uri(), () -> cell);
        Screen.app().library.photos.put(PHOTO, () -> photo);
    }

    private static GivenDocument given(Intent intent) {
        return GivenDocument.of(intent, RuntimeEnvironment.getApplication().getContentResolver());
    }

    /** Whether the system would offer the app for an intent. */
    private boolean isOffered(Intent intent) {
        PackageManager packages = app.getPackageManager();
        List<ResolveInfo> found = packages.queryIntentActivities(
                new Intent(intent).setComponent(null).setPackage(app.getPackageName()),
                PackageManager.MATCH_DEFAULT_ONLY);
        return found.size() == 1 && found.get(0).activityInfo.name.equals(MainActivity.class.getName());
    }

    // ---- what is taken

    @Test
    public void theSystemOffersTheAppForCellFilesAndPhotosAndNothingElse() {
        for (String type : new String[] {"application/json", "application/x-yaml", "application/yaml", "text/plain",
            "text/yaml", "image/jpeg", "image/png", "image/heic"}) {
            assertTrue(type, isOffered(view("content://files/7", type)));
            assertTrue(type, isOffered(send("content://files/7", type)));
        }
        assertTrue(isOffered(send("content://files/7", "application/octet-stream")));
        String storage = "content://com.android.externalstorage.documents/document/primary%3ADownload%2F";
        for (String name : new String[] {"cell.yaml", "cell.yml", "cell.json", "hall.4.yaml"}) {
            assertTrue(name, isOffered(view(storage + name, "application/octet-stream")));
        }
        assertFalse(isOffered(view(storage + "firmware.bin", "application/octet-stream")));
        assertFalse(isOffered(view("content://files/7", "video/mp4")));
        assertFalse(isOffered(send("content://files/7", "application/pdf")));
        assertFalse(isOffered(view("https://example.org/cell.yaml", "text/yaml")));
    }

    @Test
    public void whatIsGivenIsToldByItsTypeAndElseByItsName() {
        assertTrue(given(view("content://a/7", "image/jpeg")).isPhoto());
        assertFalse(given(view("content://a/7", "text/plain")).isPhoto());
        assertTrue(given(send("content://a/7", "image/heic")).isPhoto());
        assertTrue(given(send("content://a/DCIM%2Fhall.JPG", "application/octet-stream")).isPhoto());
        assertFalse(given(send("content://a/cell.yaml", "application/octet-stream")).isPhoto());
        assertFalse(given(view("content://a/7", null)).isPhoto());
        assertEquals("content://a/7", given(send("content://a/7", "*/*")).uri().toString());
    }

    @Test
    public void whatIsNoOfferOfADocumentIsLeftAlone() {
        assertNull(given(null));
        assertNull(given(new Intent()));
        assertNull(given(new Intent(Intent.ACTION_MAIN).addCategory(Intent.CATEGORY_LAUNCHER)));
        assertNull(given(view("content://a/7", "text/plain").addFlags(Intent.FLAG_ACTIVITY_LAUNCHED_FROM_HISTORY)));
        assertNull(given(new Intent(Intent.ACTION_SEND).setType("text/plain")
                .putExtra(Intent.EXTRA_TEXT, "words")).uri());
        assertNull(given(new Intent(Intent.ACTION_SEND).setType("text/plain")
                .putExtra(Intent.EXTRA_STREAM, new Bundle())).uri());
        assertNull(given(new Intent(Intent.ACTION_VIEW)).uri());
    }

    // ---- what becomes of it

    private static ActivityController<MainActivity> start(Intent intent) {
        ActivityController<MainActivity> controller = Robolectric.buildActivity(MainActivity.class,
                intent.setComponent(new ComponentName(RuntimeEnvironment.getApplication(), MainActivity.class)))
                .setup();
        shadowOf(Looper.getMainLooper()).idle();
        return controller;
    }

    @Test
    public void aCellFileThatAnotherAppOpensIsInUse() {
        CellDocument cell = FIXTURE.document();
        answer(cell, FIXTURE.photo());
        try (ActivityController<MainActivity> controller = start(view(cell.uri(), "text/yaml"))) {
            assertEquals(cell, controller.get().session().state().cell());
            // the system makes the activity anew: what was given was taken already
            Screen.app().library.cells.clear();
            controller.recreate();
            shadowOf(Looper.getMainLooper()).idle();
            assertEquals(cell, controller.get().session().state().cell());
            assertNull(controller.get().session().state().cellProblem());
        }
    }

    @Test
    public void aPhotoWaitsForItsCell() {
        answer(FIXTURE.document(), FIXTURE.photo());
        try (ActivityController<MainActivity> controller = start(send(PHOTO, "image/png"))) {
            MainActivity activity = controller.get();
            TextView text = activity.findViewById(R.id.message_text);
            assertTrue(text.getText().toString(), text.getText().toString().startsWith("The photo is waiting"));
            activity.session().chooseCell(FIXTURE.document().uri());
            shadowOf(Looper.getMainLooper()).idle();
            assertEquals(ImageSource.PHOTO, activity.session().state().source());
            assertEquals("lifted-4.png", activity.session().state().still().name());
            assertFalse(activity.session().state().photoWaits());
        }
    }

    @Test
    public void theRunningAppTakesWhatIsSharedMeanwhile() {
        answer(FIXTURE.document(), FIXTURE.photo());
        try (Screen screen = Screen.live(FIXTURE.document(), 90, false)) {
            screen.give(send(PHOTO, "image/png"));
            assertEquals(ImageSource.PHOTO, screen.state().source());
            assertEquals("lifted-4.png", screen.state().still().name());
            screen.give(new Intent(Intent.ACTION_SEND).setType("text/plain").putExtra(Intent.EXTRA_TEXT, "words"));
            assertTrue(ShadowToast.getTextOfLatestToast().startsWith("No file came with it"));
            assertEquals(ImageSource.PHOTO, screen.state().source());
        }
    }

    /** Where the system lets a user choose a language for one app, it knows both. */
    @Test
    public void bothLanguagesCanBeChosenForThisAppAlone() throws XmlPullParserException, IOException {
        Map<String, String> cells = new TreeMap<>();
        try (XmlResourceParser locales = app.getResources().getXml(R.xml.locales)) {
            while (locales.next() != XmlPullParser.END_DOCUMENT) {
                if (locales.getEventType() == XmlPullParser.START_TAG && locales.getName().equals("locale")) {
                    String language = locales.getAttributeValue("http://schemas.android.com/apk/res/android", "name");
                    RuntimeEnvironment.setQualifiers("+" + language);
                    cells.put(language, app.getString(R.string.cell));
                }
            }
        }
        Map<String, String> expected = new TreeMap<>();
        expected.put("de", "Zelle");
        expected.put("en", "Cell");
        assertEquals(expected, cells);
    }
}
