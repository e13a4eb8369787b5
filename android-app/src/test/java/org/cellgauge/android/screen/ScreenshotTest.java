package org.cellgauge.android.screen;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import android.app.Dialog;
import android.view.Surface;
import android.view.View;
import android.widget.TextView;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import org.cellgauge.android.R;
import org.cellgauge.android.camera.CameraFault;
import org.cellgauge.android.camera.CameraModelSource;
import org.cellgauge.android.camera.CameraNote;
import org.cellgauge.android.device.ThermalLevel;
import org.cellgauge.android.files.CellDocument;
import org.cellgauge.android.files.Photo;
import org.cellgauge.android.files.StorageFullException;
import org.cellgauge.android.state.CameraPermission;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellRefusal;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.internal.cell.CellPhrase;
import org.cellgauge.live.LiveState;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.GreyImage;
import org.cellgauge.warning.CheckWarning;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;
import org.cellgauge.warning.WarningKind;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.annotation.Config;
import org.robolectric.shadows.ShadowDialog;

/**
 * Pictures of the screens, for people to look at: android-app/build/screenshots. The camera's own picture is painted in
 * from the fixture, since no camera draws here. Those that need many checks are of the newest Android only.
 */
@RunWith(RobolectricTestRunner.class)
@Config(application = TestApp.class, minSdk = 27)
public class ScreenshotTest {
    private static final Fixture FIXTURE = Fixture.LIFTED;
    /** More than any run can reach: chains go on as long as a picture takes. */
    private static final double NEVER_PRECISE_ENOUGH = 1e-9;

    private static Screen live(String qualifiers, Cell cell) {
        return live(qualifiers, FIXTURE.document(cell));
    }

    private static Screen live(String qualifiers, CellDocument document) {
        RuntimeEnvironment.setQualifiers(qualifiers);
        Screen.turnDisplay(qualifiers.contains("-land") ? Surface.ROTATION_90 : Surface.ROTATION_0);
        return Screen.live(document, 90, false);
    }

    private static void passAs(String name, String qualifiers, float fontScale) {
        RuntimeEnvironment.setFontScale(fontScale);
        try (Screen screen = live(qualifiers, FIXTURE.cell())) {
            screen.holdStillUntilResult(FIXTURE);
            screen.keep(name, FIXTURE.photo());
            assertEquals(Banner.PASS, Banner.of(screen.shown()));
        }
    }

    @Test
    public void firstStart() {
        for (String qualifiers : new String[] {Screen.TABLET_LANDSCAPE, Screen.TABLET_PORTRAIT, Screen.PHONE_PORTRAIT,
            Screen.PHONE_LANDSCAPE}) {
            RuntimeEnvironment.setQualifiers(qualifiers);
            try (Screen screen = Screen.start()) {
                screen.keep("first-start-" + size(qualifiers), null);
                assertEquals(Banner.NO_CELL, Banner.of(screen.shown()));
            }
        }
    }

    private static String size(String qualifiers) {
        boolean tablet = qualifiers.equals(Screen.TABLET_LANDSCAPE) || qualifiers.equals(Screen.TABLET_PORTRAIT);
        return (tablet ? "tablet" : "phone") + (qualifiers.contains("-land") ? "-landscape" : "-portrait");
    }

    @Test
    public void pass() {
        for (String qualifiers : new String[] {Screen.TABLET_LANDSCAPE, Screen.PHONE_PORTRAIT}) {
            passAs("pass-" + size(qualifiers), qualifiers, 1);
        }
    }

    @Test
    @Config(minSdk = 27)
    public void passOnOtherScreens() {
        for (String qualifiers : new String[] {Screen.TABLET_PORTRAIT, Screen.PHONE_LANDSCAPE}) {
            passAs("pass-" + size(qualifiers), qualifiers, 1);
        }
        passAs("pass-dark", Screen.TABLET_LANDSCAPE.replace("notnight", "night"), 1);
        passAs("pass-german", "de-" + Screen.TABLET_LANDSCAPE, 1);
        passAs("pass-german-phone", "de-" + Screen.PHONE_PORTRAIT, 1);
    }

    @Test
    @Config(minSdk = 27)
    public void passAtTwiceTheSizeOfLetters() {
        passAs("pass-large-letters-tablet-landscape", Screen.TABLET_LANDSCAPE, 2);
        passAs("pass-large-letters-tablet-portrait-german", "de-" + Screen.TABLET_PORTRAIT, 2);
        passAs("pass-large-letters-phone-portrait", Screen.PHONE_PORTRAIT, 2);
        passAs("pass-large-letters-phone-landscape", Screen.PHONE_LANDSCAPE, 2);
    }

