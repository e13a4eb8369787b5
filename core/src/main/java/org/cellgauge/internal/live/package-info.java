/** Threads of a live check. */
package org.cellgauge.internal.live;
