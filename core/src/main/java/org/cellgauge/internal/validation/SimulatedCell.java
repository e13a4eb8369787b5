package org.cellgauge.internal.validation;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;

/** One simulated cell: what its file says, and how it really stands; immutable. */
public final class SimulatedCell {
    private final Cell cell;
    private final CellTruth truth;
    private final Map<Integer, RigidTransform> worldFromReferences;

    /**
     * A simulated cell.
     *
     * @param cell what the check is told
     * @param truth true poses of the camera and of every object of the cell
     * @param worldFromReferences true pose of every reference of the cell, by id; copied
     */
    public SimulatedCell(Cell cell, CellTruth truth, Map<Integer, RigidTransform> worldFromReferences) {
        this.cell = cell;
        this.truth = truth;
        this.worldFromReferences = Collections.unmodifiableMap(new LinkedHashMap<>(worldFromReferences));
    }

    /**
     * What the check is told.
     *
     * @return the cell as its file has it
     */
    public Cell cell() {
        return cell;
    }

    /**
     * Camera and objects.
     *
     * @return true poses
     */
    public CellTruth truth() {
        return truth;
    }

    /**
     * The references.
     *
     * @return unmodifiable, true pose in the world by id
     */
    public Map<Integer, RigidTransform> worldFromReferences() {
        return worldFromReferences;
    }

    /**
     * Where a perfect detector finds the corners of a marker: its true corners through the true camera and its lens.
     *
     * @param id id of a reference or an object of the cell
     * @return 8 values, u, v of top-left, top-right, bottom-right, bottom-left, px; null if one is not in front of the
     *     camera
     * @throws IllegalArgumentException if the cell has no such marker
     */
    public double[] cornersPx(int id) {
        RigidTransform cameraFromWorld = truth.worldFromCamera().inverse();
        for (Reference r : cell.references()) {
            if (r.id() == id) {
                return MarkerGeometry.cornersPx(truth.camera(cell),
                        cameraFromWorld.compose(worldFromReferences.get(id)),
                        r.sizeMm());
            }
        }
        for (ObjectMarker o : cell.objects()) {
            if (o.id() == id) {
                return MarkerGeometry.cornersPx(truth.camera(cell),
                        cameraFromWorld.compose(truth.worldFromObjects().get(id)),
                        o.sizeMm());
            }
        }
        throw new IllegalArgumentException("the cell has no marker " + id);
    }
}
