package org.cellgauge.android.screen;

import android.Manifest;
import android.app.Activity;
import android.content.ActivityNotFoundException;
import android.content.Intent;
import android.content.pm.PackageManager;
import android.graphics.Color;
import android.graphics.SurfaceTexture;
import android.hardware.display.DisplayManager;
import android.net.Uri;
import android.os.Bundle;
import android.os.Handler;
import android.os.Looper;
import android.provider.Settings;
import android.util.TypedValue;
import android.view.Display;
import android.view.Surface;
import android.view.TextureView;
import android.view.View;
import android.view.WindowManager;
import android.widget.Button;
import android.widget.ImageView;
import android.widget.TextView;
import android.widget.Toast;
import io.reactivex.rxjava3.core.Scheduler;
import io.reactivex.rxjava3.disposables.Disposable;
import io.reactivex.rxjava3.schedulers.Schedulers;
import java.util.List;
import org.cellgauge.android.AppParts;
import org.cellgauge.android.AppVersion;
import org.cellgauge.android.CellGaugeApp;
import org.cellgauge.android.R;
import org.cellgauge.android.camera.CameraFeed;
import org.cellgauge.android.files.CellDocument;
import org.cellgauge.android.files.SavedResult;
import org.cellgauge.android.state.CameraPermission;
import org.cellgauge.android.state.CheckScreenState;
import org.cellgauge.android.state.CheckSession;
import org.cellgauge.android.state.FrozenFrameFile;
import org.cellgauge.android.state.ImageSource;
import org.cellgauge.android.state.PictureDisplay;
import org.cellgauge.android.state.SessionMemory;

/** The screen: shows states, hands on what the user does, and opens and closes the camera. It decides nothing else. */
public final class MainActivity extends Activity {
    private static final int REQUEST_CELL = 1;
    private static final int REQUEST_CALIBRATION = 2;
    private static final int REQUEST_PHOTO = 3;
    private static final int REQUEST_PERMISSION = 4;
    // the session's memory is in the same bundle, with names of its own
    private static final String TARGET_TEXT = "screen-target-text";
    private static final String LICENCES_TOP = "screen-licences-top";
    private static final String FIGURES = "screen-figures";
    private static final String FROZEN_FRAME = "screen-frozen-frame";
    /** A finger may miss a marker by so much. */
    private static final float REACH_DP = 32;
    private static final int QUARTER_DEG = 90;
    /** Capital letters of a text of 12 sp, the smallest of the screen, are as high. */
    private static final float LABEL_CAP_SP = 8.5f;

    private final Handler handler = new Handler(Looper.getMainLooper());
    private final Scheduler mainThread = Schedulers.from(handler::post);
    private AppParts parts;
    private CheckSession session;
    private CameraFeed feed;
    private DisplayManager displays;
    private ScreenContent content;
    private Wording words;
    private final DisplayTurns turns = new DisplayTurns();
    private final BackGesture back = new BackGesture(this, this::goBack);
    private Disposable states = Disposable.disposed();
    private Disposable levels = Disposable.disposed();
    private TargetDialog targetDialog;
    private LicencesDialog licencesDialog;
    private ObjectDialog objectDialog;

    private boolean resumed;
    private SurfaceTexture surface;
    /** The cell that the camera is open for; null while it is closed. */
    private CellDocument openFor;
    /** What the open camera was told of its lamp. */
    private boolean shining;

    private ImageView bannerMark;
    private TextView headline;
    private TextView next;
    private View banner;
    private TextView reason;
    private TextView caption;
    private RowList rows;
    private View panel;
    /** Whether the user wants the list of figures at the cost of the picture's size. */
    private boolean figuresWanted;
    private View viewArea;
    private ViewportLayout viewport;
    private PreviewView preview;
    private StillView still;
    private OverlayView overlay;
    private View messageView;
    private Message message;
    private CheckScreenState shown;

