package org.cellgauge.android.state;

import io.reactivex.rxjava3.core.Flowable;
import io.reactivex.rxjava3.core.Scheduler;
import io.reactivex.rxjava3.disposables.CompositeDisposable;
import io.reactivex.rxjava3.processors.BehaviorProcessor;
import io.reactivex.rxjava3.processors.FlowableProcessor;
import io.reactivex.rxjava3.processors.UnicastProcessor;
import java.io.IOException;
import java.text.SimpleDateFormat;
import java.util.Date;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import org.cellgauge.android.camera.CameraFault;
import org.cellgauge.android.camera.CameraFeed;
import org.cellgauge.android.camera.CameraSetup;
import org.cellgauge.android.device.ThermalLevel;
import org.cellgauge.android.files.AppMemory;
import org.cellgauge.android.files.CellDocument;
import org.cellgauge.android.files.CellLibrary;
import org.cellgauge.android.files.DrawnResult;
import org.cellgauge.android.files.FileRefusal;
import org.cellgauge.android.files.NotSavedException;
import org.cellgauge.android.files.Photo;
import org.cellgauge.android.files.ResultArchive;
import org.cellgauge.android.files.SavedResult;
import org.cellgauge.android.files.StorageFullException;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.Requirement;
import org.cellgauge.cell.Target;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.Verdict;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.overlay.ImageOrientation;
import org.cellgauge.live.LivePace;
import org.cellgauge.live.LiveState;
import org.cellgauge.output.ResultView;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.GreyImage;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;

/**
 * Holds the screen's state: what the user and the camera do goes in, {@link #states()} comes out, and nothing flows the
 * other way. Knows no screen, so that it outlives the rotation of one.
 *
 * <p>Inputs may come on any thread. They are queued and make states one after the other on one thread. Markers are
 * searched on the thread that a frame comes on: the camera then drops what comes meanwhile.
 */
public final class CheckSession {
    private static final long NS_PER_MS = 1_000_000;

    private final CellLibrary library;
    private final ResultArchive archive;
    private final AppMemory appMemory;
    private final FrozenFrameFile frozenFrame;
    private final CheckSettings settings;
    private final SessionThreads threads;
    private final OneDetector detector;
    private final SessionMemory remembered;
    private final FlowableProcessor<UnaryOperator<CheckScreenState>> changes =
            UnicastProcessor.<UnaryOperator<CheckScreenState>>create().toSerialized();
    private final BehaviorProcessor<CheckScreenState> states = BehaviorProcessor.createDefault(CheckScreenState.EMPTY);
    private final BehaviorProcessor<LivePace> pace = BehaviorProcessor.createDefault(LivePace.FULL);
    private final CompositeDisposable work = new CompositeDisposable();
    private final Scheduler.Worker fileWork;

    // What the camera's thread must know at once, not when its turn comes.
    private final Object runLock = new Object();
    private CheckRun run;
    private final AtomicInteger runs = new AtomicInteger();
    private volatile CellDocument document;
    private volatile CameraSetup openSetup;
    private volatile boolean live = true;
    private volatile boolean closed;
    /** A photo that came before any cell, until one is chosen; of the thread of files alone. */
    private String waitingPhoto;

