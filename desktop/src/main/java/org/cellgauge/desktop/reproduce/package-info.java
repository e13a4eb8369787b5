/**
 * The experiments of the thesis that the library began with, run again: as the thesis ran them, until they converge,
 * and as the library would have it, beside what was printed.
 *
 * <p>What is printed, what is assumed and which experiments there are is data ({@code printed.yaml},
 * {@code assumptions.yaml}, {@code setups.yaml} beside the classes). {@link org.cellgauge.desktop.reproduce.Work} is
 * what is computed and kept, {@link org.cellgauge.desktop.reproduce.Section} a part of the page that is written of it,
 * {@link org.cellgauge.desktop.reproduce.Reproduction} brings both together.
 */
package org.cellgauge.desktop.reproduce;
