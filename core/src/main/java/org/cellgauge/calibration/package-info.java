/** Cameras calibrated from photos of a target, with how well every parameter is known. */
@NullMarked
package org.cellgauge.calibration;

import org.jspecify.annotations.NullMarked;