    /**
     * A session.
     *
     * @param library where cells and photos come from
     * @param archive where results are kept
     * @param appMemory is told which cell and target are in use, for the next start of the app
     * @param frozenFrame where a frozen frame outlives the process
     * @param settings how checks go about it; the seed is the memory's
     * @param threads where the session works
     * @param detectors what finds markers
     * @param memory of the session before, which is taken up again, or of none
     */
    public CheckSession(CellLibrary library, ResultArchive archive, AppMemory appMemory, FrozenFrameFile frozenFrame,
            CheckSettings settings, SessionThreads threads, Detectors detectors, SessionMemory memory) {
        this.library = library;
        this.archive = archive;
        this.appMemory = appMemory;
        this.frozenFrame = frozenFrame;
        this.settings = settings.toBuilder().seed(memory.seed()).build();
        this.threads = threads;
        this.detector = new OneDetector(detectors);
        this.remembered = memory;
        // a worker, unlike a task scheduled by itself, does not hold what is done: photos and draws of every save
        fileWork = threads.files().createWorker();
        work.add(fileWork);
        changes.observeOn(threads.states())
                .scan(CheckScreenState.EMPTY, CheckSession::changed)
                .subscribe(states);
        work.add(states.filter(s -> s.source() == ImageSource.FROZEN && s.still() != null)
                .distinctUntilChanged(CheckScreenState::still)
                .onBackpressureLatest().observeOn(threads.files(), false, 1)
                .subscribe(s -> keepFrozen(s)));
        work.add(states.map(s -> s.source() == ImageSource.FROZEN).distinctUntilChanged().buffer(2, 1)
                .filter(frozen -> frozen.size() == 2 && frozen.get(0)).onBackpressureLatest()
                .observeOn(threads.files(), false, 1).subscribe(thawed -> frozenFrame.clear()));
        files(() -> frozenFrame.clearLeftovers(System.currentTimeMillis()));
        if (memory.hasCell()) {
            restore();
        }
    }

    /**
     * What the screen shows.
     *
     * @return the newest state at once, then every other one; on a thread of the session
     */
    public Flowable<CheckScreenState> states() {
        return states.onBackpressureLatest();
    }

    /**
     * The newest state.
     *
     * @return never null
     */
    public CheckScreenState state() {
        return states.getValue();
    }

    /**
     * What is needed to take this session up in another process.
     *
     * @return the memory
     */
    public SessionMemory memory() {
        CheckScreenState state = state();
        Problem problem = state.cellProblem();
        // killed once more before what was remembered could be read again, or while its storage is away
        boolean still = state.cell() == null && remembered.hasCell()
                && (problem == null || problem.kind() == Problem.Kind.LAST_CELL);
        return still ? remembered : state.memory(remembered.seed());
    }

    /**
     * Gets what the camera has to say while it is open for a cell.
     *
     * @param cell the cell whose calibration, or lack of one, the camera is opened with
     * @return to be given to the feed; it hears nothing any more once another cell is in use
     */
    public CameraFeed.Listener cameraListener(CellDocument cell) {
        return new Frames(cell);
    }

    /**
     * The id of the file that a frozen frame is kept in.
     *
     * @return to be kept with the session's memory
     */
    public String frozenFrameId() {
        return frozenFrame.id();
    }

    /** Ends the session for good: nobody will come back to what was frozen. */
    public void end() {
        close();
        frozenFrame.clear();
    }

    /** Ends the session: checks stop, no state comes any more. What was frozen can be taken up again. */
    public void close() {
        closed = true;
        stopRun();
        work.dispose();
        changes.onComplete();
    }

    // ---- what the user does

    /**
     * Takes a cell file.
     *
     * @param uri of the document
     */
    public void chooseCell(String uri) {
        change(s -> s.change().readingCell(true).cellProblem(null).build());
        files(() -> {
            if (takeCell(() -> library.cell(uri, null), null, false) && waitingPhoto != null) {
                String photo = waitingPhoto;
                waitingPhoto = null;
                takePhoto(photo, photo(photo));
            }
        });
    }

    /** Takes the bundled cell and its photo, so that there is a result without a camera. */
    public void tryExample() {
        change(s -> s.change().readingCell(true).cellProblem(null).build());
        files(() -> {
            waitingPhoto = null;
            if (takeCell(library::example, null, false)) {
                takePhoto(null, library::examplePhoto);
            }
        });
    }

    /**
     * Takes a calibration file for the cell in use. A target that was chosen stays, and a photo is checked again.
     *
     * @param uri of the document
     */
    public void chooseCalibration(String uri) {
        change(s -> s.change().readingCell(s.cell() != null).cellProblem(null).build());
        files(() -> {
            // looked at here, behind a session before that is still being taken up
            CellDocument cell = document;
            if (cell != null && cell.uri() != null) {
                takeCell(() -> library.cell(cell.uri(), uri), uri, true);
            } else {
                change(s -> s.change().readingCell(false).build());
            }
        });
    }

