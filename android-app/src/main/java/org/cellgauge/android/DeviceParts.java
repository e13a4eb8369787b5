package org.cellgauge.android;

import android.content.Context;
import io.reactivex.rxjava3.core.Flowable;
import java.io.File;
import java.time.Clock;
import org.cellgauge.android.camera.Camera2Feed;
import org.cellgauge.android.camera.CameraFeed;
import org.cellgauge.android.device.ThermalLevel;
import org.cellgauge.android.device.ThermalWatch;
import org.cellgauge.android.files.AppMemory;
import org.cellgauge.android.files.CellLibrary;
import org.cellgauge.android.files.DocumentLibrary;
import org.cellgauge.android.files.FolderArchive;
import org.cellgauge.android.files.ResultArchive;
import org.cellgauge.android.files.StoredMemory;
import org.cellgauge.android.screen.OverlayPainter;
import org.cellgauge.android.screen.ScreenWords;
import org.cellgauge.android.state.SessionThreads;
import org.cellgauge.settings.CheckSettings;

/** The device's own camera, documents and storage. */
final class DeviceParts implements AppParts {
    private final Context context;
    private final ThermalWatch thermal;
    private final CellLibrary library;
    private final ResultArchive archive;
    private final AppMemory memory;

    /**
     * The parts of an app.
     *
     * @param context of the app
     */
    DeviceParts(Context context) {
        this.context = context;
        this.thermal = new ThermalWatch(context);
        this.library = new DocumentLibrary(context);
        this.archive = new FolderArchive(context, OverlayPainter::paint, new ScreenWords(context),
                Clock.systemDefaultZone(), AppVersion.of(context));
        this.memory = new StoredMemory(context);
    }

    @Override
    public CameraFeed cameraFeed(Context activity) {
        return new Camera2Feed(activity);
    }

    @Override
    public Flowable<ThermalLevel> thermalLevels() {
        return thermal.levels();
    }

    @Override
    public CellLibrary cellLibrary() {
        return library;
    }

    @Override
    public ResultArchive resultArchive() {
        return archive;
    }

    @Override
    public AppMemory memory() {
        return memory;
    }

    @Override
    public File cacheFolder() {
        return context.getCacheDir();
    }

    @Override
    public CheckSettings settings() {
        return CheckSettings.builder().build();
    }

    @Override
    public SessionThreads sessionThreads() {
        return SessionThreads.ofApp();
    }
}
