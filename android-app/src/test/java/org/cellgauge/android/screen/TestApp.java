package org.cellgauge.android.screen;

import android.content.Context;
import android.graphics.SurfaceTexture;
import io.reactivex.rxjava3.core.Flowable;
import io.reactivex.rxjava3.processors.BehaviorProcessor;
import io.reactivex.rxjava3.schedulers.Schedulers;
import java.io.File;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.cellgauge.android.AppParts;
import org.cellgauge.android.CellGaugeApp;
import org.cellgauge.android.camera.CameraFault;
import org.cellgauge.android.camera.CameraFeed;
import org.cellgauge.android.camera.CameraModelSource;
import org.cellgauge.android.camera.CameraNote;
import org.cellgauge.android.camera.CameraSetup;
import org.cellgauge.android.device.ThermalLevel;
import org.cellgauge.android.files.AppMemory;
import org.cellgauge.android.files.CellDocument;
import org.cellgauge.android.files.CellLibrary;
import org.cellgauge.android.files.KeptResult;
import org.cellgauge.android.files.Photo;
import org.cellgauge.android.files.ResultArchive;
import org.cellgauge.android.files.SavedResult;
import org.cellgauge.android.state.Detectors;
import org.cellgauge.android.state.SessionThreads;
import org.cellgauge.check.CheckResult;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.GreyImage;

/** The app with a camera, files and an archive that a test leads. */
public class TestApp extends CellGaugeApp implements AppParts {
    final FakeFeed feed = new FakeFeed();
    final FakeLibrary library = new FakeLibrary();
    /** In place of {@link #library} where it is not null. */
    CellLibrary documents;
    final FakeArchive archive = new FakeArchive();
    final BehaviorProcessor<ThermalLevel> levels = BehaviorProcessor.createDefault(ThermalLevel.NORMAL);
    /** In place of {@link #archive} where it is not null. */
    ResultArchive folders;
    AppMemory memory = new NoMemory();
    CheckSettings settings = CheckSettings.builder().build();
    Detectors detectors = Detectors.OF_LIBRARY;
    /** Where a session makes its states and reads its files; the check itself always has threads of its own. */
    Supplier<SessionThreads> threads = () -> new SessionThreads(Schedulers.trampoline(), Schedulers.trampoline(), null,
            null);

    @Override
    protected AppParts makeParts() {
        return this;
    }

    @Override
    public CameraFeed cameraFeed(Context context) {
        return feed;
    }

    @Override
    public Flowable<ThermalLevel> thermalLevels() {
        return levels;
    }

    @Override
    public CellLibrary cellLibrary() {
        return documents != null ? documents : library;
    }

    @Override
    public ResultArchive resultArchive() {
        return folders != null ? folders : archive;
    }

    @Override
    public AppMemory memory() {
        return memory;
    }

    @Override
    public File cacheFolder() {
        return getCacheDir();
    }

    @Override
    public CheckSettings settings() {
        return settings;
    }

    @Override
    public SessionThreads sessionThreads() {
        return threads.get();
    }

    @Override
    public Detectors detectors() {
        return detectors;
    }

    /** Every start is a first one, however many a test has. */
    static final class NoMemory implements AppMemory {
        @Override
        public Choice lastChoice() {
            return null;
        }

        @Override
        public void keep(Choice choice) {
            // forgotten
        }

        @Override
        public boolean guideShown() {
            return true;
        }

        @Override
        public void guideIsShown() {
            // no test but that of the guide asks for it
        }
    }

    /** A camera whose frames are a test's. */
    static final class FakeFeed implements CameraFeed {
        private Listener listener;
        PinholeCamera openedWith;
        OptionalDouble focusedAtM;
        int openings;
        int closings;
        int refocusings;
        boolean torch;
        /** Whether the next cameras that open have a lamp. */
        boolean hasTorch;
        private long timeNs;

        @Override
        public void open(PinholeCamera calibration, OptionalDouble focusDistanceM, SurfaceTexture preview,
                Listener to) {
            openedWith = calibration;
            focusedAtM = focusDistanceM;
            listener = to;
            openings++;
        }

        @Override
        public void refocus() {
            refocusings++;
        }

        @Override
        public void torch(boolean on) {
            torch = on;
        }

        @Override
        public void close() {
            torch = false;
            listener = null;
            closings++;
        }

        boolean isOpen() {
            return listener != null;
        }

        /** Who is told, also after the camera has closed. */
        Listener listener() {
            return listener;
        }

        /** The camera opens upright on a device whose sensor lies as stated. */
        void opened(PinholeCamera camera, int sensorOrientationDeg, boolean front, CameraNote... notes) {
            opened(camera, CameraModelSource.CALIBRATION_FILE, sensorOrientationDeg, front, notes);
        }

        void opened(PinholeCamera camera, CameraModelSource source, int sensorOrientationDeg, boolean front,
                CameraNote... notes) {
            EnumSet<CameraNote> set = EnumSet.noneOf(CameraNote.class);
            set.addAll(Arrays.asList(notes));
            listener.onOpened(new CameraSetup(camera, source, sensorOrientationDeg, front, hasTorch, set));
        }

        /** One frame, in an array that is spoilt afterwards as a camera's is used again. */
        void frame(GreyImage image) {
            byte[] own = image.luminance().clone();
            timeNs += 100_000_000;
            listener.onFrame(GreyImage.packed(own, image.widthPx(), image.heightPx()), timeNs);
            Arrays.fill(own, (byte) 0);
        }

        void fault(CameraFault fault) {
            Listener told = listener;
            listener = null;
            told.onFault(fault);
        }
    }

    /** Documents that a test puts in. */
    static final class FakeLibrary implements CellLibrary {
        final Map<String, Supplier<CellDocument>> cells = new HashMap<>();
        final Map<String, Supplier<Photo>> photos = new HashMap<>();
        final List<String> calibrations = new ArrayList<>();

        @Override
        public CellDocument example() {
            return new CellDocument("example.yaml", null, Fixture.LIFTED.cell(), Fixture.LIFTED.cell().camera());
        }

        @Override
        public Photo examplePhoto() {
            return Fixture.LIFTED.photo();
        }

        @Override
        public CellDocument cell(String uri, String calibrationUri) {
            calibrations.add(calibrationUri);
            return cells.get(uri).get();
        }

        @Override
        public Photo photo(String uri) {
            return photos.get(uri).get();
        }
    }

    /** Remembers what was kept. */
    static final class FakeArchive implements ResultArchive {
        final List<Photo> photos = new ArrayList<>();
        final List<CheckResult> results = new ArrayList<>();
        final List<SavedResult> saved = new ArrayList<>();
        IOException fault;

        @Override
        public SavedResult save(Photo photo, CheckResult result, String cellName) throws IOException {
            if (fault != null) {
                throw fault;
            }
            photos.add(photo);
            results.add(result);
            String name = "lifted-4-" + photos.size();
            SavedResult kept = new SavedResult(name, Arrays.asList("content://results/" + name + ".png",
                    "content://results/" + name + ".result.json"));
            saved.add(kept);
            return kept;
        }

        @Override
        public List<SavedResult> saved() {
            return new ArrayList<>(saved);
        }

        @Override
        public List<KeptResult> kept() {
            return new ArrayList<>();
        }

        @Override
        public byte[] picture(String name) throws IOException {
            throw new IOException("no picture of " + name);
        }

        @Override
        public boolean delete(String name) {
            return saved.removeIf(result -> result.name().equals(name));
        }
    }
}
