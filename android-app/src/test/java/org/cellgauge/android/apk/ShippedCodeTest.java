package org.cellgauge.android.apk;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import java.util.zip.ZipOutputStream;
import org.apache.commons.math3.util.FastMath;
import org.cellgauge.cli.Main;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.FieldVisitor;
import org.objectweb.asm.MethodTooLargeException;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/**
 * The code that is shipped: the release APK's own dex file, translated back to class files (Debian's enjarify), started
 * as the system starts it, on Android's own framework. What it keeps has the figures of the command line.
 */
class ShippedCodeTest {
    private static final long PATIENCE_S = 300;
    /** Its table of short forms of numbers has 1 for 2 to the power of 52, and for 2 to the power of 24 as a float. */
    private static final String TRANSLATE = "from enjarify.jvm.constants import lookup\n"
            + "lookup.DOUBLES.pop(0x4330000000000000, None)\nlookup.FLOATS.pop(0x4b800000, None)\n"
            + "from enjarify.main import main\nmain()";
    private static final String TABLES = "org/apache/commons/math3/util/FastMathLiteralArrays";

    @TempDir
    private Path folder;

    @Test
    void releaseChecksTheExampleAndKeepsWhatTheCommandLineFinds() throws Exception {
        Path apk = Path.of(System.getProperty("cellgauge.apk.release"));
        Path dex = folder.resolve("classes.dex");
        try (ZipFile zip = new ZipFile(apk.toFile());
                InputStream in = zip.getInputStream(zip.getEntry("classes.dex"))) {
            Files.copy(in, dex);
            assertEquals(null, zip.getEntry("classes2.dex"), "all of the code is in one file");
        }
        Path old = folder.resolve("old.jar");
        String translated = enjarify(dex, old);
        assertTrue(translated.contains(" 0 classes had errors"), translated);
        Path classes = folder.resolve("shipped.jar");
        asJava8(old, classes);

        Path config = Files.createDirectories(folder.resolve("config/com/android/tools"));
        Files.writeString(config.resolve("test_config.properties"), "android_merged_manifest="
                + Path.of(System.getProperty("cellgauge.shipped.manifest")) + "\nandroid_resource_apk=" + apk
                + "\nandroid_custom_package=org.cellgauge.android\n");
        String newest = System.getProperty("robolectric.enabledSdks").replaceFirst(".*,", "");
        Files.writeString(folder.resolve("config/robolectric.properties"), "sdk=" + newest + "\n");
        Path kept = Files.createDirectory(folder.resolve("kept"));
        String classpath = String.join(File.pathSeparator, folder.resolve("config").toString(), classes.toString(),
                System.getProperty("cellgauge.shipped.classpath"));
        List<String> command = new ArrayList<>(List.of(System.getProperty("java.home") + "/bin/java", "-Xmx1g",
                // a dex file has no frames that a verifier could go by
                "-XX:+UnlockDiagnosticVMOptions", "-XX:-BytecodeVerificationRemote",
                "--add-opens=java.base/java.io=ALL-UNNAMED"));
        for (String name : List.of("robolectric.offline", "robolectric.dependency.dir")) {
            command.add("-D" + name + "=" + System.getProperty(name));
        }
        command.addAll(List.of("-Drobolectric.enabledSdks=" + newest, "-cp", classpath,
                "org.cellgauge.android.shipped.ShippedApp", kept.toString()));
        String log = run(command, 0);
        assertTrue(log.contains("classes from [jar:file:" + classes + "!/org/cellgauge/android/screen/"
                + "MainActivity.class]"), log);
        assertMadeAgain(kept);
    }

    private String enjarify(Path dex, Path classes) throws IOException, InterruptedException {
        String said = run(List.of("env", "python3", "-O", "-c", TRANSLATE, "-f", "-o", classes.toString(),
                dex.toString()), null);
        Assumptions.assumeTrue(System.getenv("CI") != null || !said.contains("No module named"), said);
        return said;
    }

