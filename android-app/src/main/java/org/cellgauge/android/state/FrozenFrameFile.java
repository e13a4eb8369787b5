package org.cellgauge.android.state;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.File;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import org.cellgauge.android.files.Photo;
import org.cellgauge.internal.overlay.ImageOrientation;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.vision.GreyImage;

/**
 * The frozen frame of one screen in a file of its own, so that its check comes back when the system has ended the app
 * meanwhile. Two screens of the app that are open at a time have two files. A file is written whole or not at all; one
 * that is damaged counts as none.
 */
public final class FrozenFrameFile {
    private static final int MAGIC = 0x43474632;
    private static final int MOST_PIXELS = 100_000_000;
    private static final String PREFIX = "frozen-frame";
    private static final Pattern ID = Pattern.compile("[0-9a-f-]{1,64}");
    /** What nobody has come back to for so long is of a screen that was swept away. */
    private static final long LONGEST_KEPT_MS = TimeUnit.DAYS.toMillis(7);
    /** Frames take megabytes; nobody has so many screens of the app open. */
    private static final int MOST_KEPT = 8;

    /** What was frozen, and how it was held. */
    static final class Frame {
        private final Photo photo;
        private final ImageOrientation orientation;

        Frame(Photo photo, ImageOrientation orientation) {
            this.photo = photo;
            this.orientation = orientation;
        }

        Photo photo() {
            return photo;
        }

        ImageOrientation orientation() {
            return orientation;
        }
    }

    private final File folder;
    private final String id;
    private final File file;

    /**
     * A place for one frame.
     *
     * @param folder where the app may write what need not last
     * @param id of the screen whose frame it is, as {@link #newId()} made it once
     * @throws IllegalArgumentException if the id is none
     */
    public FrozenFrameFile(File folder, String id) {
        if (!ID.matcher(id).matches()) {
            throw new IllegalArgumentException("no id of a frozen frame: " + id);
        }
        this.folder = folder;
        this.id = id;
        this.file = new File(folder, PREFIX + "-" + id);
    }

    /**
     * An id that no screen has.
     *
     * @return to be kept with what the system keeps of the screen
     */
    public static String newId() {
        return UUID.randomUUID().toString();
    }

    /**
     * The id of the screen whose frame this is.
     *
     * @return as it was given
     */
    public String id() {
        return id;
    }

    /**
     * Removes frames that no screen will ask for again: those that are a week old, and the oldest where there are more
     * than eight. A screen that ends by itself removes its own; what the user sweeps away with its task is not told.
     *
     * @param nowMs the time, ms since 1970
     */
    void clearLeftovers(long nowMs) {
        File[] others = folder.listFiles(f -> f.getName().startsWith(PREFIX)
                && !f.getName().startsWith(file.getName()));
        if (others == null) {
            return;
        }
        // read once, since a time that changes meanwhile would leave no order
        Map<File, Long> times = new HashMap<>();
        for (File other : others) {
            times.put(other, other.lastModified());
        }
        Arrays.sort(others, (a, b) -> Long.compare(times.get(b), times.get(a)));
        for (int i = 0; i < others.length; i++) {
            if (i >= MOST_KEPT || nowMs - times.get(others[i]) > LONGEST_KEPT_MS) {
                remove(others[i]);
            }
        }
    }

    /**
     * Writes a frame in place of the last.
     *
     * @param frame what was frozen
     * @throws IOException if there is no room; the last frame is gone then, too
     */
    synchronized void write(Frame frame) throws IOException {
        GreyImage image = frame.photo.luminance();
        File part = new File(file.getPath() + ".part");
        boolean whole = false;
        try (DataOutputStream out = new DataOutputStream(new BufferedOutputStream(new FileOutputStream(part)))) {
            out.writeInt(MAGIC);
            out.writeUTF(frame.photo.name());
            out.writeUTF(image.toneCurve() == null ? "" : image.toneCurve().words());
            out.writeInt(frame.orientation.quarterTurnsClockwise());
            out.writeBoolean(frame.orientation.mirrored());
            out.writeInt(image.widthPx());
            out.writeInt(image.heightPx());
            for (int y = 0; y < image.heightPx(); y++) {
                out.write(image.luminance(), image.offset() + y * image.rowStride(), image.widthPx());
            }
            out.writeInt(MAGIC);
            whole = true;
        } finally {
            if (!whole) {
                clear();
            }
        }
        if (!part.renameTo(file)) {
            throw new IOException("cannot rename " + part);
        }
    }

    /**
     * Reads the frame.
     *
     * @return the frame, or null where there is none or its file is damaged
     */
    synchronized Frame read() {
        try (DataInputStream in = new DataInputStream(new BufferedInputStream(new FileInputStream(file)))) {
            if (in.readInt() != MAGIC) {
                return null;
            }
            String name = in.readUTF();
            String toneCurve = in.readUTF();
            ImageOrientation orientation = ImageOrientation.of(in.readInt(), in.readBoolean());
            int width = in.readInt();
            int height = in.readInt();
            if (width < 1 || height < 1 || (long) width * height > MOST_PIXELS) {
                return null;
            }
            byte[] luminance = new byte[width * height];
            in.readFully(luminance);
            if (in.readInt() != MAGIC) {
                return null;
            }
            GreyImage image = GreyImage.packed(luminance, width, height);
            return new Frame(new Photo(name, toneCurve.isEmpty() ? image
                    : image.withToneCurve(ToneCurve.of(toneCurve))), orientation);
        } catch (IOException | IllegalArgumentException e) {
            return null;
        }
    }

    /** Removes the frame; what was frozen is not kept longer than it is of use. */
    synchronized void clear() {
        remove(file);
        remove(new File(file.getPath() + ".part"));
    }

    private static void remove(File f) {
        if (f.exists() && !f.delete()) {
            f.deleteOnExit();
        }
    }
}
