package org.cellgauge.output;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.check.CellEstimate;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.Verdict;
import org.cellgauge.estimate.IntrinsicsEstimate;
import org.cellgauge.estimate.ObjectEstimate;
import org.jspecify.annotations.Nullable;

/**
 * A result as a table: one row of the camera, then of each object of the cell and of its gripping point, with what is
 * stated of all; immutable. Tables, reports, files and pictures show it, whether it comes from a check or from a file.
 *
 * <p>Two are equal where a result file would hold the same of them.
 */
public final class ResultView {
    /** One unknown parameter of the lens. */
    public static final class Intrinsic {
        private final String name;
        private final double mean;
        private final double std;

        Intrinsic(String name, double mean, double std) {
            this.name = name;
            this.mean = Figures.finite(mean);
            this.std = Figures.finite(std);
        }

        /**
         * Its name, unit included.
         *
         * @return such as {@code fx_px}
         */
        public String name() {
            return name;
        }

        /**
         * Its mean.
         *
         * @return in its unit
         */
        public double mean() {
            return mean;
        }

        /**
         * Its standard deviation.
         *
         * @return in its unit
         */
        public double std() {
            return std;
        }

        @Override
        public boolean equals(Object other) {
            return other instanceof Intrinsic && name.equals(((Intrinsic) other).name)
                    && Double.compare(mean, ((Intrinsic) other).mean) == 0
                    && Double.compare(std, ((Intrinsic) other).std) == 0;
        }

        @Override
        public int hashCode() {
            return Objects.hash(name, mean, std);
        }
    }

    private final Verdict verdict;
    private final boolean decided;
    private final String reason;
    private final OptionalDouble targetStdMm;
    private final List<ResultRow> rows;
    private final List<Intrinsic> intrinsics;
    private final ChainsView chains;
    private final List<String> warnings;
    private final @Nullable String action;

    ResultView(Verdict verdict, boolean decided, String reason, OptionalDouble targetStdMm, List<ResultRow> rows,
            List<Intrinsic> intrinsics, ChainsView chains, List<String> warnings, @Nullable String action) {
        this.action = action;
        this.verdict = verdict;
        this.decided = decided;
        this.reason = reason;
        this.targetStdMm = targetStdMm;
        this.rows = Collections.unmodifiableList(rows);
        this.intrinsics = Collections.unmodifiableList(intrinsics);
        this.chains = chains;
        this.warnings = Collections.unmodifiableList(warnings);
    }

    /**
     * The view of a check.
     *
     * @param result what it found
     * @return the view
     */
    public static ResultView of(CheckResult result) {
        Cell cell = result.cell();
        List<ResultRow> rows = new ArrayList<>();
        rows.add(camera(result.estimate()));
        for (ObjectMarker marker : cell.objects()) {
            ObjectEstimate object = result.estimate().object(marker.id());
            if (object == null) {
                rows.add(new ResultRow.Builder(ResultRow.Kind.OBJECT, OptionalInt.of(marker.id())).build());
                continue;
            }
            Boolean within = isTrusted(result.verdict()) && cell.targetStdMm().isPresent()
                    ? Boolean.valueOf(result.verdict(marker.id()) == Verdict.PASS) : null;
            rows.add(object(object).withinTarget(within)
                    .verdict(rowVerdict(result, result.referenceCheck().judgedMm(object))).build());
            if (object.grip() != null) {
                rows.add(grip(object).verdict(rowVerdict(result, result.referenceCheck().gripJudgedMm(object)))
                        .build());
            }
        }
        List<String> warnings = new ArrayList<>();
        result.warnings().forEach(warning -> warnings.add(warning.toString()));
        return new ResultView(result.verdict(), result.decided(), result.reason(), cell.targetStdMm(), rows,
                intrinsics(result.estimate().intrinsics()),
                ChainsView.of(result.diagnostics(), result.layout()), warnings,
                result.action() == null ? null : result.action().toString());
    }

    /**
     * The view of what no chain has confirmed yet: nothing in it is judged.
     *
     * @param cell the cell
     * @param estimate poses and their uncertainties
     * @return the view
     */
    public static ResultView preliminary(Cell cell, CellEstimate estimate) {
        List<ResultRow> rows = new ArrayList<>();
        rows.add(camera(estimate));
        for (ObjectMarker marker : cell.objects()) {
            ObjectEstimate object = estimate.object(marker.id());
            if (object == null) {
                rows.add(new ResultRow.Builder(ResultRow.Kind.OBJECT, OptionalInt.of(marker.id())).build());
                continue;
            }
            rows.add(object(object).build());
            if (object.grip() != null) {
                rows.add(grip(object).build());
            }
        }
        return new ResultView(null, false, null, cell.targetStdMm(), rows, intrinsics(estimate.intrinsics()), null,
                Collections.emptyList(), null);
    }

    private static ResultRow camera(CellEstimate estimate) {
        return new ResultRow.Builder(ResultRow.Kind.CAMERA, OptionalInt.empty()).pose(estimate.camera())
                .modeEstimates(estimate.cameraModes()).build();
    }

    private static ResultRow.Builder object(ObjectEstimate object) {
        return new ResultRow.Builder(ResultRow.Kind.OBJECT, OptionalInt.of(object.id())).pose(object.pose())
                .modeEstimates(object.modes()).budget(BudgetShare.of(object.budget()))
                .ellipse95Px(object.ellipse95Px());
    }

