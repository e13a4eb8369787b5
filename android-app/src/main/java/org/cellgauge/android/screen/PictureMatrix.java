package org.cellgauge.android.screen;

import android.graphics.Matrix;
import org.cellgauge.internal.overlay.ImageOrientation;
import org.cellgauge.internal.overlay.ViewFit;

/** Where pictures lie in a view: given by where core puts three corners of the image. */
final class PictureMatrix {
    private static final int CORNERS = 3;

    private PictureMatrix() {
    }

    /**
     * Where a bitmap of the image lies.
     *
     * @param matrix is set
     * @param bitmapWidth width of the bitmap, which may be smaller than the image
     * @param bitmapHeight its height
     * @param imageWidth width of the image as it comes, px
     * @param imageHeight its height
     * @param orientation how the image is turned and mirrored
     * @param viewWidth width of the view, px
     * @param viewHeight its height
     */
    static void ofBitmap(Matrix matrix, float bitmapWidth, float bitmapHeight, int imageWidth, int imageHeight,
            ImageOrientation orientation, int viewWidth, int viewHeight) {
        float[] from = {0, 0, bitmapWidth, 0, 0, bitmapHeight};
        matrix.setPolyToPoly(from, 0, corners(imageWidth, imageHeight, orientation, viewWidth, viewHeight), 0, CORNERS);
    }

    /**
     * How a preview must be turned. A texture shows the camera's buffer, stretched over the view, as it stands upright
     * on the device in its natural orientation, a front camera's mirrored: the camera service sees to that, and knows
     * nothing of the display's rotation.
     *
     * @param matrix is set
     * @param imageWidth width of the camera's frames in sensor orientation, px
     * @param imageHeight their height
     * @param natural how frames stand upright in the natural orientation
     * @param shown how they do on the display as it is turned
     * @param viewWidth width of the view, px
     * @param viewHeight its height
     */
    static void ofPreview(Matrix matrix, int imageWidth, int imageHeight, ImageOrientation natural,
            ImageOrientation shown, int viewWidth, int viewHeight) {
        float stretchX = (float) viewWidth / natural.uprightWidthPx(imageWidth, imageHeight);
        float stretchY = (float) viewHeight / natural.uprightHeightPx(imageWidth, imageHeight);
        float[] from = new float[2 * CORNERS];
        for (int i = 0; i < CORNERS; i++) {
            double[] p = natural.map(i == 1 ? imageWidth : 0, i == 2 ? imageHeight : 0, imageWidth, imageHeight);
            from[2 * i] = (float) p[0] * stretchX;
            from[2 * i + 1] = (float) p[1] * stretchY;
        }
        matrix.setPolyToPoly(from, 0, corners(imageWidth, imageHeight, shown, viewWidth, viewHeight), 0, CORNERS);
    }

    /** Upper left, upper right and lower left corner of the image as it comes, in the view. */
    private static float[] corners(int imageWidth, int imageHeight, ImageOrientation orientation, int viewWidth,
            int viewHeight) {
        ViewFit fit = ViewFit.centreCrop(orientation.uprightWidthPx(imageWidth, imageHeight),
                orientation.uprightHeightPx(imageWidth, imageHeight), viewWidth, viewHeight);
        float[] to = new float[2 * CORNERS];
        for (int i = 0; i < CORNERS; i++) {
            double[] p = orientation.map(i == 1 ? imageWidth : 0, i == 2 ? imageHeight : 0, imageWidth, imageHeight);
            double[] q = fit.toView(p[0], p[1]);
            to[2 * i] = (float) q[0];
            to[2 * i + 1] = (float) q[1];
        }
        return to;
    }
}
