package org.cellgauge.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.Map;
import org.cellgauge.cell.InputRefusedException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ResultFolderTest {
    @TempDir
    private Path folder;

    /** One input's name costs the others of a batch nothing. */
    @Test
    void filesWithoutAPlaceAreTheFaultOfTheirInputAlone() throws IOException {
        ResultFolder results = ResultFolder.into(folder);
        Path inTheWay = Files.createDirectory(folder.resolve("a.result.json"));
        assertEquals(FolderRefusal.RESULT_NOT_WRITTEN, assertThrows(InputRefusedException.class,
                () -> results.write(Map.of("a.result.json", out -> { }))).refusal().kind());
        String name = "x".repeat(250);
        assertEquals(FolderRefusal.RESULT_NOT_WRITTEN, assertThrows(InputRefusedException.class,
                () -> results.write(Map.of(name + ".result.json", out -> { }))).refusal().kind());
        results.deleteResults("a");
        results.deleteResults(name);
        assertTrue(Files.isDirectory(inTheWay), "a folder is nobody's result");
        results.write(Map.of("b.result.json", out -> out.write('b')));
        assertEquals("b", Files.readString(folder.resolve("b.result.json")));
        results.deleteResults("b");
        assertFalse(Files.exists(folder.resolve("b.result.json")));
    }

    @Test
    void theNextRunCleansUpAfterOneThatWasKilled() throws IOException {
        Path left = Files.createFile(folder.resolve(".cellgauge-4194305-0.part"));
        Files.setLastModifiedTime(left, FileTime.from(Instant.now().minusSeconds(3600)));
        ResultFolder.into(folder);
        assertFalse(Files.exists(left));
    }
}
