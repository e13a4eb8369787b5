package org.cellgauge.android.screen;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertNotSame;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertTrue;
import static org.robolectric.Shadows.shadowOf;

import android.Manifest;
import android.app.Activity;
import android.app.AlertDialog;
import android.content.ClipData;
import android.content.Intent;
import android.content.pm.PackageManager;
import android.graphics.Bitmap;
import android.net.Uri;
import android.os.Build;
import android.os.Bundle;
import android.os.Parcel;
import android.provider.Settings;
import android.view.Surface;
import android.view.View;
import android.widget.EditText;
import android.widget.TextView;
import io.reactivex.rxjava3.schedulers.Schedulers;
import io.reactivex.rxjava3.schedulers.TestScheduler;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.Set;
import org.cellgauge.android.R;
import org.cellgauge.android.camera.CameraFault;
import org.cellgauge.android.camera.CameraFeed;
import org.cellgauge.android.camera.CameraModelSource;
import org.cellgauge.android.camera.CameraNote;
import org.cellgauge.android.camera.CameraSetup;
import org.cellgauge.android.device.ThermalLevel;
import org.cellgauge.android.files.CellDocument;
import org.cellgauge.android.files.FileRefusal;
import org.cellgauge.android.files.Photo;
import org.cellgauge.android.files.StorageFullException;
import org.cellgauge.android.state.CheckSession;
import org.cellgauge.android.state.ImageSource;
import org.cellgauge.android.state.ObjectRow;
import org.cellgauge.android.state.SessionThreads;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellRefusal;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.Reference;
import org.cellgauge.cell.Target;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.Reason;
import org.cellgauge.check.Verdict;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.cell.CellPhrase;
import org.cellgauge.internal.overlay.CellOverlay;
import org.cellgauge.internal.overlay.EllipseShape;
import org.cellgauge.internal.overlay.Overlay;
import org.cellgauge.internal.overlay.Role;
import org.cellgauge.internal.overlay.Shape;
import org.cellgauge.internal.overlay.TextShape;
import org.cellgauge.live.LiveState;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Estimate;
import org.cellgauge.vision.BoofMarkerDetector;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.GreyImage;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.annotation.Config;
import org.robolectric.shadows.ShadowActivity;
import org.robolectric.shadows.ShadowDialog;

/** What a user meets: the first start, rough handling, and what is kept. */
@RunWith(RobolectricTestRunner.class)
@Config(application = TestApp.class, qualifiers = Screen.TABLET_LANDSCAPE, minSdk = 27)
public class MainActivityTest {
    private static final Fixture FIXTURE = Fixture.LIFTED;

    private static TestApp.FakeFeed feed() {
        return Screen.app().feed;
    }

    private static Screen live() {
        Screen.turnDisplay(Surface.ROTATION_90);
        return Screen.live(FIXTURE.document(), 90, false);
    }

