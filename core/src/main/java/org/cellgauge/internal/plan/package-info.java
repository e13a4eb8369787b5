/** Fisher information of layouts marker by marker, and the search for layouts that have more of it. */
@NullMarked
package org.cellgauge.internal.plan;

import org.jspecify.annotations.NullMarked;
