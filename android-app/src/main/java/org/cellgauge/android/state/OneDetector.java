package org.cellgauge.android.state;

import java.util.concurrent.locks.ReentrantLock;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.GreyImage;
import org.cellgauge.vision.MarkerDetector;

/**
 * The one detector of a session. A check gets its own when its first image comes, and that of the check before is gone
 * by then: each takes some bytes for every pixel of its camera. Images are looked at one at a time, on the thread that
 * brings them.
 */
final class OneDetector {
    private final Detectors maker;
    private final ReentrantLock lock = new ReentrantLock();
    /** Whose detector it is, or null where there is none. */
    private CheckRun user;
    private MarkerDetector detector;

    /**
     * No detector yet.
     *
     * @param maker makes them
     */
    OneDetector(Detectors maker) {
        this.maker = maker;
    }

    /**
     * Looks for the markers of a check in an image; waits until another image has been looked at.
     *
     * @param run the check
     * @param image the image
     * @param name its name
     * @return what is found
     */
    Detections detect(CheckRun run, GreyImage image, String name) {
        lock.lock();
        boolean done = false;
        try {
            if (user != run) {
                drop();
                detector = maker.of(run.cell(), run.isOfFrames());
                user = run;
            }
            Detections found = detector.detect(image, name);
            done = true;
            return found;
        } finally {
            // after a fault as well: where the memory was too small, what the detector has of it is needed
            if (!done || run.isStopped() || !run.isOfFrames()) {
                drop();
            }
            lock.unlock();
        }
    }

    /**
     * Lets go of the detector of a check that was stopped, without waiting: while an image is being looked at, that
     * call does it at its end.
     *
     * @param run the check
     */
    void release(CheckRun run) {
        if (lock.tryLock()) {
            try {
                if (user == run) {
                    drop();
                }
            } finally {
                lock.unlock();
            }
        }
    }

    private void drop() {
        detector = null;
        user = null;
    }
}
