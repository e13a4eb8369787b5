package org.cellgauge.internal.pose;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Objects;
import org.cellgauge.cell.Cell;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.EdgeShift;
import org.cellgauge.vision.MarkerObservation;
import org.cellgauge.vision.PhotoLight;
import org.jspecify.annotations.Nullable;

/**
 * How far the edges of a photo's markers lie from where they are: a shift e of the photo, px into the dark, and ink
 * that has spread by g mm on the markers of one size, so that a marker's edges are off by {@code e - g s}, s being its
 * scale in px per mm on average, and less where the paper is seen aslant. Gaussian, given what the inner edges of the
 * markers tell; immutable.
 *
 * <p>With a marker's measured shift {@code y = delta + e_y}, the corners' errors e_c having the covariance C, that of
 * e_y being v and q what they share, the corners are {@code seen = true + d delta + e_c}, d the derivative of corners
 * by a shift. So, given y and delta, {@code e_c} has the mean {@code q (y - delta) / v} and the covariance
 * {@code C - q q^T / v}: corrected by the means of delta, {@code (d - q / v)} times what is unknown of delta is left,
 * and d times how far outlines lie, all alike, from where inner edges say.
 * Of ink, d delta is the derivative of corners by a square that is larger on the paper, times g.
 */
public final class EdgeModel {
    /** What a measured shift may be off by beside its stated error: inner and outer edges are not quite alike, px. */
    public static final double DISCREPANCY_STD_PX = 0.004;
    /** Shift of a photo of whose light nothing is said but whose markers have measured shifts, px. */
    private static final double UNSAID_STD_PX = 0.2;

    private final List<Double> sizesMm;
    private final double[] priorStd;
    private final double[] mean;
    private final double[] factor;
    /** What inner edges are expected to say at each unknown: the outlines' own part of it is not theirs. */
    private final double[] ofInner;

    private EdgeModel(List<Double> sizesMm, double[] priorStd, double[] mean, double[] factor, double[] ofInner) {
        this.sizesMm = sizesMm;
        this.priorStd = priorStd;
        this.mean = mean;
        this.factor = factor;
        this.ofInner = ofInner;
    }

