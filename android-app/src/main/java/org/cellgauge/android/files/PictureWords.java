package org.cellgauge.android.files;

import org.cellgauge.check.Reason;
import org.cellgauge.check.Verdict;
import org.cellgauge.internal.overlay.LabelWords;
import org.cellgauge.internal.overlay.LegendWords;

/** What a kept picture says, in the language that the app speaks at the moment. */
public interface PictureWords {
    /**
     * What the banner says first.
     *
     * @param verdict of the check
     * @param lensMeasured whether the camera's lens was calibrated: nothing passes without
     * @return a few words
     */
    String headline(Verdict verdict, boolean lensMeasured);

    /**
     * Why.
     *
     * @param reason of the verdict
     * @return a sentence or two
     */
    String reason(Reason reason);

    /**
     * What labels say.
     *
     * @return the words
     */
    LabelWords labels();

    /**
     * What the legend says.
     *
     * @return the words
     */
    LegendWords legend();
}
