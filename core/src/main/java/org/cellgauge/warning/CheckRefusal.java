package org.cellgauge.warning;

import org.cellgauge.internal.warning.CheckPhrase;

/** Why the markers of a photo cannot be checked. */
public enum CheckRefusal implements RefusalKind {
    /** The tone curve is open, and the photo does not tell it. */
    TONE_CURVE_OPEN("whites are clipped, and then nothing in the photo tells its tone curve, without which edges are "
            + "not where they seem; expose less, or state tone_curve in the cell file"),
    /** No reference is seen: ids. */
    NO_REFERENCE_SEEN("none of the references %s is in the photo; check the marker family of the cell file, the light "
            + "and the focus"),
    /** No reference is left: ids, what the detector says of them. */
    NO_REFERENCE_LEFT("none of the references %s can be used: %s"),
    /** No camera pose fits. */
    NO_CAMERA_POSE("no camera pose explains the corners of the references; check their ids, positions and sizes in the "
            + "cell file"),
    /** No pose of an object fits: id. */
    NO_OBJECT_POSE("the corners of object %s are of no square in front of the camera; check the order of its corners"),
    /**
     * A reference whose place is as good as unknown: its id, stated deviation, mm, the same as a share of the distance,
     * %, distance from the camera, mm, largest share, %.
     */
    PLACE_UNKNOWN("reference %s may stand %s mm off its place (std_mm of all axes together), %s %% of its distance of "
            + "%s mm from the camera: beyond %s %% the model says nothing; measure its place, or leave it out of the "
            + "cell file"),
    /** Nothing is known of the focal length beforehand, and the references cannot tell it. */
    FLAT_FOCAL_IN_PLANE("with nothing known of the focal length beforehand, references in one plane do not tell it: a "
            + "longer one and a camera farther away look alike; state how well it is known, by a field of view of the "
            + "data sheet for instance, or raise a reference out of the plane of the others"),
    /** Nothing is known of the focal length beforehand, and the photo hardly tells it: its deviation, %. */
    FLAT_FOCAL_OPEN("with nothing known of the focal length beforehand, this photo tells it to %s %% only, and there "
            + "is no end to how long it may be; state how well it is known, by a field of view of the data sheet for "
            + "instance, or raise references farther"),
    /** Tangential coefficients are to be estimated of a lens that has none: its model. */
    NO_TANGENTIAL_COEFFICIENTS("a lens of the model %s has no tangential coefficients: leave their prior deviation "
            + "out"),
    /** Chains find no start: why, {@link CheckPhrase#INITIAL_PNP}. */
    CHAINS_CANNOT_START("the chains cannot start, %s; check the references' positions in the cell file or %s");

    private final String english;

    CheckRefusal(String english) {
        this.english = english;
    }

    @Override
    public String english() {
        return english;
    }
}
