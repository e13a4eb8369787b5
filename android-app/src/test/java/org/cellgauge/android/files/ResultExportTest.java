package org.cellgauge.android.files;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import android.Manifest;
import android.content.Context;
import android.content.pm.ProviderInfo;
import android.database.Cursor;
import android.os.CancellationSignal;
import android.os.ParcelFileDescriptor;
import android.provider.DocumentsContract;
import android.provider.DocumentsProvider;
import java.io.File;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.shadows.ShadowContentResolver;

/** Copies of results in a folder of another app. */
@RunWith(RobolectricTestRunner.class)
public class ResultExportTest {
    private static final String AUTHORITY = "org.example.folders";
    private static final String TREE = DocumentsContract.buildTreeDocumentUri(AUTHORITY, "root").toString();
    private static final SavedResult RESULT = new SavedResult("a", Collections.emptyList());

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private final Context context = RuntimeEnvironment.getApplication();
    private Folder target;

    /** A folder on a card, say, that may get full or be pulled out. */
    private static final class Folder extends DocumentsProvider {
        final List<String> created = new ArrayList<>();
        final List<String> types = new ArrayList<>();
        private final File place;
        RuntimeException fault;
        int room = Integer.MAX_VALUE;

        Folder(File place) {
            this.place = place;
        }

        @Override
        public boolean onCreate() {
            return true;
        }

        @Override
        public boolean isChildDocument(String parentId, String id) {
            return true;
        }

        @Override
        public String createDocument(String parentId, String mimeType, String name) throws FileNotFoundException {
            if (fault != null) {
                throw fault;
            }
            if (created.size() >= room) {
                throw new FileNotFoundException("the card is full");
            }
            created.add(name);
            types.add(mimeType);
            try {
                Files.createFile(new File(place, name).toPath());
            } catch (IOException e) {
                throw new FileNotFoundException(e.getMessage());
            }
            return name;
        }

        @Override
        public void deleteDocument(String id) {
            assertTrue(new File(place, id).delete());
        }

        @Override
        public ParcelFileDescriptor openDocument(String id, String mode, CancellationSignal signal)
                throws FileNotFoundException {
            return ParcelFileDescriptor.open(new File(place, id), ParcelFileDescriptor.MODE_READ_WRITE);
        }

        @Override
        public Cursor queryRoots(String[] projection) {
            return null;
        }

        @Override
        public Cursor queryDocument(String id, String[] projection) {
            return null;
        }

        @Override
        public Cursor queryChildDocuments(String parentId, String[] projection, String sortOrder) {
            return null;
        }
    }

    @Before
    public void aResultAndAFolder() throws IOException {
        Map<String, byte[]> files = new LinkedHashMap<>();
        files.put("a.png", new byte[100_000]);
        files.get("a.png")[99_999] = 7;
        files.put("a.result.json", new byte[] {'{', '}'});
        files.put("a.cell.yaml", new byte[] {'#'});
        ResultProvider.store(context).write("a", files);
        target = new Folder(folder.getRoot());
        ProviderInfo info = new ProviderInfo();
        info.authority = AUTHORITY;
        info.exported = true;
        info.grantUriPermissions = true;
        info.readPermission = Manifest.permission.MANAGE_DOCUMENTS;
        info.writePermission = Manifest.permission.MANAGE_DOCUMENTS;
        target.attachInfo(context, info);
        ShadowContentResolver.registerProviderInternal(AUTHORITY, target);
    }

    private List<String> copies() {
        String[] names = folder.getRoot().list();
        Arrays.sort(names);
        return Arrays.asList(names);
    }

    @Test
    public void everyFileIsCopiedWithItsType() throws IOException {
        new ResultExport(context).copy(RESULT, TREE);
        assertEquals(Arrays.asList("a.cell.yaml", "a.png", "a.result.json"), copies());
        assertEquals(Arrays.asList("application/yaml", "image/png", "application/json"), target.types);
        assertArrayEquals(Files.readAllBytes(ResultProvider.store(context).file("a", "a.png").toPath()),
                Files.readAllBytes(new File(folder.getRoot(), "a.png").toPath()));
    }

    @Test
    public void aFolderThatGetsFullKeepsNoHalf() {
        target.room = 2;
        assertThrows(IOException.class, () -> new ResultExport(context).copy(RESULT, TREE));
        assertEquals(2, target.created.size());
        assertEquals(Collections.emptyList(), copies());
    }

    @Test
    public void aFolderWhoseAppBreaksIsSaidSo() {
        target.fault = new SecurityException("no grant");
        String message = assertThrows(IOException.class, () -> new ResultExport(context).copy(RESULT, TREE))
                .getMessage();
        assertTrue(message, message.contains("choose another"));
    }

    @Test
    public void whatIsNoFolderIsSaidSo() {
        assertThrows(IOException.class, () -> new ResultExport(context).copy(RESULT, "content://nowhere/x"));
        assertThrows(IOException.class, () -> new ResultExport(context).copy(RESULT, ""));
        assertEquals(Collections.emptyList(), copies());
    }

    @Test
    public void aResultThatIsGoneCannotBeCopied() {
        SavedResult gone = new SavedResult("b", Collections.emptyList());
        assertThrows(FileNotFoundException.class, () -> new ResultExport(context).copy(gone, TREE));
        assertEquals(Collections.emptyList(), copies());
    }
}