    @Override
    protected void onCreate(Bundle saved) {
        super.onCreate(saved);
        parts = ((CellGaugeApp) getApplication()).parts();
        Kept kept = (Kept) getLastNonConfigurationInstance();
        if (kept != null) {
            session = kept.session;
            feed = kept.feed;
        } else {
            SessionMemory memory = saved != null ? SessionMemory.read(saved)
                    : SessionMemory.of(parts.settings().sampling().seed(), parts.memory().lastChoice());
            session = new CheckSession(parts.cellLibrary(), parts.resultArchive(), parts.memory(),
                    new FrozenFrameFile(parts.cacheFolder(), saved == null ? FrozenFrameFile.newId()
                            : saved.getString(FROZEN_FRAME, FrozenFrameFile.newId())),
                    parts.settings(), parts.sessionThreads(), parts.detectors(), memory);
            feed = parts.cameraFeed(getApplicationContext());
        }
        displays = getSystemService(DisplayManager.class);
        words = new Wording(getResources());
        content = new ScreenContent(words, AppVersion.of(this));
        setContentView(R.layout.main);
        SystemBars.keepClear(this);
        findViews();
        wireBar();
        rows.onAction(this::perform);
        rows.onObject(this::showObject);
        ((ZoomLayout) viewArea).onTap(this::tapped);
        figuresWanted = saved != null && saved.getBoolean(FIGURES);
        preview.setSurfaceTextureListener(new PreviewSurface());
        viewArea.addOnLayoutChangeListener((view, left, top, right, bottom, oldLeft, oldTop, oldRight, oldBottom) -> {
            if (right - left != oldRight - oldLeft || bottom - top != oldBottom - oldTop) {
                tellDisplay();
            }
        });
        if (saved == null && !parts.memory().guideShown()) {
            parts.memory().guideIsShown();
            start(new Intent(this, GuideActivity.class));
        }
        if (saved != null && saved.containsKey(TARGET_TEXT)) {
            targetDialog = new TargetDialog(this, session, saved.getStringArray(TARGET_TEXT));
        }
        if (saved != null && saved.containsKey(LICENCES_TOP)) {
            licencesDialog = new LicencesDialog(this, mainThread, saved.getInt(LICENCES_TOP));
        }
        if (kept == null && saved == null) {
            take(getIntent());
        }
    }

    @Override
    protected void onNewIntent(Intent intent) {
        super.onNewIntent(intent);
        take(intent);
    }

    /** What another app gives: a photo is checked, anything else is to be a cell file. */
    private void take(Intent intent) {
        GivenDocument given = GivenDocument.of(intent, getContentResolver());
        if (given == null) {
            return;
        }
        if (given.uri() == null) {
            Toast.makeText(this, R.string.no_file_given, Toast.LENGTH_LONG).show();
            return;
        }
        if (given.isPhoto()) {
            session.openPhoto(given.uri().toString());
        } else {
            keepAccess(given.uri());
            session.chooseCell(given.uri().toString());
        }
    }

    private void findViews() {
        banner = findViewById(R.id.banner);
        bannerMark = findViewById(R.id.banner_mark);
        headline = findViewById(R.id.banner_headline);
        next = findViewById(R.id.banner_next);
        reason = findViewById(R.id.reason);
        caption = findViewById(R.id.caption);
        rows = findViewById(R.id.rows);
        panel = findViewById(R.id.panel);
        viewArea = findViewById(R.id.view_area);
        viewport = findViewById(R.id.viewport);
        preview = findViewById(R.id.preview);
        still = findViewById(R.id.still);
        overlay = findViewById(R.id.overlay);
        messageView = findViewById(R.id.message);
    }

    private void wireBar() {
        findViewById(R.id.freeze).setOnClickListener(v -> {
            if (session.state().source() == ImageSource.LIVE) {
                session.freeze();
            } else {
                session.resume();
            }
        });
        findViewById(R.id.save).setOnClickListener(v -> session.save(shown));
        findViewById(R.id.share).setOnClickListener(v -> share());
        findViewById(R.id.results).setOnClickListener(v -> start(new Intent(this, ResultsActivity.class)));
        findViewById(R.id.target).setOnClickListener(v -> targetDialog = new TargetDialog(this, session, null));
        findViewById(R.id.figures).setOnClickListener(v -> {
            figuresWanted = panel.getVisibility() != View.VISIBLE;
            showPanel(session.state());
        });
        findViewById(R.id.refocus).setOnClickListener(v -> {
            session.refocusing();
            feed.refocus();
        });
        findViewById(R.id.torch).setOnClickListener(v -> session.torch(!session.state().torch()));
        findViewById(R.id.photo).setOnClickListener(v -> chooseDocument(REQUEST_PHOTO, "image/*"));
        findViewById(R.id.cell).setOnClickListener(v -> chooseDocument(REQUEST_CELL, "*/*"));
    }

