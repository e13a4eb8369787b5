package org.cellgauge.live;

import org.cellgauge.cell.Cell;
import org.cellgauge.check.CheckUpdate;
import org.cellgauge.check.QuickLook;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.PhotoLight;
import org.cellgauge.warning.Refusal;
import org.jspecify.annotations.Nullable;

/** The frame that figures belong to, and how far its check has come. For one thread. */
final class KeyFrame {
    /** Blur against blur from which on a sharper frame is worth starting anew, before the chains have started. */
    private static final double SHARPER = 1.3;

    final Detections detections;
    final long number;
    final QuickLook quickLook;
    final double tolerancePx;
    final double viewTolerancePx;
    /** Whether a second frame has shown that the camera is held still. */
    boolean settled;
    /** The newest figures. */
    CheckUpdate update;
    /** Why the chains could not run; null while nothing speaks against them. */
    @Nullable Refusal refusal;

    KeyFrame(Cell cell, Detections detections, long number, QuickLook quickLook) {
        this.detections = detections;
        this.number = number;
        this.quickLook = quickLook;
        tolerancePx = Stillness.tolerancePx(detections, quickLook.pixelStdPx());
        viewTolerancePx = Stillness.viewTolerancePx(detections, cell, tolerancePx);
        update = quickLook.update();
    }

    /** Whether another frame of the view is clearly sharper: by the blur that its edges were seen with. */
    boolean isBlurredAgainst(Detections other) {
        PhotoLight mine = detections.light();
        PhotoLight others = other.light();
        return mine != null && others != null && mine.blurPx() > SHARPER * others.blurPx();
    }

    boolean finished() {
        return update.phase() == CheckUpdate.Phase.RESULT || refusal != null;
    }
}
