package org.cellgauge.plan;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.geometry.RigidTransform;

/**
 * A cell as it is or could be: its markers, where the camera stands and where its objects may be; immutable.
 */
public final class Layout {
    private final Cell cell;
    private final List<RigidTransform> worldFromCameras;
    private final Map<Integer, List<RigidTransform>> worldFromObjects;

    /**
     * A layout.
     *
     * @param cell camera, references, objects, precision and target
     * @param worldFromCameras where the camera may stand, at least one place: where there are several, the worst counts
     * @param worldFromObjects where objects may stand, by id, at least one place each: the worst counts; objects of the
     *     cell that are not in it are left out
     * @throws IllegalArgumentException if there is no place of the camera, or none of an object, or an id is no object
     *     of the cell
     */
    public Layout(Cell cell, List<RigidTransform> worldFromCameras,
            Map<Integer, List<RigidTransform>> worldFromObjects) {
        if (worldFromCameras.isEmpty()) {
            throw new IllegalArgumentException("the camera stands nowhere");
        }
        Map<Integer, List<RigidTransform>> copy = new LinkedHashMap<>();
        for (ObjectMarker object : cell.objects()) {
            List<RigidTransform> places = worldFromObjects.get(object.id());
            if (places != null && places.isEmpty()) {
                throw new IllegalArgumentException("object " + object.id() + " stands nowhere");
            }
            if (places != null) {
                copy.put(object.id(), Collections.unmodifiableList(new ArrayList<>(places)));
            }
        }
        if (copy.size() < worldFromObjects.size()) {
            throw new IllegalArgumentException("not all of " + worldFromObjects.keySet() + " are objects of the cell");
        }
        this.cell = cell;
        this.worldFromCameras = Collections.unmodifiableList(new ArrayList<>(worldFromCameras));
        this.worldFromObjects = Collections.unmodifiableMap(copy);
    }

    /**
     * The same with another cell.
     *
     * @param other its objects are those of this one
     * @return a new layout
     */
    public Layout with(Cell other) {
        return new Layout(other, worldFromCameras, worldFromObjects);
    }

    /**
     * The same with the camera elsewhere.
     *
     * @param others where it may stand, at least one place
     * @return a new layout
     */
    public Layout withCameras(List<RigidTransform> others) {
        return new Layout(cell, others, worldFromObjects);
    }

    /**
     * The cell.
     *
     * @return camera, references, objects, precision and target
     */
    public Cell cell() {
        return cell;
    }

    /**
     * Where the camera may stand.
     *
     * @return unmodifiable, x_world = worldFromCamera · x_camera, not empty
     */
    public List<RigidTransform> worldFromCameras() {
        return worldFromCameras;
    }

    /**
     * Where objects may stand.
     *
     * @return unmodifiable, by id in the order of the cell
     */
    public Map<Integer, List<RigidTransform>> worldFromObjects() {
        return worldFromObjects;
    }
}
