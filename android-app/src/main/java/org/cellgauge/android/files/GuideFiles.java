package org.cellgauge.android.files;

import android.content.ContentResolver;
import android.content.Context;
import android.content.res.AssetManager;
import android.net.Uri;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.cell.CellPhrase;
import org.cellgauge.internal.cell.InputFiles;

/** What a user begins with: markers to print and a cell file to change. Methods block: not for the main thread. */
public final class GuideFiles {
    private static final String CELL = "guide/cell.yaml";
    /** Markers have no camera; the example states none. */
    private static final PinholeCamera PLACEHOLDER = PinholeCamera.ideal(1280, 720, 1000, 1000, 640, 360);

    private final AssetManager assets;
    private final ContentResolver resolver;

    /**
     * Files of an app.
     *
     * @param context of the app
     */
    public GuideFiles(Context context) {
        this.assets = context.getApplicationContext().getAssets();
        this.resolver = context.getApplicationContext().getContentResolver();
    }

    /**
     * A cell file with remarks, to be changed.
     *
     * @return YAML in UTF-8
     */
    public byte[] exampleCell() {
        return text().getBytes(StandardCharsets.UTF_8);
    }

    private String text() {
        try (InputStream in = assets.open(CELL)) {
            return InputFiles.text(in, CELL, CellPhrase.CELL_FILE, CellReader.MAX_BYTES);
        } catch (IOException e) {
            throw new UncheckedIOException("the app was packed without its example", e);
        }
    }

    /**
     * Markers to print: those of the cell that was in use last, else those of the example.
     *
     * @param library reads that cell
     * @param memory knows which one it was
     * @return a PDF file, true to size
     */
    public byte[] markers(CellLibrary library, AppMemory memory) {
        AppMemory.Choice last = memory.lastChoice();
        if (last != null) {
            try {
                return MarkerSheet.of(library.cell(last.cellUri(), null).cell());
            } catch (InputRefusedException e) {
                // the screen behind this one says so; the example's markers are of use all the same
                return exampleMarkers();
            }
        }
        return exampleMarkers();
    }

    private byte[] exampleMarkers() {
        Cell example = CellReader.read(text(), CELL, PLACEHOLDER);
        return MarkerSheet.of(example);
    }

    /**
     * Writes a document that the user chose a place for.
     *
     * @param uri of the document, new and empty
     * @param content its bytes
     * @throws IOException if it cannot be written
     */
    public void write(String uri, byte[] content) throws IOException {
        try (OutputStream out = resolver.openOutputStream(Uri.parse(uri))) {
            if (out == null) {
                throw new FileNotFoundException("nothing to write to");
            }
            out.write(content);
        } catch (RuntimeException e) {
            // whatever the app behind the document throws comes through
            throw new IOException(e.toString(), e);
        }
    }
}
