package org.cellgauge.desktop;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;

/** The folder that results, or rendered photos, go to. */
public final class ResultFolder {
    /** How result files end. */
    static final String RESULT = ".result.json";
    /** How pictures of results end. */
    static final String OVERLAY = ".overlay.png";

    /** What systems say where it is the file's name, and not the folder, that is at fault. */
    private static final Pattern NO_PLACE = Pattern.compile("(?i)too long|in the way|is a directory");

    private final Path folder;

    private ResultFolder(Path folder) {
        this.folder = folder;
    }

    /** Where it is. */
    Path path() {
        return folder;
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
     * Takes the folder for a run, and makes it where it is missing: nobody else may take it until the hold is closed.
     * What killed runs left is deleted.
     *
     * @return closes
     * @throws UnwritableException if it cannot be made, or another run has it
     */
    Hold hold() {
        List<Path> made = new ArrayList<>();
        for (Path p = folder.toAbsolutePath().normalize(); p != null && !Files.exists(p); p = p.getParent()) {
            made.add(p);
        }
        try {
            Files.createDirectories(folder);
            FolderLock lock = FolderLock.of(folder);
            WholeFiles.deleteUnfinished(folder, Duration.ZERO);
            return new Hold(lock, made);
        } catch (FolderLock.HeldException e) {
            throw new UnwritableException(Refusal.at(Place.of(folder.toString()), FolderRefusal.OUT_IN_USE,
                    String.valueOf(e.getMessage())), e);
        } catch (IOException e) {
            throw unwritable(folder, e);
        }
    }

    /** A folder that one run has for itself. */
    static final class Hold implements AutoCloseable {
        private final FolderLock lock;
        private final List<Path> made;

        private Hold(FolderLock lock, List<Path> made) {
            this.lock = lock;
            this.made = made;
        }

        /** Gives it free; folders that were made for nothing are deleted. */
        @Override
        public void close() {
            try {
                lock.close();
                for (Path folder : made) {
                    Files.deleteIfExists(folder);
                }
            } catch (IOException e) {
                // there are results in it, or it is gone: both are right
            }
        }
    }

    /**
     * Writes files that belong together, all or none; older ones of the same names are replaced. The folder is made if
     * it is missing.
     *
     * @param files content by file name
     * @throws UnwritableException if the folder takes none
     * @throws InputRefusedException if these have no place in it: their names are too long, or folders have them
     */
    public void write(Map<String, WholeFiles.Content> files) {
        try {
            Files.createDirectories(folder);
        } catch (IOException e) {
            throw unwritable(folder, e);
        }
        writeHeld(files);
    }

    /** The same into a folder that is there: where it has been removed, nobody wants it back. */
    void writeHeld(Map<String, WholeFiles.Content> files) {
        Map<Path, WholeFiles.Content> contents = new LinkedHashMap<>();
        files.forEach((name, content) -> contents.put(folder.resolve(name), content));
        try {
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

    /** The file of a chain's draws, from 1. */
    static String chain(String name, int chain) {
        return name + ".chain-" + chain + ".csv";
    }

    /** Deletes chains of an earlier run with more of them than this one. */
    void deleteChainsFrom(String name, int chain) {
        int next = chain;
        while (delete(chain(name, next))) {
            next++;
        }
    }

    /** Deletes what an earlier run wrote under a name. */
    void deleteResults(String name) {
        delete(name + RESULT);
        delete(name + OVERLAY);
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

    /** What an error at writing into this folder means. */
    UnwritableException unwritable(IOException e) {
        return unwritable(folder, e);
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