    /**
     * Reads a cell and takes it.
     *
     * @param same whether it is the one in use with another calibration, so that target and photo stay
     */
    private boolean takeCell(Supplier<CellDocument> reading, String calibrationUri, boolean same) {
        CellDocument read;
        try {
            read = reading.get();
        } catch (RuntimeException | OutOfMemoryError e) {
            noCell(problem(Problem.Kind.CELL_REFUSED, e));
            return false;
        }
        take(read, calibrationUri, same, true);
        return true;
    }

    private void noCell(Problem problem) {
        change(s -> s.change().readingCell(false).cellProblem(problem).build());
    }

    private void take(CellDocument read, String calibrationUri, boolean same, boolean remember) {
        synchronized (runLock) {
            stopRun();
            document = read;
            openSetup = null;
            live = true;
            change(s -> {
                if (same && s.source() == ImageSource.PHOTO) {
                    files(() -> takePhoto(s.photoUri(), photo(s.photoUri())));
                }
                boolean chosen = same && s.targetChosen();
                CheckScreenState taken = s.change().cell(read).readingCell(false).cellProblem(null)
                        .calibrationUri(calibrationUri).photoWaits(false)
                        .target(chosen ? s.target() : read.cell().target(), chosen).source(ImageSource.LIVE)
                        .still(null, null).photo(null, null, false).photoProblem(null).readingPhoto(false).fault(null)
                        .setup(null).noCheck(OptionalInt.empty()).build();
                return remember ? remembering(taken) : taken;
            });
        }
    }

    /** The cell of the session before; without its calibration, and with a word on that, where only that is gone. */
    private boolean takeAgain(SessionMemory m) {
        if (m.cellUri() == null) {
            return takeCell(library::example, null, false);
        }
        try {
            take(library.cell(m.cellUri(), m.calibrationUri()), m.calibrationUri(), false, false);
            return true;
        } catch (RuntimeException | OutOfMemoryError e) {
            return m.calibrationUri() == null ? lost(problem(Problem.Kind.LAST_CELL, e))
                    : takeWithoutCalibration(m.cellUri(), problem(Problem.Kind.LAST_CALIBRATION, e));
        }
    }

    private boolean takeWithoutCalibration(String cellUri, Problem ofCalibration) {
        try {
            take(library.cell(cellUri, null), null, false, false);
            change(s -> s.change().cellProblem(ofCalibration).build());
            return true;
        } catch (RuntimeException | OutOfMemoryError e) {
            return lost(problem(Problem.Kind.LAST_CELL, e));
        }
    }

    private boolean lost(Problem problem) {
        // stays remembered until another cell is chosen: a card may be back at the next start
        noCell(problem);
        return false;
    }

    /**
     * Goes on with the cell in use, or with none, after a file was refused.
     */
    public void dismissCellProblem() {
        change(s -> {
            Problem problem = s.cellProblem();
            if (problem != null && problem.kind() == Problem.Kind.LAST_CALIBRATION) {
                remembering(s);
            }
            return s.change().cellProblem(null).build();
        });
    }

    /**
     * Has what is in use remembered for the next start. In the order of the states, so that a target that was chosen
     * shortly before a calibration does not bring the calibration before it back. The example is not remembered.
     */
    private CheckScreenState remembering(CheckScreenState s) {
        if (s.cell().uri() != null) {
            AppMemory.Choice choice = new AppMemory.Choice(s.cell().uri(), s.calibrationUri(),
                    s.targetChosen() ? s.target() : null);
            files(() -> appMemory.keep(choice));
        }
        return s;
    }

