package org.cellgauge.output;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Objects;
import java.util.OptionalInt;
import java.util.function.Supplier;
import org.cellgauge.check.Conformity;
import org.cellgauge.check.Verdict;
import org.cellgauge.estimate.ModeEstimate;
import org.cellgauge.estimate.PointEstimate;
import org.cellgauge.estimate.PoseEstimate;
import org.cellgauge.estimate.VarianceBudget;
import org.cellgauge.internal.estimate.Once;
import org.cellgauge.statistics.Ellipse;
import org.jspecify.annotations.Nullable;

/**
 * One row of a {@link ResultView}: the camera, an object or its gripping point; immutable. Two are equal where a file
 * would hold the same of them.
 */
public final class ResultRow extends Value {
    /** What a row is about. */
    public enum Kind {
        /** The camera; the first row, and the only one of its kind. */
        CAMERA,
        /** An object of the cell, seen or not. */
        OBJECT,
        /** The gripping point of the object in the row before. */
        GRIP
    }

    private final Kind kind;
    private final OptionalInt id;
    private double @Nullable [] mean;
    private double @Nullable [][] covariance;
    private @Nullable PoseView pose;
    private List<ModeView> modes = Collections.emptyList();
    private Supplier<List<BudgetShare>> budget = Collections::emptyList;
    private @Nullable Ellipse ellipse95Px;
    private @Nullable Verdict verdict;
    private @Nullable Boolean withinTarget;
    private @Nullable LaplaceView laplace;
    private List<Conformity> conformities = Collections.emptyList();

    private ResultRow(Kind kind, OptionalInt id) {
        this.kind = kind;
        this.id = id;
    }

    /** Puts a row together, and is of no more use afterwards. */
    static final class Builder {
        private final ResultRow row;
        private @Nullable PoseEstimate ofRow;

        Builder(Kind kind, OptionalInt id) {
            row = new ResultRow(kind, id);
        }

        Builder pose(PoseView pose) {
            row.pose = pose;
            row.mean = pose.sharedMean();
            row.covariance = pose.sharedCovariance();
            return this;
        }

        Builder pose(PoseEstimate pose) {
            ofRow = pose;
            return pose(PoseView.of(pose));
        }

        Builder point(double[] meanMm, double[][] covarianceMm2) {
            row.mean = Figures.finite(meanMm);
            row.covariance = Figures.finite(covarianceMm2);
            return this;
        }

        Builder point(PointEstimate point) {
            return point(point.meanMm(), point.covarianceMm2());
        }

        Builder modeEstimates(List<ModeEstimate> modes) {
            List<ModeView> views = new ArrayList<>();
            if (modes.size() > 1) {
                modes.forEach(mode -> views.add(new ModeView(mode.weight(),
                        mode.pose() == ofRow ? Objects.requireNonNull(row.pose) : PoseView.of(mode.pose()))));
            }
            return modes(views);
        }

        Builder modes(List<ModeView> modes) {
            row.modes = Collections.unmodifiableList(modes);
            return this;
        }

        Builder budget(List<BudgetShare> budget) {
            List<BudgetShare> kept = Collections.unmodifiableList(budget);
            row.budget = () -> kept;
            return this;
        }

        /** The same worked out when it is asked for: a picture shows none. */
        Builder budget(VarianceBudget budget) {
            row.budget = new Once<>(() -> BudgetShare.of(budget));
            return this;
        }

        Builder ellipse95Px(@Nullable Ellipse ellipse) {
            row.ellipse95Px = ellipse;
            return this;
        }

        Builder verdict(@Nullable Verdict verdict) {
            row.verdict = verdict;
            return this;
        }

        Builder withinTarget(@Nullable Boolean within) {
            row.withinTarget = within;
            return this;
        }

        Builder laplace(LaplaceView laplace) {
            row.laplace = laplace;
            return this;
        }

        Builder conformities(List<Conformity> conformities) {
            row.conformities = Collections.unmodifiableList(new ArrayList<>(conformities));
            return this;
        }

        ResultRow build() {
            return row;
        }
    }

    /**
     * What it is about.
     *
     * @return never null
     */
    public Kind kind() {
        return kind;
    }

    /**
     * The object's marker.
     *
     * @return its id; empty for the camera
     */
    public OptionalInt id() {
        return id;
    }

    /**
     * Whether the photo showed it.
     *
     * @return false for an object that has no figures
     */
    public boolean seen() {
        return mean != null;
    }

    /**
     * The mean.
     *
     * @return x, y, z in mm and, of camera and objects, psi, theta, phi in rad; null where not seen
     */
    public double @Nullable [] mean() {
        return mean == null ? null : mean.clone();
    }

