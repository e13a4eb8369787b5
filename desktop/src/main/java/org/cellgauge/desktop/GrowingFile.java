package org.cellgauge.desktop;

import java.io.ByteArrayOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Objects;

/**
 * A file that grows while a run goes on and has no name until the end: the memory holds none of it, and the disk has
 * room for it whatever comes. What was written can still be had where the file's folder has been removed.
 */
final class GrowingFile implements Closeable {
    private static final int PIECE = 1 << 14;

    private final int reservedBytes;
    private final FileChannel channel;
    private Path temporary;

    /**
     * An empty file.
     *
     * @param place of the file to be, in a folder that exists
     * @param reservedBytes room on the disk that is taken besides, until this is closed
     * @throws IOException if it cannot be made
     */
    GrowingFile(Path place, int reservedBytes) throws IOException {
        this.reservedBytes = reservedBytes;
        channel = WholeFiles.unfinished(place, name -> temporary = name);
        try {
            byte[] nothing = new byte[Math.min(reservedBytes, PIECE)];
            for (int left = reservedBytes; left > 0; left -= nothing.length) {
                write(left < nothing.length ? new byte[left] : nothing);
            }
        } catch (IOException e) {
            close();
            throw e;
        }
    }

    /** Appends a text in UTF-8. */
    void append(String text) throws IOException {
        write(text.getBytes(StandardCharsets.UTF_8));
    }

    private void write(byte[] bytes) throws IOException {
        ByteBuffer buffer = ByteBuffer.wrap(bytes);
        while (buffer.hasRemaining()) {
            channel.write(buffer);
        }
    }

    /** All that was appended. */
    byte[] bytes() throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream((int) (channel.size() - reservedBytes));
        channel.transferTo(reservedBytes, channel.size() - reservedBytes, Channels.newChannel(out));
        return out.toByteArray();
    }

    /**
     * Gives the file its name, or makes it anew where it has been deleted or is to have its place elsewhere.
     *
     * @param place the file, in a folder that exists; there is nothing reserved
     * @throws IOException if the place cannot be had
     */
    void moveTo(Path place) throws IOException {
        if (Files.exists(temporary) && Objects.equals(temporary.getParent(), place.getParent())) {
            WholeFiles.move(temporary, place);
        } else {
            WholeFiles.writeContents(Map.of(place, out -> channel.transferTo(0, channel.size(),
                    Channels.newChannel(out))));
        }
    }

    /** Deletes it, unless it has its name. */
    @Override
    public void close() throws IOException {
        channel.close();
        Files.deleteIfExists(temporary);
    }
}