    /**
     * What enjarify translates is of Java 5, whose interfaces had no code: the same as of Java 8. One method comes out
     * longer than Java allows: tables of numbers of Apache Commons Math, which are read from its own class instead.
     */
    private static void asJava8(Path from, Path to) throws IOException {
        Map<String, byte[]> classes = new LinkedHashMap<>();
        Set<String> interfaces = new HashSet<>();
        try (ZipFile zip = new ZipFile(from.toFile())) {
            for (ZipEntry entry : Collections.list(zip.entries())) {
                byte[] bytes = zip.getInputStream(entry).readAllBytes();
                ClassReader reader = new ClassReader(bytes);
                if ((reader.getAccess() & Opcodes.ACC_INTERFACE) != 0) {
                    interfaces.add(reader.getClassName());
                }
                classes.put(entry.getName(), bytes);
            }
        }
        try (ZipOutputStream out = new ZipOutputStream(Files.newOutputStream(to))) {
            for (Map.Entry<String, byte[]> of : classes.entrySet()) {
                ClassReader reader = new ClassReader(of.getValue());
                ClassWriter writer = new ClassWriter(reader, 0);
                AsJava8 asJava8 = new AsJava8(writer, interfaces);
                reader.accept(asJava8, 0);
                out.putNextEntry(new ZipEntry(of.getKey()));
                try {
                    byte[] changed = writer.toByteArray();
                    out.write(asJava8.changes ? changed : of.getValue());
                } catch (MethodTooLargeException e) {
                    assertEquals("<clinit>", e.getMethodName());
                    out.write(withTablesOfTheLibrary(reader));
                }
            }
            out.putNextEntry(new ZipEntry(TABLES + ".class"));
            try (InputStream in = FastMath.class.getResourceAsStream("/" + TABLES + ".class")) {
                out.write(in.readAllBytes());
            }
        }
    }

    /** The same class, of which nothing but five tables is made at its start. */
    private static byte[] withTablesOfTheLibrary(ClassReader of) {
        Set<String> set = new HashSet<>();
        ClassWriter writer = new ClassWriter(0);
        of.accept(new ClassVisitor(Opcodes.ASM9, writer) {
            @Override
            public FieldVisitor visitField(int access, String name, String type, String signature, Object value) {
                if ((access & Opcodes.ACC_STATIC) != 0 && value == null) {
                    set.add(name);
                }
                return super.visitField(access, name, type, signature, value);
            }

            @Override
            public MethodVisitor visitMethod(int access, String name, String type, String signature, String[] thrown) {
                return name.equals("<clinit>") ? null : super.visitMethod(access, name, type, signature, thrown);
            }
        }, 0);
        Map<String, String> tables = Map.of("EXP_INT_A", "ExpIntA", "EXP_INT_B", "ExpIntB", "EXP_FRAC_A", "ExpFracA",
                "EXP_FRAC_B", "ExpFracB", "LN_MANT", "LnMant");
        assertEquals(tables.keySet(), set, of.getClassName());
        MethodVisitor method = writer.visitMethod(Opcodes.ACC_STATIC, "<clinit>", "()V", null, null);
        method.visitCode();
        tables.forEach((field, name) -> {
            String type = field.equals("LN_MANT") ? "[[D" : "[D";
            method.visitMethodInsn(Opcodes.INVOKESTATIC, TABLES, "load" + name, "()" + type, false);
            method.visitFieldInsn(Opcodes.PUTSTATIC, of.getClassName(), field, type);
        });
        method.visitInsn(Opcodes.RETURN);
        method.visitMaxs(1, 0);
        method.visitEnd();
        return writer.toByteArray();
    }

    /** Calls of methods that stand in interfaces are marked as such since Java 8. */
    private static final class AsJava8 extends ClassVisitor {
        private final Set<String> interfaces;
        private boolean changes;

        AsJava8(ClassVisitor next, Set<String> interfaces) {
            super(Opcodes.ASM9, next);
            this.interfaces = interfaces;
        }

        @Override
        public void visit(int version, int access, String name, String signature, String above, String[] shared) {
            changes = (access & Opcodes.ACC_INTERFACE) != 0;
            super.visit(Opcodes.V1_8, access, name, signature, above, shared);
        }

