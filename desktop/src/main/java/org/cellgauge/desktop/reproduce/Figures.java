package org.cellgauge.desktop.reproduce;

import com.google.gson.Gson;
import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import java.util.Arrays;
import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;

/** What a piece of work found: numbers by name; immutable. */
final class Figures {
    private final Map<String, double[]> values;

    private Figures(Map<String, double[]> values) {
        this.values = Collections.unmodifiableMap(values);
    }

    boolean has(String name) {
        return values.containsKey(name);
    }

    /** The numbers of a name. */
    double[] all(String name) {
        double[] found = values.get(name);
        if (found == null) {
            throw new IllegalStateException("no figures " + name + " among " + values.keySet());
        }
        return found.clone();
    }

    /** The only number of a name. */
    double one(String name) {
        return all(name)[0];
    }

    /** Of rows of some width that stand one after the other, one column. */
    double[] column(String name, int width, int column) {
        double[] all = all(name);
        double[] picked = new double[all.length / width];
        for (int i = 0; i < picked.length; i++) {
            picked[i] = all[i * width + column];
        }
        return picked;
    }

    /** As a JSON object; numbers that JSON has none for are null. */
    String json() {
        JsonObject object = new JsonObject();
        values.forEach((name, numbers) -> {
            JsonArray array = new JsonArray();
            for (double number : numbers) {
                array.add(Double.isFinite(number) ? new JsonPrimitive(number) : null);
            }
            object.add(name, array);
        });
        return new Gson().toJson(object);
    }

    /** What {@link #json()} wrote. */
    static Figures of(JsonObject object) {
        Builder builder = new Builder();
        for (Map.Entry<String, JsonElement> entry : object.entrySet()) {
            JsonArray array = entry.getValue().getAsJsonArray();
            double[] numbers = new double[array.size()];
            for (int i = 0; i < numbers.length; i++) {
                numbers[i] = array.get(i).isJsonNull() ? Double.NaN : array.get(i).getAsDouble();
            }
            builder.put(entry.getKey(), numbers);
        }
        return builder.build();
    }

    /** Collects figures. Not safe for several threads. */
    static final class Builder {
        private final Map<String, double[]> values = new TreeMap<>();

        Builder put(String name, double... numbers) {
            values.put(name, numbers.clone());
            return this;
        }

        /** Adds to what a name has. */
        Builder append(String name, double... numbers) {
            double[] before = values.getOrDefault(name, new double[0]);
            double[] all = Arrays.copyOf(before, before.length + numbers.length);
            System.arraycopy(numbers, 0, all, before.length, numbers.length);
            values.put(name, all);
            return this;
        }

        /** Takes all of others, with something before their names. */
        Builder putAll(String prefix, Figures others) {
            others.values.forEach((name, numbers) -> put(prefix + name, numbers));
            return this;
        }

        Figures build() {
            return new Figures(new TreeMap<>(values));
        }
    }
}
