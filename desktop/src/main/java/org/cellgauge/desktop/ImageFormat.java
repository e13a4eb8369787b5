package org.cellgauge.desktop;

import com.twelvemonkeys.imageio.plugins.webp.WebPImageReaderSpi;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Iterator;
import java.util.Optional;
import java.util.Set;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;

/** Formats of image files, told apart by their first bytes: endings of names are often wrong. */
enum ImageFormat {
    PNG, JPEG, GIF, BMP, TIFF,
    /** WebP (Google, "WebP Container Specification"). */
    WEBP,
    /** Netpbm's PGM and PPM, see {@link NetpbmImage}. */
    PNM,
    /** HEIC, HEIF and AVIF: what phones write where nobody told them otherwise. Java has no decoder for them. */
    HEIF;

    /** The formats that are read, as a message names them. */
    static final String READABLE = "PNG, JPEG, BMP, TIFF, GIF, WebP, PGM or PPM";
    /** Endings of the names of photos. */
    static final Set<String> ENDINGS = Set.of("png", "jpg", "jpeg", "bmp", "tif", "tiff", "gif", "webp", "pgm", "ppm",
            "pnm", "heic", "heif", "avif");

    private static final Set<String> HEIF_BRANDS = Set.of("heic", "heix", "heim", "heis", "hevc", "hevx", "mif1",
            "msf1", "avif", "avis");

    /**
     * The format of a file.
     *
     * @param bytes the file's beginning, or all of it
     * @return empty where it is none of these
     */
    static Optional<ImageFormat> of(byte[] bytes) {
        String head = new String(bytes, 0, Math.min(bytes.length, 12), StandardCharsets.ISO_8859_1);
        if (head.startsWith("\u0089PNG\r\n\u001a\n")) {
            return Optional.of(PNG);
        }
        if (head.startsWith("\u00ff\u00d8\u00ff")) {
            return Optional.of(JPEG);
        }
        if (head.startsWith("GIF8")) {
            return Optional.of(GIF);
        }
        if (head.startsWith("BM")) {
            return Optional.of(BMP);
        }
        if (head.startsWith("II*\0") || head.startsWith("MM\0*")) {
            return Optional.of(TIFF);
        }
        if (head.startsWith("RIFF") && head.startsWith("WEBP", 8)) {
            return Optional.of(WEBP);
        }
        if (head.matches("(?s)P[2356][\\s#].*")) {
            return Optional.of(PNM);
        }
        if (head.startsWith("ftyp", 4) && HEIF_BRANDS.contains(head.substring(8))) {
            return Optional.of(HEIF);
        }
        return Optional.empty();
    }

    /** A reader of this format, which the caller disposes of. */
    ImageReader reader() throws IOException {
        if (this == WEBP) {
            return new WebPImageReaderSpi().createReaderInstance(null);
        }
        Iterator<ImageReader> readers = ImageIO.getImageReadersByFormatName(name());
        if (!readers.hasNext()) {
            throw new IOException("this Java reads no " + name());
        }
        return readers.next();
    }
}
