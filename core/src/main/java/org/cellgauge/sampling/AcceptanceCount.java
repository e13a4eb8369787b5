package org.cellgauge.sampling;

/**
 * How many suggestions of one proposal were accepted and rejected.
 *
 * @param proposal name of the proposal, unique within a chain
 * @param accepted suggestions accepted, not negative
 * @param rejected suggestions rejected, not negative
 */
public record AcceptanceCount(String proposal, long accepted, long rejected) {

    /**
     * Share of suggestions accepted.
     *
     * @return 0 to 1; NaN where there was none
     */
    public double rate() {
        return (double) accepted / (accepted + rejected);
    }

    /**
     * The sum with another count of the same proposal.
     *
     * @param other count of another chain
     * @return a new count
     */
    public AcceptanceCount plus(AcceptanceCount other) {
        return new AcceptanceCount(proposal, accepted + other.accepted, rejected + other.rejected);
    }
}
