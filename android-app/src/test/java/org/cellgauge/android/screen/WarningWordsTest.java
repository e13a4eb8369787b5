package org.cellgauge.android.screen;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
import org.cellgauge.android.files.FileRefusal;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.cell.CellRefusal;
import org.cellgauge.cell.ChangeKind;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.Reference;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.cell.CellPhrase;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.warning.CheckPhrase;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.SettingRefusal;
import org.cellgauge.vision.DetectionWarning;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.cellgauge.warning.CheckRefusal;
import org.cellgauge.warning.CheckWarning;
import org.cellgauge.warning.Message;
import org.cellgauge.warning.MessageKind;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;
import org.cellgauge.warning.RefusalKind;
import org.cellgauge.warning.Warning;
import org.cellgauge.warning.WarningKind;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;

/** Warnings and refusals in both languages. That their strings take the same arguments in both: {@link StringsTest}. */
@RunWith(RobolectricTestRunner.class)
public class WarningWordsTest {
    private static List<MessageKind> kinds() {
        List<MessageKind> kinds = new ArrayList<>(Arrays.asList(DetectionWarning.values()));
        kinds.addAll(Arrays.asList(CheckWarning.values()));
        kinds.addAll(Arrays.asList(CheckPhrase.values()));
        kinds.addAll(Arrays.asList(CellRefusal.values()));
        kinds.addAll(Arrays.asList(CellPhrase.values()));
        kinds.addAll(Arrays.asList(CheckRefusal.values()));
        kinds.addAll(Arrays.asList(SettingRefusal.values()));
        kinds.addAll(Arrays.asList(FileRefusal.values()));
        kinds.addAll(Arrays.asList(ChangeKind.values()));
        return kinds;
    }

    private static Wording in(String language) {
        RuntimeEnvironment.setQualifiers(language);
        return new Wording(RuntimeEnvironment.getApplication().getResources());
    }

    /** A warning or refusal of a kind, whose arguments are names that are the same in every language. */
    private static Message sample(MessageKind kind) {
        int places = kind.english().split("%s", -1).length - 1;
        Object[] arguments = new Object[places];
        for (int i = 0; i < places; i++) {
            arguments[i] = "<" + (char) ('a' + i) + ">";
        }
        return kind instanceof WarningKind ? Warning.of((WarningKind) kind, arguments)
                : Refusal.of((RefusalKind) kind, arguments);
    }

    private static String plain(String text) {
        return text.replace('\u00a0', ' ');
    }

    @Test
    public void everyKindHasAStringOfItsOwn() {
        Set<Integer> ids = new HashSet<>();
        for (MessageKind kind : kinds()) {
            int id = kind instanceof ChangeKind ? ChangeStrings.of(kind)
                    : kind instanceof WarningKind ? WarningStrings.of(kind) : RefusalStrings.of(kind);
            assertTrue(kind + " has a string", id != WarningStrings.NONE);
            assertTrue(kind + " shares its string", ids.add(id));
        }
    }

    @Test
    public void englishIsCoresSentence() {
        Wording words = in("en");
        for (MessageKind kind : kinds()) {
            // the app has no setting for what these advise
            if (kind != CheckPhrase.MORE_ITERATIONS && kind != CheckPhrase.INITIAL_PNP) {
                assertEquals(sample(kind).toString(), plain(words.message(sample(kind))));
            }
        }
    }

    @Test
    public void germanHasEveryArgumentAndNoEnglishSentence() {
        Wording words = in("de");
        for (MessageKind kind : kinds()) {
            Message message = sample(kind);
            String german = words.message(message);
            for (Object argument : message.arguments()) {
                assertTrue(kind + " says " + argument, german.contains((String) argument));
            }
            assertFalse(german, german.contains("%%"));
            for (String word : ("the its it is are and than left seen off instead against this file write must has or "
                    + "cannot be").split(" ")) {
                assertFalse(german, (" " + german + " ").contains(" " + word + " "));
            }
        }
    }

