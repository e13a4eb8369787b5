package org.cellgauge.android.screen;

import android.content.Context;
import android.util.AttributeSet;
import android.widget.FrameLayout;

/** Takes the shape of the picture, as large as there is room, so that all that is measured is in view. */
public final class ViewportLayout extends FrameLayout {
    private int pictureWidth;
    private int pictureHeight;

    /**
     * For the layout's file.
     *
     * @param context of the activity
     * @param attributes of the file
     */
    public ViewportLayout(Context context, AttributeSet attributes) {
        super(context, attributes);
    }

    /**
     * What shape to take.
     *
     * @param width of the upright picture in any unit; 0 for all the room there is
     * @param height of the upright picture
     */
    void setPicture(int width, int height) {
        if (width != pictureWidth || height != pictureHeight) {
            pictureWidth = width;
            pictureHeight = height;
            requestLayout();
        }
    }

    @Override
    protected void onMeasure(int widthSpec, int heightSpec) {
        int width = MeasureSpec.getSize(widthSpec);
        int height = MeasureSpec.getSize(heightSpec);
        if (pictureWidth > 0 && pictureHeight > 0 && width > 0 && height > 0) {
            if ((long) width * pictureHeight > (long) height * pictureWidth) {
                width = Math.max(1, Math.round((float) height * pictureWidth / pictureHeight));
            } else {
                height = Math.max(1, Math.round((float) width * pictureHeight / pictureWidth));
            }
        }
        super.onMeasure(MeasureSpec.makeMeasureSpec(width, MeasureSpec.EXACTLY),
                MeasureSpec.makeMeasureSpec(height, MeasureSpec.EXACTLY));
    }
}
