/** Laplace's approximation: camera and objects at their modes, covariances carried to the world, shares of variance. */
@NullMarked
package org.cellgauge.internal.laplace;

import org.jspecify.annotations.NullMarked;
