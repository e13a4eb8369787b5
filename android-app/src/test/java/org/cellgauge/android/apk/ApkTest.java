package org.cellgauge.android.apk;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import boofcv.factory.fiducial.HammingDictionary;
import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

/** The APKs as a tablet gets them, judged by Android's own tools. None was installed: that takes a device. */
class ApkTest {
    private static final String ANDROID = "http://schemas.android.com/apk/res/android";
    private static final String PACKAGE = "org.cellgauge.android";
    private static final long MAX_RELEASE_BYTES = 3_000_000;

    @TempDir
    private Path scratch;

    private static Path apk(String variant) {
        return Path.of(System.getProperty("cellgauge.apk." + variant));
    }

    /** What a tool prints; its exit code must be as given. */
    private String run(int exitCode, String tool, Object... arguments) throws IOException, InterruptedException {
        List<String> line = new ArrayList<>(List.of(System.getProperty("cellgauge.tool." + tool)));
        Stream.of(arguments).map(Object::toString).forEach(line::add);
        File output = scratch.resolve("output").toFile();
        ProcessBuilder process = new ProcessBuilder(line).redirectErrorStream(true).redirectOutput(output);
        // apksigner is a script that looks for a Java of its own
        process.environment().put("JAVA_HOME", System.getProperty("java.home"));
        process.environment().merge("PATH", Path.of(System.getProperty("java.home"), "bin").toString(),
                (path, bin) -> bin + File.pathSeparator + path);
        int code = process.start().waitFor();
        String text = Files.readString(output.toPath(), StandardCharsets.ISO_8859_1);
        assertEquals(exitCode, code, () -> line + ": " + text);
        return text;
    }

    private static Set<String> found(String regex, String text) {
        Matcher matcher = Pattern.compile(regex, Pattern.MULTILINE).matcher(text);
        Set<String> found = new TreeSet<>();
        while (matcher.find()) {
            found.add(matcher.group(1));
        }
        return found;
    }

    private static <T> T inside(String variant, ZipReader<T> reader) throws IOException {
        try (ZipFile zip = new ZipFile(apk(variant).toFile())) {
            return reader.read(zip);
        }
    }

    @FunctionalInterface
    private interface ZipReader<T> {
        T read(ZipFile zip) throws IOException;
    }

    // ---- signature, alignment, size

    @ParameterizedTest
    @ValueSource(strings = {"debug", "release"})
    void signatureHoldsOnAndroid8AndNewer(String variant) throws Exception {
        String text = run(0, "apksigner", "verify", "--verbose", "--min-sdk-version", 26, apk(variant));
        assertTrue(text.contains("Verified using v2 scheme (APK Signature Scheme v2): true"), text);
    }

    /** With another key the next install is no update: Android asks to remove the app and all that it keeps. */
    @Test
    void keyForDebuggingOutlastsAClean() throws IOException {
        Path key = Path.of(System.getProperty("cellgauge.debug.keystore")).toRealPath();
        Path project = Path.of(System.getProperty("cellgauge.root")).toRealPath();
        assertFalse(key.startsWith(project), key + " is in a folder that clean, git or a new copy leave without it");
        assertTrue(Files.size(key) > 0);
    }

    /** The tool does notice: one byte of a file inside is changed. */
    @Test
    void changedApkIsNotAccepted() throws Exception {
        byte[] bytes = Files.readAllBytes(apk("release"));
        bytes[bytes.length / 4] ^= 1;
        Path changed = Files.write(scratch.resolve("changed.apk"), bytes);
        run(1, "apksigner", "verify", "--min-sdk-version", 26, changed);
    }

    @ParameterizedTest
    @ValueSource(strings = {"debug", "release"})
    void storedEntriesAreAligned(String variant) throws Exception {
        run(0, "zipalign", "-c", "-p", 4, apk(variant));
    }

    /** Android 11 and newer refuse to install a compressed table of resources. */
    @ParameterizedTest
    @ValueSource(strings = {"debug", "release"})
    void tableOfResourcesIsStored(String variant) throws IOException {
        int method = inside(variant, zip -> zip.getEntry("resources.arsc").getMethod());
        assertEquals(ZipEntry.STORED, method);
    }

    @Test
    void releaseIsSmall() throws IOException {
        long bytes = Files.size(apk("release"));
        assertTrue(bytes < MAX_RELEASE_BYTES, bytes + " bytes");
    }

    // ---- manifest

