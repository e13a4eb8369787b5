package org.cellgauge.internal.validation;

import org.cellgauge.cell.ObjectMarker;

/** Where simulated cells come from. Implementations may be called by several threads at once. */
public interface CellSource {
    /**
     * One simulated cell.
     *
     * @param seed of the whole study
     * @param index which one, from 0 on; the same seed and index give the same cell, whichever others are made
     * @return the cell with its truth
     * @throws org.cellgauge.cell.InputRefusedException if no such cell can be made
     */
    SimulatedCell cell(long seed, int index);

    /**
     * What an object is called in the figures. Objects of one name are counted together.
     *
     * @param object an object of one of the cells
     * @return the name
     */
    String nameOf(ObjectMarker object);
}
