package org.cellgauge.android.screen;

import android.app.Activity;
import android.app.AlertDialog;
import java.util.function.IntConsumer;
import org.cellgauge.android.R;
import org.cellgauge.android.state.CheckScreenState;
import org.cellgauge.android.state.CheckSession;
import org.cellgauge.cell.Requirement;

/** One object: its figures, what causes them, whether it counts, and its own target. */
final class ObjectDialog {
    private final AlertDialog dialog;

    /**
     * Opens the dialog.
     *
     * @param activity the screen
     * @param session gets what is chosen
     * @param content says what there is to say
     * @param objectId marker id
     * @param ownTarget asks for the object's own target
     */
    ObjectDialog(Activity activity, CheckSession session, ScreenContent content, int objectId,
            IntConsumer ownTarget) {
        CheckScreenState s = session.state();
        Requirement asked = s.target().of(objectId);
        boolean counts = !s.target().isAny() || asked.isAny();
        dialog = new AlertDialog.Builder(activity).setTitle(content.objectTitle(s, objectId))
                .setMessage(content.objectDetails(s, objectId))
                .setPositiveButton(R.string.object_target, (d, which) -> ownTarget.accept(objectId))
                .setNeutralButton(counts ? R.string.object_ignore : R.string.object_count,
                        (d, which) -> session.count(objectId, !counts))
                .setNegativeButton(R.string.close, null).create();
        dialog.show();
    }

    void dismiss() {
        dialog.dismiss();
    }
}
