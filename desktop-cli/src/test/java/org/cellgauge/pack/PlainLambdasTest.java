package org.cellgauge.pack;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.jar.JarFile;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.Handle;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/** Lambdas as classes of their own do what lambdas do. */
class PlainLambdasTest {
    private static final String PACKAGE = "org/cellgauge/";
    private static final String CLASS = ".class";

    /** Of all files of a jar; an even second, since jars know no others. */
    private static final long TIME_MS = 1_000_000_000_000L;

    @TempDir
    private Path folder;

    @Test
    void allKindsGiveWhatLambdasGive() throws ReflectiveOperationException, IOException {
        Map<String, byte[]> kinds = kinds();

        Map<String, byte[]> converted = PlainLambdas.converted(kinds);

        assertTrue(converted.size() >= kinds.size() + 30, converted.keySet().toString());
        List<String> expected = new LambdaKinds().get();
        assertEquals(expected, results(converted));
        assertEquals(Set.of("altMetafactory"), metafactories(converted));
        assertEquals(Set.of("altMetafactory", "metafactory"), metafactories(kinds));
    }

    /** The classes of ours that this test runs with, libraries and command line: each passes Java's verifier. */
    @Test
    void everyClassOfOursIsValid() throws IOException, ReflectiveOperationException {
        Map<String, byte[]> own = own();
        assertTrue(own.containsKey("org/cellgauge/cli/Main.class"));
        assertTrue(own.containsKey("org/cellgauge/geometry/PinholeCamera.class"));

        Map<String, byte[]> converted = PlainLambdas.converted(own);

        ClassLoader loader = new Loader(converted);
        int lambdas = 0;
        for (String name : converted.keySet()) {
            Class<?> each = Class.forName(name.substring(0, name.length() - CLASS.length()).replace('/', '.'), false,
                    loader);
            // which links the class, and so verifies it
            each.getDeclaredMethods();
            lambdas += own.containsKey(name) ? 0 : 1;
            // one whose host does not know it is its own host
            assertFalse(!own.containsKey(name) && each == each.getNestHost(), name);
        }
        assertTrue(lambdas > 800, lambdas + " lambdas");
    }

    @Test
    void jarKeepsItsFilesInOrderAndComesOutTheSameTwice() throws IOException {
        Path jar = folder.resolve("some.jar");
        byte[] text = "no class".getBytes(StandardCharsets.UTF_8);
        try (OutputStream file = Files.newOutputStream(jar); ZipOutputStream out = new ZipOutputStream(file)) {
            put(out, JarFile.MANIFEST_NAME, "Manifest-Version: 1.0\r\n\r\n".getBytes(StandardCharsets.UTF_8));
            put(out, "z.txt", text);
            for (Map.Entry<String, byte[]> each : kinds().entrySet()) {
                put(out, each.getKey(), each.getValue());
            }
            put(out, "a.txt", text);
        }

        Path first = Files.createDirectory(folder.resolve("first"));
        Path second = Files.createDirectory(folder.resolve("second"));
        PlainLambdas.main(new String[] {first.toString(), jar.toString()});
        PlainLambdas.main(new String[] {second.toString(), jar.toString()});

        byte[] written = Files.readAllBytes(first.resolve("some.jar"));
        assertArrayEquals(written, Files.readAllBytes(second.resolve("some.jar")));
        List<String> before = names(jar);
        List<String> after = names(first.resolve("some.jar"));
        assertEquals(before, after.subList(0, before.size()));
        assertTrue(after.size() > before.size());
        try (JarFile in = new JarFile(first.resolve("some.jar").toFile());
                InputStream content = in.getInputStream(in.getEntry("z.txt"))) {
            assertArrayEquals(text, content.readAllBytes());
            // of those that are made as well, so that the day of packing does not show
            assertEquals(Set.of(TIME_MS), in.stream().map(ZipEntry::getTime).collect(Collectors.toSet()));
        }
    }

