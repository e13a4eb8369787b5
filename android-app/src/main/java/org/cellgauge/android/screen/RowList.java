package org.cellgauge.android.screen;

import android.content.Context;
import android.content.res.ColorStateList;
import android.util.AttributeSet;
import android.view.LayoutInflater;
import android.view.View;
import android.widget.Button;
import android.widget.ImageView;
import android.widget.LinearLayout;
import android.widget.ProgressBar;
import android.widget.TextView;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import org.cellgauge.android.R;

/** Rows below each other. A row that has not changed is left alone, so that a screen reader stays where it is. */
public final class RowList extends LinearLayout {
    /** A bar is full where all that is asked is taken. */
    private static final int BAR_FULL = 1000;

    private final List<Row> shown = new ArrayList<>();
    private Consumer<Action> actions = action -> { };
    private IntConsumer objects = id -> { };

    /**
     * For the layout's file.
     *
     * @param context of the activity
     * @param attributes of the file
     */
    public RowList(Context context, AttributeSet attributes) {
        super(context, attributes);
    }

    /** Who is told of a button that was pressed. */
    void onAction(Consumer<Action> listener) {
        actions = listener;
    }

    /** Who is told of an object whose row was tapped. */
    void onObject(IntConsumer listener) {
        objects = listener;
    }

    /** Shows rows in place of those before. */
    void show(List<Row> rows) {
        while (getChildCount() > rows.size()) {
            removeViewAt(getChildCount() - 1);
            shown.remove(shown.size() - 1);
        }
        for (int i = 0; i < rows.size(); i++) {
            Row row = rows.get(i);
            if (i == getChildCount()) {
                LayoutInflater.from(getContext()).inflate(R.layout.row, this);
                shown.add(null);
            }
            if (!row.equals(shown.get(i))) {
                shown.set(i, row);
                bind(getChildAt(i), row);
            }
        }
    }

    private void bind(View view, Row row) {
        ImageView mark = view.findViewById(R.id.row_mark);
        mark.setImageResource(row.mark());
        mark.setImageTintList(ColorStateList.valueOf(getContext().getColor(row.colour())));
        text(view.findViewById(R.id.row_title), row.title());
        text(view.findViewById(R.id.row_figures), row.figures());
        text(view.findViewById(R.id.row_bar_text), row.barText());
        ProgressBar bar = view.findViewById(R.id.row_bar);
        bar.setVisibility(row.barText() == null ? GONE : VISIBLE);
        bar.setProgress((int) Math.min(BAR_FULL, Math.round(BAR_FULL * row.bar())));
        bar.setProgressTintList(ColorStateList.valueOf(getContext().getColor(row.colour())));
        text(view.findViewById(R.id.row_text), row.text());
        if (row.objectId().isPresent()) {
            int id = row.objectId().getAsInt();
            view.setOnClickListener(v -> objects.accept(id));
            view.setContentDescription(getContext().getString(R.string.object_row_spoken, row.title(),
                    row.figures() == null ? "" : row.figures()));
        } else {
            view.setOnClickListener(null);
            view.setContentDescription(null);
        }
        view.setClickable(row.objectId().isPresent());
        Button button = view.findViewById(R.id.row_action);
        button.setVisibility(row.action() == null ? GONE : VISIBLE);
        if (row.action() != null) {
            button.setText(row.action().label());
            button.setOnClickListener(v -> actions.accept(row.action()));
        }
    }

    private static void text(TextView view, String text) {
        view.setVisibility(text == null ? GONE : VISIBLE);
        view.setText(text);
    }
}
