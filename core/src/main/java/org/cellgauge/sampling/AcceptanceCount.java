package org.cellgauge.sampling;

/** How many suggestions of one proposal were accepted and rejected; immutable. */
public final class AcceptanceCount {
    private final String proposal;
    private final long accepted;
    private final long rejected;

    /**
     * A count.
     *
     * @param proposal name of the proposal
     * @param accepted suggestions accepted
     * @param rejected suggestions rejected
     */
    public AcceptanceCount(String proposal, long accepted, long rejected) {
        this.proposal = proposal;
        this.accepted = accepted;
        this.rejected = rejected;
    }

    /**
     * Name of the proposal.
     *
     * @return unique within a chain
     */
    public String proposal() {
        return proposal;
    }

    /**
     * Suggestions accepted.
     *
     * @return not negative
     */
    public long accepted() {
        return accepted;
    }

    /**
     * Suggestions rejected.
     *
     * @return not negative
     */
    public long rejected() {
        return rejected;
    }

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
