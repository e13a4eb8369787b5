package org.cellgauge.android.files;

import java.io.IOException;
import java.util.List;
import org.cellgauge.check.CheckResult;

/** Where results are kept. Methods write and block: they are not for the main thread. */
public interface ResultArchive {
    /**
     * Keeps a result: the photo as lossless grey PNG, from which the command line makes the same figures, the result
     * file, the overlay's picture and the cell file with the camera that was used. All of them or none.
     *
     * @param photo the frame or photo that was checked
     * @param result what came out
     * @param cellName what people know the cell file by
     * @return what was written
     * @throws StorageFullException if there is no room; nothing was written
     * @throws IOException if writing failed for another reason; nothing was written
     */
    SavedResult save(Photo photo, CheckResult result, String cellName) throws IOException;

    /**
     * What was kept so far.
     *
     * @return the newest first
     */
    List<SavedResult> saved();

    /**
     * What was kept so far, read again. One that cannot be read is among them, and says why.
     *
     * @return the newest first
     */
    List<KeptResult> kept();

    /**
     * The picture of a kept result.
     *
     * @param name of the result
     * @return PNG
     * @throws IOException if there is none
     */
    byte[] picture(String name) throws IOException;

    /**
     * Removes a kept result with all of its files.
     *
     * @param name of the result
     * @return whether there was one and it is gone
     */
    boolean delete(String name);
}
