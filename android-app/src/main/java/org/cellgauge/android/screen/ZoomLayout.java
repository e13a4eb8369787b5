package org.cellgauge.android.screen;

import android.content.Context;
import android.util.AttributeSet;
import android.view.GestureDetector;
import android.view.MotionEvent;
import android.view.ScaleGestureDetector;
import android.view.View;
import android.widget.FrameLayout;

/**
 * Room for a picture that two fingers enlarge and one moves; two quick taps enlarge it and make it whole again. Its
 * first child is the picture, and what is drawn over it comes along.
 */
public final class ZoomLayout extends FrameLayout {
    static final float LARGEST = 8;
    private static final float BY_DOUBLE_TAP = 3;

    private final ScaleGestureDetector pinch;
    private final GestureDetector taps;
    private TapListener listener = (x, y) -> { };

    /** Who is told of a tap on the picture. */
    interface TapListener {
        /**
         * The picture was tapped once.
         *
         * @param x in px of the picture's view, before it was enlarged
         * @param y in px of the picture's view
         */
        void onTap(float x, float y);
    }

    /**
     * For the layout's file.
     *
     * @param context of the activity
     * @param attributes of the file
     */
    public ZoomLayout(Context context, AttributeSet attributes) {
        super(context, attributes);
        pinch = new ScaleGestureDetector(context, new ScaleGestureDetector.SimpleOnScaleGestureListener() {
            @Override
            public boolean onScale(ScaleGestureDetector detector) {
                zoom(picture().getScaleX() * detector.getScaleFactor(), detector.getFocusX(), detector.getFocusY());
                return true;
            }
        });
        taps = new GestureDetector(context, new GestureDetector.SimpleOnGestureListener() {
            @Override
            public boolean onDown(MotionEvent event) {
                return true;
            }

            @Override
            public boolean onScroll(MotionEvent from, MotionEvent to, float distanceX, float distanceY) {
                move(picture().getTranslationX() - distanceX, picture().getTranslationY() - distanceY);
                return true;
            }

            @Override
            public boolean onDoubleTap(MotionEvent event) {
                zoom(picture().getScaleX() > 1 ? 1 : BY_DOUBLE_TAP, event.getX(), event.getY());
                return true;
            }

            @Override
            public boolean onSingleTapConfirmed(MotionEvent event) {
                tap(event.getX(), event.getY());
                return true;
            }
        });
    }

    void onTap(TapListener toTell) {
        listener = toTell;
    }

    private View picture() {
        return getChildAt(0);
    }

    /**
     * Enlarges the picture about a point that stays where it is.
     *
     * @param wanted how many times as large as it is whole; kept between 1 and {@link #LARGEST}
     * @param x of the point, px of this view
     * @param y of the point
     */
    void zoom(float wanted, float x, float y) {
        View picture = picture();
        float scale = Math.max(1, Math.min(LARGEST, wanted));
        float by = scale / picture.getScaleX();
        // views are scaled about their middle
        float middleX = picture.getLeft() + picture.getWidth() / 2f;
        float middleY = picture.getTop() + picture.getHeight() / 2f;
        float toX = x - middleX - by * (x - middleX - picture.getTranslationX());
        float toY = y - middleY - by * (y - middleY - picture.getTranslationY());
        picture.setScaleX(scale);
        picture.setScaleY(scale);
        move(toX, toY);
    }

    /** Moves the picture, as far as some of it would otherwise be out of view. */
    private void move(float x, float y) {
        View picture = picture();
        float roomX = Math.max(0, (picture.getWidth() * picture.getScaleX() - getWidth()) / 2);
        float roomY = Math.max(0, (picture.getHeight() * picture.getScaleY() - getHeight()) / 2);
        picture.setTranslationX(Math.max(-roomX, Math.min(roomX, x)));
        picture.setTranslationY(Math.max(-roomY, Math.min(roomY, y)));
    }

    /** A tap at a point of this view. */
    void tap(float x, float y) {
        View picture = picture();
        float middleX = picture.getLeft() + picture.getWidth() / 2f + picture.getTranslationX();
        float middleY = picture.getTop() + picture.getHeight() / 2f + picture.getTranslationY();
        listener.onTap((x - middleX) / picture.getScaleX() + picture.getWidth() / 2f,
                (y - middleY) / picture.getScaleY() + picture.getHeight() / 2f);
    }

    @Override
    public boolean onInterceptTouchEvent(MotionEvent event) {
        // a message over the picture has buttons of its own
        return getChildCount() > 1 && getChildAt(1).getVisibility() != VISIBLE;
    }

    @Override
    public boolean onTouchEvent(MotionEvent event) {
        boolean pinched = pinch.onTouchEvent(event);
        return taps.onTouchEvent(event) || pinched || super.onTouchEvent(event);
    }

    @Override
    protected void onLayout(boolean changed, int left, int top, int right, int bottom) {
        super.onLayout(changed, left, top, right, bottom);
        if (changed) {
            zoom(picture().getScaleX(), getWidth() / 2f, getHeight() / 2f);
        }
    }
}
