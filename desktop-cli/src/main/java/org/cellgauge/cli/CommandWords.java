package org.cellgauge.cli;

import java.util.Map;
import org.cellgauge.cell.CellRefusal;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.internal.validation.ValidationRefusal;
import org.cellgauge.internal.warning.CheckPhrase;
import org.cellgauge.warning.Message;
import org.cellgauge.warning.MessageKind;

/** What core says, in the words of the command line: where a remedy is one of its options, the option is named. */
final class CommandWords {
    /** Patterns in place of those of core. */
    static final Map<MessageKind, String> PATTERNS = Map.of(
            CellRefusal.IS_DETECTIONS_FILE,
            "this is a detections file; name a cell file, and this one after --detections",
            CheckPhrase.MORE_ITERATIONS, "allow more with --max-iterations",
            CheckPhrase.INITIAL_PNP, "use --initial pnp",
            ValidationRefusal.FARTHER_APART, "give --object poses farther apart, or a smaller --spread",
            ValidationRefusal.OTHER_POSES, "give another --camera-pose or --object pose",
            ValidationRefusal.SMALLER_SPREAD, "give a smaller --spread");

    private CommandWords() {
    }

    /** A warning or refusal in a line. */
    static String of(Message message) {
        return message.english(kind -> PATTERNS.getOrDefault(kind, kind.english()));
    }

    /** What an error says to the user. */
    static String of(Throwable error) {
        return error instanceof InputRefusedException refused ? of(refused.refusal()) : error.getMessage();
    }
}
