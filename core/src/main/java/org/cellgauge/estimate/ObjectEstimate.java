package org.cellgauge.estimate;

import java.util.Collections;
import java.util.List;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.statistics.Ellipse;
import org.jspecify.annotations.Nullable;

/** What a check says of one object; immutable. */
public final class ObjectEstimate {
    private final ObjectMarker marker;
    private final PoseEstimate pose;
    private final @Nullable PointEstimate grip;
    private final VarianceBudget budget;
    private final @Nullable VarianceBudget gripBudget;
    private final @Nullable Ellipse ellipse95Px;
    private final @Nullable Ellipse gripEllipse95Px;
    private final List<ModeEstimate> modes;

    /**
     * An estimate.
     *
     * @param marker the object as the cell file has it
     * @param pose in the world
     * @param grip its gripping point in the world; null where it has none
     * @param budget shares of the position's variance
     * @param gripBudget shares of the gripping point's; null where it has none
     * @param ellipse95Px 95 % of positions in the image, px; null where it cannot be drawn
     * @param gripEllipse95Px the same of the gripping point; null where it has none
     * @param modes heaviest first, not empty; kept
     */
    public ObjectEstimate(ObjectMarker marker, PoseEstimate pose, @Nullable PointEstimate grip,
            VarianceBudget budget, @Nullable VarianceBudget gripBudget, @Nullable Ellipse ellipse95Px,
            @Nullable Ellipse gripEllipse95Px, List<ModeEstimate> modes) {
        this.marker = marker;
        this.pose = pose;
        this.grip = grip;
        this.budget = budget;
        this.gripBudget = gripBudget;
        this.ellipse95Px = ellipse95Px;
        this.gripEllipse95Px = gripEllipse95Px;
        this.modes = Collections.unmodifiableList(modes);
    }

    /**
     * The object as the cell file has it.
     *
     * @return id, size, gripping point
     */
    public ObjectMarker marker() {
        return marker;
    }

    /**
     * Marker id.
     *
     * @return the id
     */
    public int id() {
        return marker.id();
    }

    /**
     * Pose in the world.
     *
     * @return mean and covariance over all modes
     */
    public PoseEstimate pose() {
        return pose;
    }

    /**
     * Gripping point in the world.
     *
     * @return its estimate, or null where the cell file gives none
     */
    public @Nullable PointEstimate grip() {
        return grip;
    }

    /**
     * Where the variance of the position comes from.
     *
     * @return shares by source, from the linearised model at the mode
     */
    public VarianceBudget budget() {
        return budget;
    }

    /**
     * Where the variance of the gripping point comes from.
     *
     * @return shares by source, or null where no gripping point is given
     */
    public @Nullable VarianceBudget gripBudget() {
        return gripBudget;
    }

    /**
     * The 95 % region of the position, projected into the image by the mean camera.
     *
     * @return in px, or null where the mean position is not in front of the camera
     */
    public @Nullable Ellipse ellipse95Px() {
        return ellipse95Px;
    }

    /**
     * The 95 % region of the gripping point, projected into the image.
     *
     * @return in px, or null where there is none
     */
    public @Nullable Ellipse gripEllipse95Px() {
        return gripEllipse95Px;
    }

    /**
     * The poses that explain the object's corners.
     *
     * @return one mode, or two where the object's pose is ambiguous, heavier first
     */
    public List<ModeEstimate> modes() {
        return modes;
    }

    /**
     * Largest standard deviation on any axis of position and gripping point.
     *
     * @return mm
     */
    public double worstStdMm() {
        double worst = 0;
        for (int axis = 0; axis < 3; axis++) {
            worst = Math.max(worst, pose.std()[axis]);
            if (grip != null) {
                worst = Math.max(worst, grip.stdMm()[axis]);
            }
        }
        return worst;
    }
}
