package org.cellgauge.cell;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import org.junit.jupiter.api.Assumptions;

/** Real photos and calibrations that lie beside the checkout and are no part of it. */
public final class SharedData {
    private SharedData() {
    }

    /**
     * A file of the shared data; the calling test is skipped where it is absent.
     *
     * @param relative path below {@code shared/data}
     * @return the file, found upwards from the working directory
     */
    public static Path file(String relative) {
        for (Path folder = Paths.get("").toAbsolutePath(); folder != null; folder = folder.getParent()) {
            Path file = folder.resolve("shared").resolve("data").resolve(relative);
            if (Files.exists(file)) {
                return file;
            }
        }
        Assumptions.assumeTrue(false, "shared/data/" + relative + " is not beside the checkout");
        throw new IllegalStateException("not reached");
    }
}
