package org.cellgauge.desktop;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.MemoryCacheImageInputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Pictures as files: encoding and scaling. */
public final class Pictures {
    private static final float JPEG_QUALITY = 0.85f;
    private static final long PNG_SIGNATURE = 0x89504E470D0A1A0AL;
    /** Bits, colour type, and the only compression, filters and order that a header may name besides interlaced. */
    private static final byte[] RGB_OF_8_BITS = {8, 2, 0, 0, 0};
    /** For unfiltered photos as small as the usual 4, and quicker by a third. */
    private static final int DEFLATE_LEVEL = 2;

    private Pictures() {
    }

    /**
     * A picture as PNG (ISO/IEC 15948), every pixel kept: 8 bits of red, green and blue, rows as they are. ImageIO
     * tries five filters for each row, which takes longer and, for a photo with drawings on it, saves nothing.
     *
     * @param picture an opaque picture
     * @return the file
     */
    public static byte[] png(BufferedImage picture) {
        int width = picture.getWidth();
        int height = picture.getHeight();
        ByteArrayOutputStream bytes = new ByteArrayOutputStream(width * height);
        try (DataOutputStream out = new DataOutputStream(bytes)) {
            out.writeLong(PNG_SIGNATURE);
            chunk(out, "IHDR", ByteBuffer.allocate(13).putInt(width).putInt(height).put(RGB_OF_8_BITS).array());
            chunk(out, "IDAT", deflatedRows(picture));
            chunk(out, "IEND", new byte[0]);
        } catch (IOException e) {
            throw new UncheckedIOException("writing into memory failed", e);
        }
        return bytes.toByteArray();
    }

    private static void chunk(DataOutputStream out, String type, byte[] data) throws IOException {
        byte[] name = type.getBytes(StandardCharsets.US_ASCII);
        CRC32 check = new CRC32();
        check.update(name);
        check.update(data);
        out.writeInt(data.length);
        out.write(name);
        out.write(data);
        out.writeInt((int) check.getValue());
    }

    private static byte[] deflatedRows(BufferedImage picture) throws IOException {
        int width = picture.getWidth();
        ByteArrayOutputStream bytes = new ByteArrayOutputStream(width * picture.getHeight());
        Deflater deflater = new Deflater(DEFLATE_LEVEL);
        try (DeflaterOutputStream out = new DeflaterOutputStream(bytes, deflater, 1 << 14)) {
            int[] rgb = new int[width];
            // the first byte says that no filter was applied
            byte[] row = new byte[1 + 3 * width];
            for (int y = 0; y < picture.getHeight(); y++) {
                rgb = row(picture, y, rgb);
                for (int x = 0; x < width; x++) {
                    row[3 * x + 1] = (byte) (rgb[x] >> 16);
                    row[3 * x + 2] = (byte) (rgb[x] >> 8);
                    row[3 * x + 3] = (byte) rgb[x];
                }
                out.write(row);
            }
        } finally {
            deflater.end();
        }
        return bytes.toByteArray();
    }

    /** A row of colours; of pictures that keep them so, without a look at every pixel's colour model. */
    private static int[] row(BufferedImage picture, int y, int[] into) {
        return picture.getType() == BufferedImage.TYPE_INT_RGB
                ? (int[]) picture.getRaster().getDataElements(0, y, picture.getWidth(), 1, into)
                : picture.getRGB(0, y, picture.getWidth(), 1, into, 0, picture.getWidth());
    }

    /**
     * A picture of ours read back.
     *
     * @param png what {@link #png} gave
     * @param widthPx its width, px
     * @param heightPx its height, px
     * @return the picture; empty where it is none of this size: that is not decoded
     * @throws IOException if it is damaged
     */
    static Optional<BufferedImage> read(byte[] png, int widthPx, int heightPx) throws IOException {
        ImageReader reader = ImageFormat.PNG.reader();
        try (MemoryCacheImageInputStream in = new MemoryCacheImageInputStream(new ByteArrayInputStream(png))) {
            reader.setInput(in);
            return reader.getWidth(0) == widthPx && reader.getHeight(0) == heightPx ? Optional.of(reader.read(0))
                    : Optional.empty();
        } finally {
            reader.dispose();
        }
    }

    /** A picture as JPEG, scaled down to a width where it is wider. */
    public static byte[] jpeg(BufferedImage picture, int maxWidthPx) throws IOException {
        int width = Math.min(maxWidthPx, picture.getWidth());
        int height = Math.max(1, (int) Math.round((double) picture.getHeight() * width / picture.getWidth()));
        BufferedImage scaled = width == picture.getWidth() ? picture : scaled(picture, width, height);
        ImageWriter writer = ImageIO.getImageWritersByFormatName("jpeg").next();
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (MemoryCacheImageOutputStream out = new MemoryCacheImageOutputStream(bytes)) {
            writer.setOutput(out);
            ImageWriteParam param = writer.getDefaultWriteParam();
            param.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
            param.setCompressionQuality(JPEG_QUALITY);
            writer.write(null, new IIOImage(scaled, null, null), param);
        } finally {
            writer.dispose();
        }
        return bytes.toByteArray();
    }

    private static BufferedImage scaled(BufferedImage picture, int width, int height) {
        BufferedImage scaled = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = scaled.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
        g.setRenderingHint(RenderingHints.KEY_RENDERING, RenderingHints.VALUE_RENDER_QUALITY);
        g.drawImage(picture, 0, 0, width, height, null);
        g.dispose();
        return scaled;
    }
}
