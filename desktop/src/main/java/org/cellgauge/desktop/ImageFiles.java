package org.cellgauge.desktop;

import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.Locale;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.internal.vision.StatedToneCurve;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.vision.GreyImage;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;

/**
 * Reads photos from files as the detector wants them: grey, as they are stored.
 *
 * <p>A calibration speaks of stored pixels, so a note in the file that says which way up to show it (the orientation
 * of Exif) is not followed: photos to be measured and photos for calibration must be stored alike. Colours become grey
 * by the luma weights of ITU-R BT.601 (0.299, 0.587, 0.114) on the stored values; transparent parts lie on white. Light
 * would have to be weighted before the tone curve and not after it; but markers are black and white, along their edges
 * red, green and blue are alike but for the tint of the lamp, and of equal values any weights make the same. A tint
 * multiplies the light of each colour by a factor of its own; a power takes that to a factor of grey, so that the sum
 * is still the same power of the light.
 *
 * <p>What the file says of its tone curve goes with the image ({@link GreyImage#toneCurve()}): profiles, the chunks of
 * PNG, Exif. JPEG, BMP and GIF files that say nothing are taken for sRGB, PNG and TIFF files say nothing then. Damaged
 * notes of that kind count as none.
 */
public final class ImageFiles {
    /** Largest image that is decoded, in pixels: four times what cameras on robots have, 400 MB as colour. */
    public static final long MAX_PIXELS = 100_000_000;
    private static final String FORMATS = "PNG, JPEG, BMP, TIFF or GIF";
    private static final int CMYK_BANDS = 4;
    private static final long MAX_BARE_BYTES = 200 << 20;
    private static final int APP0 = 0xE0;
    private static final int APP14 = 0xEE;
    private static final int APP15 = 0xEF;
    private static final int COMMENT = 0xFE;
    private static final int START_OF_SCAN = 0xDA;

    private ImageFiles() {
    }

    /**
     * Reads an image. The size is taken from the header first, so that a small file cannot claim a huge memory.
     *
     * @param file an image file of a format that {@code javax.imageio} reads
     * @return the image, in an array of its own
     * @throws InputRefusedException if the file is missing, a folder, empty, not readable, of another format, damaged,
     *     cut short, larger than {@value #MAX_PIXELS} pixels or in CMYK colours; the message names file and remedy
     */
    public static GreyImage read(Path file) {
        if (Files.isDirectory(file)) {
            throw refused(file, ImageRefusal.IS_FOLDER);
        }
        try {
            if (!Files.exists(file)) {
                throw refused(file, ImageRefusal.NO_SUCH_FILE);
            }
            if (Files.size(file) == 0) {
                throw refused(file, ImageRefusal.EMPTY);
            }
            if (!Files.isReadable(file)) {
                throw refused(file, ImageRefusal.NOT_PERMITTED);
            }
            // over the file itself: a stream would first be copied to a temporary file
            try (ImageInputStream in = ImageIO.createImageInputStream(file.toFile())) {
                if (in == null) {
                    throw refused(file, ImageRefusal.NOT_OPENED);
                }
                // before the reader, which may leave no way back
                ToneCurve toneCurve = StatedToneCurve.of((position, into) -> {
                    in.seek(position);
                    in.readFully(into);
                });
                in.seek(0);
                return decoded(file, in).withToneCurve(toneCurve);
            }
        } catch (IOException e) {
            throw damaged(e, file, ImageRefusal.NOT_READABLE, String.valueOf(e.getMessage()));
        }
    }

    /** The pixels; where a JPEG cannot be read as it is, without the notes that come before them. */
    private static GreyImage decoded(Path file, ImageInputStream in) throws IOException {
        try {
            return read(file, in);
        } catch (InputRefusedException e) {
            byte[] bare = withoutNotes(file);
            if (bare == null) {
                throw e;
            }
            // the JDK's reader stops at a damaged profile even where nobody asks for it
            try (ImageInputStream again = new MemoryCacheImageInputStream(new ByteArrayInputStream(bare))) {
                return read(file, again);
            } catch (InputRefusedException notBecauseOfNotes) {
                throw e;
            }
        }
    }

    /**
     * A JPEG file without the segments of notes before its first scan: APP1 to APP13, APP15 and comments (APP0 and
     * APP14 say how its colours are stored). Null for other files, damaged ones and those without notes.
     */
    private static byte[] withoutNotes(Path file) throws IOException {
        if (Files.size(file) > MAX_BARE_BYTES) {
            return null;
        }
        byte[] all = Files.readAllBytes(file);
        if (all.length < 4 || (all[0] & 0xFF) != 0xFF || (all[1] & 0xFF) != 0xD8) {
            return null;
        }
        ByteArrayOutputStream bare = new ByteArrayOutputStream(all.length);
        bare.write(all, 0, 2);
        int at = 2;
        while (at + 4 <= all.length && (all[at] & 0xFF) == 0xFF && (all[at + 1] & 0xFF) != START_OF_SCAN) {
            int marker = all[at + 1] & 0xFF;
            int length = 2 + ((all[at + 2] & 0xFF) << 8 | all[at + 3] & 0xFF);
            if (at + length > all.length) {
                return null;
            }
            boolean note = marker > APP0 && marker <= APP15 && marker != APP14 || marker == COMMENT;
            if (!note) {
                bare.write(all, at, length);
            }
            at += length;
        }
        bare.write(all, at, all.length - at);
        return bare.size() < all.length ? bare.toByteArray() : null;
    }

