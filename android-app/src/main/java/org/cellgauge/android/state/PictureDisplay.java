package org.cellgauge.android.state;

import org.cellgauge.internal.overlay.ImageOrientation;
import org.cellgauge.internal.overlay.LabelWords;
import org.cellgauge.internal.overlay.OverlayStyle;
import org.cellgauge.internal.overlay.ViewFit;

/** How the display shows the picture: turned by what, with how much room, what words and what letters; immutable. */
public final class PictureDisplay {
    /** Before anything is known of the display. */
    static final PictureDisplay UNKNOWN = new PictureDisplay(0, LabelWords.ENGLISH, 0, 0, 0);

    private final int rotationDeg;
    private final LabelWords words;
    private final int roomWidthPx;
    private final int roomHeightPx;
    private final double capHeightPx;

    /**
     * A display.
     *
     * @param rotationDeg rotation of what is drawn from the device's natural orientation: 0, 90, 180 or 270
     * @param words what labels in the picture say
     * @param roomWidthPx width of the room for the picture, px of the display; 0 where it is not known yet
     * @param roomHeightPx its height
     * @param capHeightPx height of a capital letter that can be read well, px of the display
     */
    public PictureDisplay(int rotationDeg, LabelWords words, int roomWidthPx, int roomHeightPx, double capHeightPx) {
        this.rotationDeg = rotationDeg;
        this.words = words;
        this.roomWidthPx = roomWidthPx;
        this.roomHeightPx = roomHeightPx;
        this.capHeightPx = capHeightPx;
    }

    int rotationDeg() {
        return rotationDeg;
    }

    /** The style of an overlay over an image that is shown whole; banner and legend are the screen's own. */
    OverlayStyle style(ImageOrientation orientation, int imageWidthPx, int imageHeightPx) {
        OverlayStyle style = OverlayStyle.PHOTO.withOrientation(orientation).withoutPanels().withLabels(words);
        if (roomWidthPx <= 0 || roomHeightPx <= 0) {
            return style;
        }
        int width = orientation.uprightWidthPx(imageWidthPx, imageHeightPx);
        int height = orientation.uprightHeightPx(imageWidthPx, imageHeightPx);
        return style.legible(width, height, ViewFit.fit(width, height, roomWidthPx, roomHeightPx), capHeightPx);
    }
}
