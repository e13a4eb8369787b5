package org.cellgauge.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class WholeFilesTest {
    @TempDir
    private Path folder;

    private List<String> names() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(f -> f.getFileName().toString()).sorted().toList();
        }
    }

    @Test
    void filesHoldWhatWasGivenAndNothingElseIsLeft() throws IOException {
        Files.writeString(folder.resolve("a"), "old and longer");
        Map<Path, WholeFiles.Content> files = new LinkedHashMap<>();
        files.put(folder.resolve("a"), out -> out.write("new".getBytes()));
        files.put(folder.resolve("b"), out -> { });
        WholeFiles.writeContents(files);
        assertEquals("new", Files.readString(folder.resolve("a")));
        assertEquals(List.of("a", "b"), names());
    }

    /** Whoever knows the name of an unfinished file beforehand can lay a link there: it leads nowhere. */
    @Test
    void linksInTheWayOfUnfinishedFilesAreNotFollowed() throws IOException {
        Path precious = Files.writeString(folder.resolve("precious"), "kept");
        String name = ".cellgauge-" + ProcessHandle.current().pid() + "-0.part";
        Files.createSymbolicLink(folder.resolve(name), precious);
        WholeFiles.writeContents(Map.of(folder.resolve("a"), out -> out.write("new".getBytes())));
        assertEquals("kept", Files.readString(precious));
        assertEquals("new", Files.readString(folder.resolve("a")));
        assertEquals(List.of(name, "a", "precious"), names());
    }

    /** 255 bytes are what file systems allow. */
    @Test
    void namesMayBeAsLongAsTheFileSystemLetsThem() throws IOException {
        Path file = folder.resolve("x".repeat(255));
        WholeFiles.writeContents(Map.of(file, out -> out.write("new".getBytes())));
        assertEquals("new", Files.readString(file));
    }

    @Test
    void aFolderOfTheNameIsNotReplaced() throws IOException {
        Files.createDirectory(folder.resolve("a"));
        assertThrows(IOException.class, () -> WholeFiles.writeContents(Map.of(folder.resolve("a"), out -> { })));
        assertEquals(List.of("a"), names());
    }

    @Test
    void whatKilledProcessesLeftIsDeletedAndNothingElse() throws IOException {
        long dead = 4_194_305;  // above the largest process id of Linux
        FileTime old = FileTime.from(Instant.now().minusSeconds(3600));
        String own = ".cellgauge-" + ProcessHandle.current().pid() + "-1.part";
        for (String name : List.of(".cellgauge-" + dead + "-0.part", own, "a.part", ".cellgauge-x-0.part")) {
            Files.setLastModifiedTime(Files.writeString(folder.resolve(name), ""), old);
        }
        Files.writeString(folder.resolve(".cellgauge-" + dead + "-1.part"), "just now, by another computer");
        WholeFiles.deleteUnfinished(folder);
        assertEquals(Stream.of(".cellgauge-" + dead + "-1.part", own, ".cellgauge-x-0.part", "a.part").sorted()
                .toList(), names());
    }

    @Test
    void oneFileThatCannotBeWrittenLeavesAllAsTheyWere() throws IOException {
        Files.writeString(folder.resolve("a"), "old");
        Map<Path, WholeFiles.Content> files = new LinkedHashMap<>();
        files.put(folder.resolve("a"), out -> out.write("new".getBytes()));
        files.put(folder.resolve("missing").resolve("b"), out -> out.write("new".getBytes()));
        assertThrows(IOException.class, () -> WholeFiles.writeContents(files));
        assertEquals("old", Files.readString(folder.resolve("a")));
        assertEquals(List.of("a"), names());
    }
}
