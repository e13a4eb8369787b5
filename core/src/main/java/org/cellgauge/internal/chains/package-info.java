/** The chains of one photo: targets, samplers, the walk of camera and objects, its quantities and their convergence. */
@NullMarked
package org.cellgauge.internal.chains;

import org.jspecify.annotations.NullMarked;
