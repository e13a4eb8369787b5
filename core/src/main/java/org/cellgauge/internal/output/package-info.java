/** Draws as Stan writes them. */
package org.cellgauge.internal.output;
