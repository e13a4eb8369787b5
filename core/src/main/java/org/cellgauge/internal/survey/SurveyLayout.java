package org.cellgauge.internal.survey;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.JointPlacement;
import org.cellgauge.cell.Measurement;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.PlacementGroup;
import org.cellgauge.cell.Reference;
import org.cellgauge.internal.pose.IntrinsicsPrior;

/**
 * The unknowns that all photos of a cell share, and where each is in a vector of them; immutable.
 *
 * <p>Order: the error of each reference on its place or plate (shift along world axes in mm, rotation vector in rad);
 * that of each plate likewise; the pose of each object that stands still; intrinsics; sizes of prints in units of their
 * deviation; where touched points are, the robot's base and its tool centre point; three numbers for each plane.
 */
final class SurveyLayout {
    static final int POSE = 6;
    static final int TOOL = 3;
    static final int PLANE = 3;

    final Cell cell;
    final List<Reference> references;
    final List<PlacementGroup> groups;
    /** Objects that stand still and that at least one photo shows. */
    final List<ObjectMarker> objects;
    final IntrinsicsPrior intrinsics;
    /** Sizes of prints that may be off, mm. */
    final List<Double> sizesMm;
    final List<Measurement> measurements;
    /** Index of the group of each reference; -1 for none. */
    final int[] groupOf;

    final int firstGroup;
    final int firstObject;
    final int firstIntrinsic;
    final int firstSize;
    final int firstRobot;
    final int firstPlane;
    final int size;

    private final Map<Integer, Integer> referenceOf = new HashMap<>();
    private final Map<Integer, Integer> objectOf = new HashMap<>();

    SurveyLayout(Cell cell, List<ObjectMarker> objects, IntrinsicsPrior intrinsics) {
        this.cell = cell;
        this.intrinsics = intrinsics;
        references = cell.references();
        this.objects = Collections.unmodifiableList(new ArrayList<>(objects));
        for (Reference r : references) {
            referenceOf.put(r.id(), referenceOf.size());
        }
        for (ObjectMarker o : objects) {
            objectOf.put(o.id(), objectOf.size());
        }
        JointPlacement joint = cell.joint();
        groups = joint.groups();
        measurements = joint.measurements();
        groupOf = new int[references.size()];
        java.util.Arrays.fill(groupOf, -1);
        for (int k = 0; k < groups.size(); k++) {
            for (int id : groups.get(k).members()) {
                Integer member = referenceOf.get(id);
                if (member != null) {
                    groupOf[member] = k;
                }
            }
        }
        List<Double> sizes = new ArrayList<>();
        if (cell.prints().sizeStdMm() > 0) {
            references.forEach(r -> addOnce(sizes, r.sizeMm()));
            cell.objects().forEach(o -> addOnce(sizes, o.sizeMm()));
        }
        sizesMm = Collections.unmodifiableList(sizes);
        firstGroup = POSE * references.size();
        firstObject = firstGroup + POSE * groups.size();
        firstIntrinsic = firstObject + POSE * objects.size();
        firstSize = firstIntrinsic + intrinsics.count();
        firstRobot = firstSize + sizes.size();
        boolean touched = measurements.stream().anyMatch(Measurement.Touched.class::isInstance);
        firstPlane = firstRobot + (touched ? POSE + TOOL : 0);
        int planes = (int) measurements.stream().filter(Measurement.OnePlane.class::isInstance).count();
        size = firstPlane + PLANE * planes;
    }

    private static void addOnce(List<Double> sizes, double sizeMm) {
        if (!sizes.contains(sizeMm)) {
            sizes.add(sizeMm);
        }
    }

    /** Index of a reference; -1 where the marker is none. */
    int reference(int id) {
        return referenceOf.getOrDefault(id, -1);
    }

    /** Index of an object that stands still; -1 where the marker is none. */
    int object(int id) {
        return objectOf.getOrDefault(id, -1);
    }

    boolean isRobotUnknown() {
        return firstPlane > firstRobot;
    }
}
