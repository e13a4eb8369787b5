package org.cellgauge.android.screen;

import org.cellgauge.android.R;
import org.cellgauge.android.state.FusedViews;
import org.cellgauge.android.state.ObjectRow;
import org.cellgauge.cell.Requirement;
import org.cellgauge.cell.Target;
import org.cellgauge.check.Verdict;

/** Rows of the list that are about objects, of a running check and of a kept result alike. */
final class ObjectRows {
    /** Deviations on either side of the mean that hold 95 % of a normal distribution. */
    private static final double DEVIATIONS_95 = 1.96;

    private final Wording words;
    private final Target target;
    private final Verdict verdict;
    private final boolean lensMeasured;
    private final FusedViews fused;

    /**
     * Rows of one result.
     *
     * @param words the language
     * @param target what is asked of the objects
     * @param verdict on all of them, or null
     * @param lensMeasured whether somebody calibrated the lens
     * @param fused views taken together, or null
     */
    ObjectRows(Wording words, Target target, Verdict verdict, boolean lensMeasured, FusedViews fused) {
        this.words = words;
        this.target = target;
        this.verdict = verdict;
        this.lensMeasured = lensMeasured;
        this.fused = fused;
    }

    /** All that is said of an object. */
    Row row(ObjectRow object) {
        String figures = null;
        String text = null;
        if (object.stdMm() != null) {
            figures = deviations(R.string.figures, object.stdMm()) + "\n" + coverage(object.stdMm());
            if (object.gripStdMm() != null) {
                figures += "\n" + deviations(R.string.figures_grip, object.gripStdMm());
            }
            if (object.mark() == ObjectRow.Mark.PRELIMINARY) {
                figures += "\n" + words.get(R.string.figures_preliminary);
            }
            if (fused != null && fused.count() > 1 && fused.stdMm(object.id()) != null) {
                figures += "\n" + words.plural(R.plurals.figures_fused, fused.count(), fused.count(),
                        deviations(R.string.figures, fused.stdMm(object.id())));
            }
            // what is said of all objects alike stands in the reason, once
            text = words.cause(object.reason());
            if (object.mark() == ObjectRow.Mark.NOT_OK && !isBeyond(object)) {
                text = (text == null ? "" : text) + words.misfit(object.reason(), "\n")
                        + words.misplacement(object.reason(), "\n");
            }
        } else if (object.mark() == ObjectRow.Mark.AMBIGUOUS) {
            text = object.reason() == null ? words.get(R.string.no_figure_two_poses) : words.reason(object.reason());
            if (object.poseShares().size() == 2) {
                text += "\n" + words.get(R.string.pose_shares, words.percent(object.poseShares().get(0)),
                        words.percent(object.poseShares().get(1)));
            }
        } else if (object.mark() == ObjectRow.Mark.NOT_CONVERGED) {
            text = words.get(R.string.no_figure_not_converged);
        }
        boolean contradicted = verdict == Verdict.CONTRADICTED;
        if (contradicted && object.mark() == ObjectRow.Mark.NO_FIGURE) {
            text = words.get(R.string.no_figure_not_converged);
        }
        return new Row(drawable(object.mark()), colour(object.mark(), lensMeasured),
                words.get(R.string.object_title, object.id(), mark(object)), figures,
                text == null || text.isEmpty() ? null : text, null)
                .withBar(object.use() == null ? Double.NaN : object.use().share(), words.use(object.use()))
                .ofObject(object.id());
    }

    /** Deviations along the three axes, in a pattern. */
    String deviations(int id, double[] stdMm) {
        return words.get(id, words.mm(stdMm[0]), words.mm(stdMm[1]), words.mm(stdMm[2]));
    }

    /** The same along every axis within 95 %: what the picture's ellipses hold. Draws are nearly normal where shown. */
    private String coverage(double[] stdMm) {
        double[] within = new double[stdMm.length];
        for (int i = 0; i < within.length; i++) {
            within[i] = DEVIATIONS_95 * stdMm[i];
        }
        return words.get(R.string.figures_95, words.mm(within[0]), words.mm(within[1]), words.mm(within[2]));
    }

    /** Whether its own figures are beyond what is asked, and not what else does not fit. */
    private static boolean isBeyond(ObjectRow object) {
        return object.use() != null && object.use().share() > 1;
    }

    /** How an object stands, in a few words. */
    String mark(ObjectRow object) {
        Requirement asked = target.of(object.id());
        switch (object.mark()) {
            case OK:
                return asked.isOneStd() ? words.get(R.string.mark_ok, words.plain(asked.stdMm().x()))
                        : words.get(R.string.mark_target_met);
            case NOT_OK:
                return asked.isOneStd() && isBeyond(object)
                        ? words.get(R.string.mark_not_ok, words.plain(asked.stdMm().x()))
                        : words.get(R.string.mark_target_missed);
            case PRELIMINARY:
                return words.get(R.string.mark_preliminary);
            case NOT_CONVERGED:
                return words.get(R.string.mark_not_converged);
            case AMBIGUOUS:
                return words.get(R.string.mark_ambiguous);
            case NOT_JUDGED:
                return words.get(target.isAny() && !asked.isAny() ? R.string.mark_not_counted
                        : R.string.mark_not_judged);
            case NO_FIGURE:
                return words.get(R.string.mark_no_figure);
            default:
                return words.get(R.string.mark_not_seen);
        }
    }

    /** The sign of a mark. */
    static int drawable(ObjectRow.Mark mark) {
        switch (mark) {
            case OK:
                return R.drawable.mark_pass;
            case NOT_OK:
                return R.drawable.mark_fail;
            case PRELIMINARY:
                return R.drawable.mark_preliminary;
            case NOT_CONVERGED:
                return R.drawable.mark_not_converged;
            case AMBIGUOUS:
                return R.drawable.mark_ambiguous;
            case NOT_JUDGED:
                return R.drawable.mark_not_judged;
            case NO_FIGURE:
                return R.drawable.mark_no_figure;
            default:
                return R.drawable.mark_not_seen;
        }
    }

    /** The colour of a mark: no green where nobody measured the lens. */
    static int colour(ObjectRow.Mark mark, boolean lensMeasured) {
        switch (mark) {
            case OK:
                return lensMeasured ? R.color.mark_pass : R.color.mark_neutral;
            case NOT_OK:
            case NOT_SEEN:
                return R.color.mark_fail;
            case NOT_CONVERGED:
                return R.color.mark_not_converged;
            case AMBIGUOUS:
                return R.color.mark_ambiguous;
            default:
                return R.color.mark_neutral;
        }
    }
}
