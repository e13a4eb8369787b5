package org.cellgauge.android.screen;

import android.app.Activity;
import android.app.AlertDialog;
import android.content.ActivityNotFoundException;
import android.content.res.Configuration;
import android.graphics.Bitmap;
import android.graphics.BitmapFactory;
import android.os.Bundle;
import android.os.Handler;
import android.os.Looper;
import android.view.View;
import android.widget.ImageView;
import android.widget.LinearLayout;
import android.widget.TextView;
import android.widget.Toast;
import io.reactivex.rxjava3.core.Scheduler;
import io.reactivex.rxjava3.core.Single;
import io.reactivex.rxjava3.disposables.CompositeDisposable;
import io.reactivex.rxjava3.schedulers.Schedulers;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.cellgauge.android.CellGaugeApp;
import org.cellgauge.android.R;
import org.cellgauge.android.files.KeptResult;
import org.cellgauge.android.files.ResultArchive;

/**
 * Kept results: the list of all, one of them, and two side by side. <em>Back</em> leads from what was opened to where
 * it was opened from.
 */
public final class ResultsActivity extends Activity {
    private static final String OPENED = "opened";
    private static final String OTHER = "other";
    private static final String CHOOSING = "choosing";
    /** Larger pictures are shown with fewer pixels. */
    private static final int LARGEST_SIDE = 2048;

    private final Handler handler = new Handler(Looper.getMainLooper());
    private final Scheduler mainThread = Schedulers.from(handler::post);
    private final CompositeDisposable work = new CompositeDisposable();
    private final BackGesture gesture = new BackGesture(this, this::back);
    private ResultArchive archive;
    private ResultsContent content;
    private AlertDialog question;
    /** Null while they are being read. */
    private List<KeptResult> results;
    /** Name of the result that is shown, or null. */
    private String opened;
    /** Name of the one beside it, or null. */
    private String other;
    /** Whether the one beside it is being chosen. */
    private boolean choosing;
    /** Name of the result whose picture is shown. */
    private String pictured;
    private String headed = "";

    @Override
    protected void onCreate(Bundle saved) {
        super.onCreate(saved);
        archive = ((CellGaugeApp) getApplication()).parts().resultArchive();
        content = new ResultsContent(new Wording(getResources()));
        if (saved != null) {
            opened = saved.getString(OPENED);
            other = saved.getString(OTHER);
            choosing = saved.getBoolean(CHOOSING);
        }
        setContentView(R.layout.results);
        SystemBars.keepPageClear(this, R.id.results_screen);
        boolean wide = getResources().getConfiguration().orientation == Configuration.ORIENTATION_LANDSCAPE;
        ((LinearLayout) findViewById(R.id.results_body)).setOrientation(wide ? LinearLayout.HORIZONTAL
                : LinearLayout.VERTICAL);
        for (int part : new int[] {R.id.results_zoom, R.id.results_page}) {
            View view = findViewById(part);
            LinearLayout.LayoutParams size = (LinearLayout.LayoutParams) view.getLayoutParams();
            size.width = wide ? 0 : LinearLayout.LayoutParams.MATCH_PARENT;
            size.height = wide ? LinearLayout.LayoutParams.MATCH_PARENT : 0;
            view.setLayoutParams(size);
        }
        RowList rows = findViewById(R.id.results_rows);
        rows.onObject(this::choose);
        findViewById(R.id.heading_back).setOnClickListener(v -> back());
        findViewById(R.id.results_share).setOnClickListener(v -> share());
        findViewById(R.id.results_compare).setOnClickListener(v -> {
            choosing = true;
            show();
        });
        findViewById(R.id.results_delete).setOnClickListener(v -> askToDelete());
        show();
    }

    @Override
    protected void onStart() {
        super.onStart();
        read();
    }

    @Override
    protected void onDestroy() {
        work.dispose();
        if (question != null) {
            question.dismiss();
        }
        super.onDestroy();
    }

    @Override
    protected void onSaveInstanceState(Bundle out) {
        super.onSaveInstanceState(out);
        out.putString(OPENED, opened);
        out.putString(OTHER, other);
        out.putBoolean(CHOOSING, choosing);
    }

    /** Results may come and go in the system's Files app as well. */
    private void read() {
        work.add(Single.fromCallable(archive::kept).subscribeOn(Schedulers.io()).observeOn(mainThread)
                .subscribe(found -> {
                    results = found;
                    show();
                }));
    }

    // ---- what the user does

    /** A row of the list was tapped. */
    private void choose(int place) {
        KeptResult chosen = offered().get(place);
        if (choosing) {
            other = chosen.saved().name();
            choosing = false;
        } else {
            opened = chosen.saved().name();
        }
        show();
    }

    private void share() {
        KeptResult result = result(opened);
        if (result == null || result.saved().uris().isEmpty()) {
            return;
        }
        try {
            startActivity(Sharing.of(this, result.saved()));
        } catch (ActivityNotFoundException e) {
            Toast.makeText(this, R.string.no_app, Toast.LENGTH_LONG).show();
        }
    }

