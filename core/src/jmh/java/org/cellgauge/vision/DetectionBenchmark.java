package org.cellgauge.vision;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.vision.BoofThreads;
import org.cellgauge.light.ToneCurve;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** Time to find eight markers in an image of 1280 x 720 px, on one thread, by ground, lens and tone curve. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(1)
public class DetectionBenchmark {
    private static final int WIDTH = 1280;
    private static final int HEIGHT = 720;
    private static final Integer[] IDS = {5, 20, 22, 30, 911, 944, 1234, 2000};
    private static final int CELL_PX = 4;
    private static final int MARGIN_PX = 8;
    /** Of the lens, a standard deviation, and how far from a pixel it is seen. */
    private static final double BLUR_PX = 0.7;
    private static final int REACH_PX = 4;
    private static final double LIGHT_OF_WHITE = 0.8;
    private static final double LIGHT_OF_GROUND = 0.5;
    private static final double LIGHT_OF_BLACK = 0.1;

    /** Deviation of the ground's grey from pixel to pixel; markers have 2 everywhere. */
    @Param({"2", "15"})
    public int groundNoise;

    /** First radial coefficient of the lens. */
    @Param({"0", "-0.3"})
    public double k1;

    /**
     * The curve that makes grey of light, and whether the detector is told: "linear" and "srgb" are to be found out.
     */
    @Param({"linear", "srgb", "srgb stated"})
    public String light;

    private BoofMarkerDetector detector;
    private GreyImage image;

    /** Draws upright markers of 32 px on a grey ground, blurred as by a lens, so that edges tell the curve. */
    @Setup
    public void draw() {
        BoofThreads.useOne();
        Random random = new Random(1);
        double[] sharp = new double[WIDTH * HEIGHT];
        Arrays.fill(sharp, LIGHT_OF_GROUND);
        boolean[] marked = new boolean[WIDTH * HEIGHT];
        FamilyPatterns patterns = new FamilyPatterns(MarkerFamily.SQUARE_BINARY);
        int size = patterns.grid().bands() * CELL_PX;
        for (int m = 0; m < IDS.length; m++) {
            boolean[] white = patterns.white(IDS[m]);
            int left = 200 + m % 4 * 250;
            int top = 200 + m / 4 * 250;
            for (int y = -MARGIN_PX; y < size + MARGIN_PX; y++) {
                for (int x = -MARGIN_PX; x < size + MARGIN_PX; x++) {
                    boolean inside = x >= 0 && y >= 0 && x < size && y < size;
                    boolean bright = !inside || white[y / CELL_PX * patterns.grid().bands() + x / CELL_PX];
                    sharp[(top + y) * WIDTH + left + x] = bright ? LIGHT_OF_WHITE : LIGHT_OF_BLACK;
                    marked[(top + y) * WIDTH + left + x] = true;
                }
            }
        }
        ToneCurve curve = ToneCurve.of(light.startsWith("srgb") ? "srgb" : "linear");
        byte[] grey = new byte[WIDTH * HEIGHT];
        for (int i = 0; i < grey.length; i++) {
            double level = 255 * curve.grey(marked[i] ? blurred(sharp, i) : LIGHT_OF_GROUND);
            grey[i] = grey(level, marked[i] ? 2 : groundNoise, random);
        }
        image = GreyImage.packed(grey, WIDTH, HEIGHT);
        double[] values = PinholeCamera.ideal(WIDTH, HEIGHT, 581, 581, WIDTH / 2.0, HEIGHT / 2.0).intrinsics();
        values[BrownLens.K1] = k1;
        List<Integer> ids = Arrays.asList(IDS);
        detector = new BoofMarkerDetector(PinholeCamera.of(WIDTH, HEIGHT, values), MarkerFamily.SQUARE_BINARY, ids,
                BoofMarkerDetector.RESIDUAL_LIMIT_PER_SIDE, light.endsWith("stated") ? ToneCurve.SRGB : null);
    }

    /** By a Gaussian, as lenses and pixels do it. */
    private static double blurred(double[] sharp, int at) {
        double sum = 0;
        for (int y = -REACH_PX; y <= REACH_PX; y++) {
            for (int x = -REACH_PX; x <= REACH_PX; x++) {
                sum += sharp[at + y * WIDTH + x] * share(x) * share(y);
            }
        }
        return sum;
    }

    /**
     * Share of a pixel's light, of which each point is spread by a Gaussian, that falls on the pixel so many further:
     * the second difference of the integral of the normal distribution.
     */
    private static double share(int pixels) {
        return integral(pixels + 1) - 2 * integral(pixels) + integral(pixels - 1);
    }

    private static double integral(double x) {
        double z = x / BLUR_PX;
        double density = Math.exp(-0.5 * z * z) / Math.sqrt(2 * Math.PI);
        return x * EdgeProfile.cumulative(z) + BLUR_PX * density;
    }

    private static byte grey(double mean, double deviation, Random random) {
        return (byte) Math.max(0, Math.min(255, Math.round(mean + deviation * random.nextGaussian())));
    }

    /**
     * One frame.
     *
     * @return what was found
     */
    @Benchmark
    public Detections frame() {
        return detector.detect(image, "frame");
    }
}
