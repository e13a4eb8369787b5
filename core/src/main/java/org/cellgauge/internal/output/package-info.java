/** Draws as Stan writes them. */
@NullMarked
package org.cellgauge.internal.output;

import org.jspecify.annotations.NullMarked;
