package org.cellgauge.cell;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * What is known of several references together, beside how precisely each was placed; immutable.
 *
 * @param groups references on one plate; each reference stands in at most one
 * @param measurements what was measured of references besides
 * @param robot what touched points share; null where none was touched
 * @param surveyed how well an earlier survey knows all references; null where there was none
 */
public record JointPlacement(List<PlacementGroup> groups, List<Measurement> measurements,
        @Nullable RobotPrecision robot, @Nullable SurveyedPlacement surveyed) {
    /** Nothing. */
    public static final JointPlacement NONE = new JointPlacement(List.of(), List.of(), null, null);

    /** Copies the lists. */
    public JointPlacement {
        groups = List.copyOf(groups);
        measurements = List.copyOf(measurements);
        if (robot == null && measurements.stream().anyMatch(Measurement.Touched.class::isInstance)) {
            throw new IllegalArgumentException("touched points need the precision of the robot");
        }
    }

    /**
     * Whether all that is known is what each reference's own placement says.
     *
     * @return true where nothing else is stated
     */
    public boolean isNone() {
        return groups.isEmpty() && measurements.isEmpty() && surveyed == null;
    }
}
