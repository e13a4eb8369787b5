package org.cellgauge.pack;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Enumeration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import java.util.zip.ZipOutputStream;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.Handle;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/**
 * Makes each lambda and method reference of a jar a class of its own, as compilers for Android do.
 *
 * <p>Java links each place that makes one when it gets there for the first time, by interpreted code, even where the
 * class behind it is in an archive of classes: 200 such places are 5 % of a first {@code check}. A class from the
 * archive is there at once.
 *
 * <p>Classes of files older than Java 11's stay as they are, since only from then on nest mates may call private
 * methods; and so do lambdas that are serialisable or have marker interfaces.
 */
public final class PlainLambdas {
    private static final String CLASS = ".class";
    private static final String FACTORY = "java/lang/invoke/LambdaMetafactory";
    private static final int OLDEST = Opcodes.V11;
    private static final int MAJOR = 0xffff;
    private static final int API = Opcodes.ASM9;

    /** Class files by their names in the jar; other files among them. */
    private final Map<String, byte[]> files = new LinkedHashMap<>();
    private final Map<String, byte[]> made = new TreeMap<>();
    private final Map<String, List<String>> nests = new TreeMap<>();

    private PlainLambdas(Map<String, byte[]> files) {
        this.files.putAll(files);
    }

    /**
     * Writes jars anew.
     *
     * @param args an existing folder, and the jars, each of which gets one of the same name there
     * @throws IOException if one cannot be read or written
     */
    public static void main(String[] args) throws IOException {
        Path folder = Path.of(args[0]);
        for (int i = 1; i < args.length; i++) {
            Path jar = Path.of(args[i]);
            convert(jar, folder.resolve(jar.getFileName()));
        }
    }

    /**
     * Writes one jar anew: the same files in the same order, then the classes that were lambdas; the same jar gives the
     * same bytes.
     *
     * @param jar the jar
     * @param into the new one
     * @throws IOException if one cannot be read or the other not written
     */
    static void convert(Path jar, Path into) throws IOException {
        Map<String, byte[]> files = new LinkedHashMap<>();
        Map<String, Long> times = new LinkedHashMap<>();
        try (ZipFile zip = new ZipFile(jar.toFile())) {
            for (Enumeration<? extends ZipEntry> entries = zip.entries(); entries.hasMoreElements();) {
                ZipEntry entry = entries.nextElement();
                try (InputStream in = zip.getInputStream(entry)) {
                    files.put(entry.getName(), in.readAllBytes());
                }
                times.put(entry.getName(), entry.getTime());
            }
        }
        long first = times.values().iterator().next();
        try (OutputStream file = Files.newOutputStream(into); ZipOutputStream out = new ZipOutputStream(file)) {
            for (Map.Entry<String, byte[]> each : converted(files).entrySet()) {
                ZipEntry entry = new ZipEntry(each.getKey());
                entry.setTime(times.getOrDefault(each.getKey(), first));
                out.putNextEntry(entry);
                out.write(each.getValue());
                out.closeEntry();
            }
        }
    }

    /**
     * The same for files of a jar.
     *
     * @param files by their names
     * @return the same files, classes without lambdas, and after them the classes that these have become
     */
    static Map<String, byte[]> converted(Map<String, byte[]> files) {
        PlainLambdas all = new PlainLambdas(files);
        files.forEach((name, content) -> {
            if (name.endsWith(CLASS) && isNewEnough(content)) {
                all.files.put(name, all.converted(content));
            }
        });
        all.nests.forEach((host, members) ->
                all.files.computeIfPresent(host + CLASS, (name, content) -> withNestMembers(content, members)));
        all.files.putAll(all.made);
        return all.files;
    }

    private static boolean isNewEnough(byte[] classFile) {
        return (new ClassReader(classFile).readInt(4) & MAJOR) >= OLDEST;
    }

    private byte[] converted(byte[] classFile) {
        ClassWriter out = new ClassWriter(0);
        Converter converter = new Converter(out);
        new ClassReader(classFile).accept(converter, 0);
        return converter.lambdas == 0 ? classFile : out.toByteArray();
    }

    private static byte[] withNestMembers(byte[] classFile, List<String> members) {
        ClassWriter out = new ClassWriter(0);
        new ClassReader(classFile).accept(new ClassVisitor(API, out) {
            @Override
            public void visitEnd() {
                members.forEach(this::visitNestMember);
                super.visitEnd();
            }
        }, 0);
        return out.toByteArray();
    }

    /** Takes one class's lambdas out of it. */
    private final class Converter extends ClassVisitor {
        private int version;
        private String name = "";
        private String host = "";
        private int lambdas;

        Converter(ClassWriter out) {
            super(API, out);
        }

        @Override
        public void visit(int version, int access, String name, String signature, String superName,
                String[] interfaces) {
            this.version = version;
            this.name = name;
            this.host = name;
            super.visit(version, access, name, signature, superName, interfaces);
        }

        @Override
        public void visitNestHost(String host) {
            this.host = host;
            super.visitNestHost(host);
        }

        @Override
        public MethodVisitor visitMethod(int access, String method, String descriptor, String signature,
                String[] exceptions) {
            return new MethodVisitor(API, super.visitMethod(access, method, descriptor, signature, exceptions)) {
                @Override
                public void visitInvokeDynamicInsn(String name, String descriptor, Handle bootstrap,
                        Object... arguments) {
                    if (bootstrap.getOwner().equals(FACTORY) && bootstrap.getName().equals("metafactory")) {
                        site(name, descriptor, arguments).call(mv);
                    } else {
                        super.visitInvokeDynamicInsn(name, descriptor, bootstrap, arguments);
                    }
                }
            };
        }

        private LambdaSite site(String method, String descriptor, Object... arguments) {
            String lambda = name + "$$Lambda" + lambdas++;
            LambdaSite site = new LambdaSite(lambda, method, descriptor, arguments);
            made.put(lambda + CLASS, site.classFile(version, host));
            nests.computeIfAbsent(host, each -> new ArrayList<>()).add(lambda);
            return site;
        }
    }
}
