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
    /** What it may be instead: each the phrase of a cause. */
    OR_CAUSE("; it may be %s instead"),
    /** More than stated. */
    LARGER("larger"),
    /** Less than stated. */
    SMALLER("smaller"),
    /** Edges seem to lie within the dark. */
    INWARDS("inside"),
    /** Edges seem to lie in the bright. */
    OUTWARDS("outside"),
    /** A focal length of more than stated. */
    LONGER("longer"),
    /** A focal length of less than stated. */
    SHORTER("shorter"),
    /** Positions with more between them than stated. */
    FARTHER_APART("farther apart"),
    /** Positions with less between them than stated. */
    CLOSER_TOGETHER("closer together"),
    /** In place of a size where there are several: as the cell file has it. */
    STATED("stated"),
    /** A cause: all markers are of another size. */
    CAUSE_MARKER_SIZE("the size of all markers"),
    /** A cause: some markers are of another size: ids. */
    CAUSE_SIZE_OF_SOME("the size of markers %s"),
    /** A cause: light moves edges. */
    CAUSE_EDGE_SHIFT("light that moves edges"),
    /** A cause: the focal length. */
    CAUSE_FOCAL_LENGTH("the focal length"),
    /** A cause: the principal point. */
    CAUSE_PRINCIPAL_POINT("the principal point"),
    /** A cause: the distortion of the lens. */
    CAUSE_DISTORTION("the distortion of the lens"),
    /** A cause: positions stretched: world axis. */
    CAUSE_STRETCH("a stretch of positions along %s"),
    /** A cause: all positions scaled. */
    CAUSE_POSITION_SCALE("the scale of all positions"),
    /** A cause: sizes in another unit. */
    CAUSE_SIZE_UNIT("the unit of marker sizes"),
    /** A cause: two ids exchanged: the two. */
    CAUSE_EXCHANGED("references %s exchanged"),
    /** A cause: one marker turned: id, degrees. */
    CAUSE_TURNED("reference %s turned by %s degrees"),
    /** A cause: all markers turned: degrees. */
    CAUSE_ALL_TURNED("all markers turned by %s degrees"),
    /** A cause: a world axis mirrored: its name. */
    CAUSE_MIRRORED("a mirrored %s axis"),
    /** A cause: radians for degrees. */
    CAUSE_RADIANS("rotations in radians"),
    /** A cause: one reference is off: id. */
    CAUSE_REFERENCE("reference %s"),
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
