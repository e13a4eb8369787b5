package org.cellgauge.desktop;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import org.cellgauge.cell.CameraReader;
import org.cellgauge.cell.CameraSource;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.cell.InputRefusedException;
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
     * Reads a cell file and the camera file that it names, each once: what they hold and their checksums belong
     * together, even where a file changes meanwhile or is a pipe.
     *
     * @param file the cell file
     * @return cell and files
     * @throws InputRefusedException if one of the two is missing or faulty
     */
    public static CellFile read(Path file) {
        return of(file, InputFiles.bytes(file, CellPhrase.CELL_FILE, CellReader.MAX_BYTES));
    }

    /**
     * A cell file that was read already.
     *
     * @param file the cell file as named by the user; a camera file that it names lies beside it
     * @param bytes all of it
     * @return cell and files
     * @throws InputRefusedException if it is faulty, or the camera file missing or faulty
     */
    public static CellFile of(Path file, byte[] bytes) {
        String name = file.toString();
        CameraBeside camera = new CameraBeside(file);
        Cell cell = CellReader.read(InputFiles.text(bytes, name, CellPhrase.CELL_FILE, CellReader.MAX_BYTES), name,
                camera);
        return new CellFile(file, cell, Sha256.of(bytes), camera.name, camera.sha256);
    }

    /** The camera file beside a cell file, and what it was. */
    private static final class CameraBeside implements CameraSource {
        private final Path cellFile;
        private String name;
        private String sha256;

        CameraBeside(Path cellFile) {
            this.cellFile = cellFile;
        }

        @Override
        public String read(String fileName) throws IOException {
            Path path;
            try {
                path = cellFile.resolveSibling(fileName);
            } catch (InvalidPathException e) {
                throw new FileNotFoundException(fileName);
            }
            if (!Files.exists(path)) {
                throw new FileNotFoundException(path.toString());
            }
            byte[] bytes = InputFiles.bytes(path, CellPhrase.CAMERA_FILE, CameraReader.MAX_BYTES);
            name = fileName;
            sha256 = Sha256.of(bytes);
            return InputFiles.text(bytes, path.toString(), CellPhrase.CAMERA_FILE, CameraReader.MAX_BYTES);
        }
    }

    /** A record with these files in it. */
    ResultRecord in(ResultRecord record) {
        Path name = file.getFileName();
        return record.withCell(name == null ? file.toString() : name.toString(), sha256)
                .withCamera(cameraName, cameraSha256);
    }
}
