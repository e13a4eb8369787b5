/**
 * Point estimates of poses: PnP, average and RANSAC starts, the mode by damped Gauss-Newton and its Fisher information.
 *
 * <p>All fits share one local coordinate system, the <em>centred chart</em>: points are given relative to a centre
 * (the centroid of the references, or the marker's own centre), {@code X_c = exp(w) R X + p + dp}, and a step is (dp in
 * mm, w in rad), both in the camera frame. Moves then rotate the camera about the scene and not about itself, which
 * keeps position and rotation nearly uncorrelated.
 */
package org.cellgauge.internal.pose;
