package org.cellgauge.android;

import android.content.Context;
import io.reactivex.rxjava3.core.Flowable;
import java.io.File;
import org.cellgauge.android.camera.CameraFeed;
import org.cellgauge.android.device.ThermalLevel;
import org.cellgauge.android.files.AppMemory;
import org.cellgauge.android.files.CellLibrary;
import org.cellgauge.android.files.ResultArchive;
import org.cellgauge.android.state.Detectors;
import org.cellgauge.android.state.SessionThreads;
import org.cellgauge.settings.CheckSettings;

/** What the screen works with: the device's camera and files, or those of a test. */
public interface AppParts {
    /**
     * A camera, closed.
     *
     * @param context of the activity
     * @return a new feed
     */
    CameraFeed cameraFeed(Context context);

    /**
     * How warm the device is.
     *
     * @return the present level at once, then every change
     */
    Flowable<ThermalLevel> thermalLevels();

    /**
     * Where cells and photos come from.
     *
     * @return the same one each time
     */
    CellLibrary cellLibrary();

    /**
     * Where results are kept.
     *
     * @return the same one each time
     */
    ResultArchive resultArchive();

    /**
     * What is remembered from one start to the next.
     *
     * @return the same one each time
     */
    AppMemory memory();

    /**
     * Where the app may write what need not last.
     *
     * @return a folder
     */
    File cacheFolder();

    /**
     * How a check goes about it, but for the seed and what the camera decides.
     *
     * @return the same ones each time
     */
    CheckSettings settings();

    /**
     * Threads of a session.
     *
     * @return a new set, ended by the session
     */
    SessionThreads sessionThreads();

    /**
     * What finds markers.
     *
     * @return the library's, but in a test
     */
    default Detectors detectors() {
        return Detectors.OF_LIBRARY;
    }
}
