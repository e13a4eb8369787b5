package org.cellgauge.cell;

import java.io.IOException;
import org.cellgauge.internal.cell.InputFiles;

/** Gives the text of the camera file that a cell names, where the cell does not come from the file system. */
@FunctionalInterface
public interface CameraSource {
    /**
     * The text of a camera file.
     *
     * @param name the name after {@code camera:} in the cell file, relative to the cell file
     * @return its text
     * @throws IOException if it cannot be read; {@link java.io.FileNotFoundException} where it does not exist
     * @throws InputRefusedException if it was judged already, as {@link InputFiles} does
     */
    String read(String name) throws IOException;
}
