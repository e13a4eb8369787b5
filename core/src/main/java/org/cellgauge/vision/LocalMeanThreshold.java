package org.cellgauge.vision;

import boofcv.abst.filter.binary.InputToBinary;
import boofcv.struct.image.GrayU8;
import boofcv.struct.image.ImageType;

/**
 * Marks pixels that are darker than a share of the mean about them, as BoofCV's local mean does, in one pass: sums of
 * columns slide down the image and their sum along each row. BoofCV's own blurs the whole image twice first, which
 * takes half of the time to find markers in a plain scene. Not thread-safe: the sums are kept.
 */
final class LocalMeanThreshold implements InputToBinary<GrayU8> {
    private final int radius;
    private final int percent;
    private int[] columns = new int[0];

    /**
     * A threshold.
     *
     * @param radius pixels on each side of a pixel that its mean is over; at the border, those that there are
     * @param percent of the mean at which black begins
     */
    LocalMeanThreshold(int radius, int percent) {
        this.radius = radius;
        this.percent = percent;
    }

    @Override
    public void process(GrayU8 input, GrayU8 output) {
        int width = input.width;
        int height = input.height;
        output.reshape(width, height);
        if (columns.length < width) {
            columns = new int[width];
        }
        java.util.Arrays.fill(columns, 0, width, 0);
        for (int y = 0; y < Math.min(radius, height); y++) {
            add(input, y, 1);
        }
        byte[] in = input.data;
        byte[] out = output.data;
        int[] sums = columns;
        for (int y = 0; y < height; y++) {
            if (y + radius < height) {
                add(input, y + radius, 1);
            }
            if (y - radius - 1 >= 0) {
                add(input, y - radius - 1, -1);
            }
            int rows = Math.min(height - 1, y + radius) - Math.max(0, y - radius) + 1;
            int sum = 0;
            for (int x = 0; x < Math.min(radius, width); x++) {
                sum += sums[x];
            }
            int from = input.startIndex + y * input.stride;
            int to = output.startIndex + y * output.stride;
            int first = Math.min(width, radius + 1);
            int last = Math.max(first, width - radius);
            sum = border(0, first, sum, rows, in, from, out, to, width);
            int whole = rows * (2 * radius + 1) * 100;
            for (int x = first; x < last; x++) {
                sum += sums[x + radius] - sums[x - radius - 1];
                out[to + x] = (byte) ((percent * sum - (in[from + x] & 0xFF) * whole >>> 31) ^ 1);
            }
            border(last, width, sum, rows, in, from, out, to, width);
        }
    }

    /** Pixels whose window is cut off on the left or right. */
    private int border(int first, int last, int sumBefore, int rows, byte[] in, int from, byte[] out, int to,
            int width) {
        int sum = sumBefore;
        for (int x = first; x < last; x++) {
            int right = x + radius;
            int left = x - radius - 1;
            sum += right < width ? columns[right] : 0;
            sum -= left >= 0 ? columns[left] : 0;
            int count = rows * (Math.min(width - 1, right) - Math.max(0, left + 1) + 1);
            out[to + x] = (byte) ((in[from + x] & 0xFF) * count * 100 <= percent * sum ? 1 : 0);
        }
        return sum;
    }

    private void add(GrayU8 input, int y, int sign) {
        byte[] in = input.data;
        int from = input.startIndex + y * input.stride;
        int[] sums = columns;
        if (sign > 0) {
            for (int x = 0; x < input.width; x++) {
                sums[x] += in[from + x] & 0xFF;
            }
        } else {
            for (int x = 0; x < input.width; x++) {
                sums[x] -= in[from + x] & 0xFF;
            }
        }
    }

    @Override
    public ImageType<GrayU8> getInputType() {
        return ImageType.SB_U8;
    }
}
