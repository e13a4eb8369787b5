/** Matrices of estimates, and their ellipses in the image. */
package org.cellgauge.internal.estimate;
