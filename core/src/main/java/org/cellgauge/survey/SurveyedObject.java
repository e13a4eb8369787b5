package org.cellgauge.survey;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.check.Conformity;
import org.cellgauge.estimate.PointEstimate;
import org.cellgauge.estimate.PoseEstimate;
import org.jspecify.annotations.Nullable;

/**
 * An object that stands still and where it stands; immutable.
 *
 * @param marker the object
 * @param pose in the world
 * @param grip its gripping point in the world; null where none is stated
 * @param photos how many photos show it
 * @param shares of the variance of its position by source, adding to 1
 * @param worstStdMmByPhotos largest deviation of its position along an axis after the first photo, the first two and so
 *     on, mm; NaN while nothing tells of it
 * @param nextWorstStdMm the same if one more photo told as much as those there are tell on average, mm
 * @param conformities how probable it is that position, orientation and gripping point lie within what its target
 *     tolerates; empty where no probability is asked for, and without draws
 * @param ambiguous whether two poses explain all photos
 */
public record SurveyedObject(ObjectMarker marker, PoseEstimate pose, @Nullable PointEstimate grip, int photos,
        Map<String, Double> shares, List<Double> worstStdMmByPhotos, double nextWorstStdMm,
        List<Conformity> conformities, boolean ambiguous) {
    /** Copies map and list. */
    public SurveyedObject {
        shares = Collections.unmodifiableMap(new LinkedHashMap<>(shares));
        worstStdMmByPhotos = List.copyOf(worstStdMmByPhotos);
        conformities = List.copyOf(conformities);
    }

    /**
     * Largest deviation along a world axis of position and gripping point.
     *
     * @return mm
     */
    public double worstStdMm() {
        double worst = 0;
        for (int i = 0; i < 3; i++) {
            worst = Math.max(worst, pose.std()[i]);
            worst = grip == null ? worst : Math.max(worst, grip.stdMm()[i]);
        }
        return worst;
    }
}
