package org.cellgauge.desktop;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.OpenOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.time.LocalDateTime;
import java.time.temporal.ChronoUnit;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;

/**
 * A folder that one run has for itself: {@code .cellgauge.lock} in it is locked by the system and says whose it is.
 * Where the run is killed the system gives the lock free, so that what is left of it is in nobody's way.
 */
final class FolderLock implements AutoCloseable {
    static final String NAME = ".cellgauge.lock";

    /** The byte that is locked: beyond the text, which others are to read. */
    private static final long LOCKED_BYTE = Long.MAX_VALUE - 1;
    private static final int MAX_OWNER_BYTES = 500;
    private static final int MAX_TRIES = 100;

    private final Path file;
    private final FileChannel channel;

    private FolderLock(Path file, FileChannel channel) {
        this.file = file;
        this.channel = channel;
    }

    /** Another run has the folder. */
    static final class HeldException extends IOException {
        private static final long serialVersionUID = 1L;

        HeldException(String owner) {
            super(owner);
        }
    }

    /**
     * Takes a folder.
     *
     * @param folder which exists
     * @return the lock; where the file system knows none, one that keeps nobody out
     * @throws HeldException if another run has it; its message says which
     * @throws IOException if nothing can be written there
     */
    static FolderLock of(Path folder) throws IOException {
        Path file = folder.resolve(NAME);
        for (int tries = 1; ; tries++) {
            Optional<FolderLock> lock = tried(file);
            if (lock.isPresent()) {
                return lock.get();
            }
            if (tries == MAX_TRIES) {
                throw new HeldException("runs that come and go");
            }
        }
    }

    /** Empty where the run that had it went while it was asked. */
    private static Optional<FolderLock> tried(Path file) throws IOException {
        Object before = key(file);
        FileChannel channel;
        try {
            // never through a link
            channel = FileChannel.open(file, Set.<OpenOption>of(StandardOpenOption.READ, StandardOpenOption.WRITE,
                    LinkOption.NOFOLLOW_LINKS, before == null ? StandardOpenOption.CREATE_NEW
                            : StandardOpenOption.CREATE));
        } catch (FileAlreadyExistsException e) {
            return Optional.empty();
        }
        try {
            Object opened = key(file);
            FileLock lock = channel.tryLock(LOCKED_BYTE, 1, false);
            if (lock == null) {
                throw new HeldException(owner(channel));
            }
            // whoever had the lock deletes the file, and the next one makes another
            boolean same = opened != null && opened.equals(key(file)) && (before == null || before.equals(opened));
            if (!same) {
                channel.close();
                return Optional.empty();
            }
            channel.truncate(0);
            channel.write(ByteBuffer.wrap(self().getBytes(StandardCharsets.UTF_8)), 0);
            return Optional.of(new FolderLock(file, channel));
        } catch (OverlappingFileLockException e) {
            String owner = owner(channel);
            channel.close();
            throw new HeldException(owner);
        } catch (HeldException e) {
            channel.close();
            throw e;
        } catch (IOException e) {
            if (e.getMessage() != null && e.getMessage().matches("(?i).*(no locks|not supported).*")) {
                // some network drives: two runs at once are then the caller's care
                return Optional.of(new FolderLock(file, channel));
            }
            channel.close();
            throw e;
        }
    }

    /** What tells a file from another one that has its name later; null where there is none. */
    private static Object key(Path file) throws IOException {
        try {
            BasicFileAttributes attributes = Files.readAttributes(file, BasicFileAttributes.class,
                    LinkOption.NOFOLLOW_LINKS);
            return Objects.requireNonNullElse(attributes.fileKey(), attributes.creationTime());
        } catch (NoSuchFileException e) {
            return null;
        }
    }

    private static String owner(FileChannel channel) throws IOException {
        ByteBuffer text = ByteBuffer.allocate(MAX_OWNER_BYTES);
        channel.read(text, 0);
        String owner = new String(text.array(), 0, text.position(), StandardCharsets.UTF_8).trim();
        return owner.isEmpty() ? "unknown" : owner;
    }

    private static String self() {
        ProcessHandle process = ProcessHandle.current();
        return "process " + process.pid() + process.info().user().map(user -> " of " + user).orElse("") + ", since "
                + LocalDateTime.now(LocalClock.now()).truncatedTo(ChronoUnit.SECONDS) + "\n";
    }

    /** Gives the folder free. */
    @Override
    public void close() throws IOException {
        try (channel) {
            Files.deleteIfExists(file);
        }
    }
}
