package org.cellgauge.output;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import org.cellgauge.check.NoiseEstimate;
import org.cellgauge.placement.NoiseFit;
import org.jspecify.annotations.Nullable;

/** What a result says of the corners themselves: their noise, and the shift of edges; immutable. */
public final class NoiseView extends Value {
    private final boolean stated;
    private final double usualStdPx;
    private final double addedStdPx;
    private final double @Nullable [] addedQuantilesStdPx;
    private final @Nullable Boolean holds;
    private final double chiSquare;
    private final int degreesOfFreedom;
    private final double pValue;
    private final double shownStdPx;
    private final List<MarkerNoise> markers;
    private final double @Nullable [] edgeShiftPx;

    NoiseView(boolean stated, double usualStdPx, double addedStdPx, double @Nullable [] addedQuantilesStdPx, @Nullable
            Boolean holds, double chiSquare, int degreesOfFreedom, double pValue, double shownStdPx, List<MarkerNoise>
            markers, double @Nullable [] edgeShiftPx) {
        this.stated = stated;
        this.usualStdPx = Figures.finite(usualStdPx);
        this.addedStdPx = Figures.finite(addedStdPx);
        this.addedQuantilesStdPx = addedQuantilesStdPx == null ? null : Figures.finite(addedQuantilesStdPx);
        this.holds = holds;
        this.chiSquare = Figures.finite(chiSquare);
        this.degreesOfFreedom = degreesOfFreedom;
        this.pValue = Figures.finite(pValue);
        this.shownStdPx = Figures.finite(shownStdPx);
        this.markers = Collections.unmodifiableList(new ArrayList<>(markers));
        this.edgeShiftPx = edgeShiftPx == null ? null : Figures.finite(edgeShiftPx);
    }

    static NoiseView of(NoiseEstimate noise, NoiseFit fit) {
        List<MarkerNoise> markers = new ArrayList<>();
        for (Map.Entry<Integer, Double> marker : noise.markerStdPx().entrySet()) {
            markers.add(new MarkerNoise(marker.getKey(), marker.getValue(), fit.times(marker.getKey()),
                    noise.setAside().getOrDefault(marker.getKey(), Double.NaN)));
        }
        return new NoiseView(noise.stated(), noise.usualStdPx(), noise.addedMeanStdPx(), noise.addedQuantilesStdPx(),
                fit.tested() ? fit.holds() : null, fit.chiSquare(), fit.degreesOfFreedom(), fit.pValue(),
                fit.shownStdPx(), markers, noise.edgeShiftPx());
    }

    /**
     * Whether the cell states the noise.
     *
     * @return false where it was learned from the photo
     */
    public boolean stated() {
        return stated;
    }

    /**
     * Standard deviation of a corner coordinate: as stated; where it is not, the root of the mean variance of corners,
     * added noise included.
     *
     * @return px
     */
    public double usualStdPx() {
        return usualStdPx;
    }

    /**
     * Mean of the noise on top of what the detector says of each corner.
     *
     * @return standard deviation, px; NaN where it is not sampled
     */
    public double addedStdPx() {
        return addedStdPx;
    }

    /**
     * Quantiles of it: 2.5, 50 and 97.5 %.
     *
     * @return px, a new array; null where it is not sampled
     */
    public double @Nullable [] addedQuantilesStdPx() {
        return addedQuantilesStdPx == null ? null : addedQuantilesStdPx.clone();
    }

    /**
     * Whether corners are as precise as stated, by how square markers are.
     *
     * @return null where that is not tested
     */
    public @Nullable Boolean holds() {
        return holds;
    }

    /**
     * How far markers are from square.
     *
     * @return chi-square distributed if the noise is as stated; NaN where that is not tested
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
     * Chance of a misfit as large as this if the noise is as stated.
     *
     * @return between 0 and 1; NaN where that is not tested
     */
    public double pValue() {
        return pValue;
    }

    /**
     * The noise by how square markers are.
     *
     * @return standard deviation, px; NaN where that is not tested
     */
    public double shownStdPx() {
        return shownStdPx;
    }

    /**
     * The markers of the cell that the photo shows.
     *
     * @return unmodifiable
     */
    public List<MarkerNoise> markers() {
        return markers;
    }

    /**
     * The shift of the photo's edges into the dark, of which corners are corrected.
     *
     * @return deviation before anything is measured, mean and deviation by inner edges, mean and deviation by all of
     *     the photo, px, a new array; null where nothing speaks of a shift
     */
    public double @Nullable [] edgeShiftPx() {
        return edgeShiftPx == null ? null : edgeShiftPx.clone();
    }

    @Override
    @Nullable Object[] figures() {
        return new @Nullable Object[] {stated, usualStdPx, addedStdPx, addedQuantilesStdPx, holds, chiSquare,
            degreesOfFreedom, pValue, shownStdPx, markers, edgeShiftPx};
    }
}
