package org.cellgauge.plan;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.cell.Area;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;

/** Where an object may be of which nothing is said. */
public final class ObjectPlaces {
    private static final int ALONG = 5;
    /** Below this part of a plane's normal that points up, the plane is upright. */
    private static final double LEVEL = 0.05;

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

    /**
     * Places anywhere in a region: a grid over it in the plane of the first reference, whether the camera sees the
     * object there or not.
     *
     * @param cell the references
     * @param area where the object may lie, seen from above
     * @return worldFromObject, the object's marker lying flat
     */
    public static List<RigidTransform> in(Cell cell, Area area) {
        return in(cell, area, ALONG, ALONG);
    }

    /**
     * The same on a grid of another fineness.
     *
     * @param cell the references
     * @param area where the object may lie, seen from above
     * @param columns places along x, two at least
     * @param rows places along y, two at least
     * @return worldFromObject, column by column from small x and y on
     */
    public static List<RigidTransform> in(Cell cell, Area area, int columns, int rows) {
        RigidTransform plane = cell.references().get(0).worldFromMarker();
        double[] r = plane.rotation();
        double[] origin = plane.translationMm();
        List<RigidTransform> places = new ArrayList<>();
        for (int i = 0; i < columns; i++) {
            for (int j = 0; j < rows; j++) {
                double x = area.xLowMm() + (area.xHighMm() - area.xLowMm()) * i / (columns - 1);
                double y = area.yLowMm() + (area.yHighMm() - area.yLowMm()) * j / (rows - 1);
                // straight below or above in the plane; an upright plane has one height for all
                double z = Math.abs(r[8]) < LEVEL ? origin[2]
                        : origin[2] - (r[2] * (x - origin[0]) + r[5] * (y - origin[1])) / r[8];
                places.add(RigidTransform.of(r, new double[] {x, y, z}));
            }
        }
        return places;
    }

    private static RigidTransform place(RigidTransform worldFromPlane, double[] low, double[] high, double along,
            double across) {
        return worldFromPlane.compose(RigidTransform.ofEuler(low[0] + along * (high[0] - low[0]),
                low[1] + across * (high[1] - low[1]), 0, 0, 0, 0));
    }
}
