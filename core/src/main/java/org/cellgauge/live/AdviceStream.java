package org.cellgauge.live;

import io.reactivex.rxjava3.core.Flowable;
import java.util.function.Function;
import org.cellgauge.cell.Cell;
import org.cellgauge.output.AdviceView;
import org.cellgauge.output.ResultView;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.warning.Message;

/** What would meet a target that a result misses, as a stream for a screen. */
public final class AdviceStream {
    private AdviceStream() {
    }

    /**
     * The cheapest changes, found within some milliseconds once somebody subscribes.
     * <dl>
     * <dt><b>Backpressure:</b></dt>
     * <dd>Honoured.</dd>
     * <dt><b>Scheduler:</b></dt>
     * <dd>Works on the thread that subscribes.</dd>
     * <dt><b>Error handling:</b></dt>
     * <dd>None but faults of the program.</dd>
     * </dl>
     *
     * @param cell of the result
     * @param settings it was made with
     * @param view what it says
     * @param words of a change in the language of the reader
     * @return as {@link AdviceView#of}: at most three, cheapest first
     */
    public static Flowable<AdviceView> of(Cell cell, CheckSettings settings, ResultView view,
            Function<? super Message, String> words) {
        return Flowable.defer(() -> Flowable.fromIterable(AdviceView.of(cell, settings, view, words)));
    }
}