    // ---- life

    @Override
    protected void onStart() {
        super.onStart();
        tellDisplay();
        displays.registerDisplayListener(turns, handler);
        show();
        states = session.states().observeOn(mainThread, false, 1).subscribe(s -> show());
        levels = parts.thermalLevels().subscribe(session::heat);
    }

    @Override
    protected void onResume() {
        super.onResume();
        resumed = true;
        lookAtPermission();
        session.retryCamera();
        session.lookAtSaved();
        runCamera();
    }

    @Override
    protected void onPause() {
        resumed = false;
        runCamera();
        super.onPause();
    }

    @Override
    protected void onStop() {
        if (!isChangingConfigurations()) {
            // nobody wants it to shine unasked when the app comes back
            session.torch(false);
        }
        states.dispose();
        levels.dispose();
        displays.unregisterDisplayListener(turns);
        super.onStop();
    }

    @Override
    protected void onDestroy() {
        if (targetDialog != null) {
            targetDialog.dismiss();
        }
        if (licencesDialog != null) {
            licencesDialog.dismiss();
        }
        if (objectDialog != null) {
            objectDialog.dismiss();
        }
        if (isFinishing()) {
            session.end();
        } else if (!isChangingConfigurations()) {
            session.close();
        }
        super.onDestroy();
    }

    /** What a turn of the device leaves alone; the feed, too, so that its next opening waits for its last closing. */
    private static final class Kept {
        private final CheckSession session;
        private final CameraFeed feed;

        Kept(CheckSession session, CameraFeed feed) {
            this.session = session;
            this.feed = feed;
        }
    }

    @Override
    public Object onRetainNonConfigurationInstance() {
        return new Kept(session, feed);
    }

    /** The state on the screen. */
    CheckScreenState shown() {
        return shown;
    }

    /** Where the screen's states come from. */
    CheckSession session() {
        return session;
    }

    @Override
    protected void onSaveInstanceState(Bundle out) {
        super.onSaveInstanceState(out);
        session.memory().write(out);
        out.putString(FROZEN_FRAME, session.frozenFrameId());
        out.putBoolean(FIGURES, figuresWanted);
        if (targetDialog != null && targetDialog.isShowing()) {
            out.putStringArray(TARGET_TEXT, targetDialog.texts());
        }
        if (licencesDialog != null && licencesDialog.isShowing()) {
            out.putInt(LICENCES_TOP, licencesDialog.top());
        }
    }

    // ---- camera

    /** Half a turn leaves the layout as it is, so that the activity hears of it from the display alone. */
    private final class DisplayTurns implements DisplayManager.DisplayListener {
        @Override
        public void onDisplayAdded(int id) {
            // not where the activity is
        }

        @Override
        public void onDisplayRemoved(int id) {
            // not where the activity is
        }

        @Override
        public void onDisplayChanged(int id) {
            if (id == Display.DEFAULT_DISPLAY) {
                tellDisplay();
            }
        }
    }

    /** Labels in the picture are drawn for the display as it is. */
    private void tellDisplay() {
        float letters = TypedValue.applyDimension(TypedValue.COMPLEX_UNIT_SP, LABEL_CAP_SP,
                getResources().getDisplayMetrics());
        session.display(new PictureDisplay(rotationDeg(), words.labels(), viewArea.getWidth(), viewArea.getHeight(),
                letters));
    }

    private int rotationDeg() {
        switch (displays.getDisplay(Display.DEFAULT_DISPLAY).getRotation()) {
            case Surface.ROTATION_90:
                return QUARTER_DEG;
            case Surface.ROTATION_180:
                return 2 * QUARTER_DEG;
            case Surface.ROTATION_270:
                return 3 * QUARTER_DEG;
            default:
                return 0;
        }
    }

    private void runCamera() {
        CheckScreenState s = session.state();
        boolean wanted = resumed && surface != null && s.wantsCamera() && s.fault() == null
                && s.permission() == CameraPermission.GRANTED;
        if (wanted && openFor != s.cell()) {
            openFor = s.cell();
            shining = false;
            feed.open(s.liveCalibration(), s.liveFocusDistanceM(), surface,
                    session.cameraListener(s.cell()));
        } else if (!wanted && openFor != null) {
            openFor = null;
            feed.close();
        }
        boolean shines = wanted && s.torch() && s.source() == ImageSource.LIVE;
        if (openFor != null && shines != shining) {
            shining = shines;
            feed.torch(shines);
        }
        if (wanted && s.source() == ImageSource.LIVE) {
            getWindow().addFlags(WindowManager.LayoutParams.FLAG_KEEP_SCREEN_ON);
        } else {
            getWindow().clearFlags(WindowManager.LayoutParams.FLAG_KEEP_SCREEN_ON);
        }
    }

