package org.cellgauge.placement;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.OptionalInt;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.internal.warning.Listing;

/**
 * What a misplaced reference adds: figures keep it, and if it is misplaced a stated position has a larger error
 * than its deviation; immutable.
 */
public final class Misplacement {
    private final List<Integer> references;
    private final boolean targetMet;
    private final OptionalInt objectId;
    private final boolean grip;
    private final int axis;
    private final double errorMm;

    /**
     * What misplaced references add.
     *
     * @param references marker ids, the worst first, not empty
     * @param targetMet whether the target is met even so
     * @param objectId the object whose stated position is the worst if they are misplaced, or empty
     * @param grip whether its gripping point is meant
     * @param axis 0, 1, 2 for world x, y, z
     * @param errorMm root mean square of what the stated position then is off by, mm
     */
    public Misplacement(List<Integer> references, boolean targetMet, OptionalInt objectId, boolean grip, int axis,
            double errorMm) {
        this.references = Collections.unmodifiableList(new ArrayList<>(references));
        this.targetMet = targetMet;
        this.objectId = objectId;
        this.grip = grip;
        this.axis = axis;
        this.errorMm = errorMm;
    }

    /**
     * The references that seem misplaced.
     *
     * @return marker ids, the worst first, not empty
     */
    public List<Integer> references() {
        return references;
    }

    /**
     * Whether the target is met even so.
     *
     * @return false as well where there is no target
     */
    public boolean targetMet() {
        return targetMet;
    }

    /**
     * The object whose stated position is the worst if they are misplaced.
     *
     * @return its marker id, or empty where no object is in the photo or without them there is no camera pose
     */
    public OptionalInt objectId() {
        return objectId;
    }

    /**
     * Whether the object's gripping point is meant and not the object.
     *
     * @return true for the gripping point
     */
    public boolean grip() {
        return grip;
    }

    /**
     * The world axis of that error.
     *
     * @return 0, 1, 2 for x, y, z
     */
    public int axis() {
        return axis;
    }

    /**
     * The error: root mean square of what the stated position then is off by.
     *
     * @return mm; 0 where no object is in the photo, infinite where without the references there is no camera pose
     */
    public double errorMm() {
        return errorMm;
    }

    /** What it adds to a reason. */
    public String english() {
        String who = "reference " + Listing.and(references) + (references.size() == 1 ? " seems" : " seem")
                + " misplaced";
        String start = targetMet ? " The target is met although " : " But ";
        if (!objectId.isPresent()) {
            return start + who + (errorMm == 0 ? "."
                    : ", and without " + (references.size() == 1 ? "it" : "them") + " there is no camera pose.");
        }
        return start + String.format(Decimal.POINT, "%s: if so, the largest error is %.2f mm in %s of %sobject "
                + "%d.", who, errorMm, "xyz".charAt(axis), grip ? "the gripping point of " : "",
                objectId.getAsInt());
    }
}
