package org.cellgauge.android.state;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.File;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import org.cellgauge.android.files.Photo;
import org.cellgauge.internal.overlay.ImageOrientation;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.vision.GreyImage;

/**
 * The frozen frame in a file of its own, so that its check comes back when the system has ended the app meanwhile. The
 * file is written whole or not at all; one that is damaged counts as none.
 */
public final class FrozenFrameFile {
    private static final int MAGIC = 0x43474632;
    private static final int MOST_PIXELS = 100_000_000;

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

    private final File file;

    /**
     * A place for one frame.
     *
     * @param folder where the app may write what need not last
     */
    public FrozenFrameFile(File folder) {
        this.file = new File(folder, "frozen-frame");
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
        for (File f : new File[] {file, new File(file.getPath() + ".part")}) {
            if (f.exists() && !f.delete()) {
                f.deleteOnExit();
            }
        }
    }
}
