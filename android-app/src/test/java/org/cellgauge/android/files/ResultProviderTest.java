package org.cellgauge.android.files;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import android.content.ContentResolver;
import android.content.Context;
import android.content.pm.PackageManager;
import android.content.pm.ProviderInfo;
import android.database.Cursor;
import android.net.Uri;
import android.os.ParcelFileDescriptor;
import android.provider.DocumentsContract;
import android.provider.DocumentsContract.Document;
import android.provider.DocumentsContract.Root;
import android.provider.OpenableColumns;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.Before;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;

/** What other apps see of kept results. */
@RunWith(RobolectricTestRunner.class)
public class ResultProviderTest {
    private static final String AUTHORITY = "org.cellgauge.android.results";

    private final Context context = RuntimeEnvironment.getApplication();
    private final ContentResolver resolver = context.getContentResolver();

    @Before
    public void oneResult() throws IOException {
        Map<String, byte[]> files = new LinkedHashMap<>();
        files.put("a.png", new byte[] {1, 2, 3});
        files.put("a.result.json", new byte[] {'{', '}'});
        files.put("a.cell.yaml", new byte[] {'#'});
        ResultProvider.store(context).write("a", files);
    }

    private static Uri document(String id) {
        return DocumentsContract.buildDocumentUri(AUTHORITY, id);
    }

    private static List<String> strings(Cursor cursor, String column) {
        List<String> out = new ArrayList<>();
        while (cursor.moveToNext()) {
            out.add(cursor.getString(cursor.getColumnIndexOrThrow(column)));
        }
        cursor.close();
        return out;
    }

    @Test
    public void onlyTheSystemAndWhomItGrantsGetIn() throws PackageManager.NameNotFoundException {
        ProviderInfo info = context.getPackageManager().resolveContentProvider(AUTHORITY, 0);
        assertNotNull("the manifest names the provider", info);
        assertEquals(ResultProvider.class.getName(), info.name);
        assertEquals("android.permission.MANAGE_DOCUMENTS", info.readPermission);
        assertEquals("android.permission.MANAGE_DOCUMENTS", info.writePermission);
        assertTrue(info.grantUriPermissions);
        assertTrue(info.exported);
        // a grant is for one address, not for everything
        assertNull(info.uriPermissionPatterns);
        // a permission of this level is given to parts of the system alone
        assertFalse(context.getPackageManager().checkPermission("android.permission.MANAGE_DOCUMENTS",
                "org.example.other") == PackageManager.PERMISSION_GRANTED);
    }

    @Test
    public void sharedFilesHaveNamesSizesAndTypes() {
        Uri uri = Uri.parse(ResultProvider.links(context).of("a", "a.png"));
        assertEquals("content://" + AUTHORITY + "/document/a%2Fa.png", uri.toString());
        try (Cursor cursor = query(uri, null)) {
            assertTrue(cursor.moveToFirst());
            assertEquals(1, cursor.getCount());
            assertEquals("a.png", cursor.getString(cursor.getColumnIndexOrThrow(OpenableColumns.DISPLAY_NAME)));
            assertEquals(3, cursor.getLong(cursor.getColumnIndexOrThrow(OpenableColumns.SIZE)));
        }
        String[] one = {OpenableColumns.SIZE};
        try (Cursor cursor = query(uri, one)) {
            assertArrayEquals(one, cursor.getColumnNames());
            assertTrue(cursor.moveToFirst());
            assertEquals(3, cursor.getLong(0));
        }
        assertEquals("image/png", resolver.getType(uri));
        assertEquals("application/json", resolver.getType(document("a/a.result.json")));
        assertEquals("application/yaml", resolver.getType(document("a/a.cell.yaml")));
        assertEquals(Document.MIME_TYPE_DIR, resolver.getType(document("a")));
    }

