package org.cellgauge.desktop;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;

class SummaryCsvTest {
    /** Tables that people open from mail: a name must not become a formula, nor a line of its own. */
    @Test
    void namesAreNoFormulas() {
        StringBuilder summary = new StringBuilder(SummaryCsv.header());
        for (String name : new String[] {"=cmd|'/c calc'!A1", "@SUM(A1)", "+1", "-1"}) {
            summary.append(SummaryCsv.row(new CheckInput(Path.of(name), false, name, null), "refused",
                    "a\u001b[2J\nb"));
        }
        String text = summary.toString();
        assertTrue(text.contains("\r\n'=cmd|'/c calc'!A1,'=cmd|'/c calc'!A1,refused,"), text);
        assertTrue(text.contains("\r\n'@SUM(A1),'@SUM(A1),refused,"), text);
        assertTrue(text.contains("\r\n'+1,'+1,refused,") && text.contains("\r\n'-1,'-1,refused,"), text);
        assertTrue(text.endsWith(",a [2J b,\r\n"), text);
    }
}
