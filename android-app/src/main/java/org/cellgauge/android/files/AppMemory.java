package org.cellgauge.android.files;

import org.cellgauge.cell.Target;

/** What the app remembers from one start to the next, whatever became of its process and its screens meanwhile. */
public interface AppMemory {
    /**
     * What was in use last.
     *
     * @param cellUri of the cell file
     * @param calibrationUri of the calibration file chosen with it, or null
     * @param target that was chosen for this cell, or null for the cell file's own
     */
    record Choice(String cellUri, String calibrationUri, Target target) {
    }

    /**
     * The cell that was chosen last, with its calibration and target.
     *
     * @return null where none was yet
     */
    Choice lastChoice();

    /**
     * Remembers a cell in place of the one before.
     *
     * @param choice what is in use from now on
     */
    void keep(Choice choice);

    /**
     * Whether the pictures of the first start were shown.
     *
     * @return false before the first start
     */
    boolean guideShown();

    /** They are being shown. */
    void guideIsShown();
}
