package org.cellgauge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** What {@code ./build} says and tries on a machine that has a JDK and little else. */
@DisabledOnOs(OS.WINDOWS)
class BuildScriptTest {
    private static final Path ROOT = Path.of(System.getProperty("cellgauge.root", "."));
    /** What the script calls, but for what is to be missing: a Gradle, curl, wget, sudo. */
    private static final List<String> TOOLS = List.of("sh", "sed", "dirname", "readlink", "tr", "rm", "cat");

    @TempDir
    private Path folder;
    private Path bin;

    private record Ran(int code, String out, String err) {
    }

    @BeforeEach
    void clone(@TempDir Path tools) throws IOException {
        // the system's own Gradle, wherever the test runs, is out of sight too
        Files.writeString(folder.resolve("build"), Files.readString(ROOT.resolve("build"))
                .replace("/usr/bin/gradle", folder + "/none"));
        Path wrapper = Files.createDirectories(folder.resolve("gradle/wrapper"));
        Files.copy(ROOT.resolve("gradle/wrapper/gradle-wrapper.properties"),
                wrapper.resolve("gradle-wrapper.properties"));
        Files.createDirectory(folder.resolve("out"));
        bin = tools;
        for (String tool : TOOLS) {
            Path there = Path.of("/usr/bin", tool);
            Files.createSymbolicLink(bin.resolve(tool), Files.exists(there) ? there : Path.of("/bin", tool));
        }
        script(bin.resolve("id"), "echo 1000");
        script(bin.resolve("apt-get"), "echo called apt-get");
    }

    private static void script(Path file, String body) throws IOException {
        Files.writeString(file, "#!/bin/sh\n" + body + "\n");
        assertTrue(file.toFile().setExecutable(true));
    }

    private Ran build(String... args) throws IOException, InterruptedException {
        ProcessBuilder builder = new ProcessBuilder("/bin/sh", folder.resolve("build").toString());
        builder.command().addAll(List.of(args));
        builder.environment().clear();
        builder.environment().put("PATH", bin.toString());
        builder.environment().put("HOME", folder.toString());
        builder.environment().put("JAVA_HOME", System.getProperty("java.home"));
        Path out = folder.resolve("printed.out");
        Path err = folder.resolve("printed.err");
        int code = builder.redirectOutput(out.toFile()).redirectError(err.toFile()).start().waitFor();
        return new Ran(code, Files.readString(out), Files.readString(err));
    }

    @Test
    void withoutRootTheExactLineIsSaidOnceTheWrapperFailed() throws IOException, InterruptedException {
        script(folder.resolve("gradlew"), "exit 1");
        Ran ran = build("test");
        assertEquals(1, ran.code());
        assertTrue(ran.err().contains("build: trying the wrapper (it fetches gradle-"), ran.err());
        String line = "build:     apt-get update && apt-get install -y --no-install-recommends gradle\n";
        assertTrue(ran.err().contains(line), ran.err());
        assertFalse(ran.err().contains("called apt-get") || ran.out().contains("called apt-get"), ran.err());
        assertEquals("0 passed, 0 failed, 0 skipped\n", ran.out());
    }

    @Test
    void withoutCurlAndWgetTheWrapperIsTried() throws IOException, InterruptedException {
        script(folder.resolve("gradlew"), "[ \"$1\" = --version ] || echo \"gradle $*\"");
        Ran ran = build("install");
        assertEquals(0, ran.code(), ran.err());
        assertTrue(ran.out().contains("gradle -q --console=plain install"), ran.out());
    }

    @Test
    void anOlderCountOfTestsIsNotShownForThisBuild() throws IOException, InterruptedException {
        // a folder of this name cannot be deleted as a file, whoever runs the test
        Files.createDirectories(folder.resolve("out/test-summary.txt/7 passed"));
        script(folder.resolve("gradlew"), "");
        Ran ran = build("test");
        assertEquals(1, ran.code());
        assertTrue(ran.err().contains("build: cannot write to "), ran.err());
        assertEquals("0 passed, 0 failed, 0 skipped\n", ran.out());
    }
}