    @Test
    public void sharedFilesCanBeReadAndNotWritten() throws IOException {
        try (ParcelFileDescriptor file = resolver.openFileDescriptor(document("a/a.png"), "r")) {
            assertEquals(3, file.getStatSize());
        }
        for (String mode : new String[] {"w", "rw", "rwt", "wa"}) {
            assertThrows(mode, FileNotFoundException.class,
                    () -> resolver.openFileDescriptor(document("a/a.png"), mode));
        }
        assertEquals(3, ResultProvider.store(context).file("a", "a.png").length());
    }

    @Test
    public void noAddressLeadsElsewhere() {
        String[] ids = {"../shared_prefs/x", "a/../../x", "a/..", "..", "a/../a/a.png", "/a/a.png", "a//a.png",
            "a/a.png/", "/etc/passwd", "a/%2e%2e/x", "a/missing.png", "b", ".writing-a/a.png", "a/a.png\0"};
        for (String id : ids) {
            assertThrows(id, FileNotFoundException.class, () -> resolver.openFileDescriptor(document(id), "r"));
            assertFalse(id, found(id));
        }
    }

    private boolean found(String id) {
        try (Cursor cursor = query(document(id), null)) {
            return cursor != null && cursor.getCount() > 0;
        }
    }

    /** As Android asks providers from API 26 on. */
    private Cursor query(Uri uri, String[] projection) {
        return resolver.query(uri, projection, null, null);
    }

    @Test
    public void whatIsThereIsFound() {
        assertTrue(found("a"));
        assertTrue(found("a/a.png"));
        assertTrue(found("/"));
    }

    @Test
    public void theFilesAppShowsResultsAndTheirFiles() {
        Cursor roots = query(DocumentsContract.buildRootsUri(AUTHORITY), null);
        assertTrue(roots.moveToFirst());
        assertEquals(1, roots.getCount());
        assertEquals("CellGauge", roots.getString(roots.getColumnIndexOrThrow(Root.COLUMN_TITLE)));
        String all = roots.getString(roots.getColumnIndexOrThrow(Root.COLUMN_DOCUMENT_ID));
        roots.close();
        assertEquals(Arrays.asList("a"), strings(query(DocumentsContract.buildChildDocumentsUri(AUTHORITY, all), null),
                Document.COLUMN_DISPLAY_NAME));
        assertEquals(Arrays.asList("a/a.cell.yaml", "a/a.png", "a/a.result.json"), strings(
                query(DocumentsContract.buildChildDocumentsUri(AUTHORITY, "a"), null), Document.COLUMN_DOCUMENT_ID));
        assertEquals(Document.MIME_TYPE_DIR, resolver.getType(document(all)));
        assertTrue(ResultProvider.allResults(context).toString().startsWith("content://" + AUTHORITY));
    }

    @Test
    public void wholeResultsCanBeDeletedAndSingleFilesCannot() throws IOException {
        assertThrows(FileNotFoundException.class,
                () -> DocumentsContract.deleteDocument(resolver, document("a/a.png")));
        assertThrows(FileNotFoundException.class, () -> DocumentsContract.deleteDocument(resolver, document("/")));
        assertEquals(3, ResultProvider.store(context).files("a").size());
        assertTrue(DocumentsContract.deleteDocument(resolver, document("a")));
        assertTrue(ResultProvider.store(context).names().isEmpty());
    }

    @Test
    public void childrenAreThoseInside() {
        ResultProvider provider = new ResultProvider();
        ProviderInfo info = context.getPackageManager().resolveContentProvider(AUTHORITY, 0);
        provider.attachInfo(context, info);
        assertTrue(provider.isChildDocument("/", "a"));
        assertTrue(provider.isChildDocument("/", "a/a.png"));
        assertTrue(provider.isChildDocument("a", "a/a.png"));
        assertFalse(provider.isChildDocument("a", "a"));
        assertFalse(provider.isChildDocument("a", "a/../x"));
        assertFalse(provider.isChildDocument("/", "/"));
        assertFalse(provider.isChildDocument("/", "missing"));
    }
}
