package org.cellgauge.android.screen;

import android.content.ContentResolver;
import android.content.Intent;
import android.net.Uri;
import android.os.Parcelable;
import java.util.Locale;

/** A document that another app opens with this one or shares with it; immutable. */
final class GivenDocument {
    private final Uri uri;
    private final boolean photo;

    private GivenDocument(Uri uri, boolean photo) {
        this.uri = uri;
        this.photo = photo;
    }

    /** Its address; null where nothing came but words. */
    Uri uri() {
        return uri;
    }

    /** Whether it is an image; else it should be a cell file. */
    boolean isPhoto() {
        return photo;
    }

    /**
     * What an intent brings.
     *
     * @param intent that the app was started or called with
     * @param resolver knows types that the intent does not tell
     * @return the document, or null where the intent is no offer of one
     */
    static GivenDocument of(Intent intent, ContentResolver resolver) {
        // one out of the list of recent apps was taken when it came; its permission has ended
        if (intent == null || (intent.getFlags() & Intent.FLAG_ACTIVITY_LAUNCHED_FROM_HISTORY) != 0) {
            return null;
        }
        if (Intent.ACTION_VIEW.equals(intent.getAction())) {
            return of(intent.getData(), intent, resolver);
        }
        return Intent.ACTION_SEND.equals(intent.getAction()) ? of(shared(intent), intent, resolver) : null;
    }

    private static GivenDocument of(Uri uri, Intent intent, ContentResolver resolver) {
        return new GivenDocument(uri, uri != null && isImage(uri, intent.getType(), resolver));
    }

    @SuppressWarnings("deprecation") // what replaces it does not exist before Android 13
    private static Uri shared(Intent intent) {
        try {
            Parcelable stream = intent.getParcelableExtra(Intent.EXTRA_STREAM);
            return stream instanceof Uri ? (Uri) stream : null;
        } catch (RuntimeException e) {
            // an object of the other app that nobody here knows
            return null;
        }
    }

    private static boolean isImage(Uri uri, String stated, ContentResolver resolver) {
        String type = isTelling(stated) ? stated : typeOf(uri, resolver);
        if (isTelling(type)) {
            return type.startsWith("image/");
        }
        String path = uri.getPath() == null ? "" : uri.getPath().toLowerCase(Locale.ROOT);
        return path.matches(".*\\.(png|jpe?g|hei[cf]|avif|webp)");
    }

    /** Whether a type says more than that there are bytes. */
    private static boolean isTelling(String type) {
        return type != null && !type.startsWith("*/") && !type.equals("application/octet-stream");
    }

    private static String typeOf(Uri uri, ContentResolver resolver) {
        try {
            return resolver.getType(uri);
        } catch (RuntimeException e) {
            // an app that does not give it: that it cannot be read is said when it is read
            return null;
        }
    }
}
