package org.cellgauge.desktop;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Pattern;
import org.cellgauge.warning.RefusalKind;

/**
 * One photo or detections file to check.
 *
 * @param file as named by the user
 * @param isDetections whether it holds corners rather than a picture
 * @param name what its results are called: the base name without its ending, with a number where another has it already
 * @param refusal why there is nothing to check here; null where there is a file to try
 */
public record CheckInput(Path file, boolean isDetections, String name, RefusalKind refusal) {
    private static final Pattern NUMBER = Pattern.compile("\\d+");

    /**
     * Inputs of a run.
     *
     * @param inputs in the order given, folders replaced by the images in them, sorted by name
     * @param isBatch whether a folder or more than one file was named
     * @param remarks what the user should know about names
     */
    public record Inputs(List<CheckInput> inputs, boolean isBatch, List<String> remarks) {
    }

    /**
     * Finds the files behind the arguments and gives each a name of its own.
     *
     * @param images image files and folders of them
     * @param detections detections files
     * @return what to check, in this order
     */
    public static Inputs resolve(List<Path> images, List<Path> detections) {
        List<CheckInput> found = new ArrayList<>();
        boolean batch = images.size() + detections.size() > 1;
        for (Path image : images) {
            if (Files.isDirectory(image)) {
                batch = true;
                addFolder(image, found);
            } else {
                found.add(new CheckInput(image, false, baseName(image), null));
            }
        }
        for (Path file : detections) {
            found.add(new CheckInput(file, true, baseName(file), null));
        }
        List<String> remarks = new ArrayList<>();
        return new Inputs(distinctNames(withoutRepeats(found, remarks), remarks), batch, remarks);
    }

    private static void addFolder(Path folder, List<CheckInput> found) {
        List<Path> files = new ArrayList<>();
        try (DirectoryStream<Path> entries = Files.newDirectoryStream(folder, CheckInput::isPhoto)) {
            entries.forEach(files::add);
        } catch (IOException e) {
            found.add(new CheckInput(folder, false, baseName(folder), FolderRefusal.FOLDER_NOT_READ));
            return;
        }
        if (files.isEmpty()) {
            found.add(new CheckInput(folder, false, baseName(folder), FolderRefusal.NO_IMAGE_IN_FOLDER));
        }
        files.sort(Comparator.comparing((Path file) -> countable(file.getFileName().toString()))
                .thenComparing(Comparator.naturalOrder()));
        files.forEach(file -> found.add(new CheckInput(file, false, baseName(file), null)));
    }

    /** A name in which numbers sort by their value: photo-2 before photo-10. */
    private static String countable(String name) {
        return NUMBER.matcher(name).replaceAll(m -> "0".repeat(Math.max(0, 20 - m.group().length())) + m.group());
    }

    /** Overlays are pictures too, but our own: a second run over a folder of results must not check them. */
    private static boolean isPhoto(Path file) {
        String name = file.getFileName().toString().toLowerCase(Locale.ROOT);
        return !name.startsWith(".") && !name.endsWith(".overlay.png") && Files.isRegularFile(file)
                && ImageFormat.ENDINGS.contains(name.substring(name.lastIndexOf('.') + 1));
    }

    /**
     * What result files of a photo or detections file are named after.
     *
     * @param file the input
     * @return its name without folder and last ending; {@code input} where nothing is left of it
     */
    public static String baseName(Path file) {
        Path last = file.getFileName();
        String name = last == null ? "" : last.toString();
        int dot = name.lastIndexOf('.');
        String base = dot > 0 ? name.substring(0, dot) : name;
        return base.isEmpty() || base.equals(".") || base.equals("..") ? "input" : base;
    }

    private static List<CheckInput> withoutRepeats(List<CheckInput> all, List<String> remarks) {
        Set<Path> seen = new HashSet<>();
        List<CheckInput> once = new ArrayList<>();
        for (CheckInput input : all) {
            Path real;
            try {
                real = input.file.toRealPath();
            } catch (IOException e) {
                real = input.file.toAbsolutePath().normalize();
            }
            if (seen.add(real)) {
                once.add(input);
            } else {
                remarks.add(input.file + " is named twice and checked once");
            }
        }
        return once;
    }

    /** The first of each name keeps it; later ones get the next number that is free. Case does not tell names apart. */
    private static List<CheckInput> distinctNames(List<CheckInput> inputs, List<String> remarks) {
        Set<String> taken = new HashSet<>();
        boolean[] keeps = new boolean[inputs.size()];
        for (int i = 0; i < keeps.length; i++) {
            keeps[i] = taken.add(inputs.get(i).name.toLowerCase(Locale.ROOT));
        }
        List<CheckInput> named = new ArrayList<>();
        for (int i = 0; i < keeps.length; i++) {
            CheckInput input = inputs.get(i);
            if (keeps[i]) {
                named.add(input);
                continue;
            }
            int number = 2;
            while (!taken.add((input.name + "-" + number).toLowerCase(Locale.ROOT))) {
                number++;
            }
            String name = input.name + "-" + number;
            remarks.add("results of " + input.file + " are called " + name + ", because " + input.name + " is taken");
            named.add(new CheckInput(input.file, input.isDetections, name, input.refusal));
        }
        return named;
    }
}
