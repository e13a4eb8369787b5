package org.cellgauge.desktop.render;

/**
 * The sharpening filter of phones: {@code grey + amount (grey - blurred grey)}, which overshoots on both sides of an
 * edge. The blur is a Gaussian sampled at whole pixels and cut off at four deviations; beyond its border the image goes
 * on as at the border. Immutable.
 */
final class UnsharpMask {
    private static final double REACH = 4;

    private final double amount;
    /** Weights of the pixel itself and of those 1, 2, … px away. */
    private final double[] weights;

    private UnsharpMask(double amount, double radiusPx) {
        this.amount = amount;
        weights = new double[(int) Math.ceil(REACH * radiusPx) + 1];
        double total = 0;
        for (int k = 0; k < weights.length; k++) {
            weights[k] = Math.exp(-0.5 * k * k / (radiusPx * radiusPx));
            total += k == 0 ? weights[k] : 2 * weights[k];
        }
        for (int k = 0; k < weights.length; k++) {
            weights[k] /= total;
        }
    }

    static UnsharpMask of(Sensor sensor) {
        return new UnsharpMask(sensor.unsharpAmount(), sensor.unsharpRadiusPx());
    }

    /** Pixels from which a pixel takes something, to each side. */
    int reachPx() {
        return weights.length - 1;
    }

    /**
     * Sharpens.
     *
     * @param grey levels of a picture, row by row, 0 to 255
     * @param width its width
     * @param height its height
     * @param out receives the result, cut off at 0 and 255 and rounded
     */
    void apply(float[] grey, int width, int height, byte[] out) {
        float[] sharpened = new float[grey.length];
        apply(grey, width, height, sharpened);
        for (int i = 0; i < out.length; i++) {
            out[i] = (byte) Math.min(255, Math.max(0, Math.round(sharpened[i])));
        }
    }

    /**
     * Sharpens what a picture is made of, noise alone for instance.
     *
     * @param grey values, row by row
     * @param width its width
     * @param height its height
     * @param out receives the result, neither cut off nor rounded
     */
    void apply(float[] grey, int width, int height, float[] out) {
        float[] alongRows = new float[grey.length];
        for (int row = 0; row < height; row++) {
            int start = row * width;
            for (int column = 0; column < width; column++) {
                double sum = weights[0] * grey[start + column];
                for (int k = 1; k < weights.length; k++) {
                    sum += weights[k] * (grey[start + Math.max(0, column - k)]
                            + grey[start + Math.min(width - 1, column + k)]);
                }
                alongRows[start + column] = (float) sum;
            }
        }
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                double sum = weights[0] * alongRows[row * width + column];
                for (int k = 1; k < weights.length; k++) {
                    sum += weights[k] * (alongRows[Math.max(0, row - k) * width + column]
                            + alongRows[Math.min(height - 1, row + k) * width + column]);
                }
                double level = grey[row * width + column];
                out[row * width + column] = (float) (level + amount * (level - sum));
            }
        }
    }
}
