package org.cellgauge.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.jar.JarOutputStream;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The archive of classes that shortens a start, made as an installation makes it. */
class ClassArchiveTest {
    private static final Path ROOT = Path.of(System.getProperty("cellgauge.root"));
    private static final String SPEC = "picocli.CommandLine$Model$CommandSpec ";
    private static final String CHECK = "org.cellgauge.cli.CheckCommand ";

    @TempDir
    private Path folder;

    /** Lambdas of interfaces that know picocli's largest class, which is of an old kind of class file, keep it out. */
    @Test
    void archiveHasWhatReadsTheCommandLine() throws IOException, InterruptedException {
        Path installed = install();
        run("", "sh", ROOT.resolve("gradle/class-archive.sh").toString(), installed.toString(),
                "check --cell none.yaml none.png --json");

        Path log = folder.resolve("classes.log");
        run("-Xlog:class+load:file=" + log, "sh", installed.resolve("bin/cellgauge").toString(),
                "check", "--cell", "none.yaml", "none.png", "--json");

        assertFromArchive(CHECK, log);
        assertFromArchive(SPEC, log);
    }

    private static void assertFromArchive(String name, Path log) throws IOException {
        List<String> lines = Files.readAllLines(log).stream().filter(line -> line.contains(name)).toList();
        assertEquals(1, lines.size(), name);
        assertTrue(lines.get(0).contains("shared objects file"), lines.get(0));
    }

    /** Script and jars; classes that are in a folder go into a jar, since an archive takes none of a folder. */
    private Path install() throws IOException {
        Path installed = Files.createDirectories(folder.resolve("installed"));
        Path lib = Files.createDirectories(installed.resolve("lib"));
        Files.createDirectories(installed.resolve("bin"));
        Files.copy(ROOT.resolve("desktop-cli/src/dist/bin/cellgauge"), installed.resolve("bin/cellgauge"));
        if (!installed.resolve("bin/cellgauge").toFile().setExecutable(true)) {
            throw new IOException("not executable: " + installed);
        }
        int jars = 0;
        for (String part : System.getProperty("java.class.path").split(File.pathSeparator)) {
            Path path = Path.of(part);
            Path jar = lib.resolve(jars++ + ".jar");
            if (Files.isRegularFile(path)) {
                Files.copy(path, jar);
            } else if (Files.isDirectory(path)) {
                pack(path, jar);
            }
        }
        return installed;
    }

    private static void pack(Path classes, Path jar) throws IOException {
        try (OutputStream file = Files.newOutputStream(jar); JarOutputStream out = new JarOutputStream(file);
                Stream<Path> found = Files.walk(classes)) {
            for (Path each : found.filter(Files::isRegularFile).sorted().toList()) {
                out.putNextEntry(new ZipEntry(classes.relativize(each).toString().replace(File.separatorChar, '/')));
                Files.copy(each, out);
            }
        }
    }

    private void run(String options, String... command) throws IOException, InterruptedException {
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true).directory(folder.toFile());
        builder.environment().put("JAVA_HOME", System.getProperty("java.home"));
        builder.environment().put("CELLGAUGE_JVM_OPTIONS", options);
        Process process = builder.start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        int code = process.waitFor();
        assertTrue(code == 0 || code == ExitCodes.INPUT_REFUSED, said);
    }
}
