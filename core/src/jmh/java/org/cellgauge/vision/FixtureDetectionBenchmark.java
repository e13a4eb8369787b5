package org.cellgauge.vision;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.io.IOException;
import java.nio.file.Path;
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
        if (!fixture.equals("plane-3")) {
            image = image.withToneCurve(ToneCurve.SRGB);
        }
        Cell cell = CellReader.read(folder.resolve("cell.yaml"));
        helpers = Executors.newFixedThreadPool(PROCESSORS);
        detector = BoofMarkerDetector.forCell(cell);
        ofFrames = BoofMarkerDetector.forFrames(cell);
        spread = BoofMarkerDetector.forCell(cell).spread(helpers, PROCESSORS);
        spreadOfFrames = BoofMarkerDetector.forFrames(cell).spread(helpers, PROCESSORS);
        frame = image.withToneCurve(null);
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
