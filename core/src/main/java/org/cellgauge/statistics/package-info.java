/** Convergence of chains and ellipses of normal distributions, as results tell them. */
@NullMarked
package org.cellgauge.statistics;

import org.jspecify.annotations.NullMarked;
