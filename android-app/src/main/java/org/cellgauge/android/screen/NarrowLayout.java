package org.cellgauge.android.screen;

import android.content.Context;
import android.util.AttributeSet;
import android.util.TypedValue;
import android.widget.LinearLayout;

/** No wider than lines of text are easily read. */
public final class NarrowLayout extends LinearLayout {
    private static final int WIDEST_SP = 520;

    /**
     * For the layout's file.
     *
     * @param context of the activity
     * @param attributes of the file
     */
    public NarrowLayout(Context context, AttributeSet attributes) {
        super(context, attributes);
    }

    @Override
    protected void onMeasure(int widthSpec, int heightSpec) {
        int widest = Math.round(TypedValue.applyDimension(TypedValue.COMPLEX_UNIT_SP, WIDEST_SP,
                getResources().getDisplayMetrics()));
        super.onMeasure(MeasureSpec.makeMeasureSpec(Math.min(MeasureSpec.getSize(widthSpec), widest),
                MeasureSpec.EXACTLY), heightSpec);
    }
}
