/**
 * Cell files, calibration files and photos that the user chooses, the bundled example, and the results that are kept.
 *
 * <p>What the user chooses comes through Android's document picker, so that the app needs no permission for files. What
 * it keeps lies in its own storage and is shown to the user, and to nobody else unasked, by
 * {@link org.cellgauge.android.files.ResultProvider}.
 */
package org.cellgauge.android.files;
