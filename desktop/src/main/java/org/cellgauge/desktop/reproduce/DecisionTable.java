package org.cellgauge.desktop.reproduce;

import java.util.Arrays;
import org.cellgauge.settings.LikelihoodModel;

/** Figures of the corrected decision table, wherever they come from. */
final class DecisionTable {
    private final DecisionWork work;
    private final Section.Results results;

    DecisionTable(DecisionWork work, Section.Results results) {
        this.work = work;
        this.results = results;
    }

    /**
     * Deviations of the camera's part: root mean squares over the objects along x, y, z, mm.
     *
     * @param model the likelihood
     * @param layout placement must be one of the table's
     */
    double[] stdMm(LikelihoodModel model, Layout layout) {
        double[] stds = work.stdsMm();
        int column = Arrays.binarySearch(stds, layout.stdMm());
        if (column < 0) {
            throw new IllegalArgumentException(layout + " is not in the table");
        }
        if (model == LikelihoodModel.CORNER_CUBE && layout.stdMm() >= DecisionWork.SAMPLED_FROM_MM
                && layout.references() <= work.mostSampled()) {
            int first = (int) Arrays.stream(stds).filter(s -> s < DecisionWork.SAMPLED_FROM_MM).count();
            return triple(results.of(DecisionWork.sampledName(layout.sizeMm(), layout.arrangement()))
                    .all(Integer.toString(layout.references())), column - first);
        }
        return triple(results.of("decision-forecasts").all(DecisionWork.key(model, layout.sizeMm(),
                layout.pixelStdPx(), layout.arrangement(), layout.references())), column);
    }

    private static double[] triple(double[] all, int at) {
        return Arrays.copyOfRange(all, DecisionWork.AXES * at, DecisionWork.AXES * (at + 1));
    }

    /** What the object's own corner noise adds along x, y, z, mm. */
    double[] ownMm(Layout layout) {
        return results.of("decision-forecasts").all(DecisionWork.ownKey(layout.sizeMm(), layout.pixelStdPx()));
    }

    /** The worst axis. */
    static double worst(double[] stdMm) {
        return Math.max(lateral(stdMm), stdMm[2]);
    }

    /** The worse of x and y. */
    static double lateral(double[] stdMm) {
        return Math.max(stdMm[0], stdMm[1]);
    }

    /** Both parts together. */
    static double[] together(double[] a, double[] b) {
        double[] sum = new double[a.length];
        for (int i = 0; i < sum.length; i++) {
            sum[i] = Math.hypot(a[i], b[i]);
        }
        return sum;
    }
}
