package org.cellgauge.android.files;

import org.cellgauge.cell.Cell;
import org.cellgauge.geometry.PinholeCamera;

/** A cell file as the user chose it, read and judged; immutable. */
public final class CellDocument {
    private final String name;
    private final String uri;
    private final Cell cell;
    private final PinholeCamera calibration;
    private final String cameraFile;

    /**
     * A document that names no camera file, or whose camera file was chosen with it.
     *
     * @param name its file name, for people
     * @param uri where it can be read again; null for the bundled example
     * @param cell what it says; its camera is a placeholder where {@code calibration} is null
     * @param calibration the camera that it states or that was chosen with it, or null: the device's own
     */
    public CellDocument(String name, String uri, Cell cell, PinholeCamera calibration) {
        this(name, uri, cell, calibration, null);
    }

    /**
     * A document.
     *
     * @param name its file name, for people
     * @param uri where it can be read again; null for the bundled example
     * @param cell what it says; its camera is a placeholder where {@code calibration} is null
     * @param calibration the camera that it states or that was chosen with it, or null: the device's own
     * @param cameraFile name of a camera file that the cell file refers to and that is yet to be chosen, or null
     */
    public CellDocument(String name, String uri, Cell cell, PinholeCamera calibration, String cameraFile) {
        this.name = name;
        this.uri = uri;
        this.cell = cell;
        this.calibration = calibration;
        this.cameraFile = cameraFile;
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

    /**
     * The camera file that the cell file refers to but the app cannot reach: Android gives an app the documents that a
     * user chose, not their neighbours. The user should be asked for it by this name, and
     * {@link CellLibrary#cell(String, String)} be called again with it; who has none goes on with the device's own
     * model.
     *
     * @return the name after {@code camera:}, or null where nothing is missing
     */
    public String cameraFile() {
        return cameraFile;
    }
}
