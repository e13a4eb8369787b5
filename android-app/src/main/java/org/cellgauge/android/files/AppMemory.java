package org.cellgauge.android.files;

/** What the app remembers from one start to the next, whatever became of its process and its screens meanwhile. */
public interface AppMemory {
    /**
     * Documents that were in use last.
     *
     * @param cellUri of the cell file
     * @param calibrationUri of the calibration file chosen with it, or null
     */
    record Documents(String cellUri, String calibrationUri) {
    }

    /**
     * The cell that was chosen last, with its calibration.
     *
     * @return null where none was yet
     */
    Documents lastDocuments();

    /**
     * Remembers a cell in place of the one before.
     *
     * @param documents what is in use from now on
     */
    void keep(Documents documents);

    /**
     * Whether the pictures of the first start were shown.
     *
     * @return false before the first start
     */
    boolean guideShown();

    /** They are being shown. */
    void guideIsShown();
}
