package org.cellgauge.android.files;

/**
 * Where cell files, calibration files and photos come from. Methods read and block: they are not for the main thread.
 * All throw {@link org.cellgauge.cell.InputRefusedException} with file, place and remedy where something is wrong.
 */
public interface CellLibrary {
    /**
     * The bundled cell, to try the app at once.
     *
     * @return without a URI
     */
    CellDocument example();

    /**
     * The photo that belongs to the bundled cell.
     *
     * @return a photo
     */
    Photo examplePhoto();

    /**
     * Reads a cell file. A camera file that it refers to cannot be followed: {@link CellDocument#cameraFile()} then
     * says which one is to be chosen.
     *
     * @param uri of the document
     * @param calibrationUri of a calibration file chosen with it, or null; it goes before what the cell file states
     * @return what it says
     */
    CellDocument cell(String uri, String calibrationUri);

    /**
     * Reads a saved photo: whole, as stored (a note in the file which way up to show it is not followed, since a
     * calibration speaks of stored pixels), luminance only, with the same grey values as the command line reads.
     *
     * @param uri of the document
     * @return the photo
     */
    Photo photo(String uri);
}
