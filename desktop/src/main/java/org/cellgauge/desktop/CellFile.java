package org.cellgauge.desktop;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.StatedCamera;
import org.cellgauge.internal.cell.CellPhrase;
import org.cellgauge.internal.cell.InputFiles;
import org.cellgauge.output.ResultRecord;

/**
 * A cell and the files it comes from.
 *
 * @param file the cell file as named by the user
 * @param cell what it holds
 * @param sha256 of its bytes
 * @param cameraName the camera file as the cell file names it; null where that holds the camera itself
 * @param cameraSha256 of its bytes; null where there is none
 */
public record CellFile(Path file, Cell cell, String sha256, String cameraName, String cameraSha256) {
    /**
     * Reads a cell file and the camera file that it names.
     *
     * @param file the cell file
     * @return cell and files
     * @throws InputRefusedException if one of the two is missing or faulty
     */
    public static CellFile read(Path file) {
        return of(file, CellReader.read(file), InputFiles.text(file, CellPhrase.CELL_FILE, CellReader.MAX_BYTES));
    }

    /**
     * A cell that was read already.
     *
     * @param file the cell file as named by the user; a camera file that it names lies beside it
     * @param cell what it holds
     * @param text its text
     * @return cell and files
     * @throws InputRefusedException if the camera file cannot be read
     */
    public static CellFile of(Path file, Cell cell, String text) {
        StatedCamera camera = CellReader.statedCamera(text, file.toString());
        boolean apart = camera.kind() == StatedCamera.Kind.FILE;
        return new CellFile(file, cell, Sha256.of(text.getBytes(StandardCharsets.UTF_8)),
                apart ? camera.fileName() : null, apart ? Sha256.of(file.resolveSibling(camera.fileName())) : null);
    }

    /** A record with these files in it. */
    ResultRecord in(ResultRecord record) {
        Path name = file.getFileName();
        return record.withCell(name == null ? file.toString() : name.toString(), sha256)
                .withCamera(cameraName, cameraSha256);
    }
}
