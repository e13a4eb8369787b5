package org.cellgauge.desktop;

import java.io.IOException;
import java.nio.file.DirectoryIteratorException;
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
    private static final Pattern RESULTS = Pattern.compile("(?s).*\\.(overlay\\.png|result\\.json|chain-\\d+\\.csv)"
            + "|report(-\\d{3,9})?\\.html|summary\\.csv");
    private static final Set<String> BESIDE_PHOTOS = Set.of("yaml", "yml", "json", "txt", "md", "csv", "pdf");
    private static final int MOST_NAMED = 5;

    /**
     * Inputs of a run.
     *
     * @param inputs in the order given, folders replaced by the images in them, sorted by name
     * @param isBatch whether a folder or more than one file was named
     * @param remarks what the user should know about names, and about what folders have besides photos
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
        List<String> remarks = new ArrayList<>();
        boolean batch = images.size() + detections.size() > 1;
        for (Path image : images) {
            if (Files.isDirectory(image)) {
                batch = true;
                addFolder(image, found, remarks);
            } else {
                found.add(new CheckInput(image, false, baseName(image), null));
            }
        }
        for (Path file : detections) {
            found.add(new CheckInput(file, true, baseName(file), null));
        }
        return new Inputs(distinctNames(withoutRepeats(found, remarks), remarks), batch, remarks);
    }

    private static void addFolder(Path folder, List<CheckInput> found, List<String> remarks) {
        List<Path> photos = new ArrayList<>();
        List<String> folders = new ArrayList<>();
        List<String> others = new ArrayList<>();
        try (DirectoryStream<Path> entries = Files.newDirectoryStream(folder)) {
            for (Path entry : entries) {
                String name = entry.getFileName().toString();
                if (name.startsWith(".") || isResult(name)) {
                    continue;
                }
                boolean toNowhere = Files.isSymbolicLink(entry) && !Files.exists(entry);
                if (Files.isDirectory(entry)) {
                    folders.add(name);
                } else if (isPhoto(name) && (toNowhere || Files.isRegularFile(entry))) {
                    // a link that leads nowhere is refused: a photo is missing
                    photos.add(entry);
                } else if (toNowhere || !isOfPhotos(name)) {
                    others.add(name + (toNowhere ? " (a link that leads nowhere)" : ""));
                }
            }
        } catch (IOException | DirectoryIteratorException e) {
            found.add(new CheckInput(folder, false, baseName(folder), FolderRefusal.FOLDER_NOT_READ));
            return;
        }
        if (photos.isEmpty()) {
            found.add(new CheckInput(folder, false, baseName(folder), FolderRefusal.NO_IMAGE_IN_FOLDER));
        }
        remark(folder, folders, "a folder within it is not searched", "folders within it are not searched", remarks);
        remark(folder, others, "not read, since no photo by its name",
                "files are not read, since no photos by their names", remarks);
        photos.sort(Comparator.comparing((Path file) -> countable(file.getFileName().toString()))
                .thenComparing(Comparator.naturalOrder()));
        photos.forEach(file -> found.add(new CheckInput(file, false, baseName(file), missing(file))));
    }

    /** Says what was passed over: some by name, all by number. */
    private static void remark(Path folder, List<String> names, String one, String several, List<String> remarks) {
        if (names.isEmpty()) {
            return;
        }
        names.sort(Comparator.naturalOrder());
        int more = names.size() - MOST_NAMED;
        remarks.add(folder + ": " + (names.size() == 1 ? one : names.size() + " " + several) + ": "
                + String.join(", ", names.subList(0, Math.min(names.size(), MOST_NAMED)))
                + (more > 0 ? " and " + more + " more" : ""));
    }

    private static RefusalKind missing(Path file) {
        return Files.isSymbolicLink(file) && !Files.exists(file) ? FolderRefusal.LINK_TO_NOWHERE : null;
    }

    /** A name in which numbers sort by their value: photo-2 before photo-10. */
    private static String countable(String name) {
        return NUMBER.matcher(name).replaceAll(m -> "0".repeat(Math.max(0, 20 - m.group().length())) + m.group());
    }

    /** What runs write: overlays are pictures too, and a second run over a folder of results must not check them. */
    private static boolean isResult(String name) {
        return RESULTS.matcher(name).matches();
    }

    private static boolean isPhoto(String name) {
        return ImageFormat.ENDINGS.contains(ending(name));
    }

    /** What often lies beside photos and is known to be none: cell, camera, truth, corners, notes. */
    private static boolean isOfPhotos(String name) {
        return BESIDE_PHOTOS.contains(ending(name));
    }

    private static String ending(String name) {
        return name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
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
