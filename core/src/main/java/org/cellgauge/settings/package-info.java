/**
 * Everything that determines the figures of a check besides its inputs, as data: what is modelled apart from how it is
 * sampled, and one table of all settings from which options, ranges, files, reports and the command that repeats a
 * result are made.
 */
@NullMarked
package org.cellgauge.settings;

import org.jspecify.annotations.NullMarked;
