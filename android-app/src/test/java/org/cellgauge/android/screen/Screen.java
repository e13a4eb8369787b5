package org.cellgauge.android.screen;

import static org.junit.Assert.fail;
import static org.robolectric.Shadows.shadowOf;

import android.Manifest;
import android.app.Activity;
import android.content.Context;
import android.content.Intent;
import android.content.pm.ApplicationInfo;
import android.graphics.Bitmap;
import android.graphics.Canvas;
import android.graphics.SurfaceTexture;
import android.hardware.display.DisplayManager;
import android.os.Build;
import android.os.Bundle;
import android.os.Looper;
import android.util.Pair;
import android.view.Display;
import android.view.View;
import android.view.ViewGroup;
import android.widget.TextView;
import android.window.OnBackInvokedCallback;
import java.io.File;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.BooleanSupplier;
import org.cellgauge.android.R;
import org.cellgauge.android.files.CellDocument;
import org.cellgauge.android.files.Photo;
import org.cellgauge.android.state.CheckScreenState;
import org.cellgauge.android.state.CheckSession;
import org.cellgauge.internal.overlay.ImageOrientation;
import org.robolectric.Robolectric;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.android.controller.ActivityController;
import org.robolectric.util.ReflectionHelpers;

/** The real activity, and what a user can do with it. */
final class Screen implements AutoCloseable {
    static final String TABLET_LANDSCAPE = "w1280dp-h800dp-land-notnight-mdpi";
    static final String TABLET_PORTRAIT = "w800dp-h1280dp-port-notnight-mdpi";
    static final String PHONE_LANDSCAPE = "w740dp-h360dp-land-notnight-xhdpi";
    static final String PHONE_PORTRAIT = "w360dp-h740dp-port-notnight-xhdpi";
    private static final int PATIENCE_MS = 60_000;

    private ActivityController<MainActivity> controller;

    private Screen(ActivityController<MainActivity> controller) {
        this.controller = controller;
    }

    static TestApp app() {
        return (TestApp) RuntimeEnvironment.getApplication();
    }

    static void allowCamera() {
        shadowOf(app()).grantPermissions(Manifest.permission.CAMERA);
    }

    /** The app is started, its preview ready. */
    static Screen start() {
        return start(null);
    }

    /** The app is started, perhaps with what the system kept of it. */
    static Screen start(Bundle saved) {
        backIsOwn();
        Screen screen = new Screen(Robolectric.buildActivity(MainActivity.class));
        if (saved == null) {
            screen.controller.setup();
        } else {
            screen.controller.setup(saved);
        }
        screen.settle();
        screen.previewIsReady();
        return screen;
    }

    /** The manifest says so ({@code ApkTest}); Robolectric reads manifests as Androids did that knew nothing of it. */
    static void backIsOwn() {
        if (Build.VERSION.SDK_INT >= Build.VERSION_CODES.TIRAMISU) {
            ApplicationInfo info = app().getApplicationInfo();
            int flags = ReflectionHelpers.getField(info, "privateFlagsExt");
            int own = ReflectionHelpers.getStaticField(ApplicationInfo.class,
                    "PRIVATE_FLAG_EXT_ENABLE_ON_BACK_INVOKED_CALLBACK");
            ReflectionHelpers.setField(info, "privateFlagsExt", flags | own);
        }
    }

    /** The app is started with a cell, and the camera is open on it. */
    static Screen live(CellDocument document, int sensorOrientationDeg, boolean front) {
        allowCamera();
        Screen screen = start();
        screen.chooseCell(document);
        app().feed.opened(document.cell().camera(), sensorOrientationDeg, front);
        screen.settle();
        return screen;
    }

    MainActivity activity() {
        return controller.get();
    }

    CheckSession session() {
        return activity().session();
    }

    CheckScreenState state() {
        return session().state();
    }

    CheckScreenState shown() {
        return activity().shown();
    }

    void previewIsReady() {
        PreviewView preview = find(R.id.preview);
        preview.getSurfaceTextureListener().onSurfaceTextureAvailable(new SurfaceTexture(0), 100, 100);
        settle();
    }

    void chooseCell(CellDocument document) {
        app().library.cells.put(document.uri(), () -> document);
        session().chooseCell(document.uri());
        settle();
    }

    void openPhoto(Photo photo) {
        app().library.photos.put("content://photos/" + photo.name(), () -> photo);
        session().openPhoto("content://photos/" + photo.name());
        settle();
    }

    /** Frames of a camera held still over a fixture, until the chains have ended. */
    void holdStillUntilResult(Fixture fixture) {
        app().feed.frame(fixture.image());
        // of frames that come faster than they are looked at, only the newest is
        until("quick look", () -> state().live() != null);
        app().feed.frame(fixture.image());
        until("result", () -> state().verdict() != null);
    }

    <T extends View> T find(int id) {
        return activity().findViewById(id);
    }

    String text(int id) {
        TextView view = find(id);
        return view.getVisibility() == View.VISIBLE ? plain(view.getText()) : "";
    }

    /** Text with plain spaces, where the app has ones that do not break. */
    static String plain(CharSequence text) {
        return text.toString().replace('\u00a0', ' ');
    }

    void tap(int id) {
        View view = find(id);
        if (!view.isEnabled() || !view.isShown()) {
            fail(activity().getResources().getResourceEntryName(id) + " cannot be tapped");
        }
        view.performClick();
        settle();
    }

