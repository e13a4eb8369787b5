package org.cellgauge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Properties;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * The folder for Android Studio packs the same app as the project's own build: it cannot be run without Google's
 * repository, so that what both say is compared as text.
 */
class StudioBuildTest {
    private static final Path ROOT = Path.of(System.getProperty("cellgauge.root", "."));
    private static final Pattern DEPENDENCY = Pattern.compile(
            "(?m)^\\s*(api|implementation|compileOnly|runtimeOnly)[ (]+(thirdParty\\.\\w+|project\\('[^']+'\\))");
    private static final Pattern LEFT_OUT = Pattern.compile("exclude group: '([^']+)'");
    private static final Pattern VERSION_READ = Pattern.compile("\\b(?:android|levels|versions)\\.(\\w+)");

    private static String text(String file) {
        try {
            return Files.readString(ROOT.resolve(file));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static Properties versions() throws IOException {
        Properties versions = new Properties();
        try (Reader in = Files.newBufferedReader(ROOT.resolve("android-app/versions.properties"))) {
            versions.load(in);
        }
        return versions;
    }

    private static Set<String> found(Pattern pattern, int group, String... files) {
        Set<String> found = new TreeSet<>();
        for (String file : files) {
            Matcher matcher = pattern.matcher(text(file));
            while (matcher.find()) {
                found.add(group < 0 ? matcher.group(1) + " " + matcher.group(2) : matcher.group(group));
            }
        }
        return found;
    }

    @Test
    void bothBuildsReadTheSameVersions() throws IOException {
        for (String file : List.of("android-app/build.gradle", "studio/settings.gradle", "studio/build.gradle")) {
            assertTrue(text(file).contains("versions.properties'"), file);
        }
        Set<String> stated = versions().stringPropertyNames();
        Set<String> own = found(VERSION_READ, 1, "android-app/build.gradle", "gradle/android-resources.gradle",
                "gradle/robolectric.gradle", "gradle/apk.gradle");
        Set<String> studio = found(VERSION_READ, 1, "studio/settings.gradle", "studio/build.gradle",
                "studio/core.gradle", "studio/android-app.gradle");
        for (String name : List.of("applicationId", "javaRelease", "minSdk", "targetSdk")) {
            assertTrue(stated.contains(name) && own.contains(name) && studio.contains(name), name);
        }
        Set<String> read = new HashSet<>(own);
        read.addAll(studio);
        assertTrue(read.containsAll(stated), stated + " in " + read);
    }

    /** No level of Android and no version stands in a second place. */
    @Test
    void neitherBuildStatesALevelOfItsOwn() {
        Pattern level = Pattern.compile("(?i)\\b(min|target|compile)Sdk(Version)?\\b\\s*[:=(]?\\s*\\d+");
        assertEquals(Set.of(), found(Pattern.compile("(" + level + ")"), 1, "android-app/build.gradle",
                "studio/android-app.gradle", "gradle/android-resources.gradle", "gradle/robolectric.gradle"));
        assertEquals(Set.of(), found(Pattern.compile("('[\\w.-]+:[\\w.-]+:\\d[^']*')"), 1, "studio/core.gradle",
                "studio/android-app.gradle", "studio/build.gradle"));
        assertFalse(text("android-app/src/main/AndroidManifest.xml").contains("package="));
    }

    @Test
    void bothBuildsHaveTheSameDependencies() {
        assertEquals(found(DEPENDENCY, -1, "core/build.gradle", "gradle/errorprone.gradle"),
                found(DEPENDENCY, -1, "studio/core.gradle"));
        assertEquals(found(LEFT_OUT, 1, "core/build.gradle"), found(LEFT_OUT, 1, "studio/core.gradle"));
        assertEquals(found(DEPENDENCY, -1, "android-app/build.gradle"),
                found(DEPENDENCY, -1, "studio/android-app.gradle"));
        assertEquals(Set.of("implementation project(':core')"), found(DEPENDENCY, -1, "studio/android-app.gradle"));
    }

    /** The same photo and cell as an example. */
    @Test
    void bothBuildsPackTheSameExample() {
        Pattern fixture = Pattern.compile("fixtures/([\\w-]+)");
        Pattern files = Pattern.compile("include ('cell.yaml'.*)");
        assertEquals(found(fixture, 1, "android-app/build.gradle"), found(fixture, 1, "studio/android-app.gradle"));
        assertEquals(found(files, 1, "android-app/build.gradle"), found(files, 1, "studio/android-app.gradle"));
    }

    /** Whoever has no SDK and no Google's repository builds and tests all the same. */
    @Test
    void theProjectsOwnBuildNeverAsksForThePlugin() throws IOException {
        List<Path> scripts;
        try (Stream<Path> modules = Files.list(ROOT)) {
            scripts = modules.filter(folder -> Files.isDirectory(folder) && !folder.endsWith("studio"))
                    .flatMap(StudioBuildTest::scripts).collect(Collectors.toList());
        }
        scripts.add(ROOT.resolve("build.gradle"));
        scripts.add(ROOT.resolve("settings.gradle"));
        assertTrue(scripts.size() > 15, scripts.toString());
        for (Path script : scripts) {
            String text = Files.readString(script);
            assertFalse(text.contains("com.android.application") || text.contains("google()"), script.toString());
            assertFalse(text.contains("studio/"), script.toString());
        }
    }

    private static Stream<Path> scripts(Path folder) {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> file.toString().endsWith(".gradle")).collect(Collectors.toList()).stream();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
