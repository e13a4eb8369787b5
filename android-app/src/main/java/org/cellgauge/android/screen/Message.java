package org.cellgauge.android.screen;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;

/** What stands over the picture because something is in the way, and what can be done about it; immutable. */
final class Message {
    private final String title;
    private final String text;
    private final List<Action> actions;

    /**
     * A message.
     *
     * @param title a few words
     * @param text what is the matter
     * @param actions at most three, the likeliest first
     */
    Message(String title, String text, Action... actions) {
        this.title = title;
        this.text = text;
        this.actions = Collections.unmodifiableList(Arrays.asList(actions));
    }

    String title() {
        return title;
    }

    String text() {
        return text;
    }

    List<Action> actions() {
        return actions;
    }
}
