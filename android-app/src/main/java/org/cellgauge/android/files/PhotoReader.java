package org.cellgauge.android.files;

import android.graphics.Bitmap;
import android.graphics.BitmapFactory;
import android.graphics.Color;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.internal.vision.StatedToneCurve;
import org.cellgauge.vision.GreyImage;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;

/**
 * Reads photos as the command line does: colours become grey by the luma weights of ITU-R BT.601 (0.299, 0.587, 0.114)
 * on the stored values, transparent parts lie on white, a note which way up to show the photo is not followed, and what
 * the file says of its tone curve goes with the photo.
 */
final class PhotoReader {
    /** Largest file that is read, bytes. */
    static final int MAX_BYTES = 64 << 20;
    /** Largest photo that is decoded, in pixels, as on the command line. */
    static final long MAX_PIXELS = 100_000_000;
    /** Memory that a pixel takes while it is decoded and while markers are looked for. */
    private static final int BYTES_PER_PIXEL = 8;
    private static final int CHANNELS = 4;
    private static final int OPAQUE = 255;

    private PhotoReader() {
    }

    /**
     * Reads a photo.
     *
     * @param in a PNG or JPEG file, read to its end but not closed
     * @param name its name, for messages
     * @return its grey values, in an array of their own
     * @throws IOException if it cannot be read
     * @throws InputRefusedException if it is none, damaged, cut short, or too large for this device
     */
    static GreyImage read(InputStream in, String name) throws IOException {
        Runtime runtime = Runtime.getRuntime();
        return read(in, name, runtime.maxMemory() - runtime.totalMemory() + runtime.freeMemory());
    }

    /**
     * Reads a photo.
     *
     * @param in a PNG or JPEG file, read to its end but not closed
     * @param name its name, for messages
     * @param freeBytes memory that there is
     * @return its grey values, in an array of their own
     * @throws IOException if it cannot be read
     * @throws InputRefusedException if it is none, damaged, cut short, or too large for this device
     */
    static GreyImage read(InputStream in, String name, long freeBytes) throws IOException {
        try {
            byte[] file = bytes(in, name);
            ImageHeader.judge(file, name);
            return grey(decoded(file, name, freeBytes)).withToneCurve(StatedToneCurve.of(file));
        } catch (OutOfMemoryError e) {
            throw new InputRefusedException(Refusal.at(Place.of(name), FileRefusal.MEMORY), e);
        }
    }

    private static byte[] bytes(InputStream in, String name) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream(1 << 16);
        byte[] buffer = new byte[1 << 16];
        int n = in.read(buffer);
        while (n >= 0) {
            out.write(buffer, 0, n);
            if (out.size() > MAX_BYTES) {
                throw new InputRefusedException(name, FileRefusal.TOO_LARGE, MAX_BYTES >> 20);
            }
            n = in.read(buffer);
        }
        return out.toByteArray();
    }

    private static Bitmap decoded(byte[] file, String name, long freeBytes) {
        BitmapFactory.Options options = new BitmapFactory.Options();
        options.inJustDecodeBounds = true;
        BitmapFactory.decodeByteArray(file, 0, file.length, options);
        int width = options.outWidth;
        int height = options.outHeight;
        if (width < 1 || height < 1) {
            throw damaged(name);
        }
        long pixels = (long) width * height;
        // the file itself lies in the memory already
        if (pixels > MAX_PIXELS || pixels * BYTES_PER_PIXEL > freeBytes) {
            throw new InputRefusedException(name, FileRefusal.PIXELS, width, height, (int) (freeBytes >> 20));
        }
        options = new BitmapFactory.Options();
        options.inPreferredConfig = Bitmap.Config.ARGB_8888;
        options.inScaled = false;
        // colours as they are stored: neither mixed with black nor taken into another colour space
        options.inPremultiplied = false;
        Bitmap bitmap = BitmapFactory.decodeByteArray(file, 0, file.length, options);
        if (bitmap == null || bitmap.getConfig() != Bitmap.Config.ARGB_8888 || bitmap.getWidth() != width
                || bitmap.getHeight() != height) {
            throw damaged(name);
        }
        return bitmap;
    }

    private static InputRefusedException damaged(String name) {
        return new InputRefusedException(name, FileRefusal.UNUSUAL);
    }

    private static GreyImage grey(Bitmap bitmap) {
        int width = bitmap.getWidth();
        int height = bitmap.getHeight();
        // bytes as they lie in the memory: getPixels would take them through sRGB
        byte[] bytes = new byte[CHANNELS * width * height];
        bitmap.copyPixelsToBuffer(ByteBuffer.wrap(bytes));
        bitmap.recycle();
        int[] order = channelOrder();
        byte[] grey = new byte[width * height];
        for (int i = 0; i < grey.length; i++) {
            int at = CHANNELS * i;
            double value = 0.299 * (bytes[at + order[0]] & 0xFF) + 0.587 * (bytes[at + order[1]] & 0xFF)
                    + 0.114 * (bytes[at + order[2]] & 0xFF);
            int alpha = bytes[at + order[3]] & 0xFF;
            if (alpha != OPAQUE) {
                double share = alpha / (double) OPAQUE;
                value = share * value + (1 - share) * OPAQUE;
            }
            grey[i] = (byte) Math.round(value);
        }
        return GreyImage.packed(grey, width, height);
    }

    /** Where red, green, blue and alpha of a pixel stand: in this order on devices, in another one on a desktop. */
    private static int[] channelOrder() {
        Bitmap probe = Bitmap.createBitmap(1, 1, Bitmap.Config.ARGB_8888);
        probe.setPixel(0, 0, Color.rgb(1, 2, 3));
        byte[] bytes = new byte[CHANNELS];
        probe.copyPixelsToBuffer(ByteBuffer.wrap(bytes));
        probe.recycle();
        int[] order = new int[CHANNELS];
        for (int i = 0; i < CHANNELS; i++) {
            order[(bytes[i] & 0xFF) == OPAQUE ? CHANNELS - 1 : bytes[i] - 1] = i;
        }
        return order;
    }
}
