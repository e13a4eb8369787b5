/**
 * Log densities over plain arrays: likelihoods of a camera pose, priors, and the charts that turn an array into a pose.
 *
 * <p>A density is the sum of three ideas that do not know each other: a
 * {@link CameraLikelihood} over poses, a {@link CameraChart} that says
 * which pose an array stands for and what volume it takes, and priors. Evaluating one allocates nothing.
 */
package org.cellgauge.internal.posterior;
