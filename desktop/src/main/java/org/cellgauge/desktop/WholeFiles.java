package org.cellgauge.desktop;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Files that appear whole or not at all: written beside their place under another name, then moved. */
public final class WholeFiles {
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
                // not createTempFile: that hides the file from everyone but its owner, and the rights stay on moving
                Path temporary = place.resolveSibling("." + place.getFileName() + "." + ProcessHandle.current().pid()
                        + ".part");
                waiting.put(place, temporary);
                try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(temporary), 1 << 16)) {
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

    private static void move(Path from, Path to) throws IOException {
        try {
            Files.move(from, to, StandardCopyOption.ATOMIC_MOVE);
        } catch (AtomicMoveNotSupportedException e) {
            // some network drives cannot; within one folder the plain move is the next best
            Files.move(from, to, StandardCopyOption.REPLACE_EXISTING);
        }
    }
}