    /** The camera draws as soon as there is something to draw on. */
    private final class PreviewSurface implements TextureView.SurfaceTextureListener {
        @Override
        public void onSurfaceTextureAvailable(SurfaceTexture texture, int width, int height) {
            surface = texture;
            runCamera();
        }

        @Override
        public void onSurfaceTextureSizeChanged(SurfaceTexture texture, int width, int height) {
            // the preview is turned and scaled where the view is
        }

        @Override
        public boolean onSurfaceTextureDestroyed(SurfaceTexture texture) {
            surface = null;
            runCamera();
            return true;
        }

        @Override
        public void onSurfaceTextureUpdated(SurfaceTexture texture) {
            // nothing depends on single frames of the preview
        }
    }

    private void lookAtPermission() {
        boolean granted = checkSelfPermission(Manifest.permission.CAMERA) == PackageManager.PERMISSION_GRANTED;
        if (granted) {
            session.permission(CameraPermission.GRANTED);
        } else if (session.state().permission() != CameraPermission.REFUSED) {
            session.permission(CameraPermission.ASK);
        }
    }

    @Override
    public void onRequestPermissionsResult(int request, String[] permissions, int[] results) {
        if (request != REQUEST_PERMISSION || results.length == 0) {
            return;
        }
        boolean granted = results[0] == PackageManager.PERMISSION_GRANTED;
        session.permission(granted ? CameraPermission.GRANTED
                : shouldShowRequestPermissionRationale(Manifest.permission.CAMERA) ? CameraPermission.ASK
                : CameraPermission.REFUSED);
    }

    // ---- what the user does

    private void perform(Action action) {
        switch (action) {
            case CHOOSE_CELL:
            case CHOOSE_ANOTHER_CELL:
                chooseDocument(REQUEST_CELL, "*/*");
                break;
            case TRY_EXAMPLE:
                session.tryExample();
                break;
            case KEEP_CELL:
            case GO_ON_WITHOUT:
                session.dismissCellProblem();
                break;
            case CHOOSE_CALIBRATION:
                chooseDocument(REQUEST_CALIBRATION, "*/*");
                break;
            case OPEN_PHOTO:
            case OPEN_ANOTHER_PHOTO:
                chooseDocument(REQUEST_PHOTO, "image/*");
                break;
            case BACK_TO_CAMERA:
            case TRY_AGAIN:
                session.resume();
                break;
            case ALLOW_CAMERA:
                requestPermissions(new String[] {Manifest.permission.CAMERA}, REQUEST_PERMISSION);
                break;
            case OPEN_SETTINGS:
                start(new Intent(Settings.ACTION_APPLICATION_DETAILS_SETTINGS,
                        Uri.fromParts("package", getPackageName(), null)));
                break;
            case GUIDE:
                start(new Intent(this, GuideActivity.class));
                break;
            case LICENCES:
                if (licencesDialog == null || !licencesDialog.isShowing()) {
                    licencesDialog = new LicencesDialog(this, mainThread, 0);
                }
                break;
            default:
                session.save(shown);
                break;
        }
    }

    private void chooseDocument(int request, String type) {
        Intent intent = new Intent(Intent.ACTION_OPEN_DOCUMENT).addCategory(Intent.CATEGORY_OPENABLE).setType(type);
        try {
            startActivityForResult(intent, request);
        } catch (ActivityNotFoundException e) {
            Toast.makeText(this, R.string.no_app, Toast.LENGTH_LONG).show();
        }
    }

    private void start(Intent intent) {
        try {
            startActivity(intent);
        } catch (ActivityNotFoundException e) {
            Toast.makeText(this, R.string.no_app, Toast.LENGTH_LONG).show();
        }
    }

