package org.cellgauge.desktop;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Optional;
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

    private Pictures() {
    }

    /** A picture as PNG, every pixel kept. */
    public static byte[] png(BufferedImage picture) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        // in memory: the default would keep a copy in a temporary file
        try (MemoryCacheImageOutputStream out = new MemoryCacheImageOutputStream(bytes)) {
            if (!ImageIO.write(picture, "png", out)) {
                throw new IOException("this Java writes no PNG");
            }
        }
        return bytes.toByteArray();
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
        BufferedImage scaled = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = scaled.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
        g.setRenderingHint(RenderingHints.KEY_RENDERING, RenderingHints.VALUE_RENDER_QUALITY);
        g.drawImage(picture, 0, 0, width, height, null);
        g.dispose();
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
}