    /**
     * Holds another target against the figures; nothing is sampled again. It is remembered with the cell.
     *
     * @param target what is asked of the objects
     */
    public void chooseTarget(Target target) {
        change(s -> s.cell() == null ? s : remembering(judged(heldAgainst(s, target).target(target, true).build())));
    }

    /**
     * Lets an object count or not: of one that does not, nothing is asked, in view or not.
     *
     * @param objectId marker id of an object of the cell
     * @param counts false to ask nothing of it; true for what is asked of all, or of it alone by the cell file
     */
    public void count(int objectId, boolean counts) {
        change(s -> {
            if (s.cell() == null) {
                return s;
            }
            Map<Integer, Requirement> own = new HashMap<>(s.target().own());
            own.remove(objectId);
            Requirement stated = s.cell().cell().target().own().get(objectId);
            if (!counts) {
                own.put(objectId, Requirement.NONE);
            } else if (stated != null && stated.isAny()) {
                own.put(objectId, stated);
            }
            Target target = new Target(s.target().general(), own);
            return remembering(judged(heldAgainst(s, target).target(target, true).build()));
        });
    }

    /** Takes the cell file's target again. */
    public void resetTarget() {
        change(s -> s.cell() == null ? s : remembering(
                judged(heldAgainst(s, s.cell().cell().target()).target(s.cell().cell().target(), false).build())));
    }

    /** The last verdict is another one under another target. */
    private static CheckScreenState.Builder heldAgainst(CheckScreenState s, Target target) {
        HeldVerdict held = s.held();
        if (held == null) {
            return s.change();
        }
        CheckResult result = held.result().withTarget(target);
        ResultView view = ResultView.of(result);
        return s.change().held(new HeldVerdict(result, view, CheckFigures.rows(result.cell(), target, s.live(), result,
                view), held.photo(), held.atMs(), held.ageMs()));
    }

    /** Holds the frame that the figures belong to, and samples it to the end. */
    public void freeze() {
        change(s -> s.canFreeze() ? held(s) : s);
    }

    private CheckScreenState held(CheckScreenState s) {
        CheckRun current = run();
        if (current == null) {
            return s;
        }
        live = false;
        current.endFrames();
        // where this is null the frame has been given up meanwhile: the next state brings that in its place
        Photo frame = current.photoOf(s.live().keyFrame());
        return s.change().live(s.live(), frame).still(frame, s.orientation()).source(ImageSource.FROZEN)
                .photo(null, current.cell().camera(), current.lensEstimated()).build();
    }

    /** Goes back to the camera's picture. */
    public void resume() {
        change(s -> {
            if (s.source() == ImageSource.LIVE) {
                return s.change().fault(null).build();
            }
            stopRun();
            live = true;
            return s.change().source(ImageSource.LIVE).still(null, null).photo(null, null, false).photoProblem(null)
                    .readingPhoto(false).fault(null).noCheck(OptionalInt.empty()).build();
        });
    }

    /**
     * Checks a saved photo; without a cell, as soon as one is chosen.
     *
     * @param uri of the document
     */
    public void openPhoto(String uri) {
        beginPhoto(uri);
        files(() -> {
            if (document == null) {
                waitingPhoto = uri;
                change(s -> s.change().photoWaits(true).build());
            } else {
                takePhoto(uri, photo(uri));
            }
        });
    }

    /** Reads a photo; the bundled one where there is no address. */
    private Supplier<Photo> photo(String uri) {
        return uri == null ? library::examplePhoto : () -> library.photo(uri);
    }

    /** The address counts from here on: a calibration that is taken meanwhile is for this photo. */
    private void beginPhoto(String uri) {
        synchronized (runLock) {
            live = false;
            stopRun();
            change(s -> s.cell() == null ? s : s.change().source(ImageSource.PHOTO).still(null, null).readingPhoto(true)
                    .photo(uri, null, false).photoProblem(null).noCheck(OptionalInt.empty()).build());
        }
    }

