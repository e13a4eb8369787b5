package org.cellgauge.android.screen;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;
import static org.robolectric.Shadows.shadowOf;

import android.app.Activity;
import android.content.Intent;
import android.content.UriPermission;
import android.net.Uri;
import android.view.View;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.Collectors;
import org.cellgauge.android.R;
import org.cellgauge.android.files.DocumentLibrary;
import org.cellgauge.android.files.StoredMemory;
import org.cellgauge.android.files.TestDocuments;
import org.cellgauge.cell.Requirement;
import org.cellgauge.cell.Target;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.annotation.Config;
import org.robolectric.shadows.ShadowActivity;

/** A start of the app without anything that the system kept of its screens: what was chosen last is in use again. */
@RunWith(RobolectricTestRunner.class)
@Config(application = TestApp.class, qualifiers = Screen.TABLET_LANDSCAPE)
public class ColdStartTest {
    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private TestDocuments documents;
    private String cell;
    private String calibration;

    @Before
    public void documents() throws IOException {
        documents = TestDocuments.registered(folder.getRoot());
        cell = documents.add("cell.yaml", fixture("cell.yaml"));
        calibration = documents.add("tablet.yaml", fixture("camera.yaml"));
        Screen.app().documents = new DocumentLibrary(Screen.app());
    }

    private static byte[] fixture(String name) throws IOException {
        return Files.readAllBytes(new File(System.getProperty("cellgauge.root"), "fixtures/lifted-4/" + name).toPath());
    }

    /** As in a process of its own: nothing but what is stored is left of the start before. */
    private static Screen coldStart() {
        Screen.app().memory = new StoredMemory(Screen.app());
        return Screen.start();
    }

    private static void choose(Screen screen, String uri) {
        ShadowActivity.IntentForResult asked = shadowOf(screen.activity()).getNextStartedActivityForResult();
        shadowOf(screen.activity()).receiveResult(asked.intent, Activity.RESULT_OK, new Intent().setData(
                Uri.parse(uri)));
        screen.settle();
    }

    private void chooseBoth() {
        try (Screen screen = coldStart()) {
            screen.tap(R.id.cell);
            choose(screen, cell);
            RowList rows = screen.find(R.id.rows);
            rows.getChildAt(0).findViewById(R.id.row_action).performClick();
            choose(screen, calibration);
            assertNotNull(screen.state().cell().calibration());
            screen.activity().finish();
        }
    }

    private static Set<String> readable() {
        List<UriPermission> kept = Screen.app().getContentResolver().getPersistedUriPermissions();
        return kept.stream().filter(UriPermission::isReadPermission).map(p -> p.getUri().toString())
                .collect(Collectors.toSet());
    }

    private static boolean messageShown(Screen screen) {
        return screen.find(R.id.message).getVisibility() == View.VISIBLE;
    }

    @Test
    public void lastCellAndCalibrationAreReadAgain() {
        chooseBoth();
        assertEquals(Set.of(cell, calibration), readable());
        try (Screen screen = coldStart()) {
            assertEquals("shown cell.yaml", screen.state().cell().name());
            assertNull(screen.state().cellProblem());
            assertEquals(Fixture.LIFTED.cell().camera().toString(), screen.state().cell().calibration().toString());
        }
    }

    @Test
    public void anotherCellIsRememberedWithoutTheCalibrationOfTheOneBefore() throws IOException {
        chooseBoth();
        String other = documents.add("other.yaml", fixture("cell.yaml"));
        try (Screen screen = coldStart()) {
            screen.tap(R.id.cell);
            choose(screen, other);
        }
        try (Screen screen = coldStart()) {
            assertEquals("shown other.yaml", screen.state().cell().name());
            assertNull(screen.state().cell().calibration());
        }
    }

    /** The calibration file says how its lens was focused, and the camera hears of it. */
    @Test
    public void cameraIsFocusedAsItsCalibrationFileSays() throws IOException {
        calibration = documents.add("near.yaml", (new String(fixture("camera.yaml"), StandardCharsets.UTF_8)
                + "focus_distance_m: 0.5\n").getBytes(StandardCharsets.UTF_8));
        Screen.allowCamera();
        chooseBoth();
        try (Screen screen = coldStart()) {
            assertEquals(OptionalDouble.of(0.5), Screen.app().feed.focusedAtM);
            screen.session().tryExample();
            screen.settle();
            assertEquals("the example's camera is not this one", OptionalDouble.empty(),
                    screen.state().liveFocusDistanceM());
        }
    }

