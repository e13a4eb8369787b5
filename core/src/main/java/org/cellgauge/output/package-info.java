/** All that a result says, as one view, and the result file that holds it, written and read back. */
@NullMarked
package org.cellgauge.output;

import org.jspecify.annotations.NullMarked;
