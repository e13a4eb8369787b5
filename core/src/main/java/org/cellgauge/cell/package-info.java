/**
 * What stands in the cell and how well it is known: camera, markers, references with the precision of their placement,
 * objects with their gripping points, the target; and the reading and judging of the cell file.
 */
@NullMarked
package org.cellgauge.cell;

import org.jspecify.annotations.NullMarked;