        @Override
        public MethodVisitor visitMethod(int access, String name, String type, String signature, String[] thrown) {
            return new MethodVisitor(Opcodes.ASM9, super.visitMethod(access, name, type, signature, thrown)) {
                @Override
                public void visitMethodInsn(int opcode, String owner, String called, String of, boolean marked) {
                    boolean mark = marked || isInterface(owner);
                    changes |= mark != marked;
                    super.visitMethodInsn(opcode, owner, called, of, mark);
                }
            };
        }

        private boolean isInterface(String owner) {
            if (interfaces.contains(owner)) {
                return true;
            }
            try {
                return owner.startsWith("java/") && Class.forName(owner.replace('/', '.')).isInterface();
            } catch (ClassNotFoundException e) {
                return false;       // of Android alone
            }
        }
    }

    /** What a command prints; it ends in time, and with this exit code where one is given. */
    private String run(List<String> command, Integer code) throws IOException, InterruptedException {
        Path said = Files.createTempFile(folder, "said", ".txt");
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(said.toFile());
        // Debian's package is written for Debian's own Python
        builder.environment().merge("PATH", "/usr/bin:/bin", (path, first) -> first + ":" + path);
        Process process = builder.start();
        boolean ended = process.waitFor(PATIENCE_S, TimeUnit.SECONDS);
        process.destroyForcibly();
        String log = Files.readString(said);
        assertTrue(ended, log);
        assertTrue(code == null || process.exitValue() == code, log);
        return log;
    }

    private void assertMadeAgain(Path kept) throws IOException {
        Path cell;
        try (Stream<Path> files = Files.list(kept)) {
            cell = files.filter(f -> f.toString().endsWith(".cell.yaml")).findFirst().orElseThrow();
        }
        String name = cell.getFileName().toString().replace(".cell.yaml", "");
        String text = Files.readString(cell);
        int begin = text.indexOf("# cellgauge ");
        String command = text.substring(begin + 12, text.indexOf('\n', begin));
        List<String> words = new ArrayList<>();
        Arrays.stream(command.split(" ")).forEach(w -> words.add(w.startsWith(name) ? kept.resolve(w).toString() : w));
        words.addAll(List.of("--out", folder.resolve("out").toString()));
        StringWriter said = new StringWriter();
        Main.commandLine().setOut(new PrintWriter(said)).setErr(new PrintWriter(said))
                .execute(words.toArray(new String[0]));
        JsonObject theirs = json(folder.resolve("out").resolve(name + ".result.json"), said.toString());
        JsonObject ours = json(kept.resolve(name + ".result.json"), "kept");
        assertEquals("pass", ours.get("verdict").getAsString());
        for (String key : List.of("version", "date", "command", "plan")) {
            theirs.remove(key);
            ours.remove(key);
        }
        List<String> differing = new ArrayList<>();
        // counted, so that what is compared is known to be a result and not a stump of one
        int values = compare("", theirs, ours, differing);
        assertEquals(List.of(), differing);
        assertTrue(values > 1000, "values: " + values);
    }

    private static int compare(String at, JsonElement expected, JsonElement found, List<String> differing) {
        int values = 0;
        if (expected.isJsonObject() && found.isJsonObject()
                && expected.getAsJsonObject().keySet().equals(found.getAsJsonObject().keySet())) {
            for (String key : expected.getAsJsonObject().keySet()) {
                values += compare(at + "." + key, expected.getAsJsonObject().get(key),
                        found.getAsJsonObject().get(key), differing);
            }
        } else if (expected.isJsonArray() && found.isJsonArray()
                && expected.getAsJsonArray().size() == found.getAsJsonArray().size()) {
            for (int i = 0; i < expected.getAsJsonArray().size(); i++) {
                values += compare(at + "[" + i + "]", expected.getAsJsonArray().get(i),
                        found.getAsJsonArray().get(i), differing);
            }
        } else {
            values++;
            if (!expected.equals(found)) {
                differing.add(at + ": " + found + " for " + expected);
            }
        }
        return values;
    }

    private static JsonObject json(Path file, String log) throws IOException {
        assertTrue(Files.exists(file), log);
        return JsonParser.parseString(Files.readString(file)).getAsJsonObject();
    }
}
