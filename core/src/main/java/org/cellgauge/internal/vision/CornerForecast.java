package org.cellgauge.internal.vision;

import java.util.Objects;
import org.apache.commons.math3.special.Erf;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.vision.EdgeShift;
import org.cellgauge.vision.MarkerObservation;

/**
 * How precisely a marker's corners would be found in a photo that is only thought of: what the fit of its sides would
 * state of itself; immutable.
 *
 * <p>Along a side the same blurred step is seen over and over, so its position and slope have the Fisher information of
 * one profile per px of length (Cramér, "Mathematical Methods of Statistics", 1946, section 32.3): grey is the tone
 * curve of a step of light blurred by optics and pixel, observed under white noise within the band that the fit looks
 * at, with blur and both levels unknown. Four lines then make four corners, by where they meet; the ends of a
 * side, which the fit leaves out ({@link SideBand}), have to be reached from the rest of it. Light that other edges
 * bring into the band is left out.
 */
public final class CornerForecast {
    /** Blur, noise and tone curve of a usual photo in focus: 0.7 px, 2 grey levels of 255, sRGB. */
    public static final CornerForecast USUAL = new CornerForecast(ToneCurve.SRGB, 0.7, 2);
    /** Deviation of the shift of a photo's edges where its tone curve has been estimated, px. */
    public static final double EDGE_SHIFT_STD_PX = 0.1;

    /** Light that paper and ink of a usual print throw back at the usual exposure, as a share of full scale. */
    private static final double PAPER = 0.85;
    private static final double INK = 0.05;
    private static final double STEP_PX = 0.02;
    private static final double DIFFERENCE = 1e-4;
    private static final int UNKNOWNS = 4;
    /**
     * Inner edges against the outline, by the patterns of square-binary and 36h11 in rendered photos: deviation of the
     * shift that they tell over that of the outline's mean offset, and the correlation of both.
     */
    private static final double SHIFT_BY_OUTLINE = 1.2;
    private static final double SHIFT_CORRELATION = 0.46;

    private final ToneCurve toneCurve;
    private final double blurPx;
    private final double noiseGrey;
    private final double offsetVariancePx3;
    private final double knownOffsetVariancePx3;

    /**
     * A kind of photo.
     *
     * @param toneCurve of the camera
     * @param blurPx standard deviation of the blur, px, positive
     * @param noiseGrey standard deviation of the noise, grey levels of 255, positive
     * @throws IllegalArgumentException if a value is not positive and finite
     */
    public CornerForecast(ToneCurve toneCurve, double blurPx, double noiseGrey) {
        if (!(blurPx > 0 && noiseGrey > 0 && Double.isFinite(blurPx + noiseGrey))) {
            throw new IllegalArgumentException("blur and noise must be positive, not " + blurPx + " and " + noiseGrey);
        }
        this.toneCurve = toneCurve;
        this.blurPx = blurPx;
        this.noiseGrey = noiseGrey;
        double[] information = information();
        double[] covariance = Objects.requireNonNull(Cholesky.inverse(information, UNKNOWNS), "a step has all four");
        offsetVariancePx3 = covariance[0];
        knownOffsetVariancePx3 = 1 / information[0];
    }

    /**
     * Blur of the photo.
     *
     * @return standard deviation, px
     */
    public double blurPx() {
        return blurPx;
    }

    /** Fisher information of offset, blur, dark and bright level in one profile across an edge, per px of length. */
    private double[] information() {
        double half = SideBand.halfWidthPx(blurPx);
        double[] at = {0, blurPx, INK, PAPER};
        double[] row = new double[UNKNOWNS];
        double[] sum = new double[UNKNOWNS * UNKNOWNS];
        int steps = (int) Math.ceil(2 * half / STEP_PX);
        for (int k = 0; k < steps; k++) {
            double x = -half + (k + 0.5) * 2 * half / steps;
            for (int i = 0; i < UNKNOWNS; i++) {
                double centre = at[i];
                at[i] = centre + DIFFERENCE;
                double more = grey(x, at);
                at[i] = centre - DIFFERENCE;
                row[i] = (more - grey(x, at)) / (2 * DIFFERENCE);
                at[i] = centre;
            }
            for (int i = 0; i < UNKNOWNS; i++) {
                for (int j = 0; j < UNKNOWNS; j++) {
                    sum[i * UNKNOWNS + j] += row[i] * row[j] * 2 * half / steps / (noiseGrey * noiseGrey);
                }
            }
        }
        return sum;
    }

