package org.cellgauge.android.camera;

import java.nio.ByteBuffer;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.vision.GreyImage;

/**
 * Takes the luminance of camera frames over into an array that is used again for every frame: cameras deliver in memory
 * outside of Java's, which the detector cannot read. One bulk copy per frame, rows as far apart as in the camera's.
 */
final class LuminancePlane {
    /** Cameras bend the tones of the frames that they show; how exactly they do not say. */
    private static final ToneCurve START = ToneCurve.SRGB;

    private byte[] bytes = {};

    /**
     * The luminance of a frame.
     *
     * @param plane the first plane of the frame; its position is left as it is
     * @param rowStride bytes from one row to the next
     * @param pixelStride bytes from one pixel to the next; 1 by Android's contract
     * @param widthPx width of the frame
     * @param heightPx height of the frame
     * @return a view of an array that the next call writes over, said to be sRGB: a start, not more
     * @throws IllegalArgumentException if the plane has fewer bytes than such a frame takes, or rows overlap
     */
    GreyImage read(ByteBuffer plane, int rowStride, int pixelStride, int widthPx, int heightPx) {
        if (pixelStride < 1 || widthPx < 1 || heightPx < 1 || rowStride < (widthPx - 1L) * pixelStride + 1) {
            throw new IllegalArgumentException("no plane: " + widthPx + " x " + heightPx + " with strides " + rowStride
                    + " and " + pixelStride);
        }
        // the last row may end with its last pixel
        long length = (long) rowStride * (heightPx - 1) + (long) (widthPx - 1) * pixelStride + 1;
        ByteBuffer source = plane.duplicate();
        if (source.remaining() < length) {
            throw new IllegalArgumentException(widthPx + " x " + heightPx + " px with strides " + rowStride + " and "
                    + pixelStride + " take " + length + " bytes, the plane has " + source.remaining());
        }
        if (bytes.length < length) {
            bytes = new byte[(int) length];
        }
        source.get(bytes, 0, (int) length);
        if (pixelStride == 1) {
            return GreyImage.wrap(bytes, 0, rowStride, widthPx, heightPx).withToneCurve(START);
        }
        for (int y = 0; y < heightPx; y++) {
            int from = y * rowStride;
            int to = y * widthPx;
            for (int x = 0; x < widthPx; x++) {
                // never behind what is still to be read
                bytes[to + x] = bytes[from + x * pixelStride];
            }
        }
        return GreyImage.packed(bytes, widthPx, heightPx).withToneCurve(START);
    }
}
