package org.cellgauge.cell;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** The edit distance and the words it chooses. */
class SuggestionsTest {
    @Test
    void distanceCountsInsertionsDeletionsAndReplacements() {
        assertEquals(3, Suggestions.distance("kitten", "sitting"));
        assertEquals(0, Suggestions.distance("size_mm", "size_mm"));
        assertEquals(4, Suggestions.distance("", "grip"));
        assertEquals(2, Suggestions.distance("grip", "gr"));
    }

    @Test
    void nearestWordIsSuggestedWhateverItsCaseAndDashes() {
        assertEquals("did you mean \"std_deg\"?",
                Suggestions.remedy("STD-DEG", Arrays.asList("std_mm", "std_deg")).toString());
    }

    @Test
    void forgottenUnitIsSuggested() {
        assertEquals("did you mean \"grip_mm\"?",
                Suggestions.remedy("grip", Arrays.asList("size_mm", "grip_mm")).toString());
    }

    @Test
    void allWordsAreListedWhereNoneIsNear() {
        assertEquals("known here: std_mm, std_deg",
                Suggestions.remedy("colour", Arrays.asList("std_mm", "std_deg")).toString());
    }
}
