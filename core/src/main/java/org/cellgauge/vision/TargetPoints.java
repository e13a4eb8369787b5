package org.cellgauge.vision;

import java.util.Collections;
import java.util.List;
import org.cellgauge.geometry.RigidTransform;

/**
 * The points of a calibration target that photos show, in the target's frame; immutable.
 */
public final class TargetPoints {
    /**
     * Points of one plane, in a row.
     *
     * @param targetFromPatch the plane is z = 0 of this frame
     * @param first index of its first point
     * @param count number of its points, at least 4
     */
    public record Patch(RigidTransform targetFromPatch, int first, int count) {
    }

    private final double[] xyzMm;
    private final List<Patch> patches;
    private final boolean cornersOfMarkers;

    /**
     * Points.
     *
     * @param xyzMm x, y, z of each in the target's frame, mm; copied
     * @param patches the planes they lie in; one of all points where the target is flat
     * @param cornersOfMarkers whether every four in a row are corners of a marker, which move where the light moves its
     *     sides; points where black and white cross do not
     */
    public TargetPoints(double[] xyzMm, List<Patch> patches, boolean cornersOfMarkers) {
        this.xyzMm = xyzMm.clone();
        this.patches = Collections.unmodifiableList(List.copyOf(patches));
        this.cornersOfMarkers = cornersOfMarkers;
    }

    /**
     * A flat target.
     *
     * @param xyMm x, y of each point, mm
     * @return points of one plane z = 0
     */
    public static TargetPoints flat(double[] xyMm) {
        int count = xyMm.length / 2;
        double[] xyz = new double[3 * count];
        for (int i = 0; i < count; i++) {
            xyz[3 * i] = xyMm[2 * i];
            xyz[3 * i + 1] = xyMm[2 * i + 1];
        }
        return new TargetPoints(xyz, List.of(new Patch(RigidTransform.IDENTITY, 0, count)), false);
    }

    /**
     * How many points there are.
     *
     * @return the number
     */
    public int count() {
        return xyzMm.length / 3;
    }

    /**
     * The points.
     *
     * @return x, y, z of each in the target's frame, mm; a copy
     */
    public double[] xyzMm() {
        return xyzMm.clone();
    }

    /**
     * The planes they lie in.
     *
     * @return unmodifiable
     */
    public List<Patch> patches() {
        return patches;
    }

    /**
     * Whether all lie in one plane z = 0.
     *
     * @return false for markers about a cell
     */
    public boolean isFlat() {
        return patches.size() == 1;
    }

    /**
     * Whether every four in a row are corners of a marker.
     *
     * @return whether the light in a photo may move them
     */
    public boolean areCornersOfMarkers() {
        return cornersOfMarkers;
    }
}
