package org.cellgauge.android.files;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** A kept result; immutable. */
public final class SavedResult {
    private final String name;
    private final List<String> uris;

    /**
     * A kept result.
     *
     * @param name common beginning of its files' names
     * @param uris content URIs that other apps may be given, one per file
     */
    public SavedResult(String name, List<String> uris) {
        this.name = name;
        this.uris = Collections.unmodifiableList(new ArrayList<>(uris));
    }

    /**
     * Common beginning of its files' names.
     *
     * @return for people
     */
    public String name() {
        return name;
    }

    /**
     * Its files.
     *
     * @return content URIs that other apps may be given
     */
    public List<String> uris() {
        return uris;
    }
}
