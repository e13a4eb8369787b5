package org.cellgauge.android.files;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import android.content.ContentResolver;
import android.content.Context;
import android.graphics.Bitmap;
import android.graphics.BitmapFactory;
import android.net.Uri;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import io.reactivex.rxjava3.core.Flowable;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.time.Clock;
import java.time.Instant;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.Reason;
import org.cellgauge.check.Verdict;
import org.cellgauge.desktop.ImageFiles;
import org.cellgauge.internal.overlay.LabelWords;
import org.cellgauge.internal.overlay.LegendWords;
import org.cellgauge.internal.overlay.Overlay;
import org.cellgauge.internal.overlay.Role;
import org.cellgauge.internal.overlay.Shape;
import org.cellgauge.internal.overlay.Status;
import org.cellgauge.internal.overlay.TextShape;
import org.cellgauge.live.LiveCheck;
import org.cellgauge.live.LivePace;
import org.cellgauge.live.LiveState;
import org.cellgauge.output.ResultJson;
import org.cellgauge.output.ResultRecord;
import org.cellgauge.output.ResultView;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Estimate;
import org.cellgauge.settings.InitialEstimate;
import org.cellgauge.settings.LikelihoodModel;
import org.cellgauge.settings.ObjectNoise;
import org.cellgauge.settings.SamplerKind;
import org.cellgauge.vision.BoofMarkerDetector;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.GreyImage;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;

/** Results as they are kept, read again by Android, by Java and by the command line. */
@RunWith(RobolectricTestRunner.class)
public class FolderArchiveTest {
    private static final Clock CLOCK = Clock.fixed(Instant.parse("2024-05-17T12:30:05.900Z"),
            ZoneId.of("Europe/Berlin"));
    private static final String NAME = "cellgauge-20240517-143005";
    private static final String VERSION = "9.8.7";

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private final Context context = RuntimeEnvironment.getApplication();
    private final List<Overlay> painted = new ArrayList<>();
    private FolderArchive archive;

    @Before
    public void newArchive() {
        archive = new FolderArchive(context, this::paint, new GermanWords(), CLOCK, VERSION);
    }

    /** Words that tell where they come from. */
    private static final class GermanWords implements PictureWords {
        @Override
        public String headline(Verdict verdict, boolean lensMeasured) {
            return "Urteil " + verdict + (lensMeasured ? "" : ", Linse unbekannt");
        }

        @Override
        public String reason(Reason reason) {
            return "weil " + reason.kind();
        }

        @Override
        public LabelWords labels() {
            return new LabelWords(Locale.GERMAN, "", "", "", "", "unsicher", "", "", "");
        }

        @Override
        public LegendWords legend() {
            return new LegendWords(Locale.GERMAN, "Referenz", "dort", "wahr", "%s-fach", "unsicher", "Griff", "zwei",
                    "s", "Gitter %s", "Gitter %s", "nichts");
        }
    }

    private Bitmap paint(GreyImage photo, Overlay overlay) {
        painted.add(overlay);
        Bitmap bitmap = Bitmap.createBitmap(overlay.widthPx(), overlay.heightPx(), Bitmap.Config.ARGB_8888);
        bitmap.eraseColor(0xFF336699);
        return bitmap;
    }

    /** The fixture's photo as a camera would deliver it: with something between its rows. */
    private static Photo photo() {
        return photo("lifted-4");
    }

    private static Photo photo(String fixture) {
        GreyImage packed = ImageFiles.read(Fixtures.path(fixture + "/photo.png"));
        int stride = packed.widthPx() + 64;
        byte[] padded = new byte[stride * packed.heightPx()];
        Arrays.fill(padded, (byte) 77);
        for (int y = 0; y < packed.heightPx(); y++) {
            System.arraycopy(packed.luminance(), y * packed.widthPx(), padded, y * stride, packed.widthPx());
        }
        return new Photo("frame.png", GreyImage.wrap(padded, 0, stride, packed.widthPx(), packed.heightPx()));
    }

    private static CheckResult check(Photo photo, CheckSettings settings) {
        Cell cell = CellReader.read(Fixtures.path("lifted-4/cell.yaml"));
        return CellCheck.run(cell, BoofMarkerDetector.forCell(cell).detect(photo.luminance(), photo.name()), settings);
    }

    private static CheckSettings quick() {
        return CheckSettings.builder().seed(3).iterations(300).build();
    }

