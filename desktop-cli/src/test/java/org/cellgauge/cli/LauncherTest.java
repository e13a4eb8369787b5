package org.cellgauge.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The script that starts Java, with a Java that says what it was started with. */
class LauncherTest {
    private static final Path SCRIPT =
            Path.of(System.getProperty("cellgauge.root"), "desktop-cli", "src", "dist", "bin", "cellgauge");

    @TempDir
    private Path folder;

    @BeforeEach
    void install() throws IOException {
        Files.createDirectories(folder.resolve("installed/bin"));
        Files.createDirectories(folder.resolve("installed/lib"));
        Files.copy(SCRIPT, folder.resolve("installed/bin/cellgauge"));
        Files.createDirectories(folder.resolve("java/bin"));
        Files.writeString(folder.resolve("java/release"), "JAVA_VERSION=\"17.0.1\"\n");
        Path java = folder.resolve("java/bin/java");
        Files.writeString(java, "#!/bin/sh\nprintf '%s\\n' \"$@\"\n");
        if (!java.toFile().setExecutable(true)) {
            throw new IOException("not executable: " + java);
        }
    }

    private boolean optimises(String compiler, String... arguments) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of("sh", folder.resolve("installed/bin/cellgauge").toString()));
        command.addAll(Arrays.asList(arguments));
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
        builder.environment().put("JAVA_HOME", folder.resolve("java").toString());
        builder.environment().put("CELLGAUGE_COMPILER", compiler);
        Process process = builder.start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, process.waitFor(), said);
        // all that was given is handed on, in its order
        assertEquals(String.join("\n", arguments), said.substring(said.indexOf("Main\n") + 5).strip());
        return !said.contains("-XX:TieredStopAtLevel=1\n");
    }

    private static String[] check(int photos) {
        String[] arguments = new String[photos + 1];
        Arrays.fill(arguments, "a photo.png");
        arguments[0] = "check";
        return arguments;
    }

    @Test
    void longWorkIsOptimised() throws IOException, InterruptedException {
        assertEquals(false, optimises("", "check", "--cell", "cell.yaml", "photo.png"));
        assertEquals(true, optimises("", "validate", "--cell", "cell.yaml"));
        assertEquals(false, optimises("", check(240)));
        assertEquals(true, optimises("", check(260)));
    }

    @Test
    void folderCountsAsWhatIsInIt() throws IOException, InterruptedException {
        Path photos = Files.createDirectory(folder.resolve("many photos"));
        assertEquals(false, optimises("", "check", photos.toString()));
        for (int i = 0; i < 260; i++) {
            Files.createFile(photos.resolve("photo " + i));
        }
        assertEquals(true, optimises("", "check", photos.toString()));
    }

    @Test
    void whatIsSaidOfTheCompilerHolds() throws IOException, InterruptedException {
        assertEquals(false, optimises("quick", check(260)));
        assertEquals(true, optimises("full", check(1)));
    }
}