    @Override
    protected void onActivityResult(int request, int result, Intent data) {
        Uri uri = result == RESULT_OK && data != null ? data.getData() : null;
        if (uri == null) {
            return;
        }
        if (request != REQUEST_PHOTO) {
            keepAccess(uri);
        }
        switch (request) {
            case REQUEST_CELL:
                session.chooseCell(uri.toString());
                break;
            case REQUEST_CALIBRATION:
                session.chooseCalibration(uri.toString());
                break;
            case REQUEST_PHOTO:
                session.openPhoto(uri.toString());
                break;
            default:
                break;
        }
    }

    /**
     * A cell and its calibration are read again at the next start. A photo is not, and the system keeps access to some
     * hundred documents alone: photos would push the cell out. A screen may read its photo as long as it is there.
     */
    private void keepAccess(Uri uri) {
        try {
            getContentResolver().takePersistableUriPermission(uri, Intent.FLAG_GRANT_READ_URI_PERMISSION);
        } catch (SecurityException e) {
            // a provider that grants for now only: the next start says that the document is to be chosen again
            return;
        }
    }

    @Override
    @SuppressWarnings("deprecation") // what replaces it, BackGesture, does not exist before Android 13
    public void onBackPressed() {
        goBack();
    }

    /** From a held picture back to the camera; else the app steps aside and keeps what it has. */
    private void goBack() {
        if (holdsPicture(session.state())) {
            session.resume();
        } else {
            moveTaskToBack(true);
        }
    }

    private static boolean holdsPicture(CheckScreenState s) {
        return s.cell() != null && s.source() != ImageSource.LIVE;
    }

    /** Where the launcher opened the app, the system's own back leads aside as well, and shows that it will. */
    private boolean endsOnBack() {
        String action = getIntent() == null ? null : getIntent().getAction();
        return action != null && !action.equals(Intent.ACTION_MAIN);
    }

    private void share() {
        SavedResult saved = session.state().saved();
        if (saved == null || saved.uris().isEmpty()) {
            return;
        }
        start(Sharing.of(this, saved));
    }

    // ---- what is shown

    /** Shows the newest state, whichever brought the news: one that waited for its turn may be outdated. */
    private void show() {
        CheckScreenState s = session.state();
        if (s == shown) {
            return;
        }
        shown = s;
        Banner now = Banner.of(s);
        text(headline, content.headline(s));
        bannerMark.setImageResource(now.mark());
        banner.setBackgroundColor(s.held() == null ? getColor(now.colour()) : dimmed(getColor(now.colour())));
        optional(next, content.next(s));
        optional(reason, content.reason(s));
        rows.show(content.rows(s));
        showMessage(s);
        showPicture(s);
        showPanel(s);
        runCamera();
        showBar(s);
        back.own(holdsPicture(s) || endsOnBack());
    }

    /** A colour half-way to the one of nothing: white letters stand out from both. */
    private int dimmed(int colour) {
        int idle = getColor(R.color.banner_idle);
        return Color.rgb((Color.red(colour) + Color.red(idle)) / 2, (Color.green(colour) + Color.green(idle)) / 2,
                (Color.blue(colour) + Color.blue(idle)) / 2);
    }

    private void showPicture(CheckScreenState s) {
        boolean stillShown = s.source() != ImageSource.LIVE;
        int width = 0;
        int height = 0;
        if (s.still() != null) {
            width = s.still().luminance().widthPx();
            height = s.still().luminance().heightPx();
        } else if (!stillShown && s.setup() != null) {
            width = s.setup().camera().widthPx();
            height = s.setup().camera().heightPx();
        }
        viewport.setPicture(s.orientation().uprightWidthPx(width, height),
                s.orientation().uprightHeightPx(width, height));
        preview.configure(s.setup(), s.displayRotationDeg());
        still.setVisibility(stillShown ? View.VISIBLE : View.GONE);
        still.setStill(s.still(), s.orientation());
        overlay.setOverlay(message == null ? s.overlay() : null);
        double[] shift = s.overlayShiftPx();
        overlay.setShift(shift[0], shift[1]);
        overlay.describe(content.spoken(s));
    }

    /** The list takes room from the picture only where the user wants it, or there is no picture. */
    private void showPanel(CheckScreenState s) {
        // what the user asked for and did not get stands there, with what can be done
        boolean amiss = s.saveProblem() != null || s.source() == ImageSource.FROZEN && s.fault() != null
                || s.cell() != null && s.cell().cameraFile() != null && s.cell().calibration() == null;
        boolean shownPanel = figuresWanted || s.cell() == null || message != null || amiss;
        panel.setVisibility(shownPanel ? View.VISIBLE : View.GONE);
        findViewById(R.id.figures).setContentDescription(words.get(shownPanel ? R.string.figures_hide_spoken
                : R.string.figures_show_spoken));
        enable(R.id.figures, s.cell() != null && message == null && !amiss);
    }