    @ParameterizedTest
    @ValueSource(strings = {"debug", "release"})
    void manifestSaysWhatTheAppIs(String variant) throws Exception {
        String text = run(0, "aapt2", "dump", "badging", apk(variant));
        assertEquals(Set.of(PACKAGE), found("^package: name='([^']*)'", text));
        assertEquals(Set.of(System.getProperty("cellgauge.version")),
                found("^package: .* versionName='([^']*)'", text));
        assertEquals(Set.of("26"), found("^sdkVersion:'([^']*)'", text));
        assertEquals(Set.of("36"), found("^targetSdkVersion:'([^']*)'", text));
        assertEquals(Set.of("CellGauge"), found("^application-label:'([^']*)'", text));
        assertEquals(Set.of(PACKAGE + ".screen.MainActivity"), found("^launchable-activity: name='([^']*)'", text));
        assertEquals(variant.equals("debug"), text.contains("\napplication-debuggable\n"), text);
    }

    /** The camera and nothing else, the network least of all; and a tablet without one may still judge saved photos. */
    @ParameterizedTest
    @ValueSource(strings = {"debug", "release"})
    void cameraIsAllThatIsAskedFor(String variant) throws Exception {
        String text = run(0, "aapt2", "dump", "badging", apk(variant));
        assertEquals(Set.of("android.permission.CAMERA"),
                found("^uses-permission(?:-sdk-\\d+)?: name='([^']*)'", text));
        assertTrue(found("^ *uses-feature-not-required: name='([^']*)'", text).contains("android.hardware.camera"),
                text);
        assertFalse(found("^ *uses-feature: name='([^']*)'", text).stream().anyMatch(f -> f.contains("camera")), text);
    }

    /** Nothing leaves the device by itself. */
    @ParameterizedTest
    @ValueSource(strings = {"debug", "release"})
    void resultsGoIntoNoBackup(String variant) throws Exception {
        String text = run(0, "aapt2", "dump", "xmltree", "--file", "AndroidManifest.xml", apk(variant));
        assertEquals(Set.of("false"), found(":allowBackup\\(0x[0-9a-f]+\\)=(\\S+)", text));
        assertFalse(found(":dataExtractionRules\\(0x[0-9a-f]+\\)=(\\S+)", text).isEmpty(), text);
    }

    /** What newer Androids ask an app for: a language of its own, and who has a use for back. */
    @ParameterizedTest
    @ValueSource(strings = {"debug", "release"})
    void languageAndBackAreTheSystems(String variant) throws Exception {
        String text = run(0, "aapt2", "dump", "xmltree", "--file", "AndroidManifest.xml", apk(variant));
        assertEquals(Set.of("true"), found(":enableOnBackInvokedCallback\\(0x[0-9a-f]+\\)=(\\S+)", text));
        assertFalse(found(":localeConfig\\(0x[0-9a-f]+\\)=(\\S+)", text).isEmpty(), text);
    }

    /** Android installs no version over one with a higher code. */
    @ParameterizedTest
    @ValueSource(strings = {"debug", "release"})
    void versionCodeGrowsWithTheVersion(String variant) throws Exception {
        String[] parts = System.getProperty("cellgauge.version").split("[.-]");
        int code = Integer.parseInt(parts[0]) * 10_000 + Integer.parseInt(parts[1]) * 100 + Integer.parseInt(parts[2]);
        assertEquals(Set.of("" + code),
                found("^package: .* versionCode='([^']*)'", run(0, "aapt2", "dump", "badging", apk(variant))));
    }

    // ---- content

    @ParameterizedTest
    @ValueSource(strings = {"debug", "release"})
    void nothingIsInsideThatTheAppDoesNotUse(String variant) throws IOException {
        List<String> known = List.of("AndroidManifest\\.xml", "resources\\.arsc", "res/.+", "assets/.+",
                "classes\\d*\\.dex", "org/cellgauge/.+\\.properties", "boofcv/factory/fiducial/.+\\.txt");
        List<String> strange = inside(variant, zip -> zip.stream().map(ZipEntry::getName)
                .filter(name -> known.stream().noneMatch(name::matches)).collect(Collectors.toList()));
        assertEquals(List.of(), strange);
    }

    @ParameterizedTest
    @ValueSource(strings = {"debug", "release"})
    void whatIsReadAtRunTimeIsInside(String variant) throws IOException {
        List<String> names = new ArrayList<>(List.of("org/cellgauge/version.properties"));
        for (HammingDictionary dictionary : HammingDictionary.allPredefined()) {
            names.add("boofcv/factory/fiducial/" + dictionary.name().toLowerCase(Locale.ROOT) + ".txt");
        }
        assertTrue(names.size() > 10, names.toString());
        inside(variant, zip -> {
            for (String name : names) {
                try (InputStream expected = ApkTest.class.getResourceAsStream("/" + name)) {
                    assertTrue(zip.getEntry(name) != null, name);
                    byte[] found = zip.getInputStream(zip.getEntry(name)).readAllBytes();
                    assertArrayEquals(expected.readAllBytes(), found, name);
                }
            }
            return null;
        });
    }

