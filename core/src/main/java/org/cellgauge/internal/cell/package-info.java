/** Files of cells and cameras: their checks and phrases, and the writing of them. */
package org.cellgauge.internal.cell;
