package org.cellgauge.android.files;

import java.time.LocalDateTime;
import org.cellgauge.output.ResultView;
import org.cellgauge.warning.Refusal;

/** A kept result as its files have it; immutable. */
public final class KeptResult {
    private final SavedResult saved;
    private final LocalDateTime time;
    private final String cellName;
    private final ResultView view;
    private final Refusal refusal;

    /**
     * A result that was read.
     *
     * @param saved its name and files
     * @param time when it was kept, as its name has it; null where the name does not say
     * @param cellName what people know its cell file by; null where that was not kept
     * @param view all that its result file says
     */
    public KeptResult(SavedResult saved, LocalDateTime time, String cellName, ResultView view) {
        this(saved, time, cellName, view, null);
    }

    /**
     * A result whose file cannot be read.
     *
     * @param saved its name and files
     * @param time when it was kept, or null
     * @param refusal why
     */
    public KeptResult(SavedResult saved, LocalDateTime time, Refusal refusal) {
        this(saved, time, null, null, refusal);
    }

    private KeptResult(SavedResult saved, LocalDateTime time, String cellName, ResultView view, Refusal refusal) {
        this.saved = saved;
        this.time = time;
        this.cellName = cellName;
        this.view = view;
        this.refusal = refusal;
    }

    /**
     * Its name and files.
     *
     * @return never null
     */
    public SavedResult saved() {
        return saved;
    }

    /**
     * When it was kept.
     *
     * @return in the time zone of then; null where the name does not say
     */
    public LocalDateTime time() {
        return time;
    }

    /**
     * What people know its cell file by.
     *
     * @return a file name, or null where it was not kept
     */
    public String cellName() {
        return cellName;
    }

    /**
     * All that its result file says.
     *
     * @return null where it cannot be read
     */
    public ResultView view() {
        return view;
    }

    /**
     * Why it cannot be read.
     *
     * @return null where it can
     */
    public Refusal refusal() {
        return refusal;
    }
}
