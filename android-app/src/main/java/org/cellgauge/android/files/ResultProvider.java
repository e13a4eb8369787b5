package org.cellgauge.android.files;

import android.content.Context;
import android.content.res.AssetFileDescriptor;
import android.database.Cursor;
import android.database.MatrixCursor;
import android.graphics.Point;
import android.net.Uri;
import android.os.CancellationSignal;
import android.os.ParcelFileDescriptor;
import android.provider.DocumentsContract;
import android.provider.DocumentsContract.Document;
import android.provider.DocumentsContract.Root;
import android.provider.DocumentsProvider;
import java.io.File;
import java.io.FileNotFoundException;
import java.util.Locale;
import org.cellgauge.android.R;

/**
 * Shows kept results to the system's Files app, and gives single files to apps that the user shares them with. Nobody
 * else can read them: the provider is closed to all but the system, and an app gets a grant for the files in its
 * intent.
 *
 * <p>Files can be read and never written; whole results can be deleted. A document's id is "/", "RESULT" or
 * "RESULT/FILE"; one that leads anywhere else names nothing.
 */
public final class ResultProvider extends DocumentsProvider {
    private static final String ROOT_ID = "results";
    /** Id of the folder of all results; no result is called like that, since names begin with a letter or digit. */
    private static final String ALL = "/";
    private static final String[] ROOT_COLUMNS = {Root.COLUMN_ROOT_ID, Root.COLUMN_FLAGS, Root.COLUMN_ICON,
        Root.COLUMN_TITLE, Root.COLUMN_DOCUMENT_ID, Root.COLUMN_AVAILABLE_BYTES, Root.COLUMN_MIME_TYPES};
    private static final String[] DOCUMENT_COLUMNS = {Document.COLUMN_DOCUMENT_ID, Document.COLUMN_MIME_TYPE,
        Document.COLUMN_DISPLAY_NAME, Document.COLUMN_LAST_MODIFIED, Document.COLUMN_FLAGS, Document.COLUMN_SIZE};

    private ResultStore store;
    private String authority;

    /**
     * The store of the app's results.
     *
     * @param context of the app
     * @return the store
     */
    static ResultStore store(Context context) {
        return new ResultStore(new File(context.getFilesDir(), "results"), new ResultStore.RealDisk());
    }

    /**
     * What other apps know the app's results by.
     *
     * @param context of the app
     * @return addresses at this provider
     */
    static FolderArchive.ResultLinks links(Context context) {
        Context app = context.getApplicationContext();
        String authority = authority(app);
        return new FolderArchive.ResultLinks() {
            @Override
            public String of(String result, String file) {
                return DocumentsContract.buildDocumentUri(authority, result + "/" + file).toString();
            }

            @Override
            public void changed() {
                app.getContentResolver().notifyChange(DocumentsContract.buildChildDocumentsUri(authority, ALL), null);
            }
        };
    }

    private static String authority(Context context) {
        return context.getPackageName() + ".results";
    }

    @Override
    public boolean onCreate() {
        store = store(getContext());
        authority = authority(getContext());
        return true;
    }

    @Override
    public Cursor queryRoots(String[] projection) {
        MatrixCursor cursor = new MatrixCursor(projection == null ? ROOT_COLUMNS : projection);
        cursor.newRow().add(Root.COLUMN_ROOT_ID, ROOT_ID).add(Root.COLUMN_DOCUMENT_ID, ALL)
                .add(Root.COLUMN_TITLE, getContext().getString(R.string.app_name))
                .add(Root.COLUMN_ICON, R.mipmap.ic_launcher)
                .add(Root.COLUMN_MIME_TYPES, "image/png\napplication/json\napplication/yaml")
                .add(Root.COLUMN_AVAILABLE_BYTES, getContext().getFilesDir().getUsableSpace())
                .add(Root.COLUMN_FLAGS, Root.FLAG_LOCAL_ONLY | Root.FLAG_SUPPORTS_IS_CHILD);
        return cursor;
    }

    @Override
    public Cursor queryDocument(String id, String[] projection) throws FileNotFoundException {
        MatrixCursor cursor = new MatrixCursor(projection == null ? DOCUMENT_COLUMNS : projection);
        if (!addRow(cursor, id)) {
            cursor.close();
            throw nothing(id);
        }
        return cursor;
    }

