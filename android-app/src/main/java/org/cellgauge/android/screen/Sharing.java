package org.cellgauge.android.screen;

import android.content.ClipData;
import android.content.Context;
import android.content.Intent;
import android.net.Uri;
import java.util.ArrayList;
import org.cellgauge.android.R;
import org.cellgauge.android.files.SavedResult;

/** Hands a kept result to another app. */
final class Sharing {
    private Sharing() {
    }

    /**
     * Asks which app.
     *
     * @param context of the screen
     * @param saved a result with files
     * @return to be started; the app that is chosen may read these files and no others
     */
    static Intent of(Context context, SavedResult saved) {
        ArrayList<Uri> uris = new ArrayList<>();
        saved.uris().forEach(uri -> uris.add(Uri.parse(uri)));
        // grants go by the clip: those of EXTRA_STREAM alone do not reach through the chooser on every version
        ClipData clip = ClipData.newRawUri(saved.name(), uris.get(0));
        for (Uri uri : uris.subList(1, uris.size())) {
            clip.addItem(new ClipData.Item(uri));
        }
        Intent intent = new Intent(Intent.ACTION_SEND_MULTIPLE).setType("*/*")
                .putParcelableArrayListExtra(Intent.EXTRA_STREAM, uris).putExtra(Intent.EXTRA_SUBJECT, saved.name())
                .addFlags(Intent.FLAG_GRANT_READ_URI_PERMISSION);
        intent.setClipData(clip);
        return Intent.createChooser(intent, context.getString(R.string.share_title));
    }
}
