/** Many photos of one cell: where references really stand, and objects with them. */
@NullMarked
package org.cellgauge.survey;

import org.jspecify.annotations.NullMarked;
