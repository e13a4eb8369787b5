package org.cellgauge.android.screen;

import android.content.Context;
import android.graphics.Bitmap;
import android.graphics.Canvas;
import android.graphics.Matrix;
import android.graphics.Paint;
import android.util.AttributeSet;
import android.view.View;
import org.cellgauge.android.files.Photo;
import org.cellgauge.internal.overlay.ImageOrientation;
import org.cellgauge.vision.GreyImage;

/** A held frame or a photo in place of the camera's picture. */
public final class StillView extends View {
    /** Larger pictures are shown with fewer pixels; what is measured keeps all of them. */
    private static final int LARGEST_SIDE = 2048;

    private final Paint paint = new Paint(Paint.FILTER_BITMAP_FLAG);
    private final Matrix matrix = new Matrix();
    private Photo photo;
    private ImageOrientation orientation = ImageOrientation.IDENTITY;
    private Bitmap bitmap;

    /**
     * For the layout's file.
     *
     * @param context of the activity
     * @param attributes of the file
     */
    public StillView(Context context, AttributeSet attributes) {
        super(context, attributes);
    }

    /**
     * What to show.
     *
     * @param next a frame or photo as it came, or null for nothing
     * @param turned how it is turned and mirrored
     */
    void setStill(Photo next, ImageOrientation turned) {
        if (next == photo && turned.equals(orientation)) {
            return;
        }
        if (next != photo) {
            bitmap = null;
            if (next != null) {
                GreyImage image = next.luminance();
                int longest = Math.max(image.widthPx(), image.heightPx());
                bitmap = OverlayPainter.bitmap(image, (longest + LARGEST_SIDE - 1) / LARGEST_SIDE);
            }
        }
        photo = next;
        orientation = turned;
        place();
        invalidate();
    }

    @Override
    protected void onSizeChanged(int width, int height, int oldWidth, int oldHeight) {
        place();
    }

    private void place() {
        if (bitmap != null && getWidth() > 0 && getHeight() > 0) {
            GreyImage image = photo.luminance();
            PictureMatrix.ofBitmap(matrix, bitmap.getWidth(), bitmap.getHeight(), image.widthPx(), image.heightPx(),
                    orientation, getWidth(), getHeight());
        }
    }

    @Override
    protected void onDraw(Canvas canvas) {
        if (bitmap != null) {
            canvas.drawBitmap(bitmap, matrix, paint);
        }
    }
}
