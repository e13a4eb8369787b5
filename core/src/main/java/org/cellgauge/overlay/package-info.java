/**
 * What to draw over a photo, as shapes in image pixels without any toolkit.
 *
 * <p>{@link org.cellgauge.overlay.CellOverlay} turns a check, at whatever stage, into an
 * {@link org.cellgauge.overlay.Overlay}: shapes with a {@link org.cellgauge.overlay.Role} and a
 * {@link org.cellgauge.overlay.Status}. Every shape, texts included, can be had as strokes, so a painter only has to
 * map roles to colours and draw lines; no fonts are needed.
 */
package org.cellgauge.overlay;