    /** Names of all libraries that the app is built with, and what they want to be said of them. */
    @ParameterizedTest
    @ValueSource(strings = {"debug", "release"})
    void licencesOfAllLibrariesAreInside(String variant) throws IOException {
        String text = inside(variant, zip -> new String(
                zip.getInputStream(zip.getEntry("assets/licences.txt")).readAllBytes(), StandardCharsets.UTF_8));
        String[] jars = System.getProperty("cellgauge.libraries").split(File.pathSeparator);
        assertTrue(jars.length > 15, jars.length + " libraries");
        for (String jar : jars) {
            String title = new File(jar).getName().replaceAll("-(\\d[^-]*)\\.jar$", " $1");
            assertTrue(text.contains("\n- " + title + " ("), title);
            try (ZipFile zip = new ZipFile(jar)) {
                ZipEntry notice = zip.getEntry("META-INF/NOTICE.txt");
                if (notice != null) {
                    String said = new String(zip.getInputStream(notice).readAllBytes(), StandardCharsets.UTF_8);
                    assertTrue(text.replaceAll("\\s+", " ").contains(said.replaceAll("\\s+", " ").trim()), title);
                }
            }
        }
        assertFalse(text.contains("- picocli "), "the command line's alone");
        assertTrue(text.contains("Version 2.0, January 2004"), "the Apache License");
    }

    /** Android 8 reads dex files of version 038 and older. */
    @ParameterizedTest
    @ValueSource(strings = {"debug", "release"})
    void dexFilesAreOfAVersionThatAndroid8Reads(String variant) throws IOException {
        inside(variant, zip -> {
            for (ZipEntry entry : (Iterable<ZipEntry>) zip.stream().map(e -> (ZipEntry) e)::iterator) {
                if (entry.getName().endsWith(".dex")) {
                    byte[] magic = zip.getInputStream(entry).readNBytes(8);
                    String version = new String(magic, 4, 3, StandardCharsets.US_ASCII);
                    assertTrue(version.compareTo("038") <= 0, entry.getName() + " is of version " + version);
                }
            }
            return null;
        });
    }

    /** What the manifest names must be there under that name, in any of the dex files, and no class twice. */
    @ParameterizedTest
    @ValueSource(strings = {"debug", "release"})
    void componentsOfTheManifestAreClassesInside(String variant) throws Exception {
        Set<String> classes = new HashSet<>();
        List<String> twice = new ArrayList<>();
        Process dexdump = new ProcessBuilder(System.getProperty("cellgauge.tool.dexdump"), apk(variant).toString())
                .redirectError(ProcessBuilder.Redirect.DISCARD).start();
        Pattern descriptor = Pattern.compile(" *Class descriptor *: 'L(.*);'");
        try (BufferedReader lines = dexdump.inputReader(StandardCharsets.ISO_8859_1)) {
            lines.lines().map(descriptor::matcher).filter(Matcher::matches).map(m -> m.group(1).replace('/', '.'))
                    .filter(name -> !classes.add(name)).forEach(twice::add);
        }
        assertEquals(0, dexdump.waitFor());
        assertEquals(List.of(), twice);
        assertTrue(classes.containsAll(components()), components() + " in " + classes.size() + " classes");
        assertFalse(classes.stream().anyMatch(name -> name.startsWith(PACKAGE + ".probe.")), "the probe is for tests");
    }

    /** Full names of the classes that the manifest names, each of which Android constructs by its name. */
    private static Set<String> components() throws Exception {
        DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
        factory.setNamespaceAware(true);
        Element manifest = factory.newDocumentBuilder().parse(new File(System.getProperty("cellgauge.manifest")))
                .getDocumentElement();
        Function<String, String> full = name -> name.startsWith(".") ? PACKAGE + name : name;
        Set<String> names = new TreeSet<>();
        for (String tag : List.of("application", "activity", "service", "provider", "receiver")) {
            NodeList elements = manifest.getElementsByTagName(tag);
            for (int i = 0; i < elements.getLength(); i++) {
                String name = ((Element) elements.item(i)).getAttributeNS(ANDROID, "name");
                if (!name.isEmpty()) {
                    names.add(full.apply(name));
                }
            }
        }
        assertTrue(names.contains(PACKAGE + ".screen.MainActivity"), names.toString());
        return names;
    }
}
