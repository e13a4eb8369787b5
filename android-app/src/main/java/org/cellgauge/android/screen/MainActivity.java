package org.cellgauge.android.screen;

import android.app.Activity;
import android.os.Bundle;
import android.view.Gravity;
import android.widget.TextView;
import org.cellgauge.android.R;

/** Stands where the app's screen will be. */
public final class MainActivity extends Activity {
    @Override
    protected void onCreate(Bundle state) {
        super.onCreate(state);
        TextView text = new TextView(this);
        text.setGravity(Gravity.CENTER);
        text.setText(R.string.placeholder);
        setContentView(text);
    }
}
