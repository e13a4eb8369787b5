package org.cellgauge.output;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.function.Function;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Target;
import org.cellgauge.check.CellEstimate;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.JudgedObject;
import org.cellgauge.check.JudgedPoint;
import org.cellgauge.check.TargetTest;
import org.cellgauge.check.Verdict;
import org.cellgauge.estimate.IntrinsicsEstimate;
import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.estimate.PointEstimate;
import org.cellgauge.estimate.VarianceSource;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.vision.PhotoLight;
import org.cellgauge.warning.Message;
import org.cellgauge.warning.Warning;
import org.jspecify.annotations.Nullable;

/**
 * All that a result says: a table of one row of the camera, then of each object of the cell and of its gripping point,
 * what is stated of all, and what it rests on; immutable. Tables, reports, files and pictures show it, whether it comes
 * from a check or from a file.
 *
 * <p>Two are equal where a result file would hold the same of them.
 */
public final class ResultView extends Value {
    /** One unknown parameter of the lens. */
    public static final class Intrinsic extends Value {
        private final String name;
        private final double mean;
        private final double std;
        private final double priorMean;
        private final double priorStd;
        private final boolean calibrated;

        Intrinsic(String name, double mean, double std, double priorMean, double priorStd, boolean calibrated) {
            this.name = name;
            this.mean = Figures.finite(mean);
            this.std = Figures.finite(std);
            this.priorMean = Figures.finite(priorMean);
            this.priorStd = Figures.finite(priorStd);
            this.calibrated = calibrated;
        }

        /**
         * Its value as known before the photo was seen.
         *
         * @return in its unit
         */
        public double priorMean() {
            return priorMean;
        }

        /**
         * How well it was known before.
         *
         * @return standard deviation in its unit; NaN where nothing was known
         */
        public double priorStd() {
            return priorStd;
        }

        /**
         * Whether what was known before is what a calibration leaves open.
         *
         * @return false where it was to be estimated
         */
        public boolean calibrated() {
            return calibrated;
        }

        /**
         * Whether the photo tells anything of it.
         *
         * @return false where its figures are what was known beforehand
         */
        public boolean learned() {
            return IntrinsicsEstimate.isLearned(std, priorStd);
        }

        /**
         * What its figures rest on, in words.
         *
         * @return {@code learned}, {@code not learned} or {@code as calibrated}
         */
        public String restsOn() {
            return learned() ? "learned" : calibrated ? "as calibrated" : "not learned";
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
        @Nullable Object[] figures() {
            return new @Nullable Object[] {name, mean, std};
        }
    }

    private @Nullable Verdict verdict;
    private boolean decided;
    private @Nullable String reason;
    private Target target = Target.NONE;
    private List<ResultRow> rows = Collections.emptyList();
    private List<Intrinsic> intrinsics = Collections.emptyList();
    private double[][] intrinsicsCovariance = {};
    private CellView cell;
    private @Nullable PhotoLight light;
    private @Nullable RunView run;
    private @Nullable NoiseView noise;
    private @Nullable ReferencesView references;
    private @Nullable ChainsView chains;
    private List<WarningView> warnings = Collections.emptyList();
    private @Nullable String action;
    private List<AdviceView> advice = Collections.emptyList();

    private ResultView(CellView cell) {
        this.cell = cell;
    }

    /** Puts a view together, and is of no more use afterwards. */
    static final class Builder {
        private final ResultView view;

        Builder(CellView cell) {
            view = new ResultView(cell);
        }

        private Builder(ResultView like) {
            this(like.cell);
            judged(like.verdict, like.decided, like.reason, like.target);
            rows(like.rows);
            intrinsics(like.intrinsics, like.intrinsicsCovariance);
            view.light = like.light;
            view.run = like.run;
            view.noise = like.noise;
            view.references = like.references;
            view.chains = like.chains;
            view.warnings = like.warnings;
            view.action = like.action;
            view.advice = like.advice;
        }

        Builder judged(@Nullable Verdict verdict, boolean decided, @Nullable String reason, Target target) {
            view.verdict = verdict;
            view.decided = decided;
            view.reason = reason;
            view.target = target;
            return this;
        }

        Builder rows(List<ResultRow> rows) {
            view.rows = Collections.unmodifiableList(new ArrayList<>(rows));
            return this;
        }

        /** @param covariance square, in the order of the parameters */
        Builder intrinsics(List<Intrinsic> intrinsics, double[][] covariance) {
            view.intrinsics = Collections.unmodifiableList(new ArrayList<>(intrinsics));
            view.intrinsicsCovariance = Figures.finite(covariance);
            return this;
        }

        Builder light(@Nullable PhotoLight light) {
            view.light = light;
            return this;
        }

