package org.cellgauge.android.screen;

import android.content.Context;
import org.cellgauge.android.files.PictureWords;
import org.cellgauge.check.Reason;
import org.cellgauge.check.Verdict;
import org.cellgauge.internal.overlay.LabelWords;
import org.cellgauge.internal.overlay.LegendWords;

/** Words of a kept picture: those of the screen, in the language that is set when they are asked for. */
public final class ScreenWords implements PictureWords {
    private final Context context;

    /**
     * The words of an app.
     *
     * @param context of the app
     */
    public ScreenWords(Context context) {
        this.context = context;
    }

    private Wording words() {
        return new Wording(context.getResources());
    }

    @Override
    public String headline(Verdict verdict, boolean lensMeasured) {
        return words().get(Banner.of(verdict, lensMeasured).headline());
    }

    @Override
    public String reason(Reason reason) {
        return words().reason(reason);
    }

    @Override
    public LabelWords labels() {
        return words().labels();
    }

    @Override
    public LegendWords legend() {
        return words().legend();
    }
}