    private byte[] content(String uri) throws IOException {
        ContentResolver resolver = context.getContentResolver();
        try (InputStream in = resolver.openInputStream(Uri.parse(uri))) {
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            byte[] buffer = new byte[4096];
            for (int n = in.read(buffer); n >= 0; n = in.read(buffer)) {
                out.write(buffer, 0, n);
            }
            return out.toByteArray();
        }
    }

    private byte[] content(SavedResult saved, String ending) throws IOException {
        for (String uri : saved.uris()) {
            if (uri.endsWith(ending)) {
                return content(uri);
            }
        }
        throw new AssertionError("no " + ending + " among " + saved.uris());
    }

    @Test
    public void allFourFilesAreKeptUnderTheTimesName() throws IOException {
        Photo photo = photo();
        CheckResult result = check(photo, quick());
        SavedResult saved = archive.save(photo, result, "kitchen.yaml");
        assertEquals(NAME, saved.name());
        assertEquals(4, saved.uris().size());

        byte[] png = content(saved, NAME + ".png");
        assertArrayEquals(Fixtures.pixels(photo.luminance()),
                Fixtures.pixels(PhotoReader.read(new ByteArrayInputStream(png), "png")));
        String json = new String(content(saved, ".result.json"), StandardCharsets.UTF_8);
        ResultRecord record = ResultRecord.of(NAME + ".png", sha256(png), VERSION)
                .withCommand(DesktopCommand.of(NAME, result.settings()))
                .withCell(NAME + ".cell.yaml", sha256(content(saved, ".cell.yaml"))).withDate("2024-05-17");
        assertEquals(ResultJson.of(result, record), json);
        byte[] overlay = content(saved, ".overlay.png");
        Bitmap bitmap = BitmapFactory.decodeByteArray(overlay, 0, overlay.length);
        assertEquals(1280, bitmap.getWidth());
        assertEquals(0xFF336699, bitmap.getPixel(100, 100));
        assertEquals(1, painted.size());
        assertEquals(Arrays.asList("Urteil NOT_CONVERGED", "weil NOT_CONVERGED"), texts(painted.get(0), Role.BANNER));
        assertTrue(texts(painted.get(0), Role.LABEL).contains("5: unsicher"));
        assertEquals("Referenz", texts(painted.get(0), Role.LEGEND).get(0));
        String cell = new String(content(saved, ".cell.yaml"), StandardCharsets.UTF_8);
        Cell again = CellReader.read(cell, "cell", name -> {
            throw new IOException("no other file is needed");
        });
        assertEquals(result.cell().camera().toString(), again.camera().toString());
        assertTrue(cell, cell.contains("cellgauge check --cell " + NAME + ".cell.yaml --iterations 300 --seed 3 "
                + NAME + ".png"));
    }

    private static List<String> texts(Overlay overlay, Role role) {
        List<String> texts = new ArrayList<>();
        for (Shape shape : overlay.shapes(role)) {
            if (shape instanceof TextShape) {
                texts.add(((TextShape) shape).text());
            }
        }
        return texts;
    }

    /** By another way than the product's: the tool of the system. */
    private String sha256(byte[] bytes) throws IOException {
        File file = folder.newFile();
        Files.write(file.toPath(), bytes);
        return run("sha256sum", file.getPath()).substring(0, 64);
    }

    private String run(String... words) throws IOException {
        File out = folder.newFile();
        Process process = new ProcessBuilder(words).redirectErrorStream(true).redirectOutput(out).start();
        try {
            assertTrue(process.waitFor(120, TimeUnit.SECONDS));
        } catch (InterruptedException e) {
            throw new IOException(e);
        }
        return new String(Files.readAllBytes(out.toPath()), StandardCharsets.UTF_8);
    }

    /** The promise of the archive: the command in the cell file makes the same figures from the kept photo. */
    @Test
    public void theCommandLineMakesTheSameFiguresOfWhatWasKept() throws IOException {
        Photo photo = photo();
        assertMadeAgain(photo, check(photo, CheckSettings.builder().seed(42).build()), "pass");
    }

    /** The same of what the screen shows, where chains run in steps and stop when their error suffices. */
    @Test
    public void theCommandLineMakesTheSameFiguresOfALiveCheck() throws IOException {
        Photo photo = photo();
        Cell cell = CellReader.read(Fixtures.path("lifted-4/cell.yaml"));
        CheckSettings settings = CheckSettings.builder().seed(-7).estimate(Estimate.FOCAL).build();
        LiveState last = LiveCheck.states(
                Flowable.just(BoofMarkerDetector.forCell(cell).detect(photo.luminance(), photo.name())), cell, settings,
                Flowable.just(LivePace.FULL)).blockingLast();
        // a focal length that nobody knows makes more uncertain than the target allows
        assertMadeAgain(photo, last.update().result(), "fail");
    }

