/**
 * What to draw over a photo, as shapes in image pixels without any toolkit.
 *
 * <p>{@link CellOverlay} turns a check, at whatever stage, into an
 * {@link Overlay}: shapes with a {@link Role} and a
 * {@link Status}. Every shape, texts included, can be had as strokes, so a painter only has to
 * map roles to colours and draw lines; no fonts are needed.
 */
@NullMarked
package org.cellgauge.internal.overlay;

import org.jspecify.annotations.NullMarked;
