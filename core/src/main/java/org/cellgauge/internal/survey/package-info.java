/** Many photos of one cell: their joint posterior, its mode by sparse normal equations, and draws of it. */
@NullMarked
package org.cellgauge.internal.survey;

import org.jspecify.annotations.NullMarked;
