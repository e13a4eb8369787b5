package org.cellgauge.android.screen;

import android.content.Context;
import android.graphics.Canvas;
import android.util.AttributeSet;
import android.view.View;
import org.cellgauge.internal.overlay.Overlay;
import org.cellgauge.internal.overlay.ViewFit;

/** The overlay over the picture; nothing else. */
public final class OverlayView extends View {
    private final OverlayPainter painter = new OverlayPainter();
    private Overlay overlay;
    private ViewFit fit;
    private double shiftXPx;
    private double shiftYPx;

    /**
     * For the layout's file.
     *
     * @param context of the activity
     * @param attributes of the file
     */
    public OverlayView(Context context, AttributeSet attributes) {
        super(context, attributes);
    }

    /**
     * What to draw.
     *
     * @param next in px of the upright picture, which fills the view and is cut where the shapes differ; null for
     *     nothing
     */
    void setOverlay(Overlay next) {
        if (next == overlay) {
            return;
        }
        overlay = next;
        painter.prepare(next);
        refit();
        invalidate();
    }

    /**
     * Where to draw it: the picture moves with the hand that holds the camera.
     *
     * @param toRightPx by how much the picture has moved since, px of the upright picture
     * @param downPx the same downwards
     */
    void setShift(double toRightPx, double downPx) {
        if (toRightPx != shiftXPx || downPx != shiftYPx) {
            shiftXPx = toRightPx;
            shiftYPx = downPx;
            invalidate();
        }
    }

    /**
     * Sets what a screen reader says of the picture; it is spoken when it changes.
     *
     * @param spoken a sentence or two
     */
    void describe(CharSequence spoken) {
        if (!spoken.equals(getContentDescription())) {
            setContentDescription(spoken);
        }
    }

    private void refit() {
        fit = overlay == null || getWidth() == 0 || getHeight() == 0 ? null
                : ViewFit.centreCrop(overlay.widthPx(), overlay.heightPx(), getWidth(), getHeight());
    }

    @Override
    protected void onSizeChanged(int width, int height, int oldWidth, int oldHeight) {
        refit();
    }

    @Override
    protected void onDraw(Canvas canvas) {
        if (fit == null) {
            return;
        }
        int saved = canvas.save();
        canvas.translate((float) fit.dx(), (float) fit.dy());
        canvas.scale((float) fit.scale(), (float) fit.scale());
        canvas.translate((float) shiftXPx, (float) shiftYPx);
        painter.draw(canvas);
        canvas.restoreToCount(saved);
    }
}