    private void assertMadeAgain(Photo photo, CheckResult result, String verdict) throws IOException {
        SavedResult saved = archive.save(photo, result, "kitchen.yaml");
        File copies = folder.newFolder();
        for (String uri : saved.uris()) {
            String name = Uri.parse(uri).getLastPathSegment();
            Files.write(new File(copies, name.substring(name.indexOf('/') + 1)).toPath(), content(uri));
        }
        String cell = new String(content(saved, ".cell.yaml"), StandardCharsets.UTF_8);
        int begin = cell.indexOf("# cellgauge ");
        String command = cell.substring(begin + 12, cell.indexOf('\n', begin));
        List<String> words = new ArrayList<>(Arrays.asList(
                System.getProperty("java.home") + "/bin/java", "-cp", System.getProperty("java.class.path"),
                "org.cellgauge.cli.Main"));
        for (String word : command.split(" ")) {
            words.add(word.startsWith(NAME) ? new File(copies, word).getPath() : word);
        }
        words.addAll(Arrays.asList("--out", new File(copies, "out").getPath()));
        String log = run(words.toArray(new String[0]));
        File made = new File(copies, "out/" + NAME + ".result.json");
        assertTrue(log, made.isFile());
        JsonObject theirs = json(Files.readAllBytes(made.toPath()));
        JsonObject ours = json(content(saved, ".result.json"));
        assertEquals(verdict, ours.get("verdict").getAsString());
        assertEquals("cellgauge " + command, ours.get("command").getAsString());
        theirs.remove("command");
        ours.remove("command");
        // all of it but version, day and where files lie: verdict, photo and cell with their hashes, settings, figures
        // to the last digit, diagnostics
        for (String key : Arrays.asList("version", "date")) {
            theirs.remove(key);
            ours.remove(key);
        }
        // what would help is added by the command line; the app shows it beside the result
        theirs.remove("plan");
        assertEquals(ours, theirs);
    }

    private static JsonObject json(byte[] bytes) {
        return JsonParser.parseString(new String(bytes, StandardCharsets.UTF_8)).getAsJsonObject();
    }

    /** A target so wide that it is met whatever the lens: the picture says so, and is not as green as a pass. */
    @Test
    public void thePictureOfAnUnmeasuredLensIsNoPass() throws IOException {
        // references out of one plane tell the lens well enough for chains to converge soon
        Photo photo = photo("raised-4");
        Cell cell = CellReader.read(Fixtures.path("raised-4/cell.yaml")).withTarget(OptionalDouble.of(500));
        Detections seen = BoofMarkerDetector.forCell(cell).detect(photo.luminance(), photo.name());
        CheckResult measured = CellCheck.run(cell, seen, CheckSettings.builder().seed(3).build());
        CheckResult estimated = CellCheck.run(cell, seen,
                CheckSettings.builder().seed(3).estimate(Estimate.INTRINSICS).build());
        assertEquals(Verdict.PASS, measured.verdict());
        assertEquals(Verdict.PASS, estimated.verdict());
        archive.save(photo, measured, "cell.yaml");
        archive.save(photo, estimated, "cell.yaml");
        assertEquals("Urteil PASS", texts(painted.get(0), Role.BANNER).get(0));
        assertEquals("Urteil PASS, Linse unbekannt", texts(painted.get(1), Role.BANNER).get(0));
        assertTrue("a pass is drawn as one", statuses(painted.get(0)).contains(Status.PASS));
        assertFalse("and nothing else is", statuses(painted.get(1)).contains(Status.PASS));
    }

    private static Set<Status> statuses(Overlay overlay) {
        Set<Status> statuses = EnumSet.noneOf(Status.class);
        for (Role role : Role.values()) {
            for (Shape shape : overlay.shapes(role)) {
                statuses.add(shape.status());
            }
        }
        return statuses;
    }

    @Test
    public void resultsOfOneSecondKeepApart() throws IOException {
        Photo photo = photo();
        CheckResult result = check(photo, quick());
        assertEquals(NAME, archive.save(photo, result, "kitchen.yaml").name());
        SavedResult second = archive.save(photo, result, "kitchen.yaml");
        assertEquals(NAME + "-2", second.name());
        assertEquals(NAME + "-3", archive.save(photo, result, "kitchen.yaml").name());
        assertTrue(second.uris().stream().allMatch(uri -> uri.contains(NAME + "-2")));
        assertEquals(3, archive.saved().size());
        String cell = new String(content(second, ".cell.yaml"), StandardCharsets.UTF_8);
        assertTrue(cell, cell.contains(NAME + "-2.png"));
        assertEquals(NAME + "-2.png", json(content(second, ".result.json")).getAsJsonObject("input").get("name")
                .getAsString());
    }

