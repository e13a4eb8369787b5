package org.cellgauge.desktop.render;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Iterator;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.vision.GreyImage;

/** Grey pictures as PNG files. */
public final class GreyPng {
    private static final String NATIVE_FORMAT = "javax_imageio_png_1.0";

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
        return encode(image, ToneCurve.LINEAR);
    }

    /**
     * Encodes a picture with a note on its tone curve, as cameras' files have it: an sRGB chunk, or a gAMA chunk with
     * 1/gamma (ISO/IEC 15948, 11.3.3), or none for a linear one.
     *
     * @param image the picture
     * @param curve its tone curve
     * @return the bytes of the file
     * @throws IOException if this Java cannot write PNG
     */
    public static byte[] encode(GreyImage image, ToneCurve curve) throws IOException {
        BufferedImage picture = picture(image);
        Iterator<ImageWriter> writers = ImageIO.getImageWritersByFormatName("png");
        if (!writers.hasNext()) {
            throw new IOException("this Java has no PNG writer");
        }
        ImageWriter writer = writers.next();
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        // a stream of its own: on a plain output stream ImageIO would put a cache file on the disk
        try (ImageOutputStream stream = new MemoryCacheImageOutputStream(bytes)) {
            IIOMetadata metadata = curve.isLinear() ? null : profile(writer, picture, curve);
            writer.setOutput(stream);
            writer.write(new IIOImage(picture, null, metadata));
        } finally {
            writer.dispose();
        }
        return bytes.toByteArray();
    }

    private static IIOMetadata profile(ImageWriter writer, BufferedImage picture, ToneCurve curve)
            throws IOException {
        IIOMetadata metadata = writer.getDefaultImageMetadata(ImageTypeSpecifier.createFromRenderedImage(picture),
                null);
        IIOMetadataNode chunk;
        if (curve == ToneCurve.SRGB) {
            chunk = new IIOMetadataNode("sRGB");
            chunk.setAttribute("renderingIntent", "Perceptual");
        } else {
            chunk = new IIOMetadataNode("gAMA");
            // the power is the only curve that grows by it: grey of 0.5 is 0.5^(1/gamma)
            double inverseGamma = Math.log(curve.grey(0.5)) / Math.log(0.5);
            chunk.setAttribute("value", String.valueOf(Math.round(1e5 * inverseGamma)));
        }
        IIOMetadataNode root = new IIOMetadataNode(NATIVE_FORMAT);
        root.appendChild(chunk);
        metadata.mergeTree(NATIVE_FORMAT, root);
        return metadata;
    }

    /** The picture as Java has it, its bytes as they are: setRGB would pass them through a colour space. */
    static BufferedImage picture(GreyImage image) {
        BufferedImage picture = new BufferedImage(image.widthPx(), image.heightPx(), BufferedImage.TYPE_BYTE_GRAY);
        byte[] grey = ((DataBufferByte) picture.getRaster().getDataBuffer()).getData();
        for (int row = 0; row < image.heightPx(); row++) {
            System.arraycopy(image.luminance(), image.offset() + row * image.rowStride(), grey, row * image.widthPx(),
                    image.widthPx());
        }
        return picture;
    }
}