    /** All that waits on the main thread is done. */
    void settle() {
        shadowOf(Looper.getMainLooper()).idle();
    }

    void until(String what, BooleanSupplier condition) {
        long end = System.currentTimeMillis() + PATIENCE_MS;
        settle();
        while (!(condition.getAsBoolean() && activity().shown() == state())) {
            if (System.currentTimeMillis() > end) {
                fail(what + " does not come; the screen says: " + text(R.id.banner_headline) + " / "
                        + text(R.id.reason));
            }
            try {
                Thread.sleep(2);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
            settle();
        }
    }

    /** The device is turned: the system makes the activity anew. */
    void turn(String qualifiers, int rotation) {
        turnDisplay(rotation);
        RuntimeEnvironment.setQualifiers(qualifiers);
        recreate();
    }

    static void turnDisplay(int rotation) {
        DisplayManager displays = (DisplayManager) app().getSystemService(Context.DISPLAY_SERVICE);
        shadowOf(displays.getDisplay(Display.DEFAULT_DISPLAY)).setRotation(rotation);
    }

    void recreate() {
        controller.recreate();
        settle();
        previewIsReady();
    }

    /** The system ends the process: what is left is what it was given to keep. */
    Bundle killed() {
        Bundle kept = new Bundle();
        controller.pause().saveInstanceState(kept).stop().destroy();
        settle();
        return kept;
    }

    /** Another app opens or shares something while this one runs. */
    void give(Intent intent) {
        controller.newIntent(intent);
        settle();
    }

    /**
     * A back gesture or button, as this Android tells the app of it.
     *
     * @return whether the app had a use for it; else it is the system's
     */
    boolean back() {
        boolean own = back(activity());
        settle();
        return own;
    }

    /** The same of any screen, without waiting for what comes of it. */
    @SuppressWarnings("deprecation") // of old Androids
    static boolean back(Activity activity) {
        if (Build.VERSION.SDK_INT < Build.VERSION_CODES.TIRAMISU) {
            activity.onBackPressed();
            return true;
        }
        Object window = activity.getOnBackInvokedDispatcher();
        List<Pair<OnBackInvokedCallback, Integer>> waiting = ReflectionHelpers.getField(window, "mCallbacks");
        Object actual = ReflectionHelpers.getField(window, "mActualDispatcher");
        OnBackInvokedCallback own = null;
        if (actual != null) {
            TreeMap<Integer, List<OnBackInvokedCallback>> byPriority =
                    ReflectionHelpers.getField(actual, "mOnBackInvokedCallbacks");
            for (Map.Entry<Integer, List<OnBackInvokedCallback>> entry : byPriority.entrySet()) {
                own = entry.getKey() >= 0 && !entry.getValue().isEmpty() ? entry.getValue().get(0) : own;
            }
        } else {
            for (Pair<OnBackInvokedCallback, Integer> each : waiting) {
                own = each.second >= 0 ? each.first : own;
            }
        }
        if (own != null) {
            own.onBackInvoked();
        }
        return own != null;
    }

    void pause() {
        controller.pause();
        settle();
    }

    void resume() {
        controller.resume();
        settle();
    }

    // ---- pictures

    /** What is on the screen; the camera's own picture is missing there, since no camera drew it. */
    Bitmap picture() {
        return picture(activity().getWindow().getDecorView());
    }

    static Bitmap picture(View view) {
        if (Build.VERSION.SDK_INT < Build.VERSION_CODES.P) {
            withoutFadingEdges(view);
        }
        Bitmap bitmap = Bitmap.createBitmap(view.getWidth(), view.getHeight(), Bitmap.Config.ARGB_8888);
        view.draw(new Canvas(bitmap));
        return bitmap;
    }

    /**
     * Androids before 9 fade edges by layers that leave the canvas unclipped. The drawing code that Robolectric runs is
     * of a later one, which knows no such layers: it would draw the edges and nothing between them.
     */
    private static void withoutFadingEdges(View view) {
        view.setVerticalFadingEdgeEnabled(false);
        view.setHorizontalFadingEdgeEnabled(false);
        if (view instanceof ViewGroup) {
            for (int i = 0; i < ((ViewGroup) view).getChildCount(); i++) {
                withoutFadingEdges(((ViewGroup) view).getChildAt(i));
            }
        }
    }

    /** Keeps the screen as a PNG, with a photo where the camera's picture would be. */
    void keep(String name, Photo behind) {
        StillView still = find(R.id.still);
        if (behind != null && still.getVisibility() != View.VISIBLE) {
            ImageOrientation orientation = state().orientation();
            View viewport = find(R.id.viewport);
            still.setVisibility(View.VISIBLE);
            still.setStill(behind, orientation);
            // not by the main thread, which would show the next state and hide it again
            still.layout(0, 0, viewport.getWidth(), viewport.getHeight());
        }
        write(name, picture());
    }

    static void write(String name, Bitmap bitmap) {
        File folder = new File(System.getProperty("cellgauge.root"), "android-app/build/screenshots/"
                + (Build.VERSION.SDK_INT < Build.VERSION_CODES.O_MR1 ? "android-8" : "android-15"));
        folder.mkdirs();
        try (OutputStream out = new FileOutputStream(new File(folder, name + ".png"))) {
            bitmap.compress(Bitmap.CompressFormat.PNG, 100, out);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    public void close() {
        if (activity().isDestroyed()) {
            return;
        }
        controller.pause().stop().destroy();
        settle();
    }
}
