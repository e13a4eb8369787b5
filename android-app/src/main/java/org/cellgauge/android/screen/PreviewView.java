package org.cellgauge.android.screen;

import android.content.Context;
import android.graphics.Matrix;
import android.util.AttributeSet;
import android.view.TextureView;
import org.cellgauge.android.camera.CameraSetup;
import org.cellgauge.internal.overlay.ImageOrientation;

/** The camera's picture: it fills the view, upright however the display is turned, a front camera's mirrored. */
public final class PreviewView extends TextureView {
    private final Matrix matrix = new Matrix();
    private CameraSetup setup;
    private int displayRotationDeg;

    /**
     * For the layout's file.
     *
     * @param context of the activity
     * @param attributes of the file
     */
    public PreviewView(Context context, AttributeSet attributes) {
        super(context, attributes);
    }

    /**
     * How the picture comes and how the display is turned.
     *
     * @param next how the camera delivers, or null
     * @param rotationDeg rotation of what is drawn from the device's natural orientation, degrees
     */
    void configure(CameraSetup next, int rotationDeg) {
        if (next != setup || rotationDeg != displayRotationDeg) {
            setup = next;
            displayRotationDeg = rotationDeg;
            turn();
        }
    }

    @Override
    protected void onSizeChanged(int width, int height, int oldWidth, int oldHeight) {
        super.onSizeChanged(width, height, oldWidth, oldHeight);
        turn();
    }

    private void turn() {
        if (setup == null || getWidth() == 0 || getHeight() == 0) {
            return;
        }
        PictureMatrix.ofPreview(matrix, setup.camera().widthPx(), setup.camera().heightPx(),
                ImageOrientation.of(setup.sensorOrientationDeg(), 0, setup.frontFacing()),
                ImageOrientation.of(setup.sensorOrientationDeg(), displayRotationDeg, setup.frontFacing()), getWidth(),
                getHeight());
        setTransform(matrix);
    }
}
