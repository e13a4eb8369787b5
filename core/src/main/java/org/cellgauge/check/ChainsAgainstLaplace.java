package org.cellgauge.check;

import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.placement.Misfit;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.sampling.Quantity.Axis;
import org.cellgauge.statistics.ChainDiagnostics;
import org.cellgauge.warning.CheckWarning;
import org.cellgauge.warning.Warning;
import org.jspecify.annotations.Nullable;

/**
 * How far chains and Laplace's approximation are apart; immutable.
 *
 * <p>They are two ways to the same figures. Where the posterior is not Gaussian the chains correct the approximation,
 * by a fifth with two references placed to 20 mm; where they are apart by far, a model that is linear in placement
 * errors is used beyond where it holds, and neither is to be trusted silently. Compared are positions of the camera,
 * objects and gripping points, of poses without a second mode, and what Monte Carlo errors explain is taken off.
 */
final class ChainsAgainstLaplace {
    /** Factor between standard deviations, and distance of means in them, from which on it is said. */
    private static final double SAID_FACTOR = 1.5;
    private static final double SAID_SHIFT = 1;
    /** The same from which on no target counts as met. */
    private static final double WRONG_FACTOR = 2;
    private static final double WRONG_SHIFT = 2;
    /** Monte Carlo errors that chance explains. */
    private static final double CHANCE = 3;

    private double factor = 1;
    private double shift;
    /** How far beyond what is said already, as a share of it: which of all is told. */
    private double worst = Double.NEGATIVE_INFINITY;
    private @Nullable Quantity quantity;
    private double ratio = Double.NaN;
    private double off = Double.NaN;

    private ChainsAgainstLaplace() {
    }

    /** Where there is nothing to compare. */
    static ChainsAgainstLaplace none() {
        return new ChainsAgainstLaplace();
    }

    static ChainsAgainstLaplace of(CellEstimate chains, CellEstimate laplace, Diagnostics diagnostics) {
        ChainsAgainstLaplace all = new ChainsAgainstLaplace();
        if (!diagnostics.converged() || chains.cameraModes().size() > 1) {
            return all;
        }
        Axis[] axes = {Axis.X, Axis.Y, Axis.Z};
        for (int i = 0; i < axes.length; i++) {
            all.add(Quantity.camera(axes[i]), diagnostics, laplace.camera().mean()[i], laplace.camera().std()[i]);
        }
        for (ObjectEstimate object : chains.objects()) {
            ObjectEstimate other = laplace.object(object.id());
            for (int i = 0; i < axes.length && other != null && object.modes().size() < 2; i++) {
                all.add(Quantity.object(object.id(), axes[i]), diagnostics, other.pose().mean()[i],
                        other.pose().std()[i]);
                if (other.grip() != null) {
                    all.add(Quantity.grip(object.id(), axes[i]), diagnostics, other.grip().meanMm()[i],
                            other.grip().stdMm()[i]);
                }
            }
        }
        return all;
    }

    private void add(Quantity of, Diagnostics diagnostics, double mean, double std) {
        ChainDiagnostics d = diagnostics.of(of);
        double least = d.std() - CHANCE * d.mcseSd();
        double most = d.std() + CHANCE * d.mcseSd();
        double apart = Math.max(1, Math.max(least / std, std / most));
        double moved = Math.max(0, Math.abs(d.mean() - mean) - CHANCE * d.mcseMean()) / std;
        factor = Math.max(factor, apart);
        shift = Math.max(shift, moved);
        double by = Math.max(apart / SAID_FACTOR, moved / SAID_SHIFT);
        if (by > worst) {
            worst = by;
            quantity = of;
            ratio = d.std() / std;
            off = (d.mean() - mean) / std;
        }
    }

    /** What to tell the user; null where they agree. */
    @Nullable Warning warning() {
        return quantity == null || (factor < SAID_FACTOR && shift < SAID_SHIFT) ? null
                : Warning.of(CheckWarning.CHAINS_APART, quantity.name(), Decimal.of(ratio, 2), Decimal.of(off, 1));
    }

    /** What it adds to a reason; null where figures may be trusted. */
    @Nullable Misfit misfit() {
        return factor < WRONG_FACTOR && shift < WRONG_SHIFT ? null : Misfit.ofChains();
    }
}
