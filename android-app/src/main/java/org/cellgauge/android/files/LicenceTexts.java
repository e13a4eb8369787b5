package org.cellgauge.android.files;

import android.content.res.AssetManager;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import org.cellgauge.internal.cell.InputFiles;

/** The libraries in the app and the terms they stand under, as the build wrote them down. */
public final class LicenceTexts {
    private static final String ASSET = "licences.txt";
    private static final int MAX_BYTES = 1 << 20;

    private LicenceTexts() {
    }

    /**
     * Reads them. Blocks: not for the main thread.
     *
     * @param assets of the app
     * @return names, versions, notices and licences; lines are broken for a page of 80 letters or more
     */
    public static String read(AssetManager assets) {
        try (InputStream in = assets.open(ASSET)) {
            return InputFiles.text(in, ASSET, FileRefusal.LICENCES, MAX_BYTES);
        } catch (IOException e) {
            throw new UncheckedIOException("the app was packed without its licences", e);
        }
    }
}
