package org.cellgauge.android.screen;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** Lines that were broken for a page are joined, and no others. */
class ParagraphsTest {
    @Test
    void brokenLinesOfAParagraphAreJoined() {
        assertEquals(
                "\"License\" shall mean the terms and conditions for use, reproduction, and distribution.\n\nNext",
                Paragraphs.of("      \"License\" shall mean the terms and conditions for use, reproduction,\n"
                        + "      and distribution.\n\n      Next\n"));
    }

    @Test
    void titlesAndShortLinesStayOnTheirOwn() {
        String notice = "Apache Commons Math\nCopyright 2001-2016 The Foundation";
        assertEquals(notice, Paragraphs.of(notice));
    }

    @Test
    void itemsOfAListBeginANewLine() {
        String list = "- some-library-with-a-long-name 1.2.2 (org.example): Apache License 2.0\n- gson 2.11.0";
        assertEquals(list, Paragraphs.of(list));
        String items = "(a) You must give any other recipients of the Work a copy; and\n"
                + "2. The end-user documentation must include the following";
        assertEquals(items, Paragraphs.of(items));
    }

    @Test
    void rulesAreShortAndEmptyLinesSingle() {
        String line = "a line that is as long as a line of a page may be";
        assertEquals(line + "\n———\n\nb", Paragraphs.of("\n\n" + line + "\n====================\n\n \n\nb\n\n"));
    }
}
