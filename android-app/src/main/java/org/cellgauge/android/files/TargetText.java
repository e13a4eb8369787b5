package org.cellgauge.android.files;

import java.util.HashMap;
import java.util.Map;
import java.util.TreeMap;
import org.cellgauge.cell.Requirement;
import org.cellgauge.cell.Target;

/** A target as a line of text that outlives its process: numbers to the last bit, infinite where nothing is asked. */
public final class TargetText {
    private static final String BETWEEN_OBJECTS = ";";
    private static final String BETWEEN_NUMBERS = " ";
    private static final int NUMBERS = 9;

    private TargetText() {
    }

    /**
     * Writes a target.
     *
     * @param target what is asked of the objects
     * @return nine numbers of what is asked of all, and after each semicolon an object's id and its own nine
     */
    public static String of(Target target) {
        StringBuilder text = new StringBuilder();
        append(target.general(), text);
        for (Map.Entry<Integer, Requirement> own : new TreeMap<>(target.own()).entrySet()) {
            text.append(BETWEEN_OBJECTS).append(own.getKey()).append(BETWEEN_NUMBERS);
            append(own.getValue(), text);
        }
        return text.toString();
    }

    private static void append(Requirement r, StringBuilder text) {
        double[] numbers = {r.stdMm().x(), r.stdMm().y(), r.stdMm().z(), r.toleranceMm().x(), r.toleranceMm().y(),
            r.toleranceMm().z(), r.distanceMm(), r.toleranceDeg(), r.probability()};
        for (int i = 0; i < numbers.length; i++) {
            text.append(i == 0 ? "" : BETWEEN_NUMBERS).append(numbers[i]);
        }
    }

    /**
     * Reads a target.
     *
     * @param text what {@link #of(Target)} wrote, or null
     * @return the target; null where there is none, or the text is of another version of the app
     */
    public static Target read(String text) {
        if (text == null) {
            return null;
        }
        try {
            String[] objects = text.split(BETWEEN_OBJECTS, -1);
            Map<Integer, Requirement> own = new HashMap<>();
            for (int i = 1; i < objects.length; i++) {
                String[] parts = objects[i].split(BETWEEN_NUMBERS, 2);
                own.put(Integer.valueOf(parts[0]), requirement(parts.length < 2 ? "" : parts[1]));
            }
            return new Target(requirement(objects[0]), own);
        } catch (IllegalArgumentException e) {
            return null;
        }
    }

    private static Requirement requirement(String text) {
        String[] parts = text.split(BETWEEN_NUMBERS, -1);
        if (parts.length != NUMBERS) {
            throw new IllegalArgumentException("not " + NUMBERS + " numbers: " + text);
        }
        double[] n = new double[NUMBERS];
        for (int i = 0; i < NUMBERS; i++) {
            n[i] = Double.parseDouble(parts[i]);
        }
        return new Requirement(new Requirement.Axes(n[0], n[1], n[2]), new Requirement.Axes(n[3], n[4], n[5]), n[6],
                n[7], n[8]);
    }
}
