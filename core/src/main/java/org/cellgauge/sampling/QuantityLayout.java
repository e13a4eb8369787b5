package org.cellgauge.sampling;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Names of the quantities of a draw, which of them are angles, and which are wanted with a joint covariance; immutable.
 *
 * <p>An angle has a reference direction: running statistics work on its deviation from there, wrapped to (-pi, pi], so
 * that draws to both sides of +-pi stay together.
 */
public final class QuantityLayout {
    private final List<String> names;
    private final boolean[] angle;
    private final double[] referenceRad;
    private final Map<String, int[]> groups;

    private QuantityLayout(Builder b) {
        names = Collections.unmodifiableList(new ArrayList<>(b.names));
        angle = new boolean[names.size()];
        referenceRad = new double[names.size()];
        b.references.forEach((index, reference) -> {
            angle[index] = true;
            referenceRad[index] = reference;
        });
        groups = Collections.unmodifiableMap(new LinkedHashMap<>(b.groups));
    }

    /**
     * Number of quantities.
     *
     * @return at least 1
     */
    public int size() {
        return names.size();
    }

    /**
     * Names.
     *
     * @return unmodifiable, in the order of the draws
     */
    public List<String> names() {
        return names;
    }

    /**
     * Position of a quantity.
     *
     * @param name its name
     * @return index in a draw
     * @throws IllegalArgumentException if there is none of that name
     */
    public int indexOf(String name) {
        int i = names.indexOf(name);
        if (i < 0) {
            throw new IllegalArgumentException("no quantity " + name);
        }
        return i;
    }

    /**
     * Whether a quantity is an angle.
     *
     * @param index position
     * @return true for an angle in rad
     */
    public boolean isAngle(int index) {
        return angle[index];
    }

    /**
     * Reference direction of an angle.
     *
     * @param index position
     * @return rad; 0 for what is no angle
     */
    public double referenceRad(int index) {
        return referenceRad[index];
    }

    /**
     * Groups of quantities with a joint covariance.
     *
     * @return unmodifiable: group name to positions (not to be changed)
     */
    public Map<String, int[]> groups() {
        return groups;
    }

    /** Builds a layout. */
    public static final class Builder {
        private final List<String> names = new ArrayList<>();
        private final Map<Integer, Double> references = new LinkedHashMap<>();
        private final Map<String, int[]> groups = new LinkedHashMap<>();

        /**
         * Adds a quantity.
         *
         * @param name unique name, unit included
         * @return its index
         */
        public int add(String name) {
            if (names.contains(name)) {
                throw new IllegalArgumentException("quantity " + name + " stands twice");
            }
            names.add(name);
            return names.size() - 1;
        }

        /**
         * Adds an angle.
         *
         * @param name unique name
         * @param referenceRad direction near which draws are expected, rad
         * @return its index
         */
        public int addAngle(String name, double referenceRad) {
            int index = add(name);
            references.put(index, referenceRad);
            return index;
        }

        /**
         * Asks for a joint covariance.
         *
         * @param name name of the group
         * @param indices its quantities, in the order of the covariance
         */
        public void group(String name, int... indices) {
            groups.put(name, indices.clone());
        }

        /**
         * The layout.
         *
         * @return what was added so far
         */
        public QuantityLayout build() {
            return new QuantityLayout(this);
        }
    }
}
