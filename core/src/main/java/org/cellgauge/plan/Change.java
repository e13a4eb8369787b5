package org.cellgauge.plan;

import org.cellgauge.cell.ChangeKind;
import org.cellgauge.warning.Warning;

/**
 * One change of a set-up; immutable.
 *
 * @param words what to do, as data: a {@link ChangeKind} with its figures
 * @param cost in minutes of work, or in whatever costs were stated
 */
public record Change(Warning words, double cost) {
    /**
     * What kind of change it is.
     *
     * @return the kind
     */
    public ChangeKind kind() {
        return (ChangeKind) words.kind();
    }
}
