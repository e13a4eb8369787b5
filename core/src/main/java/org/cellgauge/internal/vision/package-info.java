/** What detection is made of and shared with the rendering of markers and the reading of images. */
package org.cellgauge.internal.vision;
