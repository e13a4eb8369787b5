package org.cellgauge.android.screen;

import android.app.Activity;
import android.app.AlertDialog;
import android.text.method.DigitsKeyListener;
import android.view.LayoutInflater;
import android.view.View;
import android.view.inputmethod.EditorInfo;
import android.widget.EditText;
import android.widget.TextView;
import java.util.Locale;
import org.cellgauge.android.R;
import org.cellgauge.android.state.CheckScreenState;
import org.cellgauge.android.state.CheckSession;
import org.cellgauge.cell.Target;

/** Asks for a target in mm. */
final class TargetDialog {
    private final CheckSession session;
    private final AlertDialog dialog;
    private final EditText field;
    private final Wording words;

    /**
     * Opens the dialog.
     *
     * @param activity the screen
     * @param session gets the target
     * @param text what stands in the field; null for the target in force
     */
    TargetDialog(Activity activity, CheckSession session, String text) {
        this.session = session;
        this.words = new Wording(activity.getResources());
        CheckScreenState state = session.state();
        View content = LayoutInflater.from(activity).inflate(R.layout.target, null);
        field = content.findViewById(R.id.target_field);
        Locale locale = activity.getResources().getConfiguration().getLocales().get(0);
        field.setKeyListener(DigitsKeyListener.getInstance(locale, false, true));
        field.setText(text != null ? text
                : state.targetStdMm().isPresent() ? words.plain(state.targetStdMm().getAsDouble()) : "");
        field.setSelection(field.length());
        TextView ofFile = content.findViewById(R.id.target_of_file);
        Target stated = state.cell() == null ? Target.NONE : state.cell().cell().target();
        ofFile.setText(stated.oneStdMm().isPresent()
                ? words.get(R.string.target_of_file, words.plain(stated.oneStdMm().getAsDouble()))
                : words.get(stated.isAny() ? R.string.target_of_file_stated : R.string.target_of_file_none));
        dialog = new AlertDialog.Builder(activity).setTitle(R.string.target_title).setView(content)
                .setPositiveButton(R.string.target_set, null).setNegativeButton(R.string.cancel, null).create();
        ofFile.setOnClickListener(v -> {
            session.resetTarget();
            dialog.dismiss();
        });
        field.setOnEditorActionListener((v, action, event) -> {
            if (action == EditorInfo.IME_ACTION_DONE) {
                take();
            }
            return action == EditorInfo.IME_ACTION_DONE;
        });
        // set afterwards, so that a wrong number does not close the dialog
        dialog.setOnShowListener(d -> dialog.getButton(AlertDialog.BUTTON_POSITIVE).setOnClickListener(v -> take()));
        dialog.show();
    }

    private void take() {
        double mm = Decimals.parse(field.getText().toString());
        if (mm > 0) {
            session.chooseTarget(mm);
            dialog.dismiss();
        } else {
            field.setError(words.get(R.string.target_wrong, words.plain(0.5)));
        }
    }

    boolean isShowing() {
        return dialog.isShowing();
    }

    /** What stands in the field. */
    String text() {
        return field.getText().toString();
    }

    void dismiss() {
        dialog.dismiss();
    }
}
