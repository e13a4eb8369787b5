package org.cellgauge.check;

import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.internal.pose.EdgeModel;
import org.cellgauge.sampling.Draws;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.sampling.QuantityLayout;

/** What a check says of the corners themselves: their noise, the shift of edges, markers set aside. Immutable. */
public final class NoiseEstimate {
    private static final double[] SHARES = {0.025, 0.5, 0.975};

    private final boolean stated;
    private final double usualStdPx;
    private final double addedMeanStdPx;
    private final double[] addedQuantilesStdPx;
    private final Map<Integer, Double> markerStdPx;
    private final Map<Integer, Double> setAside;
    private final double[] edgeShiftPx;

    private NoiseEstimate(boolean stated, double usualStdPx, double addedMeanStdPx, double[] addedQuantilesStdPx,
            Map<Integer, Double> markerStdPx, Map<Integer, Double> setAside, double[] edgeShiftPx) {
        this.stated = stated;
        this.usualStdPx = usualStdPx;
        this.addedMeanStdPx = addedMeanStdPx;
        this.addedQuantilesStdPx = addedQuantilesStdPx;
        this.markerStdPx = Collections.unmodifiableMap(markerStdPx);
        this.setAside = setAside;
        this.edgeShiftPx = edgeShiftPx;
    }

    /**
     * Reads it off the draws.
     *
     * @param errors errors of the corners
     * @param noiseLevel added noise by Laplace's method, where it is not sampled
     */
    public static NoiseEstimate of(CornerErrors errors, double noiseLevel, List<Draws> draws, QuantityLayout layout) {
        double level = noiseLevel;
        double mean = Double.NaN;
        double[] quantiles = null;
        if (errors.added() != null) {
            double[] values = all(draws, layout.indexOf(Quantity.ADDED_NOISE));
            double sum = 0;
            double squares = 0;
            for (double v : values) {
                sum += v;
                squares += v * v;
            }
            mean = sum / values.length;
            level = errors.added().ofVariance(squares / values.length);
            Arrays.sort(values);
            quantiles = new double[SHARES.length];
            for (int i = 0; i < SHARES.length; i++) {
                quantiles[i] = values[(int) Math.min(values.length - 1.0, SHARES[i] * values.length)];
            }
        }
        Map<Integer, Double> ofMarkers = new LinkedHashMap<>();
        for (int id : errors.ids()) {
            ofMarkers.put(id, Math.sqrt(errors.meanVariancePx2(id, level)));
        }
        double[] edges = null;
        EdgeModel model = errors.edges();
        if (model != null) {
            double[] values = all(draws, layout.indexOf(Quantity.EDGE_SHIFT));
            double sum = 0;
            for (double v : values) {
                sum += v;
            }
            double after = sum / values.length;
            double squares = 0;
            for (double v : values) {
                squares += (v - after) * (v - after);
            }
            double[] none = new double[errors.unknowns()];
            double[] one = none.clone();
            one[0] = 1;
            edges = new double[] {model.priorStd(0), model.value(0, none), model.value(0, one) - model.value(0, none),
                after, Math.sqrt(squares / values.length)};
        }
        return new NoiseEstimate(!Double.isNaN(errors.statedStdPx()), errors.usualStdPx(level), mean, quantiles,
                ofMarkers, errors.setAside(), edges);
    }

    private static double[] all(List<Draws> draws, int quantity) {
        int count = 0;
        for (Draws chain : draws) {
            count += chain.count();
        }
        double[] out = new double[count];
        int at = 0;
        for (Draws chain : draws) {
            for (int i = 0; i < chain.count(); i++) {
                out[at++] = chain.get(quantity, i);
            }
        }
        return out;
    }

    /**
     * Whether the cell file states the noise.
     *
     * @return true for a number
     */
    public boolean stated() {
        return stated;
    }

    /**
     * Root of the mean variance of a corner coordinate, of markers that are not set aside.
     *
     * @return px; as stated where the noise is stated
     */
    public double usualStdPx() {
        return usualStdPx;
    }

    /**
     * Mean of the noise on top of what the detector says of each corner.
     *
     * @return standard deviation, px; NaN where it is not sampled
     */
    public double addedMeanStdPx() {
        return addedMeanStdPx;
    }

    /**
     * Quantiles of it: 2.5, 50 and 97.5 %.
     *
     * @return a copy, px; null where it is not sampled
     */
    public double[] addedQuantilesStdPx() {
        return addedQuantilesStdPx == null ? null : addedQuantilesStdPx.clone();
    }

    /**
     * Root of the mean variance of a coordinate of each marker, added noise and inflation included.
     *
     * @return by marker id, px; unmodifiable
     */
    public Map<Integer, Double> markerStdPx() {
        return markerStdPx;
    }

    /**
     * Markers whose corners fit no square.
     *
     * @return by marker id, how many times worse than the others'; unmodifiable, mostly empty
     */
    public Map<Integer, Double> setAside() {
        return setAside;
    }

    /**
     * The shift of the photo's edges into the dark, of which corners are corrected.
     *
     * @return a copy: deviation before anything is measured, mean and deviation by inner edges, mean and deviation by
     *     all of the photo, px; null where nothing speaks of a shift
     */
    public double[] edgeShiftPx() {
        return edgeShiftPx == null ? null : edgeShiftPx.clone();
    }
}