        Builder run(RunView run) {
            view.run = run;
            return this;
        }

        Builder foundations(NoiseView noise, ReferencesView references) {
            view.noise = noise;
            view.references = references;
            return this;
        }

        Builder chains(ChainsView chains) {
            view.chains = chains;
            return this;
        }

        Builder warnings(List<WarningView> warnings) {
            view.warnings = Collections.unmodifiableList(new ArrayList<>(warnings));
            return this;
        }

        Builder action(@Nullable String action) {
            view.action = action;
            return this;
        }

        Builder advice(List<AdviceView> advice) {
            view.advice = Collections.unmodifiableList(new ArrayList<>(advice));
            return this;
        }

        ResultView build() {
            return view;
        }
    }

    /**
     * The view of a check.
     *
     * @param result what it found
     * @return the view
     */
    public static ResultView of(CheckResult result) {
        return of(result, Message::toString);
    }

    /**
     * The view of a check, warnings in the words of the program around this.
     *
     * @param result what it found
     * @param words what a warning says
     * @return the view
     */
    public static ResultView of(CheckResult result, Function<? super Message, String> words) {
        Cell cell = result.cell();
        CellEstimate estimate = result.estimate();
        CellEstimate quick = result.quickLook();
        List<ResultRow> rows = new ArrayList<>();
        rows.add(camera(estimate).laplace(LaplaceView.of(quick.camera().mean(), quick.camera().std(),
                estimate.camera().mean(), estimate.camera().std())).build());
        for (ObjectMarker marker : cell.objects()) {
            ObjectEstimate object = estimate.object(marker.id());
            if (object == null) {
                rows.add(notSeen(marker.id()));
                continue;
            }
            ObjectEstimate before = Objects.requireNonNull(quick.object(marker.id()), "seen by both");
            rows.add(object(object).laplace(LaplaceView.of(before.pose().mean(), before.pose().std(),
                    object.pose().mean(), object.pose().std())).build());
            PointEstimate grip = object.grip();
            if (grip != null) {
                PointEstimate gripBefore = Objects.requireNonNull(before.grip(), "an object has it or has not");
                rows.add(grip(object, grip).laplace(LaplaceView.of(gripBefore.meanMm(), gripBefore.stdMm(),
                        grip.meanMm(), grip.stdMm())).build());
            }
        }
        List<WarningView> warnings = new ArrayList<>();
        for (Warning warning : result.warnings()) {
            warnings.add(new WarningView(warning.kind().code(), words.apply(warning)));
        }
        return intrinsics(estimate.intrinsics(), new Builder(CellView.of(cell)))
                .judged(result.verdict(), result.decided(), result.reason(), cell.target())
                .rows(judged(rows, result.verdict(), result.targetTest()))
                .light(result.detections().light())
                .run(RunView.of(result))
                .foundations(NoiseView.of(result.noise(), result.noiseFit()),
                        ReferencesView.of(cell, result.referenceCheck(), result.targetTest().misfit()))
                .chains(ChainsView.of(result)).warnings(warnings)
                .action(result.action() == null ? null : words.apply(result.action())).build();
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
        rows.add(camera(estimate).build());
        for (ObjectMarker marker : cell.objects()) {
            ObjectEstimate object = estimate.object(marker.id());
            if (object == null) {
                rows.add(notSeen(marker.id()));
                continue;
            }
            rows.add(object(object).build());
            PointEstimate grip = object.grip();
            if (grip != null) {
                rows.add(grip(object, grip).build());
            }
        }
        return intrinsics(estimate.intrinsics(), new Builder(CellView.of(cell)))
                .judged(null, false, null, cell.target()).rows(rows).build();
    }

    private static ResultRow.Builder camera(CellEstimate estimate) {
        return new ResultRow.Builder(ResultRow.Kind.CAMERA, OptionalInt.empty()).pose(estimate.camera())
                .modeEstimates(estimate.cameraModes());
    }

    private static ResultRow notSeen(int id) {
        return new ResultRow.Builder(ResultRow.Kind.OBJECT, OptionalInt.of(id)).build();
    }

    private static ResultRow.Builder object(ObjectEstimate object) {
        return new ResultRow.Builder(ResultRow.Kind.OBJECT, OptionalInt.of(object.id())).pose(object.pose())
                .modeEstimates(object.modes()).budget(object.budget())
                .ellipse95Px(object.ellipse95Px());
    }

    private static ResultRow.Builder grip(ObjectEstimate object, PointEstimate grip) {
        return new ResultRow.Builder(ResultRow.Kind.GRIP, OptionalInt.of(object.id())).point(grip)
                .budget(Objects.requireNonNull(object.gripBudget()))
                .ellipse95Px(object.gripEllipse95Px());
    }

