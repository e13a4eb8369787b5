package org.cellgauge.android.state;

import java.util.List;
import org.cellgauge.cell.Requirement;
import org.cellgauge.check.Conformity;
import org.cellgauge.output.ResultRow;

/**
 * How much of what is asked of an object it takes, of all that is asked the worst; immutable.
 *
 * @param share what it takes of what is asked: 1 at the limit; of a tolerance, the risk taken of the risk allowed
 * @param stdMm the standard deviation, mm, where one is limited; else NaN
 * @param limitMm its limit, mm
 * @param axis world axis of that deviation: 0, 1, 2 for x, y, z
 * @param grip whether the gripping point is meant and not the object's position
 * @param conformity the tolerance and how surely it is kept, where one is asked for; else null
 */
public record TargetUse(double share, double stdMm, double limitMm, int axis, boolean grip, Conformity conformity) {
    private static final int AXES = 3;

    /**
     * What an object takes.
     *
     * @param asked what is asked of it
     * @param position figures of its position
     * @param gripping figures of its gripping point, or null
     * @return the worst; null where nothing is asked, or nothing known of what is
     */
    static TargetUse of(Requirement asked, ResultRow position, ResultRow gripping) {
        TargetUse worst = worse(of(asked, position, false, null), asked, position, false);
        return gripping == null ? worst : worse(of(asked, gripping, true, worst), asked, gripping, true);
    }

    private static TargetUse of(Requirement asked, ResultRow point, boolean grip, TargetUse before) {
        TargetUse worst = before;
        double[] std = point.std();
        for (int axis = 0; std != null && axis < AXES; axis++) {
            double share = std[axis] / asked.stdMm().of(axis);
            if (share > 0 && (worst == null || share > worst.share)) {
                worst = new TargetUse(share, std[axis], asked.stdMm().of(axis), axis, grip, null);
            }
        }
        return worst;
    }

    private static TargetUse worse(TargetUse before, Requirement asked, ResultRow point, boolean grip) {
        TargetUse worst = before;
        List<Conformity> conformities = point.conformities();
        for (Conformity c : conformities) {
            double share = (1 - c.probability()) / (1 - asked.probability());
            if (worst == null || share > worst.share) {
                worst = new TargetUse(share, Double.NaN, c.tolerance(), 0, grip, c);
            }
        }
        return worst;
    }
}
