package org.cellgauge.android.state;

import java.util.Collections;
import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.cellgauge.android.camera.CameraFault;
import org.cellgauge.android.camera.CameraSetup;
import org.cellgauge.android.device.ThermalLevel;
import org.cellgauge.android.files.CellDocument;
import org.cellgauge.android.files.Photo;
import org.cellgauge.android.files.SavedResult;
import org.cellgauge.cell.Target;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.CheckUpdate;
import org.cellgauge.check.Reason;
import org.cellgauge.check.Verdict;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.overlay.ImageOrientation;
import org.cellgauge.internal.overlay.Overlay;
import org.cellgauge.live.LiveState;
import org.cellgauge.output.ResultView;

/** All that the screen shows; immutable. The screen knows nothing else, and changes nothing but through a session. */
public final class CheckScreenState {
    /** Nothing was chosen yet. */
    public static final CheckScreenState EMPTY = new CheckScreenState(new Builder());

    private final Builder v;

    private CheckScreenState(Builder b) {
        v = new Builder(b);
    }

    /**
     * The cell in use.
     *
     * @return null before one was chosen
     */
    public CellDocument cell() {
        return v.cell;
    }

    /**
     * Whether a cell file is being read.
     *
     * @return true until it is there or was refused
     */
    public boolean readingCell() {
        return v.readingCell;
    }

    /**
     * Why the last cell or calibration file was not taken; the cell in use stays.
     *
     * @return null where there is nothing to say
     */
    public Problem cellProblem() {
        return v.cellProblem;
    }

    /**
     * The target in force.
     *
     * @return largest allowed standard deviation of any axis, mm; empty where none is set
     */
    public OptionalDouble targetStdMm() {
        return v.target.oneStdMm();
    }

    /**
     * The target in force, whatever it asks for.
     *
     * @return what the user chose, or what the cell file states
     */
    public Target target() {
        return v.target;
    }

    /**
     * What is shown.
     *
     * @return never null
     */
    public ImageSource source() {
        return v.source;
    }

    /**
     * The picture in place of the camera's.
     *
     * @return the frozen frame or the photo; null while live or while a photo is read
     */
    public Photo still() {
        return v.source == ImageSource.LIVE ? null : v.still;
    }

    /**
     * How the picture is turned and mirrored on the display.
     *
     * @return from the image as it comes, or was stored, to the upright image
     */
    public ImageOrientation orientation() {
        if (v.source == ImageSource.LIVE && v.setup != null) {
            return ImageOrientation.of(v.setup.sensorOrientationDeg(), v.display.rotationDeg(), v.setup.frontFacing());
        }
        return v.source == ImageSource.FROZEN && v.stillOrientation != null ? v.stillOrientation
                : ImageOrientation.IDENTITY;
    }

    /**
     * Whether a photo is being read.
     *
     * @return true until it is there or was refused
     */
    public boolean readingPhoto() {
        return v.readingPhoto;
    }

    /**
     * Whether a photo came before any cell was chosen: it is checked with the next one.
     *
     * @return false once there is a cell
     */
    public boolean photoWaits() {
        return v.photoWaits;
    }

    /**
     * Whether the camera of the photo on the screen is known for another image size of its shape, and was scaled.
     *
     * @return false where it is the size that it is known for, or no photo is shown
     */
    public boolean photoCameraScaled() {
        PinholeCamera known = v.cell == null || v.cell.calibration() == null
                ? v.setup == null ? null : v.setup.camera() : v.cell.calibration();
        return v.source == ImageSource.PHOTO && v.photoCamera != null && known != null
                && known.widthPx() != v.photoCamera.widthPx();
    }

    /**
     * Why the photo is not checked.
     *
     * @return null where there is nothing to say
     */
    public Problem photoProblem() {
        return v.photoProblem;
    }

    /**
     * How the camera delivers, as it said when it was opened last.
     *
     * @return null before that
     */
    public CameraSetup setup() {
        return v.setup;
    }

