package org.cellgauge.android.files;

import java.util.HashMap;
import java.util.Map;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Requirement;
import org.cellgauge.cell.Target;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.Verdict;
import org.cellgauge.settings.Estimate;

/** A result as it is drawn, on the screen and in the picture that is kept: no green that is not earned. */
public final class DrawnResult {
    private DrawnResult() {
    }

    /**
     * Whether the lens that a check went through was measured: else all of it is estimated along.
     *
     * @param result of a check by this app
     * @return whether it was
     */
    public static boolean isLensMeasured(CheckResult result) {
        return result.settings().model().estimate() != Estimate.INTRINSICS;
    }

    /**
     * Of a lens that nobody measured, what meets its target is drawn as if nothing were asked of it.
     *
     * @param result judged by the target in force; null for none
     * @param lensMeasured whether the lens was
     * @return the same where it was
     */
    public static CheckResult of(CheckResult result, boolean lensMeasured) {
        if (result == null || lensMeasured) {
            return result;
        }
        Map<Integer, Requirement> missed = new HashMap<>();
        for (ObjectMarker object : result.cell().objects()) {
            if (result.verdict(object.id()) == Verdict.FAIL) {
                missed.put(object.id(), result.cell().target().of(object.id()));
            }
        }
        return result.withTarget(new Target(Requirement.NONE, missed));
    }
}
