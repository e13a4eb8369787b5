package org.cellgauge.cli;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import org.cellgauge.cell.CameraReader;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.desktop.BatchRefusal;
import org.cellgauge.desktop.CellFile;
import org.cellgauge.internal.cell.CellPhrase;
import org.cellgauge.internal.cell.InputFiles;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;
import picocli.CommandLine;
import picocli.CommandLine.ParameterException;

/** The word {@code -}, which stands for standard input in place of a cell file, a photo or a detections file. */
final class StandardInput {
    private static final Path WORD = Path.of("-");
    /** Name of the file that a photo or detections are kept in while they are read, and so of their results. */
    private static final String NAME = "stdin";
    private static final String FOLDER = "cellgauge-stdin-";
    private static final int MAX_CELL_BYTES = 1 << 20;

    private StandardInput() {
    }

    /** Whether a file is standard input. */
    static boolean is(Path file) {
        return WORD.equals(file);
    }

    /**
     * Requires that standard input is asked for once at most.
     *
     * @param command for the message
     * @param files all that are to be read
     * @throws ParameterException if it stands twice
     */
    static void requireOnce(CommandLine command, List<Path> files) {
        if (files.stream().filter(StandardInput::is).count() > 1) {
            throw new ParameterException(command, "'-' is standard input, which can be read once only");
        }
    }

    /**
     * Reads a cell file, or a cell from standard input, whose camera file is named from the folder of the call.
     *
     * @param file the cell file, or {@code -}
     * @return the cell
     * @throws InputRefusedException if it is faulty
     */
    static Cell cell(Path file) {
        return is(file) ? cell(cellText()) : CellReader.read(file);
    }

    /**
     * The same with the files that it comes from.
     *
     * @param file the cell file, or {@code -}
     * @return cell and files
     * @throws InputRefusedException if it is faulty
     */
    static CellFile cellFile(Path file) {
        return is(file) ? CellFile.of(WORD, InputFiles.bytes(System.in, WORD.toString(), CellPhrase.CELL_FILE,
                MAX_CELL_BYTES)) : CellFile.read(file);
    }

    private static String cellText() {
        return InputFiles.text(System.in, WORD.toString(), CellPhrase.CELL_FILE, MAX_CELL_BYTES);
    }

    private static Cell cell(String text) {
        return CellReader.read(text, WORD.toString(), name -> {
            Path camera;
            try {
                camera = Path.of(name);
            } catch (InvalidPathException e) {
                throw (IOException) new FileNotFoundException(name).initCause(e);
            }
            if (!Files.exists(camera)) {
                throw new FileNotFoundException(name);
            }
            return InputFiles.text(camera, CellPhrase.CAMERA_FILE, CameraReader.MAX_BYTES);
        });
    }

    /**
     * Files in which standard input is one: it is kept in a file of its own until the process ends, since what is read
     * is read more than once.
     *
     * @param files files, or {@code -}
     * @param in standard input
     * @return the same, but for it
     * @throws InputRefusedException if it cannot be read or kept
     */
    static List<Path> kept(List<Path> files, InputStream in) {
        return files.stream().map(file -> is(file) ? keep(in) : file).toList();
    }

    private static Path keep(InputStream in) {
        try {
            Path folder = Files.createTempDirectory(FOLDER);
            folder.toFile().deleteOnExit();
            Path file = folder.resolve(NAME);
            // deleted before the folder: the last that was asked for goes first
            file.toFile().deleteOnExit();
            Files.copy(in, file);
            return file;
        } catch (IOException e) {
            throw new InputRefusedException(Refusal.at(Place.of(WORD.toString()), BatchRefusal.NOT_READABLE,
                    String.valueOf(e.getMessage())), e);
        }
    }

    /** What the user called a file: {@code -} for standard input and for what it is kept in. */
    static Path asGiven(Path file) {
        Path folder = file.getParent();
        boolean kept = folder != null && folder.getFileName() != null && file.endsWith(NAME)
                && folder.getFileName().toString().startsWith(FOLDER);
        return kept ? WORD : file;
    }
}
