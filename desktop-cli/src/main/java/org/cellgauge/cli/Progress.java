package org.cellgauge.cli;

import java.io.PrintWriter;
import java.util.function.LongSupplier;
import org.cellgauge.desktop.InputOutcome;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.internal.warning.Printable;

/** How far a batch is: on a terminal one line that is rewritten, with the time left; elsewhere a line of each input. */
final class Progress {
    private static final int SECONDS_A_MINUTE = 60;

    private final PrintWriter err;
    private final boolean rewritten;
    private final int columns;
    private final LongSupplier nanoTime;
    private final long startNs;
    private int checked;
    private int shown;
    private String line = "";

    /**
     * Progress of a batch that begins now.
     *
     * @param err where it goes
     * @param rewritten whether that is a terminal that can go back to the beginning of a line
     * @param columns of it
     * @param nanoTime a clock, ns
     */
    Progress(PrintWriter err, boolean rewritten, int columns, LongSupplier nanoTime) {
        this.err = err;
        this.rewritten = rewritten;
        this.columns = columns;
        this.nanoTime = nanoTime;
        startNs = nanoTime.getAsLong();
    }

    /** Makes room for a message. */
    void clear() {
        if (shown > 0) {
            err.print("\r" + " ".repeat(shown) + "\r");
            err.flush();
            shown = 0;
        }
    }

    /**
     * An input is done.
     *
     * @param outcome what became of it
     * @param words of its result
     */
    void done(InputOutcome outcome, String words) {
        String name = Printable.of(outcome.input().name());
        String count = "[" + outcome.number() + "/" + outcome.count() + "] ";
        if (rewritten) {
            checked += outcome.isKept() ? 0 : 1;
            line = count + left(outcome) + name + ": " + words;
            show();
        } else {
            err.println(count + name + ": " + words + (outcome.isKept() ? " (kept)"
                    : String.format(Decimal.POINT, " (%.2f s)", outcome.seconds())));
            err.flush();
        }
    }

    private void show() {
        clear();
        String fitting = line.substring(0, Math.min(line.length(), columns - 1));
        err.print(fitting);
        err.flush();
        shown = fitting.length();
    }

    /** What is left, if the next take as long as those so far did; those kept took no time worth counting. */
    private String left(InputOutcome outcome) {
        int inputs = outcome.count() - outcome.number();
        double each = (nanoTime.getAsLong() - startNs) * 1e-9 / (checked == 0 ? outcome.number() : checked);
        return inputs == 0 ? "" : text(Math.round(each * inputs)) + " left, ";
    }

    /** Minutes and seconds, or hours and minutes. */
    static String text(long seconds) {
        long minutes = seconds / SECONDS_A_MINUTE;
        return minutes < SECONDS_A_MINUTE
                ? String.format(Decimal.POINT, "%d:%02d min", minutes, seconds % SECONDS_A_MINUTE)
                : String.format(Decimal.POINT, "%d:%02d h", minutes / SECONDS_A_MINUTE, minutes % SECONDS_A_MINUTE);
    }
}
