package org.cellgauge.android.files;

import android.graphics.Bitmap;
import org.cellgauge.internal.overlay.Overlay;
import org.cellgauge.vision.GreyImage;

/** Paints what a check found over the photo that it was found in. */
@FunctionalInterface
public interface OverlayPicture {
    /**
     * Paints an overlay over a photo.
     *
     * @param photo the photo
     * @param overlay what to draw, in px of the photo
     * @return a bitmap of the photo's size, for the caller to recycle
     */
    Bitmap paint(GreyImage photo, Overlay overlay);
}
