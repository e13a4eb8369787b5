package org.cellgauge.cli;

import static java.util.Map.entry;

import java.util.Map;
import org.cellgauge.cell.CellRefusal;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.desktop.BatchRefusal;
import org.cellgauge.desktop.FolderRefusal;
import org.cellgauge.desktop.ResultFolder;
import org.cellgauge.internal.cell.CellPhrase;
import org.cellgauge.internal.validation.ValidationRefusal;
import org.cellgauge.internal.warning.CheckPhrase;
import org.cellgauge.warning.Message;
import org.cellgauge.warning.MessageKind;

/** What core says, in the words of the command line: where a remedy is one of its options, the option is named. */
final class CommandWords {
    /** Patterns in place of those of core. */
    static final Map<MessageKind, String> PATTERNS = Map.ofEntries(
            entry(CellRefusal.IS_DETECTIONS_FILE,
                    "this is a detections file; name a cell file, and this one after --detections"),
            entry(CellRefusal.NO_CAMERA_FILE, "there is no file \"%s\"; write the camera file's path relative to this "
                    + "file, or make one with 'cellgauge calibrate --target'"),
            entry(CellPhrase.IMAGE_SCALED, "the image is scaled or binned; if it is the whole image, let the camera be "
                    + "scaled with --scale-camera, else take it in the calibrated size"),
            entry(CheckPhrase.MORE_ITERATIONS, "allow more with --max-iterations"),
            entry(CheckPhrase.INITIAL_PNP, "use --initial pnp"),
            entry(ValidationRefusal.FARTHER_APART, "give --object poses farther apart, or a smaller --spread"),
            entry(ValidationRefusal.OTHER_POSES, "give another --camera-pose or --object pose"),
            entry(ValidationRefusal.SMALLER_SPREAD, "give a smaller --spread"),
            entry(FolderRefusal.OUT_IS_FILE, "this is a file, not a folder; name a folder with --out"),
            entry(FolderRefusal.OUT_NOT_PERMITTED, "no permission to write here; name another folder with --out"),
            entry(FolderRefusal.OUT_NOT_MADE, "this folder cannot be made or is gone; name another with --out"),
            entry(FolderRefusal.OUT_NOT_WRITTEN,
                    "results cannot be written (%s); free space or name another folder with --out"),
            entry(FolderRefusal.OUT_IN_USE, "another run writes its results here (%s); wait for its end, or name "
                    + "another folder with --out"),
            entry(FolderRefusal.RESULT_NOT_WRITTEN, "its result cannot be written (%s); give the input another name, "
                    + "or name another folder with --out"),
            entry(BatchRefusal.NOT_STORED, "no result of this input is in %s; check it without --rejudge first, or "
                    + "name the folder that has it with --out"),
            entry(BatchRefusal.OTHER_INPUT, "the stored result is of another file of this name; check it again "
                    + "without --rejudge"),
            entry(BatchRefusal.OTHER_CELL, "the stored result is of another cell: more than its target has changed; "
                    + "check it again without --rejudge"),
            entry(BatchRefusal.OTHER_SETTINGS, "the stored result was made with other settings; give the same ones, "
                    + "or check it again without --rejudge"),
            entry(BatchRefusal.TOLERANCE_NEEDS_DRAWS, "the target asks for a probability, which only draws tell; "
                    + "check it again without --rejudge"));

    private CommandWords() {
    }

    /** A warning or refusal in a line. */
    static String of(Message message) {
        return message.english(kind -> PATTERNS.getOrDefault(kind, kind.english()));
    }

    /** What an error says to the user. */
    static String of(Throwable error) {
        if (error instanceof InputRefusedException refused) {
            return of(refused.refusal());
        }
        return error instanceof ResultFolder.UnwritableException unwritable ? of(unwritable.refusal())
                : error.getMessage();
    }
}
