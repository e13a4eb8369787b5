package org.cellgauge.android.state;

import io.reactivex.rxjava3.schedulers.Schedulers;
import org.cellgauge.cell.Cell;
import org.cellgauge.vision.BoofMarkerDetector;
import org.cellgauge.vision.MarkerDetector;

/** Makes what finds markers: the library's detectors, or those of a test. */
public interface Detectors {
    /** A cell shows some seven markers, and helpers that wait for work keep their processors awake. */
    int MOST_THREADS = 4;
    /** The library's. */
    Detectors OF_LIBRARY = (cell, frames) -> (frames ? BoofMarkerDetector.forFrames(cell)
            : BoofMarkerDetector.forCell(cell))
            .spread(Schedulers.computation()::scheduleDirect,
                    Math.min(MOST_THREADS, Runtime.getRuntime().availableProcessors()));

    /**
     * Makes a detector.
     *
     * @param cell whose markers it looks for, with the camera of the images to come
     * @param frames whether frames of a camera come, which it is to be quick with; false for a photo, in which it looks
     *     for faint markers as well
     * @return a new one
     */
    MarkerDetector of(Cell cell, boolean frames);
}
