/** The uncertainty of a layout of markers, from poses alone. */
package org.cellgauge.laplace;