    private static Builder intrinsics(@Nullable IntrinsicsEstimate estimate, Builder builder) {
        if (estimate == null) {
            return builder;
        }
        List<Intrinsic> all = new ArrayList<>();
        double[] std = Figures.std(estimate.covariance());
        for (int i = 0; i < std.length; i++) {
            all.add(new Intrinsic(estimate.names().get(i), estimate.mean()[i], std[i], estimate.priorMean()[i],
                    estimate.priorStd()[i], i >= estimate.estimated()));
        }
        return builder.intrinsics(all, estimate.covariance());
    }

    // ---- the target

    /** Rows as a target judges them. */
    private static List<ResultRow> judged(List<ResultRow> rows, Verdict verdict, TargetTest target) {
        List<ResultRow> judged = new ArrayList<>();
        for (ResultRow row : rows) {
            JudgedObject object = row.kind() == ResultRow.Kind.CAMERA ? null : target.object(row.id().getAsInt());
            if (object == null) {
                judged.add(row);
                continue;
            }
            boolean position = row.kind() == ResultRow.Kind.OBJECT;
            Verdict own = target.of(object.id()).verdict();
            JudgedPoint point = position ? object.position() : Objects.requireNonNull(object.grip());
            judged.add(row.judged(isTrusted(verdict) ? target.verdict(object, point) : verdict,
                    position && isTrusted(verdict) && own != Verdict.NO_TARGET ? own == Verdict.PASS : null,
                    point.conformities()));
        }
        return judged;
    }

    /**
     * Whether another target can be held against these figures: one that asks for a probability needs the draws.
     *
     * @param other what is asked of the objects
     * @return false where it asks for a probability and is not the target of this result
     */
    public boolean canBeHeldAgainst(Target other) {
        return other.equals(target) || !other.asksForProbability();
    }

    /**
     * The same figures held against one standard deviation as the target.
     *
     * @param targetStdMm largest allowed standard deviation of any axis, mm, or empty for no target
     * @return as {@link #withTarget(Target)}
     */
    public ResultView withTarget(OptionalDouble targetStdMm) {
        return withTarget(Target.ofStdMm(targetStdMm));
    }

    /**
     * The same figures held against another target; nothing is sampled again.
     *
     * @param other what is asked of the objects
     * @return what a check with that target would have said of the same draws
     * @throws IllegalStateException if this is preliminary
     */
    public ResultView withTarget(Target other) {
        if (verdict == null || run == null || other.equals(target)) {
            if (verdict == null) {
                throw new IllegalStateException("nothing is judged yet");
            }
            return this;
        }
        if (!canBeHeldAgainst(other)) {
            throw new IllegalArgumentException("only draws tell how probable it is to be within " + other);
        }
        TargetTest test = targetTest(other);
        Builder judged = new Builder(this).run(run.withoutTarget()).advice(Collections.emptyList());
        if (isTrusted(verdict)) {
            judged.judged(test.verdict(), test.decided(), test.reason().english(), other)
                    .rows(judged(rows, test.verdict(), test));
        } else {
            // no target is held against figures that are not to be trusted
            judged.judged(verdict, false, reason, other).rows(withoutConformities(rows));
        }
        return judged.build();
    }

    /**
     * The same with changes of the set-up that would meet its target.
     *
     * @param other what {@link AdviceView#of} finds for it
     * @return another view
     */
    public ResultView withAdvice(List<AdviceView> other) {
        return new Builder(this).advice(other).build();
    }

    /**
     * Changes of the set-up that would meet a target which is missed.
     *
     * @return unmodifiable, cheapest first; empty where none were looked for or found
     */
    public List<AdviceView> advice() {
        return advice;
    }

    private static List<ResultRow> withoutConformities(List<ResultRow> rows) {
        List<ResultRow> others = new ArrayList<>();
        rows.forEach(row -> others.add(row.judged(row.verdict(), row.withinTarget(), Collections.emptyList())));
        return others;
    }

    /** The figures that a target is held against. */
    private TargetTest targetTest(Target other) {
        ReferencesView found = Objects.requireNonNull(references);
        List<JudgedObject> seen = new ArrayList<>();
        List<Integer> notSeen = new ArrayList<>();
        for (ResultRow row : objects()) {
            int id = row.id().getAsInt();
            ResultRow grip = grip(id);
            MovedObject moved = found.without() == null ? null : found.without().object(id);
            if (!row.seen()) {
                notSeen.add(id);
            } else {
                MovedGrip movedGrip = moved == null ? null : moved.grip();
                seen.add(new JudgedObject(id, point(row, moved == null ? null : moved.errorMm()), grip == null ? null
                        : point(grip, movedGrip == null ? null : movedGrip.errorMm())));
            }
        }
        List<Integer> misplaced = new ArrayList<>();
        found.misplaced().forEach(reference -> misplaced.add(reference.id()));
        return new TargetTest(seen, notSeen, misplaced, found.without() != null, found.misfit(), other);
    }