    private static void put(ZipOutputStream out, String name, byte[] content) throws IOException {
        ZipEntry entry = new ZipEntry(name);
        entry.setTime(TIME_MS);
        out.putNextEntry(entry);
        out.write(content);
    }

    private static List<String> names(Path jar) throws IOException {
        try (JarFile in = new JarFile(jar.toFile())) {
            return in.stream().map(ZipEntry::getName).toList();
        }
    }

    private static List<String> results(Map<String, byte[]> classes) throws ReflectiveOperationException {
        Class<?> kinds = Class.forName(LambdaKinds.class.getName(), true, new Loader(classes));
        @SuppressWarnings("unchecked")
        Supplier<List<String>> made = (Supplier<List<String>>) kinds.getConstructor().newInstance();
        assertFalse(made instanceof LambdaKinds, "not the converted class");
        return made.get();
    }

    /** Which methods of Java's factory of lambdas are still called for. */
    private static Set<String> metafactories(Map<String, byte[]> classes) {
        Set<String> found = new HashSet<>();
        classes.values().forEach(content -> new ClassReader(content).accept(new ClassVisitor(Opcodes.ASM9) {
            @Override
            public MethodVisitor visitMethod(int access, String name, String descriptor, String signature,
                    String[] exceptions) {
                return new MethodVisitor(Opcodes.ASM9) {
                    @Override
                    public void visitInvokeDynamicInsn(String name, String descriptor, Handle bootstrap,
                            Object... arguments) {
                        if (bootstrap.getOwner().endsWith("LambdaMetafactory")) {
                            found.add(bootstrap.getName());
                        }
                    }
                };
            }
        }, 0));
        return found;
    }

    private static Map<String, byte[]> kinds() throws IOException {
        Map<String, byte[]> kinds = new TreeMap<>();
        for (Map.Entry<String, byte[]> each : own().entrySet()) {
            if (each.getKey().contains("/LambdaKinds")) {
                kinds.put(each.getKey(), each.getValue());
            }
        }
        assertTrue(kinds.size() >= 5, kinds.keySet().toString());
        return kinds;
    }

    /** All classes of ours on the class path. */
    private static Map<String, byte[]> own() throws IOException {
        Map<String, byte[]> own = new TreeMap<>();
        for (String part : System.getProperty("java.class.path").split(File.pathSeparator)) {
            Path path = Path.of(part);
            if (Files.isDirectory(path)) {
                try (Stream<Path> found = Files.walk(path)) {
                    for (Path each : found.filter(Files::isRegularFile).toList()) {
                        add(own, path.relativize(each).toString().replace(File.separatorChar, '/'),
                                Files.readAllBytes(each));
                    }
                }
            } else if (Files.isRegularFile(path)) {
                try (JarFile jar = new JarFile(path.toFile())) {
                    for (ZipEntry entry : jar.stream().toList()) {
                        if (entry.getName().startsWith(PACKAGE)) {
                            try (InputStream in = jar.getInputStream(entry)) {
                                add(own, entry.getName(), in.readAllBytes());
                            }
                        }
                    }
                }
            }
        }
        return own;
    }

    private static void add(Map<String, byte[]> own, String name, byte[] content) {
        if (name.startsWith(PACKAGE) && name.endsWith(CLASS)) {
            own.put(name, content);
        }
    }

    /** Has these classes itself, and all others from where the test has them. */
    private static final class Loader extends ClassLoader {
        private final Map<String, byte[]> classes;

        Loader(Map<String, byte[]> classes) {
            super(PlainLambdasTest.class.getClassLoader());
            this.classes = classes;
        }

        @Override
        protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
            byte[] content = classes.get(name.replace('.', '/') + CLASS);
            synchronized (getClassLoadingLock(name)) {
                Class<?> known = findLoadedClass(name);
                if (known != null) {
                    return known;
                }
                return content == null ? super.loadClass(name, resolve)
                        : defineClass(name, content, 0, content.length);
            }
        }
    }
}
