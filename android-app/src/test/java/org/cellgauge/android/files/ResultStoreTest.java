package org.cellgauge.android.files;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** All or nothing, whatever the disk does. */
class ResultStoreTest {
    @TempDir
    Path folder;

    private File results;
    private ResultStore store;

    /** A disk on which a file, or the wait for it, fails after some bytes. */
    private static final class FailingDisk implements ResultStore.Disk {
        private final ResultStore.RealDisk real = new ResultStore.RealDisk();
        private final long room;
        private final String message;
        private final boolean failOnSync;
        private long written;
        private long free;

        FailingDisk(long room, String message, boolean failOnSync) {
            this.room = room;
            this.message = message;
            this.failOnSync = failOnSync;
        }

        @Override
        public ResultStore.Whole create(File file) throws IOException {
            ResultStore.Whole out = real.create(file);
            return new ResultStore.Whole() {
                @Override
                public void write(int b) throws IOException {
                    write(new byte[] {(byte) b}, 0, 1);
                }

                @Override
                public void write(byte[] bytes, int from, int count) throws IOException {
                    int fits = (int) Math.min(count, failOnSync ? count : room - written);
                    out.write(bytes, from, fits);
                    written += fits;
                    if (fits < count) {
                        throw new IOException(message);
                    }
                }

                @Override
                void sync() throws IOException {
                    if (written > room) {
                        throw new IOException(message);
                    }
                    out.sync();
                }

                @Override
                public void close() throws IOException {
                    out.close();
                }
            };
        }

        @Override
        public long freeBytes(File of) {
            return free;
        }
    }

    @BeforeEach
    void newStore() {
        results = new File(folder.toFile(), "app/results");
        store = new ResultStore(results, new ResultStore.RealDisk());
    }

    private static Map<String, byte[]> files() {
        Map<String, byte[]> files = new LinkedHashMap<>();
        files.put("a.png", new byte[1000]);
        files.put("a.result.json", new byte[] {1, 2, 3});
        files.put("a.cell.yaml", new byte[500]);
        return files;
    }

    private void assertNothingIn(File dir) {
        String[] left = dir.list();
        assertEquals(Collections.emptyList(), left == null ? Collections.emptyList() : Arrays.asList(left));
    }