    private void takePhoto(String uri, Supplier<Photo> reading) {
        CellDocument cell = document;
        if (cell == null) {
            return;
        }
        beginPhoto(uri);
        PinholeCamera camera = cell.calibration();
        boolean estimated = false;
        CameraSetup setup = openSetup;
        if (camera == null && setup != null) {
            camera = setup.camera();
            estimated = !LensKnowledge.isMeasured(setup.source());
        }
        checkPhoto(cell, uri, reading, camera, estimated, ImageSource.PHOTO, null);
    }

    private void checkPhoto(CellDocument cell, String uri, Supplier<Photo> reading, PinholeCamera camera,
            boolean estimated, ImageSource source, ImageOrientation orientation) {
        Photo photo;
        try {
            photo = reading.get();
        } catch (RuntimeException e) {
            photoRefused(problem(Problem.Kind.PHOTO_REFUSED, e));
            return;
        } catch (OutOfMemoryError e) {
            photoRefused(new Problem(Problem.Kind.PHOTO_REFUSED, Refusal.of(FileRefusal.MEMORY)));
            return;
        }
        PinholeCamera scaled = scaled(camera, photo.luminance());
        change(s -> s.change().source(source).still(photo, orientation).readingPhoto(false)
                .photo(uri, scaled, estimated).build());
        if (camera == null) {
            photoRefused(new Problem(Problem.Kind.PHOTO_WITHOUT_CAMERA, ""));
            return;
        }
        boolean fits = scaled.widthPx() == photo.luminance().widthPx()
                && scaled.heightPx() == photo.luminance().heightPx();
        try {
            begin(cell, scaled, estimated, photo);
        } catch (OutOfMemoryError e) {
            photoRefused(new Problem(Problem.Kind.PHOTO_REFUSED,
                    Refusal.at(Place.of(photo.name()), FileRefusal.MEMORY_FOR_CHECK)));
        } catch (RuntimeException e) {
            photoRefused(problem(fits ? Problem.Kind.PHOTO_REFUSED : Problem.Kind.PHOTO_SIZE, e));
        }
    }

    /** The camera for a photo that shows the same in more or fewer pixels, as devices take photos and frames. */
    private static PinholeCamera scaled(PinholeCamera camera, GreyImage photo) {
        return camera != null && camera.hasShape(photo.widthPx(), photo.heightPx())
                ? camera.resized(photo.widthPx(), photo.heightPx()) : camera;
    }

    private void photoRefused(Problem problem) {
        change(s -> s.change().readingPhoto(false).photoProblem(problem).build());
    }

    /** Keeps the result of the newest state. */
    public void save() {
        save(state());
    }

    /**
     * Keeps the result that was on the screen.
     *
     * @param shown what the screen showed when the user asked for it; the session may be further by now
     */
    public void save(CheckScreenState shown) {
        change(s -> {
            if (!shown.canSave() || s.saving() || s.keeps(shown.shownResult())) {
                return s;
            }
            CheckResult result = shown.shownResult();
            Photo photo = shown.shownPhoto();
            String cellName = shown.cell().name();
            files(() -> save(photo, result, cellName));
            return s.change().saving(true).saveProblem(null).build();
        });
    }

    private void save(Photo photo, CheckResult result, String cellName) {
        try {
            SavedResult saved = archive.save(photo, result, cellName);
            change(s -> s.change().saving(false).saved(saved, result).build());
        } catch (StorageFullException e) {
            notSaved(problem(Problem.Kind.STORAGE_FULL, e));
        } catch (IOException | RuntimeException e) {
            notSaved(problem(Problem.Kind.NOT_SAVED, e));
        } catch (OutOfMemoryError e) {
            notSaved(new Problem(Problem.Kind.NOT_SAVED, Refusal.of(FileRefusal.RESULT_MEMORY)));
        }
    }

    private void notSaved(Problem problem) {
        change(s -> s.change().saving(false).saveProblem(problem).build());
    }

