package org.cellgauge.desktop.render;

import java.util.Map;
import java.util.Set;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.vision.MarkerPattern;

/**
 * What people do wrong when they print and mount markers; immutable. The places in a cell stay what they are, and the
 * true corners with them: only what is printed there changes, or where an id's print has gone.
 *
 * @param inverted ids of the markers that are printed white on black paper
 * @param mirrored ids of those whose left and right are exchanged
 * @param quartersClockwise by how many quarters clockwise prints are turned in their places, by id
 * @param exchanged ids whose prints stand in each other's places, both ways
 * @param inkReflectance as in {@link SceneMarker}
 */
public record Misprints(Set<Integer> inverted, Set<Integer> mirrored, Map<Integer, Integer> quartersClockwise,
        Map<Integer, Integer> exchanged, double inkReflectance) {
    /** All is as it should be. */
    public static final Misprints NONE = new Misprints(Set.of(), Set.of(), Map.of(), Map.of(), PlanarMarker.BLACK);

    /** Takes copies. */
    public Misprints {
        inverted = Set.copyOf(inverted);
        mirrored = Set.copyOf(mirrored);
        quartersClockwise = Map.copyOf(quartersClockwise);
        exchanged = Map.copyOf(exchanged);
    }

    /** The print of a marker in its place. */
    SceneMarker print(MarkerFamily family, int id, double sizeMm, RigidTransform worldFromMarker) {
        MarkerPattern pattern = MarkerPattern.of(family, id);
        if (inverted.contains(id)) {
            pattern = pattern.inverted();
        }
        if (mirrored.contains(id)) {
            pattern = pattern.mirrored();
        }
        return new SceneMarker(id, sizeMm, pattern.turnedClockwise(quartersClockwise.getOrDefault(id, 0)),
                worldFromMarker, inkReflectance);
    }

    /** Puts prints into each other's places; two of which one is not in the scene stay. */
    void exchange(Map<Integer, RigidTransform> references, Map<Integer, RigidTransform> objects) {
        exchanged.forEach((one, other) -> {
            Map<Integer, RigidTransform> ofOne = references.containsKey(one) ? references : objects;
            Map<Integer, RigidTransform> ofOther = references.containsKey(other) ? references : objects;
            if (ofOne.containsKey(one) && ofOther.containsKey(other)) {
                RigidTransform placeOfOne = ofOne.get(one);
                ofOne.put(one, ofOther.get(other));
                ofOther.put(other, placeOfOne);
            }
        });
    }
}
