package org.cellgauge.plan;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;

/** Where an object may be of which nothing is said. */
public final class ObjectPlaces {
    private static final int ALONG = 5;

    private ObjectPlaces() {
    }

    /**
     * Places between the references: a grid over the rectangle that they span in the plane of the first of them, as far
     * as the camera sees the object there.
     *
     * @param cell the references
     * @param worldFromCamera where the camera stands
     * @param object whose marker lies flat there
     * @return worldFromObject, at least one; the middle where the camera sees none of them
     */
    public static List<RigidTransform> between(Cell cell, RigidTransform worldFromCamera, ObjectMarker object) {
        RigidTransform worldFromPlane = cell.references().get(0).worldFromMarker();
        RigidTransform planeFromWorld = worldFromPlane.inverse();
        double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (Reference r : cell.references()) {
            double[] at = planeFromWorld.apply(r.worldFromMarker().translationMm());
            for (int i = 0; i < 2; i++) {
                low[i] = Math.min(low[i], at[i]);
                high[i] = Math.max(high[i], at[i]);
            }
        }
        List<RigidTransform> places = new ArrayList<>();
        for (int i = 0; i < ALONG; i++) {
            for (int j = 0; j < ALONG; j++) {
                RigidTransform place = place(worldFromPlane, low, high, i / (ALONG - 1.0), j / (ALONG - 1.0));
                if (MarkerGeometry.seenPx(cell.camera(), worldFromCamera.inverse().compose(place),
                        object.sizeMm()) != null) {
                    places.add(place);
                }
            }
        }
        return places.isEmpty() ? List.of(place(worldFromPlane, low, high, 0.5, 0.5)) : places;
    }

    private static RigidTransform place(RigidTransform worldFromPlane, double[] low, double[] high, double along,
            double across) {
        return worldFromPlane.compose(RigidTransform.ofEuler(low[0] + along * (high[0] - low[0]),
                low[1] + across * (high[1] - low[1]), 0, 0, 0, 0));
    }
}
