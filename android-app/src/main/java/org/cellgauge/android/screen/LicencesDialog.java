package org.cellgauge.android.screen;

import android.app.Activity;
import android.app.AlertDialog;
import android.content.res.AssetManager;
import android.text.Layout;
import android.view.LayoutInflater;
import android.view.View;
import android.widget.ScrollView;
import android.widget.TextView;
import io.reactivex.rxjava3.core.Scheduler;
import io.reactivex.rxjava3.core.Single;
import io.reactivex.rxjava3.disposables.Disposable;
import io.reactivex.rxjava3.schedulers.Schedulers;
import java.util.Locale;
import org.cellgauge.android.R;
import org.cellgauge.android.files.LicenceTexts;

/** Shows the libraries in the app and the terms they stand under. */
final class LicencesDialog {
    private final AlertDialog dialog;
    private final ScrollView page;
    private final TextView text;
    private final Disposable reading;
    private int top;
    private boolean shown;

    /**
     * Opens the dialog and has the text read.
     *
     * @param activity the screen
     * @param mainThread the thread of the screen
     * @param top index of a letter in the uppermost line; 0 for the beginning
     */
    LicencesDialog(Activity activity, Scheduler mainThread, int top) {
        this.top = top;
        View content = LayoutInflater.from(activity).inflate(R.layout.licences, null);
        page = content.findViewById(R.id.licences_page);
        text = content.findViewById(R.id.licences_text);
        dialog = new AlertDialog.Builder(activity).setTitle(R.string.licences_title).setView(content)
                .setPositiveButton(R.string.close, null).create();
        dialog.show();
        AssetManager assets = activity.getApplicationContext().getAssets();
        reading = Single.fromCallable(() -> Paragraphs.of(LicenceTexts.read(assets))).subscribeOn(Schedulers.io())
                .observeOn(mainThread).subscribe(this::show, e -> text.setText(e.getMessage()));
    }

    private void show(String licences) {
        // whatever language the screen speaks, for who reads it aloud
        text.setTextLocale(Locale.ENGLISH);
        text.setText(licences);
        text.addOnLayoutChangeListener(new View.OnLayoutChangeListener() {
            @Override
            public void onLayoutChange(View v, int left, int above, int right, int bottom, int oldLeft, int oldTop,
                    int oldRight, int oldBottom) {
                text.removeOnLayoutChangeListener(this);
                Layout lines = text.getLayout();
                page.scrollTo(0, lines.getLineTop(lines.getLineForOffset(Math.min(top, text.length()))));
                shown = true;
            }
        });
    }

    boolean isShowing() {
        return dialog.isShowing();
    }

    /** Index of the first letter of the uppermost line, which a screen of another width can begin with as well. */
    int top() {
        Layout lines = text.getLayout();
        if (shown && lines != null) {
            top = lines.getLineStart(lines.getLineForVertical(page.getScrollY()));
        }
        return top;
    }

    void dismiss() {
        reading.dispose();
        dialog.dismiss();
    }
}
