package org.cellgauge.cell;

import org.cellgauge.warning.WarningKind;

/** A kind of change of a set-up, with what it costs unless told otherwise. */
public enum ChangeKind implements WarningKind {
    /** All references placed more precisely: largest deviation along an axis, mm; of turns, degrees. */
    PLACE_PRECISELY("place every reference to within %s mm and %s degrees (standard deviations)", 10),
    /** One reference measured again: id; deviations as before. */
    MEASURE_REFERENCE("measure reference %s again, to within %s mm and %s degrees (standard deviations)", 10),
    /** One more reference: size, mm; x, y, z, mm; psi, theta, phi, degrees. */
    ADD_REFERENCE("add a reference of %s mm at (%s, %s, %s) mm, turned by (%s, %s, %s) degrees", 20),
    /** Several more references: each an {@link #ADD_REFERENCE}. */
    ADD_REFERENCES("%s", 20),
    /** A reference off its plane: id, mm. */
    RAISE_REFERENCE("raise reference %s by %s mm", 15),
    /** A reference tilted: id, degrees, axis of the marker. */
    TILT_REFERENCE("tilt reference %s by %s degrees about its %s axis", 15),
    /** Larger markers on objects: factor, new size of the smallest, mm. */
    LARGER_OBJECT_MARKERS("print the markers on objects %s times as large (%s mm)", 5),
    /** Larger references: factor, new size of the smallest, mm. */
    LARGER_REFERENCE_MARKERS("print the references %s times as large (%s mm)", 5),
    /** The camera nearer, along its line of sight: x, y, z, mm; share of the distance, %. */
    CAMERA_CLOSER("move the camera closer, to (%s, %s, %s) mm: %s %% of the distance", 10),
    /** The camera looks from the side: x, y, z, mm; degrees off where it is. */
    CAMERA_ASLANT("let the camera look from (%s, %s, %s) mm, %s degrees aslant", 15),
    /** A longer lens: focal length, px; factor. */
    LONGER_LENS("take a lens of %s px focal length, %s times as long", 60),
    /** More pixels in the same field of view: width and height, px. */
    MORE_PIXELS("take a camera of %s x %s px with the same field of view", 120),
    /** A plate with four references: size, mm; distance from one to the next, mm; x, y, z of its middle, mm. */
    ADD_PLATE("add a plate with four references of %s mm, %s mm apart, its middle at (%s, %s, %s) mm", 30),
    /** A distance between references that is measured: ids; standard deviation, mm. */
    MEASURE_DISTANCE("measure the distance between references %s and %s to within %s mm (standard deviation)", 5),
    /** More photos while nothing moves: from where, mm. */
    MORE_PHOTOS("take one more photo from each of %s mm while nothing moves", 3),
    /** A calibration in place of unknown intrinsics. */
    CALIBRATE("calibrate the camera", 30);

    private final String english;
    private final double usualCost;

    ChangeKind(String english, double usualCost) {
        this.english = english;
        this.usualCost = usualCost;
    }

    @Override
    public String english() {
        return english;
    }

    /**
     * What it costs unless told otherwise.
     *
     * @return minutes of work, for each marker that has to be touched; for a lens or a camera, as much as it is worth
     */
    public double usualCost() {
        return usualCost;
    }
}
