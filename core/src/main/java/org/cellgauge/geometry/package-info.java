/**
 * Rigid transforms, rotations and their angles, the camera model and its projection with derivatives.
 *
 * <p>Frames: world W; camera C (x right, y down, z forward); marker M (x right, y up, z out of the face, origin at the
 * centre). A transform {@code aFromB} maps coordinates of B to coordinates of A: {@code x_a = R x_b + t}. Lengths are
 * millimetres, angles radians, image coordinates pixels with pixel centres at +0.5 (pixel (i, j) covers [i, i+1)).
 * Rotation matrices are {@code double[9]}, row by row.
 */
@NullMarked
package org.cellgauge.geometry;

import org.jspecify.annotations.NullMarked;