    private static Warning misplaced() {
        return Warning.of(CheckWarning.REFERENCE_OFF, 1234,
                Listing.and(Arrays.asList(Warning.of(CheckPhrase.SHIFT, Decimal.of(15.25, 1), "x"),
                        Warning.of(CheckPhrase.SHIFT, Decimal.of(-3, 1), "y"))),
                Listing.and(Collections.singletonList(Warning.of(CheckPhrase.STD_MM, Decimal.of(1, 1)))),
                Warning.of(CheckPhrase.OR_INSTEAD, Listing.or(Arrays.asList(8, 9))));
    }

    @Test
    public void numbersAreWrittenAsTheUserDoes() {
        assertEquals("Referenz 1234 scheint um etwa 15,3 mm längs x und -3,0 mm längs y versetzt zu sein, was ihre "
                + "angegebene Genauigkeit (1,0 mm) nicht zulässt: ihre Position neu messen; es kann stattdessen auch "
                + "Referenz 8 oder 9 sein", plain(in("de").message(misplaced())));
        assertEquals(misplaced().toString(), plain(in("en").message(misplaced())));
        Warning capped = Warning.of(CheckWarning.CAP_REACHED, Decimal.of(100_000, 0), "camera_x", Decimal.of(1.66, 1),
                Decimal.shortest(0.1), CheckPhrase.MORE_ITERATIONS);
        String german = plain(in("de").message(capped));
        assertTrue(german, german.contains("Grenze von 100.000 Schritten") && german.contains("von camera_x")
                && german.contains("1,7 % statt 0,1 %; mehr lässt nur die Befehlszeile zu"));
        String english = plain(in("en").message(capped));
        assertTrue(english, english.contains("cap of 100,000 iterations"));
        assertTrue(english, english.contains("1.7 % in place of 0.1 %; only the command line"));
    }

    private static Refusal refused(String faulty, String right, String wrong) {
        String text = faulty.replace(right, wrong);
        assertTrue(!text.equals(faulty));
        try {
            CellReader.read(text, "zelle.yaml", Fixture.LIFTED.cell().camera());
        } catch (InputRefusedException e) {
            return e.refusal();
        }
        throw new AssertionError("not refused: " + wrong);
    }

    @Test
    public void refusedCellFileIsSaidWithItsPlace() {
        String cell = "cellgauge: 1\nmarkers: {family: square-binary, size_mm: 47}\n"
                + "placement: {std_mm: [5, 5, 5], std_deg: 0.5}\nreferences:\n  944: {position_mm: [492, 380, 0]}\n";
        Wording words = in("de");
        assertEquals("zelle.yaml, Zeile 2, markers.size_mm: muss größer als 0 sein, da steht -47; zu schreiben ist die "
                + "Außenkante des schwarzen Rands in mm", words.refusal(refused(cell, "size_mm: 47", "size_mm: -47")));
        assertEquals("zelle.yaml, Zeile 5, references.944.position_mm: hier gehört eine Liste von 3 Zahlen hin, da "
                + "steht 6; zu schreiben ist [x, y, z] in mm (Dezimalzahlen haben einen Punkt, kein Komma)",
                words.refusal(refused(cell, "492, 380, 0", "492,0, 380,0, 0,0")));
        assertEquals("zelle.yaml, Zeile 3, placement.std: unbekannter Schlüssel; ist \"std_mm\" gemeint?",
                words.refusal(refused(cell, "std_mm:", "std:")));
        Refusal syntax = refused(cell, "5, 5, 5]", "5, 5, 5");
        String german = words.refusal(syntax);
        assertTrue(german, german.startsWith("zelle.yaml, Zeile ") && german.contains(", Spalte ")
                && german.contains("kein gültiges YAML ("));
        assertEquals(syntax.toString(), plain(in("en").refusal(syntax)));
    }