    /** The screen came back: what was kept last may have been deleted meanwhile, here or in the Files app. */
    public void lookAtSaved() {
        if (state().saved() == null) {
            return;
        }
        files(() -> {
            Set<String> there = new HashSet<>();
            archive.saved().forEach(result -> there.add(result.name()));
            change(s -> s.saved() == null || there.contains(s.saved().name()) ? s
                    : s.change().saved(null, null).build());
        });
    }

    // ---- what the device does

    /**
     * The display was turned, its language changed, or the room for the picture.
     *
     * @param display how it shows the picture
     */
    public void display(PictureDisplay display) {
        change(s -> redrawn(s.change().display(display).build()));
    }

    /**
     * Whether the camera may be used was looked at.
     *
     * @param permission what came out
     */
    public void permission(CameraPermission permission) {
        change(s -> s.change().permission(permission).fault(
                permission == CameraPermission.GRANTED && s.fault() == CameraFault.NOT_PERMITTED ? null : s.fault())
                .build());
    }

    /** The screen came back, or the user wants the camera to be tried again. */
    public void retryCamera() {
        change(s -> s.fault() == null ? s : s.change().fault(null).build());
    }

    /** The camera focuses anew: no frame comes while the lens moves. */
    public void refocusing() {
        change(s -> s.source() == ImageSource.LIVE ? s.change().awaitFrame().build() : s);
    }

    /**
     * Switches the lamp beside the camera.
     *
     * @param on whether it is to shine
     */
    public void torch(boolean on) {
        change(s -> s.torch() == on ? s : s.change().torch(on).build());
    }

    /**
     * The device got warmer or cooler.
     *
     * @param level how warm it is
     */
    public void heat(ThermalLevel level) {
        LivePace allowed = ThermalPace.of(level);
        pace.onNext(allowed);
        change(s -> {
            CheckScreenState next = s.change().heat(level).build();
            if (!next.allowsCamera() && s.canFreeze()) {
                return held(next);
            }
            if (allowed.sampling() && s.still() != null && s.phase() == LiveState.Phase.QUICK_LOOK) {
                // its frames have ended, so that nothing but a new check can take up what heat kept from sampling
                files(() -> sampleStill(s));
            }
            return next;
        });
    }

    private void sampleStill(CheckScreenState s) {
        if (s.photoCamera() != null && state().still() == s.still()) {
            begin(s.cell(), s.photoCamera(), s.lensEstimated(), s.still());
        }
    }

    // ---- checks

    /**
     * Begins another check in place of the one before.
     *
     * @return null where the user has gone on to another cell or picture meanwhile
     */
    private CheckRun begin(CellDocument cell, PinholeCamera camera, boolean estimated, Photo photo) {
        CheckRun begun = new CheckRun(runs.incrementAndGet(), cell, camera, estimated, photo, detector);
        synchronized (runLock) {
            if (closed || document != cell || live != (photo == null)) {
                return null;
            }
            stopRun();
            run = begun;
            OptionalInt number = OptionalInt.of(begun.number());
            change(s -> s.change().noCheck(number).build());
        }
        begun.start(settings, pace, threads, state -> checked(begun, state), fault -> failed(begun, fault));
        return begun;
    }

    private CheckRun run() {
        synchronized (runLock) {
            return run;
        }
    }

    private void stopRun() {
        synchronized (runLock) {
            if (run != null) {
                run.stop();
                run = null;
            }
        }
    }

    private void checked(CheckRun from, LiveState state) {
        boolean verdict = state.update() != null && state.update().result() != null;
        from.choose(state.keyFrame());
        // the pixels of a moving camera's frames are nobody's: their arrays are used again
        Photo photo = verdict || !from.isOfFrames() || !live ? from.photoOf(state.keyFrame()) : null;
        if (from.isNewlyJudged(state)) {
            files(() -> {
                FusedViews fused = from.fuse(state.keyFrame(), settings);
                change(s -> belongs(s, from) ? s.change().fused(fused).build() : s);
            });
        }
        change(s -> {
            if (!belongs(s, from)) {
                return s;
            }
            CheckScreenState.Builder next = s.change().hold(verdict, System.nanoTime() / NS_PER_MS).live(state, photo);
            if (s.source() == ImageSource.FROZEN && photo != null) {
                // a frame that was under way when the picture was frozen
                next.still(photo, s.orientation());
            }
            return showsTheSame(s, state) ? next.build() : judged(next.build());
        });
    }

