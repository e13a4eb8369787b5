/** The uncertainty of a layout of markers, from poses alone. */
@NullMarked
package org.cellgauge.laplace;

import org.jspecify.annotations.NullMarked;
