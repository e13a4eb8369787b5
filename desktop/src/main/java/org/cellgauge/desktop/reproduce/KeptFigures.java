package org.cellgauge.desktop.reproduce;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.Map;
import java.util.Optional;
import org.cellgauge.desktop.ResultFolder;

/**
 * Figures of earlier runs in a folder, a file for each piece of work: the file's name says what made them, so that
 * other settings, assumptions or versions find none of it.
 */
final class KeptFigures {
    private static final int DIGITS = 16;

    private final ResultFolder folder;
    private final String version;

    /**
     * A folder of figures.
     *
     * @param folder made when the first are kept
     * @param version of the program
     */
    KeptFigures(ResultFolder folder, String version) {
        this.folder = folder;
        this.version = version;
    }

    /** What is kept of a piece of work; nothing where it was not done yet, or its file is damaged. */
    Optional<Figures> of(Work work) {
        Path file = folder.file(name(work));
        try {
            JsonElement found = Files.exists(file)
                    ? JsonParser.parseString(Files.readString(file, StandardCharsets.UTF_8)) : new JsonObject();
            return found.isJsonObject() && found.getAsJsonObject().size() > 0
                    ? Optional.of(Figures.of(found.getAsJsonObject())) : Optional.empty();
        } catch (IOException | JsonParseException | IllegalStateException | UnsupportedOperationException
                | NumberFormatException e) {
            // what cannot be read is made again
            return Optional.empty();
        }
    }

    /**
     * Keeps what was found.
     *
     * @throws ResultFolder.UnwritableException if the folder takes it not
     */
    void keep(Work work, Figures figures) {
        folder.write(Map.of(name(work), out -> out.write(figures.json().getBytes(StandardCharsets.UTF_8))));
    }

    private String name(Work work) {
        try {
            byte[] hash = MessageDigest.getInstance("SHA-256")
                    .digest((version + "\n" + work.name() + "\n" + work.identity()).getBytes(StandardCharsets.UTF_8));
            return work.name().replaceAll("[^A-Za-z0-9.-]+", "-") + "."
                    + HexFormat.of().formatHex(hash).substring(0, DIGITS) + ".json";
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }
}
