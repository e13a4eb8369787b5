package org.cellgauge;

import java.io.File;
import java.io.IOException;
import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.Type;
import java.lang.reflect.WildcardType;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;

/**
 * What users of the library compile against, as text: the public types that are in no package called {@code internal},
 * with their public and protected members, then the names of types of other libraries, and of internal ones, that these
 * mention.
 */
final class ApiListing {
    private static final String BASE = "org.cellgauge.";

    private ApiListing() {
    }

    /**
     * Writes the listing.
     *
     * @param args the file to write, and the folder of the library's class files
     */
    public static void main(String... args) throws Exception {
        Files.writeString(Path.of(args[0]), text(typesForUsers(Path.of(args[1]))), StandardCharsets.UTF_8);
    }

    /** The public types among the class files of a folder that are in no package called {@code internal}, by name. */
    static List<Class<?>> typesForUsers(Path classes) throws IOException, ClassNotFoundException {
        List<String> names;
        try (Stream<Path> files = Files.walk(classes)) {
            names = files.map(file -> classes.relativize(file).toString().replace(File.separatorChar, '.'))
                    .filter(name -> name.endsWith(".class") && !name.contains("$") && !name.contains(".internal."))
                    .map(name -> name.substring(0, name.length() - ".class".length()))
                    .filter(name -> !name.endsWith("package-info"))
                    .sorted().toList();
        }
        List<Class<?>> types = new ArrayList<>();
        for (String name : names) {
            Class<?> type = Class.forName(name, false, ApiListing.class.getClassLoader());
            if (visible(type.getModifiers())) {
                types.add(type);
            }
        }
        return types;
    }

    static String text(List<Class<?>> types) {
        Set<Class<?>> listed = new LinkedHashSet<>();
        Deque<Class<?>> open = new ArrayDeque<>(types);
        while (!open.isEmpty()) {
            Class<?> type = open.remove();
            listed.add(type);
            Arrays.stream(type.getDeclaredClasses()).filter(nested -> visible(nested.getModifiers()))
                    .sorted((a, b) -> a.getName().compareTo(b.getName())).forEach(open::addFirst);
        }
        StringBuilder text = new StringBuilder();
        Set<Class<?>> mentioned = new LinkedHashSet<>();
        for (Class<?> type : listed) {
            text.append(header(type, mentioned)).append('\n');
            for (String member : members(type, mentioned)) {
                text.append("    ").append(member).append('\n');
            }
            text.append('\n');
        }
        mentioned.removeAll(listed);
        Set<String> others = new TreeSet<>();
        for (Class<?> type : mentioned) {
            others.add(shortened(type.getName()));
        }
        text.append("mentioned above\n");
        others.forEach(name -> text.append("    ").append(name).append('\n'));
        return text.toString();
    }

    private static boolean visible(int modifiers) {
        return Modifier.isPublic(modifiers) || Modifier.isProtected(modifiers);
    }

    /** What takes an internal type is the library's own: users have none to give. */
    private static boolean isForUsers(Executable member) {
        Set<Class<?>> taken = new LinkedHashSet<>();
        Arrays.stream(member.getGenericParameterTypes()).forEach(each -> collect(each, taken));
        return visible(member.getModifiers()) && !member.isSynthetic()
                && taken.stream().noneMatch(type -> type.getName().contains(".internal."));
    }

    private static String header(Class<?> type, Set<Class<?>> mentioned) {
        StringBuilder header = new StringBuilder(type.toGenericString());
        if (type.getGenericSuperclass() != null && type.getSuperclass() != Object.class && !type.isEnum()) {
            header.append(" extends ").append(type.getGenericSuperclass().getTypeName());
            collect(type.getGenericSuperclass(), mentioned);
        }
        for (Type above : type.getGenericInterfaces()) {
            header.append(type.isInterface() ? " extends " : " implements ").append(above.getTypeName());
            collect(above, mentioned);
        }
        return shortened(header.toString());
    }

    private static List<String> members(Class<?> type, Set<Class<?>> mentioned) {
        List<String> members = new ArrayList<>();
        for (Field field : type.getDeclaredFields()) {
            if (visible(field.getModifiers()) && !field.isSynthetic()) {
                members.add("field " + field.toGenericString()
                        .replace(type.getName() + "." + field.getName(), field.getName()) + value(field));
                collect(field.getGenericType(), mentioned);
            }
        }
        for (Constructor<?> constructor : type.getDeclaredConstructors()) {
            if (isForUsers(constructor)) {
                members.add("new " + constructor.toGenericString());
                Arrays.stream(constructor.getGenericParameterTypes()).forEach(each -> collect(each, mentioned));
            }
        }
        for (Method method : type.getDeclaredMethods()) {
            if (isForUsers(method)) {
                members.add(method.toGenericString()
                        .replace(type.getName() + "." + method.getName(), method.getName()));
                collect(method.getGenericReturnType(), mentioned);
                Arrays.stream(method.getGenericParameterTypes()).forEach(each -> collect(each, mentioned));
            }
        }
        members.replaceAll(ApiListing::shortened);
        Collections.sort(members);
        return members;
    }

    /** A constant of a simple type is compiled into its users: another value breaks them as another name would. */
    private static String value(Field field) {
        int modifiers = field.getModifiers();
        boolean simple = field.getType().isPrimitive() || field.getType() == String.class;
        if (!simple || !Modifier.isStatic(modifiers) || !Modifier.isFinal(modifiers) || !Modifier.isPublic(modifiers)) {
            return "";
        }
        try {
            return " = " + field.get(null);
        } catch (IllegalAccessException e) {
            throw new IllegalStateException(field.toString(), e);
        }
    }

    private static void collect(Type type, Set<Class<?>> mentioned) {
        if (type instanceof Class) {
            Class<?> single = (Class<?>) type;
            while (single.isArray()) {
                single = single.getComponentType();
            }
            if (!single.isPrimitive() && !single.getName().startsWith("java.")) {
                mentioned.add(single);
            }
        } else if (type instanceof ParameterizedType) {
            collect(((ParameterizedType) type).getRawType(), mentioned);
            Arrays.stream(((ParameterizedType) type).getActualTypeArguments())
                    .forEach(each -> collect(each, mentioned));
        } else if (type instanceof WildcardType) {
            Arrays.stream(((WildcardType) type).getUpperBounds()).forEach(each -> collect(each, mentioned));
        }
    }

    private static String shortened(String text) {
        return text.replace(BASE, "").replaceAll("\\bjava\\.(lang|util)\\.(?=[A-Z])", "");
    }
}
