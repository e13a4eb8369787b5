package org.cellgauge.internal.warning;

import org.cellgauge.warning.CheckRefusal;
import org.cellgauge.warning.CheckWarning;
import org.cellgauge.warning.WarningKind;

/** Parts of the sentences of {@link CheckWarning} and {@link CheckRefusal}. */
public enum CheckPhrase implements WarningKind {
    /** What shows that chains would hardly move: efficiency of importance sampling, %, accepted steps, %. */
    MISFIT("importance efficiency %s %%, acceptance %s %%"),
    /** A marker that is small in the image: id, shortest side, px. */
    SMALL_MARKER("%s (%s px)"),
    /** A place in the image: u, v, px. */
    PLACE("(%s, %s)"),
    /** The prior of the camera pose: deviations of position, mm, and orientation, rad. */
    WEAK_PRIOR("N(initial estimate, %s mm, %s rad)"),
    /** A shift: mm, world axis. */
    SHIFT("%s mm along %s"),
    /** A turn: degrees, world axis. */
    TURN("%s degrees about %s"),
    /** A deviation of a position: mm. */
    STD_MM("%s mm"),
    /** A deviation of an orientation: degrees. */
    STD_DEGREES("%s degrees"),
    /** Another reference may be the one that is off: ids. */
    OR_INSTEAD("; it may be reference %s instead"),
    /** The camera moves most. */
    CAMERA("the camera"),
    /** An object moves most: id. */
    OBJECT("object %s"),
    /** The gripping point of an object moves most: the object's id. */
    GRIP("the gripping point of object %s"),
    /** Other objects move less. */
    MORE_THAN_ANY_OTHER(", more than any other"),
    /** The largest deviation, mm, of any object or gripping point: without the misplaced references, with them. */
    LARGEST_DEVIATION(", and the largest deviation is %s mm instead of %s mm"),
    /** A remedy for chains that were too short. */
    MORE_ITERATIONS("allow more iterations"),
    /** A remedy for a start that leads nowhere. */
    INITIAL_PNP("take pnp as the initial estimate"),
    /** Why chains cannot start: the log density there. */
    DENSITY_AT_START("the density is %s at the start of the chain");

    private final String english;

    CheckPhrase(String english) {
        this.english = english;
    }

    @Override
    public String english() {
        return english;
    }
}