    private static ResultRow.Builder grip(ObjectEstimate object) {
        return new ResultRow.Builder(ResultRow.Kind.GRIP, OptionalInt.of(object.id())).point(object.grip())
                .budget(BudgetShare.of(object.gripBudget())).ellipse95Px(object.gripEllipse95Px());
    }

    private static List<Intrinsic> intrinsics(IntrinsicsEstimate estimate) {
        List<Intrinsic> all = new ArrayList<>();
        if (estimate != null) {
            double[] std = Figures.std(estimate.covariance());
            for (int i = 0; i < std.length; i++) {
                all.add(new Intrinsic(estimate.names().get(i), estimate.mean()[i], std[i]));
            }
        }
        return all;
    }

    /** What one deviation says of the target, where any figure can be trusted. */
    static Verdict rowVerdict(CheckResult result, double judgedMm) {
        OptionalDouble target = result.cell().targetStdMm();
        return !isTrusted(result.verdict()) ? result.verdict()
                : !target.isPresent() ? Verdict.NO_TARGET
                : judgedMm <= target.getAsDouble() && result.finding().misfit() == null ? Verdict.PASS : Verdict.FAIL;
    }

    private static boolean isTrusted(Verdict verdict) {
        return verdict.isTrusted();
    }

    /**
     * The verdict on the photo.
     *
     * @return null of what is preliminary
     */
    public Verdict verdict() {
        return verdict;
    }

    /**
     * Whether figures are to be trusted.
     *
     * @return false where the chains have not converged, two poses explain the photo, references contradict each
     *     other, or nothing is judged yet
     */
    public boolean trusted() {
        return verdict != null && isTrusted(verdict);
    }

    /**
     * Whether there are figures to show, though they may not be trusted.
     *
     * @return false where references contradict each other: then all figures are of another cell
     */
    public boolean showsFigures() {
        return verdict != Verdict.CONTRADICTED;
    }

    /**
     * Whether the verdict would be the same with any number of draws.
     *
     * @return as {@link CheckResult#decided()}
     */
    public boolean decided() {
        return decided;
    }

    /**
     * Why the verdict is what it is, in English.
     *
     * @return a sentence or two; null of what is preliminary
     */
    public String reason() {
        return reason;
    }

    /**
     * The target.
     *
     * @return largest standard deviation allowed, mm; empty where none is set
     */
    public OptionalDouble targetStdMm() {
        return targetStdMm;
    }

    /**
     * All rows: the camera first, then each object in the order of the cell, its gripping point after it.
     *
     * @return unmodifiable, never empty
     */
    public List<ResultRow> rows() {
        return rows;
    }

    /**
     * The row of the camera.
     *
     * @return never null
     */
    public ResultRow camera() {
        return rows.get(0);
    }

    /**
     * All rows but the camera's: objects and gripping points.
     *
     * @return unmodifiable
     */
    public List<ResultRow> points() {
        return rows.subList(1, rows.size());
    }

    /**
     * The rows of the objects of the cell, seen or not.
     *
     * @return a new list, in the order of the cell
     */
    public List<ResultRow> objects() {
        List<ResultRow> objects = new ArrayList<>();
        for (ResultRow row : rows) {
            if (row.kind() == ResultRow.Kind.OBJECT) {
                objects.add(row);
            }
        }
        return objects;
    }

    /**
     * The row of one object.
     *
     * @param id marker id
     * @return null where the cell has no such object
     */
    public ResultRow object(int id) {
        return row(ResultRow.Kind.OBJECT, id);
    }

    /**
     * The row of an object's gripping point.
     *
     * @param id marker id
     * @return null where it has none, or was not seen
     */
    public ResultRow grip(int id) {
        return row(ResultRow.Kind.GRIP, id);
    }

    private ResultRow row(ResultRow.Kind kind, int id) {
        for (ResultRow row : rows) {
            if (row.kind() == kind && row.id().getAsInt() == id) {
                return row;
            }
        }
        return null;
    }

    /**
     * The object whose position or gripping point has the largest deviation.
     *
     * @return its row; the first of the largest; null where no object was seen
     */
    public ResultRow worstObject() {
        ResultRow worst = null;
        for (ResultRow object : objects()) {
            if (object.seen() && (worst == null || worstStdMm(object) > worstStdMm(worst))) {
                worst = object;
            }
        }
        return worst;
    }

    /**
     * The largest deviation of an object and its gripping point along any axis.
     *
     * @param object one of {@link #objects()}
     * @return mm; NaN where it was not seen
     */
    public double worstStdMm(ResultRow object) {
        ResultRow grip = grip(object.id().getAsInt());
        return grip == null ? object.largestStdMm() : Math.max(object.largestStdMm(), grip.largestStdMm());
    }

    /**
     * Unknown parameters of the lens.
     *
     * @return unmodifiable; empty where all were taken as known
     */
    public List<Intrinsic> intrinsics() {
        return intrinsics;
    }

    /**
     * How the chains went.
     *
     * @return null of what is preliminary
     */
    public ChainsView chains() {
        return chains;
    }

    /**
     * Warnings, in English.
     *
     * @return unmodifiable
     */
    public List<String> warnings() {
        return warnings;
    }

    /**
     * What to do first where something does not fit, in English.
     *
     * @return one of the warnings; null where nothing is to be done about the references
     */
    public @Nullable String action() {
        return action;
    }

    private Object[] figures() {
        return new Object[] {verdict, decided, reason, targetStdMm, rows, intrinsics, chains, warnings, action};
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof ResultView && Arrays.deepEquals(figures(), ((ResultView) other).figures());
    }

    @Override
    public int hashCode() {
        return Arrays.deepHashCode(figures());
    }
}
