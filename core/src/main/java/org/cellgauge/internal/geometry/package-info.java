/** Mathematics of poses and lenses: rotations, markers' corners, factorisations, one damped Gauss-Newton. */
@NullMarked
package org.cellgauge.internal.geometry;

import org.jspecify.annotations.NullMarked;