    private void tapped(float x, float y) {
        if (message == null) {
            float reach = TypedValue.applyDimension(TypedValue.COMPLEX_UNIT_DIP, REACH_DP,
                    getResources().getDisplayMetrics());
            PictureTap.objectAt(session.state(), x, y, viewport.getWidth(), viewport.getHeight(), reach)
                    .ifPresent(this::showObject);
        }
    }

    private void showObject(int id) {
        objectDialog = new ObjectDialog(this, session, content, id,
                of -> targetDialog = new TargetDialog(this, session, null, of));
    }

    private void showMessage(CheckScreenState s) {
        message = content.message(s);
        messageView.setVisibility(message == null ? View.GONE : View.VISIBLE);
        // keeps its room below a picture where it is empty, so that the picture stays where it is
        caption.setVisibility(message == null ? View.VISIBLE : View.GONE);
        String below = content.caption(s);
        text(caption, below == null ? "" : below);
        // what is covered is not there for a screen reader either
        viewport.setImportantForAccessibility(message == null ? View.IMPORTANT_FOR_ACCESSIBILITY_AUTO
                : View.IMPORTANT_FOR_ACCESSIBILITY_NO_HIDE_DESCENDANTS);
        if (message == null) {
            return;
        }
        TextView title = findViewById(R.id.message_title);
        if (!message.title().contentEquals(title.getText())) {
            messageView.scrollTo(0, 0);
        }
        text(title, message.title());
        text(findViewById(R.id.message_text), message.text());
        int[] buttons = {R.id.message_first, R.id.message_second, R.id.message_third};
        List<Action> actions = message.actions();
        for (int i = 0; i < buttons.length; i++) {
            Button button = findViewById(buttons[i]);
            button.setVisibility(i < actions.size() ? View.VISIBLE : View.GONE);
            if (i < actions.size()) {
                Action action = actions.get(i);
                text(button, action == Action.KEEP_CELL ? words.get(action.label(), content.cellName(s))
                        : words.get(action.label()));
                button.setOnClickListener(v -> perform(action));
            }
        }
    }

    private void showBar(CheckScreenState s) {
        boolean liveShown = s.source() == ImageSource.LIVE;
        Button freeze = findViewById(R.id.freeze);
        freeze.setEnabled(s.cell() != null && (s.canFreeze() || !liveShown));
        text(freeze, words.get(liveShown ? R.string.freeze : R.string.resume));
        freeze.setContentDescription(words.get(liveShown ? R.string.freeze_spoken : R.string.resume_spoken));
        freeze.setCompoundDrawablesWithIntrinsicBounds(0,
                liveShown ? R.drawable.ic_freeze : R.drawable.ic_resume, 0, 0);
        enable(R.id.save, s.canSave());
        enable(R.id.share, s.canShare());
        enable(R.id.target, s.cell() != null);
        enable(R.id.refocus, s.setup() != null && liveShown && openFor != null);
        enable(R.id.photo, s.cell() != null);
        Button torch = findViewById(R.id.torch);
        torch.setVisibility(s.setup() != null && s.setup().hasTorch() ? View.VISIBLE : View.GONE);
        torch.setEnabled(liveShown && openFor != null);
        torch.setContentDescription(words.get(s.torch() ? R.string.torch_off_spoken : R.string.torch_on_spoken));
        torch.setCompoundDrawablesWithIntrinsicBounds(0,
                s.torch() ? R.drawable.ic_torch_on : R.drawable.ic_torch, 0, 0);
        View target = findViewById(R.id.target);
        target.setContentDescription(words.get(R.string.target_spoken, content.targetSpoken(s)));
    }

    private void enable(int id, boolean enabled) {
        findViewById(id).setEnabled(enabled);
    }

    private static void optional(TextView view, String text) {
        view.setVisibility(text == null || text.isEmpty() ? View.GONE : View.VISIBLE);
        text(view, text == null ? "" : text);
    }

    /** Text that has not changed is left alone, so that a selection in it stays. */
    private static void text(TextView view, String text) {
        if (!text.contentEquals(view.getText())) {
            view.setText(text);
        }
    }
}