    private double grey(double x, double[] p) {
        double std = Math.sqrt(p[1] * p[1] + SideBand.PIXEL_VARIANCE);
        return 255 * toneCurve.grey(p[2] + (p[3] - p[2]) * 0.5 * Erf.erfc((p[0] - x) / (std * Math.sqrt(2))));
    }

    /**
     * Standard deviation of the place of an edge.
     *
     * @param lengthPx length of the edge in the photo, px, positive
     * @return across it, px
     */
    public double edgeStdPx(double lengthPx) {
        return Math.sqrt(offsetVariancePx3 / (lengthPx - 2 * SideBand.cornerMarginPx(lengthPx, blurPx)));
    }

    /**
     * What a detector would say of a marker.
     *
     * @param id marker id
     * @param cornersPx where its corners would be, 8 values, px
     * @return these corners with covariance, and a shift of edges of 0 as its inner edges would tell it
     */
    public MarkerObservation of(int id, double[] cornersPx) {
        // the unknowns of the four lines: offset along the inward normal and change of it along the side
        double[] nx = new double[4];
        double[] ny = new double[4];
        double[] length = new double[4];
        double[] fitted = new double[4];
        double meanOffsetVariance = 0;
        for (int i = 0; i < 4; i++) {
            int j = (i + 1) % 4;
            double dx = cornersPx[2 * j] - cornersPx[2 * i];
            double dy = cornersPx[2 * j + 1] - cornersPx[2 * i + 1];
            length[i] = Math.hypot(dx, dy);
            nx[i] = -dy / length[i];
            ny[i] = dx / length[i];
            fitted[i] = length[i] - 2 * SideBand.cornerMarginPx(length[i], blurPx);
            meanOffsetVariance += offsetVariancePx3 / fitted[i] / 16;
        }
        double[] bySide = new double[8 * 4];
        double[] bySlope = new double[8 * 4];
        for (int i = 0; i < 4; i++) {
            int before = (i + 3) % 4;
            double determinant = nx[before] * ny[i] - nx[i] * ny[before];
            double[] byBefore = {ny[i] / determinant, -nx[i] / determinant};
            double[] byNext = {-ny[before] / determinant, nx[before] / determinant};
            for (int c = 0; c < 2; c++) {
                bySide[(2 * i + c) * 4 + before] = byBefore[c];
                bySide[(2 * i + c) * 4 + i] = byNext[c];
                bySlope[(2 * i + c) * 4 + before] = byBefore[c] * length[before] / 2;
                bySlope[(2 * i + c) * 4 + i] = -byNext[c] * length[i] / 2;
            }
        }
        double[] covariance = new double[64];
        for (int s = 0; s < 4; s++) {
            double offset = offsetVariancePx3 / fitted[s];
            double slope = 12 * knownOffsetVariancePx3 / (fitted[s] * fitted[s] * fitted[s]);
            for (int r = 0; r < 8; r++) {
                for (int c = 0; c < 8; c++) {
                    covariance[8 * r + c] += bySide[4 * r + s] * bySide[4 * c + s] * offset
                            + bySlope[4 * r + s] * bySlope[4 * c + s] * slope;
                }
            }
        }
        double variance = SHIFT_BY_OUTLINE * SHIFT_BY_OUTLINE * meanOffsetVariance;
        double[] shared = EdgeShift.ofCorners(cornersPx);
        for (int i = 0; i < 8; i++) {
            // errors of all four offsets share as much with the shift: that of their mean
            shared[i] *= SHIFT_CORRELATION * Math.sqrt(variance * meanOffsetVariance);
        }
        return new MarkerObservation(id, cornersPx, covariance, new EdgeShift(0, variance, shared));
    }

    @Override
    public String toString() {
        return "blur " + blurPx + " px, noise " + noiseGrey + " of 255, " + toneCurve.words();
    }
}
