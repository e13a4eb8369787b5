package org.cellgauge.android.files;

import android.content.ContentResolver;
import android.content.Intent;
import android.database.Cursor;
import android.net.Uri;
import android.provider.OpenableColumns;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;
import org.cellgauge.warning.RefusalKind;

/** Documents that the user chose, opened; what other apps' providers do wrong becomes a refusal with a remedy. */
final class Documents {
    private final ContentResolver resolver;

    /** What is done with an open document. */
    interface Reading<T> {
        /**
         * Reads a document.
         *
         * @param in its content, closed by the caller
         * @param name its file name, for messages
         * @return what was read
         * @throws IOException if it cannot be read
         */
        T read(InputStream in, String name) throws IOException;
    }

    Documents(ContentResolver resolver) {
        this.resolver = resolver;
    }

    /**
     * Reads a document.
     *
     * @param uriText its address
     * @param what what it should be, without places, for messages
     * @param again whether it will be wanted again later: the permission to read it is then kept where it can be
     * @param reading what is done with it
     * @return what was read
     * @throws InputRefusedException if it cannot be read, or as {@code reading} throws it
     */
    <T> T read(String uriText, RefusalKind what, boolean again, Reading<T> reading) {
        Uri uri = Uri.parse(uriText);
        if (!ContentResolver.SCHEME_CONTENT.equals(uri.getScheme())) {
            // a path would be read with the app's own rights, whoever handed it over
            throw new InputRefusedException(uriText, FileRefusal.NO_DOCUMENT, what);
        }
        String name = name(uri);
        if (again) {
            keepPermission(uri);
        }
        try (InputStream in = resolver.openInputStream(uri)) {
            if (in == null) {
                throw new FileNotFoundException("nothing to open");
            }
            return reading.read(in, name);
        } catch (FileNotFoundException e) {
            throw refused(e, name, FileRefusal.GONE, what);
        } catch (SecurityException e) {
            throw refused(e, name, FileRefusal.PERMISSION_ENDED, what);
        } catch (InputRefusedException e) {
            throw e;
        } catch (IOException e) {
            throw refused(e, name, FileRefusal.NOT_READABLE, what, String.valueOf(e.getMessage()));
        } catch (RuntimeException e) {
            // whatever the app behind the document throws comes through
            throw refused(e, name, FileRefusal.APP_FAILS, what, e.getClass().getSimpleName());
        }
    }

    private static InputRefusedException refused(Exception cause, String name, FileRefusal kind, Object... arguments) {
        return new InputRefusedException(Refusal.at(Place.of(name), kind, arguments), cause);
    }

    private void keepPermission(Uri uri) {
        try {
            resolver.takePersistableUriPermission(uri, Intent.FLAG_GRANT_READ_URI_PERMISSION);
        } catch (SecurityException e) {
            // not every app offers it: then the document is to be chosen again next time, which is said when it is
            // missing
            return;
        }
    }

    /** The name that people know a document by. */
    private String name(Uri uri) {
        try (Cursor cursor = resolver.query(uri, new String[] {OpenableColumns.DISPLAY_NAME}, null, null, null)) {
            if (cursor != null && cursor.moveToFirst()) {
                int column = cursor.getColumnIndex(OpenableColumns.DISPLAY_NAME);
                String name = column < 0 ? null : cursor.getString(column);
                if (name != null && !name.isEmpty()) {
                    return name;
                }
            }
        } catch (RuntimeException e) {
            // without a name it is called by the end of its address; that it cannot be read is found when it is opened
            return nameless(uri);
        }
        return nameless(uri);
    }

    private static String nameless(Uri uri) {
        String segment = uri.getLastPathSegment();
        return segment == null || segment.isEmpty() ? uri.toString() : segment.substring(segment.lastIndexOf('/') + 1);
    }
}
