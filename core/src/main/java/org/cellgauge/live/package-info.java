/** A check that goes on over the frames of a camera. */
@NullMarked
package org.cellgauge.live;

import org.jspecify.annotations.NullMarked;
