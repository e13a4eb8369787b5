package org.cellgauge.android.files;

import android.content.Context;
import android.content.res.AssetManager;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import org.cellgauge.cell.CameraReader;
import org.cellgauge.cell.CameraSource;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.cell.StatedCamera;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.cell.CellPhrase;
import org.cellgauge.internal.cell.InputFiles;
import org.cellgauge.warning.RefusalKind;

/** Cells and photos out of Android's document picker, and the example out of the app itself. */
public final class DocumentLibrary implements CellLibrary {
    private static final RefusalKind CELL_FILE = CellPhrase.CELL_FILE;
    private static final RefusalKind CAMERA_FILE = CellPhrase.CAMERA_FILE;
    private static final String EXAMPLE = "example/";
    private static final String EXAMPLE_CELL = "cell.yaml";
    private static final String EXAMPLE_PHOTO = "photo.png";
    /** Stands in a cell whose camera is the device's, until that is known. */
    private static final PinholeCamera PLACEHOLDER = PinholeCamera.ideal(1280, 720, 1000, 1000, 640, 360);

    private final AssetManager assets;
    private final Documents documents;

    /**
     * A library.
     *
     * @param context of the app
     */
    public DocumentLibrary(Context context) {
        this.assets = context.getApplicationContext().getAssets();
        this.documents = new Documents(context.getApplicationContext().getContentResolver());
    }

    @Override
    public CellDocument example() {
        CameraSource cameras = name -> asset(name, CAMERA_FILE, CameraReader.MAX_BYTES);
        Cell cell = CellReader.read(asset(EXAMPLE_CELL, CELL_FILE, CellReader.MAX_BYTES), EXAMPLE_CELL, cameras);
        return new CellDocument(EXAMPLE_CELL, null, cell, cell.camera());
    }

    @Override
    public Photo examplePhoto() {
        try (InputStream in = assets.open(EXAMPLE + EXAMPLE_PHOTO)) {
            return new Photo(EXAMPLE_PHOTO, PhotoReader.read(in, EXAMPLE_PHOTO));
        } catch (IOException e) {
            throw new UncheckedIOException("the app was packed without its example", e);
        }
    }

    private String asset(String name, RefusalKind what, int maxBytes) {
        try (InputStream in = assets.open(EXAMPLE + name)) {
            return InputFiles.text(in, name, what, maxBytes);
        } catch (IOException e) {
            throw new UncheckedIOException("the app was packed without its example", e);
        }
    }

    @Override
    public CellDocument cell(String uri, String calibrationUri) {
        return documents.read(uri, CELL_FILE, true, (in, name) -> cell(uri, name,
                InputFiles.text(in, name, CELL_FILE, CellReader.MAX_BYTES), calibrationUri));
    }

    private CellDocument cell(String uri, String name, String text, String calibrationUri) {
        if (calibrationUri != null) {
            String camera = CellReader.statedCamera(text, name).cameraName();
            return documents.read(calibrationUri, CAMERA_FILE, true, (in, cameraName) -> {
                String cameraText = InputFiles.text(in, cameraName, CAMERA_FILE, CameraReader.MAX_BYTES);
                Cell cell = CellReader.read(text, name, CameraReader.file(cameraText, cameraName, camera));
                return new CellDocument(name, uri, cell, cell.camera());
            });
        }
        StatedCamera stated = CellReader.statedCamera(text, name);
        if (stated.kind() == StatedCamera.Kind.INLINE) {
            CameraSource none = file -> {
                throw new IllegalStateException("the camera is inline");
            };
            Cell cell = CellReader.read(text, name, none);
            return new CellDocument(name, uri, cell, cell.camera());
        }
        return new CellDocument(name, uri, CellReader.read(text, name, PLACEHOLDER), null, stated.fileName());
    }

    @Override
    public Photo photo(String uri) {
        return documents.read(uri, FileRefusal.PHOTO, false, (in, name) -> new Photo(name, PhotoReader.read(in, name)));
    }
}