    /** Whether figures and what is drawn are those of before: most states of a moving camera only say where it is. */
    private static boolean showsTheSame(CheckScreenState shown, LiveState state) {
        return state.update() != null && shown.live() != null && shown.live().update() == state.update()
                && shown.live().keyFrame() == state.keyFrame() && shown.overlay() != null;
    }

    private void failed(CheckRun from, Throwable fault) {
        change(s -> belongs(s, from) ? s.change().checkProblem(problem(Problem.Kind.INTERNAL, fault)).build() : s);
    }

    private static boolean belongs(CheckScreenState state, CheckRun run) {
        return state.run().isPresent() && state.run().getAsInt() == run.number();
    }

    /** The verdict by the target in force, on figures that are there. */
    private CheckScreenState judged(CheckScreenState s) {
        CheckRun current = run();
        if (s.live() == null || current == null || !belongs(s, current)) {
            return s;
        }
        CheckResult found = s.live().update() == null ? null : s.live().update().result();
        CheckResult result = found == null ? null
                : s.result() != null && sameJudgement(s.result(), found, s.target()) ? s.result()
                : found.withTarget(s.target());
        ResultView view = result == null ? null : result == s.result() ? s.view() : ResultView.of(result);
        if (result != s.result() && result != null && result.verdict() == Verdict.FAIL) {
            files(() -> advise(result, view));
        }
        CheckResult drawn = result == s.result() ? s.drawn() : DrawnResult.of(result, s.lensMeasured());
        return redrawn(s.change().result(result, view, drawn)
                .objects(CheckFigures.rows(current.cell(), s.target(), s.live(), result, view)).build());
    }

    private void advise(CheckResult result, ResultView view) {
        Advice advice = Advice.of(result, view);
        change(s -> s.result() == result ? s.change().advice(advice).build() : s);
    }

    private static boolean sameJudgement(CheckResult a, CheckResult found, Target target) {
        return a.estimate() == found.estimate() && a.cell().target().equals(target);
    }

    private CheckScreenState redrawn(CheckScreenState s) {
        CheckRun current = run();
        if (s.live() == null || current == null || !belongs(s, current)) {
            return s;
        }
        PinholeCamera camera = current.cell().camera();
        return s.change().overlay(CheckFigures.overlay(current.cell(), s.live(), s.drawn(),
                s.display().style(s.orientation(), camera.widthPx(), camera.heightPx()))).build();
    }

    // ---- the camera

    /** Frames come on the feed's thread and are looked at there. */
    private final class Frames implements CameraFeed.Listener {
        private final CellDocument cell;
        private final SimpleDateFormat stamp = new SimpleDateFormat("yyyyMMdd-HHmmss", Locale.ROOT);
        private long lastNs = Long.MIN_VALUE;
        private boolean opened;
        private boolean broken;

        Frames(CellDocument cell) {
            this.cell = cell;
        }

        @Override
        public void onOpened(CameraSetup setup) {
            synchronized (runLock) {
                if (cell != document) {
                    return;
                }
                openSetup = setup;
                boolean anew = !opened;
                opened = true;
                change(s -> {
                    CheckScreenState next = redrawn(s.change().setup(setup).fault(null).build());
                    return anew ? next.change().awaitFrame().build() : next;
                });
            }
            lastNs = Long.MIN_VALUE;
            broken = false;
        }

        @Override
        public void onFocusing() {
            if (cell == document) {
                refocusing();
            }
        }

