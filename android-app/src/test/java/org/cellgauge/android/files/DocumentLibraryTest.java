package org.cellgauge.android.files;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import android.content.Context;
import android.net.Uri;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.cellgauge.cell.CameraReader;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.desktop.ImageFiles;
import org.cellgauge.geometry.PinholeCamera;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;

/** Documents good and bad, from an app that may fail. */
@RunWith(RobolectricTestRunner.class)
public class DocumentLibraryTest {
    private static final String INLINE = "camera:\n  model: pinhole\n"
            + "  pinhole: {fx: 900, fy: 901, cx: 640, cy: 360, width: 1280, height: 720}\n";

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private final Context context = RuntimeEnvironment.getApplication();
    private TestDocuments documents;
    private DocumentLibrary library;

    @Before
    public void newLibrary() {
        documents = TestDocuments.registered(folder.getRoot());
        library = new DocumentLibrary(context);
    }

    private String add(String name, String text) throws IOException {
        return documents.add(name, text.getBytes(StandardCharsets.UTF_8));
    }

    private static String cellText(String camera) throws IOException {
        String text = new String(Fixtures.bytes("lifted-4/cell.yaml"), StandardCharsets.UTF_8);
        return text.replace("camera: camera.yaml\n", camera);
    }

    private String refusal(String uri, String calibrationUri) {
        return assertThrows(InputRefusedException.class, () -> library.cell(uri, calibrationUri)).getMessage();
    }

    private String photoRefusal(String uri) {
        return assertThrows(InputRefusedException.class, () -> library.photo(uri)).getMessage();
    }

    // ---- the example

    @Test
    public void theExampleIsTheFixture() {
        Cell expected = CellReader.read(Fixtures.path("lifted-4/cell.yaml"));
        CellDocument example = library.example();
        assertEquals("cell.yaml", example.name());
        assertNull(example.uri());
        assertNull(example.cameraFile());
        assertEquals(expected.camera().toString(), example.calibration().toString());
        assertEquals(expected.camera().toString(), example.cell().camera().toString());
        assertEquals(expected.references().size(), example.cell().references().size());
        Photo photo = library.examplePhoto();
        assertEquals("photo.png", photo.name());
        assertArrayEquals(Fixtures.pixels(ImageFiles.read(Fixtures.path("lifted-4/photo.png"))),
                Fixtures.pixels(photo.luminance()));
    }

    // ---- cells and cameras

    @Test
    public void aCellWithItsCameraInlineNeedsNothingElse() throws IOException {
        String uri = add("mine.yaml", cellText(INLINE));
        CellDocument cell = library.cell(uri, null);
        assertEquals("shown mine.yaml", cell.name());
        assertEquals(uri, cell.uri());
        assertEquals(901, cell.calibration().get(PinholeCamera.FY), 0);
        assertEquals(cell.calibration(), cell.cell().camera());
        assertNull(cell.cameraFile());
        assertEquals(3, cell.cell().objects().size());
    }

    @Test
    public void aCameraFileThatCannotBeFollowedIsNamed() throws IOException {
        CellDocument cell = library.cell(add("mine.yaml", cellText("camera: ../cameras/tablet.yaml\n")), null);
        assertNull(cell.calibration());
        assertEquals("../cameras/tablet.yaml", cell.cameraFile());
        assertEquals(4, cell.cell().references().size());
    }

    @Test
    public void aCellWithoutACameraIsForTheDevices() throws IOException {
        CellDocument cell = library.cell(add("mine.yaml", cellText("")), null);
        assertNull(cell.calibration());
        assertNull(cell.cameraFile());
        assertNotNull(cell.cell());
    }

