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
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.Reference;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.geometry.MarkerGeometry;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.DetectionWarning;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.cellgauge.warning.CheckPhrase;
import org.cellgauge.warning.CheckWarning;
import org.cellgauge.warning.Decimal;
import org.cellgauge.warning.Listing;
import org.cellgauge.warning.Warning;
import org.cellgauge.warning.WarningKind;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;

/** Warnings in both languages. That their strings take the same arguments in both: {@link StringsTest}. */
@RunWith(RobolectricTestRunner.class)
public class WarningWordsTest {
    private static List<WarningKind> kinds() {
        List<WarningKind> kinds = new ArrayList<>(Arrays.asList(DetectionWarning.values()));
        kinds.addAll(Arrays.asList(CheckWarning.values()));
        kinds.addAll(Arrays.asList(CheckPhrase.values()));
        return kinds;
    }

    private static Wording in(String language) {
        RuntimeEnvironment.setQualifiers(language);
        return new Wording(RuntimeEnvironment.getApplication().getResources());
    }

    /** A warning of each kind, whose arguments are names that are the same in every language. */
    private static Warning sample(WarningKind kind) {
        int places = kind.english().split("%s", -1).length - 1;
        Object[] arguments = new Object[places];
        for (int i = 0; i < places; i++) {
            arguments[i] = "<" + (char) ('a' + i) + ">";
        }
        return Warning.of(kind, arguments);
    }

    private static String plain(String text) {
        return text.replace('\u00a0', ' ');
    }

    @Test
    public void everyKindHasAStringOfItsOwn() {
        Set<Integer> ids = new HashSet<>();
        for (WarningKind kind : kinds()) {
            assertTrue(kind + " has a string", WarningStrings.of(kind) != WarningStrings.NONE);
            assertTrue(kind + " shares its string", ids.add(WarningStrings.of(kind)));
        }
    }

    @Test
    public void englishIsCoresSentence() {
        Wording words = in("en");
        for (WarningKind kind : kinds()) {
            // the app has no option that allows more
            String core = sample(kind).toString().replace("allow more with --max-iterations",
                    "only the command line can be allowed more");
            assertEquals(core, plain(words.warning(sample(kind))));
        }
    }

    @Test
    public void germanHasEveryArgumentAndNoEnglishSentence() {
        Wording words = in("de");
        for (WarningKind kind : kinds()) {
            Warning warning = sample(kind);
            String german = words.warning(warning);
            for (Object argument : warning.arguments()) {
                assertTrue(kind + " says " + argument, german.contains((String) argument));
            }
            assertFalse(german, german.contains("%%"));
            for (String word : "the its it is are and than left seen off instead against".split(" ")) {
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
                + "Referenz 8 oder 9 sein", plain(in("de").warning(misplaced())));
        assertEquals(misplaced().toString(), plain(in("en").warning(misplaced())));
        Warning capped = Warning.of(CheckWarning.CAP_REACHED, Decimal.of(100_000, 0), "camera_x", Decimal.of(1.66, 1),
                Decimal.shortest(0.1));
        String german = plain(in("de").warning(capped));
        assertTrue(german, german.contains("Grenze von 100.000 Schritten") && german.contains("von camera_x")
                && german.contains("1,7 % statt 0,1 %"));
        String english = plain(in("en").warning(capped));
        assertTrue(english, english.contains("cap of 100,000 iterations"));
        assertTrue(english, english.contains("1.7 % in place of 0.1 %"));
    }

    @Test
    public void placesInTheImageAreNotGrouped() {
        Warning square = Warning.of(DetectionWarning.SEEN_TWICE, 1234, 1500, 201, 2420, 1250);
        String german = plain(in("de").warning(square));
        assertTrue(german, german.startsWith("Marker 1234 ist bei (1500; 201) px und bei (2420; 1250) px"));
        assertEquals(square.toString(), plain(in("en").warning(square)));
    }

    @Test
    public void whatIsLeftOutLeavesNoTrace() {
        Warning bare = Warning.of(CheckWarning.FIGURES_REST_ON_THEM, Listing.and(Arrays.asList(22, 8, 9)),
                Warning.of(CheckPhrase.CAMERA), Decimal.of(1, 1), Decimal.of(-1234.56, 1), Decimal.of(Double.NaN, 1),
                "", "");
        assertEquals("Die Zahlen stützen sich trotzdem auf die Referenzen 22, 8 und 9: Ohne sie verschiebt sich die "
                + "Kamera um (1,0; -1234,6; nicht definiert) mm", plain(in("de").warning(bare)));
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
        assertEquals("marker 5 is not mine", in("de").warning(Warning.of(other, 5)));
    }
}
