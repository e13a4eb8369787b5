package org.cellgauge.sampling;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * The quantities of a draw, which of them are angles, and which are wanted with a joint covariance; immutable.
 *
 * <p>An angle has a reference direction: running statistics work on its deviation from there, wrapped to (-pi, pi], so
 * that draws to both sides of +-pi stay together.
 */
public final class QuantityLayout {
    private final List<Quantity> quantities;
    private final Map<Quantity, Integer> indices;
    private final List<String> names;
    private final boolean[] angle;
    private final double[] referenceRad;
    private final List<int[]> groups;

    private QuantityLayout(Builder b) {
        quantities = Collections.unmodifiableList(new ArrayList<>(b.indices.keySet()));
        indices = new HashMap<>(b.indices);
        names = Collections.unmodifiableList(quantities.stream().map(Quantity::name).collect(Collectors.toList()));
        angle = new boolean[names.size()];
        referenceRad = new double[names.size()];
        b.references.forEach((index, reference) -> {
            angle[index] = true;
            referenceRad[index] = reference;
        });
        groups = Collections.unmodifiableList(new ArrayList<>(b.groups));
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
     * The quantities.
     *
     * @return unmodifiable, in the order of the draws
     */
    public List<Quantity> quantities() {
        return quantities;
    }

    /**
     * Their names: the header of a file of draws.
     *
     * @return unmodifiable, in the order of the draws
     */
    public List<String> names() {
        return names;
    }

    /**
     * Position of a quantity.
     *
     * @param quantity which
     * @return index in a draw
     * @throws IllegalArgumentException if draws have no such quantity
     */
    public int indexOf(Quantity quantity) {
        Integer i = indices.get(quantity);
        if (i == null) {
            throw new IllegalArgumentException("no quantity " + quantity);
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
     * @return unmodifiable: positions of each (not to be changed), in the order in which they were asked for
     */
    public List<int[]> groups() {
        return groups;
    }

    /** Builds a layout. */
    public static final class Builder {
        private final Map<Quantity, Integer> indices = new LinkedHashMap<>();
        private final Map<Integer, Double> references = new LinkedHashMap<>();
        private final List<int[]> groups = new ArrayList<>();

        /**
         * Adds a quantity.
         *
         * @param quantity one that is not there yet
         * @return its index
         */
        public int add(Quantity quantity) {
            int index = indices.size();
            if (indices.putIfAbsent(quantity, index) != null) {
                throw new IllegalArgumentException("quantity " + quantity + " stands twice");
            }
            return index;
        }

        /**
         * Adds an angle.
         *
         * @param quantity one that is not there yet
         * @param referenceRad direction near which draws are expected, rad
         * @return its index
         */
        public int addAngle(Quantity quantity, double referenceRad) {
            int index = add(quantity);
            references.put(index, referenceRad);
            return index;
        }

        /**
         * Asks for a joint covariance.
         *
         * @param indices its quantities, in the order of the covariance
         * @return index of the group, to ask a summary for it
         */
        public int group(int... indices) {
            groups.add(indices.clone());
            return groups.size() - 1;
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
