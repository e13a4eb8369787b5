package org.cellgauge.internal.sampling;

import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.sampling.AcceptanceCount;

/**
 * A Metropolis-Hastings chain (Hastings 1970): one of its proposals, each as likely as the others, suggests a point
 * that is accepted with probability {@code min(1, p(to) q(from|to) / (p(from) q(to|from)))}.
 *
 * <p>The density of the current point is kept and never evaluated again. A step allocates nothing. Not thread-safe.
 */
public final class MetropolisChain {
    private final LogDensity density;
    private final Proposal[] proposals;
    private final long[] accepted;
    private final long[] rejected;
    private final RandomGenerator random;
    private double[] current;
    private double[] candidate;
    private double currentLogDensity;

    /**
     * A chain.
     *
     * @param density target
     * @param proposals at least one
     * @param start first point; copied
     * @param random source of randomness, the chain's own
     * @throws StartException if the density at the start is not finite: such a chain could never move
     */
    public MetropolisChain(LogDensity density, List<? extends Proposal> proposals, double[] start,
            RandomGenerator random) {
        this.density = density;
        this.proposals = proposals.toArray(new Proposal[0]);
        this.random = random;
        accepted = new long[this.proposals.length];
        rejected = new long[this.proposals.length];
        current = start.clone();
        candidate = start.clone();
        currentLogDensity = density.at(current);
        requireFinite();
    }

    private void requireFinite() {
        if (!Double.isFinite(currentLogDensity)) {
            throw new StartException(currentLogDensity);
        }
    }

    /**
     * Suggests one point and accepts or rejects it.
     *
     * @return whether it was accepted
     */
    public boolean step() {
        int which = proposals.length == 1 ? 0 : random.nextInt(proposals.length);
        double correction = proposals[which].propose(current, candidate, random);
        double candidateLogDensity = density.at(candidate);
        double logRatio = candidateLogDensity - currentLogDensity + correction;
        // a uniform number is drawn at every step, accepted outright or not: the stream does not depend on rounding
        if (Math.log(1 - random.nextDouble()) <= logRatio && candidateLogDensity > Double.NEGATIVE_INFINITY) {
            double[] swap = current;
            current = candidate;
            candidate = swap;
            currentLogDensity = candidateLogDensity;
            accepted[which]++;
            return true;
        }
        rejected[which]++;
        return false;
    }

    /**
     * Tells the chain that its density has changed under it, so that the one it keeps is stale. Where its point has no
     * density any more it goes on from another.
     *
     * @param start where it goes on from then; copied
     * @return false if there is no density there either: the chain must not be stepped until it has changed again
     */
    public boolean densityChanged(double[] start) {
        currentLogDensity = density.at(current);
        if (!Double.isFinite(currentLogDensity)) {
            System.arraycopy(start, 0, current, 0, current.length);
            currentLogDensity = density.at(current);
        }
        return Double.isFinite(currentLogDensity);
    }

    /**
     * The current point.
     *
     * @return shared: valid until the next step, not to be changed
     */
    public double[] current() {
        return current;
    }

    /**
     * Log density of the current point.
     *
     * @return finite
     */
    public double logDensity() {
        return currentLogDensity;
    }

    /**
     * What became of the suggestions of each proposal.
     *
     * @return one count per proposal, in their order; an immutable copy
     */
    public List<AcceptanceCount> acceptance() {
        AcceptanceCount[] counts = new AcceptanceCount[proposals.length];
        for (int i = 0; i < proposals.length; i++) {
            counts[i] = new AcceptanceCount(proposals[i].name(), accepted[i], rejected[i]);
        }
        return List.of(counts);
    }
}
