/**
 * Mathematics alone: running means and covariances, directions, convergence diagnostics of Markov chains, coverage
 * regions, and the exact tests that say whether a claimed coverage is kept.
 *
 * <p>Nothing here knows cameras, markers or units: every class works on plain numbers and arrays, in whatever unit the
 * caller holds them. Angles are in radians. No class draws random numbers and none keeps static mutable state.
 *
 * <ul>
 *   <li>{@link org.cellgauge.statistics.RunningMoments}, {@link org.cellgauge.statistics.CircularMoments}: streams of
 *       draws in constant memory, mergeable over chains;
 *   <li>{@link org.cellgauge.statistics.Angles}: wrapping and differences of angles;
 *   <li>{@link org.cellgauge.statistics.ChainDiagnostics}, {@link org.cellgauge.statistics.Convergence}: R-hat,
 *       effective sample sizes, Monte Carlo standard errors, and the verdict they lead to;
 *   <li>{@link org.cellgauge.statistics.CoverageRegion}, {@link org.cellgauge.statistics.Ellipse}: regions of stated
 *       probability of normal distributions;
 *   <li>{@link org.cellgauge.statistics.BinomialBand}, {@link org.cellgauge.statistics.RankHistogram}: is a stated
 *       95 % right 95 times in 100?
 * </ul>
 */
@NullMarked
package org.cellgauge.statistics;

import org.jspecify.annotations.NullMarked;
