package org.cellgauge.android.screen;

import android.app.Activity;
import android.app.AlertDialog;
import android.content.ActivityNotFoundException;
import android.content.Intent;
import android.net.Uri;
import android.os.Bundle;
import android.os.Handler;
import android.os.Looper;
import android.view.LayoutInflater;
import android.view.View;
import android.widget.Button;
import android.widget.ImageView;
import android.widget.LinearLayout;
import android.widget.TextView;
import android.widget.Toast;
import io.reactivex.rxjava3.core.Scheduler;
import io.reactivex.rxjava3.core.Single;
import io.reactivex.rxjava3.disposables.CompositeDisposable;
import io.reactivex.rxjava3.schedulers.Schedulers;
import org.cellgauge.android.AppParts;
import org.cellgauge.android.CellGaugeApp;
import org.cellgauge.android.R;
import org.cellgauge.android.files.GuideFiles;

/**
 * What to do before the first check, in four pictures: print markers, measure, write the cell file, calibrate. Each has
 * the file or the text that it takes. Shown at the first start, and from the list whenever it is wanted.
 */
public final class GuideActivity extends Activity {
    private static final int REQUEST_MARKERS = 1;
    private static final int REQUEST_CELL = 2;
    private static final String HOW_TO = "how-to";

    private final Handler handler = new Handler(Looper.getMainLooper());
    private final Scheduler mainThread = Schedulers.from(handler::post);
    private final CompositeDisposable work = new CompositeDisposable();
    private AppParts parts;
    private GuideFiles files;
    private AlertDialog howTo;
    private GuideStep read;

    @Override
    protected void onCreate(Bundle saved) {
        super.onCreate(saved);
        parts = ((CellGaugeApp) getApplication()).parts();
        files = new GuideFiles(this);
        setContentView(R.layout.guide);
        SystemBars.keepPageClear(this, R.id.guide_screen);
        ((TextView) findViewById(R.id.heading_title)).setText(R.string.guide_title);
        findViewById(R.id.heading_back).setOnClickListener(v -> finish());
        findViewById(R.id.guide_done).setOnClickListener(v -> finish());
        LinearLayout page = findViewById(R.id.guide_steps);
        int columns = getResources().getInteger(R.integer.guide_columns);
        LinearLayout row = null;
        for (GuideStep step : GuideStep.values()) {
            if (row == null || row.getChildCount() == columns) {
                row = new LinearLayout(this);
                row.setBaselineAligned(false);
                page.addView(row);
            }
            View card = card(step, row);
            LinearLayout.LayoutParams size = (LinearLayout.LayoutParams) card.getLayoutParams();
            size.width = 0;
            size.weight = 1;
            row.addView(card, size);
        }
        if (saved != null && saved.containsKey(HOW_TO)) {
            open(GuideStep.valueOf(saved.getString(HOW_TO)));
        }
    }

    private View card(GuideStep step, LinearLayout row) {
        View card = LayoutInflater.from(this).inflate(R.layout.guide_step, row, false);
        ImageView picture = card.findViewById(R.id.guide_picture);
        picture.setImageResource(step.picture());
        picture.setContentDescription(getString(step.spoken()));
        ((TextView) card.findViewById(R.id.guide_step_title)).setText(step.title());
        ((TextView) card.findViewById(R.id.guide_step_first)).setText(step.first());
        ((TextView) card.findViewById(R.id.guide_step_second)).setText(step.second());
        Button button = card.findViewById(R.id.guide_step_button);
        button.setText(step.button());
        button.setOnClickListener(v -> open(step));
        return card;
    }

    @Override
    protected void onDestroy() {
        work.dispose();
        if (howTo != null) {
            howTo.dismiss();
        }
        super.onDestroy();
    }

    @Override
    protected void onSaveInstanceState(Bundle out) {
        super.onSaveInstanceState(out);
        if (howTo != null && howTo.isShowing()) {
            out.putString(HOW_TO, read.name());
        }
    }

    private void open(GuideStep step) {
        switch (step) {
            case PRINT:
                chooseAPlace(REQUEST_MARKERS, "application/pdf", "cellgauge-markers.pdf");
                break;
            case WRITE:
                // of any other type the system would add the ending of that type to the name
                chooseAPlace(REQUEST_CELL, "application/octet-stream", "cell.yaml");
                break;
            default:
                read = step;
                howTo = new AlertDialog.Builder(this).setTitle(step.title()).setMessage(step.howTo())
                        .setPositiveButton(R.string.close, null).create();
                howTo.show();
                break;
        }
    }

    private void chooseAPlace(int request, String type, String name) {
        Intent intent = new Intent(Intent.ACTION_CREATE_DOCUMENT).addCategory(Intent.CATEGORY_OPENABLE).setType(type)
                .putExtra(Intent.EXTRA_TITLE, name);
        try {
            startActivityForResult(intent, request);
        } catch (ActivityNotFoundException e) {
            say(R.string.no_app);
        }
    }

    @Override
    protected void onActivityResult(int request, int result, Intent data) {
        Uri uri = result == RESULT_OK && data != null ? data.getData() : null;
        if (uri == null) {
            return;
        }
        work.add(Single.fromCallable(() -> {
            files.write(uri.toString(), request == REQUEST_MARKERS
                    ? files.markers(parts.cellLibrary(), parts.memory()) : files.exampleCell());
            return true;
        }).subscribeOn(Schedulers.io()).observeOn(mainThread).subscribe(written -> say(R.string.guide_saved),
                fault -> say(R.string.guide_not_saved)));
    }

    private void say(int text) {
        Toast.makeText(this, text, Toast.LENGTH_LONG).show();
    }
}
