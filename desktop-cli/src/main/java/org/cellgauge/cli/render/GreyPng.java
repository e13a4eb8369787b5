package org.cellgauge.cli.render;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import javax.imageio.ImageIO;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.cellgauge.vision.GreyImage;

/** Grey pictures as PNG files. */
public final class GreyPng {
    private GreyPng() {
    }

    /**
     * Encodes a picture as a PNG of 8 bits of grey per pixel, without loss.
     *
     * @param image the picture
     * @return the bytes of the file
     * @throws IOException if this Java cannot write PNG
     */
    public static byte[] encode(GreyImage image) throws IOException {
        BufferedImage picture = new BufferedImage(image.widthPx(), image.heightPx(), BufferedImage.TYPE_BYTE_GRAY);
        // the raster's bytes are set directly: setRGB would pass them through a colour space and change them
        byte[] grey = ((DataBufferByte) picture.getRaster().getDataBuffer()).getData();
        for (int row = 0; row < image.heightPx(); row++) {
            System.arraycopy(image.luminance(), image.offset() + row * image.rowStride(), grey, row * image.widthPx(),
                    image.widthPx());
        }
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        // a stream of its own: on a plain output stream ImageIO would put a cache file on the disk
        try (ImageOutputStream stream = new MemoryCacheImageOutputStream(bytes)) {
            if (!ImageIO.write(picture, "png", stream)) {
                throw new IOException("this Java has no PNG writer");
            }
        }
        return bytes.toByteArray();
    }
}
