package org.cellgauge.cli;

import java.util.List;
import org.cellgauge.check.Verdict;

/** What the program tells a calling script. */
final class ExitCodes {
    static final int OK = 0;
    static final int INTERNAL_ERROR = 1;
    static final int USAGE = 2;
    static final int INPUT_REFUSED = 3;
    static final int TARGET_MISSED = 4;
    static final int NO_FIGURE = 5;

    /** Most serious first: what hides more of the answer comes before what is known. */
    private static final List<Integer> BY_SERIOUSNESS = List.of(INTERNAL_ERROR, USAGE, INPUT_REFUSED, NO_FIGURE,
            TARGET_MISSED, OK);

    private ExitCodes() {
    }

    /** The code of one verdict. */
    static int of(Verdict verdict) {
        switch (verdict) {
            case PASS:
            case NO_TARGET:
                return OK;
            case FAIL:
                return TARGET_MISSED;
            default:
                return NO_FIGURE;
        }
    }

    /** The more serious of two codes. */
    static int moreSerious(int a, int b) {
        return BY_SERIOUSNESS.indexOf(a) <= BY_SERIOUSNESS.indexOf(b) ? a : b;
    }
}