    @Test
    public void keptResultsAreReadAgainWithTimeCellAndFigures() throws IOException {
        Photo photo = photo();
        CheckResult result = check(photo, quick());
        archive.save(photo, result, "kitchen\n.yaml");
        KeptResult kept = archive.kept().get(0);
        assertEquals(NAME, kept.saved().name());
        assertEquals(4, kept.saved().uris().size());
        assertEquals(LocalDateTime.of(2024, 5, 17, 14, 30, 5), kept.time());
        assertEquals("kitchen .yaml", kept.cellName());
        assertNull(kept.refusal());
        assertEquals(ResultView.of(result), kept.view());
        Bitmap picture = BitmapFactory.decodeStream(new ByteArrayInputStream(archive.picture(NAME)));
        assertEquals(photo.luminance().widthPx(), picture.getWidth());
        assertTrue(archive.delete(NAME));
        assertFalse("only once", archive.delete(NAME));
        assertEquals(Collections.emptyList(), archive.kept());
        assertThrows(IOException.class, () -> archive.picture(NAME));
        assertFalse("nothing outside of the folder", archive.delete("../results"));
    }

    @Test
    public void damagedResultIsAmongThemAndSaysSo() throws IOException {
        Photo photo = photo();
        archive.save(photo, check(photo, quick()), "kitchen.yaml");
        File stored = new File(context.getFilesDir(), "results/" + NAME + "/" + NAME + ".result.json");
        Files.write(stored.toPath(), Arrays.copyOf(Files.readAllBytes(stored.toPath()), 1000));
        KeptResult kept = archive.kept().get(0);
        assertNull(kept.view());
        assertEquals(FileRefusal.RESULT_NOT_READ, kept.refusal().kind());
        assertTrue(stored.delete());
        assertEquals(FileRefusal.RESULT_NOT_READ, archive.kept().get(0).refusal().kind());
        assertTrue(archive.delete(NAME));
    }

    @Test
    public void nothingWasKeptAtFirst() {
        assertEquals(Collections.emptyList(), archive.saved());
    }

    @Test
    public void aPictureThatCannotBePaintedLeavesNothingBehind() {
        Photo photo = photo();
        CheckResult result = check(photo, quick());
        FolderArchive failing = new FolderArchive(context, (p, o) -> {
            throw new OutOfMemoryError("no room for a bitmap");
        }, new GermanWords(), CLOCK, VERSION);
        IOException e = assertThrows(IOException.class, () -> failing.save(photo, result, "kitchen.yaml"));
        assertFalse(e instanceof StorageFullException);
        assertEquals(Collections.emptyList(), failing.saved());
    }

    @Test
    public void theCommandNamesEveryOptionThatIsNotTheUsual() {
        assertEquals("cellgauge check --cell n.cell.yaml n.png",
                DesktopCommand.of("n", CheckSettings.builder().build()));
        assertEquals("cellgauge check --cell n.cell.yaml --seed -5 --estimate focal --focal-prior-std 120.5 n.png",
                DesktopCommand.of("n", CheckSettings.builder().seed(-5).estimate(Estimate.FOCAL)
                        .focalPriorStdPx(120.5).build()));
        assertEquals("cellgauge check --cell n.cell.yaml --estimate focal --aspect-prior-std independent "
                + "n.png",
                DesktopCommand.of("n", CheckSettings.builder().estimate(Estimate.FOCAL)
                        .aspectPriorStd(Double.POSITIVE_INFINITY).build()));
        assertEquals("cellgauge check --cell n.cell.yaml --model corner-cube --kappa 0.7 --sampler adaptive "
                + "--chains 2 --iterations 9000 --warmup 100 --initial ransac --object-noise none n.png",
                DesktopCommand.of("n", CheckSettings.builder().likelihood(LikelihoodModel.CORNER_CUBE)
                        .kappa(0.7).sampler(SamplerKind.ADAPTIVE).chains(2).iterations(9000)
                        .warmup(100).initial(InitialEstimate.RANSAC)
                        .objectNoise(ObjectNoise.NONE).build()));
    }
}
