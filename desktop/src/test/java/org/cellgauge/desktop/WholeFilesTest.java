package org.cellgauge.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
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