    private static String rows(Screen screen) {
        RowList rows = screen.find(R.id.rows);
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < rows.getChildCount(); i++) {
            for (int id : new int[] {R.id.row_title, R.id.row_figures, R.id.row_text}) {
                TextView view = rows.getChildAt(i).findViewById(id);
                text.append(view.getVisibility() == View.VISIBLE ? Screen.plain(view.getText()) + "\n" : "");
            }
        }
        return text.toString();
    }

    private static void tapRow(Screen screen, String label) {
        RowList rows = screen.find(R.id.rows);
        for (int i = 0; i < rows.getChildCount(); i++) {
            TextView button = rows.getChildAt(i).findViewById(R.id.row_action);
            if (button.getVisibility() == View.VISIBLE && button.getText().toString().equals(label)) {
                button.performClick();
                screen.settle();
                return;
            }
        }
        throw new AssertionError("no row offers " + label + ":\n" + rows(screen));
    }

    private static int frozenFrames() {
        return Screen.app().cacheFolder().listFiles(file -> file.getName().startsWith("frozen-frame")).length;
    }

    private static boolean messageShown(Screen screen) {
        return screen.find(R.id.message).getVisibility() == View.VISIBLE;
    }

    // ---- first start

    @Test
    @Config(minSdk = 26)
    public void firstStartExplainsAndOffersAFileAndTheExample() {
        try (Screen screen = Screen.start()) {
            assertEquals("No cell chosen", screen.text(R.id.banner_headline));
            assertTrue(messageShown(screen));
            assertEquals("Choose cell file", screen.text(R.id.message_first));
            assertEquals("Try the example", screen.text(R.id.message_second));
            assertEquals("", screen.text(R.id.message_third));
            assertFalse(feed().isOpen());
        }
    }

    @Test
    @Config(minSdk = 26)
    public void exampleShowsAResultWithoutCameraOrPermission() {
        try (Screen screen = Screen.start()) {
            screen.tap(R.id.message_second);
            screen.until("result", () -> screen.state().verdict() != null);
            assertEquals("Pass – target met", screen.text(R.id.banner_headline));
            assertEquals(ImageSource.PHOTO, screen.state().source());
            assertFalse(messageShown(screen));
            assertEquals(0, feed().openings);
            assertTrue(rows(screen), rows(screen).contains("Object 20 – deviation within 3 mm"));
        }
    }

    @Test
    @Config(minSdk = 26)
    public void examplesCameraIsNotTakenForTheDevices() {
        Screen.allowCamera();
        try (Screen screen = Screen.start()) {
            screen.tap(R.id.message_second);
            screen.until("result", () -> screen.state().verdict() != null);
            screen.tap(R.id.freeze);
            assertTrue(feed().isOpen());
            assertNull(feed().openedWith);
            assertNull(screen.state().result());
        }
    }

    @Test
    @Config(minSdk = 26)
    public void documentsAreAskedForAndTheirAccessIsKept() {
        try (Screen screen = Screen.start()) {
            screen.tap(R.id.message_first);
            ShadowActivity.IntentForResult asked = shadowOf(screen.activity()).getNextStartedActivityForResult();
            assertEquals(Intent.ACTION_OPEN_DOCUMENT, asked.intent.getAction());
            assertTrue(asked.intent.getCategories().contains(Intent.CATEGORY_OPENABLE));
            CellDocument document = FIXTURE.document();
            Screen.app().library.cells.put(document.uri(), () -> document);
            shadowOf(screen.activity()).receiveResult(asked.intent, Activity.RESULT_OK,
                    new Intent().setData(Uri.parse(document.uri())));
            screen.settle();
            assertSame(document, screen.state().cell());
            assertEquals(document.uri(), screen.activity().getContentResolver().getPersistedUriPermissions().get(0)
                    .getUri().toString());
        }
    }

    @Test
    @Config(minSdk = 26)
    public void cancelledPickerChangesNothing() {
        try (Screen screen = Screen.start()) {
            screen.tap(R.id.message_first);
            ShadowActivity.IntentForResult asked = shadowOf(screen.activity()).getNextStartedActivityForResult();
            shadowOf(screen.activity()).receiveResult(asked.intent, Activity.RESULT_CANCELED, null);
            screen.settle();
            assertEquals("No cell chosen", screen.text(R.id.banner_headline));
        }
    }

    // ---- the check

    @Test
    @Config(minSdk = 26)
    public void chainsThatDidNotConvergeShowNoFigureAnywhere() {
        Screen.app().settings = CheckSettings.builder().iterations(300).build();
        try (Screen screen = live()) {
            screen.holdStillUntilResult(FIXTURE);
            assertEquals("Not converged – no figure to trust", screen.text(R.id.banner_headline));
            for (int id : new int[] {5, 20, 30}) {
                assertTrue(rows(screen), rows(screen).contains("Object " + id + " – not converged\nIts figures are not "
                        + "shown, because they cannot be relied on.\n"));
            }
            assertFalse(rows(screen), rows(screen).contains("σ"));
            for (Shape shape : screen.state().overlay().shapes()) {
                assertFalse(shape instanceof TextShape && ((TextShape) shape).text().contains("σ"));
                assertTrue(!(shape instanceof EllipseShape) || shape.dashed());
            }
        }
    }

    @Test
    @Config(minSdk = 26)
    public void ambiguousObjectsShowNoFigureAnywhere() {
        Screen.turnDisplay(Surface.ROTATION_90);
        try (Screen screen = Screen.live(FIXTURE.document(Fixture.with(FIXTURE.cell(), 0.3, OptionalDouble.of(3))), 90,
                false)) {
            screen.holdStillUntilResult(FIXTURE);
            assertEquals("Ambiguous – two poses fit", screen.text(R.id.banner_headline));
            for (int id : new int[] {5, 20, 30}) {
                assertTrue(rows(screen), rows(screen).contains("Object " + id + " – ambiguous\nTwo poses explain the "
                        + "corners of object " + id + " "));
            }
            assertFalse(rows(screen), rows(screen).contains("σ"));
            for (Shape shape : screen.state().overlay().shapes()) {
                assertFalse(shape instanceof TextShape && ((TextShape) shape).text().contains("σ"));
            }
        }
    }

    @Test
    @Config(minSdk = 26)
    public void stillCameraEndsInTheResultOfItsKeyFrameAlone() {
        try (Screen screen = live()) {
            assertEquals("Starting the camera…", screen.text(R.id.banner_headline));
            screen.holdStillUntilResult(FIXTURE);
            CheckResult shown = screen.state().result();
            CheckResult alone = CellCheck.run(FIXTURE.cell(),
                    BoofMarkerDetector.forCell(FIXTURE.cell()).detect(FIXTURE.image(), "alone"),
                    CheckSettings.builder().build());
            for (int id : new int[] {5, 20, 30}) {
                assertArrayEquals(alone.estimate().object(id).pose().std(),
                        shown.estimate().object(id).pose().std(), 0);
            }
            assertEquals(Verdict.PASS, screen.state().verdict());
            assertEquals(alone.reason().replace(" %", "%"), screen.text(R.id.reason));
            double[] std = alone.estimate().object(5).pose().std();
            assertTrue(rows(screen), rows(screen).contains(
                    String.format(Locale.ROOT, "σ  x %.2f · y %.2f · z %.2f mm", std[0], std[1], std[2])));
            assertEquals("95% ellipses, magnified 20× · grid 100 mm", screen.text(R.id.caption));
        }
    }

    @Test
    @Config(minSdk = 26)
    public void figuresBeforeConvergenceAreMarkedAsSuch() {
        Screen.app().levels.onNext(ThermalLevel.HOT);
        try (Screen screen = live()) {
            feed().frame(FIXTURE.image());
            screen.until("quick look", () -> screen.state().phase() == LiveState.Phase.QUICK_LOOK);
            assertEquals("Preliminary – quick look", screen.text(R.id.banner_headline));
            assertTrue(screen.text(R.id.reason), screen.text(R.id.reason).contains("have not converged"));
            assertTrue(rows(screen), rows(screen).contains("Object 5 – preliminary"));
            assertEquals(3, rows(screen).split("not converged yet", -1).length - 1);
            assertTrue(screen.text(R.id.caption), screen.text(R.id.caption).contains("dashed: not converged yet"));
            assertFalse(screen.find(R.id.save).isEnabled());
            assertTrue(screen.state().overlay().shapes(Role.OBJECT_ELLIPSE).stream()
                    .allMatch(Shape::dashed));
        }
    }

    @Test
    @Config(minSdk = 26)
    public void noMarkersInViewNamesWhatIsLookedFor() {
        try (Screen screen = live()) {
            feed().frame(FIXTURE.blank());
            screen.until("search", () -> screen.state().phase() == LiveState.Phase.SEARCHING);
            assertEquals("No reference in view", screen.text(R.id.banner_headline));
            assertEquals("None of the references 944, 1234, 911 and 22 is in view: "
                    + "come closer, or check light and focus.", screen.text(R.id.reason));
            assertFalse(screen.find(R.id.freeze).isEnabled());
        }
    }

    @Test
    @Config(minSdk = 26)
    public void objectWithoutAnyReferenceHasNoFigure() {
        try (Screen screen = live()) {
            GreyImage image = FIXTURE.image();
            // the references' columns; object 30 at (601, 393) stays, and so do the others
            for (int y = 0; y < image.heightPx(); y++) {
                Arrays.fill(image.luminance(), y * image.widthPx(), y * image.widthPx() + 550, (byte) 120);
                Arrays.fill(image.luminance(), y * image.widthPx() + 690, (y + 1) * image.widthPx(), (byte) 120);
            }
            feed().frame(image);
            screen.until("search", () -> screen.state().phase() == LiveState.Phase.SEARCHING);
            assertTrue(rows(screen), rows(screen).contains("Object 30 – in view, no figure"));
        }
    }

    @Test
    @Config(minSdk = 26)
    public void referenceThatIsCoveredIsNamed() {
        try (Screen screen = live()) {
            GreyImage image = FIXTURE.image();
            // 944 is at (745, 171)
            for (int y = 140; y < 205; y++) {
                Arrays.fill(image.luminance(), y * image.widthPx() + 710, y * image.widthPx() + 780, (byte) 120);
            }
            feed().frame(image);
            screen.until("figures", () -> screen.state().overlay() != null && screen.state().live().update() != null);
            assertTrue(rows(screen), rows(screen).contains("Reference 944 is not in view."));
        }
    }

    @Test
    @Config(minSdk = 26)
    public void anotherTargetJudgesTheSameDrawsAnew() {
        try (Screen screen = live()) {
            screen.holdStillUntilResult(FIXTURE);
            CheckResult before = screen.state().result();
            screen.session().chooseTarget(Target.ofStdMm(OptionalDouble.of(0.3)));
            screen.settle();
            assertEquals("Target missed", screen.text(R.id.banner_headline));
            assertSame(before.estimate(), screen.state().result().estimate());
            assertSame(before.draws(), screen.state().result().draws());
            assertTrue(rows(screen), rows(screen).contains("Object 5 – deviation beyond 0.3 mm"));
            assertTrue(rows(screen), rows(screen).contains("Target, chosen here: a standard deviation of at most "
                    + "0.3 mm on every axis"));
            screen.session().resetTarget();
            screen.settle();
            assertEquals("Pass – target met", screen.text(R.id.banner_headline));
        }
    }

    @Test
    @Config(minSdk = 26)
    public void cellWithoutTargetIsNotJudged() {
        Screen.allowCamera();
        try (Screen screen = Screen.start()) {
            CellDocument document = FIXTURE.document(FIXTURE.cell().withTarget(OptionalDouble.empty()));
            screen.chooseCell(document);
            screen.openPhoto(FIXTURE.photo());
            screen.until("result", () -> screen.state().verdict() != null);
            assertEquals("No target set", screen.text(R.id.banner_headline));
            assertTrue(rows(screen), rows(screen).contains("Object 5 – no target"));
        }
    }

    @Test
    public void misplacedReferenceIsNamedAndItsErrorIsHeldAgainstTheTarget() {
        Cell cell = FIXTURE.cell();
        List<Reference> references = new ArrayList<>();
        for (Reference r : cell.references()) {
            double[] p = r.worldFromMarker().translationMm();
            // the cell file has 911 where it does not stand
            references.add(r.id() != 911 ? r : new Reference(911, r.sizeMm(),
                    RigidTransform.ofEuler(p[0] + 12, p[1], p[2], 0, 0, 0), r.placement()));
        }
        Cell wrong = new Cell(cell.camera(), cell.family(), references, cell.objects(), cell.pixelStdPx(),
                cell.targetStdMm());
        try (Screen screen = Screen.start()) {
            screen.chooseCell(FIXTURE.document(wrong));
            screen.openPhoto(FIXTURE.photo());
            screen.until("result", () -> screen.state().verdict() != null);
            Reason reason = screen.state().reason();
            assertTrue(reason.english(), reason.misplacement() != null);
            String said = screen.text(R.id.reason);
            assertTrue(said, said.contains("Reference 911 seems misplaced. If so, the largest error is "));
            boolean met = screen.state().verdict() == Verdict.PASS;
            assertEquals(said, met, said.contains("The target is met even so."));
            assertTrue(rows(screen), rows(screen).contains("Reference 911 seems misplaced."));
            for (ObjectRow row : screen.state().objects()) {
                assertEquals(screen.state().result().verdict(row.id()) == Verdict.PASS,
                        row.mark() == ObjectRow.Mark.OK);
            }
        }
    }

    // ---- freezing and keeping

    @Test
    public void savedFrameIsTheOneThatTheFiguresCameFrom() {
        try (Screen screen = live()) {
            screen.holdStillUntilResult(FIXTURE);
            screen.tap(R.id.freeze);
            assertEquals(ImageSource.FROZEN, screen.state().source());
            assertEquals("Resume", screen.text(R.id.freeze));
            // the camera goes on, and looks elsewhere
            feed().frame(FIXTURE.blank());
            screen.tap(R.id.save);
            assertArrayEquals(FIXTURE.image().luminance(), Screen.app().archive.photos.get(0).luminance().luminance());
            assertEquals(Screen.app().archive.results.get(0).detections().imageName(),
                    Screen.app().archive.photos.get(0).name());
            assertTrue(rows(screen), rows(screen).contains("Saved as lifted-4-1"));
            assertFalse("a second tap would keep it twice", screen.find(R.id.save).isEnabled());
            assertTrue(screen.find(R.id.share).isEnabled());
        }
    }

    @Test
    public void frozenFrameIsSampledToItsEndAndTheCameraGoesOnAfterwards() {
        try (Screen screen = live()) {
            feed().frame(FIXTURE.image());
            screen.until("figures", () -> screen.state().canFreeze());
            screen.tap(R.id.freeze);
            screen.until("result", () -> screen.state().verdict() != null);
            assertEquals(ImageSource.FROZEN, screen.state().source());
            assertEquals("kept in case the system ends the app", 1, frozenFrames());
            screen.tap(R.id.freeze);
            assertEquals("and no longer than that", 0, frozenFrames());
            assertEquals(ImageSource.LIVE, screen.state().source());
            assertNull(screen.state().result());
            screen.holdStillUntilResult(FIXTURE);
            assertEquals("Pass – target met", screen.text(R.id.banner_headline));
        }
    }

    @Test
    public void resultIsKeptAgainUnderAnotherTarget() {
        try (Screen screen = live()) {
            screen.holdStillUntilResult(FIXTURE);
            screen.tap(R.id.save);
            screen.session().chooseTarget(Target.ofStdMm(OptionalDouble.of(0.3)));
            screen.settle();
            assertTrue(rows(screen), rows(screen).contains("Saved before: lifted-4-1"));
            screen.tap(R.id.save);
            assertEquals(OptionalDouble.of(0.3), Screen.app().archive.results.get(1).cell().targetStdMm());
            assertEquals(Verdict.FAIL, Screen.app().archive.results.get(1).verdict());
        }
    }

    @Test
    public void fullStorageIsSaidAndSavingCanBeTriedAgain() {
        Screen.app().archive.fault = new StorageFullException(6_000_000, 2_000_000);
        try (Screen screen = live()) {
            screen.holdStillUntilResult(FIXTURE);
            screen.tap(R.id.save);
            assertTrue(rows(screen), rows(screen).contains("Not saved: no room on the device"));
            assertTrue(rows(screen), rows(screen).contains("the result takes 6.0 MB and 2.0 MB are free"));
            assertFalse(screen.find(R.id.share).isEnabled());
            Screen.app().archive.fault = null;
            tapRow(screen, "Save again");
            assertTrue(rows(screen), rows(screen).contains("Saved as lifted-4-1"));
        }
    }

    @Test
    public void failedSavingIsSaid() {
        Screen.app().archive.fault = new IOException("the card was removed");
        try (Screen screen = live()) {
            screen.holdStillUntilResult(FIXTURE);
            screen.tap(R.id.save);
            assertTrue(rows(screen), rows(screen).contains("Not saved\nthe card was removed"));
        }
    }

    /** Read as every Android can read it. */
    @Test
    @SuppressWarnings("deprecation")
    public void savedResultIsSharedWithTheRightToReadIt() {
        try (Screen screen = live()) {
            screen.holdStillUntilResult(FIXTURE);
            screen.tap(R.id.save);
            screen.tap(R.id.share);
            Intent chooser = shadowOf(screen.activity()).getNextStartedActivity();
            Intent shared = chooser.getParcelableExtra(Intent.EXTRA_INTENT);
            assertEquals(Intent.ACTION_SEND_MULTIPLE, shared.getAction());
            List<Uri> uris = shared.getParcelableArrayListExtra(Intent.EXTRA_STREAM);
            assertEquals(Arrays.asList(Uri.parse("content://results/lifted-4-1.png"),
                    Uri.parse("content://results/lifted-4-1.result.json")), uris);
            assertTrue((shared.getFlags() & Intent.FLAG_GRANT_READ_URI_PERMISSION) != 0);
            ClipData clip = shared.getClipData();
            assertEquals(uris.get(0), clip.getItemAt(0).getUri());
            assertEquals(uris.get(1), clip.getItemAt(1).getUri());
        }
    }

    // ---- permission

    @Test
    public void permissionIsAskedForInContextAndRefusalIsNoEnd() {
        try (Screen screen = Screen.start()) {
            screen.chooseCell(FIXTURE.document());
            assertEquals("CellGauge needs access to the camera", screen.text(R.id.message_title));
            assertEquals("The camera is off", screen.text(R.id.banner_headline));
            assertNull("nothing is asked before the user knows why",
                    shadowOf(screen.activity()).getLastRequestedPermission());
            screen.tap(R.id.message_first);
            ShadowActivity.PermissionsRequest asked = shadowOf(screen.activity()).getLastRequestedPermission();
            assertArrayEquals(new String[] {Manifest.permission.CAMERA}, asked.requestedPermissions);
            screen.activity().onRequestPermissionsResult(asked.requestCode, asked.requestedPermissions,
                    new int[] {PackageManager.PERMISSION_DENIED});
            screen.settle();
            assertEquals("Open settings", screen.text(R.id.message_first));
            // a dialog that was only put aside can be asked for again
            assertEquals("Allow access", screen.text(R.id.message_second));
            assertEquals("Open a saved photo", screen.text(R.id.message_third));
            assertFalse(screen.activity().isFinishing());
            screen.tap(R.id.message_first);
            Intent settings = shadowOf(screen.activity()).getNextStartedActivity();
            assertEquals(Settings.ACTION_APPLICATION_DETAILS_SETTINGS, settings.getAction());
            assertEquals("package:org.cellgauge.android", settings.getDataString());
            // given there; the camera starts by itself
            screen.pause();
            Screen.allowCamera();
            screen.resume();
            assertTrue(feed().isOpen());
            assertFalse(messageShown(screen));
        }
    }

    @Test
    public void photosAreCheckedWithoutThePermission() {
        try (Screen screen = Screen.start()) {
            screen.chooseCell(FIXTURE.document());
            screen.openPhoto(FIXTURE.photo());
            screen.until("result", () -> screen.state().verdict() != null);
            assertFalse(messageShown(screen));
            assertEquals(0, feed().openings);
        }
    }

    @Test
    public void permissionTakenBackWhileAwayIsNoticed() {
        try (Screen screen = live()) {
            assertTrue(feed().isOpen());
            screen.pause();
            shadowOf(Screen.app()).denyPermissions(Manifest.permission.CAMERA);
            screen.resume();
            assertFalse(feed().isOpen());
            assertEquals("CellGauge needs access to the camera", screen.text(R.id.message_title));
        }
    }

    // ---- what belongs to what

    @Test
    public void figuresOfBeforeLieOnNoNewViewBeforeItsFirstFrame() {
        try (Screen screen = live()) {
            screen.holdStillUntilResult(FIXTURE);
            CheckResult result = screen.state().result();
            screen.pause();
            screen.resume();
            feed().opened(FIXTURE.cell().camera(), 90, false);
            screen.settle();
            assertEquals("Focusing…", screen.text(R.id.banner_headline));
            assertNull(screen.state().overlay());
            assertFalse(rows(screen), rows(screen).contains("Object 5"));
            feed().frame(FIXTURE.image());
            screen.until("the same view", () -> !screen.state().awaitsFrame());
            assertEquals("Pass – target met", screen.text(R.id.banner_headline));
            assertSame(result, screen.state().result());
            assertTrue(rows(screen), rows(screen).contains("Object 5 – deviation within 3 mm"));

            screen.tap(R.id.refocus);
            assertEquals("Focusing…", screen.text(R.id.banner_headline));
            assertNull(screen.state().overlay());
            feed().frame(FIXTURE.image());
            screen.until("focused", () -> !screen.state().awaitsFrame());
            assertEquals("Pass – target met", screen.text(R.id.banner_headline));
        }
    }

    @Test
    public void cameraThatWasOpenedForTheCellBeforeIsNotHeardAnyMore() {
        try (Screen screen = live()) {
            feed().frame(FIXTURE.image());
            screen.until("quick look", () -> screen.state().live() != null);
            CameraFeed.Listener before = feed().listener();
            screen.chooseCell(new CellDocument("other.yaml", "content://cells/other", FIXTURE.cell(), null));
            before.onOpened(new CameraSetup(FIXTURE.cell().camera(), CameraModelSource.CALIBRATION_FILE, 90, false,
                    EnumSet.noneOf(CameraNote.class)));
            before.onFrame(FIXTURE.image(), Long.MAX_VALUE);
            screen.settle();
            assertNull(screen.state().setup());
            assertNull(screen.state().live());
            // nor is its calibration taken for a photo
            screen.openPhoto(FIXTURE.photo());
            assertEquals("The camera of this photo is not known", screen.text(R.id.message_title));
        }
    }

    @Test
    public void calibrationChosenForARefusedPhotoChecksItAgainstTheTargetThatWasChosen() {
        CellDocument bare = new CellDocument("bare.yaml", "content://cells/bare", FIXTURE.cell(), null);
        try (Screen screen = Screen.start()) {
            screen.chooseCell(bare);
            screen.session().chooseTarget(Target.ofStdMm(OptionalDouble.of(0.3)));
            screen.openPhoto(FIXTURE.photo());
            assertEquals("The camera of this photo is not known", screen.text(R.id.message_title));
            assertEquals("Choose calibration file", screen.text(R.id.message_second));
            Screen.app().library.cells.put(bare.uri(), () -> new CellDocument("bare.yaml", bare.uri(), FIXTURE.cell(),
                    FIXTURE.cell().camera()));
            screen.tap(R.id.message_second);
            ShadowActivity.IntentForResult asked = shadowOf(screen.activity()).getNextStartedActivityForResult();
            shadowOf(screen.activity()).receiveResult(asked.intent, Activity.RESULT_OK,
                    new Intent().setData(Uri.parse("content://calibrations/tablet")));
            screen.settle();
            assertEquals(Arrays.asList(null, "content://calibrations/tablet"), Screen.app().library.calibrations);
            screen.until("result", () -> screen.state().verdict() != null);
            assertEquals(ImageSource.PHOTO, screen.state().source());
            assertEquals("lifted-4.png", screen.state().still().name());
            assertEquals(OptionalDouble.of(0.3), screen.state().targetStdMm());
            assertEquals("Target missed", screen.text(R.id.banner_headline));
            assertEquals(Estimate.NONE, screen.state().result().settings().model().estimate());
        }
    }

    @Test
    public void photoAskedForWhileACalibrationIsReadIsTheOneThatIsChecked() {
        TestScheduler files = new TestScheduler();
        Screen.app().threads = () -> new SessionThreads(Schedulers.trampoline(), files, null, null);
        CellDocument document = FIXTURE.document();
        Screen.app().library.cells.put(document.uri(), () -> document);
        Photo mine = new Photo("mine.png", FIXTURE.image());
        Screen.app().library.photos.put("content://photos/mine.png", () -> mine);
        try (Screen screen = Screen.start()) {
            screen.session().chooseCell(document.uri());
            files.triggerActions();
            screen.session().chooseCalibration("content://calibrations/tablet");
            screen.session().openPhoto("content://photos/mine.png");
            files.triggerActions();
            screen.until("result", () -> screen.state().verdict() != null);
            assertEquals("mine.png", screen.state().still().name());
        }
    }

    @Test
    @Config(minSdk = 27)
    public void lensIsEstimatedWhereNobodyMeasuredIt() {
        CellDocument bare = new CellDocument("bare.yaml", "content://cells/bare", FIXTURE.cell(), null);
        Screen.allowCamera();
        try (Screen screen = Screen.start()) {
            screen.chooseCell(bare);
            screen.settle();
            feed().opened(FIXTURE.cell().camera(), CameraModelSource.FIELD_OF_VIEW, 90, false);
            screen.settle();
            screen.holdStillUntilResult(FIXTURE);
            assertEquals(Estimate.INTRINSICS, screen.state().result().settings().model().estimate());
            screen.openPhoto(FIXTURE.photo());
            screen.until("result", () -> screen.state().verdict() != null);
            assertEquals(Estimate.INTRINSICS, screen.state().result().settings().model().estimate());
        }
    }

    @Test
    public void turningWhileChainsRunLeavesThemRunning() {
        Screen.app().settings = CheckSettings.builder().targetMcseStdRel(1e-9).build();
        try (Screen screen = live()) {
            feed().frame(FIXTURE.image());
            screen.until("quick look", () -> screen.state().live() != null);
            feed().frame(FIXTURE.image());
            screen.until("sampling", () -> screen.state().phase() == LiveState.Phase.SAMPLING
                    && screen.state().iterationsPerChain() > 1000);
            Detections key = screen.state().live().keyFrame();
            int before = screen.state().iterationsPerChain();
            screen.turn(Screen.TABLET_PORTRAIT, Surface.ROTATION_0);
            screen.until("more", () -> screen.state().iterationsPerChain() > before);
            assertSame(key, screen.state().live().keyFrame());
            assertEquals(LiveState.Phase.SAMPLING, screen.state().phase());
        }
    }

    @Test
    @Config(minSdk = 26)
    public void backLeadsFromAHeldFrameToTheCameraAndThenAsideWithoutAnEnd() {
        try (Screen screen = live()) {
            screen.holdStillUntilResult(FIXTURE);
            screen.tap(R.id.freeze);
            assertEquals(ImageSource.FROZEN, screen.state().source());
            assertTrue(screen.back());
            assertEquals(ImageSource.LIVE, screen.state().source());
            assertFalse(screen.activity().isFinishing());
            // from Android 13 on the system leads aside, and shows beforehand that it will
            assertEquals(Build.VERSION.SDK_INT < Build.VERSION_CODES.TIRAMISU, screen.back());
            assertFalse(screen.activity().isFinishing());
        }
    }

    // ---- the camera fails

    @Test
    public void everyFaultIsExplainedAndNoneEndsTheApp() {
        Set<String> explained = new HashSet<>();
        for (CameraFault fault : CameraFault.values()) {
            try (Screen screen = live()) {
                feed().fault(fault);
                screen.settle();
                assertEquals("The camera is off", screen.text(R.id.banner_headline));
                assertTrue(messageShown(screen));
                assertTrue(fault + ": " + screen.text(R.id.message_text), screen.text(R.id.message_text).length() > 20);
                String offers = screen.text(R.id.message_first) + screen.text(R.id.message_second)
                        + screen.text(R.id.message_third);
                assertTrue(offers, offers.contains("Open a saved photo"));
                assertTrue(fault.toString(), explained.add(screen.text(R.id.message_title)));
                assertTrue(fault.toString(), explained.add(screen.text(R.id.message_text)));
            }
        }
    }

    @Test
    public void cameraIsTriedAgainByTapAndOnReturn() {
        try (Screen screen = live()) {
            feed().fault(CameraFault.IN_USE);
            screen.settle();
            assertFalse(feed().isOpen());
            screen.tap(R.id.message_first);
            assertTrue(feed().isOpen());
            feed().fault(CameraFault.DISCONNECTED);
            screen.settle();
            screen.pause();
            screen.resume();
            assertTrue(feed().isOpen());
            assertEquals(3, feed().openings);
        }
    }

    @Test
    public void lostCameraLeavesItsLastFigures() {
        try (Screen screen = live()) {
            screen.holdStillUntilResult(FIXTURE);
            feed().fault(CameraFault.DISCONNECTED);
            screen.settle();
            assertFalse(messageShown(screen));
            assertEquals("Pass – target met", screen.text(R.id.banner_headline));
            assertEquals(View.VISIBLE, screen.find(R.id.still).getVisibility());
            assertTrue(rows(screen),
                    rows(screen).contains("The camera was disconnected. The last frame with figures is held."));
            screen.tap(R.id.save);
            assertArrayEquals(FIXTURE.image().luminance(), Screen.app().archive.photos.get(0).luminance().luminance());
            tapRow(screen, "Try again");
            assertTrue(feed().isOpen());
            assertEquals(ImageSource.LIVE, screen.state().source());
        }
    }

    @Test
    public void cameraRunsOnlyWhileTheAppIsInFront() {
        try (Screen screen = live()) {
            screen.pause();
            assertFalse(feed().isOpen());
            screen.resume();
            assertTrue(feed().isOpen());
        }
    }

    @Test
    public void cameraNotesAndModelAreSaid() {
        Screen.allowCamera();
        try (Screen screen = Screen.start()) {
            screen.chooseCell(new CellDocument("cell.yaml", "content://cells/own", FIXTURE.cell(), null));
            assertNull("the device's own model is asked for", feed().openedWith);
            feed().opened(FIXTURE.cell().camera(), CameraModelSource.FIELD_OF_VIEW, 90, false,
                    CameraNote.FOCUS_NOT_LOCKED, CameraNote.FOCAL_LENGTH_ESTIMATED);
            screen.settle();
            assertTrue(rows(screen), rows(screen).contains("From the lens's field of view only."));
            assertTrue(rows(screen), rows(screen).contains("The focus cannot be locked"));
            assertTrue(rows(screen), rows(screen).contains("The focal length is not calibrated"));
            screen.tap(R.id.refocus);
            assertEquals(1, feed().refocusings);
        }
    }

    // ---- warmth

    @Test
    public void warmDeviceStepsDownAndACriticalOneStopsTheCamera() {
        try (Screen screen = live()) {
            Screen.app().levels.onNext(ThermalLevel.WARM);
            screen.settle();
            assertTrue(rows(screen), rows(screen).contains("The device is warm"));
            Screen.app().levels.onNext(ThermalLevel.CRITICAL);
            screen.settle();
            assertFalse(feed().isOpen());
            assertEquals("The device is too hot", screen.text(R.id.message_title));
            Screen.app().levels.onNext(ThermalLevel.NORMAL);
            screen.settle();
            assertTrue(feed().isOpen());
            assertFalse(messageShown(screen));
        }
    }

    @Test
    public void hotDeviceDoesNotSampleAndTakesItUpWhenItHasCooled() {
        Screen.app().levels.onNext(ThermalLevel.HOT);
        try (Screen screen = Screen.start()) {
            screen.chooseCell(FIXTURE.document());
            screen.openPhoto(FIXTURE.photo());
            screen.until("quick look", () -> screen.state().phase() == LiveState.Phase.QUICK_LOOK);
            assertTrue(screen.text(R.id.reason), screen.text(R.id.reason).contains("too warm for sampling"));
            assertNull(screen.state().result());
            Screen.app().levels.onNext(ThermalLevel.NORMAL);
            screen.until("result", () -> screen.state().verdict() != null);
            assertEquals("Pass – target met", screen.text(R.id.banner_headline));
        }
    }

    // ---- files that are refused

    @Test
    public void refusedCellIsShownInFullAndTheOldOneStays() {
        try (Screen screen = live()) {
            Refusal refusal = Refusal.at(Place.of("kitchen.yaml", 7, 0, "references.944.position_mm"),
                    CellRefusal.EXPECTED, Refusal.of(CellPhrase.NUMBERS, 3), 2, "[x, y, z] in mm", "");
            Screen.app().library.cells.put("content://cells/kitchen", () -> {
                throw new InputRefusedException(refusal);
            });
            screen.session().chooseCell("content://cells/kitchen");
            screen.settle();
            assertEquals("kitchen.yaml, line 7, references.944.position_mm: expected 3 numbers, got 2; write [x, y, z] "
                    + "in mm", screen.text(R.id.message_text));
            assertTrue(((TextView) screen.find(R.id.message_text)).isTextSelectable());
            assertEquals("Keep lifted-4.yaml", screen.text(R.id.message_second));
            screen.tap(R.id.message_second);
            assertFalse(messageShown(screen));
            assertEquals("lifted-4.yaml", screen.state().cell().name());
        }
    }

    @Test
    public void photoOfAnotherSizeIsRefusedWithBothSizes() {
        try (Screen screen = live()) {
            screen.openPhoto(new Photo("small.png", GreyImage.packed(new byte[640 * 480], 640, 480)));
            assertEquals("The photo has another size", screen.text(R.id.message_title));
            assertTrue(screen.text(R.id.message_text), screen.text(R.id.message_text).contains("640 x 480 px"));
            assertTrue(screen.text(R.id.message_text), screen.text(R.id.message_text).contains("1280 x 720 px"));
            screen.tap(R.id.message_second);
            assertEquals(ImageSource.LIVE, screen.state().source());
            assertTrue(feed().isOpen());
        }
    }

    /** As a device's camera app takes them: the same picture in more pixels than the frames have. */
    @Test
    public void photoOfTheCalibratedShapeIsCheckedInItsOwnSize() {
        GreyImage frame = FIXTURE.image();
        int width = 2 * frame.widthPx();
        int height = 2 * frame.heightPx();
        byte[] grey = new byte[width * height];
        for (int i = 0; i < grey.length; i++) {
            grey[i] = (byte) Math.round(between(frame, (i % width + 0.5) / 2 - 0.5, (i / width + 0.5) / 2 - 0.5));
        }
        try (Screen screen = live()) {
            screen.openPhoto(new Photo("large.png", GreyImage.packed(grey, width, height)));
            screen.until("result", () -> screen.state().verdict() != null);
            assertEquals(width, screen.state().result().cell().camera().widthPx());
            CheckResult alone = CellCheck.run(FIXTURE.cell(),
                    BoofMarkerDetector.forCell(FIXTURE.cell()).detect(frame, "frame"), CheckSettings.builder().build());
            double[] large = screen.state().result().estimate().object(20).pose().mean();
            double[] small = alone.estimate().object(20).pose().mean();
            for (int axis = 0; axis < 3; axis++) {
                assertEquals(small[axis], large[axis], 1.5);
            }
            assertTrue(rows(screen), rows(screen).contains("The photo has 2560 × 1440 px"));
        }
    }

    /** A grey value between four pixels, whose middles have whole coordinates. */
    private static double between(GreyImage image, double x, double y) {
        int left = Math.max(0, Math.min(image.widthPx() - 2, (int) Math.floor(x)));
        int top = Math.max(0, Math.min(image.heightPx() - 2, (int) Math.floor(y)));
        double toRight = Math.max(0, Math.min(1, x - left));
        double down = Math.max(0, Math.min(1, y - top));
        return (1 - down) * ((1 - toRight) * image.get(left, top) + toRight * image.get(left + 1, top))
                + down * ((1 - toRight) * image.get(left, top + 1) + toRight * image.get(left + 1, top + 1));
    }

    @Test
    public void photoThatCannotBeReadIsRefusedWithItsReason() {
        try (Screen screen = live()) {
            Screen.app().library.photos.put("content://photos/broken", () -> {
                throw new InputRefusedException("broken.png", FileRefusal.CUT_SHORT);
            });
            screen.session().openPhoto("content://photos/broken");
            screen.settle();
            assertEquals("The photo was refused", screen.text(R.id.message_title));
            assertEquals("broken.png: it is cut short; copy it again", screen.text(R.id.message_text));
        }
    }

    @Test
    public void photoWithoutReferencesCannotBeJudged() {
        try (Screen screen = live()) {
            screen.openPhoto(new Photo("wall.png", FIXTURE.blank()));
            screen.until("search", () -> screen.state().phase() == LiveState.Phase.SEARCHING);
            assertEquals("No reference in view", screen.text(R.id.banner_headline));
            assertFalse(screen.find(R.id.save).isEnabled());
        }
    }

    @Test
    public void photoOfAnUnknownCameraIsNotChecked() {
        try (Screen screen = Screen.start()) {
            screen.chooseCell(
                    new CellDocument("cell.yaml", "content://cells/own", FIXTURE.cell(), null, "camera.yaml"));
            assertTrue(rows(screen), rows(screen).contains("The cell file names the camera camera.yaml"));
            screen.openPhoto(FIXTURE.photo());
            assertEquals("The camera of this photo is not known", screen.text(R.id.message_title));
            assertEquals("Choose calibration file", screen.text(R.id.message_second));
        }
    }

    // ---- turning and dying

    @Test
    public void turningTheDeviceLosesNothing() {
        try (Screen screen = live()) {
            screen.holdStillUntilResult(FIXTURE);
            CheckSession session = screen.session();
            CheckResult result = screen.state().result();
            screen.session().chooseTarget(Target.ofStdMm(OptionalDouble.of(0.3)));
            MainActivity before = screen.activity();
            screen.turn(Screen.TABLET_PORTRAIT, Surface.ROTATION_0);
            assertNotSame(before, screen.activity());
            assertSame(session, screen.session());
            assertSame(result.draws(), screen.state().result().draws());
            assertEquals("Target missed", screen.text(R.id.banner_headline));
            assertEquals(0, screen.state().displayRotationDeg());
            assertEquals(720, screen.state().overlay().widthPx());
            assertTrue("the camera runs on the new screen", feed().isOpen());
            assertEquals(2, feed().openings);
        }
    }

    @Test
    public void halfATurnIsNoticedWithoutANewActivity() {
        try (Screen screen = live()) {
            screen.holdStillUntilResult(FIXTURE);
            assertFalse(screen.state().orientation().mirrored());
            assertEquals(0, screen.state().orientation().quarterTurnsClockwise());
            Screen.turnDisplay(Surface.ROTATION_270);
            screen.settle();
            assertEquals(2, screen.state().orientation().quarterTurnsClockwise());
        }
    }

    @Test
    public void frozenCheckComesBackAfterTheProcessWasEnded() {
        Bundle kept;
        double[] std;
        try (Screen screen = live()) {
            screen.session().chooseTarget(Target.ofStdMm(OptionalDouble.of(2.5)));
            screen.holdStillUntilResult(FIXTURE);
            screen.tap(R.id.freeze);
            std = screen.state().result().estimate().object(20).pose().std();
            kept = screen.killed();
        }
        Bundle parcelled = throughAParcel(kept);
        try (Screen screen = Screen.start(parcelled)) {
            screen.until("result", () -> screen.state().verdict() != null);
            assertEquals(ImageSource.FROZEN, screen.state().source());
            assertEquals("lifted-4.yaml", screen.state().cell().name());
            assertEquals(OptionalDouble.of(2.5), screen.state().targetStdMm());
            assertArrayEquals(FIXTURE.image().luminance(), screen.state().still().luminance().luminance());
            assertArrayEquals("same photo, same seed, same figures", std,
                    screen.state().result().estimate().object(20).pose().std(), 0);
            screen.tap(R.id.freeze);
            assertEquals(ImageSource.LIVE, screen.state().source());
        }
    }

    /** Two screens of the app, as a split screen has them: each comes back to what was frozen on it. */
    @Test
    public void twoScreensFreezeTwoFrames() {
        GreyImage first = FIXTURE.image();
        byte[] grey = first.luminance().clone();
        grey[0] ^= 1;
        GreyImage second = GreyImage.packed(grey, first.widthPx(), first.heightPx());
        Bundle ofFirst = killedWithFrozen(first);
        Bundle ofSecond = killedWithFrozen(second);
        assertEquals(2, frozenFrames());
        assertComesBack(ofFirst, first);
        assertComesBack(ofSecond, second);
    }

    private static Bundle killedWithFrozen(GreyImage frame) {
        try (Screen screen = live()) {
            feed().frame(frame);
            screen.until("figures", () -> screen.state().canFreeze());
            screen.tap(R.id.freeze);
            return throughAParcel(screen.killed());
        }
    }

    private static void assertComesBack(Bundle kept, GreyImage frame) {
        int before = frozenFrames();
        try (Screen screen = Screen.start(kept)) {
            screen.until("frame", () -> screen.state().still() != null);
            assertArrayEquals(frame.luminance(), screen.state().still().luminance().luminance());
            screen.activity().finish();
        }
        assertEquals("nobody comes back to a screen that has ended", before - 1, frozenFrames());
    }

    @Test
    public void photoCheckStartsAgainAfterTheProcessWasEnded() {
        Bundle kept;
        try (Screen screen = Screen.start()) {
            screen.chooseCell(FIXTURE.document());
            screen.openPhoto(FIXTURE.photo());
            // in the middle of it
            kept = screen.killed();
        }
        try (Screen screen = Screen.start(throughAParcel(kept))) {
            screen.until("result", () -> screen.state().verdict() != null);
            assertEquals(ImageSource.PHOTO, screen.state().source());
            assertEquals("lifted-4.png", screen.state().still().name());
            assertEquals("Pass – target met", screen.text(R.id.banner_headline));
        }
    }

    @Test
    public void liveCheckComesBackWithCellCalibrationAndTargetAfterTheProcessWasEnded() {
        Screen.allowCamera();
        Bundle kept;
        try (Screen screen = Screen.start()) {
            screen.chooseCell(FIXTURE.document());
            screen.session().chooseCalibration("content://calibrations/tablet");
            screen.settle();
            screen.session().chooseTarget(Target.ofStdMm(OptionalDouble.of(0.3)));
            screen.settle();
            feed().opened(FIXTURE.cell().camera(), 90, false);
            screen.holdStillUntilResult(FIXTURE);
            kept = screen.killed();
        }
        Screen.app().library.calibrations.clear();
        try (Screen screen = Screen.start(throughAParcel(kept))) {
            screen.settle();
            assertEquals("lifted-4.yaml", screen.state().cell().name());
            assertEquals(Arrays.asList("content://calibrations/tablet"), Screen.app().library.calibrations);
            assertEquals(ImageSource.LIVE, screen.state().source());
            assertTrue(feed().isOpen());
            feed().opened(FIXTURE.cell().camera(), 90, false);
            screen.holdStillUntilResult(FIXTURE);
            assertEquals(OptionalDouble.of(0.3), screen.state().targetStdMm());
            assertEquals("Target missed", screen.text(R.id.banner_headline));
        }
    }

    @Test
    public void exampleComesBackAfterTheProcessWasEnded() {
        Bundle kept;
        try (Screen screen = Screen.start()) {
            screen.tap(R.id.message_second);
            kept = screen.killed();
        }
        try (Screen screen = Screen.start(throughAParcel(kept))) {
            screen.until("result", () -> screen.state().verdict() != null);
            assertEquals("Pass – target met", screen.text(R.id.banner_headline));
        }
    }

    private static Bundle throughAParcel(Bundle bundle) {
        Parcel parcel = Parcel.obtain();
        bundle.writeToParcel(parcel, 0);
        parcel.setDataPosition(0);
        Bundle read = Bundle.CREATOR.createFromParcel(parcel);
        read.setClassLoader(MainActivityTest.class.getClassLoader());
        parcel.recycle();
        return read;
    }

    // ---- the target's dialog

    @Test
    public void targetIsTypedInTheUsersNotation() {
        assertEquals(1.5, Decimals.parse("1,5"), 0);
        assertEquals(1.5, Decimals.parse(" 1.5"), 0);
        assertEquals(0.5, Decimals.parse(".5"), 0);
        assertEquals(2, Decimals.parse("2."), 0);
        for (String wrong : new String[] {"", ".", "1.2.3", "-1", "1e3", "abc"}) {
            assertTrue(wrong, Double.isNaN(Decimals.parse(wrong)));
        }
    }

    @Test
    public void targetDialogSetsRefusesAndSurvivesATurn() {
        try (Screen screen = live()) {
            screen.tap(R.id.target);
            AlertDialog dialog = (AlertDialog) ShadowDialog.getLatestDialog();
            EditText field = dialog.findViewById(R.id.target_field);
            assertEquals("3", field.getText().toString());
            field.setText("0");
            dialog.getButton(AlertDialog.BUTTON_POSITIVE).performClick();
            screen.settle();
            assertTrue(dialog.isShowing());
            assertNotNull(field.getError());
            field.setText("0.75");
            screen.turn(Screen.TABLET_PORTRAIT, Surface.ROTATION_0);
            dialog = (AlertDialog) ShadowDialog.getLatestDialog();
            assertTrue(dialog.isShowing());
            field = dialog.findViewById(R.id.target_field);
            assertEquals("0.75", field.getText().toString());
            dialog.getButton(AlertDialog.BUTTON_POSITIVE).performClick();
            screen.settle();
            assertFalse(dialog.isShowing());
            assertEquals(OptionalDouble.of(0.75), screen.state().targetStdMm());
        }
    }

    // ---- licences

    private static AlertDialog licences(Screen screen) {
        AlertDialog dialog = (AlertDialog) ShadowDialog.getLatestDialog();
        TextView text = dialog.findViewById(R.id.licences_text);
        screen.until("licences", () -> !"Reading…".contentEquals(text.getText()));
        return dialog;
    }

    /** The first start has the row, too: whoever has no cell has the libraries all the same. */
    @Test
    public void licencesAreReadFromTheLastRowWithAndWithoutACell() {
        try (Screen screen = Screen.start()) {
            assertEquals("Four steps to the first check\nPrint markers, measure, write the cell file, calibrate.\n"
                    + "About CellGauge " + System.getProperty("cellgauge.version") + "\n", rows(screen));
            tapRow(screen, "Licences");
            AlertDialog dialog = licences(screen);
            TextView text = dialog.findViewById(R.id.licences_text);
            String said = text.getText().toString();
            assertTrue(said, said.contains("Apache Commons Math\nCopyright 2001-2016 The Apache Software Foundation"));
            assertTrue(said, said.contains("This product includes software developed for Orekit by"));
            assertTrue(said, said.contains("- boofcv-recognition 1.2.2 (org.boofcv): Apache License 2.0\n"));
            assertTrue(text.isTextSelectable());
            dialog.getButton(AlertDialog.BUTTON_POSITIVE).performClick();
            screen.settle();
            assertFalse(dialog.isShowing());
            screen.chooseCell(FIXTURE.document());
            assertTrue(rows(screen), rows(screen).endsWith(
                    "\nAbout CellGauge " + System.getProperty("cellgauge.version") + "\n"));
        }
    }

    @Test
    public void licencesStayWhereTheyWereReadToThroughATurn() {
        try (Screen screen = live()) {
            tapRow(screen, "Licences");
            AlertDialog dialog = licences(screen);
            TextView before = dialog.findViewById(R.id.licences_text);
            int wanted = before.getText().toString().indexOf("Minpack Copyright Notice");
            View page = dialog.findViewById(R.id.licences_page);
            page.scrollTo(0, before.getLayout().getLineTop(before.getLayout().getLineForOffset(wanted)));
            screen.turn(Screen.TABLET_PORTRAIT, Surface.ROTATION_0);
            assertFalse(dialog.isShowing());
            dialog = licences(screen);
            assertTrue(dialog.isShowing());
            TextView after = dialog.findViewById(R.id.licences_text);
            assertNotSame(before, after);
            page = dialog.findViewById(R.id.licences_page);
            int line = after.getLayout().getLineForVertical(page.getScrollY());
            assertTrue(page.getScrollY() > 0);
            assertEquals(after.getLayout().getLineForOffset(wanted), line);
            dialog.dismiss();
            screen.turn(Screen.TABLET_LANDSCAPE, Surface.ROTATION_90);
            assertFalse("closed is closed", ShadowDialog.getLatestDialog().isShowing());
        }
    }

    // ---- the picture that is kept

    @Test
    public void overlayPictureHasPhotoShapesBannerAndLegend() {
        CheckResult result = CellCheck.run(FIXTURE.cell(),
                BoofMarkerDetector.forCell(FIXTURE.cell()).detect(FIXTURE.image(), "photo"),
                CheckSettings.builder().build());
        Overlay overlay = CellOverlay.of(result);
        Bitmap painted = OverlayPainter.paint(FIXTURE.image(), overlay);
        Screen.write("overlay-picture", painted);
        BufferedImage desktop = org.cellgauge.desktop.OverlayPainter.paint(FIXTURE.image(), overlay);
        long difference = 0;
        int far = 0;
        for (int y = 0; y < painted.getHeight(); y++) {
            for (int x = 0; x < painted.getWidth(); x++) {
                int a = painted.getPixel(x, y);
                int b = desktop.getRGB(x, y);
                int d = Math.abs((a >> 16 & 0xFF) - (b >> 16 & 0xFF)) + Math.abs((a >> 8 & 0xFF) - (b >> 8 & 0xFF))
                        + Math.abs((a & 0xFF) - (b & 0xFF));
                difference += d;
                far += d > 150 ? 1 : 0;
            }
        }
        double pixels = (double) painted.getWidth() * painted.getHeight();
        // two renderers differ in how they smooth edges, and in nothing else
        assertTrue("mean difference " + difference / pixels / 3, difference / pixels / 3 < 1);
        assertTrue(far + " pixels far off", far < 0.001 * pixels);
    }
}
