package org.cellgauge.internal.cell;

import java.io.ByteArrayOutputStream;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.CodingErrorAction;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import org.cellgauge.cell.CellRefusal;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;
import org.cellgauge.warning.RefusalKind;

/** Reads text files that people wrote or tools made, and refuses what is none in words that say what to do. */
public final class InputFiles {
    private InputFiles() {
    }

    /**
     * The text of a UTF-8 file, without a byte order mark.
     *
     * @param file the file
     * @param what what it should be, without places, such as {@link CellPhrase#CELL_FILE}
     * @param maxBytes largest size that such a file can sensibly have, bytes
     * @return its text; may be empty
     * @throws InputRefusedException if it is missing, a folder, not readable, larger than allowed or no UTF-8 text
     */
    public static String text(Path file, RefusalKind what, int maxBytes) {
        return text(bytes(file, what, maxBytes), file.toString(), what, maxBytes);
    }

    /**
     * The bytes of a file.
     *
     * @param file the file
     * @param what what it should be, without places, such as {@link CellPhrase#CELL_FILE}
     * @param maxBytes largest size that such a file can sensibly have, bytes
     * @return all of it; may be empty
     * @throws InputRefusedException if it is missing, a folder, not readable or larger than allowed
     */
    public static byte[] bytes(Path file, RefusalKind what, int maxBytes) {
        if (Files.isDirectory(file)) {
            throw new InputRefusedException(file.toString(), CellRefusal.IS_FOLDER, what);
        }
        // bounded rather than by the stated size, so that an endless device cannot fill the memory
        try (InputStream in = Files.newInputStream(file)) {
            byte[] bytes = bounded(in, maxBytes);
            if (bytes.length > maxBytes) {
                throw new InputRefusedException(file.toString(), CellRefusal.TOO_LARGE, maxBytes / 1024, what);
            }
            return bytes;
        } catch (IOException e) {
            throw unreadable(file.toString(), e, what);
        }
    }

    /**
     * The text of a stream, as {@link #text(Path, RefusalKind, int)}: for sources that are no files,
     * such as Android's documents.
     *
     * @param in the stream, read to its end but not closed
     * @param name the name that messages give it
     * @param what what it should be, without places
     * @param maxBytes largest size that such a file can sensibly have, bytes
     * @return its text; may be empty
     * @throws InputRefusedException if it cannot be read, is larger than allowed or no UTF-8 text
     */
    public static String text(InputStream in, String name, RefusalKind what, int maxBytes) {
        return text(bytes(in, name, what, maxBytes), name, what, maxBytes);
    }

    /**
     * The bytes of a stream, as {@link #text(InputStream, String, RefusalKind, int)}.
     *
     * @param in the stream, read to its end, or beyond what is allowed, but not closed
     * @param name the name that messages give it
     * @param what what it should be, without places
     * @param maxBytes largest size that such a file can sensibly have, bytes
     * @return all of it; more bytes than allowed where there are more
     * @throws InputRefusedException if it cannot be read
     */
    public static byte[] bytes(InputStream in, String name, RefusalKind what, int maxBytes) {
        try {
            return bounded(in, maxBytes);
        } catch (IOException e) {
            throw unreadable(name, e, what);
        }
    }

    private static InputRefusedException unreadable(String name, IOException e, RefusalKind what) {
        return new InputRefusedException(reason(e, what).withPlace(Place.of(name)), e);
    }

    /** Why a file could not be read, with the remedy, without its name. */
    public static Refusal reason(IOException e, RefusalKind what) {
        if (e instanceof NoSuchFileException || e instanceof FileNotFoundException) {
            return Refusal.of(CellRefusal.NO_SUCH_FILE, what);
        }
        if (e instanceof AccessDeniedException) {
            return Refusal.of(CellRefusal.NOT_PERMITTED);
        }
        String message = e.getMessage() == null ? e.getClass().getSimpleName() : e.getMessage();
        return Refusal.of(CellRefusal.NOT_READABLE, what, message);
    }

    private static byte[] bounded(InputStream in, int maxBytes) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        byte[] buffer = new byte[8192];
        int n = in.read(buffer);
        while (n >= 0 && out.size() <= maxBytes) {
            out.write(buffer, 0, n);
            n = in.read(buffer);
        }
        return out.toByteArray();
    }

    /**
     * The text that bytes are, as {@link #text(Path, RefusalKind, int)}.
     *
     * @param bytes all of a file
     * @param name the name that messages give it
     * @param what what it should be, without places
     * @param maxBytes largest size that such a file can sensibly have, bytes
     * @return its text; may be empty
     * @throws InputRefusedException if it is larger than allowed or no UTF-8 text
     */
    public static String text(byte[] bytes, String name, RefusalKind what, int maxBytes) {
        if (bytes.length > maxBytes) {
            throw new InputRefusedException(name, CellRefusal.TOO_LARGE, maxBytes / 1024, what);
        }
        if (bytes.length >= 2 && ((bytes[0] == (byte) 0xFE && bytes[1] == (byte) 0xFF)
                || (bytes[0] == (byte) 0xFF && bytes[1] == (byte) 0xFE))) {
            throw new InputRefusedException(name, CellRefusal.UTF_16, what);
        }
        String text;
        try {
            text = StandardCharsets.UTF_8.newDecoder().onMalformedInput(CodingErrorAction.REPORT)
                    .onUnmappableCharacter(CodingErrorAction.REPORT).decode(ByteBuffer.wrap(bytes)).toString();
        } catch (CharacterCodingException e) {
            throw new InputRefusedException(Refusal.at(Place.of(name), CellRefusal.NO_UTF_8, what), e);
        }
        if (text.indexOf('\0') >= 0) {
            throw new InputRefusedException(name, CellRefusal.BINARY, what);
        }
        return text.startsWith("\uFEFF") ? text.substring(1) : text;
    }
}
