package org.cellgauge.android.state;

import org.cellgauge.android.files.Photo;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.GreyImage;

/**
 * Pixels of the newest frames, until it is known which of them the figures belong to: the camera uses its arrays again,
 * and a check chooses its key frame a little after it came. Arrays of frames that were not chosen are used again.
 */
final class RecentFrames {
    /** Large frames are kept in smaller number: the whole app may have no more than 200 MB. */
    private static final long MOST_BYTES = 24_000_000;
    private static final int FEWEST = 2;

    private final Detections[] detections;
    private final byte[][] luminance;
    private final ToneCurve[] toneCurves;
    private int next;
    private Photo key;
    private Detections keyDetections;

    /**
     * Room for some frames.
     *
     * @param count how many frames may come between a frame and its choice
     */
    RecentFrames(int count) {
        this.detections = new Detections[count];
        this.luminance = new byte[count][];
        this.toneCurves = new ToneCurve[count];
    }

    /**
     * Keeps a frame in place of the oldest.
     *
     * @param found its markers
     * @param image its pixels; copied
     */
    synchronized void keep(Detections found, GreyImage image) {
        int size = image.widthPx() * image.heightPx();
        int room = (int) Math.max(FEWEST, Math.min(detections.length, MOST_BYTES / size));
        if (next >= room) {
            next = 0;
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
     * The frame that was chosen; its pixels are not used again.
     *
     * @param chosen markers of the frame, the same object as was kept; null for none
     * @return its pixels under the name of its markers, or null where it is too old or none was chosen
     */
    synchronized Photo choose(Detections chosen) {
        if (chosen == null || chosen == keyDetections) {
            return chosen == null ? null : key;
        }
        keyDetections = chosen;
        key = null;
        for (int i = 0; i < detections.length; i++) {
            if (detections[i] == chosen) {
                key = new Photo(chosen.imageName(),
                        GreyImage.packed(luminance[i], chosen.widthPx(), chosen.heightPx())
                                .withToneCurve(toneCurves[i]));
                detections[i] = null;
                luminance[i] = null;
            }
        }
        return key;
    }
}
