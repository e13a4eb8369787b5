/**
 * Estimates of poses, points and intrinsics, each with its covariance, the covariance's order and frame, and what its
 * variance comes from.
 */
@NullMarked
package org.cellgauge.estimate;

import org.jspecify.annotations.NullMarked;
