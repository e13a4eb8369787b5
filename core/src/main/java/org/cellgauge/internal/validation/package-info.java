/**
 * Is a stated 95 % right 95 times in 100? Cells simulated from their own stated uncertainties, each checked as a photo
 * would be, and what the checks stated counted against the truth.
 *
 * <p>{@link Validation} runs the simulations; {@link TruthPrior} says
 * where the true poses come from, and with it what a deviation from the nominal coverage means.
 */
package org.cellgauge.internal.validation;
