package org.cellgauge.desktop;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;

/** SHA-256 of files (FIPS 180-4), hexadecimal: what tells whether two are the same. */
final class Sha256 {
    private Sha256() {
    }

    /** Of bytes that were read of a file, and decoded. */
    static String of(byte[] bytes) {
        return HexFormat.of().formatHex(digest().digest(bytes));
    }

    static String of(Path file) {
        try (InputStream in = Files.newInputStream(file)) {
            MessageDigest digest = digest();
            byte[] buffer = new byte[1 << 16];
            int n = in.read(buffer);
            while (n >= 0) {
                digest.update(buffer, 0, n);
                n = in.read(buffer);
            }
            return HexFormat.of().formatHex(digest.digest());
        } catch (IOException e) {
            throw new InputRefusedException(Refusal.at(Place.of(file.toString()), BatchRefusal.NOT_READABLE,
                    String.valueOf(e.getMessage())), e);
        }
    }

    private static MessageDigest digest() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }
}