    /**
     * Standard deviations.
     *
     * @return in the order of {@link #mean()}; null where not seen
     */
    public double @Nullable [] std() {
        return covariance == null ? null : Figures.std(covariance);
    }

    /**
     * The covariance.
     *
     * @return in the order of {@link #mean()}, a copy; null where not seen
     */
    public double @Nullable [][] covariance() {
        return covariance == null ? null : Figures.finite(covariance);
    }

    /**
     * The largest deviation of the position along any axis.
     *
     * @return mm; NaN where not seen
     */
    public double largestStdMm() {
        if (covariance == null) {
            return Double.NaN;
        }
        double[] std = Figures.std(covariance);
        return Math.max(std[0], Math.max(std[1], std[2]));
    }

    /**
     * The whole pose.
     *
     * @return null of a gripping point, and where not seen
     */
    public @Nullable PoseView pose() {
        return pose;
    }

    /**
     * The poses that explain the photo, where there are two; heavier first.
     *
     * @return unmodifiable; empty where there is but one
     */
    public List<ModeView> modes() {
        return modes;
    }

    /**
     * Whether no single figure describes this pose.
     *
     * @return true if poses other than the first of {@link #modes()} hold more than
     *     {@link ModeEstimate#AMBIGUOUS_SHARE}
     */
    public boolean ambiguous() {
        return modes.size() > 1 && 1 - modes.get(0).weight() > ModeEstimate.AMBIGUOUS_SHARE;
    }

    /**
     * Where the variance comes from.
     *
     * @return unmodifiable; empty of the camera, and where not seen
     */
    public List<BudgetShare> budget() {
        return budget.get();
    }

    /**
     * The source of most of the variance, all axes together.
     *
     * @return the first of the largest; null where there is no budget
     */
    public @Nullable BudgetShare largestShare() {
        @Nullable BudgetShare largest = null;
        for (BudgetShare share : budget.get()) {
            largest = largest == null || share.share() > largest.share() ? share : largest;
        }
        return largest;
    }

    /**
     * The 95 % region in the image.
     *
     * @return in px; null of the camera, and where the mean is not in front of it
     */
    public @Nullable Ellipse ellipse95Px() {
        return ellipse95Px;
    }

    /**
     * How this row's deviations alone stand against the target, errors of misplaced references included; no allowance
     * is made for the Monte Carlo error.
     *
     * @return {@link Verdict#NOT_CONVERGED} and {@link Verdict#AMBIGUOUS} of a whole result hold for each row; null of
     *     the camera, where not seen, of what is preliminary, and where a file does not say it
     */
    public @Nullable Verdict verdict() {
        return verdict;
    }

    /**
     * Whether object and gripping point together are within the target, by more than the Monte Carlo error.
     *
     * @return null of other rows than objects, without a target, and where no figure is to be trusted
     */
    public @Nullable Boolean withinTarget() {
        return withinTarget;
    }

    /**
     * Laplace's approximation of it, and what the chains make of that.
     *
     * @return null where not seen, and of what is preliminary
     */
    public @Nullable LaplaceView laplace() {
        return laplace;
    }

    /**
     * How probable it is that its tolerances are kept.
     *
     * @return unmodifiable, one for each tolerance of the target, also where figures are not to be trusted; of an
     *     object's position the turn of the object is among them
     */
    public List<Conformity> conformities() {
        return conformities;
    }

    /** The same row as another target has it. */
    ResultRow judged(@Nullable Verdict other, @Nullable Boolean within, List<Conformity> kept) {
        ResultRow row = new ResultRow(kind, id);
        row.mean = mean;
        row.covariance = covariance;
        row.pose = pose;
        row.modes = modes;
        row.budget = budget;
        row.ellipse95Px = ellipse95Px;
        row.laplace = laplace;
        row.verdict = other;
        row.withinTarget = within;
        row.conformities = Collections.unmodifiableList(new ArrayList<>(kept));
        return row;
    }

    @Override
    @Nullable Object[] figures() {
        double @Nullable [] ellipse = ellipse95Px == null ? null : new double[] {ellipse95Px.centreX(),
            ellipse95Px.centreY(), ellipse95Px.semiMajor(), ellipse95Px.semiMinor(), ellipse95Px.angleRad()};
        return new @Nullable Object[] {kind, id, mean, covariance, pose, modes, budget.get(), ellipse, verdict,
            withinTarget, laplace, conformities};
    }


    @Override
    public String toString() {
        return kind + (id.isPresent() ? " " + id.getAsInt() : "") + " " + Arrays.toString(mean);
    }
}
