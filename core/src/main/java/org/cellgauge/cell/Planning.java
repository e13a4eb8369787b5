package org.cellgauge.cell;

import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.cellgauge.geometry.RigidTransform;
import org.jspecify.annotations.Nullable;

/**
 * What a cell file says for planning alone: where the camera and the objects may be, where references may be put, and
 * what changes cost; immutable. A check of a photo asks for none of it but the costs.
 *
 * @param worldFromCamera where the camera stands, or null where that is not said
 * @param cameraRange how far from there it may be
 * @param regions where objects may lie anywhere, by marker id
 * @param free where references may be put; empty: anywhere
 * @param walls upright walls, which references may hang on, and which hide what is behind them
 * @param maxHeightMm how far off their plane references may be raised, mm, not negative; empty where that is not said
 * @param costs what changes cost; those left out cost what is usual
 */
public record Planning(@Nullable RigidTransform worldFromCamera, CameraRange cameraRange, Map<Integer, Area> regions,
        List<Area> free, List<Wall> walls, OptionalDouble maxHeightMm, Map<ChangeKind, Double> costs) {
    /** Nothing is said. */
    public static final Planning NONE = new Planning(null, CameraRange.NONE, Map.of(), List.of(), List.of(),
            OptionalDouble.empty(), Map.of());

    /**
     * What is said for planning.
     *
     * @param regions copied, as the other collections are
     */
    public Planning {
        regions = Map.copyOf(regions);
        free = List.copyOf(free);
        walls = List.copyOf(walls);
        costs = Map.copyOf(costs);
    }
}
