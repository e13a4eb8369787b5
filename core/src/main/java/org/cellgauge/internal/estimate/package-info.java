/** Matrices of estimates, and their ellipses in the image. */
@NullMarked
package org.cellgauge.internal.estimate;

import org.jspecify.annotations.NullMarked;
