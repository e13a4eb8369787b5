package org.cellgauge.android;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The screen knows the state, the state knows no screen; camera, files and device know neither. */
class LayersTest {
    private static final File SOURCES = new File(System.getProperty("cellgauge.root"),
            "android-app/src/main/java/org/cellgauge/android");

    private static List<String> imports(String folder, String... forbidden) throws IOException {
        List<String> found = new ArrayList<>();
        for (File file : new File(SOURCES, folder).listFiles()) {
            for (String line : Files.readAllLines(file.toPath(), StandardCharsets.UTF_8)) {
                for (String name : forbidden) {
                    if (line.startsWith("import " + name)) {
                        found.add(file.getName() + ": " + line);
                    }
                }
            }
        }
        return found;
    }

    @Test
    void stateKnowsNoScreenAndNoContext() throws IOException {
        assertEquals(new ArrayList<>(), imports("state", "org.cellgauge.android.screen", "android.content",
                "android.app", "android.view", "android.widget", "android.graphics", "android.hardware"));
    }

    /** No mathematics of its own, and no library of core's behind core's back. */
    @Test
    void theAppKnowsAndroidCoreAndTheStreamOfStatesAndNothingElse() throws IOException {
        List<String> found = new ArrayList<>();
        for (String folder : new String[] {"", "camera", "files", "device", "state", "screen"}) {
            for (File file : new File(SOURCES, folder).listFiles(f -> f.getName().endsWith(".java"))) {
                for (String line : Files.readAllLines(file.toPath(), StandardCharsets.UTF_8)) {
                    if (line.matches("import (static )?(?!java\\.|android\\.|io\\.reactivex\\.|org\\.cellgauge\\.).*")
                            || line.matches(".*\\b(boofcv|georegression|org\\.ejml|org\\.ddogleg|"
                                    + "org\\.apache\\.commons\\.math3)\\..*")) {
                        found.add(file.getName() + ": " + line);
                    }
                }
            }
        }
        assertEquals(new ArrayList<>(), found);
    }

    @Test
    void cameraFilesAndDeviceKnowNeitherStateNorScreen() throws IOException {
        for (String folder : new String[] {"camera", "files", "device"}) {
            assertEquals(new ArrayList<>(),
                    imports(folder, "org.cellgauge.android.screen", "org.cellgauge.android.state"));
        }
    }
}
