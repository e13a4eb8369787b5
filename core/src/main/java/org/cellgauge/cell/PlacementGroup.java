package org.cellgauge.cell;

import java.util.List;

/**
 * References that were printed or mounted on one plate: the plate is off its place by one rigid error, which all of
 * them share; how far each is off its place on the plate is its own {@link Reference#placement()}. Immutable.
 *
 * <p>The plate's error is a shift along the world axes and a rotation vector in world axes about the centroid of its
 * members' stated places.
 *
 * @param name what the cell file calls it
 * @param members ids of references, at least two
 * @param placement how precisely the plate was placed
 */
public record PlacementGroup(String name, List<Integer> members, Placement placement) {
    /**
     * Copies the list.
     *
     * @throws IllegalArgumentException if there are fewer than two members
     */
    public PlacementGroup {
        members = List.copyOf(members);
        if (members.size() < 2) {
            throw new IllegalArgumentException("group " + name + " needs at least two members");
        }
    }
}