    private void askToDelete() {
        String name = opened;
        question = new AlertDialog.Builder(this).setTitle(R.string.delete_title)
                .setMessage(getString(R.string.delete_text, name))
                .setPositiveButton(R.string.delete_confirm, (dialog, which) -> delete(name))
                .setNegativeButton(R.string.cancel, null).create();
        question.show();
    }

    private void delete(String name) {
        work.add(Single.fromCallable(() -> archive.delete(name)).subscribeOn(Schedulers.io()).observeOn(mainThread)
                .subscribe(gone -> {
                    if (!gone) {
                        Toast.makeText(this, R.string.delete_failed, Toast.LENGTH_LONG).show();
                    }
                    read();
                }));
    }

    @Override
    @SuppressWarnings("deprecation") // what replaces it, BackGesture, does not exist before Android 13
    public void onBackPressed() {
        back();
    }

    private void back() {
        if (choosing) {
            choosing = false;
        } else if (other != null) {
            other = null;
        } else if (opened != null) {
            opened = null;
        } else {
            finish();
            return;
        }
        show();
    }

    // ---- what is shown

    private KeptResult result(String name) {
        if (results != null && name != null) {
            for (KeptResult result : results) {
                if (result.saved().name().equals(name)) {
                    return result;
                }
            }
        }
        return null;
    }

    /** The results that a tap may lead to. */
    private List<KeptResult> offered() {
        if (!choosing) {
            return results;
        }
        List<KeptResult> others = new ArrayList<>(results);
        others.removeIf(result -> result.view() == null || result.saved().name().equals(opened));
        return others;
    }

    private void show() {
        if (results != null && result(opened) == null) {
            // deleted meanwhile, with all that was opened from it
            opened = null;
            choosing = false;
        }
        if (results != null && (opened == null || result(other) == null)) {
            other = null;
        }
        gesture.own(choosing || other != null || opened != null);
        KeptResult one = result(opened);
        KeptResult two = result(other);
        boolean single = one != null && two == null && !choosing;
        List<Row> rows = results == null ? Collections.emptyList()
                : single ? content.details(one)
                : one != null && two != null ? compared(one, two)
                : content.list(offered());
        ((RowList) findViewById(R.id.results_rows)).show(rows);
        String heading = title(single ? one : null, two);
        ((TextView) findViewById(R.id.heading_title)).setText(heading);
        if (!heading.equals(headed)) {
            // another page begins at its top
            headed = heading;
            findViewById(R.id.results_page).scrollTo(0, 0);
        }
        TextView empty = findViewById(R.id.results_empty);
        empty.setText(results == null ? R.string.results_reading
                : choosing ? R.string.results_no_other : R.string.results_none);
        empty.setVisibility(rows.isEmpty() ? View.VISIBLE : View.GONE);
        findViewById(R.id.results_bar).setVisibility(single ? View.VISIBLE : View.GONE);
        findViewById(R.id.results_compare).setEnabled(single && one.view() != null);
        findViewById(R.id.results_zoom).setVisibility(single && one.view() != null ? View.VISIBLE : View.GONE);
        showPicture(single ? one : null);
    }

    private String title(KeptResult single, KeptResult two) {
        return single != null ? content.time(single)
                : getString(choosing ? R.string.results_choose_other
                : two != null ? R.string.results_comparison : R.string.results_title);
    }

    /** The earlier one stands first, whichever was opened first. */
    private List<Row> compared(KeptResult one, KeptResult two) {
        // the list has the newest first
        return results.indexOf(one) > results.indexOf(two) ? content.comparison(one, two)
                : content.comparison(two, one);
    }

    private void showPicture(KeptResult result) {
        String name = result == null ? null : result.saved().name();
        ImageView picture = findViewById(R.id.results_picture);
        if (name == null || !name.equals(pictured)) {
            picture.setImageDrawable(null);
            pictured = name;
        }
        if (name != null && picture.getDrawable() == null) {
            picture.setContentDescription(getString(R.string.results_picture_spoken, content.time(result)));
            work.add(Single.fromCallable(() -> decode(archive.picture(name))).subscribeOn(Schedulers.io())
                    .observeOn(mainThread).subscribe(bitmap -> {
                        if (name.equals(pictured)) {
                            picture.setImageBitmap(bitmap);
                        }
                    }, fault -> picture.setContentDescription(getString(R.string.results_no_picture))));
        }
    }

    private static Bitmap decode(byte[] png) {
        BitmapFactory.Options options = new BitmapFactory.Options();
        options.inJustDecodeBounds = true;
        BitmapFactory.decodeByteArray(png, 0, png.length, options);
        int longest = Math.max(options.outWidth, options.outHeight);
        options.inJustDecodeBounds = false;
        options.inSampleSize = Math.max(1, (longest + LARGEST_SIDE - 1) / LARGEST_SIDE);
        return BitmapFactory.decodeByteArray(png, 0, png.length, options);
    }
}
