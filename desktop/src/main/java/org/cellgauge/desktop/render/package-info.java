/**
 * Photos of a cell whose truth is known: a scene of printed square markers in front of a textured wall, seen through a
 * lens with distortion and blur by a sensor with noise.
 *
 * <p>A {@link org.cellgauge.desktop.render.Scene} says what stands where,
 * a {@link org.cellgauge.desktop.render.Sensor} how the picture is taken;
 * {@link org.cellgauge.desktop.render.SceneRenderer} makes the {@link org.cellgauge.vision.GreyImage}, and
 * {@link org.cellgauge.desktop.render.SceneTruth} says where the corners really are. Frames, units and the pixel
 * convention are those of {@code org.cellgauge.geometry}.
 */
package org.cellgauge.desktop.render;
