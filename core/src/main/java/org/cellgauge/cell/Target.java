package org.cellgauge.cell;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.OptionalDouble;

/**
 * What is asked of the objects of a cell; immutable.
 *
 * @param general what is asked of every object of which nothing else is
 * @param own what is asked of single objects instead, by marker id
 */
public record Target(Requirement general, Map<Integer, Requirement> own) {
    /** Nothing is asked. */
    public static final Target NONE = new Target(Requirement.NONE, Map.of());

    /**
     * A target.
     *
     * @param own copied; what is asked as of all is left out
     */
    public Target {
        Map<Integer, Requirement> others = new LinkedHashMap<>();
        for (Map.Entry<Integer, Requirement> e : own.entrySet()) {
            if (!e.getValue().equals(general)) {
                others.put(e.getKey(), e.getValue());
            }
        }
        own = Map.copyOf(others);
    }

    /**
     * One standard deviation for all.
     *
     * @param stdMm the largest allowed along any axis of any object and gripping point, mm, positive; empty for none
     * @return the target
     */
    public static Target ofStdMm(OptionalDouble stdMm) {
        return stdMm.isPresent() ? new Target(Requirement.ofStdMm(stdMm.getAsDouble()), Map.of()) : NONE;
    }

    /**
     * What is asked of an object.
     *
     * @param objectId marker id
     * @return its own requirement or that of all
     */
    public Requirement of(int objectId) {
        return own.getOrDefault(objectId, general);
    }

    /**
     * Whether anything is asked of any object.
     *
     * @return false for {@link #NONE} and its like
     */
    public boolean isAny() {
        return general.isAny() || own.values().stream().anyMatch(Requirement::isAny);
    }

    /**
     * Whether a probability is asked for, which only draws tell.
     *
     * @return true where any object has a tolerance
     */
    public boolean asksForProbability() {
        return general.asksForProbability() || own.values().stream().anyMatch(Requirement::asksForProbability);
    }

    /**
     * The target as one standard deviation.
     *
     * @return the largest allowed along any axis of any object and gripping point, mm; empty where there is no target,
     *     and where it asks for more or differs between axes or objects
     */
    public OptionalDouble oneStdMm() {
        return own.isEmpty() && general.isOneStd() ? OptionalDouble.of(general.stdMm().x()) : OptionalDouble.empty();
    }

    @Override
    public String toString() {
        StringBuilder out = new StringBuilder(general.isAny() || own.isEmpty() ? general.toString() : "");
        own.entrySet().stream().sorted(Map.Entry.comparingByKey()).forEach(e ->
                out.append(out.length() == 0 ? "" : "; ").append("object ").append(e.getKey()).append(": ")
                        .append(e.getValue()));
        return out.toString();
    }
}
