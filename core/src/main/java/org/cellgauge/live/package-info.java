/** A check that goes on over the frames of a camera. */
package org.cellgauge.live;
