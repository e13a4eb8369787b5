/**
 * The job itself: from the detections of one photo to poses with their uncertainties and a verdict.
 *
 * <p>{@link org.cellgauge.check.CellCheck} takes a cell, detections and settings and publishes updates while it runs:
 * the quick look of Laplace's approximation first, running statistics of the chains then, the result last.
 */
@NullMarked
package org.cellgauge.check;

import org.jspecify.annotations.NullMarked;