    @Test
    public void quickLook() {
        Screen.app().levels.onNext(ThermalLevel.HOT);
        try (Screen screen = live(Screen.TABLET_LANDSCAPE, FIXTURE.cell())) {
            Screen.app().feed.frame(FIXTURE.image());
            screen.until("quick look", () -> screen.state().phase() == LiveState.Phase.QUICK_LOOK);
            screen.keep("quick-look-hot", FIXTURE.photo());
            assertEquals(Banner.QUICK_LOOK, Banner.of(screen.shown()));
        }
    }

    @Test
    public void sampling() {
        Screen.app().settings = CheckSettings.builder().targetMcseStdRel(NEVER_PRECISE_ENOUGH)
                .maxIterations(100_000_000).build();
        for (String language : new String[] {"", "de-"}) {
            try (Screen screen = live(language + Screen.TABLET_LANDSCAPE, FIXTURE.cell())) {
                Screen.app().feed.frame(FIXTURE.image());
                screen.until("quick look", () -> screen.state().live() != null);
                Screen.app().feed.frame(FIXTURE.image());
                screen.until("sampling", () -> screen.state().phase() == LiveState.Phase.SAMPLING
                        && screen.state().iterationsPerChain() > 0);
                screen.keep("sampling" + (language.isEmpty() ? "" : "-german"), FIXTURE.photo());
                assertEquals(Banner.SAMPLING, Banner.of(screen.shown()));
            }
        }
    }

    @Test
    @Config(minSdk = 27)
    public void verdicts() {
        verdict("fail", Banner.FAIL, FIXTURE.cell().withTarget(OptionalDouble.of(0.3)), Screen.TABLET_LANDSCAPE);
        verdict("fail-dark", Banner.FAIL, FIXTURE.cell().withTarget(OptionalDouble.of(0.3)),
                Screen.TABLET_LANDSCAPE.replace("notnight", "night"));
        verdict("fail-german-portrait", Banner.FAIL, FIXTURE.cell().withTarget(OptionalDouble.of(0.3)),
                "de-" + Screen.TABLET_PORTRAIT);
        verdict("no-target", Banner.NO_TARGET, FIXTURE.cell().withTarget(OptionalDouble.empty()),
                Screen.TABLET_LANDSCAPE);
        verdict("ambiguous", Banner.AMBIGUOUS, Fixture.with(FIXTURE.cell(), 0.3, OptionalDouble.of(3)),
                Screen.TABLET_LANDSCAPE);
        verdict("ambiguous-dark-german", Banner.AMBIGUOUS, Fixture.with(FIXTURE.cell(), 0.3, OptionalDouble.of(3)),
                "de-" + Screen.TABLET_LANDSCAPE.replace("notnight", "night"));
        // as many draws as cannot do
        Screen.app().settings = CheckSettings.builder().iterations(260).build();
        verdict("not-converged", Banner.NOT_CONVERGED, FIXTURE.cell(), Screen.TABLET_LANDSCAPE);
        verdict("not-converged-dark", Banner.NOT_CONVERGED, FIXTURE.cell(),
                Screen.TABLET_LANDSCAPE.replace("notnight", "night"));
        verdict("not-converged-german", Banner.NOT_CONVERGED, FIXTURE.cell(), "de-" + Screen.TABLET_PORTRAIT);
    }

    /** A reference stated wrongly, corner noise not stated, an object that is not there, small markers. */
    @Test
    @Config(minSdk = 27)
    public void warnings() {
        for (String qualifiers : new String[] {Screen.TABLET_LANDSCAPE, "de-" + Screen.TABLET_LANDSCAPE,
            "de-" + Screen.PHONE_PORTRAIT}) {
            try (Screen screen = live(qualifiers, FIXTURE.doubtful())) {
                screen.holdStillUntilResult(FIXTURE);
                screen.find(R.id.panel).scrollTo(0, 10_000);
                String german = qualifiers.startsWith("de") ? "-german-" + size(qualifiers.substring(3)) : "";
                screen.keep("warnings" + german, FIXTURE.photo());
                List<WarningKind> kinds = new ArrayList<>();
                screen.state().result().warnings().forEach(warning -> kinds.add(warning.kind()));
                // what is wrong with the references comes first
                assertEquals(Arrays.asList(CheckWarning.REFERENCE_OFF, CheckWarning.FIGURES_REST_ON_IT,
                        CheckWarning.OBJECTS_NOT_SEEN, CheckWarning.SMALL_MARKERS), kinds);
            }
        }
    }

