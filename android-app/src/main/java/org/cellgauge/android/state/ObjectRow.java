package org.cellgauge.android.state;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.cellgauge.check.Reason;
import org.cellgauge.statistics.Ellipse;

/** What the list says of one object of the cell; immutable. */
public final class ObjectRow {
    /** How an object was judged. */
    public enum Mark {
        /** Within the target. */
        OK,
        /** Beyond the target. */
        NOT_OK,
        /** The chains have not converged yet: no figure to rely on. */
        PRELIMINARY,
        /** The chains ended without converging: no figure at all. */
        NOT_CONVERGED,
        /** Two poses explain what is seen: no figure at all. */
        AMBIGUOUS,
        /** Converged; there is no target to judge by. */
        NOT_JUDGED,
        /** The object is in view, and nothing can be said of it: no reference is, the frame was refused, or
         * references contradict each other.
         */
        NO_FIGURE,
        /** The object is not in view. */
        NOT_SEEN
    }

    private final int id;
    private final Mark mark;
    private final double[] stdMm;
    private final double[] gripStdMm;
    private final Ellipse ellipse95Px;
    private final Reason reason;
    private final TargetUse use;
    private final List<Double> poseShares;

    /**
     * A row.
     *
     * @param id marker id
     * @param mark how it was judged
     * @param stdMm standard deviations along world x, y, z in mm, or null where there is no figure
     * @param gripStdMm those of its gripping point in mm, or null
     * @param ellipse95Px the 95 % ellipse of its position in px of the image as it came, or null
     * @param reason why it was judged so, or what causes its largest deviation; null where there is nothing to say
     * @param use how much of what is asked it takes, or null
     * @param poseShares shares of the poses that fit, where several do
     */
    ObjectRow(int id, Mark mark, double[] stdMm, double[] gripStdMm, Ellipse ellipse95Px, Reason reason,
            TargetUse use, List<Double> poseShares) {
        this.id = id;
        this.mark = mark;
        this.stdMm = stdMm;
        this.gripStdMm = gripStdMm;
        this.ellipse95Px = ellipse95Px;
        this.reason = reason;
        this.use = use;
        this.poseShares = Collections.unmodifiableList(new ArrayList<>(poseShares));
    }

    /**
     * Marker id.
     *
     * @return the id
     */
    public int id() {
        return id;
    }

    /**
     * How it was judged.
     *
     * @return never null
     */
    public Mark mark() {
        return mark;
    }

    /**
     * Standard deviations along world x, y and z.
     *
     * @return a copy, mm, or null where there is no figure
     */
    public double[] stdMm() {
        return stdMm == null ? null : stdMm.clone();
    }

    /**
     * Standard deviations of its gripping point.
     *
     * @return a copy, mm, or null where it has none or there is no figure
     */
    public double[] gripStdMm() {
        return gripStdMm == null ? null : gripStdMm.clone();
    }

    /**
     * The 95 % ellipse of its position.
     *
     * @return px of the image as it came, or null
     */
    public Ellipse ellipse95Px() {
        return ellipse95Px;
    }

    /**
     * Why it was judged so, or what causes its largest deviation.
     *
     * @return core's reason, or null
     */
    public Reason reason() {
        return reason;
    }

    /**
     * How much of what is asked of it the object takes.
     *
     * @return null where there is no figure or nothing is asked
     */
    public TargetUse use() {
        return use;
    }

    /**
     * Shares of the poses that fit, as in the picture.
     *
     * @return 0 to 1 each, unmodifiable; empty where one pose fits
     */
    public List<Double> poseShares() {
        return poseShares;
    }
}
