package org.cellgauge.desktop.render;

import java.awt.image.BufferedImage;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Iterator;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.cellgauge.vision.GreyImage;

/** Grey pictures as JPEG files of one component, without chroma. */
public final class GreyJpeg {
    private GreyJpeg() {
    }

    /**
     * Encodes a picture.
     *
     * @param image the picture
     * @param quality 1 to 100, on the usual scale of the IJG's library
     * @return the bytes of the file
     * @throws IOException if this Java cannot write JPEG
     * @throws IllegalArgumentException if the quality is out of range
     */
    public static byte[] encode(GreyImage image, int quality) throws IOException {
        if (quality < 1 || quality > 100) {
            throw new IllegalArgumentException("JPEG quality must be between 1 and 100, not " + quality);
        }
        Iterator<ImageWriter> writers = ImageIO.getImageWritersByFormatName("jpeg");
        if (!writers.hasNext()) {
            throw new IOException("this Java has no JPEG writer");
        }
        ImageWriter writer = writers.next();
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ImageOutputStream stream = new MemoryCacheImageOutputStream(bytes)) {
            ImageWriteParam parameters = writer.getDefaultWriteParam();
            parameters.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
            parameters.setCompressionQuality(quality / 100f);
            writer.setOutput(stream);
            writer.write(null, new IIOImage(GreyPng.picture(image), null, null), parameters);
        } finally {
            writer.dispose();
        }
        return bytes.toByteArray();
    }

    /**
     * What is left of a picture once it was a JPEG file.
     *
     * @param image the picture
     * @param quality 1 to 100
     * @return the picture as decoded
     * @throws IOException if this Java cannot write or read JPEG
     * @throws IllegalArgumentException if the quality is out of range
     */
    public static GreyImage roundTrip(GreyImage image, int quality) throws IOException {
        Iterator<ImageReader> readers = ImageIO.getImageReadersByFormatName("jpeg");
        if (!readers.hasNext()) {
            throw new IOException("this Java has no JPEG reader");
        }
        ImageReader reader = readers.next();
        try (ImageInputStream stream = new MemoryCacheImageInputStream(
                new ByteArrayInputStream(encode(image, quality)))) {
            reader.setInput(stream, true, true);
            BufferedImage picture = reader.read(0);
            Raster raster = picture.getRaster();
            int[] row = new int[image.widthPx()];
            byte[] grey = new byte[image.widthPx() * image.heightPx()];
            for (int y = 0; y < image.heightPx(); y++) {
                raster.getSamples(0, y, row.length, 1, 0, row);
                for (int x = 0; x < row.length; x++) {
                    grey[y * row.length + x] = (byte) row[x];
                }
            }
            return GreyImage.packed(grey, image.widthPx(), image.heightPx());
        } finally {
            reader.dispose();
        }
    }
}
