/** How a camera is calibrated from photos of a target: bundle adjustment, and what its figures are held against. */
@NullMarked
package org.cellgauge.internal.calibration;

import org.jspecify.annotations.NullMarked;