    private static GreyImage read(Path file, ImageInputStream in) throws IOException {
        Iterator<ImageReader> readers = ImageIO.getImageReaders(in);
        if (!readers.hasNext()) {
            throw refused(file, ImageRefusal.UNKNOWN_FORMAT, FORMATS);
        }
        ImageReader reader = readers.next();
        try {
            // metadata (thumbnails, colour profiles) is not needed, and damaged metadata would stop the reader
            reader.setInput(in, true, true);
            int width;
            int height;
            BufferedImage image;
            String[] warning = new String[1];
            reader.addIIOReadWarningListener((source, text) -> {
                if (!isHarmless(text)) {
                    warning[0] = text;
                }
            });
            try {
                width = reader.getWidth(0);
                height = reader.getHeight(0);
                if (width < 1 || height < 1 || (long) width * height > MAX_PIXELS) {
                    throw refused(file, ImageRefusal.TOO_LARGE, width, height, (int) (MAX_PIXELS / 1_000_000));
                }
                if (hasNoType(reader)) {
                    throw refused(file, ImageRefusal.CMYK);
                }
                image = reader.read(0);
            } catch (IOException | RuntimeException e) {
                if (e instanceof InputRefusedException) {
                    throw e;
                }
                // readers throw whatever a damaged file leads them to, unchecked exceptions included
                throw e instanceof EOFException || e.getCause() instanceof EOFException
                        ? damaged(e, file, ImageRefusal.CUT_SHORT)
                        : damaged(e, file, ImageRefusal.DAMAGED, String.valueOf(e.getMessage()));
            }
            if (warning[0] != null) {
                throw refused(file, ImageRefusal.PARTLY_DAMAGED, warning[0]);
            }
            return grey(file, image);
        } finally {
            reader.dispose();
        }
    }

    /** Remarks on what comes beside the pixels: previews, colour profiles, metadata. */
    private static boolean isHarmless(String warning) {
        String text = warning.toLowerCase(Locale.ROOT);
        return text.contains("icc") || text.contains("color profile") || text.contains("thumb")
                || text.contains("metadata") || text.contains("jfif");
    }

    /** The JPEG reader offers no type for CMYK colours it cannot convert. */
    private static boolean hasNoType(ImageReader reader) throws IOException {
        if (!reader.getFormatName().toLowerCase(Locale.ROOT).startsWith("jp")) {
            return false;
        }
        return !reader.getImageTypes(0).hasNext();
    }

    private static GreyImage grey(Path file, BufferedImage image) {
        ColorModel colours = image.getColorModel();
        int width = image.getWidth();
        int height = image.getHeight();
        byte[] grey = new byte[width * height];
        if (colours instanceof IndexColorModel) {
            greyOfPalette(image.getRaster(), (IndexColorModel) colours, grey);
            return GreyImage.packed(grey, width, height);
        }
        int colourBands = colours.getNumColorComponents();
        int space = colours.getColorSpace().getType();
        if (colourBands == CMYK_BANDS) {
            throw refused(file, ImageRefusal.CMYK);
        }
        boolean isGrey = colourBands == 1 && space == ColorSpace.TYPE_GRAY;
        if (!isGrey && (colourBands != 3 || space != ColorSpace.TYPE_RGB)
                || image.getSampleModel().getTransferType() > DataBuffer.TYPE_USHORT
                && image.getSampleModel().getTransferType() != DataBuffer.TYPE_INT) {
            throw refused(file, ImageRefusal.OTHER_COLOURS);
        }
        Raster raster = image.getRaster();
        int bands = raster.getNumBands();
        int[] row = new int[width * bands];
        double[] scale = new double[bands];
        for (int b = 0; b < bands; b++) {
            scale[b] = 255.0 / ((1 << colours.getComponentSize(b)) - 1);
        }
        boolean multiplied = colours.isAlphaPremultiplied();
        for (int y = 0; y < height; y++) {
            raster.getPixels(0, y, width, 1, row);
            for (int x = 0; x < width; x++) {
                int at = x * bands;
                double value = isGrey ? row[at] * scale[0]
                        : luma(row[at] * scale[0], row[at + 1] * scale[1], row[at + 2] * scale[2]);
                if (colours.hasAlpha()) {
                    double alpha = row[at + bands - 1] * scale[bands - 1] / 255;
                    value = (multiplied ? value : alpha * value) + (1 - alpha) * 255;
                }
                grey[y * width + x] = (byte) Math.round(value);
            }
        }
        return GreyImage.packed(grey, width, height);
    }

    private static void greyOfPalette(Raster raster, IndexColorModel palette, byte[] grey) {
        byte[] greyOf = new byte[palette.getMapSize()];
        for (int i = 0; i < greyOf.length; i++) {
            double alpha = palette.getAlpha(i) / 255.0;
            double value = luma(palette.getRed(i), palette.getGreen(i), palette.getBlue(i));
            greyOf[i] = (byte) Math.round(alpha * value + (1 - alpha) * 255);
        }
        int width = raster.getWidth();
        int[] row = new int[width];
        for (int y = 0; y < raster.getHeight(); y++) {
            raster.getSamples(0, y, width, 1, 0, row);
            for (int x = 0; x < width; x++) {
                grey[y * width + x] = row[x] < greyOf.length ? greyOf[row[x]] : 0;
            }
        }
    }

    private static double luma(double red, double green, double blue) {
        return 0.299 * red + 0.587 * green + 0.114 * blue;
    }

    private static InputRefusedException refused(Path file, ImageRefusal kind, Object... arguments) {
        return new InputRefusedException(file.toString(), kind, arguments);
    }

    private static InputRefusedException damaged(Exception cause, Path file, ImageRefusal kind, Object... arguments) {
        return new InputRefusedException(Refusal.at(Place.of(file.toString()), kind, arguments), cause);
    }
}
