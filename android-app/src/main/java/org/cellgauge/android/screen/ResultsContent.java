package org.cellgauge.android.screen;

import java.time.LocalDateTime;
import java.time.format.DateTimeFormatter;
import java.time.format.FormatStyle;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.cellgauge.android.R;
import org.cellgauge.android.files.KeptResult;
import org.cellgauge.android.state.CheckFigures;
import org.cellgauge.android.state.ObjectRow;
import org.cellgauge.output.ResultRow;
import org.cellgauge.output.ResultView;
import org.cellgauge.output.WarningView;

/** What the screen of kept results says, in the user's language: pure text, as {@link ScreenContent}. */
final class ResultsContent {
    private static final String BULLET = "\u2022 ";
    /** Deviations that are nearer than so many of their Monte Carlo errors could be the same. */
    private static final double GUARD = 2;

    private final Wording words;

    /**
     * Content in one language.
     *
     * @param words the language
     */
    ResultsContent(Wording words) {
        this.words = words;
    }

    /** When a result was kept, as its screen's heading. */
    String time(KeptResult result) {
        LocalDateTime time = result.time();
        return time == null ? result.saved().name() : DateTimeFormatter.ofLocalizedDateTime(FormatStyle.MEDIUM,
                FormatStyle.MEDIUM).withLocale(words.locale()).format(time);
    }

    /** One row for each result; a tap leads to it by its place in the list. */
    List<Row> list(List<KeptResult> results) {
        List<Row> rows = new ArrayList<>();
        for (KeptResult result : results) {
            rows.add(head(time(result), result).ofObject(rows.size()));
        }
        return rows;
    }

    private Row head(String title, KeptResult result) {
        ResultView view = result.view();
        String name = result.cellName() == null ? result.saved().name()
                : words.get(R.string.result_of_cell, result.cellName(), result.saved().name());
        if (view == null) {
            return new Row(R.drawable.mark_not_converged, R.color.mark_fail, title, null,
                    name + "\n" + words.refusal(result.refusal()), null);
        }
        Banner banner = Banner.of(view);
        return new Row(banner.mark(), colour(banner), title, words.get(banner.headline()), name, null);
    }

    private static int colour(Banner banner) {
        switch (banner) {
            case PASS:
                return R.color.mark_pass;
            case FAIL:
                return R.color.mark_fail;
            case AMBIGUOUS:
                return R.color.mark_ambiguous;
            case NOT_CONVERGED:
            case CONTRADICTED:
                return R.color.mark_not_converged;
            default:
                return R.color.mark_neutral;
        }
    }

    /** All that is said of one result, below its picture. */
    List<Row> details(KeptResult result) {
        ResultView view = result.view();
        List<Row> rows = new ArrayList<>();
        Row head = head(time(result), result);
        if (view == null) {
            return Collections.singletonList(head);
        }
        rows.add(head.telling(head.text() + "\n" + words.target(view.target())));
        ObjectRows objects = rows(view);
        for (ObjectRow object : CheckFigures.rows(view)) {
            Row row = objects.row(object);
            rows.add(row.telling(object.stdMm() == null ? row.text() : budget(view, object.id())));
        }
        if (!view.warnings().isEmpty()) {
            List<String> sentences = new ArrayList<>();
            for (WarningView warning : view.warnings()) {
                sentences.add(BULLET + warning.text());
            }
            rows.add(new Row(R.drawable.mark_not_converged, R.color.mark_ambiguous,
                    words.get(R.string.result_warnings), null, String.join("\n", sentences), null));
        }
        return rows;
    }

    private ObjectRows rows(ResultView view) {
        return new ObjectRows(words, view.target(), view.verdict(), Banner.isLensMeasured(view), null);
    }

    private String budget(ResultView view, int id) {
        String text = words.budget(R.string.budget, view.object(id));
        ResultRow grip = view.grip(id);
        String ofGrip = grip == null ? "" : words.budget(R.string.budget_grip, grip);
        text += text.isEmpty() || ofGrip.isEmpty() ? ofGrip : "\n" + ofGrip;
        return text.isEmpty() ? null : text;
    }

    // ---- before and after

    /**
     * Two results side by side: of each object the deviations of both, which are smaller, and both verdicts.
     *
     * @param before the earlier one, that was read
     * @param after the later one, that was read
     * @return rows
     */
    List<Row> comparison(KeptResult before, KeptResult after) {
        List<Row> rows = new ArrayList<>();
        rows.add(side(R.string.compare_before, before));
        rows.add(side(R.string.compare_after, after));
        Map<Integer, ObjectRow> first = byId(before.view());
        Map<Integer, ObjectRow> second = byId(after.view());
        List<Integer> ids = new ArrayList<>(first.keySet());
        for (int id : second.keySet()) {
            if (!first.containsKey(id)) {
                ids.add(id);
            }
        }
        for (int id : ids) {
            rows.add(compared(id, before.view(), first.get(id), after.view(), second.get(id)));
        }
        return rows;
    }

    private Row side(int title, KeptResult result) {
        Row head = head(words.get(title, time(result)), result);
        return head.telling(head.text() + "\n" + words.target(result.view().target()));
    }

    private static Map<Integer, ObjectRow> byId(ResultView view) {
        Map<Integer, ObjectRow> rows = new LinkedHashMap<>();
        CheckFigures.rows(view).forEach(row -> rows.put(row.id(), row));
        return rows;
    }

    private Row compared(int id, ResultView before, ObjectRow first, ResultView after, ObjectRow second) {
        String text = words.get(R.string.compare_verdicts, mark(before, first), mark(after, second));
        if (!hasFigures(first) || !hasFigures(second)) {
            String figures = hasFigures(first) ? figures(R.string.compare_figures_before, before, first)
                    : hasFigures(second) ? figures(R.string.compare_figures_after, after, second) : null;
            return new Row(R.drawable.mark_not_judged, R.color.mark_neutral,
                    words.get(R.string.object_title, id, words.get(R.string.compare_impossible)), figures, text, null);
        }
        double was = before.worstStdMm(before.object(id));
        double is = after.worstStdMm(after.object(id));
        boolean same = !(Math.abs(was - is) > GUARD * Math.hypot(was * error(before), is * error(after)));
        int title = same ? R.string.compare_same : is < was ? R.string.compare_smaller_after
                : R.string.compare_smaller_before;
        int mark = same ? R.drawable.mark_not_judged : is < was ? R.drawable.ic_smaller : R.drawable.ic_larger;
        return new Row(mark, R.color.mark_neutral, words.get(R.string.object_title, id, words.get(title)),
                figures(R.string.compare_figures_before, before, first) + "\n"
                        + figures(R.string.compare_figures_after, after, second),
                words.get(R.string.compare_largest, words.mm(was), words.mm(is)) + "\n" + text, null);
    }

    private static boolean hasFigures(ObjectRow row) {
        return row != null && row.stdMm() != null;
    }

    /** Relative Monte Carlo error of deviations; 0 where a file does not say it. */
    private static double error(ResultView view) {
        double error = view.chains() == null ? 0 : view.chains().mcseStdRelMax();
        return error > 0 ? error : 0;
    }

    private String figures(int heading, ResultView view, ObjectRow row) {
        ObjectRows rows = rows(view);
        String text = words.get(heading) + "\n" + rows.deviations(R.string.figures, row.stdMm());
        return row.gripStdMm() == null ? text : text + "\n" + rows.deviations(R.string.figures_grip, row.gripStdMm());
    }

    private String mark(ResultView view, ObjectRow row) {
        return row == null ? words.get(R.string.compare_not_in_cell) : rows(view).mark(row);
    }
}