    @Test
    public void refusedFrameIsSaid() {
        assertEquals("foto.png: keine der Referenzen 8, 9 und 22 ist im Foto; die Markerfamilie der Zelldatei, Licht "
                + "und Schärfe prüfen",
                in("de").refusal(Refusal.at(Place.of("foto.png"), CheckRefusal.NO_REFERENCE_SEEN,
                        Listing.and(Arrays.asList(8, 9, 22)))));
        assertEquals("foto.png: das Bild hat 640 x 480 px, die Kamera ist aber für 1280 x 720 px kalibriert; der Zelle "
                + "die Kamera dieser Bildgröße geben", plain(in("de").refusal(Refusal.at(Place.of("foto.png"),
                        CellRefusal.IMAGE_SIZE, 640, 480, 1280, 720, CellPhrase.CAMERA_OF_THIS_SIZE))));
    }

    @Test
    public void placesInTheImageAreNotGrouped() {
        Warning square = Warning.of(DetectionWarning.SEEN_TWICE, 1234, 2, Listing.and(Arrays.asList(
                Warning.of(CheckPhrase.PLACE, 1500, 201), Warning.of(CheckPhrase.PLACE, 2420, 1250))));
        String german = plain(in("de").message(square));
        assertTrue(german,
                german.startsWith("Marker 1234 ist an 2 Stellen zu sehen, (1500; 201) und (2420; 1250) px,"));
        assertEquals(square.toString(), plain(in("en").message(square)));
    }

    @Test
    public void whatIsLeftOutLeavesNoTrace() {
        Warning bare = Warning.of(CheckWarning.FIGURES_REST_ON_THEM, Listing.and(Arrays.asList(22, 8, 9)),
                Warning.of(CheckPhrase.CAMERA), Decimal.of(1, 1), Decimal.of(-1234.56, 1), Decimal.of(Double.NaN, 1),
                "", "");
        assertEquals("Die Zahlen stützen sich trotzdem auf die Referenzen 22, 8 und 9: Ohne sie verschiebt sich die "
                + "Kamera um (1,0; -1234,6; nicht definiert) mm", plain(in("de").message(bare)));
    }

    /** A photo whose corners are noisier than stated: core's sentence, in both languages. */
    @Test
    public void whatAPhotoContradictsIsSaidWithTheVerdict() {
        Cell cell = Fixture.LIFTED.cell();
        List<MarkerObservation> markers = new ArrayList<>();
        RigidTransform cameraFromWorld = RigidTransform.ofEuler(418, 106, 1070, 3.08, 0.10, 0.02).inverse();
        for (Reference reference : cell.references()) {
            double[] corners = MarkerGeometry.cornersMm(cameraFromWorld.compose(reference.worldFromMarker()),
                    reference.sizeMm());
            double[] px = new double[8];
            for (int k = 0; k < 4; k++) {
                double[] uv = cell.camera().project(corners[3 * k], corners[3 * k + 1], corners[3 * k + 2]);
                // every other corner half a pixel outwards: no square, and no noise of 0.05 px
                px[2 * k] = uv[0] + (k % 2 == 0 ? 0.5 : 0);
                px[2 * k + 1] = uv[1];
            }
            markers.add(new MarkerObservation(reference.id(), px));
        }
        says(cell, markers, "But corners are ", "Die Ecken rauschen aber ");
    }

    private static void says(Cell cell, List<MarkerObservation> markers, String english, String german) {
        CheckResult result = CellCheck.run(Fixture.with(cell, 0.05, OptionalDouble.of(50)),
                new Detections("photo", cell.camera().widthPx(), cell.camera().heightPx(), markers),
                CheckSettings.builder().targetMcseStdRel(0.05).build());
        String core = result.finding().english();
        assertTrue(core, core.contains(english));
        assertTrue(plain(in("en").reason(result.finding())).contains(core.substring(core.indexOf(english))));
        String words = plain(in("de").reason(result.finding()));
        assertTrue(words, words.contains(german));
        assertTrue(words, words.contains("angegebenen 0,050 px"));
    }

    /** What the command line adds to a check is no string of the app. */
    @Test
    public void aKindOfSomeoneElseIsSaidInEnglish() {
        WarningKind other = () -> "marker %s is not mine";
        assertEquals(WarningStrings.NONE, WarningStrings.of(other));
        assertEquals("marker 5 is not mine", in("de").message(Warning.of(other, 5)));
    }
}