    @Test
    public void aChosenCalibrationGoesBeforeWhatTheCellStates() throws IOException {
        String camera = documents.add("tablet.yaml", Fixtures.bytes("distorted-4/camera.yaml"));
        PinholeCamera expected = CameraReader.read(Fixtures.path("distorted-4/camera.yaml"));
        for (String stated : new String[] {INLINE, "camera: other.yaml\n", ""}) {
            CellDocument cell = library.cell(add("mine.yaml", cellText(stated)), camera);
            assertEquals(expected.toString(), cell.calibration().toString());
            assertEquals(expected.toString(), cell.cell().camera().toString());
            assertNull(cell.cameraFile());
        }
    }

    @Test
    public void howWellAChosenCalibrationIsKnownIsKept() throws IOException {
        String camera = documents.add("tablet.yaml", (new String(Fixtures.bytes("distorted-4/camera.yaml"),
                StandardCharsets.UTF_8) + "\ncellgauge_calibration: {parameters: [fx, k1], covariance: [[4, 1e-3], "
                + "[1e-3, 1e-6]]}\n").getBytes(StandardCharsets.UTF_8));
        CellDocument cell = library.cell(add("a.yaml", cellText("camera: other.yaml\n")), camera);
        assertEquals(2, cell.cell().calibration().std(0), 1e-12);
    }

    @Test
    public void aCameraOfAChainIsTheOneThatTheCellNames() throws IOException {
        String chain = "%s:\n  camera_model: pinhole\n  intrinsics: [%s, 900, 639.5, 359.5]\n"
                + "  resolution: [1280, 720]\n";
        String camera = documents.add("chain.yaml", (String.format(chain, "cam0", 800) + String.format(chain, "cam1",
                901)).getBytes(StandardCharsets.UTF_8));
        CellDocument cell = library.cell(add("a.yaml", cellText("camera: {file: chain.yaml, name: cam1}\n")), camera);
        assertEquals(901, cell.calibration().get(PinholeCamera.FX), 0);
        assertEquals("chain.yaml", library.cell(add("b.yaml", cellText("camera: {file: chain.yaml, name: cam1}\n")),
                null).cameraFile());
    }

    @Test
    public void toneCurveOfAChosenCalibrationHoldsUnlessTheCellStatesOne() throws IOException {
        String camera = documents.add("tablet.yaml", (new String(Fixtures.bytes("distorted-4/camera.yaml"),
                StandardCharsets.UTF_8) + "\ntone_curve: gamma 1.8\n").getBytes(StandardCharsets.UTF_8));
        assertEquals("gamma 1.8", library.cell(add("a.yaml", cellText("")), camera).cell().toneCurve().words());
        String linear = add("b.yaml", cellText("tone_curve: linear\n"));
        assertEquals("linear", library.cell(linear, camera).cell().toneCurve().words());
        assertEquals("linear", library.cell(linear, null).cell().toneCurve().words());
    }

    @Test
    public void faultsAreSaidWithTheNameThatTheUserSees() throws IOException {
        String message = refusal(add("mine.yaml", cellText(INLINE).replace("size_mm: 47", "size_mm: -47")), null);
        assertTrue(message, message.startsWith("shown mine.yaml, line "));
        assertTrue(message, message.contains("markers.size_mm"));
        String cell = add("mine.yaml", cellText(""));
        message = refusal(cell, add("tablet.yaml", "model: fisheye\n"));
        assertTrue(message, message.startsWith("shown tablet.yaml, line 1"));
        message = refusal(cell, cell);
        assertTrue(message, message.contains("this is a cell file; name a camera file here"));
        message = refusal(add("camera.yaml", new String(Fixtures.bytes("lifted-4/camera.yaml"),
                StandardCharsets.UTF_8)), null);
        assertTrue(message, message.contains("this is a camera file"));
    }

