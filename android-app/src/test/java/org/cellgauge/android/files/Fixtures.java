package org.cellgauge.android.files;

import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.cellgauge.vision.GreyImage;

/** Files of the repository that tests read. */
final class Fixtures {
    private Fixtures() {
    }

    static Path path(String relative) {
        return new File(System.getProperty("cellgauge.root"), "fixtures/" + relative).toPath();
    }

    static byte[] bytes(String relative) throws IOException {
        return Files.readAllBytes(path(relative));
    }

    /** The pixels of an image row by row, without what lies between its rows. */
    static byte[] pixels(GreyImage image) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        for (int y = 0; y < image.heightPx(); y++) {
            out.write(image.luminance(), image.offset() + y * image.rowStride(), image.widthPx());
        }
        return out.toByteArray();
    }
}
