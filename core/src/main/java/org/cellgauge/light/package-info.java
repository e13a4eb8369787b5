/** Grey values and the light that made them: tone curves. Mathematics alone. */
@NullMarked
package org.cellgauge.light;

import org.jspecify.annotations.NullMarked;
