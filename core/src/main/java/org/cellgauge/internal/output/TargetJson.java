package org.cellgauge.internal.output;

import com.google.gson.stream.JsonWriter;
import java.io.IOException;
import java.util.Map;
import java.util.TreeMap;
import org.cellgauge.cell.Requirement;
import org.cellgauge.cell.Target;

/** A target as results and plans hold it: the keys of the cell file, null where nothing is asked. */
public final class TargetJson {
    private TargetJson() {
    }

    /**
     * Writes a target.
     *
     * @param target what is asked of the objects
     * @param json receives an object
     * @throws IOException if it cannot be written
     */
    public static void write(Target target, JsonWriter json) throws IOException {
        json.beginObject();
        requirement(target.general(), json);
        if (!target.own().isEmpty()) {
            json.name("objects").beginObject();
            for (Map.Entry<Integer, Requirement> own : new TreeMap<>(target.own()).entrySet()) {
                json.name(String.valueOf(own.getKey())).beginObject();
                requirement(own.getValue(), json);
                json.endObject();
            }
            json.endObject();
        }
        json.endObject();
    }

    private static void requirement(Requirement asked, JsonWriter json) throws IOException {
        limits("std_mm", asked.stdMm(), json);
        if (asked.asksForProbability()) {
            limits("tolerance_mm", asked.toleranceMm(), json);
            limits("distance_mm", Requirement.Axes.all(asked.distanceMm()), json);
            limits("tolerance_deg", Requirement.Axes.all(asked.toleranceDeg()), json);
            json.name("probability").value(asked.probability());
        }
    }

    private static void limits(String name, Requirement.Axes limits, JsonWriter json) throws IOException {
        json.name(name);
        if (limits.isUniform() || !limits.isAny()) {
            limit(limits.x(), json);
        } else {
            json.beginArray();
            for (int axis = 0; axis < 3; axis++) {
                limit(limits.of(axis), json);
            }
            json.endArray();
        }
    }

    private static void limit(double limit, JsonWriter json) throws IOException {
        if (limit < Double.POSITIVE_INFINITY) {
            json.value(limit);
        } else {
            json.nullValue();
        }
    }
}
