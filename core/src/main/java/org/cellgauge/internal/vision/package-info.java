/** What detection is made of and shared with the rendering of markers and the reading of images. */
@NullMarked
package org.cellgauge.internal.vision;

import org.jspecify.annotations.NullMarked;
