package org.cellgauge.examples;

import java.nio.file.Path;
import java.time.LocalDate;
import java.util.List;
import org.cellgauge.desktop.BatchCheck;
import org.cellgauge.desktop.BatchOutcome;
import org.cellgauge.desktop.CellFile;
import org.cellgauge.desktop.CheckInput;
import org.cellgauge.desktop.ResultFolder;
import org.cellgauge.settings.CheckSettings;

/** Checks all photos of a folder, with the files that the command line writes, and prints a line for each. */
public final class CheckFolder {
    private CheckFolder() {
    }

    /**
     * Runs the example.
     *
     * @param args the cell file, the folder of photos, the folder for results
     */
    public static void main(String... args) {
        BatchCheck batch = BatchCheck.of(CellFile.read(Path.of(args[0])))
                .settings(CheckSettings.builder().seed(1).build())
                .folder(ResultFolder.into(Path.of(args[2]))).day(LocalDate.now().toString()).version("example")
                .listener(photo -> System.out.println(photo.number() + " of " + photo.count() + ", "
                        + photo.input().name() + ": " + photo.word()))
                .build();
        BatchOutcome outcome = batch.run(CheckInput.resolve(List.of(Path.of(args[1])), List.of()));
        System.out.println(outcome.total());
    }
}
