package org.cellgauge.cell;

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

/** Reads text files that people wrote or tools made, and refuses what is none in words that say what to do. */
public final class InputFiles {
    private InputFiles() {
    }

    /**
     * The text of a UTF-8 file, without a byte order mark.
     *
     * @param file the file
     * @param what what it should be, for the message: "cell file", "camera file"
     * @param maxBytes largest size that such a file can sensibly have, bytes
     * @return its text; may be empty
     * @throws InputRefusedException if it is missing, a folder, not readable, larger than allowed or no UTF-8 text
     */
    public static String text(Path file, String what, int maxBytes) {
        byte[] bytes;
        if (Files.isDirectory(file)) {
            throw new InputRefusedException(file + ": this is a folder; name the " + what + " in it");
        }
        // bounded rather than by the stated size, so that an endless device cannot fill the memory
        try (InputStream in = Files.newInputStream(file)) {
            bytes = bounded(in, maxBytes);
        } catch (IOException e) {
            throw new InputRefusedException(file + ": " + reason(e, what), e);
        }
        if (bytes.length > maxBytes) {
            throw new InputRefusedException(file + ": larger than " + maxBytes / 1024 + " KiB, which no " + what
                    + " is; check the name of the file");
        }
        return decode(bytes, file.toString(), what);
    }

    /**
     * The text of a stream, as {@link #text}: for sources that are no files, such as Android's documents.
     *
     * @param in the stream, read to its end but not closed
     * @param name the name that messages give it
     * @param what what it should be, for the message
     * @param maxBytes largest size that such a file can sensibly have, bytes
     * @return its text; may be empty
     * @throws InputRefusedException if it cannot be read, is larger than allowed or no UTF-8 text
     */
    public static String text(InputStream in, String name, String what, int maxBytes) {
        byte[] bytes;
        try {
            bytes = bounded(in, maxBytes);
        } catch (IOException e) {
            throw new InputRefusedException(name + ": " + reason(e, what), e);
        }
        if (bytes.length > maxBytes) {
            throw new InputRefusedException(name + ": larger than " + maxBytes / 1024 + " KiB, which no " + what
                    + " is; check the name of the file");
        }
        return decode(bytes, name, what);
    }

    /** Why a file could not be read, with the remedy, without its name. */
    static String reason(IOException e, String what) {
        if (e instanceof NoSuchFileException || e instanceof FileNotFoundException) {
            return "there is no such file; check the name and the folder of the " + what;
        }
        if (e instanceof AccessDeniedException) {
            return "no permission to read this file; allow reading it or copy it elsewhere";
        }
        String message = e.getMessage() == null ? e.getClass().getSimpleName() : e.getMessage();
        return "the " + what + " cannot be read (" + message + "); check the disk or copy the file elsewhere";
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

    private static String decode(byte[] bytes, String name, String what) {
        if (bytes.length >= 2 && ((bytes[0] == (byte) 0xFE && bytes[1] == (byte) 0xFF)
                || (bytes[0] == (byte) 0xFF && bytes[1] == (byte) 0xFE))) {
            throw new InputRefusedException(name + ": this text is stored as UTF-16; save the " + what + " as UTF-8");
        }
        String text;
        try {
            text = StandardCharsets.UTF_8.newDecoder().onMalformedInput(CodingErrorAction.REPORT)
                    .onUnmappableCharacter(CodingErrorAction.REPORT).decode(ByteBuffer.wrap(bytes)).toString();
        } catch (CharacterCodingException e) {
            throw new InputRefusedException(name + ": this is no text in UTF-8; name a " + what
                    + ", and save it as UTF-8 if it is one", e);
        }
        if (text.indexOf('\0') >= 0) {
            throw new InputRefusedException(name + ": this is a binary file; name a " + what + " instead");
        }
        return text.startsWith("\uFEFF") ? text.substring(1) : text;
    }
}
