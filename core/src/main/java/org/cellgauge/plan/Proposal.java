package org.cellgauge.plan;

import java.util.List;
import java.util.stream.Collectors;

/**
 * Changes made together, and what comes of them; immutable.
 *
 * @param changes one to three
 * @param layout the layout with them
 * @param forecast what a photo of it would tell
 */
public record Proposal(List<Change> changes, Layout layout, Forecast forecast) {
    /**
     * A proposal.
     *
     * @param changes copied
     * @param layout the layout with them
     * @param forecast what a photo of it would tell
     */
    public Proposal {
        changes = List.copyOf(changes);
    }

    /**
     * What the changes cost together.
     *
     * @return in minutes of work, or in whatever costs were stated
     */
    public double cost() {
        return changes.stream().mapToDouble(Change::cost).sum();
    }

    /**
     * The changes in words.
     *
     * @return in English, without a full stop
     */
    public String sentence() {
        return changes.stream().map(change -> change.words().toString()).collect(Collectors.joining("; "));
    }
}
