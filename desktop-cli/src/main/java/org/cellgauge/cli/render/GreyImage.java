package org.cellgauge.cli.render;

import boofcv.struct.image.GrayU8;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;

/** An 8-bit grey picture, row by row from the top left; immutable. */
public final class GreyImage {
    private final int widthPx;
    private final int heightPx;
    private final byte[] grey;

    GreyImage(int widthPx, int heightPx, byte[] grey) {
        this.widthPx = widthPx;
        this.heightPx = heightPx;
        this.grey = grey;
    }

    /**
     * Width.
     *
     * @return px
     */
    public int widthPx() {
        return widthPx;
    }

    /**
     * Height.
     *
     * @return px
     */
    public int heightPx() {
        return heightPx;
    }

    /**
     * One pixel.
     *
     * @param column from the left
     * @param row from the top
     * @return 0 to 255
     */
    public int get(int column, int row) {
        return grey[row * widthPx + column] & 0xFF;
    }

    /**
     * All pixels.
     *
     * @return a copy, row by row, each byte unsigned
     */
    public byte[] bytes() {
        return grey.clone();
    }

    /**
     * The picture for BoofCV.
     *
     * @return a new image with its own pixels
     */
    public GrayU8 toBoof() {
        GrayU8 image = new GrayU8(widthPx, heightPx);
        System.arraycopy(grey, 0, image.data, 0, grey.length);
        return image;
    }

    /**
     * The picture for {@code javax.imageio}.
     *
     * @return a new image of type {@link BufferedImage#TYPE_BYTE_GRAY} with its own pixels
     */
    public BufferedImage toBufferedImage() {
        BufferedImage image = new BufferedImage(widthPx, heightPx, BufferedImage.TYPE_BYTE_GRAY);
        // the raster's bytes are set directly: setRGB would pass them through a colour space and change them
        System.arraycopy(grey, 0, ((DataBufferByte) image.getRaster().getDataBuffer()).getData(), 0, grey.length);
        return image;
    }
}
