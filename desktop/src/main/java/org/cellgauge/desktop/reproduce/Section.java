package org.cellgauge.desktop.reproduce;

import java.util.List;

/** A part of the page: which work it rests on, and what it says of it. */
interface Section {
    /** What a user asks for it by: the number of a table, or a word. */
    String id();

    /** What else it is asked for by: numbers of other tables and figures that it covers. */
    default List<String> alsoCalled() {
        return List.of();
    }

    /** Its heading. */
    String title();

    /** The work it rests on. */
    List<Work> needs();

    /** Writes it. */
    void write(Page page, Results results);

    /** Figures by the name of the work. */
    interface Results {
        Figures of(String work);
    }
}
