package org.cellgauge;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Assumptions;

/** Snippets of Python in the documents, run where there is a Python that has their modules. */
final class Python {
    private static final String COMMAND = System.getenv().getOrDefault("CELLGAUGE_PYTHON", "python3");

    private Python() {
    }

    /** How a program ended. */
    record Ran(int code, String printed) {
    }

    /** The snippets of a document, in their order. */
    static List<String> snippets(Path document) throws IOException {
        List<String> found = new ArrayList<>();
        Matcher blocks = Pattern.compile("(?s)```python\n(.*?)```").matcher(Files.readString(document));
        while (blocks.find()) {
            found.add(blocks.group(1));
        }
        return found;
    }

    /** Skips the test where a snippet's modules are missing. */
    static void assumeModulesOf(String snippet, Path folder) throws IOException, InterruptedException {
        String imports = snippet.lines().filter(line -> line.startsWith("import ") || line.startsWith("from "))
                .collect(Collectors.joining("\n"));
        Assumptions.assumeTrue(started(imports, folder.resolve("imports.out")).code() == 0,
                "no such modules: " + COMMAND);
    }

    /** Runs a snippet; skips the test where its modules are missing. */
    static Ran run(String snippet, Path folder, String... arguments) throws IOException, InterruptedException {
        assumeModulesOf(snippet, folder);
        return started(snippet, folder.resolve("snippet.out"), arguments);
    }

    private static Ran started(String program, Path printed, String... arguments) throws IOException,
            InterruptedException {
        List<String> command = new ArrayList<>(List.of(COMMAND, "-c", program));
        command.addAll(List.of(arguments));
        try {
            Process process = new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(printed.toFile())
                    .start();
            return new Ran(process.waitFor(), Files.readString(printed));
        } catch (IOException e) {
            return new Ran(-1, "no Python: " + e.getMessage());
        }
    }
}
