package org.cellgauge.desktop;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.List;
import org.cellgauge.internal.overlay.Overlay;
import org.cellgauge.internal.overlay.Polyline;
import org.cellgauge.internal.overlay.Role;
import org.cellgauge.internal.overlay.Status;

/**
 * Loads what reads and paints pictures while options and cell file are read: Java's part of both takes longer to begin
 * than the work on a photo, and a second processor has nothing to do until then. It changes no result.
 */
public final class EarlyStart {
    private static final int SIDE_PX = 16;

    private EarlyStart() {
    }

    /**
     * Begins, in a thread of its own, where there is a second processor.
     *
     * @param paints whether overlays will be painted, or photos read alone
     */
    public static void begin(boolean paints) {
        if (Runtime.getRuntime().availableProcessors() > 1) {
            Thread thread = new Thread(() -> load(paints), "cellgauge-ahead");
            thread.setDaemon(true);
            thread.start();
        }
    }

    private static void load(boolean paints) {
        try {
            BufferedImage black = new BufferedImage(SIDE_PX, SIDE_PX, BufferedImage.TYPE_INT_RGB);
            byte[] photo = Pictures.png(black);
            Sha256.of(photo);
            ImageFiles.decode(photo, "", (width, height) -> { });
            if (paints) {
                Polyline line = new Polyline(Role.OBJECT_OUTLINE, Status.PASS, 0, false, 1, 1.5, SIDE_PX - 1, 9);
                Overlay overlay = new Overlay(SIDE_PX, SIDE_PX, Status.PASS, 1, 1, List.of(line));
                Pictures.jpeg(OverlayPainter.paint(black, overlay), SIDE_PX);
            }
        } catch (IOException | RuntimeException e) {
            // whoever needs it will come upon it again, and tell
        }
    }
}
