/** What a layout would reach, and which change of it reaches more: without a photo. */
@NullMarked
package org.cellgauge.plan;

import org.jspecify.annotations.NullMarked;
