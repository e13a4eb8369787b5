package org.cellgauge.warning;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Arrays;
import java.util.Collections;
import org.cellgauge.internal.warning.Listing;
import org.junit.jupiter.api.Test;

class RefusalTest {
    private enum Kind implements RefusalKind {
        SIZE("must be at least %s, got %s; write %s"),
        REMEDY("a length in mm"),
        OTHER("%s"),
        ROW("known here: %s"),
        NUMBERED("%1$s of %1$s");

        private final String english;

        Kind(String english) {
            this.english = english;
        }

        @Override
        public String english() {
            return english;
        }
    }

    private static final Place PLACE = Place.of("cell.yaml", 7, 0, "references.944");

    /** Right-to-left override, C1 control, escape, line separator: none of them reaches a terminal. */
    @Test
    void textsOfFilesCannotCommandATerminal() {
        String evil = "a\u001b[31m\u009b\u202egnp\u2028b";
        assertEquals("a [31m  gnp b: a [31m  gnp b", Refusal.at(Place.of(evil), Kind.OTHER, evil).toString());
        assertEquals("known here: a [31m  gnp b",
                Refusal.of(Kind.ROW, Listing.comma(Arrays.asList(evil))).toString());
        assertEquals("\ud83d\ude00", Refusal.of(Kind.OTHER, "\ud83d\ude00").toString());
    }

    @Test
    void messagesStayAsLongAsPeopleRead() {
        String text = Refusal.of(Kind.OTHER, "x".repeat(1_000_000)).toString();
        assertEquals("x".repeat(497) + "...", text);
        String row = Refusal.of(Kind.ROW, Listing.and(Collections.nCopies(1000, 7))).toString();
        assertEquals("known here: " + "7, ".repeat(58) + "7 and ... (+941)", row);
    }

    @Test
    void placeStandsBeforeWhatIsWrong() {
        assertEquals("cell.yaml, line 7, references.944: must be at least 1, got -3; write a length in mm",
                Refusal.at(PLACE, Kind.SIZE, 1, "-3", Kind.REMEDY).toString());
        assertEquals("d.json, line 2, column 9: a length in mm",
                Refusal.at(Place.of("d.json", 2, 9, ""), Kind.REMEDY).toString());
        assertEquals("a.png: a length in mm", Refusal.of(Kind.REMEDY).withPlace(Place.of("a.png")).toString());
        assertEquals("a length in mm", Refusal.of(Kind.REMEDY).toString());
    }

    @Test
    void refusalOfAnotherFileKeepsItsPlace() {
        assertEquals("cell.yaml, line 7, references.944: camera.yaml: a length in mm",
                Refusal.at(PLACE, Kind.OTHER, Refusal.at(Place.of("camera.yaml"), Kind.REMEDY)).toString());
    }

    /** What stands in a file must not command the terminal that shows it. */
    @Test
    void controlCharactersAreSpaces() {
        Refusal refusal = Refusal.at(Place.of("a\u001b[2J.yaml", 1, 0, "k\ty"), Kind.SIZE, 1, "\u0007x",
                Refusal.of(Kind.ROW, Listing.comma(Arrays.asList("a\nb", Refusal.of(Kind.OTHER, "\r")))));
        assertEquals("a [2J.yaml, line 1, k y: must be at least 1, got  x; write known here: a b,  ",
                refusal.toString());
        assertEquals("a [2J.yaml", refusal.place().file());
        assertEquals(" x", refusal.arguments().get(1));
    }

    @Test
    void equalityIsOfPlaceKindAndArguments() {
        Refusal refusal = Refusal.at(PLACE, Kind.OTHER, 5);
        assertEquals(Refusal.at(Place.of("cell.yaml", 7, 0, "references.944"), Kind.OTHER, 5), refusal);
        assertEquals(Refusal.at(PLACE, Kind.OTHER, 5).hashCode(), refusal.hashCode());
        assertNotEquals(Refusal.of(Kind.OTHER, 5), refusal);
        assertNotEquals(Refusal.at(PLACE, Kind.OTHER, 6), refusal);
        assertNotEquals(Refusal.at(PLACE, Kind.ROW, 5), refusal);
    }

    @Test
    void partsCanBeSaidInOtherWords() {
        Refusal refusal = Refusal.at(PLACE, Kind.ROW, Listing.and(Arrays.asList(3, Kind.REMEDY)));
        assertEquals("cell.yaml, line 7, references.944: known here: 3 and --length",
                refusal.english(kind -> kind == Kind.REMEDY ? "--length" : kind.english()));
    }

    @Test
    void argumentsFitTheKind() {
        assertThrows(IllegalArgumentException.class, () -> Refusal.of(Kind.OTHER));
        assertThrows(IllegalArgumentException.class, () -> Refusal.of(Kind.OTHER, 1.5));
        // a part with places is no part without its arguments
        assertThrows(IllegalArgumentException.class, () -> Refusal.of(Kind.OTHER, Kind.ROW));
        assertThrows(IllegalArgumentException.class, () -> Refusal.of(Kind.NUMBERED, 5));
    }
}