    private JudgedPoint point(ResultRow row, double @Nullable [] errorMm) {
        int id = row.id().getAsInt();
        double[] sampled = new double[3];
        double[] mcse = new double[3];
        Quantity.Axis[] axes = {Quantity.Axis.X, Quantity.Axis.Y, Quantity.Axis.Z};
        List<Map<VarianceSource, Double>> shares = new ArrayList<>();
        for (int i = 0; i < axes.length; i++) {
            Quantity quantity = row.kind() == ResultRow.Kind.GRIP ? Quantity.grip(id, axes[i])
                    : Quantity.object(id, axes[i]);
            QuantityView draws = Objects.requireNonNull(chains).quantity(quantity.name());
            sampled[i] = draws == null ? Double.NaN : draws.std();
            mcse[i] = draws == null ? Double.NaN : draws.mcseStd();
            Map<VarianceSource, Double> share = new LinkedHashMap<>();
            for (BudgetShare part : row.budget()) {
                share.put(part.source(), part.share(i));
            }
            shares.add(share);
        }
        return new JudgedPoint(Objects.requireNonNull(row.std()), sampled, mcse, errorMm, shares,
                Collections.emptyList());
    }

    private static boolean isTrusted(Verdict verdict) {
        return verdict.isTrusted();
    }

    /**
     * The verdict on the photo.
     *
     * @return null of what is preliminary
     */
    public @Nullable Verdict verdict() {
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
    public @Nullable String reason() {
        return reason;
    }

    /**
     * What is asked of the objects.
     *
     * @return the target; {@link Target#NONE} where none is set
     */
    public Target target() {
        return target;
    }

    /**
     * The target as one standard deviation.
     *
     * @return as {@link Target#oneStdMm()}
     */
    public OptionalDouble targetStdMm() {
        return target.oneStdMm();
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
    public @Nullable ResultRow object(int id) {
        return row(ResultRow.Kind.OBJECT, id);
    }

    /**
     * The row of an object's gripping point.
     *
     * @param id marker id
     * @return null where it has none, or was not seen
     */
    public @Nullable ResultRow grip(int id) {
        return row(ResultRow.Kind.GRIP, id);
    }

    private @Nullable ResultRow row(ResultRow.Kind kind, int id) {
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
    public @Nullable ResultRow worstObject() {
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
     * Covariance of the unknown parameters of the lens.
     *
     * @return square, in the order of {@link #intrinsics()}, a copy; of no rows where all were taken as known
     */
    public double[][] intrinsicsCovariance() {
        return Figures.finite(intrinsicsCovariance);
    }

    /**
     * The cell that was checked.
     *
     * @return all of it but for the target
     */
    public CellView cell() {
        return cell;
    }

    /**
     * What was found out about the photo's light.
     *
     * @return null where corners came without a photo, and of what is preliminary
     */
    public @Nullable PhotoLight light() {
        return light;
    }

    /**
     * How the result was sampled.
     *
     * @return null of what is preliminary
     */
    public @Nullable RunView run() {
        return run;
    }

    /**
     * What is said of the corners themselves.
     *
     * @return null of what is preliminary
     */
    public @Nullable NoiseView noise() {
        return noise;
    }

    /**
     * How the references fit together.
     *
     * @return null of what is preliminary
     */
    public @Nullable ReferencesView references() {
        return references;
    }

    /**
     * How the chains went.
     *
     * @return null of what is preliminary
     */
    public @Nullable ChainsView chains() {
        return chains;
    }

    /**
     * Warnings.
     *
     * @return unmodifiable
     */
    public List<WarningView> warnings() {
        return warnings;
    }

    /**
     * What to do first where something does not fit.
     *
     * @return one of the warnings; null where nothing is to be done about the references
     */
    public @Nullable String action() {
        return action;
    }

    private static @Nullable Object figures(@Nullable PhotoLight light) {
        return light == null ? null : Arrays.asList(light.toneCurve().words(), light.toneCurveEstimated(),
                light.blurPx(), light.noiseGrey(), light.noiseDegreesOfFreedom(), light.edgeShiftStdPx(),
                light.outlineStdPx());
    }

    @Override
    @Nullable Object[] figures() {
        return new @Nullable Object[] {verdict, decided, reason, target, rows, intrinsics, intrinsicsCovariance,
            cell, figures(light), run, noise, references, chains, warnings, action, advice};
    }
}
