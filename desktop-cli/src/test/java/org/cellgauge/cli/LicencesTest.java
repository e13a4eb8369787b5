package org.cellgauge.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** The distribution says whose libraries it brings along, and under which terms. */
class LicencesTest {
    private static String text;
    private static List<Path> jars;

    @BeforeAll
    static void read() throws IOException {
        text = squeezed(Files.readString(Path.of(System.getProperty("cellgauge.licences"))));
        jars = List.of(System.getProperty("cellgauge.libraries").split(File.pathSeparator)).stream().map(Path::of)
                .collect(Collectors.toList());
    }

    private static String squeezed(String text) {
        return text.replaceAll("\\s+", " ").trim();
    }

    private static int count(String part) {
        return text.split(Pattern.quote(part), -1).length - 1;
    }

    @Test
    void everyJarIsNamedOnceWithItsVersionAndALicence() {
        assertTrue(jars.size() > 15, jars.toString());
        for (Path jar : jars) {
            String title = jar.getFileName().toString().replaceAll("-(\\d[^-]*)\\.jar$", " $1");
            assertEquals(1, count("- " + title + " ("), title);
        }
        assertEquals(jars.size(), count("): Apache License 2.0") + count("): BSD 3-Clause License")
                + count("): MIT No Attribution (MIT-0)"));
    }

    @Test
    void everyNoticeIsThereInFull() throws IOException {
        int notices = 0;
        for (Path jar : jars) {
            try (ZipFile zip = new ZipFile(jar.toFile())) {
                for (ZipEntry entry : (Iterable<ZipEntry>) zip.stream().map(e -> (ZipEntry) e)::iterator) {
                    if (entry.getName().matches("META-INF/(NOTICE|COPYRIGHT).*")) {
                        notices++;
                        assertTrue(text.contains(squeezed(new String(zip.getInputStream(entry).readAllBytes(),
                                StandardCharsets.UTF_8))), jar + ": " + entry);
                    }
                }
            }
        }
        assertTrue(notices > 0);
        assertTrue(text.contains("developed for Orekit by CS Systèmes d'Information"));
    }

    /** What commons-math took from others stands under their terms, which its jar adds to the Apache License. */
    @Test
    void termsBeyondTheLicenceAreThereToo() {
        for (String holder : List.of("Minpack Copyright Notice (1999) University of Chicago", "Ernst Hairer",
                "Makoto Matsumoto and Takuji Nishimura", "Frances Y. Kuo and Stephen Joe", "SciPy Developers")) {
            assertTrue(text.contains(holder), holder);
        }
    }

    /** Its sources have a notice that its jar lacks: parts of it stand under other terms. */
    @Test
    void noticeThatOnlyTheSourcesHaveIsThereToo() {
        assertEquals(1, count("NOTICE of its sources"));
        assertTrue(text.contains("one or more files from OpenJDK, licensed under GPL v2 with Classpath Exception"));
        assertEquals(1, count("\"CLASSPATH\" EXCEPTION TO THE GPL"));
    }

    @Test
    void ownTermsStandAtTheTop() throws IOException {
        Path root = Path.of(System.getProperty("cellgauge.root"));
        assertTrue(text.indexOf(squeezed(Files.readString(root.resolve("NOTICE"))))
                < text.indexOf("Each library stands"));
        assertEquals(squeezed(Files.readString(root.resolve("LICENSE"))),
                text.substring(text.indexOf("Apache License Version 2.0, January 2004"),
                        text.indexOf(" [ BSD 3-Clause")));
    }

    @Test
    void fullTextsAreThereOnce() {
        assertEquals(1, count("Apache License Version 2.0, January 2004"));
        assertEquals(1, count("9. Accepting Warranty or Additional Liability."));
        assertEquals(1, count("See the License for the specific language governing permissions and limitations under"
                + " the License. [ BSD 3-Clause License"));
        assertEquals(1, count("[ BSD 3-Clause License ] BSD 3-Clause License Redistribution and use in source"));
        assertTrue(text.contains("Copyright (c) 2008-2020, Harald Kuhr"));
        assertEquals(1, count("MIT No Attribution Permission is hereby granted, free of charge,"));
        assertFalse(text.contains("null"));
    }
}