    private static void verdict(String name, Banner expected, Cell cell, String qualifiers) {
        try (Screen screen = live(qualifiers, cell)) {
            screen.holdStillUntilResult(FIXTURE);
            screen.keep(name, FIXTURE.photo());
            assertEquals(expected, Banner.of(screen.shown()));
        }
    }

    @Test
    @Config(minSdk = 27)
    public void faults() {
        for (CameraFault fault : CameraFault.values()) {
            String name = "fault-" + fault.name().toLowerCase(Locale.ROOT).replace('_', '-');
            try (Screen screen = live(Screen.TABLET_LANDSCAPE, FIXTURE.cell())) {
                Screen.app().feed.fault(fault);
                screen.settle();
                screen.keep(name, null);
                assertEquals(Banner.CAMERA_OFF, Banner.of(screen.shown()));
            }
        }
        RuntimeEnvironment.setFontScale(2);
        try (Screen screen = live("de-" + Screen.PHONE_LANDSCAPE, FIXTURE.cell())) {
            Screen.app().feed.fault(CameraFault.DISABLED);
            screen.settle();
            screen.keep("fault-disabled-german-large-letters-phone", null);
        }
    }

    @Test
    public void cameraLostWithFigures() {
        try (Screen screen = live(Screen.TABLET_LANDSCAPE, FIXTURE.cell())) {
            screen.holdStillUntilResult(FIXTURE);
            Screen.app().feed.fault(CameraFault.DISCONNECTED);
            screen.settle();
            screen.find(R.id.panel).scrollTo(0, 10_000);
            screen.keep("lost-camera-held", null);
        }
    }

    @Test
    public void permission() {
        for (String language : new String[] {"", "de-"}) {
            RuntimeEnvironment.setQualifiers(language + Screen.PHONE_PORTRAIT);
            try (Screen screen = Screen.start()) {
                screen.chooseCell(FIXTURE.document());
                screen.keep("permission" + (language.isEmpty() ? "" : "-german"), null);
            }
        }
        RuntimeEnvironment.setQualifiers(Screen.TABLET_PORTRAIT);
        try (Screen screen = Screen.start()) {
            screen.chooseCell(FIXTURE.document());
            screen.session().permission(CameraPermission.REFUSED);
            screen.settle();
            screen.keep("permission-refused", null);
        }
    }

    @Test
    public void warmth() {
        try (Screen screen = live(Screen.TABLET_LANDSCAPE, FIXTURE.cell())) {
            Screen.app().levels.onNext(ThermalLevel.CRITICAL);
            screen.settle();
            screen.keep("heat-critical", null);
        }
        Screen.app().levels.onNext(ThermalLevel.WARM);
        try (Screen screen = live(Screen.TABLET_LANDSCAPE, FIXTURE.cell())) {
            Screen.app().feed.frame(FIXTURE.blank());
            screen.until("search", () -> screen.state().phase() == LiveState.Phase.SEARCHING);
            screen.keep("searching-warm", new Photo("blank", FIXTURE.blank()));
        }
    }

    @Test
    @Config(minSdk = 27)
    public void files() {
        RuntimeEnvironment.setQualifiers(Screen.TABLET_LANDSCAPE);
        try (Screen screen = Screen.start()) {
            Screen.app().library.cells.put("content://cells/kitchen", () -> {
                throw new InputRefusedException(Refusal.at(Place.of("kitchen.yaml", 7, 0,
                        "references.944.position_mm"), CellRefusal.EXPECTED, Refusal.of(CellPhrase.NUMBERS, 3), 2,
                        "[x, y, z] in mm", ""));
            });
            screen.session().chooseCell("content://cells/kitchen");
            screen.settle();
            screen.keep("cell-refused", null);
        }
        try (Screen screen = live(Screen.TABLET_LANDSCAPE, FIXTURE.cell())) {
            screen.openPhoto(new Photo("small.png", GreyImage.packed(new byte[640 * 480], 640, 480)));
            screen.keep("photo-size", null);
        }
        RuntimeEnvironment.setQualifiers(Screen.TABLET_PORTRAIT);
        try (Screen screen = Screen.start()) {
            screen.chooseCell(
                    new CellDocument("cell.yaml", "content://cells/own", FIXTURE.cell(), null, "camera.yaml"));
            screen.openPhoto(FIXTURE.photo());
            screen.keep("photo-without-camera", null);
        }
    }

