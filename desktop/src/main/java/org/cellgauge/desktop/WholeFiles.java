package org.cellgauge.desktop;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.DirectoryStream;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.security.SecureRandom;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Files that appear whole or not at all: written beside their place under another name, then moved. */
public final class WholeFiles {
    private static final String PREFIX = ".cellgauge-";
    private static final String SUFFIX = ".part";
    private static final Pattern UNFINISHED = Pattern.compile("\\.cellgauge-(\\d{1,18})-[0-9a-f]+\\.part");
    private static final int RANDOM_BYTES = 8;
    private static final int MAX_TRIES = 100;
    private static final Duration OTHERS_MAY_WRITE = Duration.ofMinutes(1);

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
                FileChannel channel = unfinished(place, temporary -> waiting.put(place, temporary));
                try (OutputStream out = new BufferedOutputStream(Channels.newOutputStream(channel), 1 << 16)) {
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
     * Opens a file that did not exist, beside the place of a file to be written. Not of createTempFile: that hides the
     * file from everyone but its owner, and the rights stay on moving. Its name does not grow with the other's, which
     * may be as long as names can be, and nobody can foresee it.
     *
     * @param place of the file to be
     * @param name is told where it is as soon as it is there
     * @return the file, to be written and read
     * @throws IOException if it cannot be made
     */
    static FileChannel unfinished(Path place, Consumer<Path> name) throws IOException {
        byte[] random = new byte[RANDOM_BYTES];
        for (int tries = 1; ; tries++) {
            new SecureRandom().nextBytes(random);
            Path temporary = place.resolveSibling(PREFIX + ProcessHandle.current().pid() + "-"
                    + HexFormat.of().formatHex(random) + SUFFIX);
            try {
                // never into what is there already: somebody else's file, or a link to one
                FileChannel channel = FileChannel.open(temporary, StandardOpenOption.CREATE_NEW,
                        StandardOpenOption.READ, StandardOpenOption.WRITE);
                name.accept(temporary);
                return channel;
            } catch (FileAlreadyExistsException e) {
                if (tries == MAX_TRIES) {
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
        deleteUnfinished(folder, OTHERS_MAY_WRITE);
    }

    /** The same of files that are so old; of any where nobody else may write to the folder. */
    static void deleteUnfinished(Path folder, Duration age) throws IOException {
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, PREFIX + "*" + SUFFIX)) {
            for (Path file : files) {
                Matcher name = UNFINISHED.matcher(file.getFileName().toString());
                if (name.matches() && Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)
                        && !Files.getLastModifiedTime(file).toInstant().isAfter(Instant.now().minus(age))
                        && ProcessHandle.of(Long.parseLong(name.group(1))).isEmpty()) {
                    Files.deleteIfExists(file);
                }
            }
        }
    }

    /** Gives a file its name, in place of what has it. */
    static void move(Path from, Path to) throws IOException {
        try {
            Files.move(from, to, StandardCopyOption.ATOMIC_MOVE);
        } catch (AtomicMoveNotSupportedException e) {
            // some network drives cannot; within one folder the plain move is the next best
            Files.move(from, to, StandardCopyOption.REPLACE_EXISTING);
        }
    }
}
