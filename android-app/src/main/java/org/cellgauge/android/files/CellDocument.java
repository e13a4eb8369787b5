package org.cellgauge.android.files;

import org.cellgauge.cell.Cell;
import org.cellgauge.geometry.PinholeCamera;

/** A cell file as the user chose it, read and judged; immutable. */
public final class CellDocument {
    private final String name;
    private final String uri;
    private final Cell cell;
    private final PinholeCamera calibration;

    /**
     * A document.
     *
     * @param name its file name, for people
     * @param uri where it can be read again; null for the bundled example
     * @param cell what it says; its camera is a placeholder where {@code calibration} is null
     * @param calibration the camera that it states or that was chosen with it, or null: the device's own
     */
    public CellDocument(String name, String uri, Cell cell, PinholeCamera calibration) {
        this.name = name;
        this.uri = uri;
        this.cell = cell;
        this.calibration = calibration;
    }

    /**
     * Its file name.
     *
     * @return for people
     */
    public String name() {
        return name;
    }

    /**
     * Where it can be read again.
     *
     * @return a document's URI, or null for the bundled example
     */
    public String uri() {
        return uri;
    }

    /**
     * What it says.
     *
     * @return the cell; its camera means nothing where {@link #calibration()} is null
     */
    public Cell cell() {
        return cell;
    }

    /**
     * The camera that the file states or that was chosen with it.
     *
     * @return intrinsics, or null: the device's own model is to be used
     */
    public PinholeCamera calibration() {
        return calibration;
    }
}
