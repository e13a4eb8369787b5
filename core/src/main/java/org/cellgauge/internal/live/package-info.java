/** Threads of a live check. */
@NullMarked
package org.cellgauge.internal.live;

import org.jspecify.annotations.NullMarked;
