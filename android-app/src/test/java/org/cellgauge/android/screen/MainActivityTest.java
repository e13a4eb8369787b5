package org.cellgauge.android.screen;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import android.graphics.Bitmap;
import android.graphics.Canvas;
import android.graphics.Color;
import android.view.View;
import android.view.View.MeasureSpec;
import android.widget.TextView;
import org.cellgauge.android.R;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.Robolectric;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.android.controller.ActivityController;

/** The activity started on Android's own code. */
@RunWith(RobolectricTestRunner.class)
public class MainActivityTest {

    @Test
    public void startsAndIsTitledWithTheAppsName() {
        try (ActivityController<MainActivity> controller = Robolectric.buildActivity(MainActivity.class).setup()) {
            assertEquals("CellGauge", controller.get().getTitle().toString());
        }
    }

    @Test
    public void textIsDrawnIntoABitmap() {
        try (ActivityController<MainActivity> controller = Robolectric.buildActivity(MainActivity.class).setup()) {
            TextView text = new TextView(controller.get());
            text.setText(R.string.placeholder);
            text.setTextColor(Color.WHITE);
            Bitmap drawn = drawn(text, 400, 60);
            int bright = 0;
            for (int y = 0; y < drawn.getHeight(); y++) {
                for (int x = 0; x < drawn.getWidth(); x++) {
                    bright += Color.alpha(drawn.getPixel(x, y)) > 128 ? 1 : 0;
                }
            }
            assertTrue(bright + " pixels of 400 x 60 drawn", bright > 200 && bright < 8000);
        }
    }

    private static Bitmap drawn(View view, int width, int height) {
        view.measure(MeasureSpec.makeMeasureSpec(width, MeasureSpec.EXACTLY),
                MeasureSpec.makeMeasureSpec(height, MeasureSpec.EXACTLY));
        view.layout(0, 0, width, height);
        Bitmap bitmap = Bitmap.createBitmap(width, height, Bitmap.Config.ARGB_8888);
        view.draw(new Canvas(bitmap));
        return bitmap;
    }
}