    /** A cell that is looked at day by day has its target day by day; another one has its own file's. */
    @Test
    public void chosenTargetIsInForceAgainWithItsCell() throws IOException {
        chooseBoth();
        Requirement tolerance = new Requirement(Requirement.Axes.NONE, new Requirement.Axes(0.1, 2, 3), 4.7, 1.5, 0.99);
        Target target = new Target(tolerance, Map.of(5, Requirement.ofStdMm(1 / 3.0)));
        try (Screen screen = coldStart()) {
            assertFileTarget(screen);
            screen.session().chooseTarget(target);
            screen.settle();
            screen.session().count(20, false);
            screen.settle();
        }
        Target chosen = new Target(tolerance, Map.of(5, Requirement.ofStdMm(1 / 3.0), 20, Requirement.NONE));
        try (Screen screen = coldStart()) {
            assertEquals(chosen, screen.state().target());
            assertNotNull(screen.state().cell().calibration());
            screen.session().chooseCalibration(calibration);
            screen.settle();
        }
        try (Screen screen = coldStart()) {
            assertEquals("with another calibration of the same cell", chosen, screen.state().target());
            screen.session().resetTarget();
            screen.settle();
        }
        try (Screen screen = coldStart()) {
            assertFileTarget(screen);
            screen.session().chooseTarget(target);
            screen.settle();
            screen.session().tryExample();
            screen.settle();
            screen.session().chooseTarget(Target.NONE);
            screen.settle();
        }
        String other = documents.add("other.yaml", fixture("cell.yaml"));
        try (Screen screen = coldStart()) {
            assertEquals("not the example's", target, screen.state().target());
            screen.tap(R.id.cell);
            choose(screen, other);
            assertFileTarget(screen);
        }
        try (Screen screen = coldStart()) {
            assertEquals("shown other.yaml", screen.state().cell().name());
            assertFileTarget(screen);
        }
    }

    private static void assertFileTarget(Screen screen) {
        assertEquals(screen.state().cell().cell().target(), screen.state().target());
    }

    @Test
    public void refusedFileAndExampleLeaveTheLastCellRemembered() throws IOException {
        chooseBoth();
        String bad = documents.add("bad.yaml", "cellgauge: 1\n".getBytes(StandardCharsets.UTF_8));
        try (Screen screen = coldStart()) {
            screen.tap(R.id.cell);
            choose(screen, bad);
            assertNotNull(screen.state().cellProblem());
            screen.session().tryExample();
            screen.settle();
            assertNull(screen.state().cell().uri());
        }
        try (Screen screen = coldStart()) {
            assertEquals("shown cell.yaml", screen.state().cell().name());
            assertNotNull(screen.state().cell().calibration());
        }
    }

    @Test
    public void photosTakeNoPlaceAmongTheDocumentsThatAreRemembered() throws IOException {
        chooseBoth();
        String photo = documents.add("photo.png", fixture("photo.png"));
        try (Screen screen = coldStart()) {
            screen.tap(R.id.photo);
            choose(screen, photo);
            assertEquals("shown photo.png", screen.state().still().name());
        }
        assertEquals(Set.of(cell, calibration), readable());
    }

    /** The start is that of the first time, after a word on what is missing and what can be done. */
    @Test
    public void cellThatIsGoneIsSaidAndCanBeChosenAgain() {
        chooseBoth();
        documents.remove(cell);
        try (Screen screen = coldStart()) {
            assertNull(screen.state().cell());
            assertEquals("No cell chosen", screen.text(R.id.banner_headline));
            assertTrue(messageShown(screen));
            assertEquals("The cell file of the last time cannot be read again", screen.text(R.id.message_title));
            assertEquals("shown cell.yaml: this cell file is not there any more, or its app does not give it; "
                    + "choose it again", screen.text(R.id.message_text));
            assertEquals("Choose cell file", screen.text(R.id.message_first));
            assertEquals("Try the example", screen.text(R.id.message_second));
        }
    }

    @Test
    public void permissionThatHasEndedIsSaidAndTheCellComesBackWithIt() {
        chooseBoth();
        documents.permissionEnded(true);
        try (Screen screen = coldStart()) {
            assertNull(screen.state().cell());
            assertEquals("shown cell.yaml: the permission to read this cell file has ended; choose it again",
                    screen.text(R.id.message_text));
        }
        documents.permissionEnded(false);
        try (Screen screen = coldStart()) {
            assertEquals("a card was put in again", "shown cell.yaml", screen.state().cell().name());
            assertNotNull(screen.state().cell().calibration());
        }
    }

    @Test
    public void calibrationThatIsGoneIsSaidAndTheCellIsInUseWithoutIt() {
        chooseBoth();
        documents.remove(calibration);
        try (Screen screen = coldStart()) {
            assertEquals("shown cell.yaml", screen.state().cell().name());
            assertNull(screen.state().cell().calibration());
            assertTrue(messageShown(screen));
            assertEquals("The calibration file of the last time cannot be read again",
                    screen.text(R.id.message_title));
            assertTrue(screen.text(R.id.message_text), screen.text(R.id.message_text).startsWith(
                    "shown tablet.yaml: this camera file is not there any more"));
            assertEquals("Choose calibration file", screen.text(R.id.message_first));
            screen.tap(R.id.message_second);
            assertFalse(screen.text(R.id.message_title), screen.text(R.id.message_title).contains("calibration file"));
        }
        try (Screen screen = coldStart()) {
            assertNull("said once, after going on without it", screen.state().cellProblem());
            assertEquals("shown cell.yaml", screen.state().cell().name());
        }
    }
}
