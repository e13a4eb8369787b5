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
    private final List<List<Integer>> plates;
    private final List<MeasuredDistance> distances;
    private final List<RigidTransform> cameraFromOthers;

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
        this(cell, worldFromCameras, worldFromObjects, List.of(), List.of(), List.of());
    }

    private Layout(Cell cell, List<RigidTransform> worldFromCameras,
            Map<Integer, List<RigidTransform>> worldFromObjects, List<List<Integer>> plates,
            List<MeasuredDistance> distances, List<RigidTransform> cameraFromOthers) {
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
        this.plates = List.copyOf(plates);
        this.distances = List.copyOf(distances);
        this.cameraFromOthers = List.copyOf(cameraFromOthers);
    }

    /**
     * The same with another cell.
     *
     * @param other its objects are those of this one
     * @return a new layout
     */
    public Layout with(Cell other) {
        return new Layout(other, worldFromCameras, worldFromObjects, plates, distances, cameraFromOthers);
    }

    /**
     * The same with the camera elsewhere.
     *
     * @param others where it may stand, at least one place
     * @return a new layout
     */
    public Layout withCameras(List<RigidTransform> others) {
        return new Layout(cell, others, worldFromObjects, plates, distances, cameraFromOthers);
    }

    /**
     * The same with references that stand on one plate, so that they are off together: placement is said of the plate's
     * middle, by the first of them, and on the plate they stand exactly.
     *
     * @param references ids, two at least
     * @return a new layout
     * @throws IllegalArgumentException if there is no reference of an id, or it is on a plate already
     */
    public Layout withPlate(List<Integer> references) {
        for (int id : references) {
            requireReference(id);
            if (plates.stream().anyMatch(plate -> plate.contains(id))) {
                throw new IllegalArgumentException("reference " + id + " is on a plate already");
            }
        }
        if (references.stream().distinct().count() < 2) {
            throw new IllegalArgumentException("one reference makes no plate");
        }
        List<List<Integer>> more = new ArrayList<>(plates);
        more.add(List.copyOf(references));
        return new Layout(cell, worldFromCameras, worldFromObjects, more, distances, cameraFromOthers);
    }

    /**
     * The same with a distance that is measured.
     *
     * @param distance between two of its references
     * @return a new layout
     * @throws IllegalArgumentException if there is no reference of an id
     */
    public Layout withDistance(MeasuredDistance distance) {
        requireReference(distance.first());
        requireReference(distance.second());
        List<MeasuredDistance> more = new ArrayList<>(distances);
        more.add(distance);
        return new Layout(cell, worldFromCameras, worldFromObjects, plates, more, cameraFromOthers);
    }

    /**
     * The same with more photos of what stands still meanwhile.
     *
     * @param others where the camera stands for each of them, in the frame of the camera of the first photo
     * @return a new layout
     */
    public Layout withOtherPhotos(List<RigidTransform> others) {
        return new Layout(cell, worldFromCameras, worldFromObjects, plates, distances, others);
    }

    private void requireReference(int id) {
        if (cell.references().stream().noneMatch(r -> r.id() == id)) {
            throw new IllegalArgumentException("there is no reference " + id);
        }
    }

    /**
     * References that stand on one plate.
     *
     * @return unmodifiable, ids plate by plate
     */
    public List<List<Integer>> plates() {
        return plates;
    }

    /**
     * Measured distances.
     *
     * @return unmodifiable
     */
    public List<MeasuredDistance> distances() {
        return distances;
    }

    /**
     * Where the camera stands for the photos after the first.
     *
     * @return unmodifiable, x_first = cameraFromOther · x_other
     */
    public List<RigidTransform> cameraFromOthers() {
        return cameraFromOthers;
    }

    /**
     * Whether it is one photo of references that err independently of each other, which is all that a check knows.
     *
     * @return false with plates, measured distances or other photos
     */
    public boolean isOnePhoto() {
        return plates.isEmpty() && distances.isEmpty() && cameraFromOthers.isEmpty();
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
