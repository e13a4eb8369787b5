/** Markers found in an image or read from a detections file, as plain data, and the detector that finds them. */
@NullMarked
package org.cellgauge.vision;

import org.jspecify.annotations.NullMarked;
