package org.cellgauge.internal.calibration;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.cellgauge.geometry.Lens;

/**
 * What a choice among lenses and boards leaves open; immutable. A choice by the photos is no knowledge: another lens
 * that explains photos held out about as well puts the parameters elsewhere, and a covariance that is that of the
 * chosen one alone is too small.
 *
 * <p>Every lens and board tried has a weight by the photos held out, {@code exp(-d / 2 c)}, d its squared errors there
 * in units of the least (pseudo-Bayesian averaging: S. Geisser and W. F. Eddy, "A predictive approach to model
 * selection", 1979), and c by how much errors scatter more than the noise of single corners makes likely: the squared
 * ratio of odd to even photos where that is above 1 (K. P. Burnham and D. R. Anderson, "Model selection and multimodel
 * inference", 2nd ed. 2002, section 2.5). The covariance about the chosen parameters t is the second moment
 * {@code sum w (C + (t' - t) (t' - t)^T)} of all of them; what a leaner lens has not is zero in it. A
 * lens of more parameters than the chosen model has is weighed and not averaged: a camera file of that model has no
 * place for them.
 */
final class ModelAverage {
    /** Weight below which a lens changes no figure that is shown. */
    private static final double NEGLIGIBLE = 1e-3;

    /**
     * A lens and a board, tried.
     *
     * @param deviance sum of squared errors in photos held out, in units of the least mean square of all trials
     */
    record Trial(LensChoice lens, BoardShape board, double deviance) {
    }

    /** The richest lens that has any weight: its unknowns are those of the covariance. */
    final LensChoice choice;
    /** Of the lens's unknowns about the chosen values. */
    final double[] covariance;
    private final List<Trial> trials;
    private final double[] weights;

    /**
     * Averages.
     *
     * @param chosen the fit whose values count
     * @param covariance its own, of lens and board
     * @param tried what the choice was among, the chosen one included; empty where there was none; of other lens
     *     models, whose parameters mean something else, none is averaged in
     * @param crossRatio difference of odd and even photos over its stated deviation; NaN where unknown
     */
    ModelAverage(CalibrationFit chosen, double[] covariance, List<Trial> tried, double crossRatio) {
        trials = tried.stream().filter(t -> t.lens.lens() == chosen.choice.lens()).toList();
        double scatter = crossRatio > 1 ? crossRatio * crossRatio : 1;
        double least = trials.stream().mapToDouble(Trial::deviance).min().orElse(0);
        weights = trials.stream().mapToDouble(t -> Math.exp(-(t.deviance - least) / (2 * scatter))).toArray();
        double all = 0;
        for (double w : weights) {
            all += w;
        }
        List<CalibrationFit> fits = new ArrayList<>();
        List<Double> kept = new ArrayList<>();
        List<double[]> own = new ArrayList<>();
        LensChoice widest = chosen.choice;
        List<Integer> photos = IntStream.range(0, chosen.photos.size()).boxed().toList();
        for (int k = 0; k < weights.length; k++) {
            weights[k] /= all;
            Trial trial = trials.get(k);
            if (trial.lens == chosen.choice && trial.board == chosen.board) {
                fits.add(chosen);
                own.add(covariance);
                kept.add(weights[k]);
            } else if (weights[k] > NEGLIGIBLE && holds(chosen.choice.lens(), trial.lens.lens())) {
                CalibrationFit fit = chosen.ofPhotos(trial.lens, trial.board, photos);
                double[] ofFit = fit.covariance;
                if (ofFit != null) {
                    fits.add(fit);
                    own.add(ofFit);
                    kept.add(weights[k]);
                    widest = trial.lens.unknowns() > widest.unknowns() ? trial.lens : widest;
                }
            }
        }
        if (fits.isEmpty()) {
            fits.add(chosen);
            own.add(covariance);
            kept.add(1.0);
        }
        choice = widest;
        double sum = kept.stream().mapToDouble(w -> w).sum();
        int n = choice.unknowns();
        this.covariance = new double[n * n];
        for (int f = 0; f < fits.size(); f++) {
            add(kept.get(f) / sum, fits.get(f), own.get(f), chosen);
        }
    }

    private void add(double weight, CalibrationFit fit, double[] own, CalibrationFit chosen) {
        int n = choice.unknowns();
        for (int a = 0; a < n; a++) {
            int i = choice.parameter(a);
            int ofA = unknown(fit, i);
            for (int b = 0; b < n; b++) {
                int j = choice.parameter(b);
                int ofB = unknown(fit, j);
                double within = ofA < 0 || ofB < 0 ? 0 : own[ofA * fit.globals + ofB];
                covariance[a * n + b] += weight
                        * (within + (value(fit, i) - chosen.values[i]) * (value(fit, j) - chosen.values[j]));
            }
        }
    }

    /** Whether a lens has all parameters of another one, so that it can stand for it. */
    private static boolean holds(Lens lens, Lens other) {
        return lens.parameterNames().containsAll(other.parameterNames());
    }

    /** Where a fit's lens has a parameter of the chosen lens; -1 where it has none. */
    private int index(CalibrationFit fit, int parameter) {
        return fit.choice.lens() == choice.lens() ? parameter
                : fit.choice.lens().parameterNames().indexOf(choice.lens().parameterNames().get(parameter));
    }

    private int unknown(CalibrationFit fit, int parameter) {
        int index = index(fit, parameter);
        return index < 0 ? -1 : fit.choice.unknown(index);
    }

    private double value(CalibrationFit fit, int parameter) {
        int index = index(fit, parameter);
        return index < 0 ? 0 : fit.values[index];
    }

    /** Weight of a lens, whatever the board; NaN where none was tried. */
    double weight(LensChoice lens) {
        return trials.isEmpty() ? Double.NaN : IntStream.range(0, weights.length)
                .filter(k -> trials.get(k).lens == lens).mapToDouble(k -> weights[k]).sum();
    }
}
