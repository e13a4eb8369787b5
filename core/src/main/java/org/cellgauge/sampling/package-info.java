/** Draws of chains and the quantities that they are draws of, as results tell them. */
@NullMarked
package org.cellgauge.sampling;

import org.jspecify.annotations.NullMarked;
