/**
 * Mathematics alone: running means and covariances, directions, convergence diagnostics of Markov chains, coverage
 * regions, and the exact tests that say whether a claimed coverage is kept.
 *
 * <p>Nothing here knows cameras, markers or units: every class works on plain numbers and arrays, in whatever unit the
 * caller holds them. Angles are in radians. No class draws random numbers and none keeps static mutable state.
 *
 * <ul>
 *   <li>{@link RunningMoments}, {@link CircularMoments}: streams of
 *       draws in constant memory, mergeable over chains;
 *   <li>{@link Angles}: wrapping and differences of angles;
 *   <li>{@link ChainDiagnostics}, {@link Convergence}: R-hat,
 *       effective sample sizes, Monte Carlo standard errors, and the verdict they lead to;
 *   <li>{@link CoverageRegion}, {@link Ellipse}: regions of stated
 *       probability of normal distributions;
 *   <li>{@link BinomialBand}, {@link RankHistogram}: is a stated
 *       95 % right 95 times in 100?
 * </ul>
 */
@NullMarked
package org.cellgauge.internal.statistics;

import org.cellgauge.statistics.ChainDiagnostics;
import org.cellgauge.statistics.Convergence;
import org.cellgauge.statistics.Ellipse;
import org.jspecify.annotations.NullMarked;
