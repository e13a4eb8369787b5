package org.cellgauge.cli;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import org.cellgauge.cell.InputRefusedException;

/** The folder that results go to. */
final class CheckOutput {
    private final Path folder;

    private CheckOutput(Path folder) {
        this.folder = folder;
    }

    /** The folder cannot take results: a run has no use in going on. */
    static final class UnwritableException extends RuntimeException {
        private static final long serialVersionUID = 1L;

        UnwritableException(String message, Throwable cause) {
            super(message, cause);
        }
    }

    /**
     * Makes the folder where it is missing.
     *
     * @param folder where results are to go
     * @return the folder, ready to be written to
     * @throws UnwritableException if it cannot be made or written to; the message says what to do
     */
    static CheckOutput into(Path folder) {
        try {
            Files.createDirectories(folder);
        } catch (IOException e) {
            throw unwritable(folder, e);
        }
        if (!Files.isWritable(folder)) {
            throw unwritable(folder, new AccessDeniedException(folder.toString()));
        }
        return new CheckOutput(folder);
    }

    /**
     * Writes files that belong together, all or none; older ones of the same names are replaced.
     *
     * @param files content by file name
     * @throws UnwritableException if they cannot be written
     */
    void write(Map<String, byte[]> files) {
        Map<Path, byte[]> contents = new LinkedHashMap<>();
        files.forEach((name, bytes) -> contents.put(folder.resolve(name), bytes));
        try {
            WholeFiles.write(contents);
        } catch (IOException e) {
            throw unwritable(folder, e);
        }
    }

    /** Deletes a file of an earlier run; whether there was one. */
    boolean delete(String name) {
        try {
            return Files.deleteIfExists(folder.resolve(name));
        } catch (IOException e) {
            throw unwritable(folder, e);
        }
    }

    private static UnwritableException unwritable(Path folder, IOException e) {
        String why;
        if (e instanceof FileAlreadyExistsException) {
            why = "this is a file, not a folder; name a folder with --out";
        } else if (e instanceof AccessDeniedException) {
            why = "no permission to write here; name another folder with --out";
        } else if (e instanceof NoSuchFileException) {
            why = "the folder is gone; make it again or name another with --out";
        } else {
            String reason = e instanceof FileSystemException && ((FileSystemException) e).getReason() != null
                    ? ((FileSystemException) e).getReason() : e.getMessage();
            why = "results cannot be written (" + reason + "); free space or name another folder with --out";
        }
        // control characters of names stay out of terminals
        return new UnwritableException(new InputRefusedException(folder + ": " + why).getMessage(), e);
    }

    @Override
    public String toString() {
        return folder.toString();
    }
}
