package org.cellgauge.desktop;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.DirectoryStream;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Files that appear whole or not at all: written beside their place under another name, then moved. */
public final class WholeFiles {
    private static final String PREFIX = ".cellgauge-";
    private static final String SUFFIX = ".part";
    private static final Pattern UNFINISHED = Pattern.compile("\\.cellgauge-(\\d{1,18})-\\d+\\.part");
    private static final int MAX_NUMBER = 10_000;
    private static final int MIN_AGE_S = 60;

    private WholeFiles() {
    }

    /** What a file is to hold, written piece by piece: large files never stand in memory as a whole. */
    public interface Content {
        /**
         * Writes all of it.
         *
         * @param out receives the bytes; buffered, not closed by this
         * @throws IOException if {@code out} throws it
         */
        void writeTo(OutputStream out) throws IOException;
    }

    /**
     * Writes files that belong together. All are complete on the disk before the first takes its name, so an error
     * while writing (a full disk, say) leaves the old files untouched and nothing behind.
     *
     * @param contents contents by file, moved in this order; the folders must exist
     * @throws IOException if a file cannot be written
     */
    public static void writeContents(Map<Path, Content> contents) throws IOException {
        Map<Path, Path> waiting = new LinkedHashMap<>();
        try {
            for (Map.Entry<Path, Content> entry : contents.entrySet()) {
                Path place = entry.getKey();
                if (Files.isDirectory(place)) {
                    // a move would replace an empty folder without a word
                    throw new FileSystemException(place.toString(), null, "a folder of this name is in the way");
                }
                try (OutputStream out = new BufferedOutputStream(unfinished(place, waiting), 1 << 16)) {
                    entry.getValue().writeTo(out);
                }
            }
            List<Path> done = new ArrayList<>();
            for (Map.Entry<Path, Path> entry : waiting.entrySet()) {
                move(entry.getValue(), entry.getKey());
                done.add(entry.getKey());
            }
            done.forEach(waiting::remove);
        } finally {
            for (Path temporary : waiting.values()) {
                Files.deleteIfExists(temporary);
            }
        }
    }

    /**
     * A file that did not exist, beside the place of a file to be written. Not of createTempFile: that hides the file
     * from everyone but its owner, and the rights stay on moving. Its name does not grow with the other's, which may be
     * as long as names can be.
     */
    private static OutputStream unfinished(Path place, Map<Path, Path> waiting) throws IOException {
        for (int number = waiting.size(); ; number++) {
            Path temporary = place.resolveSibling(PREFIX + ProcessHandle.current().pid() + "-" + number + SUFFIX);
            try {
                // never into what is there already: somebody else's file, or a link to one
                OutputStream out = Files.newOutputStream(temporary, StandardOpenOption.CREATE_NEW,
                        StandardOpenOption.WRITE);
                waiting.put(place, temporary);
                return out;
            } catch (FileAlreadyExistsException e) {
                if (number > MAX_NUMBER) {
                    throw e;
                }
            }
        }
    }

    /**
     * Deletes what programs that were killed while they wrote left in a folder: unfinished files of processes that are
     * no more, a minute old, since other computers may write to the same folder.
     *
     * @param folder a folder that files were written to
     * @throws IOException if the folder cannot be read or a file not be deleted
     */
    public static void deleteUnfinished(Path folder) throws IOException {
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, PREFIX + "*" + SUFFIX)) {
            for (Path file : files) {
                Matcher name = UNFINISHED.matcher(file.getFileName().toString());
                boolean isOld = Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS) && Files.getLastModifiedTime(file)
                        .toInstant().isBefore(Instant.now().minusSeconds(MIN_AGE_S));
                if (name.matches() && isOld && ProcessHandle.of(Long.parseLong(name.group(1))).isEmpty()) {
                    Files.deleteIfExists(file);
                }
            }
        }
    }

    private static void move(Path from, Path to) throws IOException {
        try {
            Files.move(from, to, StandardCopyOption.ATOMIC_MOVE);
        } catch (AtomicMoveNotSupportedException e) {
            // some network drives cannot; within one folder the plain move is the next best
            Files.move(from, to, StandardCopyOption.REPLACE_EXISTING);
        }
    }
}