    /**
     * Whether the lens of what is shown was calibrated.
     *
     * @return false where it is estimated along, from what is known of devices' lenses beforehand; true as well where
     *     no camera is known yet
     */
    public boolean lensMeasured() {
        return v.source == ImageSource.LIVE ? v.setup == null || LensKnowledge.isMeasured(v.setup.source())
                : !v.lensEstimated;
    }

    /**
     * Why the camera does not deliver.
     *
     * @return null while it does, or is being opened
     */
    public CameraFault fault() {
        return v.fault;
    }

    /**
     * Whether the camera may be used.
     *
     * @return never null
     */
    public CameraPermission permission() {
        return v.permission;
    }

    /**
     * Whether the lamp beside the camera is to shine.
     *
     * @return what the user chose
     */
    public boolean torch() {
        return v.torch;
    }

    /**
     * How warm the device is.
     *
     * @return never null
     */
    public ThermalLevel heat() {
        return v.heat;
    }

    /**
     * Whether the device is cool enough for the camera.
     *
     * @return false where it is off for that reason
     */
    public boolean allowsCamera() {
        return ThermalPace.allowsCamera(v.heat);
    }

    /**
     * Whether the device is cool enough for chains.
     *
     * @return false where every figure stays preliminary for that reason
     */
    public boolean allowsSampling() {
        return ThermalPace.of(v.heat).sampling();
    }

    /**
     * Rotation of what is drawn from the device's natural orientation.
     *
     * @return 0, 90, 180 or 270 degrees
     */
    public int displayRotationDeg() {
        return v.display.rotationDeg();
    }

    /**
     * What the check knows.
     *
     * @return null before the first frame, or while another cell or photo is read
     */
    public LiveState live() {
        return v.live;
    }

    /**
     * How far the check has come.
     *
     * @return null where there is none
     */
    public LiveState.Phase phase() {
        return v.live == null ? null : v.live.phase();
    }

    /**
     * Iterations each chain has run.
     *
     * @return 0 before the chains
     */
    public int iterationsPerChain() {
        CheckUpdate update = v.live == null ? null : v.live.update();
        return update == null ? 0 : update.iterationsPerChain();
    }

    /**
     * The last verdict, while the camera's view has left it and there is no newer one.
     *
     * @return null where there is none, or the one in force is shown
     */
    public HeldVerdict held() {
        return v.source == ImageSource.LIVE && v.result == null && !awaitsFrame() ? v.held : null;
    }

    /**
     * The result that the screen shows: of the view, or the last one.
     *
     * @return null where there is none
     */
    public CheckResult shownResult() {
        return v.result != null ? v.result : held() == null ? null : held().result();
    }

    /**
     * All that {@link #shownResult()} says.
     *
     * @return null where there is none
     */
    public ResultView shownView() {
        return v.result != null ? v.view : held() == null ? null : held().view();
    }

    /** The result as it is drawn: in no green where nobody measured the lens. */
    CheckResult drawn() {
        return v.drawn;
    }

    /** The frame or photo that the result on the screen belongs to. */
    Photo shownPhoto() {
        return v.result != null ? v.checked : held() == null ? null : held().photo();
    }

    /**
     * The result, judged by the target in force.
     *
     * @return null before the chains have ended
     */
    public CheckResult result() {
        return v.result;
    }

    /**
     * All that the result says.
     *
     * @return null before the chains have ended
     */
    public ResultView view() {
        return v.view;
    }

    /**
     * What would meet a target that the result misses.
     *
     * @return the cheapest that is known, or null
     */
    public Advice advice() {
        return v.advice;
    }

    /**
     * The views of this cell that were judged, taken together.
     *
     * @return null before the first one
     */
    public FusedViews fused() {
        return v.fused;
    }

    /**
     * The verdict by the target in force.
     *
     * @return null before the chains have ended
     */
    public Verdict verdict() {
        return v.result == null ? null : v.result.verdict();
    }

    /**
     * Why.
     *
     * @return core's reason in parts; null before the chains have ended
     */
    public Reason reason() {
        return v.result == null ? null : v.result.finding();
    }

    /**
     * What is said of each object of the cell.
     *
     * @return in the order of the cell; empty where there is no check; unmodifiable
     */
    public List<ObjectRow> objects() {
        return awaitsFrame() ? Collections.emptyList() : held() == null ? v.objects : held().objects();
    }