        @Override
        public Detections onFrame(GreyImage luminance, long timestampNs) {
            CameraSetup setup = openSetup;
            // frames of a camera that was opened for the cell before have its calibration
            if (!live || cell != document || setup == null || broken || tooSoon(timestampNs)) {
                return null;
            }
            lastNs = timestampNs;
            try {
                boolean estimated = !LensKnowledge.isMeasured(setup.source());
                CheckRun current = run();
                if (current == null || !current.fits(cell, setup.camera(), estimated)) {
                    current = begin(cell, setup.camera(), estimated, null);
                }
                return current == null ? null
                        : current.frame(luminance, "frame-" + stamp.format(new Date()) + ".png");
            } catch (RuntimeException | OutOfMemoryError e) {
                // the next frame would fail alike
                broken = true;
                change(s -> s.change().checkProblem(problem(Problem.Kind.INTERNAL, e)).build());
                return null;
            }
        }

        private boolean tooSoon(long timestampNs) {
            return lastNs != Long.MIN_VALUE
                    && timestampNs - lastNs < pace.getValue().minFrameIntervalMs() * NS_PER_MS;
        }

        @Override
        public void onFault(CameraFault fault) {
            change(s -> {
                CheckScreenState next = s.change().fault(fault).build();
                return s.canFreeze() ? held(next) : next;
            });
        }
    }

    // ---- another process

    private void restore() {
        SessionMemory m = remembered;
        change(s -> s.change().readingCell(true).build());
        files(() -> {
            if (!takeAgain(m)) {
                return;
            }
            if (m.targetChosen()) {
                change(s -> s.change().target(m.target(), true).build());
            }
            if (m.source() == ImageSource.PHOTO && m.photoCamera() == null) {
                takePhoto(m.photoUri(), photo(m.photoUri()));
            } else if (m.source() == ImageSource.PHOTO) {
                beginPhoto(m.photoUri());
                checkPhoto(document, m.photoUri(), photo(m.photoUri()), m.photoCamera(), m.lensEstimated(),
                        ImageSource.PHOTO, null);
            } else if (m.source() == ImageSource.FROZEN) {
                FrozenFrameFile.Frame frame = frozenFrame.read();
                if (frame != null && m.photoCamera() != null) {
                    beginPhoto(null);
                    checkPhoto(document, null, frame::photo, m.photoCamera(), m.lensEstimated(), ImageSource.FROZEN,
                            frame.orientation());
                }
            }
        });
    }

    private void keepFrozen(CheckScreenState s) {
        try {
            frozenFrame.write(new FrozenFrameFile.Frame(s.still(), s.orientation()));
        } catch (IOException e) {
            // then the frame does not come back after the system has ended the app; the result on the screen stays
            frozenFrame.clear();
        }
    }

    // ---- plumbing

    private void change(UnaryOperator<CheckScreenState> change) {
        changes.onNext(change);
    }

    private void files(Runnable task) {
        if (!closed) {
            fileWork.schedule(() -> {
                try {
                    task.run();
                } catch (OutOfMemoryError e) {
                    // nobody else would hear of it, and Android would end the app
                    change(s -> s.change().readingCell(false).readingPhoto(false).saving(false)
                            .checkProblem(problem(Problem.Kind.INTERNAL, e)).build());
                }
            });
        }
    }

    private static CheckScreenState changed(CheckScreenState state, UnaryOperator<CheckScreenState> change) {
        try {
            return change.apply(state);
        } catch (OutOfMemoryError e) {
            return state.change().checkProblem(problem(Problem.Kind.INTERNAL, e)).build();
        }
    }

    private static Problem problem(Problem.Kind kind, Throwable cause) {
        if (cause instanceof OutOfMemoryError) {
            return new Problem(Problem.Kind.MEMORY, "");
        }
        String message = cause.getMessage();
        if (cause instanceof InputRefusedException) {
            return new Problem(kind, ((InputRefusedException) cause).refusal());
        }
        if (cause instanceof NotSavedException) {
            return new Problem(kind, ((NotSavedException) cause).refusal());
        }
        return new Problem(kind, cause instanceof IOException && message != null ? message : cause.toString());
    }
}
