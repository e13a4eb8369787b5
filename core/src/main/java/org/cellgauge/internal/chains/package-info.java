/** The chains of one photo: targets, samplers, the walk of camera and objects, its quantities and their convergence. */
package org.cellgauge.internal.chains;
