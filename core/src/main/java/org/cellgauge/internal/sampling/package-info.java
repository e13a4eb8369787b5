/**
 * Metropolis sampling as a stream: proposals, chains, several chains at once and the running statistics they emit.
 *
 * <p>Vocabulary: a <em>density</em> says how probable a point is; a <em>proposal</em> suggests where to go next; a
 * <em>chain</em> accepts or rejects; a <em>process</em> is what one chain of a job advances (a camera and the objects
 * seen by it) and which <em>quantities</em> a draw of it has; an <em>ensemble</em> runs several processes in parallel,
 * round by round, and publishes a <em>snapshot</em> after each round. Proposals, densities and observers do not know
 * each other.
 */
@NullMarked
package org.cellgauge.internal.sampling;

import org.jspecify.annotations.NullMarked;