    @Test
    @Config(minSdk = 26)
    public void keptAndNotKept() {
        try (Screen screen = live(Screen.TABLET_LANDSCAPE, FIXTURE.cell())) {
            screen.holdStillUntilResult(FIXTURE);
            screen.tap(R.id.freeze);
            screen.tap(R.id.save);
            screen.keep("frozen-and-saved", null);
        }
        Screen.app().archive.fault = new StorageFullException(2_100_000, 300_000);
        try (Screen screen = live(Screen.TABLET_PORTRAIT, FIXTURE.cell())) {
            screen.holdStillUntilResult(FIXTURE);
            screen.tap(R.id.save);
            screen.keep("storage-full", FIXTURE.photo());
        }
    }

    @Test
    public void cameraNotes() {
        Screen.allowCamera();
        RuntimeEnvironment.setQualifiers(Screen.TABLET_LANDSCAPE);
        Screen.turnDisplay(Surface.ROTATION_90);
        try (Screen screen = Screen.start()) {
            screen.chooseCell(
                    new CellDocument("cell.yaml", "content://cells/own", FIXTURE.cell(), null, "camera.yaml"));
            Screen.app().feed.opened(FIXTURE.cell().camera(), CameraModelSource.FIELD_OF_VIEW, 90, false,
                    CameraNote.values());
            screen.holdStillUntilResult(FIXTURE);
            screen.keep("camera-notes", FIXTURE.photo());
            screen.find(R.id.panel).scrollTo(0, 800);
            screen.keep("camera-notes-scrolled", FIXTURE.photo());
        }
    }

    @Test
    public void exampleWithoutACamera() {
        RuntimeEnvironment.setQualifiers("de-" + Screen.PHONE_LANDSCAPE.replace("notnight", "night"));
        try (Screen screen = Screen.start()) {
            screen.tap(R.id.message_second);
            screen.until("result", () -> screen.state().verdict() != null);
            screen.keep("example-phone-german-dark", null);
        }
    }

    @Test
    public void frontCameraUpright() {
        RuntimeEnvironment.setQualifiers(Screen.TABLET_PORTRAIT);
        Screen.turnDisplay(Surface.ROTATION_0);
        try (Screen screen = Screen.live(FIXTURE.document(), 270, true)) {
            screen.holdStillUntilResult(FIXTURE);
            screen.keep("front-camera", FIXTURE.photo());
            assertTrue(screen.state().orientation().mirrored());
        }
    }

    @Test
    public void target() {
        for (String qualifiers : new String[] {Screen.TABLET_LANDSCAPE, "de-" + Screen.PHONE_PORTRAIT}) {
            try (Screen screen = live(qualifiers, FIXTURE.cell())) {
                screen.tap(R.id.target);
                Dialog dialog = ShadowDialog.getLatestDialog();
                screen.settle();
                Screen.write("target-dialog" + (qualifiers.startsWith("de") ? "-german-phone" : ""),
                        Screen.picture(dialog.getWindow().getDecorView()));
                dialog.dismiss();
            }
        }
    }

    @Test
    @Config(minSdk = 27)
    public void licences() {
        licences("licences", Screen.TABLET_LANDSCAPE, 1);
        licences("licences-dark", Screen.TABLET_LANDSCAPE.replace("notnight", "night"), 1);
        licences("licences-german-phone", "de-" + Screen.PHONE_PORTRAIT, 1);
        licences("licences-large-letters-phone-dark", Screen.PHONE_PORTRAIT.replace("notnight", "night"), 2);
        licences("licences-large-letters-phone-landscape", Screen.PHONE_LANDSCAPE, 2);
    }

    private static void licences(String name, String qualifiers, float fontScale) {
        RuntimeEnvironment.setFontScale(fontScale);
        try (Screen screen = live(qualifiers, FIXTURE.cell())) {
            screen.holdStillUntilResult(FIXTURE);
            screen.find(R.id.panel).scrollTo(0, 10_000);
            screen.keep(name + "-row", FIXTURE.photo());
            RowList rows = screen.find(R.id.rows);
            rows.getChildAt(rows.getChildCount() - 1).findViewById(R.id.row_action).performClick();
            Dialog dialog = ShadowDialog.getLatestDialog();
            TextView text = dialog.findViewById(R.id.licences_text);
            screen.until("licences", () -> text.length() > 1000);
            Screen.write(name, Screen.picture(dialog.getWindow().getDecorView()));
            View page = dialog.findViewById(R.id.licences_page);
            page.scrollTo(0, text.getLayout().getLineTop(text.getLayout().getLineForOffset(
                    text.getText().toString().indexOf("APACHE COMMONS MATH DERIVATIVE WORKS"))));
            Screen.write(name + "-scrolled", Screen.picture(dialog.getWindow().getDecorView()));
            dialog.dismiss();
        }
    }
}
