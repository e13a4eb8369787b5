/** Warnings to the user as data, from which any language can make sentences; knows no other package. */
@NullMarked
package org.cellgauge.warning;

import org.jspecify.annotations.NullMarked;
