package org.cellgauge.settings;

/** A choice that has a word: what files hold and what users write. */
public interface Word {
    /**
     * The word.
     *
     * @return lower case, hyphens between its parts
     */
    String word();
}