    /**
     * References of the cell that are not in view.
     *
     * @return marker ids; unmodifiable
     */
    public List<Integer> missingReferences() {
        return v.live == null ? Collections.emptyList() : v.live.missingReferences();
    }

    /**
     * What to draw over the picture, in px of the upright image.
     *
     * @return null for nothing
     */
    public Overlay overlay() {
        return awaitsFrame() ? null : v.overlay;
    }

    /**
     * By how much the camera's picture has moved as a whole since the frame that the overlay belongs to.
     *
     * @return to the right and downwards, px of the upright image; 0 where a held picture is shown
     */
    public double[] overlayShiftPx() {
        if (v.source != ImageSource.LIVE || v.live == null || v.live.keyFrame() == null) {
            return new double[2];
        }
        int width = v.live.keyFrame().widthPx();
        int height = v.live.keyFrame().heightPx();
        double[] from = orientation().map(0, 0, width, height);
        double[] to = orientation().map(v.live.shiftXPx(), v.live.shiftYPx(), width, height);
        return new double[] {to[0] - from[0], to[1] - from[1]};
    }

    /**
     * Whether the camera's picture has begun anew and no frame of it was looked at yet, as while the lens still moves:
     * what is known belongs to a picture from before, and lies nowhere on this one.
     *
     * @return true until the first frame
     */
    public boolean awaitsFrame() {
        return v.source == ImageSource.LIVE && v.live != null && v.awaitedFrame > 0;
    }

    /**
     * The frame or photo that the figures belong to.
     *
     * @return null where there are no figures
     */
    public Photo checkedPhoto() {
        return v.checked;
    }

    /**
     * Whether the result is being written.
     *
     * @return true until it is there or failed
     */
    public boolean saving() {
        return v.saving;
    }

    /**
     * The result that was kept last; perhaps not the one on the screen, see {@link #showsSaved()}.
     *
     * @return null where none was
     */
    public SavedResult saved() {
        return v.saved;
    }

    /**
     * Whether the result on the screen is the one that was kept last.
     *
     * @return true if so, with the same target
     */
    public boolean showsSaved() {
        return v.saved != null && shownResult() == v.savedResult;
    }

    /** Whether a result is the one that was kept last. */
    boolean keeps(CheckResult result) {
        return v.saved != null && result == v.savedResult;
    }

    /**
     * Why the result was not kept.
     *
     * @return null where there is nothing to say
     */
    public Problem saveProblem() {
        return v.saveProblem;
    }

    /**
     * A fault of the program in the check.
     *
     * @return null where there is none
     */
    public Problem checkProblem() {
        return v.checkProblem;
    }

    /**
     * Whether the camera should run as far as the user is concerned; permission and faults are another matter.
     *
     * @return true with a cell, unless a photo is shown or the device is too hot
     */
    public boolean wantsCamera() {
        return v.cell != null && v.source != ImageSource.PHOTO && allowsCamera();
    }

    /**
     * The calibration that the device's camera is to be opened with.
     *
     * @return that of the cell in use, or null: the device's own model. The bundled example's camera is not this one
     */
    public PinholeCamera liveCalibration() {
        return v.cell == null || v.cell.uri() == null ? null : v.cell.calibration();
    }

    /**
     * The distance that the device's camera is to be focused at.
     *
     * @return that of {@link #liveCalibration()}, m; empty where it states none
     */
    public OptionalDouble liveFocusDistanceM() {
        return liveCalibration() == null ? OptionalDouble.empty() : v.cell.cell().focusDistanceM();
    }

    /**
     * Whether there is a frame to freeze.
     *
     * @return true while live with figures
     */
    public boolean canFreeze() {
        return v.source == ImageSource.LIVE && v.live != null && v.live.keyFrame() != null;
    }

    /**
     * Whether there is a result to keep that was not kept yet.
     *
     * @return true once the chains have ended, and as long as their verdict is shown
     */
    public boolean canSave() {
        return shownResult() != null && shownPhoto() != null && !v.saving && !showsSaved();
    }

