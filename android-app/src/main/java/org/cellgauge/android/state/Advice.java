package org.cellgauge.android.state;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.cellgauge.check.CheckResult;
import org.cellgauge.live.AdviceStream;
import org.cellgauge.output.AdviceView;
import org.cellgauge.output.ResultView;
import org.cellgauge.warning.Message;

/** The cheapest changes that would meet a target which a result misses, in parts that any language says; immutable. */
public final class Advice {
    private final List<Message> changes;
    private final AdviceView view;

    private Advice(List<Message> changes, AdviceView view) {
        this.changes = Collections.unmodifiableList(changes);
        this.view = view;
    }

    /**
     * Looks for changes; takes some milliseconds.
     *
     * @param result what was found
     * @param view what it says
     * @return the cheapest, or null where none is known
     */
    static Advice of(CheckResult result, ResultView view) {
        List<Message> said = new ArrayList<>();
        // sentences are asked for proposal by proposal: those of the first come first
        AdviceView first = AdviceStream.of(result.cell(), result.settings(), view, message -> {
            said.add(message);
            return message.toString();
        }).firstElement().blockingGet();
        return first == null ? null : new Advice(new ArrayList<>(said.subList(0, first.sentences().size())), first);
    }

    /**
     * What to change.
     *
     * @return one message for each change; all of them together meet the target
     */
    public List<Message> changes() {
        return changes;
    }

    /**
     * What they bring.
     *
     * @return deviations as they are and as they would be
     */
    public AdviceView view() {
        return view;
    }
}
