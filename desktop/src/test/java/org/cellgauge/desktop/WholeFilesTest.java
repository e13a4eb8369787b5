package org.cellgauge.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
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

    /** Whoever knew the name of an unfinished file beforehand could lay a link there. */
    @Test
    void namesOfUnfinishedFilesCannotBeForeseen() throws IOException {
        Set<String> names = new HashSet<>();
        for (int i = 0; i < 20; i++) {
            List<String> beside = new ArrayList<>();
            WholeFiles.writeContents(Map.of(folder.resolve("a"), out -> beside.addAll(names())));
            beside.remove("a");
            assertEquals(1, beside.size(), beside.toString());
            assertTrue(beside.get(0).matches("\\.cellgauge-\\d+-[0-9a-f]{16}\\.part"), beside.get(0));
            names.addAll(beside);
        }
        assertEquals(20, names.size());
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
        for (String name : List.of(".cellgauge-" + dead + "-0.part", ".cellgauge-" + dead + "-00ff00ff00ff00ff.part",
                own, "a.part", ".cellgauge-x-0.part")) {
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
