package org.cellgauge.desktop;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.internal.vision.BoofThreads;
import org.cellgauge.vision.BoofMarkerDetector;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.DetectionsFile;
import org.cellgauge.warning.Refusal;

/** Photos of one cell, or files of their corners, read side by side; one that cannot be read stops no other. */
public final class PhotoReading {
    /**
     * What became of one input.
     *
     * @param input photo or file of corners
     * @param detections what it shows; null where it was refused
     * @param refusal why it was; null where it was not
     */
    public record Photo(CheckInput input, Detections detections, Refusal refusal) {
    }

    /** Told of every photo. */
    @FunctionalInterface
    public interface Listener {
        /**
         * A photo was read; called by one thread, in the order of the photos.
         *
         * @param number from 1
         * @param count how many there are
         * @param photo what became of it
         */
        void photo(int number, int count, Photo photo);
    }

    private PhotoReading() {
    }

    /**
     * Reads photos.
     *
     * @param cell the cell that they show
     * @param inputs photos and files of corners
     * @param threads how many at once, at least 1
     * @param listener told of every photo
     * @return one for each input, in their order
     */
    public static List<Photo> of(Cell cell, List<CheckInput> inputs, int threads, Listener listener) {
        // photos go side by side, each on one thread
        BoofThreads.useOne();
        ThreadLocal<BoofMarkerDetector> detectors = ThreadLocal.withInitial(() -> BoofMarkerDetector.forCell(cell));
        ExecutorService pool = Executors.newFixedThreadPool(threads);
        try {
            List<Future<Photo>> waiting = new ArrayList<>();
            for (CheckInput input : inputs) {
                waiting.add(pool.submit(() -> read(input, detectors)));
            }
            List<Photo> out = new ArrayList<>();
            for (Future<Photo> one : waiting) {
                out.add(one.get());
                listener.photo(out.size(), inputs.size(), out.get(out.size() - 1));
            }
            return out;
        } catch (ExecutionException e) {
            if (e.getCause() instanceof Error error) {
                throw error;
            }
            throw new IllegalStateException(e.getCause());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException(e);
        } finally {
            pool.shutdownNow();
        }
    }

    private static Photo read(CheckInput input, ThreadLocal<BoofMarkerDetector> detectors) {
        String name = input.file().toString();
        try {
            if (input.refusal() != null) {
                throw new InputRefusedException(name, input.refusal());
            }
            Detections seen = input.isDetections() ? DetectionsFile.read(DetectionsFile.bytes(input.file()), name)
                    : detectors.get().detect(ImageFiles.read(input.file()), name);
            Detections named = new Detections(input.name(), seen.widthPx(), seen.heightPx(), seen.markers(),
                    seen.warnings(), seen.light());
            return new Photo(input, named, null);
        } catch (InputRefusedException e) {
            return new Photo(input, null, e.refusal());
        }
    }
}