    /** The model of a photo; null where nothing speaks of a shift. */
    static @Nullable EdgeModel of(Cell cell, Detections detections, List<MarkerErrors.Source> markers) {
        boolean measured = false;
        for (MarkerErrors.Source m : markers) {
            measured |= m.observation.edgeShift() != null;
        }
        double std = detections.light() != null ? detections.light().edgeShiftStdPx() : measured ? UNSAID_STD_PX : 0;
        double outlineStd = detections.light() != null ? detections.light().outlineStdPx()
                : PhotoLight.usualOutlineStdPx(Double.NaN);
        if (!measured && !(std > 0)) {
            return null;
        }
        List<Double> sizes = new ArrayList<>();
        if (cell.prints().printGainStdMm() > 0) {
            for (MarkerErrors.Source m : markers) {
                if (!sizes.contains(m.sizeMm)) {
                    sizes.add(m.sizeMm);
                }
            }
        }
        int n = 1 + sizes.size();
        double[] prior = new double[n];
        // a photo's shift that is known to be none keeps its place, with next to no deviation
        prior[0] = Math.max(std, 1e-6);
        java.util.Arrays.fill(prior, 1, n, cell.prints().printGainStdMm());
        double[] information = new double[n * n];
        double[] right = new double[n];
        for (int i = 0; i < n; i++) {
            information[i * (n + 1)] = 1 / (prior[i] * prior[i]);
        }
        for (MarkerErrors.Source m : markers) {
            EdgeShift shift = m.observation.edgeShift();
            if (shift != null) {
                double[] row = row(sizes, m);
                for (int i = 0; i < n; i++) {
                    right[i] += row[i] * shift.shiftPx() / variance(shift);
                    for (int j = 0; j < n; j++) {
                        information[i * n + j] += row[i] * row[j] / variance(shift);
                    }
                }
            }
        }
        double[] covariance = Objects.requireNonNull(Cholesky.inverse(information, n), "every unknown has a prior");
        double[] mean = new double[n];
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                mean[i] += covariance[i * n + j] * right[j];
            }
        }
        double[] ofInner = covariance.clone();
        if (measured) {
            // what all markers share of that discrepancy does not average out
            covariance[0] += outlineStd * outlineStd;
        }
        Cholesky.factor(covariance, n);
        // it moves outlines, not inner edges: with S their covariance without it, L L^T that with it, inner edges are
        // expected at S (L L^T)^-1 L nu = S L^-T nu
        double[] row = new double[n];
        for (int i = 0; i < n; i++) {
            System.arraycopy(ofInner, i * n, row, 0, n);
            Cholesky.solveLower(covariance, n, row);
            System.arraycopy(row, 0, ofInner, i * n, n);
        }
        return new EdgeModel(Collections.unmodifiableList(sizes), prior, mean, covariance, ofInner);
    }

    /** Variance of a measured shift about the marker's own. */
    static double variance(EdgeShift shift) {
        return shift.variancePx2() + DISCREPANCY_STD_PX * DISCREPANCY_STD_PX;
    }

    private static double[] row(List<Double> sizes, MarkerErrors.Source m) {
        double[] row = new double[1 + sizes.size()];
        row[0] = 1;
        int size = sizes.indexOf(m.sizeMm);
        if (size >= 0) {
            row[1 + size] = -pxPerMm(m);
        }
        return row;
    }

    private static double pxPerMm(MarkerErrors.Source m) {
        MarkerObservation observation = m.observation;
        double[] c = observation.cornersPx();
        double around = 0;
        for (int i = 0; i < 4; i++) {
            int j = (i + 1) % 4;
            around += Math.hypot(c[2 * j] - c[2 * i], c[2 * j + 1] - c[2 * i + 1]);
        }
        return around / 4 / m.sizeMm;
    }

    /** Mean of the shift of one marker, px. */
    double mean(MarkerErrors.Source m) {
        double[] row = row(sizesMm, m);
        double sum = 0;
        for (int i = 0; i < row.length; i++) {
            sum += row[i] * mean[i];
        }
        return sum;
    }

    /** Change of the shift that one marker's inner edges show by each unit-normal unknown, px. */
    double[] ofInnerByUnknown(MarkerErrors.Source m) {
        int n = mean.length;
        double[] row = row(sizesMm, m);
        double[] out = new double[n];
        for (int j = 0; j < n; j++) {
            for (int i = 0; i < n; i++) {
                out[j] += row[i] * ofInner[i * n + j];
            }
        }
        return out;
    }

    /** How the mean shift and mean ink move the corners of the marker of {@link #rowsOfCorners}, 8 values, px. */
    double[] meanOfCorners(double[] rows) {
        int n = mean.length;
        double[] out = new double[8];
        for (int c = 0; c < 8; c++) {
            for (int i = 0; i < n; i++) {
                out[c] += rows[c * n + i] * mean[i];
            }
        }
        return out;
    }

    /** Change of each corner coordinate of that marker by each unit-normal unknown, 8 rows, px. */
    double[] cornersByUnknown(double[] rows) {
        int n = mean.length;
        double[] out = new double[8 * n];
        for (int c = 0; c < 8 * n; c += n) {
            for (int j = 0; j < n; j++) {
                for (int i = j; i < n; i++) {
                    out[c + j] += rows[c + i] * factor[i * n + j];
                }
            }
        }
        return out;
    }

    /**
     * Change of each corner coordinate of a marker by the photo's shift and by each ink, 8 rows: light moves all sides
     * of a marker by the same in the image, ink by the same on the paper: less where that is seen aslant.
     */
    double[] rowsOfCorners(MarkerErrors.Source m) {
        int n = mean.length;
        double[] corners = m.observation.cornersPx();
        double[] byShift = EdgeShift.ofCorners(corners);
        double[] byInk = EdgeShift.byInk(corners, m.sizeMm);
        int size = sizesMm.indexOf(m.sizeMm);
        double[] rows = new double[8 * n];
        for (int c = 0; c < 8; c++) {
            rows[c * n] = byShift[c];
            if (size >= 0) {
                rows[c * n + 1 + size] = byInk[c];
            }
        }
        return rows;
    }

    /**
     * Number of unknowns.
     *
     * @return 1 for the photo's shift and one per size of markers on which ink may have spread
     */
    public int unknowns() {
        return mean.length;
    }

    /**
     * Sizes of markers on which ink may have spread.
     *
     * @return unmodifiable, mm, in the order of the unknowns from the second on
     */
    public List<Double> sizesMm() {
        return sizesMm;
    }

    /**
     * Deviation before the inner edges were looked at.
     *
     * @param i 0 for the photo's shift, in px; then ink, in mm
     * @return standard deviation
     */
    public double priorStd(int i) {
        return priorStd[i];
    }

    /**
     * A value, from the unit-normal unknowns.
     *
     * @param i 0 for the photo's shift, px into the dark; then how far ink has spread, mm
     * @param unknowns values of which the first belong to this model
     * @return px or mm
     */
    public double value(int i, double[] unknowns) {
        double sum = mean[i];
        for (int j = 0; j <= i; j++) {
            sum += factor[i * mean.length + j] * unknowns[j];
        }
        return sum;
    }
}
