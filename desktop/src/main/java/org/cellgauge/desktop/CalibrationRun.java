package org.cellgauge.desktop;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.cellgauge.calibration.Calibration;
import org.cellgauge.calibration.CalibrationOptions;
import org.cellgauge.calibration.CalibrationResult;
import org.cellgauge.cell.CalibrationTarget;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.vision.BoofThreads;
import org.cellgauge.vision.GreyImage;
import org.cellgauge.vision.TargetDetector;
import org.cellgauge.vision.TargetObservation;
import org.cellgauge.vision.TargetPoints;

/** Photos of a target from files to a calibrated camera. */
public final class CalibrationRun {
    /** Told of every photo. */
    @FunctionalInterface
    public interface Listener {
        /**
         * A photo was looked at; called by one thread at a time, in the order of the photos.
         *
         * @param number from 1
         * @param count how many there are
         * @param seen what it shows
         */
        void photo(int number, int count, TargetObservation seen);
    }

    /** A camera of which nothing is known yet is looked through as one of 60 degrees. */
    private static final double FIRST_FIELD_OF_VIEW_RAD = Math.PI / 3;

    private final CalibrationTarget target;
    private final CalibrationOptions options;
    private final int threads;
    private final Listener listener;

    /**
     * A run.
     *
     * @param target what was photographed
     * @param options how to calibrate
     * @param threads photos looked at at once, at least 1
     * @param listener told of every photo
     */
    public CalibrationRun(CalibrationTarget target, CalibrationOptions options, int threads, Listener listener) {
        this.target = target;
        this.options = options;
        this.threads = threads;
        this.listener = listener;
    }

    /**
     * Calibrates.
     *
     * @param photos image files
     * @return the camera and all about it
     * @throws org.cellgauge.cell.InputRefusedException if a photo cannot be read, or they give no calibration
     */
    public CalibrationResult of(List<Path> photos) {
        // photos go side by side, each on one thread
        BoofThreads.useOne();
        ExecutorService pool = Executors.newFixedThreadPool(threads);
        try {
            Found found = detect(pool, photos, null, listener);
            CalibrationResult result = Calibration.of(found.points, found.seen, options);
            if (target instanceof CalibrationTarget.Markers) {
                // the sides of markers are bent as the lens bends them: known now, so look again
                found = detect(pool, photos, result.camera(), (number, count, seen) -> { });
                result = Calibration.of(found.points, found.seen, options);
            }
            return result;
        } finally {
            pool.shutdownNow();
        }
    }

    private record Found(TargetPoints points, List<TargetObservation> seen) {
    }

    private Found detect(ExecutorService pool, List<Path> photos, PinholeCamera camera, Listener told) {
        // one detector a thread: they keep what they work on
        ThreadLocal<TargetDetector> detectors = new ThreadLocal<>();
        List<Future<TargetObservation>> waiting = new ArrayList<>();
        for (Path photo : photos) {
            waiting.add(pool.submit(() -> {
                GreyImage image = ImageFiles.read(photo);
                boolean fits = camera != null && camera.widthPx() == image.widthPx()
                        && camera.heightPx() == image.heightPx();
                TargetDetector detector = detectors.get();
                if (detector == null || target instanceof CalibrationTarget.Markers && !fits) {
                    detector = TargetDetector.of(target, fits ? camera : PinholeCamera.fromFieldOfView(image.widthPx(),
                            image.heightPx(), FIRST_FIELD_OF_VIEW_RAD));
                    detectors.set(detector);
                }
                return detector.find(image, photo.getFileName().toString());
            }));
        }
        List<TargetObservation> seen = new ArrayList<>();
        try {
            for (Future<TargetObservation> one : waiting) {
                seen.add(one.get());
                told.photo(seen.size(), photos.size(), seen.get(seen.size() - 1));
            }
        } catch (ExecutionException e) {
            if (e.getCause() instanceof RuntimeException refused) {
                throw refused;
            }
            if (e.getCause() instanceof Error error) {
                throw error;
            }
            throw new IllegalStateException(e.getCause());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException(e);
        }
        return new Found(TargetDetector.of(target, PinholeCamera.fromFieldOfView(1, 1, 1)).points(), seen);
    }
}