    /**
     * Whether there is a kept result to hand on.
     *
     * @return true after one was saved
     */
    public boolean canShare() {
        return v.saved != null;
    }

    /**
     * What is needed to come back to this state in another process.
     *
     * @param seed of the session
     * @return the memory
     */
    SessionMemory memory(long seed) {
        if (v.cell == null) {
            return SessionMemory.nothing(seed);
        }
        return new SessionMemory(seed, v.cell.uri(), v.calibrationUri, v.targetChosen, v.target, v.source,
                v.photoUri, v.photoCamera, v.lensEstimated);
    }

    /** The camera of the photo or frozen frame. */
    PinholeCamera photoCamera() {
        return v.photoCamera;
    }

    /** Whether the lens of that camera is estimated along. */
    boolean lensEstimated() {
        return v.lensEstimated;
    }

    /** Whether the target is the user's and not the cell file's. */
    boolean targetChosen() {
        return v.targetChosen;
    }

    /** The photo that is shown; null for the bundled one or none. */
    String photoUri() {
        return v.photoUri;
    }

    /** The calibration file in use, or null. */
    String calibrationUri() {
        return v.calibrationUri;
    }

    /** How the display shows the picture. */
    PictureDisplay display() {
        return v.display;
    }

    /**
     * Which check the state belongs to; a state of an earlier one is stale.
     *
     * @return the number
     */
    OptionalInt run() {
        return v.run;
    }

    Builder change() {
        return new Builder(v);
    }

    /** A state in the making. */
    static final class Builder {
        private CellDocument cell;
        private boolean readingCell;
        private Problem cellProblem;
        private Target target = Target.NONE;
        private ImageSource source = ImageSource.LIVE;
        private Photo still;
        private ImageOrientation stillOrientation;
        private boolean readingPhoto;
        private boolean photoWaits;
        private Problem photoProblem;
        private CameraSetup setup;
        private CameraFault fault;
        private CameraPermission permission = CameraPermission.UNKNOWN;
        private ThermalLevel heat = ThermalLevel.NORMAL;
        private boolean torch;
        private PictureDisplay display = PictureDisplay.UNKNOWN;
        /** Number of the first frame of a picture that has begun anew; 0 where one was looked at. */
        private long awaitedFrame;
        private OptionalInt run = OptionalInt.empty();
        private LiveState live;
        private CheckResult result;
        private ResultView view;
        private CheckResult drawn;
        private Advice advice;
        private HeldVerdict held;
        private FusedViews fused;
        private long shownAtMs;
        private List<ObjectRow> objects = Collections.emptyList();
        private Overlay overlay;
        private Photo checked;
        private boolean saving;
        private SavedResult saved;
        private CheckResult savedResult;
        private Problem saveProblem;
        private Problem checkProblem;
        private String calibrationUri;
        private boolean targetChosen;
        private String photoUri;
        private PinholeCamera photoCamera;
        private boolean lensEstimated;

        private Builder() {
        }

        private Builder(Builder o) {
            cell = o.cell;
            readingCell = o.readingCell;
            cellProblem = o.cellProblem;
            target = o.target;
            source = o.source;
            still = o.still;
            stillOrientation = o.stillOrientation;
            readingPhoto = o.readingPhoto;
            photoWaits = o.photoWaits;
            photoProblem = o.photoProblem;
            setup = o.setup;
            fault = o.fault;
            permission = o.permission;
            heat = o.heat;
            torch = o.torch;
            display = o.display;
            awaitedFrame = o.awaitedFrame;
            run = o.run;
            live = o.live;
            result = o.result;
            view = o.view;
            drawn = o.drawn;
            advice = o.advice;
            held = o.held;
            fused = o.fused;
            shownAtMs = o.shownAtMs;
            objects = o.objects;
            overlay = o.overlay;
            checked = o.checked;
            saving = o.saving;
            saved = o.saved;
            savedResult = o.savedResult;
            saveProblem = o.saveProblem;
            checkProblem = o.checkProblem;
            calibrationUri = o.calibrationUri;
            targetChosen = o.targetChosen;
            photoUri = o.photoUri;
            photoCamera = o.photoCamera;
            lensEstimated = o.lensEstimated;
        }

