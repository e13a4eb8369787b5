package org.cellgauge.vision;

import boofcv.alg.filter.blur.BlurImageOps;
import boofcv.struct.image.GrayF32;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
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
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Time to find the six or seven markers of the fixtures' photos, 1280 x 720 px, on one thread and on all. All say sRGB
 * but {@code plane-3}, which says nothing.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.SampleTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(1)
public class FixtureDetectionBenchmark {
    private static final int PROCESSORS = Runtime.getRuntime().availableProcessors();

    /** Folder of the fixture. */
    @Param({"lifted-4", "raised-4", "plane-4", "raised-3", "distorted-4", "apriltag-4", "plane-3"})
    public String fixture;

    /** Deviation of noise on the ground, blurred by 0.7 px as texture is, in grey levels; 0 for the photo as it is. */
    @Param("0")
    public int texture;

    private BoofMarkerDetector detector;
    private BoofMarkerDetector ofFrames;
    private BoofMarkerDetector spread;
    private BoofMarkerDetector spreadOfFrames;
    private GreyImage image;
    private GreyImage frame;
    private ExecutorService helpers;

    /**
     * Reads the photo.
     *
     * @throws IOException if it cannot be read
     */
    @Setup
    public void read() throws IOException {
        BoofThreads.useOne();
        Path folder = Path.of(System.getProperty("cellgauge.root"), "fixtures", fixture);
        BufferedImage photo = ImageIO.read(folder.resolve("photo.png").toFile());
        image = GreyImage.packed(((DataBufferByte) photo.getRaster().getDataBuffer()).getData(), photo.getWidth(),
                photo.getHeight());
        Cell cell = CellReader.read(folder.resolve("cell.yaml"));
        if (texture > 0) {
            image = textured(image, BoofMarkerDetector.forCell(cell).detect(image, fixture).markers(), texture);
        }
        if (!fixture.equals("plane-3")) {
            image = image.withToneCurve(ToneCurve.SRGB);
        }
        helpers = Executors.newFixedThreadPool(PROCESSORS);
        detector = BoofMarkerDetector.forCell(cell);
        ofFrames = BoofMarkerDetector.forFrames(cell);
        spread = BoofMarkerDetector.forCell(cell).spread(helpers, PROCESSORS);
        spreadOfFrames = BoofMarkerDetector.forFrames(cell).spread(helpers, PROCESSORS);
        frame = image.withToneCurve(null);
    }

    /** The photo with noise on its ground, but not on markers and the margins about them. */
    private static GreyImage textured(GreyImage photo, List<MarkerObservation> markers, int std) {
        int width = photo.widthPx();
        int height = photo.heightPx();
        GrayF32 noise = new GrayF32(width, height);
        Random random = new Random(1);
        for (int i = 0; i < noise.data.length; i++) {
            noise.data[i] = (float) random.nextGaussian();
        }
        noise = BlurImageOps.gaussian(noise, null, 0.7, 4, null);
        double square = 0;
        for (float n : noise.data) {
            square += n * n / noise.data.length;
        }
        byte[] grey = new byte[width * height];
        for (int y = 0, at = 0; y < height; y++) {
            for (int x = 0; x < width; x++, at++) {
                double added = isNear(markers, x, y) ? 0 : std * noise.data[at] / Math.sqrt(square);
                grey[at] = (byte) Math.max(0, Math.min(255, Math.round(photo.get(x, y) + added)));
            }
        }
        return GreyImage.packed(grey, width, height);
    }

    /** Whether a place lies on a marker or its margin, which reaches some three cells about it. */
    private static boolean isNear(List<MarkerObservation> markers, int x, int y) {
        for (MarkerObservation marker : markers) {
            double[] c = marker.cornersPx();
            double u = (c[0] + c[2] + c[4] + c[6]) / 4;
            double v = (c[1] + c[3] + c[5] + c[7]) / 4;
            double reach = 0;
            for (int i = 0; i < 8; i += 2) {
                reach = Math.max(reach, 1.45 * Math.hypot(c[i] - u, c[i + 1] - v));
            }
            if (Math.hypot(x - u, y - v) < reach) {
                return true;
            }
        }
        return false;
    }

    /** Ends the threads. */
    @TearDown
    public void end() {
        helpers.shutdown();
    }

    /**
     * One photo.
     *
     * @return what was found
     */
    @Benchmark
    public Detections photo() {
        return detector.detect(image, fixture);
    }

    /**
     * The same as a frame of a camera that says nothing of its curve, after others.
     *
     * @return what was found
     */
    @Benchmark
    public Detections frame() {
        return ofFrames.detect(frame, fixture);
    }

    /**
     * One photo, its markers fitted on all processors.
     *
     * @return what was found
     */
    @Benchmark
    public Detections photoSpread() {
        return spread.detect(image, fixture);
    }

    /**
     * A frame, likewise.
     *
     * @return what was found
     */
    @Benchmark
    public Detections frameSpread() {
        return spreadOfFrames.detect(frame, fixture);
    }
}
