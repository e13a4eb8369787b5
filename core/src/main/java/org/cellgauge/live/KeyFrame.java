package org.cellgauge.live;

import org.cellgauge.check.CheckUpdate;
import org.cellgauge.check.QuickLook;
import org.cellgauge.vision.Detections;
import org.cellgauge.warning.Refusal;
import org.jspecify.annotations.Nullable;

/** The frame that figures belong to, and how far its check has come. For one thread. */
final class KeyFrame {
    final Detections detections;
    final long number;
    final QuickLook quickLook;
    final double tolerancePx;
    /** Whether a second frame has shown that the camera is held still. */
    boolean settled;
    /** The newest figures. */
    CheckUpdate update;
    /** Why the chains could not run; null while nothing speaks against them. */
    @Nullable Refusal refusal;

    KeyFrame(Detections detections, long number, QuickLook quickLook) {
        this.detections = detections;
        this.number = number;
        this.quickLook = quickLook;
        tolerancePx = Stillness.tolerancePx(detections, quickLook.pixelStdPx());
        update = quickLook.update();
    }

    boolean finished() {
        return update.phase() == CheckUpdate.Phase.RESULT || refusal != null;
    }
}
