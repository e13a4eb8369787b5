"""Writes the draws and the reference values that ChainDiagnosticsTest compares with.

Run once, from this folder, and commit what it writes:

    python -m venv VENV && VENV/bin/pip install arviz==0.23.4 numpy==2.4.6 scipy==1.17.1
    VENV/bin/python make_reference.py

Written with Python 3.11.7 and exactly these versions. Files:

    draws-CASE.csv   one line per draw, one column per chain
    reference.csv    case,quantity,value

The values come from ArviZ. Where ArviZ and the R package posterior (1.6) differ, posterior is what the library follows,
and ArviZ's building blocks are put together accordingly:

  r_hat         posterior takes deviations from the median before it splits chains, arviz.rhat after; this matters for an
                odd number of draws only, and is asserted to agree for even ones. arviz.rhat refuses a single chain.
  ess_sd        posterior uses absolute deviations from the mean: arviz.ess(method="mean") of those.
  ess_squared   is what arviz.ess(method="sd") computes.
  truncation    of the autocorrelations of halves with an odd number of draws: ArviZ looks one pair of lags further
                before it gives up. The halves here are even, or their sequences end long before.
"""

import csv

import arviz as az
import numpy as np
from arviz.stats import diagnostics as blocks

QUANTILES = (0.025, 0.05, 0.25, 0.5, 0.9)


def ar1(rng, chains, draws, rho):
    x = np.empty((chains, draws))
    x[:, 0] = rng.standard_normal(chains)
    for t in range(1, draws):
        x[:, t] = rho * x[:, t - 1] + np.sqrt(1 - rho**2) * rng.standard_normal(chains)
    return x


def metropolis(rng, chains, draws, step):
    """Random walk on a standard normal density; a long step is refused often and repeats draws."""
    x = np.empty((chains, draws))
    now = rng.standard_normal(chains)
    for t in range(draws):
        proposed = now + step * rng.standard_normal(chains)
        accept = np.log(rng.random(chains)) < (now**2 - proposed**2) / 2
        now = np.where(accept, proposed, now)
        x[:, t] = now
    return x


def cases():
    rng = np.random.default_rng(20260711)
    yield "normal", rng.standard_normal((4, 1000))
    yield "autoregressive", ar1(rng, 4, 1000, 0.9)
    yield "antithetic", ar1(rng, 4, 1000, -0.7)
    yield "capped", ar1(rng, 4, 500, -0.97)
    yield "cauchy", rng.standard_cauchy((4, 1000))
    shifted = rng.standard_normal((4, 500))
    shifted[2] += 1.5
    yield "shifted", shifted
    scaled = rng.standard_normal((4, 500))
    scaled[1] *= 3
    yield "scaled", scaled
    yield "rounded", np.round(2 * ar1(rng, 4, 500, 0.5)) / 2
    yield "odd", ar1(rng, 3, 777, 0.5)
    yield "single", ar1(rng, 1, 1000, 0.3)
    yield "sticky", metropolis(rng, 4, 1000, 20.0)
    # Far from zero, in a unit where the draws hardly vary: 1090 mm with a deviation of 0.01 mm
    yield "offset", 1090 + 0.01 * ar1(rng, 4, 500, 0.6)
    trend = ar1(rng, 4, 500, 0.3) + np.linspace(0, 1, 500)
    yield "trend", trend


def reference(x):
    folded = np.abs(x - np.median(x))
    r_bulk = float(blocks._rhat(blocks._z_scale(blocks._split_chains(x))))
    r_folded = float(blocks._rhat(blocks._z_scale(blocks._split_chains(folded))))
    if x.shape[0] > 1:
        assert abs(az.rhat(x, method="z_scale") - r_bulk) < 1e-12
        if x.shape[1] % 2 == 0:
            assert abs(az.rhat(x, method="rank") - max(r_bulk, r_folded)) < 1e-12
    yield "mean", np.mean(x)
    yield "std", np.std(x, ddof=1)
    yield "r_hat_bulk", r_bulk
    yield "r_hat_folded", r_folded
    yield "r_hat", max(r_bulk, r_folded)
    yield "ess_bulk", az.ess(x, method="bulk")
    yield "ess_tail", az.ess(x, method="tail")
    yield "ess_mean", az.ess(x, method="mean")
    yield "ess_sd", az.ess(np.abs(x - x.mean()), method="mean")
    yield "ess_squared", az.ess(x, method="sd")
    yield "mcse_mean", az.mcse(x, method="mean")
    yield "mcse_sd", az.mcse(x, method="sd")
    for p in QUANTILES:
        yield f"quantile:{p}", np.quantile(x, p)
        # Ties: a quantile between two equal draws must be that draw, whatever the interpolation rounds to
        (arviz_quantile,) = blocks._quantile(x, p)
        assert np.array_equal(x <= arviz_quantile, x <= np.quantile(x, p)), p
        yield f"ess_quantile:{p}", az.ess(x, method="quantile", prob=p)
        yield f"mcse_quantile:{p}", az.mcse(x, method="quantile", prob=p)


def main():
    with open("reference.csv", "w", newline="") as out:
        values = csv.writer(out, lineterminator="\n")
        values.writerow(["case", "quantity", "value"])
        for name, x in cases():
            path = f"draws-{name}.csv"
            # Eight digits keep the variation of draws far from zero; five are plenty elsewhere
            np.savetxt(path, x.T, fmt="%.8g" if name == "offset" else "%.5g", delimiter=",")
            x = np.loadtxt(path, delimiter=",", ndmin=2).T
            for quantity, value in reference(x):
                assert np.isfinite(value), (name, quantity)
                values.writerow([name, quantity, repr(float(value))])


if __name__ == "__main__":
    main()
