/**
 * What is said to people as data, from which any language can make sentences: warnings, and refusals with the place of
 * the fault; knows no other package.
 */
@NullMarked
package org.cellgauge.warning;

import org.jspecify.annotations.NullMarked;
