/** Pieces of sentences: numbers, lists and phrases inside messages. */
@NullMarked
package org.cellgauge.internal.warning;

import org.jspecify.annotations.NullMarked;
