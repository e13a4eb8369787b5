package org.cellgauge.desktop.reproduce;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.Yaml;
import org.yaml.snakeyaml.constructor.SafeConstructor;

/**
 * A value of one of the data files beside the classes; immutable. Faults in them are faults of the program.
 *
 * @param path where it stands, for messages
 * @param value a map, a list, a text or a number
 */
record DataNode(String path, Object value) {
    /**
     * Reads a file.
     *
     * @param name its name beside the classes
     */
    static DataNode ofResource(String name) {
        try (InputStream in = DataNode.class.getResourceAsStream(name)) {
            return new DataNode(name, new Yaml(new SafeConstructor(new LoaderOptions())).load(in));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** What stands under a key. */
    DataNode at(String key) {
        for (Map.Entry<?, ?> entry : map().entrySet()) {
            if (key.equals(String.valueOf(entry.getKey()))) {
                return new DataNode(path + "." + key, entry.getValue());
            }
        }
        throw new IllegalStateException(path + " has no '" + key + "'");
    }

    boolean has(String key) {
        return map().keySet().stream().anyMatch(k -> key.equals(String.valueOf(k)));
    }

    /** Keys in the order of the file. */
    List<String> keys() {
        return map().keySet().stream().map(String::valueOf).toList();
    }

    List<DataNode> items() {
        List<DataNode> items = new ArrayList<>();
        for (Object item : (List<?>) value) {
            items.add(new DataNode(path + "[" + items.size() + "]", item));
        }
        return items;
    }

    String text() {
        return String.valueOf(value);
    }

    double number() {
        return ((Number) value).doubleValue();
    }

    double[] numbers() {
        return items().stream().mapToDouble(DataNode::number).toArray();
    }

    List<String> texts() {
        return items().stream().map(DataNode::text).toList();
    }

    /** The same with another laid over it: its maps are joined key by key, everything else replaced. */
    DataNode with(DataNode over) {
        return new DataNode(path, joined(value, over.value));
    }

    private static Object joined(Object under, Object over) {
        if (!(under instanceof Map) || !(over instanceof Map)) {
            return over;
        }
        Map<Object, Object> all = new LinkedHashMap<>((Map<?, ?>) under);
        ((Map<?, ?>) over).forEach((key, value) ->
                all.put(key, all.containsKey(key) ? joined(all.get(key), value) : value));
        return all;
    }

    private Map<?, ?> map() {
        return (Map<?, ?>) value;
    }
}
