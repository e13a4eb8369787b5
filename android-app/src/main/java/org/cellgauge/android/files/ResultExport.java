package org.cellgauge.android.files;

import android.content.ContentResolver;
import android.content.Context;
import android.net.Uri;
import android.provider.DocumentsContract;
import java.io.File;
import java.io.FileInputStream;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.List;

/** Copies kept results to a folder that the user chose, on a card or in a cloud. Blocks: not for the main thread. */
public final class ResultExport {
    private final ContentResolver resolver;
    private final ResultStore store;

    /**
     * An export.
     *
     * @param context of the app
     */
    public ResultExport(Context context) {
        this.resolver = context.getApplicationContext().getContentResolver();
        this.store = ResultProvider.store(context);
    }

    /**
     * Copies a result.
     *
     * @param result what to copy
     * @param treeUri a folder that the user chose ({@code ACTION_OPEN_DOCUMENT_TREE})
     * @throws IOException if it cannot be copied; what was copied of it is removed again where the folder's app lets it
     */
    public void copy(SavedResult result, String treeUri) throws IOException {
        Uri tree = Uri.parse(treeUri);
        List<Uri> copies = new ArrayList<>();
        boolean whole = false;
        try {
            Uri parent = DocumentsContract.buildDocumentUriUsingTree(tree, DocumentsContract.getTreeDocumentId(tree));
            List<String> files = store.files(result.name());
            if (files.isEmpty()) {
                throw new FileNotFoundException("the result " + result.name() + " is not there any more");
            }
            for (String name : files) {
                Uri copy = DocumentsContract.createDocument(resolver, parent, ResultProvider.mimeType(name), name);
                if (copy == null) {
                    throw new IOException("the chosen folder takes no files");
                }
                copies.add(copy);
                write(store.file(result.name(), name), copy);
            }
            whole = true;
        } catch (RuntimeException e) {
            // whatever the app behind the folder throws comes through
            throw new IOException("the chosen folder cannot be written to (" + e.getClass().getSimpleName()
                    + "); choose another", e);
        } finally {
            if (!whole) {
                copies.forEach(this::remove);
            }
        }
    }

    private void write(File from, Uri to) throws IOException {
        try (InputStream in = new FileInputStream(from); OutputStream out = resolver.openOutputStream(to)) {
            if (out == null) {
                throw new IOException("the chosen folder takes no files");
            }
            byte[] buffer = new byte[1 << 16];
            int n = in.read(buffer);
            while (n >= 0) {
                out.write(buffer, 0, n);
                n = in.read(buffer);
            }
        }
    }

    private void remove(Uri copy) {
        try {
            DocumentsContract.deleteDocument(resolver, copy);
        } catch (FileNotFoundException | RuntimeException e) {
            // the user sees it in the folder and can remove it there
            android.util.Log.w("ResultExport", "a half copy is left behind", e);
        }
    }
}
