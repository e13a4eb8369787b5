package org.cellgauge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** How Java files look, as far as lines and imports go. */
class StyleTest {
    private static final Path ROOT = Path.of(System.getProperty("cellgauge.root", "."));
    private static final List<String> FOLDERS =
            List.of("core/src", "desktop/src", "desktop-cli/src", "android-app/src", "examples", "src");
    private static final int COLUMNS = 120;

    @Test
    void everyJavaFileKeepsToIt() throws IOException {
        List<String> faults = new ArrayList<>();
        int files = 0;
        for (String folder : FOLDERS) {
            try (Stream<Path> paths = Files.walk(ROOT.resolve(folder))) {
                for (Path file : paths.filter(path -> path.toString().endsWith(".java")).sorted().toList()) {
                    files++;
                    faultsOf(Files.readString(file)).forEach(fault -> faults.add(ROOT.relativize(file) + ": " + fault));
                }
            }
        }
        assertTrue(files > 300, files + " files found");
        assertEquals("", String.join("\n", faults));
    }

    @Test
    void everyFaultIsSeen() {
        assertEquals(List.of("line 1 has 121 columns"), faultsOf("/".repeat(121) + "\n"));
        assertEquals(List.of("line 1 has a tab"), faultsOf("class A {}\t// a\n"));
        assertEquals(List.of("line 2 ends in blanks"), faultsOf("class A {\n  \n}\n"));
        assertEquals(List.of("does not end in one line break"), faultsOf("class A {}"));
        assertEquals(List.of("does not end in one line break"), faultsOf("class A {}\n\n"));
        assertEquals(List.of("has a carriage return"), faultsOf("class A {}\r\n"));
        assertEquals(List.of("imports are not in order: java.util.Map before java.util.List"),
                faultsOf("import java.util.Map;\nimport java.util.List;\nList<Map> a;\n"));
        assertEquals(List.of("imports are not in order: java.util.Map before static java.util.List.of"),
                faultsOf("import java.util.Map;\nimport static java.util.List.of;\nMap<A, B> a = of();\n"));
        assertEquals(List.of("imports java.util.Map twice or without use"),
                faultsOf("import java.util.Map;\nList<HashMap> a;\n"));
        assertEquals(List.of("imports all of java.util"), faultsOf("import java.util.*;\n"));
        assertEquals(List.of(),
                faultsOf("import static a.B.c;\n\nimport a.B;\nimport java.util.Map;\n\nB<Map> d = c;\n"));
    }

    private static List<String> faultsOf(String text) {
        List<String> faults = new ArrayList<>();
        if (text.indexOf('\r') >= 0) {
            return List.of("has a carriage return");
        }
        if (!text.endsWith("\n") || text.endsWith("\n\n")) {
            faults.add("does not end in one line break");
        }
        List<String> lines = text.lines().toList();
        for (int i = 0; i < lines.size(); i++) {
            String line = lines.get(i);
            if (line.codePointCount(0, line.length()) > COLUMNS) {
                faults.add("line " + (i + 1) + " has " + line.codePointCount(0, line.length()) + " columns");
            }
            if (line.indexOf('\t') >= 0) {
                faults.add("line " + (i + 1) + " has a tab");
            }
            if (!line.isEmpty() && Character.isWhitespace(line.charAt(line.length() - 1))) {
                faults.add("line " + (i + 1) + " ends in blanks");
            }
        }
        addFaultsOfImports(lines, faults);
        return faults;
    }

    private static void addFaultsOfImports(List<String> lines, List<String> faults) {
        List<String> imports = lines.stream().filter(line -> line.startsWith("import ") && line.endsWith(";"))
                .map(line -> line.substring("import ".length(), line.length() - 1)).toList();
        String rest = lines.stream().filter(line -> !line.startsWith("import ")).collect(Collectors.joining("\n"));
        for (int i = 0; i < imports.size(); i++) {
            String name = imports.get(i);
            if (i > 0 && rank(imports.get(i - 1)).compareTo(rank(name)) > 0) {
                faults.add("imports are not in order: " + imports.get(i - 1) + " before " + name);
            }
            String simple = name.substring(name.lastIndexOf('.') + 1);
            if (simple.equals("*")) {
                faults.add("imports all of " + name.substring(0, name.length() - 2));
            } else if (imports.indexOf(name) < i
                    || !Pattern.compile("\\b" + Pattern.quote(simple) + "\\b").matcher(rest).find()) {
                faults.add("imports " + name + " twice or without use");
            }
        }
    }

    /** Static imports first, then by name. */
    private static String rank(String name) {
        return (name.startsWith("static ") ? "0" : "1") + name;
    }
}