    @Test
    public void whatIsNoTextIsRefused() throws IOException {
        assertTrue(refusal(documents.add("cell.yaml", Fixtures.bytes("lifted-4/photo.png")), null)
                .contains("no text in UTF-8"));
        assertTrue(refusal(add("cell.yaml", ""), null).contains("the file is empty"));
        assertTrue(refusal(documents.add("cell.yaml", "cellgauge: 1".getBytes(StandardCharsets.UTF_16)), null)
                .contains("UTF-16"));
        assertTrue(refusal(documents.add("cell.yaml", new byte[CellReader.MAX_BYTES + 1]), null)
                .contains("larger than"));
        assertTrue(refusal(add("cell.yaml", "cellgauge: 1\ncamera: [\n"), null).contains("not valid YAML"));
        assertTrue(refusal(add("cell.yaml", "just a line"), null).contains("cellgauge: 1"));
    }

    // ---- photos

    @Test
    public void aPhotoHasTheNameThatTheUserSees() throws IOException {
        Photo photo = library.photo(documents.add("p.png", Fixtures.bytes("lifted-4/photo.png")));
        assertEquals("shown p.png", photo.name());
        assertEquals(1280, photo.luminance().widthPx());
    }

    @Test
    public void aPhotoThatIsNoneIsRefusedByItsName() throws IOException {
        assertTrue(photoRefusal(add("notes.txt", "hello")).startsWith("shown notes.txt: this is no image"));
    }

    // ---- apps that fail

    @Test
    public void aDocumentThatIsGoneIsToBeChosenAgain() {
        String gone = TestDocuments.uri("id9/gone.yaml");
        assertEquals("shown gone.yaml: this cell file is not there any more, or its app does not give it; choose it "
                + "again", refusal(gone, null));
        assertEquals("shown gone.yaml: this photo is not there any more, or its app does not give it; choose it again",
                photoRefusal(gone));
    }

    @Test
    public void aPermissionThatHasEndedIsSaid() throws IOException {
        String uri = add("mine.yaml", cellText(INLINE));
        documents.openFault = new SecurityException("no grant");
        assertEquals("shown mine.yaml: the permission to read this cell file has ended; choose it again",
                refusal(uri, null));
        // then its name cannot be asked for either
        documents.queryFault = new SecurityException("no grant");
        assertEquals("mine.yaml: the permission to read this cell file has ended; choose it again", refusal(uri, null));
    }

    @Test
    public void anAppThatBreaksIsNoFaultOfThisOne() throws IOException {
        String uri = add("mine.yaml", cellText(INLINE));
        documents.openFault = new IllegalStateException("its own business");
        assertTrue(refusal(uri, null).contains("the app that holds this cell file does not give it "
                + "(IllegalStateException)"));
        documents.openFault = null;
        documents.opensNothing = true;
        assertTrue(refusal(uri, null).startsWith("shown mine.yaml: "));
    }

    @Test
    public void aDocumentWithoutANameIsCalledByItsAddress() throws IOException {
        documents.nameless = true;
        assertEquals("mine.yaml", library.cell(add("mine.yaml", cellText(INLINE)), null).name());
        documents.queryFault = new UnsupportedOperationException();
        assertEquals("mine.yaml", library.cell(add("mine.yaml", cellText(INLINE)), null).name());
    }

    @Test
    public void pathsAreNotFollowed() throws IOException {
        String path = folder.newFile("cell.yaml").getPath();
        for (String uri : new String[] {Uri.fromFile(new java.io.File(path)).toString(), path, "",
            "http://example.org/c", "android.resource://org.cellgauge.android/raw/x"}) {
            assertTrue(uri, refusal(uri, null).contains("this is no document of this device"));
            assertTrue(uri, photoRefusal(uri).contains("this is no document of this device"));
        }
    }

    @Test
    public void cellAndCalibrationStayReadableAfterARestart() throws IOException {
        String cell = add("mine.yaml", cellText(""));
        String camera = add("tablet.yaml", new String(Fixtures.bytes("lifted-4/camera.yaml"), StandardCharsets.UTF_8));
        library.cell(cell, camera);
        assertEquals(2, context.getContentResolver().getPersistedUriPermissions().size());
        assertTrue(context.getContentResolver().getPersistedUriPermissions().stream()
                .allMatch(p -> p.isReadPermission() && !p.isWritePermission()));
    }
}
