/** Settings in files. */
@NullMarked
package org.cellgauge.internal.settings;

import org.jspecify.annotations.NullMarked;
