package org.cellgauge.android.state;

import org.cellgauge.android.files.Photo;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.GreyImage;

/**
 * Pixels of the newest frames, until it is known which of them the figures belong to: the camera uses its arrays again,
 * and a check chooses its key frame a little after it came. The chosen one stays until another is chosen, so that its
 * pixels can be taken when they are wanted; arrays that nobody took are used again, and while the camera moves none is
 * made.
 */
final class RecentFrames {
    /** Large frames are kept in smaller number: the whole app may have no more than 200 MB. */
    private static final long MOST_BYTES = 24_000_000;
    private static final int FEWEST = 2;

    private final Detections[] detections;
    private final byte[][] luminance;
    private final ToneCurve[] toneCurves;
    private int next;
    private Detections chosen;
    private Photo taken;
    private Detections takenDetections;

    /**
     * Room for some frames.
     *
     * @param count how many frames may come between a frame and its choice, besides the one that was chosen last
     */
    RecentFrames(int count) {
        this.detections = new Detections[count + 1];
        this.luminance = new byte[count + 1][];
        this.toneCurves = new ToneCurve[count + 1];
    }

    /**
     * Keeps a frame in place of the oldest that was not chosen.
     *
     * @param found its markers
     * @param image its pixels; copied
     */
    synchronized void keep(Detections found, GreyImage image) {
        int size = image.widthPx() * image.heightPx();
        int room = (int) Math.max(FEWEST, Math.min(detections.length - 1, MOST_BYTES / size)) + 1;
        if (next >= room) {
            next = 0;
        }
        if (detections[next] != null && detections[next] == chosen) {
            next = (next + 1) % room;
        }
        byte[] copy = luminance[next];
        if (copy == null || copy.length != size) {
            copy = new byte[size];
            luminance[next] = copy;
        }
        for (int y = 0; y < image.heightPx(); y++) {
            System.arraycopy(image.luminance(), image.offset() + y * image.rowStride(), copy, y * image.widthPx(),
                    image.widthPx());
        }
        detections[next] = found;
        toneCurves[next] = image.toneCurve();
        next = (next + 1) % room;
    }

    /**
     * Chooses a frame, whose pixels stay until another is chosen; the one before is given up.
     *
     * @param keyFrame markers of the frame, the same object as was kept; null for none
     */
    synchronized void choose(Detections keyFrame) {
        chosen = keyFrame;
    }

    /**
     * Takes the pixels of a frame, which are not used again.
     *
     * @param keyFrame markers of the frame, the same object as was kept; null for none
     * @return its pixels under the name of its markers, the same each time for the one taken last; null where it is too
     *     old or none
     */
    synchronized Photo take(Detections keyFrame) {
        if (keyFrame == null || keyFrame == takenDetections) {
            return keyFrame == null ? null : taken;
        }
        for (int i = 0; i < detections.length; i++) {
            if (detections[i] == keyFrame) {
                takenDetections = keyFrame;
                taken = new Photo(keyFrame.imageName(),
                        GreyImage.packed(luminance[i], keyFrame.widthPx(), keyFrame.heightPx())
                                .withToneCurve(toneCurves[i]));
                detections[i] = null;
                luminance[i] = null;
                return taken;
            }
        }
        return null;
    }
}
