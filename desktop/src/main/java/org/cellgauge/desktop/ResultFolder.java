package org.cellgauge.desktop;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Pattern;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;

/** The folder that results, or rendered photos, go to. */
public final class ResultFolder {
    /** What systems say where it is the file's name, and not the folder, that is at fault. */
    private static final Pattern NO_PLACE = Pattern.compile("(?i)too long|in the way|is a directory");

    private final Path folder;

    private ResultFolder(Path folder) {
        this.folder = folder;
    }

    /** The folder cannot take results: a run has no use in going on. */
    public static final class UnwritableException extends RuntimeException {
        private static final long serialVersionUID = 1L;

        private final transient Refusal refusal;

        UnwritableException(Refusal refusal, Throwable cause) {
            super(refusal.toString(), cause);
            this.refusal = refusal;
        }

        /**
         * Folder, what is wrong, remedy.
         *
         * @return the refusal
         */
        public Refusal refusal() {
            return refusal;
        }
    }

    /**
     * A folder for results, made when the first are written; that it can be is judged now, before hours of work.
     *
     * @param folder where results are to go
     * @return the folder
     * @throws UnwritableException if it cannot be made or written to; the message says what to do
     */
    public static ResultFolder into(Path folder) {
        Path existing = folder.toAbsolutePath().normalize();
        while (existing.getParent() != null && !Files.exists(existing)) {
            existing = existing.getParent();
        }
        if (!Files.isDirectory(existing)) {
            throw unwritable(existing, new FileAlreadyExistsException(existing.toString()));
        }
        if (!Files.isWritable(existing)) {
            throw unwritable(existing, new AccessDeniedException(existing.toString()));
        }
        if (Files.isDirectory(folder)) {
            try {
                WholeFiles.deleteUnfinished(folder);
            } catch (IOException e) {
                // what a killed run left is in nobody's way; whether this one can write is seen when it does
            }
        }
        return new ResultFolder(folder);
    }

    /**
     * Writes files that belong together, all or none; older ones of the same names are replaced.
     *
     * @param files content by file name
     * @throws UnwritableException if the folder takes none
     * @throws InputRefusedException if these have no place in it: their names are too long, or folders have them
     */
    public void write(Map<String, WholeFiles.Content> files) {
        Map<Path, WholeFiles.Content> contents = new LinkedHashMap<>();
        files.forEach((name, content) -> contents.put(folder.resolve(name), content));
        try {
            Files.createDirectories(folder);
            WholeFiles.writeContents(contents);
        } catch (FileSystemException e) {
            // a file that was to be moved to its place names that as the other one
            String at = e.getOtherFile() == null ? e.getFile() : e.getOtherFile();
            if (e.getReason() != null && at != null && NO_PLACE.matcher(e.getReason()).find()) {
                throw new InputRefusedException(Refusal.at(Place.of(at), FolderRefusal.RESULT_NOT_WRITTEN,
                        e.getReason()), e);
            }
            throw unwritable(folder, e);
        } catch (IOException e) {
            throw unwritable(folder, e);
        }
    }

    /**
     * A file in it.
     *
     * @param name its name
     * @return its path
     */
    public Path file(String name) {
        return folder.resolve(name);
    }

    /** Deletes chains of an earlier run with more of them than this one. */
    void deleteChainsFrom(String name, int chain) {
        int next = chain;
        while (delete(name + ".chain-" + next + ".csv")) {
            next++;
        }
    }

    /** Deletes what an earlier run wrote under a name. */
    void deleteResults(String name) {
        delete(name + ".result.json");
        delete(name + ".overlay.png");
        deleteChainsFrom(name, 1);
    }

    private boolean delete(String file) {
        Path path = folder.resolve(file);
        if (!Files.isRegularFile(path, LinkOption.NOFOLLOW_LINKS) && !Files.isSymbolicLink(path)) {
            // nothing of ours: a folder, say, or a name that cannot be
            return false;
        }
        try {
            return Files.deleteIfExists(path);
        } catch (IOException e) {
            throw unwritable(folder, e);
        }
    }

    private static UnwritableException unwritable(Path folder, IOException e) {
        Place place = Place.of(folder.toString());
        Refusal why;
        if (e instanceof FileAlreadyExistsException) {
            why = Refusal.at(place, FolderRefusal.OUT_IS_FILE);
        } else if (e instanceof AccessDeniedException) {
            why = Refusal.at(place, FolderRefusal.OUT_NOT_PERMITTED);
        } else if (e instanceof NoSuchFileException) {
            why = Refusal.at(place, FolderRefusal.OUT_NOT_MADE);
        } else {
            String reason = e instanceof FileSystemException && ((FileSystemException) e).getReason() != null
                    ? ((FileSystemException) e).getReason() : e.getMessage();
            why = Refusal.at(place, FolderRefusal.OUT_NOT_WRITTEN, String.valueOf(reason));
        }
        return new UnwritableException(why, e);
    }

    @Override
    public String toString() {
        return folder.toString();
    }
}
