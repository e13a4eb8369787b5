/** Grey values and the light that made them: tone curves. Mathematics alone. */
package org.cellgauge.light;
