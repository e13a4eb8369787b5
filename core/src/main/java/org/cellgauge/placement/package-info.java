/**
 * Tests of what is stated: whether references stand where they should, and corners are as precise as they should be.
 */
@NullMarked
package org.cellgauge.placement;

import org.jspecify.annotations.NullMarked;