    @Test
    void whatIsWrittenIsThere() throws IOException {
        store.write("a", files());
        assertEquals(Collections.singletonList("a"), store.names());
        assertEquals(Arrays.asList("a.cell.yaml", "a.png", "a.result.json"), store.files("a"));
        assertArrayEquals(new byte[] {1, 2, 3}, Files.readAllBytes(store.file("a", "a.result.json").toPath()));
        assertArrayEquals(new String[] {"a"}, results.list());
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 999, 1000, 1002, 1003, 1502})
    void aDiskThatGetsFullAnywhereIsSaidAndLeavesNothing(int room) {
        for (boolean onSync : new boolean[] {false, true}) {
            FailingDisk disk = new FailingDisk(room, "write failed: ENOSPC (No space left on device)", onSync);
            StorageFullException e = assertThrows(StorageFullException.class,
                    () -> new ResultStore(results, disk).write("a", files()));
            assertTrue(e.getMessage().contains("are free"), e.getMessage());
            assertNothingIn(results);
        }
    }

    @Test
    void anotherFaultOfTheDiskLeavesNothingEither() {
        FailingDisk disk = new FailingDisk(1001, "I/O error", false);
        IOException e = assertThrows(IOException.class, () -> new ResultStore(results, disk).write("a", files()));
        assertFalse(e instanceof StorageFullException);
        assertEquals("I/O error", e.getMessage());
        assertNothingIn(results);
    }

    @Test
    void tooLittleSpaceIsFoundBeforeAnythingIsWritten() {
        FailingDisk disk = new FailingDisk(Long.MAX_VALUE, "", false);
        disk.free = (1 << 20) + 1502;
        StorageFullException e = assertThrows(StorageFullException.class,
                () -> new ResultStore(results, disk).write("a", files()));
        assertEquals("the result takes 0.0 MB and 1.1 MB are free; remove what is not needed any more, such as earlier "
                + "results", e.getMessage());
        assertEquals(0, disk.written);
        assertNothingIn(results);
        disk.free++;
        assertNotNull(assertWritten(disk));
    }

    @Test
    void aDiskThatDoesNotSayWhatIsFreeIsTried() {
        assertNotNull(assertWritten(new FailingDisk(Long.MAX_VALUE, "", false)));
    }

    private File assertWritten(FailingDisk disk) {
        try {
            new ResultStore(results, disk).write("a", files());
        } catch (IOException e) {
            throw new AssertionError(e);
        }
        return store.file("a", "a.png");
    }

    @Test
    void aFolderThatCannotBeMadeIsAFault() throws IOException {
        Files.createDirectories(results.getParentFile().toPath());
        Files.write(results.toPath(), new byte[0]);
        IOException e = assertThrows(IOException.class, () -> store.write("a", files()));
        assertFalse(e instanceof StorageFullException);
    }

    @Test
    void whatAnEndedAppLeftHalfDoneIsNoResultAndGoesWithTheNext() throws IOException {
        File half = new File(results, ".writing-b");
        File going = new File(results, ".deleted-c");
        assertTrue(half.mkdirs() && going.mkdirs());
        Files.write(new File(half, "b.png").toPath(), new byte[10]);
        assertEquals(Collections.emptyList(), store.names());
        store.write("a", files());
        assertArrayEquals(new String[] {"a"}, results.list());
    }

    @Test
    void takenNamesAreNumbered() throws IOException {
        assertEquals("a", store.freeName("a"));
        store.write("a", files());
        assertEquals("a-2", store.freeName("a"));
        store.write("a-2", files());
        assertEquals("a-3", store.freeName("a"));
    }

    @Test
    void anExistingResultIsNeverWrittenOver() throws IOException {
        store.write("a", files());
        assertThrows(IOException.class, () -> store.write("a", Collections.singletonMap("x", new byte[0])));
        assertEquals(3, store.files("a").size());
    }

    @Test
    void theNewestComesFirst() throws IOException {
        for (String name : new String[] {"x", "a", "m"}) {
            store.write(name, files());
        }
        assertTrue(new File(results, "x").setLastModified(2_000_000));
        assertTrue(new File(results, "a").setLastModified(3_000_000));
        assertTrue(new File(results, "m").setLastModified(2_000_000));
        assertEquals(Arrays.asList("a", "x", "m"), store.names());
    }

    @Test
    void aDeletedResultIsGoneWithItsFiles() throws IOException {
        store.write("a", files());
        store.write("b", files());
        assertTrue(store.delete("a"));
        assertFalse(store.delete("a"));
        assertEquals(Collections.singletonList("b"), store.names());
        assertArrayEquals(new String[] {"b"}, results.list());
    }

    @ParameterizedTest
    @ValueSource(strings = {"..", ".", "", "/", "../secret", "a/../../secret", "a/..", ".writing-b", "a\0", "a b",
        "%2e%2e", "/etc/passwd", "b"})
    void noNameLeadsOutOfTheFolder(String name) throws IOException {
        store.write("a", files());
        Files.write(new File(results.getParentFile(), "secret").toPath(), new byte[10]);
        assertNull(store.result(name));
        assertNull(store.file(name, "a.png"));
        assertNull(store.file("a", name));
        assertEquals(Collections.emptyList(), store.files(name));
        assertFalse(store.delete(name));
        assertNotNull(store.file("a", "a.png"));
    }

    @Test
    void aLinkLeadsNowhere() throws IOException {
        store.write("a", files());
        Path secret = Files.write(new File(results.getParentFile(), "secret").toPath(), new byte[10]);
        Files.createSymbolicLink(new File(results, "a/link.png").toPath(), secret);
        Files.createSymbolicLink(new File(results, "b").toPath(), results.getParentFile().toPath());
        assertNull(store.file("a", "link.png"));
        assertNull(store.result("b"));
    }
}
