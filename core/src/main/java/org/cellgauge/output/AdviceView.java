package org.cellgauge.output;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.cellgauge.cell.Cell;
import org.cellgauge.check.Verdict;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.plan.CellPlanner;
import org.cellgauge.plan.Change;
import org.cellgauge.plan.Forecast;
import org.cellgauge.plan.Layout;
import org.cellgauge.plan.PlanOptions;
import org.cellgauge.plan.Proposal;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.LikelihoodModel;
import org.cellgauge.vision.PhotoLight;
import org.cellgauge.warning.Message;
import org.jspecify.annotations.Nullable;

/** Changes of the set-up that would meet a target which a result misses, as forecast for what it shows; immutable. */
public final class AdviceView extends Value {
    private final List<String> codes;
    private final List<String> sentences;
    private final double cost;
    private final int objectId;
    private final boolean grip;
    private final int axis;
    private final double nowStdMm;
    private final double thenStdMm;
    private final double worstStdMm;

    AdviceView(List<String> codes, List<String> sentences, double cost, int objectId, boolean grip, int axis,
            double nowStdMm, double thenStdMm, double worstStdMm) {
        this.codes = Collections.unmodifiableList(new ArrayList<>(codes));
        this.sentences = Collections.unmodifiableList(new ArrayList<>(sentences));
        this.cost = Figures.finite(cost);
        this.objectId = objectId;
        this.grip = grip;
        this.axis = axis;
        this.nowStdMm = Figures.finite(nowStdMm);
        this.thenStdMm = Figures.finite(thenStdMm);
        this.worstStdMm = Figures.finite(worstStdMm);
    }

    /**
     * The cheapest changes that would meet the target, for camera and objects as a result has them.
     *
     * @param cell of the result
     * @param settings it was made with
     * @param view what it says
     * @param words of a change in the language of the reader
     * @return at most three, cheapest first; none where the target is met, where figures are not to be trusted or rest
     *     on what the photo contradicts, where objects are not seen, and where nothing that was tried meets it
     */
    public static List<AdviceView> of(Cell cell, CheckSettings settings, ResultView view,
            Function<? super Message, String> words) {
        Layout layout = missed(cell, settings, view);
        if (layout == null) {
            return Collections.emptyList();
        }
        PlanOptions options = options(cell, settings, view.light());
        Forecast now = CellPlanner.forecast(layout, options);
        List<AdviceView> found = new ArrayList<>();
        CellPlanner.advice(layout, options).forEach(proposal -> found.add(of(proposal, now, words)));
        return found;
    }

    /** What stands where, if it misses its target and changes of it are what could help; else null. */
    private static @Nullable Layout missed(Cell cell, CheckSettings settings, ResultView view) {
        PoseView camera = view.camera().pose();
        ReferencesView references = view.references();
        if (view.verdict() != Verdict.FAIL || camera == null || references == null || references.misfit() != null
                || !references.misplaced().isEmpty()
                || settings.model().likelihood() != LikelihoodModel.RIGID_MARKER) {
            return null;
        }
        Map<Integer, List<RigidTransform>> places = new LinkedHashMap<>();
        for (ResultRow row : view.objects()) {
            PoseView pose = row.pose();
            if (pose == null) {
                return null;
            }
            places.put(row.id().getAsInt(), List.of(pose.ofFigures()));
        }
        return places.isEmpty() ? null
                : new Layout(cell.withTarget(view.target()), List.of(camera.ofFigures()), places);
    }

    private static PlanOptions options(Cell cell, CheckSettings settings, @Nullable PhotoLight light) {
        PlanOptions usual = PlanOptions.of(cell, settings);
        return light == null || !(light.blurPx() > 0 && light.noiseGrey() > 0) ? usual
                : usual.withLight(light.toneCurve(), light.blurPx(), light.noiseGrey());
    }

    private static AdviceView of(Proposal proposal, Forecast now, Function<? super Message, String> words) {
        List<String> codes = new ArrayList<>();
        List<String> sentences = new ArrayList<>();
        for (Change change : proposal.changes()) {
            codes.add(change.kind().code());
            sentences.add(words.apply(change.words()));
        }
        Forecast.Row worst = now.rows().get(0);
        for (Forecast.Row row : now.rows()) {
            worst = row.ratio() > worst.ratio() ? row : worst;
        }
        int axis = 0;
        for (int i = 1; i < Forecast.AXES; i++) {
            axis = worst.axis(i) > worst.axis(axis) ? i : axis;
        }
        double then = Double.NaN;
        for (Forecast.Row row : proposal.forecast().rows()) {
            then = row.object() == worst.object() && row.grip() == worst.grip() ? row.axis(axis) : then;
        }
        return new AdviceView(codes, sentences, proposal.cost(), worst.object(), worst.grip(), axis, worst.axis(axis),
                then, proposal.forecast().worstStdMm());
    }

    /**
     * Codes of the changes.
     *
     * @return unmodifiable, as in {@link org.cellgauge.cell.ChangeKind#code()}
     */
    public List<String> codes() {
        return codes;
    }

    /**
     * The changes in words.
     *
     * @return unmodifiable, one for each, without a full stop
     */
    public List<String> sentences() {
        return sentences;
    }

    /**
     * What the changes cost together.
     *
     * @return in minutes of work, or in whatever costs the cell file states
     */
    public double cost() {
        return cost;
    }

    /**
     * The object whose point takes most of what is asked as it is.
     *
     * @return marker id
     */
    public int objectId() {
        return objectId;
    }

    /**
     * Whether that point is its gripping point.
     *
     * @return false for its position
     */
    public boolean grip() {
        return grip;
    }

    /**
     * The axis along which that point has the largest deviation.
     *
     * @return 0, 1 or 2 for x, y, z
     */
    public int axis() {
        return axis;
    }

    /**
     * That deviation as it is forecast for the set-up as it is.
     *
     * @return mm
     */
    public double nowStdMm() {
        return nowStdMm;
    }

    /**
     * The same deviation with the changes.
     *
     * @return mm
     */
    public double thenStdMm() {
        return thenStdMm;
    }

    /**
     * The largest deviation of any point along any axis with the changes.
     *
     * @return mm
     */
    public double worstStdMm() {
        return worstStdMm;
    }

    /**
     * The advice in a line.
     *
     * @return such as {@code raise reference 22 by 165 mm: z of object 5 2.41 -> 1.10 mm}
     */
    public String line() {
        return String.format(Decimal.POINT, "%s: %s of %sobject %d %.2f -> %.2f mm (cost %.0f)",
                String.join("; ", sentences), "xyz".charAt(axis), grip ? "the gripping point of " : "", objectId,
                nowStdMm, thenStdMm, cost);
    }

    @Override
    @Nullable Object[] figures() {
        return new @Nullable Object[] {codes, sentences, cost, objectId, grip, axis, nowStdMm, thenStdMm, worstStdMm};
    }
}
