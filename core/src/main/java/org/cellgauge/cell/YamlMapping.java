package org.cellgauge.cell;

import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import org.cellgauge.internal.cell.CellPhrase;
import org.cellgauge.warning.RefusalKind;
import org.yaml.snakeyaml.nodes.MappingNode;
import org.yaml.snakeyaml.nodes.Node;
import org.yaml.snakeyaml.nodes.NodeTuple;
import org.yaml.snakeyaml.nodes.ScalarNode;
import org.yaml.snakeyaml.nodes.Tag;

/** A mapping of a YAML file in the order of the file; each key stands once. */
final class YamlMapping {
    private final YamlValue self;
    private final Map<String, YamlValue> values = new LinkedHashMap<>();

    YamlMapping(YamlValue self, MappingNode node) {
        this.self = self;
        for (NodeTuple tuple : node.getValue()) {
            Node keyNode = tuple.getKeyNode();
            int line = keyNode.getStartMark().getLine() + 1;
            if (!(keyNode instanceof ScalarNode)) {
                throw YamlValue.refused(self.file(), line, self.path(), CellRefusal.KEY_NO_WORD);
            }
            String key = ((ScalarNode) keyNode).getValue();
            String path = self.path().isEmpty() ? key : self.path() + "." + key;
            if (Tag.MERGE.equals(keyNode.getTag())) {
                throw YamlValue.refused(self.file(), line, path, CellRefusal.MERGE_KEY);
            }
            YamlValue value = new YamlValue(self.file(), path, line, tuple.getValueNode());
            YamlValue earlier = values.putIfAbsent(key, value);
            if (earlier != null) {
                throw value.refused(CellRefusal.TWICE, earlier.line());
            }
        }
    }

    void refuseUnknown(Collection<String> known) {
        for (Map.Entry<String, YamlValue> e : values.entrySet()) {
            if (!known.contains(e.getKey())) {
                // {size_mm: 47,5} reads as the keys size_mm and 5
                boolean comma = e.getKey().matches("\\d+") && e.getValue().isEmpty();
                throw e.getValue().refused(CellRefusal.UNKNOWN_KEY, Suggestions.remedy(e.getKey(), known),
                        comma ? CellPhrase.POINT_NOT_COMMA : "");
            }
        }
    }

    YamlValue self() {
        return self;
    }

    Set<String> keys() {
        return Collections.unmodifiableSet(values.keySet());
    }

    Map<String, YamlValue> values() {
        return Collections.unmodifiableMap(values);
    }

    /** The value of a key, or null where the key does not stand there. */
    YamlValue optional(String key) {
        return values.get(key);
    }

    /**
     * The value of a key that must stand there.
     *
     * @param remedy how to write it, as an argument of a refusal
     */
    YamlValue required(String key, Object remedy) {
        YamlValue value = values.get(key);
        if (value == null) {
            throw missing(key, CellRefusal.MISSING, remedy);
        }
        return value;
    }

    /** A refusal for a key that does not stand there, on the mapping's own line. */
    InputRefusedException missing(String key, RefusalKind kind, Object... arguments) {
        String path = self.path().isEmpty() ? key : self.path() + "." + key;
        return YamlValue.refused(self.file(), self.line(), path, kind, arguments);
    }
}
