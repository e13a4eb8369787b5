package org.cellgauge.internal.overlay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

class StrokeFontTest {
    private static List<double[]> strokes(String text, double leftPx, double baselinePx, double capHeightPx) {
        return new TextShape(Role.LABEL, Status.NEUTRAL, 0.1, leftPx, baselinePx, capHeightPx, text).strokes();
    }

    private static final String BEYOND_ASCII = "\u03c3\u00b1\u00d7\u00b0\u00b2"
            + "\u2013\u2014\u2026\u2019\u2264\u2265\u2248\u00b5\u2212"
            + "\u00e4\u00f6\u00fc\u00c4\u00d6\u00dc\u00df";

    @Test
    void hasAllPrintableCharactersAndTheSignsOfMessages() {
        for (char c = ' '; c <= '~'; c++) {
            assertTrue(StrokeFont.has(c), "no glyph for " + c);
        }
        for (char c : BEYOND_ASCII.toCharArray()) {
            assertTrue(StrokeFont.has(c), "no glyph for " + c);
        }
    }

    @Test
    void everyGlyphStaysWithinItsAdvanceAndTheHeightOfALine() {
        String all = BEYOND_ASCII;
        for (char c = '!'; c <= '~'; c++) {
            all += c;
        }
        for (char c : all.toCharArray()) {
            String text = String.valueOf(c);
            Box box = Box.around(strokes(text, 100, 200, 14));
            // a quarter of the gap between letters may be taken by a serif or a bow
            assertTrue(box.left() > 100 - 0.9 && box.right() < 100 + 14 * StrokeFont.widthInCapHeights(text) + 0.9,
                    c + " sticks out sideways: " + box);
            assertTrue(box.top() >= 200 - 14 * StrokeFont.ASCENT - 1e-9
                    && box.bottom() <= 200 + 14 * StrokeFont.DESCENT,
                    c + " sticks out of its line: " + box);
        }
    }

    @Test
    void capitalsAreAsHighAsStated() {
        for (char c : "ABDEFHIKLMNPRTUVWXYZ".toCharArray()) {
            Box box = Box.around(strokes(String.valueOf(c), 0, 0, 30));
            assertEquals(-30, box.top(), 1e-9, "top of " + c);
            assertEquals(0, box.bottom(), 1e-9, "foot of " + c);
        }
    }

    @Test
    void noTwoCharactersLookTheSame() {
        for (char a = '!'; a <= '~'; a++) {
            for (char b = '!'; b < a; b++) {
                assertFalse(same(strokes(String.valueOf(a), 0, 0, 1),
                        strokes(String.valueOf(b), 0, 0, 1)), a + " and " + b);
            }
        }
    }

    /** Two dots, above the letter, and the letter itself below them as it is elsewhere, or a lower capital. */
    @Test
    void dottedLettersAreThoseLettersWithTwoDots() {
        String dotted = "\u00e4\u00f6\u00fc\u00c4\u00d6\u00dc";
        String plain = "aouAOU";
        for (int i = 0; i < dotted.length(); i++) {
            List<double[]> letter = strokes(dotted.substring(i, i + 1), 0, 0, 14);
            List<double[]> without = strokes(plain.substring(i, i + 1), 0, 0, 14);
            int body = without.size();
            assertEquals(body + 2, letter.size(), dotted.substring(i, i + 1));
            Box left = Box.around(letter.subList(body, body + 1));
            Box right = Box.around(letter.subList(body + 1, body + 2));
            Box under = Box.around(letter.subList(0, body));
            assertTrue(left.bottom() < under.top() - 1.5, "apart from the letter");
        assertTrue(right.bottom() < under.top() - 1.5, "apart from the letter");
            assertTrue(right.left() - left.right() > 2.5, "apart from each other");
            assertEquals((left.left() + right.left()) / 2, (under.left() + under.right()) / 2, 0.4, "in the middle");
            assertEquals(StrokeFont.widthInCapHeights(plain.substring(i, i + 1)),
                    StrokeFont.widthInCapHeights(dotted.substring(i, i + 1)));
            assertEquals(i < 3, same(without, letter.subList(0, body)), "capitals are lower");
        }
        assertFalse(same(strokes("B", 0, 0, 14), strokes("\u00df", 0, 0, 14)));
    }

    @Test
    void spacesThatBindAreAsWideAsOthersAndEndNoLine() {
        for (char space : "\u00a0\u202f".toCharArray()) {
            assertTrue(StrokeFont.has(space));
            assertEquals(StrokeFont.widthInCapHeights("2 mm"), StrokeFont.widthInCapHeights("2" + space + "mm"));
            assertEquals(strokes("2 mm", 0, 0, 14).size(),
                    strokes("2" + space + "mm", 0, 0, 14).size());
            String bound = "2" + space + "mm";
            assertEquals(List.of("about", bound, "off"),
                    StrokeFont.wrap("about " + bound + " off", StrokeFont.widthInCapHeights("about 2")));
        }
    }

    private static boolean same(List<double[]> a, List<double[]> b) {
        if (a.size() != b.size()) {
            return false;
        }
        for (int i = 0; i < a.size(); i++) {
            if (!java.util.Arrays.equals(a.get(i), b.get(i))) {
                return false;
            }
        }
        return true;
    }

    @Test
    void aCharacterItLacksIsDrawnAsABox() {
        List<double[]> strokes = strokes("\u4e2d", 0, 0, 14);
        assertEquals(1, strokes.size());
        assertEquals(10, strokes.get(0).length);
        assertFalse(StrokeFont.has('\u4e2d'));
    }

    @Test
    void textMovesAndScalesWithItsAnchorAndHeight() {
        List<double[]> small = strokes("Gap 5", 0, 0, 10);
        List<double[]> large = strokes("Gap 5", 7, 9, 25);
        for (int i = 0; i < small.size(); i++) {
            for (int k = 0; k < small.get(i).length; k += 2) {
                assertEquals(7 + 2.5 * small.get(i)[k], large.get(i)[k], 1e-9);
                assertEquals(9 + 2.5 * small.get(i)[k + 1], large.get(i)[k + 1], 1e-9);
            }
        }
    }

    @Test
    void wrappedLinesFitAndKeepAllWordsInOrder() {
        String text = "Largest deviation: 2.41 mm in z of the gripping point of object 20 against a target of 3 mm";
        for (double width : new double[] {12, 20, 35, 200}) {
            List<String> lines = StrokeFont.wrap(text, width);
            assertEquals(text, String.join(" ", lines));
            for (String line : lines) {
                assertTrue(StrokeFont.widthInCapHeights(line) <= width, line);
            }
        }
        assertEquals(1, StrokeFont.wrap(text, 200).size());
    }

    @Test
    void aWordWiderThanALineIsBroken() {
        List<String> lines = StrokeFont.wrap("a verylongnamewithoutanyspaces b", 5);
        assertEquals("averylongnamewithoutanyspacesb", String.join("", lines).replace(" ", ""));
        for (String line : lines) {
            assertTrue(StrokeFont.widthInCapHeights(line) <= 5, line);
        }
    }

    @Test
    void anEmptyTextIsOneEmptyLine() {
        assertEquals(List.of(""), StrokeFont.wrap("", 10));
        assertEquals(0, StrokeFont.widthInCapHeights(""));
    }
}
