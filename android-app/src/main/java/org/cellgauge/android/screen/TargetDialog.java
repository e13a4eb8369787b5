package org.cellgauge.android.screen;

import android.app.Activity;
import android.app.AlertDialog;
import android.text.method.DigitsKeyListener;
import android.view.LayoutInflater;
import android.view.View;
import android.view.inputmethod.EditorInfo;
import android.widget.Button;
import android.widget.EditText;
import android.widget.TextView;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import org.cellgauge.android.R;
import org.cellgauge.android.state.CheckScreenState;
import org.cellgauge.android.state.CheckSession;
import org.cellgauge.cell.Requirement;
import org.cellgauge.cell.Target;

/**
 * Asks for a target: how far an error may go and how surely, or how large a standard deviation may be; of all objects,
 * or of one of them alone.
 */
final class TargetDialog {
    /** Stands for all objects of which nothing else is asked. */
    static final int ALL = -1;
    private static final int TOLERANCE = 0;
    private static final int PROBABILITY = 1;
    private static final int STD = 2;
    private static final double PERCENT = 100;

    private final CheckSession session;
    private final int objectId;
    private final AlertDialog dialog;
    private final EditText[] fields;
    private final Wording words;

    /**
     * Opens the dialog for all objects.
     *
     * @param activity the screen
     * @param session gets the target
     * @param texts what stands in the fields, as {@link #texts()} gave it; null for the target in force
     */
    TargetDialog(Activity activity, CheckSession session, String[] texts) {
        this(activity, session, texts, texts == null ? ALL : Integer.parseInt(texts[texts.length - 1]));
    }

    /**
     * Opens the dialog.
     *
     * @param activity the screen
     * @param session gets the target
     * @param texts what stands in the fields; null for the target in force
     * @param objectId the object that it is about, or {@link #ALL}
     */
    TargetDialog(Activity activity, CheckSession session, String[] texts, int objectId) {
        this.session = session;
        this.objectId = objectId;
        this.words = new Wording(activity.getResources());
        CheckScreenState state = session.state();
        View content = LayoutInflater.from(activity).inflate(R.layout.target, null);
        fields = new EditText[] {content.findViewById(R.id.target_tolerance),
            content.findViewById(R.id.target_probability), content.findViewById(R.id.target_field)};
        Locale locale = activity.getResources().getConfiguration().getLocales().get(0);
        String[] shown = texts != null ? texts : texts(asked(state.target()));
        for (int i = 0; i < fields.length; i++) {
            fields[i].setKeyListener(DigitsKeyListener.getInstance(locale, false, true));
            fields[i].setText(shown[i]);
            fields[i].setSelection(fields[i].length());
        }
        Target stated = state.cell() == null ? Target.NONE : state.cell().cell().target();
        Button ofFile = content.findViewById(R.id.target_of_file);
        ofFile.setText(stated.oneStdMm().isPresent()
                ? words.get(R.string.target_of_file, words.plain(stated.oneStdMm().getAsDouble()))
                : words.get(stated.isAny() ? R.string.target_of_file_stated : R.string.target_of_file_none));
        dialog = new AlertDialog.Builder(activity)
                .setTitle(objectId == ALL ? words.get(R.string.target_title)
                        : words.get(R.string.target_title_object, objectId))
                .setView(content).setPositiveButton(R.string.target_set, null)
                .setNegativeButton(R.string.cancel, null).create();
        ofFile.setOnClickListener(v -> {
            if (objectId == ALL) {
                session.resetTarget();
            } else {
                choose(stated.of(objectId));
            }
            dialog.dismiss();
        });
        fields[STD].setOnEditorActionListener((v, action, event) -> {
            if (action == EditorInfo.IME_ACTION_DONE) {
                take();
            }
            return action == EditorInfo.IME_ACTION_DONE;
        });
        // set afterwards, so that a wrong number does not close the dialog
        dialog.setOnShowListener(d -> dialog.getButton(AlertDialog.BUTTON_POSITIVE).setOnClickListener(v -> take()));
        dialog.show();
    }

    private Requirement asked(Target target) {
        return objectId == ALL ? target.general() : target.of(objectId);
    }

    private String[] texts(Requirement asked) {
        return new String[] {asked.toleranceMm().isUniform() ? words.plain(asked.toleranceMm().x()) : "",
            words.plain(Math.round(asked.probability() * PERCENT * PERCENT) / PERCENT),
            asked.stdMm().isUniform() ? words.plain(asked.stdMm().x()) : ""};
    }

    private void take() {
        double tolerance = number(fields[TOLERANCE]);
        double percent = number(fields[PROBABILITY]);
        double std = number(fields[STD]);
        if (!(tolerance > 0)) {
            wrong(fields[TOLERANCE], R.string.target_wrong, 3);
        } else if (!(percent > 0 && percent < PERCENT)) {
            wrong(fields[PROBABILITY], R.string.target_wrong_probability, 95);
        } else if (!(std > 0) || Double.isInfinite(std) && Double.isInfinite(tolerance)) {
            wrong(fields[STD], R.string.target_wrong, 0.5);
        } else {
            Requirement before = asked(session.state().target());
            choose(new Requirement(Requirement.Axes.all(std), Requirement.Axes.all(tolerance), before.distanceMm(),
                    before.toleranceDeg(), Double.isInfinite(tolerance) && !before.asksForProbability()
                            ? Requirement.USUAL_PROBABILITY : percent / PERCENT));
            dialog.dismiss();
        }
    }

    private void choose(Requirement requirement) {
        Target target = session.state().target();
        if (objectId == ALL) {
            session.chooseTarget(new Target(requirement, target.own()));
        } else {
            Map<Integer, Requirement> own = new HashMap<>(target.own());
            own.put(objectId, requirement);
            session.chooseTarget(new Target(target.general(), own));
        }
    }

    /** The number in a field; infinite where it is empty, so that nothing is asked. */
    private static double number(TextView field) {
        String text = field.getText().toString().trim();
        return text.isEmpty() ? Double.POSITIVE_INFINITY : Decimals.parse(text);
    }

    private void wrong(EditText field, int sentence, double example) {
        field.setError(words.get(sentence, words.plain(example)));
        field.requestFocus();
    }

    boolean isShowing() {
        return dialog.isShowing();
    }

    /** What stands in the fields, and at the end which object it is about. */
    String[] texts() {
        return new String[] {fields[TOLERANCE].getText().toString(), fields[PROBABILITY].getText().toString(),
            fields[STD].getText().toString(), String.valueOf(objectId)};
    }

    void dismiss() {
        dialog.dismiss();
    }
}
