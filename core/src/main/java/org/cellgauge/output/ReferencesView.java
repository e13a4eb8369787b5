package org.cellgauge.output;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.Reference;
import org.cellgauge.estimate.PointEstimate;
import org.cellgauge.placement.Explanation;
import org.cellgauge.placement.Misfit;
import org.cellgauge.placement.MisplacedReference;
import org.cellgauge.placement.ReferenceCheck;
import org.cellgauge.placement.ReferenceFit;
import org.cellgauge.placement.WithoutMisplaced;
import org.jspecify.annotations.Nullable;

/** How the references of a cell fit together, and what hangs on those that do not; immutable. */
public final class ReferencesView extends Value {
    private final List<ReferenceFitView> fits;
    private final double chiSquare;
    private final int degreesOfFreedom;
    private final double pValue;
    private final @Nullable Boolean fitTogether;
    private final List<MisplacedView> misplaced;
    private final @Nullable WithoutView without;
    private final @Nullable Misfit misfit;
    private final List<CauseView> causes;
    private final String noticeable;

    ReferencesView(List<ReferenceFitView> fits, double chiSquare, int degreesOfFreedom, double pValue, @Nullable Boolean
            fitTogether, List<MisplacedView> misplaced, @Nullable WithoutView without, @Nullable Misfit misfit,
            List<CauseView> causes, String noticeable) {
        this.fits = Collections.unmodifiableList(new ArrayList<>(fits));
        this.chiSquare = Figures.finite(chiSquare);
        this.degreesOfFreedom = degreesOfFreedom;
        this.pValue = Figures.finite(pValue);
        this.fitTogether = fitTogether;
        this.misplaced = Collections.unmodifiableList(new ArrayList<>(misplaced));
        this.without = without;
        this.misfit = misfit;
        this.causes = Collections.unmodifiableList(new ArrayList<>(causes));
        this.noticeable = noticeable;
    }

    static ReferencesView of(Cell cell, ReferenceCheck check, @Nullable Misfit misfit) {
        List<ReferenceFitView> fits = new ArrayList<>();
        for (Reference reference : cell.references()) {
            fits.add(fit(reference.id(), check.fit(reference.id())));
        }
        List<MisplacedView> misplaced = new ArrayList<>();
        for (MisplacedReference reference : check.misplaced()) {
            misplaced.add(new MisplacedView(reference.id(), reference.offset(), reference.statistic(),
                    reference.limit(), reference.orInstead()));
        }
        List<CauseView> causes = new ArrayList<>();
        for (Explanation cause : check.causes()) {
            causes.add(CauseView.of(cause));
        }
        return new ReferencesView(fits, check.chiSquare(), check.degreesOfFreedom(), check.pValue(),
                check.degreesOfFreedom() > 0 ? check.fitTogether() : null, misplaced, without(check.without()),
                misfit, causes, check.noticeable());
    }

    private static ReferenceFitView fit(int id, @Nullable ReferenceFit fit) {
        return fit == null ? notUsed(id) : new ReferenceFitView(id, true, fit.misplaced(), fit.chiSquare(),
                fit.degreesOfFreedom(), fit.pValue(), fit.normalisedResidual(), fit.tested(), fit.statistic(),
                fit.limit(), fit.offset(), fit.offsetStd(), fit.detectable());
    }

    /** A reference that was not seen, or left out. */
    static ReferenceFitView notUsed(int id) {
        double[] none = none();
        return new ReferenceFitView(id, false, false, Double.NaN, 0, Double.NaN, Double.NaN, false, none, none, none,
                none, none);
    }

    /** The coordinates of a reference that is not tested. */
    static double[] none() {
        double[] none = new double[6];
        Arrays.fill(none, Double.NaN);
        return none;
    }

    private static @Nullable WithoutView without(@Nullable WithoutMisplaced without) {
        if (without == null) {
            return null;
        }
        List<MovedObject> objects = new ArrayList<>();
        for (WithoutMisplaced.ObjectWithout object : without.objects()) {
            PointEstimate grip = object.grip();
            double[] move = object.gripMoveMm();
            double[] error = object.gripErrorMm();
            objects.add(new MovedObject(object.id(), PoseView.of(object.pose()), object.moveMm(), object.errorMm(),
                    grip == null || move == null || error == null ? null
                            : new MovedGrip(grip.meanMm(), grip.covarianceMm2(), move, error)));
        }
        return new WithoutView(without.leftOut(), PoseView.of(without.camera()), without.cameraMoveMm(), objects);
    }

    private static @Nullable Object figures(@Nullable Misfit misfit) {
        return misfit == null ? null : Arrays.asList(misfit.kind(), misfit.markerId(), misfit.otherId(),
                misfit.times(), misfit.statedStdPx(), misfit.shownStdPx(), misfit.causeText());
    }

    /**
     * How each reference fits the others.
     *
     * @return all of the cell, in its order
     */
    public List<ReferenceFitView> fits() {
        return fits;
    }

    /**
     * Misfit of all together that do not seem misplaced, but for how square they are.
     *
     * @return chi-square distributed if the cell is as stated; NaN where that is not tested
     */
    public double chiSquare() {
        return chiSquare;
    }

    /**
     * Its degrees of freedom.
     *
     * @return 0 where that is not tested
     */
    public int degreesOfFreedom() {
        return degreesOfFreedom;
    }

    /**
     * Chance of a misfit as large as this if the cell is as stated.
     *
     * @return between 0 and 1; NaN where that is not tested
     */
    public double pValue() {
        return pValue;
    }

    /**
     * Whether they fit together as stated.
     *
     * @return null where that is not tested
     */
    public @Nullable Boolean fitTogether() {
        return fitTogether;
    }

    /**
     * References that stand farther off than their stated precision allows.
     *
     * @return the worst first; mostly none
     */
    public List<MisplacedView> misplaced() {
        return misplaced;
    }

    /**
     * Camera and objects without them.
     *
     * @return null where none seems misplaced, or the others lead to no pose
     */
    public @Nullable WithoutView without() {
        return without;
    }

    /**
     * What the photo contradicts of what all figures rest on, so that no target counts as met.
     *
     * @return mostly null
     */
    public @Nullable Misfit misfit() {
        return misfit;
    }

    /**
     * Causes that explain why references do not fit together.
     *
     * @return the likeliest first; mostly none
     */
    public List<CauseView> causes() {
        return causes;
    }

    /**
     * How far off a reference would have to be to be noticed, in English.
     *
     * @return a sentence or two; empty where that is not tested
     */
    public String noticeable() {
        return noticeable;
    }

    /**
     * How one reference fits the others.
     *
     * @param id marker id
     * @return its figures, or null where the cell has no such reference
     */
    public @Nullable ReferenceFitView fit(int id) {
        for (ReferenceFitView fit : fits) {
            if (fit.id() == id) {
                return fit;
            }
        }
        return null;
    }

    /**
     * References that the camera pose rests on.
     *
     * @return marker ids, in the order of the cell
     */
    public List<Integer> used() {
        List<Integer> used = new ArrayList<>();
        for (ReferenceFitView fit : fits) {
            if (fit.used()) {
                used.add(fit.id());
            }
        }
        return used;
    }

    @Override
    @Nullable Object[] figures() {
        return new @Nullable Object[] {fits, chiSquare, degreesOfFreedom, pValue, fitTogether, misplaced, without,
            figures(misfit), causes, noticeable};
    }
}
