package org.cellgauge.desktop;

import io.reactivex.rxjava3.core.Flowable;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.time.LocalDate;
import java.util.List;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.overlay.CellOverlay;
import org.cellgauge.internal.overlay.Overlay;
import org.cellgauge.internal.overlay.Status;
import org.cellgauge.internal.statistics.CoverageRegion;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.vision.BoofMarkerDetector;
import org.cellgauge.vision.Detections;

/**
 * Loads what reads cell files and pictures, paints pictures, and sums up while options are read: to begin takes all of
 * it longer than the work on a photo, and a second processor has nothing to do until then. It changes no result.
 * Markers are not looked for ahead: options are read by then, and the two would wait for each other.
 */
public final class EarlyStart {
    private static final int SIDE_PX = 64;
    /** Of a picture with so much text that what paints it is compiled by the time it is needed. */
    private static final int WIDTH_PX = 640;
    private static final int HEIGHT_PX = 180;
    private static final String CELL = "cellgauge: 1\nmarkers: {family: square-binary, size_mm: 50}\n"
            + "placement: {std_mm: [1, 1, 1], std_deg: 0.2}\n"
            + "references:\n  1: {position_mm: [0, 0, 0], rotation_deg: [0, 0, 0]}\nobjects:\n  2: {}\n"
            + "target: {std_mm: 1}\n";

    private EarlyStart() {
    }

    /**
     * Begins, in a thread of its own, where there is a second processor.
     *
     * @param paints whether overlays will be painted
     * @param decodes whether photos may be of formats that ImageIO reads
     */
    public static void begin(boolean paints, boolean decodes) {
        if (Runtime.getRuntime().availableProcessors() > 1) {
            Thread thread = new Thread(() -> {
                try {
                    load(paints, decodes);
                } catch (IOException | RuntimeException e) {
                    // whoever needs it will come upon it again, and tell
                }
            }, "cellgauge-ahead");
            thread.setDaemon(true);
            thread.start();
        }
    }

    /** Loads all of it, in the order of its turn. */
    static void load(boolean paints, boolean decodes) throws IOException {
        Cell cell = CellReader.read(CELL, "", PinholeCamera.of(SIDE_PX, SIDE_PX,
                new double[] {SIDE_PX, SIDE_PX, SIDE_PX / 2.0, SIDE_PX / 2.0, 0, 0, 0, 0, 0, 0}));
        // the offset of the time zone
        LocalDate.now(LocalClock.now());
        new StopSignal();
        Sha256.of(new byte[1]);
        if (decodes) {
            ImageFiles.decode(Pictures.jpeg(black(), SIDE_PX), "", (width, height) -> { });
        }
        BoofMarkerDetector.forCell(cell);
        // of the pose, of chains, and of what is said of them
        CoverageRegion.chiSquareQuantile(0.5, 8);
        Flowable.empty();
        String.format(Decimal.POINT, "%.1f", 1.0);
        if (paints) {
            Overlay overlay = CellOverlay.ofDetections(cell, new Detections("", SIDE_PX, SIDE_PX, List.of()),
                    Status.PASS, "PASS", "");
            BufferedImage painted = OverlayPainter.paint(black(), overlay);
            Pictures.jpeg(painted, SIDE_PX);
            Pictures.png(painted, Runnable::run);
            // a processor is free now, and what is painted over a photo is lines of text for the most part
            OverlayPainter.paint(new BufferedImage(WIDTH_PX, HEIGHT_PX, BufferedImage.TYPE_INT_RGB),
                    CellOverlay.ofDetections(cell, new Detections("", WIDTH_PX, HEIGHT_PX, List.of()), Status.PASS,
                            "PASS", "The quick brown fox jumps over the lazy dog and 0123456789 more, it says."));
        }
    }

    private static BufferedImage black() {
        return new BufferedImage(SIDE_PX, SIDE_PX, BufferedImage.TYPE_INT_RGB);
    }
}