    @Override
    public Cursor queryChildDocuments(String parentId, String[] projection, String sortOrder)
            throws FileNotFoundException {
        boolean all = ALL.equals(parentId);
        if (!all && store.result(parentId) == null) {
            throw nothing(parentId);
        }
        MatrixCursor cursor = new MatrixCursor(projection == null ? DOCUMENT_COLUMNS : projection);
        // one that was deleted meanwhile is left out
        for (String name : all ? store.names() : store.files(parentId)) {
            addRow(cursor, all ? name : parentId + "/" + name);
        }
        cursor.setNotificationUri(getContext().getContentResolver(),
                DocumentsContract.buildChildDocumentsUri(authority, parentId));
        return cursor;
    }

    /** Adds what a document is, and says whether there is one of this id. */
    private boolean addRow(MatrixCursor cursor, String id) {
        if (ALL.equals(id)) {
            cursor.newRow().add(Document.COLUMN_DOCUMENT_ID, ALL)
                    .add(Document.COLUMN_DISPLAY_NAME, getContext().getString(R.string.app_name))
                    .add(Document.COLUMN_MIME_TYPE, Document.MIME_TYPE_DIR).add(Document.COLUMN_FLAGS, 0);
            return true;
        }
        File result = store.result(id);
        if (result != null) {
            cursor.newRow().add(Document.COLUMN_DOCUMENT_ID, id).add(Document.COLUMN_DISPLAY_NAME, id)
                    .add(Document.COLUMN_MIME_TYPE, Document.MIME_TYPE_DIR)
                    .add(Document.COLUMN_LAST_MODIFIED, result.lastModified())
                    .add(Document.COLUMN_FLAGS, Document.FLAG_SUPPORTS_DELETE);
            return true;
        }
        File file = file(id);
        if (file == null) {
            return false;
        }
        String type = mimeType(file.getName());
        cursor.newRow().add(Document.COLUMN_DOCUMENT_ID, id).add(Document.COLUMN_DISPLAY_NAME, file.getName())
                .add(Document.COLUMN_MIME_TYPE, type).add(Document.COLUMN_LAST_MODIFIED, file.lastModified())
                .add(Document.COLUMN_SIZE, file.length())
                .add(Document.COLUMN_FLAGS, type.startsWith("image/") ? Document.FLAG_SUPPORTS_THUMBNAIL : 0);
        return true;
    }

    @Override
    public ParcelFileDescriptor openDocument(String id, String mode, CancellationSignal signal)
            throws FileNotFoundException {
        if (!"r".equals(mode)) {
            throw new FileNotFoundException("results can be read only, not opened with mode " + mode);
        }
        File file = file(id);
        if (file == null) {
            throw nothing(id);
        }
        return ParcelFileDescriptor.open(file, ParcelFileDescriptor.MODE_READ_ONLY);
    }

    @Override
    public AssetFileDescriptor openDocumentThumbnail(String id, Point size, CancellationSignal signal)
            throws FileNotFoundException {
        // the pictures are as large as a screen at most; the reader scales them
        return new AssetFileDescriptor(openDocument(id, "r", signal), 0, AssetFileDescriptor.UNKNOWN_LENGTH);
    }

    @Override
    public boolean isChildDocument(String parentId, String id) {
        return ALL.equals(parentId) ? !ALL.equals(id) && exists(id)
                : id.startsWith(parentId + "/") && exists(id);
    }

    private boolean exists(String id) {
        return store.result(id) != null || file(id) != null;
    }

    @Override
    public void deleteDocument(String id) throws FileNotFoundException {
        // single files cannot be: the others would be half a result
        if (!store.delete(id)) {
            throw nothing(id);
        }
        revokeDocumentPermission(id);
        getContext().getContentResolver().notifyChange(DocumentsContract.buildChildDocumentsUri(authority, ALL), null);
    }

    /** The file of an id, or null where there is none. */
    private File file(String id) {
        int slash = id.indexOf('/');
        return slash < 0 ? null : store.file(id.substring(0, slash), id.substring(slash + 1));
    }

    private static FileNotFoundException nothing(String id) {
        return new FileNotFoundException("there is no result " + id);
    }

    /** The MIME type of a file by the end of its name. */
    private static String mimeType(String name) {
        String lower = name.toLowerCase(Locale.ROOT);
        if (lower.endsWith(".png")) {
            return "image/png";
        }
        if (lower.endsWith(".json")) {
            return "application/json";
        }
        return lower.endsWith(".yaml") ? "application/yaml" : "application/octet-stream";
    }

    /**
     * The address of a folder of results, for the Files app to open at.
     *
     * @param context of the app
     * @return a document's URI
     */
    public static Uri allResults(Context context) {
        return DocumentsContract.buildRootUri(authority(context), ROOT_ID);
    }
}
