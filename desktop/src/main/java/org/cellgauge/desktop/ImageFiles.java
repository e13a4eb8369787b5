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
import java.io.InputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.Locale;
import java.util.Optional;
import java.util.zip.DataFormatException;
import javax.imageio.ImageReader;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.internal.vision.StatedToneCurve;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.vision.GreyImage;
import org.cellgauge.warning.MessageKind;
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
 * <p>Cameras of 10 and 12 bits are often stored in 16 with the upper ones empty: where no value of a photo takes more
 * than 8, 10 or 12 bits, those are the whole range. PGM and PPM state their largest value.
 *
 * <p>What the file says of its tone curve goes with the image ({@link GreyImage#toneCurve()}): profiles, the chunks of
 * PNG, Exif. JPEG, BMP and GIF files that say nothing are taken for sRGB, files of other formats say nothing then.
 * Damaged notes of that kind count as none.
 */
public final class ImageFiles {
    /** Largest image that is decoded, in pixels: four times what cameras on robots have, 400 MB as colour. */
    public static final long MAX_PIXELS = 100_000_000;
    /** Longest side of an image that is decoded, px; the longest that a camera file may state. */
    public static final int MAX_SIDE_PX = 30_000;
    /** Largest file that is read, bytes. */
    public static final int MAX_BYTES = 400 << 20;
    private static final int CMYK_BANDS = 4;
    private static final int BYTE_BITS = 8;
    private static final int MAX_BITS = 16;
    /** Bits of values that cameras hand over in 16. */
    private static final int[] BITS_IN_16 = {8, 10, 12};
    /** How often a reader may ask for more than there is: of whole files, for the last 64 bits. */
    private static final int MAX_READS_BEHIND_END = 200;
    private static final int APP0 = 0xE0;
    private static final int APP14 = 0xEE;
    private static final int APP15 = 0xEF;
    private static final int COMMENT = 0xFE;
    private static final int START_OF_SCAN = 0xDA;

    private ImageFiles() {
    }

    /** Says whether an image of a size is of use, before it is decoded. */
    @FunctionalInterface
    public interface SizeJudge {
        /**
         * Judges a size.
         *
         * @param widthPx image width, px
         * @param heightPx image height, px
         * @throws InputRefusedException if an image of this size is of no use
         */
        void judge(int widthPx, int heightPx);
    }

    /**
     * Reads an image of any size.
     *
     * @param file an image file
     * @return the image, in an array of its own
     * @throws InputRefusedException as {@link #bytes} and {@link #decode} do
     */
    public static GreyImage read(Path file) {
        return decode(bytes(file), file.toString(), (width, height) -> { });
    }

    /**
     * The bytes of an image file, read once: what is decoded of them and a checksum of them belong together, even where
     * the file changes meanwhile or is a pipe.
     *
     * @param file an image file
     * @return all of it
     * @throws InputRefusedException if it is missing, a folder, empty, not readable or larger than {@value #MAX_BYTES}
     *     bytes; the message names file and remedy
     */
    public static byte[] bytes(Path file) {
        String name = file.toString();
        if (Files.isDirectory(file)) {
            throw new InputRefusedException(name, ImageRefusal.IS_FOLDER);
        }
        byte[] bytes;
        try (InputStream in = Files.newInputStream(file)) {
            bytes = in.readNBytes(MAX_BYTES + 1);
        } catch (NoSuchFileException e) {
            throw refused(e, name, name.indexOf('\uFFFD') < 0 ? ImageRefusal.NO_SUCH_FILE
                    : ImageRefusal.NAME_NOT_UTF_8);
        } catch (AccessDeniedException e) {
            throw refused(e, name, ImageRefusal.NOT_PERMITTED);
        } catch (IOException | OutOfMemoryError e) {
            throw refused(e, name, ImageRefusal.NOT_READABLE, said(e));
        }
        if (bytes.length == 0) {
            throw new InputRefusedException(name, ImageRefusal.EMPTY);
        }
        if (bytes.length > MAX_BYTES) {
            throw new InputRefusedException(name, ImageRefusal.FILE_TOO_LARGE, MAX_BYTES >> 20);
        }
        return bytes;
    }

    /**
     * Decodes an image. The size is taken from the header and judged first, so that a small file cannot claim a huge
     * memory, and no time is spent on a photo that is of no use.
     *
     * @param bytes an image file; kept by nobody
     * @param name the name that messages give it
     * @param size refuses sizes that are of no use
     * @return the image, in an array of its own
     * @throws InputRefusedException if it is of another format, damaged, cut short, larger than {@value #MAX_PIXELS}
     *     pixels, longer than {@value #MAX_SIDE_PX} px, of other colours than grey and RGB, or {@code size} refuses it;
     *     the message names file and remedy
     */
    public static GreyImage decode(byte[] bytes, String name, SizeJudge size) {
        ImageFormat format = ImageFormat.of(bytes).orElseThrow(() ->
                new InputRefusedException(name, ImageRefusal.UNKNOWN_FORMAT, ImageFormat.READABLE));
        if (format == ImageFormat.HEIF) {
            throw new InputRefusedException(name, ImageRefusal.HEIF);
        }
        try {
            ToneCurve toneCurve = StatedToneCurve.of((position, into) -> {
                if (position < 0 || position + into.length > bytes.length) {
                    throw new EOFException();
                }
                System.arraycopy(bytes, (int) position, into, 0, into.length);
            });
            Optional<GreyImage> plain = format == ImageFormat.PNG ? plain(bytes, name, size) : Optional.empty();
            GreyImage image = format == ImageFormat.PNM ? netpbm(bytes, name, size)
                    : plain.isPresent() ? plain.get() : pixels(bytes, format, name, size);
            return image.withToneCurve(toneCurve);
        } catch (IOException e) {
            throw refused(e, name, ImageRefusal.NOT_READABLE, said(e));
        }
    }

    /** The pixels of a PNG file that needs no reader of ImageIO. */
    private static Optional<GreyImage> plain(byte[] bytes, String name, SizeJudge size) {
        Optional<PlainPng> file = PlainPng.of(bytes);
        if (file.isEmpty()) {
            return Optional.empty();
        }
        judge(file.get().widthPx(), file.get().heightPx(), name, size);
        try {
            return file.get().grey();
        } catch (OutOfMemoryError e) {
            throw refused(e, name, ImageRefusal.DAMAGED, said(e));
        }
    }

    private static GreyImage netpbm(byte[] bytes, String name, SizeJudge size) {
        try {
            NetpbmImage image = new NetpbmImage(bytes);
            judge(image.widthPx(), image.heightPx(), name, size);
            return image.grey();
        } catch (DataFormatException | OutOfMemoryError e) {
            throw refused(e, name, ImageRefusal.DAMAGED, said(e));
        } catch (IOException e) {
            throw refused(e, name, ImageRefusal.CUT_SHORT);
        }
    }

    private static void judge(int width, int height, String name, SizeJudge size) {
        if (width < 1 || height < 1 || Math.max(width, height) > MAX_SIDE_PX || (long) width * height > MAX_PIXELS) {
            throw new InputRefusedException(name, ImageRefusal.TOO_LARGE, width, height,
                    (int) (MAX_PIXELS / 1_000_000), MAX_SIDE_PX);
        }
        size.judge(width, height);
    }

    /** The pixels; where a JPEG cannot be read as it is, without the notes that come before them. */
    private static GreyImage pixels(byte[] bytes, ImageFormat format, String name, SizeJudge size) throws IOException {
        try {
            return decoded(bytes, format, name, size);
        } catch (InputRefusedException e) {
            byte[] bare = format == ImageFormat.JPEG && isDamage(e.refusal().kind()) ? withoutNotes(bytes) : null;
            if (bare == null) {
                throw e;
            }
            // the JDK's reader stops at a damaged profile even where nobody asks for it
            try {
                return decoded(bare, format, name, size);
            } catch (InputRefusedException notBecauseOfNotes) {
                throw e;
            }
        }
    }

    private static boolean isDamage(MessageKind kind) {
        return kind == ImageRefusal.DAMAGED || kind == ImageRefusal.PARTLY_DAMAGED || kind == ImageRefusal.CUT_SHORT
                || kind == ImageRefusal.CMYK;
    }

    /**
     * A JPEG file without the segments of notes before its first scan: APP1 to APP13, APP15 and comments (APP0 and
     * APP14 say how its colours are stored). Null for damaged files and those without notes.
     */
    private static byte[] withoutNotes(byte[] all) {
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

    private static GreyImage decoded(byte[] bytes, ImageFormat format, String name, SizeJudge size)
            throws IOException {
        ImageReader reader = format.reader();
        try (ImageInputStream in = new EndingInput(bytes)) {
            // metadata (thumbnails, colour profiles) is not needed, and damaged metadata would stop the reader
            reader.setInput(in, true, true);
            BufferedImage image;
            String[] warning = new String[1];
            reader.addIIOReadWarningListener((source, text) -> {
                if (!isHarmless(text)) {
                    warning[0] = text;
                }
            });
            try {
                int width = reader.getWidth(0);
                int height = reader.getHeight(0);
                if (format == ImageFormat.TIFF) {
                    judgeDepth(reader, name);
                }
                judge(width, height, name, size);
                if (format == ImageFormat.JPEG && !reader.getImageTypes(0).hasNext()) {
                    // the JPEG reader offers no type for CMYK colours it cannot convert
                    throw new InputRefusedException(name, ImageRefusal.CMYK);
                }
                image = reader.read(0);
            } catch (IOException | RuntimeException | OutOfMemoryError e) {
                if (e instanceof InputRefusedException) {
                    throw e;
                }
                // readers throw whatever a damaged file leads them to, unchecked exceptions included
                throw e instanceof EOFException || e.getCause() instanceof EOFException
                        ? refused(e, name, ImageRefusal.CUT_SHORT)
                        : refused(e, name, ImageRefusal.DAMAGED, said(e));
            }
            if (warning[0] != null) {
                throw new InputRefusedException(name, ImageRefusal.PARTLY_DAMAGED, warning[0]);
            }
            return grey(name, image);
        } finally {
            reader.dispose();
        }
    }

    /**
     * The bytes of an image, for readers that take what lies behind the end for zeros: of a file cut short they would
     * make a picture, or never come to an end.
     */
    private static final class EndingInput extends MemoryCacheImageInputStream {
        private int readsBehindEnd;

        EndingInput(byte[] bytes) {
            super(new ByteArrayInputStream(bytes));
        }

        @Override
        public int read() throws IOException {
            return counted(super.read());
        }

        @Override
        public int read(byte[] into, int offset, int length) throws IOException {
            return counted(super.read(into, offset, length));
        }

        private int counted(int found) throws IOException {
            if (found < 0 && ++readsBehindEnd > MAX_READS_BEHIND_END) {
                // as a cause: they catch the exception itself
                throw new IOException("reads on behind its end", new EOFException());
            }
            return found;
        }
    }

    /** Only TIFF has more than 16 bits: of such a photo that is the fault, whatever its size. */
    private static void judgeDepth(ImageReader reader, String name) throws IOException {
        Iterator<ImageTypeSpecifier> types = reader.getImageTypes(0);
        int bits = types.hasNext() ? bits(types.next().getColorModel()) : 0;
        if (bits > MAX_BITS) {
            throw new InputRefusedException(name, ImageRefusal.DEPTH, bits);
        }
    }

    /** What an error says of the file, or an error behind it: faults within a reader speak of its code. */
    private static String said(Throwable error) {
        int depth = 0;
        for (Throwable t = error; t != null && depth < 10; t = t.getCause(), depth++) {
            String message = t.getMessage();
            boolean ofCode = t instanceof NullPointerException || t instanceof IndexOutOfBoundsException
                    || t instanceof ClassCastException || t instanceof NegativeArraySizeException;
            if (!ofCode && message != null && !message.isBlank() && !message.equals("null")) {
                return message.strip();
            }
        }
        return "no reason is given";
    }

    /** Remarks on what comes beside the pixels: previews, colour profiles, metadata. */
    private static boolean isHarmless(String warning) {
        String text = warning.toLowerCase(Locale.ROOT);
        return text.contains("icc") || text.contains("color profile") || text.contains("thumb")
                || text.contains("metadata") || text.contains("jfif");
    }

    private static GreyImage grey(String name, BufferedImage image) {
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
            throw new InputRefusedException(name, ImageRefusal.CMYK);
        }
        boolean isGrey = colourBands == 1 && space == ColorSpace.TYPE_GRAY;
        int bits = bits(colours);
        int type = image.getSampleModel().getTransferType();
        if (!isGrey && (colourBands != 3 || space != ColorSpace.TYPE_RGB)
                || type != DataBuffer.TYPE_BYTE && type != DataBuffer.TYPE_USHORT && type != DataBuffer.TYPE_INT) {
            throw new InputRefusedException(name, ImageRefusal.OTHER_COLOURS);
        }
        Raster raster = image.getRaster();
        int bands = raster.getNumBands();
        if (isGrey && bands == 1 && type == DataBuffer.TYPE_BYTE && bits == BYTE_BITS) {
            raster.getDataElements(0, 0, width, height, grey);
            return GreyImage.packed(grey, width, height);
        }
        int[] row = new int[width * bands];
        double[] scale = new double[bands];
        int usedBits = bits > BYTE_BITS ? usedBits(raster, colourBands, bits, row) : bits;
        for (int b = 0; b < bands; b++) {
            int bandBits = b < colourBands && bits > BYTE_BITS ? usedBits : colours.getComponentSize(b);
            scale[b] = 255.0 / ((1 << bandBits) - 1);
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

    /** Bits of the widest component. */
    private static int bits(ColorModel colours) {
        int bits = 0;
        for (int component : colours.getComponentSize()) {
            bits = Math.max(bits, component);
        }
        return bits;
    }

    /** How many bits the largest colour value takes, of those that cameras have. */
    private static int usedBits(Raster raster, int colourBands, int bits, int[] row) {
        int width = raster.getWidth();
        int bands = raster.getNumBands();
        int largest = 0;
        for (int y = 0; y < raster.getHeight(); y++) {
            raster.getPixels(0, y, width, 1, row);
            for (int i = 0; i < width * bands; i += bands) {
                for (int b = 0; b < colourBands; b++) {
                    largest = Math.max(largest, row[i + b]);
                }
            }
        }
        for (int fewer : BITS_IN_16) {
            if (fewer < bits && largest < 1 << fewer) {
                return fewer;
            }
        }
        return bits;
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

    static double luma(double red, double green, double blue) {
        return 0.299 * red + 0.587 * green + 0.114 * blue;
    }

    /** A refusal for an error; where a limit of the computer is behind it, that is said. */
    private static InputRefusedException refused(Throwable cause, String name, ImageRefusal kind, Object... arguments) {
        Refusal refusal = MachineRefusal.behind(cause).orElseGet(() -> Refusal.of(kind, arguments));
        return new InputRefusedException(refusal.withPlace(Place.of(name)), cause);
    }
}
