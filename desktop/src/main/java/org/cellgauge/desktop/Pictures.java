package org.cellgauge.desktop;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.DataBufferByte;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.zip.CRC32;
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
    /** Length, type and check sum of a PNG's chunk, bytes. */
    private static final int ABOUT_CHUNK = 12;
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
     * @param besides runs what can be done beside the rest; the file is the same on whatever thread
     * @return the file
     */
    public static byte[] png(BufferedImage picture, Executor besides) {
        int width = picture.getWidth();
        int height = picture.getHeight();
        byte[] head = ByteBuffer.allocate(13).putInt(width).putInt(height).put(RGB_OF_8_BITS).array();
        // a zero before each row says that no filter was applied
        byte[] data = TwoPartDeflate.zlib(height, 1 + 3 * width, () -> {
            int[] row = new int[width];
            return (y, into) -> rgb(picture, y, row, into, 1);
        }, DEFLATE_LEVEL, besides);
        ByteBuffer file = ByteBuffer.allocate(Long.BYTES + 3 * ABOUT_CHUNK + head.length + data.length);
        file.putLong(PNG_SIGNATURE);
        putChunk(file, "IHDR", head);
        putChunk(file, "IDAT", data);
        putChunk(file, "IEND", new byte[0]);
        return file.array();
    }

    private static void putChunk(ByteBuffer file, String type, byte[] data) {
        byte[] name = type.getBytes(StandardCharsets.US_ASCII);
        CRC32 check = new CRC32();
        check.update(name);
        check.update(data);
        file.putInt(data.length).put(name).put(data).putInt((int) check.getValue());
    }

    /** Puts red, green and blue of a row of pixels into an array, from a place on, by way of another. */
    private static void rgb(BufferedImage picture, int y, int[] row, byte[] into, int from) {
        int width = picture.getWidth();
        // of pictures that keep them so, without a look at every pixel's colour model
        if (picture.getType() == BufferedImage.TYPE_INT_RGB) {
            picture.getRaster().getDataElements(0, y, width, 1, row);
        } else {
            picture.getRGB(0, y, width, 1, row, 0, width);
        }
        for (int x = 0, at = from; x < width; x++, at += 3) {
            into[at] = (byte) (row[x] >> 16);
            into[at + 1] = (byte) (row[x] >> 8);
            into[at + 2] = (byte) row[x];
        }
    }

    /** The same picture as bytes, which ImageIO's JPEG takes by the row; others pixel by pixel. */
    private static BufferedImage ofBytes(BufferedImage picture) {
        int width = picture.getWidth();
        byte[] rgb = new byte[3 * width * picture.getHeight()];
        int[] row = new int[width];
        for (int y = 0; y < picture.getHeight(); y++) {
            rgb(picture, y, row, rgb, 3 * width * y);
        }
        WritableRaster raster = Raster.createInterleavedRaster(new DataBufferByte(rgb, rgb.length), width,
                picture.getHeight(), 3 * width, 3, new int[] {0, 1, 2}, null);
        return new BufferedImage(new ComponentColorModel(ColorSpace.getInstance(ColorSpace.CS_sRGB), false, false,
                Transparency.OPAQUE, DataBuffer.TYPE_BYTE), raster, false, null);
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
            writer.write(null, new IIOImage(ofBytes(scaled), null, null), param);
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
