package org.cellgauge.android.files;

import android.content.ContentProvider;
import android.content.ContentValues;
import android.content.pm.ProviderInfo;
import android.database.Cursor;
import android.database.MatrixCursor;
import android.net.Uri;
import android.os.ParcelFileDescriptor;
import android.provider.OpenableColumns;
import java.io.File;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.nio.file.Files;
import java.util.HashMap;
import java.util.Map;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.shadows.ShadowContentResolver;

/** An app that holds documents, and fails as a test tells it. */
public final class TestDocuments extends ContentProvider {
    private static final String AUTHORITY = "org.example.documents";

    private final Map<String, File> files = new HashMap<>();
    private final File folder;
    /** Thrown when a document is opened, if not null. */
    RuntimeException openFault;
    /** Thrown when a document's name is asked for, if not null. */
    RuntimeException queryFault;
    /** Whether documents have no names. */
    boolean nameless;
    /** Whether an open document is null. */
    boolean opensNothing;

    private TestDocuments(File folder) {
        this.folder = folder;
    }

    /**
     * An app without documents yet.
     *
     * @param folder where it keeps them
     * @return known to the system
     */
    public static TestDocuments registered(File folder) {
        TestDocuments documents = new TestDocuments(folder);
        ProviderInfo info = new ProviderInfo();
        info.authority = AUTHORITY;
        info.grantUriPermissions = true;
        documents.attachInfo(RuntimeEnvironment.getApplication(), info);
        ShadowContentResolver.registerProviderInternal(AUTHORITY, documents);
        return documents;
    }

    /**
     * Adds a document.
     *
     * @param name its file name
     * @param content its bytes
     * @return its address
     * @throws IOException if it cannot be written
     */
    public String add(String name, byte[] content) throws IOException {
        File file = new File(folder, "document-" + files.size());
        Files.write(file.toPath(), content);
        String id = "id" + files.size() + "/" + name;
        files.put(id, file);
        return uri(id);
    }

    /**
     * Removes a document.
     *
     * @param uri its address
     */
    public void remove(String uri) {
        files.remove(Uri.parse(uri).getLastPathSegment());
    }

    /**
     * Lets the system refuse every document from now on, or not any more.
     *
     * @param ended whether it does
     */
    public void permissionEnded(boolean ended) {
        openFault = ended ? new SecurityException("Permission Denial") : null;
    }

    static String uri(String id) {
        return new Uri.Builder().scheme("content").authority(AUTHORITY).appendPath(id).build().toString();
    }

    @Override
    public boolean onCreate() {
        return true;
    }

    @Override
    public Cursor query(Uri uri, String[] projection, String selection, String[] arguments, String order) {
        if (queryFault != null) {
            throw queryFault;
        }
        MatrixCursor cursor = new MatrixCursor(new String[] {OpenableColumns.DISPLAY_NAME});
        String id = uri.getLastPathSegment();
        if (!nameless) {
            cursor.addRow(new Object[] {"shown " + id.substring(id.indexOf('/') + 1)});
        }
        return cursor;
    }

    @Override
    public ParcelFileDescriptor openFile(Uri uri, String mode) throws FileNotFoundException {
        if (openFault != null) {
            throw openFault;
        }
        if (opensNothing) {
            return null;
        }
        File file = files.get(uri.getLastPathSegment());
        if (file == null) {
            throw new FileNotFoundException("no such document");
        }
        return ParcelFileDescriptor.open(file, ParcelFileDescriptor.MODE_READ_ONLY);
    }

    @Override
    public String getType(Uri uri) {
        return "application/octet-stream";
    }

    @Override
    public Uri insert(Uri uri, ContentValues values) {
        return null;
    }

    @Override
    public int delete(Uri uri, String selection, String[] arguments) {
        return 0;
    }

    @Override
    public int update(Uri uri, ContentValues values, String selection, String[] arguments) {
        return 0;
    }
}
