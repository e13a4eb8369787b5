package org.cellgauge.android.camera;

import android.content.Context;
import android.graphics.SurfaceTexture;
import java.util.OptionalDouble;
import java.util.concurrent.CountDownLatch;
import org.cellgauge.geometry.PinholeCamera;

/**
 * The device's camera by Android's Camera2.
 *
 * <p>Every opening is a {@link CameraRun} with a thread of its own, on which all of its camera's callbacks and all
 * calls of the listener come; a run begins only once the one before it has let go of its camera and its listener. So
 * there is no state in which a call could come at the wrong time.
 */
public final class Camera2Feed implements CameraFeed {
    private final Context context;
    private CameraRun run;
    /** Counts down when the last run has let go; the run itself is not kept, nor is its listener. */
    private CountDownLatch lastEnd = new CountDownLatch(0);

    /**
     * A closed camera.
     *
     * @param context of the app; its application context is kept
     */
    public Camera2Feed(Context context) {
        this.context = context.getApplicationContext();
    }

    @Override
    public void open(PinholeCamera calibration, OptionalDouble focusDistanceM, SurfaceTexture preview,
            Listener listener) {
        close();
        run = new CameraRun(context, lastEnd, calibration, focusDistanceM, preview, listener);
        lastEnd = run.ended();
        run.start();
    }

    @Override
    public void refocus() {
        if (run != null) {
            run.refocus();
        }
    }

    @Override
    public void torch(boolean on) {
        if (run != null) {
            run.torch(on);
        }
    }

    @Override
    public void close() {
        if (run != null) {
            run.close();
            run = null;
        }
    }
}
