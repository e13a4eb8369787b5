package org.cellgauge.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.Map;
import org.cellgauge.desktop.CheckInput;
import org.cellgauge.desktop.InputOutcome;
import org.junit.jupiter.api.Test;

class ProgressTest {
    private final StringWriter text = new StringWriter();
    private long now;

    private static InputOutcome outcome(int number, boolean kept, String name) {
        return new InputOutcome(new CheckInput(Path.of(name), false, name, null), InputOutcome.Kind.REFUSED, null, null,
                null, kept, 0, number, 10, 0.25);
    }

    @Test
    void aTerminalHasOneLineWithTheTimeLeft() {
        Progress progress = new Progress(new PrintWriter(text), true, 60, () -> now);
        now = 1_000_000L;
        progress.done(outcome(1, true, "a"), "pass");
        // what was kept took no time: eight are left at 30 s each
        now += 30_000_000_000L;
        progress.done(outcome(2, false, "b\u001b[2J\u202e\n"), "pass");
        String shown = text.toString();
        assertTrue(shown.endsWith("\r[2/10] 4:00 min left, b [2J  : pass"), shown);
        assertFalse(shown.contains("\n"));
        progress.done(outcome(3, false, "x".repeat(200)), "pass");
        String last = text.toString().substring(text.toString().lastIndexOf('\r') + 1);
        assertEquals(59, last.length(), "within the terminal");
        progress.clear();
        assertTrue(text.toString().endsWith("\r" + " ".repeat(59) + "\r"));
        assertEquals("1:01 h", Progress.text(3661));
    }

    @Test
    void elsewhereEveryInputHasItsLine() {
        Progress progress = new Progress(new PrintWriter(text), false, 60, () -> now);
        progress.done(outcome(1, true, "a"), "pass");
        progress.done(outcome(2, false, "b"), "FAIL");
        progress.clear();
        assertEquals(String.format("[1/10] a: pass (kept)%n[2/10] b: FAIL (0.25 s)%n"), text.toString());
    }

    /** Tests run without the start script, which says so of a terminal. */
    @Test
    void nothingIsRewrittenWhereNobodySaysThatItIsATerminal() {
        assertFalse(Main.isTerminal(Map.of("TERM", "xterm")));
    }
}
