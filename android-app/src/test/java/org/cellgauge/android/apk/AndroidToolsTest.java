package org.cellgauge.android.apk;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Which build tools make the APK: those of an SDK before those on the path, the newest complete ones of several. */
class AndroidToolsTest {
    private static final Path SCRIPT =
            Path.of(System.getProperty("cellgauge.root", "."), "gradle", "android-tools.sh").toAbsolutePath();
    private static final List<String> TOOLS = List.of("aapt2", "zipalign", "apksigner", "dexdump");

    @TempDir
    private Path folder;
    private Path path;
    private String printed;

    @BeforeEach
    void makeAPathWithoutTools() throws IOException {
        path = Files.createDirectory(folder.resolve("bin"));
        // what the script itself needs
        for (String command : List.of("sh", "ls", "grep", "awk", "sort", "cut")) {
            Path found = null;
            for (String place : System.getenv("PATH").split(":")) {
                if (found == null && Files.isExecutable(Path.of(place, command))) {
                    found = Path.of(place, command);
                }
            }
            Files.createSymbolicLink(path.resolve(command), found);
        }
    }

    private static void tools(Path in, List<String> names) throws IOException {
        Files.createDirectories(in);
        for (String name : names) {
            Path tool = Files.writeString(in.resolve(name), "#!/bin/sh\n");
            assertTrue(tool.toFile().setExecutable(true));
        }
    }

    private int run(Map<String, String> environment) throws IOException, InterruptedException {
        ProcessBuilder builder = new ProcessBuilder(path.resolve("sh").toString(), SCRIPT.toString());
        builder.environment().clear();
        builder.environment().put("PATH", path.toString());
        builder.environment().putAll(environment);
        builder.redirectErrorStream(true);
        Process process = builder.start();
        printed = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        return process.waitFor();
    }

    private static String all(Path in) {
        List<String> lines = new ArrayList<>();
        TOOLS.forEach(tool -> lines.add(tool + "=" + in.resolve(tool)));
        return String.join("\n", lines) + "\n";
    }

    @Test
    void newestVersionOfAnSdkIsTakenByNumber() throws Exception {
        Path sdk = folder.resolve("sdk");
        for (String version : List.of("9.0.0", "34.0.0", "35.0.0-rc1")) {
            tools(sdk.resolve("build-tools").resolve(version), TOOLS);
        }
        assertEquals(0, run(Map.of("ANDROID_HOME", sdk.toString())));
        assertEquals(all(sdk.resolve("build-tools/35.0.0-rc1")), printed);
        tools(sdk.resolve("build-tools/35.0.0"), TOOLS);
        assertEquals(0, run(Map.of("ANDROID_HOME", sdk.toString())));
        assertEquals(all(sdk.resolve("build-tools/35.0.0")), printed);
    }

    @Test
    void incompleteVersionsArePassedOver() throws Exception {
        Path sdk = folder.resolve("sdk");
        tools(sdk.resolve("build-tools/34.0.0"), TOOLS);
        tools(sdk.resolve("build-tools/35.0.0"), List.of("aapt2", "zipalign", "dexdump"));
        assertEquals(0, run(Map.of("ANDROID_SDK_ROOT", sdk.toString())));
        assertEquals(all(sdk.resolve("build-tools/34.0.0")), printed);
    }

    @Test
    void anSdkComesBeforeThePathAndAndroidHomeBeforeTheOlderName() throws Exception {
        tools(path, TOOLS);
        Path home = folder.resolve("home");
        Path root = folder.resolve("root");
        tools(home.resolve("build-tools/33.0.0"), TOOLS);
        tools(root.resolve("build-tools/34.0.0"), TOOLS);
        assertEquals(0, run(Map.of("ANDROID_HOME", home.toString(), "ANDROID_SDK_ROOT", root.toString())));
        assertEquals(all(home.resolve("build-tools/33.0.0")), printed);
    }

    @Test
    void thePathServesWhereTheSdkHasNone() throws Exception {
        tools(path, TOOLS);
        Path sdk = Files.createDirectory(folder.resolve("sdk"));
        assertEquals(0, run(Map.of("ANDROID_HOME", sdk.toString())));
        assertEquals(all(path), printed);
    }

    @Test
    void whereNothingIsCompleteItSaysWhatIsMissingAndWhatToInstall() throws Exception {
        tools(path, List.of("aapt2", "dexdump"));
        Path sdk = Files.createDirectory(folder.resolve("sdk"));
        assertEquals(1, run(Map.of("ANDROID_HOME", sdk.toString())));
        assertEquals("the Android build tools are incomplete: no zipalign apksigner on the PATH, no complete set under "
                + sdk + "/build-tools. Install them (Debian, Ubuntu: apt-get install aapt apksigner zipalign dexdump),"
                + " or set ANDROID_HOME to an Android SDK with build tools.\n", printed);
    }
}