        Builder cell(CellDocument value) {
            cell = value;
            return this;
        }

        Builder readingCell(boolean value) {
            readingCell = value;
            return this;
        }

        Builder cellProblem(Problem value) {
            cellProblem = value;
            return this;
        }

        Builder target(Target value, boolean chosen) {
            target = value;
            targetChosen = chosen;
            return this;
        }

        Builder calibrationUri(String value) {
            calibrationUri = value;
            return this;
        }

        Builder photo(String uri, PinholeCamera camera, boolean estimated) {
            photoUri = uri;
            photoCamera = camera;
            lensEstimated = estimated;
            return this;
        }

        Builder source(ImageSource value) {
            source = value;
            return this;
        }

        Builder still(Photo value, ImageOrientation orientation) {
            still = value;
            stillOrientation = orientation;
            return this;
        }

        Builder readingPhoto(boolean value) {
            readingPhoto = value;
            return this;
        }

        Builder photoWaits(boolean value) {
            photoWaits = value;
            return this;
        }

        Builder photoProblem(Problem value) {
            photoProblem = value;
            return this;
        }

        Builder setup(CameraSetup value) {
            setup = value;
            return this;
        }

        Builder fault(CameraFault value) {
            fault = value;
            return this;
        }

        Builder permission(CameraPermission value) {
            permission = value;
            return this;
        }

        Builder heat(ThermalLevel value) {
            heat = value;
            return this;
        }

        Builder torch(boolean value) {
            torch = value;
            return this;
        }

        Builder display(PictureDisplay value) {
            display = value;
            return this;
        }

        /** No check, or one that has not said anything yet. */
        Builder noCheck(OptionalInt newRun) {
            run = newRun;
            live = null;
            awaitedFrame = Math.min(awaitedFrame, 1);
            result = null;
            view = null;
            drawn = null;
            advice = null;
            held = null;
            fused = null;
            objects = Collections.emptyList();
            overlay = null;
            checked = null;
            checkProblem = null;
            return this;
        }

        Builder awaitFrame() {
            awaitedFrame = live == null ? 1 : live.frameNumber() + 1;
            return this;
        }

        Builder live(LiveState value, Photo checkedPhoto) {
            live = value;
            awaitedFrame = value.frameNumber() >= awaitedFrame ? 0 : awaitedFrame;
            checked = checkedPhoto;
            return this;
        }

        Builder result(CheckResult value, ResultView ofValue, CheckResult drawnAs) {
            drawn = drawnAs;
            advice = value == result ? advice : null;
            result = value;
            view = ofValue;
            return this;
        }

        /** The verdict stays when the view leaves it; called before the newer state is taken over. */
        Builder hold(boolean verdictThere, long nowMs) {
            if (verdictThere) {
                shownAtMs = nowMs;
                held = null;
            } else if (result != null && checked != null && source == ImageSource.LIVE) {
                held = new HeldVerdict(result, view, objects, checked, shownAtMs, Math.max(0, nowMs - shownAtMs));
            } else if (held != null) {
                held = held.at(nowMs);
            }
            return this;
        }

        Builder held(HeldVerdict value) {
            held = value;
            return this;
        }

        Builder fused(FusedViews value) {
            fused = value;
            return this;
        }

        Builder advice(Advice value) {
            advice = value;
            return this;
        }

        Builder objects(List<ObjectRow> value) {
            objects = Collections.unmodifiableList(value);
            return this;
        }

        Builder overlay(Overlay value) {
            overlay = value;
            return this;
        }

        Builder saving(boolean value) {
            saving = value;
            return this;
        }

        Builder saved(SavedResult value, CheckResult of) {
            saved = value;
            savedResult = of;
            return this;
        }

        Builder saveProblem(Problem value) {
            saveProblem = value;
            return this;
        }

        Builder checkProblem(Problem value) {
            checkProblem = value;
            return this;
        }

        CheckScreenState build() {
            return new CheckScreenState(this);
        }
    }
}
