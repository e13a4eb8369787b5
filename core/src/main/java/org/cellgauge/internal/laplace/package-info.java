/** Laplace's approximation: camera and objects at their modes, covariances carried to the world, shares of variance. */
package org.cellgauge.internal.laplace;
