/** Files of cells and cameras: their checks and phrases, and the writing of them. */
@NullMarked
package org.cellgauge.internal.cell;

import org.jspecify.annotations.NullMarked;
