package org.cellgauge.desktop;

import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;

/** The checksum by which a result names its input (FIPS 180-4). */
public final class Sha256 {
    private Sha256() {
    }

    /**
     * The checksum of bytes.
     *
     * @param bytes what was read of a file, and decoded
     * @return 64 hexadecimal digits in lower case
     */
    public static String of(byte[] bytes) {
        try {
            return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bytes));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }
}
