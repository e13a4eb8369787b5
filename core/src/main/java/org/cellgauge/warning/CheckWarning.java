package org.cellgauge.warning;

import org.cellgauge.internal.warning.CheckPhrase;

/** What a check warns of. */
public enum CheckWarning implements WarningKind {
    /** Another sampler took over: {@link CheckPhrase#MISFIT}. */
    FAR_FROM_GAUSSIAN("the posterior is far from Gaussian (%s): adaptive Metropolis was used instead of independence"),
    /** Objects of the cell that the photo does not show: ids. */
    OBJECTS_NOT_SEEN("not seen in the photo: object %s"),
    /** A principal point away from the image's middle: cx, cy, width, height, px, largest usual share of a side, %. */
    PRINCIPAL_POINT_OFF("the camera's principal point (%s, %s) px is far from the middle of the image of %s x %s px "
            + "(by more than %s %% of a side): as it must be where images are cut out of larger ones, and else a "
            + "mistake in cx or cy"),
    /** References of the cell that the photo does not show: ids. */
    REFERENCES_NOT_SEEN("not seen in the photo: reference %s"),
    /** Small markers: each a {@link CheckPhrase#SMALL_MARKER}, side that is too small, px, advised side, px. */
    SMALL_MARKERS("small in the image: marker %s; below %s px of side corners get imprecise and markers are missed, "
            + "plan for %s px: larger markers or a closer camera"),
    /** The corner noise is neither stated nor told by the detector: its median, px, and where 95 % of it lie, px. */
    CORNER_NOISE_ESTIMATED("pixel_std_px is not stated: corners of this photo are good to %s px as far as it tells, "
            + "and with 95 %% to between %s and %s px"),
    /** A marker whose corners fit no square: its id, how many times worse than the others. */
    MARKER_SET_ASIDE("the corners of marker %s fit no square: %s times worse than those of the others; it counts for "
            + "little until they do (is it covered, smudged, bent, or has it a glint?)"),
    /** Corners are not as precise as stated: how many times noisier, stated deviation, px, deviation shown, px. */
    NOISIER_THAN_STATED("corners are %s times noisier than the stated %s px, by how square markers are: figures "
            + "promise too much; state pixel_std_px: %s, or leave pixel_std_px out"),
    /** The corners of one marker are not as precise as stated: its id, how many times noisier, stated deviation, px. */
    MARKER_NOISIER_THAN_STATED("the corners of marker %s fit no square: they are %s times noisier than the stated %s "
            + "px, and those of the others are not (is it covered, smudged, bent, or has it a glint?)"),
    /** The corners of one marker fit no square, by what the others say of the noise: its id, how many times worse. */
    MARKER_NO_SQUARE("the corners of marker %s fit no square: %s times worse than those of the others, which no noise "
            + "that these leave open explains; no target counts as met until they do"),
    /** Two markers in one place of the photo: ids. */
    MARKERS_IN_ONE_PLACE("markers %s and %s are seen in one place, where at most one of them can be: one is misread, "
            + "or the detections are not of one photo"),
    /** Two references in one place of the cell file: ids. */
    REFERENCES_IN_ONE_PLACE("the cell file has references %s and %s in one place, where at most one of them can be: "
            + "correct the position of one"),
    /** References together fit worse than stated: how many times, chi-square, degrees of freedom. */
    REFERENCES_DO_NOT_FIT("the references together fit %s times worse than their stated precision and corner noise let "
            + "expect (chi-square %s of %s), and no single one stands out: measure their positions again, or state a "
            + "placement that they keep"),
    /** References whose turn is stated too loosely for the model: ids, largest figure, figure it holds up to. */
    TURNS_TOO_LOOSE("reference %s may be turned farther than the model can follow (side in px times squared turn in "
            + "rad over corner noise in px is up to %s, and the model holds to about %s): figures may be off; state a "
            + "smaller std_deg after measuring how it is mounted"),
    /** References whose places are stated loosely: ids, largest deviation as a share of the distance, %. */
    PLACES_WIDE("reference %s may stand off by up to %s %% of its distance from the camera, as stated: what the result "
            + "says is that uncertain, and rests on nothing else; measure the place"),
    /**
     * Chains do not confirm Laplace's approximation: by what they differ most, for which coordinate; how many times as
     * large the deviation is, by how many deviations the mean is off.
     */
    CHAINS_APART("chains and Laplace's approximation are apart: the standard deviation of %s is %s times as large, its "
            + "mean %s deviations off; the photo leaves too much open for a model that is linear in placement errors: "
            + "state smaller placement deviations, or add references"),
    /** A reference that no pose explains along with the others: id. */
    REFERENCE_LEFT_OUT("reference %s is left out: its corners are nowhere near where the other references put it; "
            + "check its id and position in the cell file"),
    /**
     * All markers of another size: by how much, %, {@link CheckPhrase#LARGER} or smaller, stated size
     * ({@link CheckPhrase#STD_MM} or {@link CheckPhrase#STATED}), deviation, %, {@link CheckPhrase#OR_CAUSE} or
     * nothing.
     */
    AS_IF_MARKERS("as if all markers were %s %% %s than %s (give or take %s %%): measure the black square of a print "
            + "and state that as size_mm%s"),
    /** Some markers of another size: their ids, and as of all. */
    AS_IF_SOME_MARKERS("as if markers %s were %s %% %s than %s (give or take %s %%): measure their black squares and "
            + "state that as size_mm%s"),
    /** Edges that lie off: px, deviation, px, {@link CheckPhrase#INWARDS} or outwards, what it may be instead. */
    AS_IF_EDGES("as if the edges of all markers were seen %s px (give or take %s px) too far %s: see to light, focus "
            + "and contrast, or state the camera's tone_curve%s"),
    /** Another focal length: %, {@link CheckPhrase#LONGER} or shorter, deviation, %, what it may be instead. */
    AS_IF_FOCAL_LENGTH("as if the focal length were %s %% %s than in the camera file (give or take %s %%): calibrate "
            + "the camera again, with this focus and image size%s"),
    /** Another principal point: px in x, in y, deviation, px, what it may be instead. */
    AS_IF_PRINCIPAL_POINT("as if the principal point were off by (%s, %s) px (give or take %s px): see whether images "
            + "are cropped or turned against the calibration, or calibrate the camera again%s"),
    /** Another distortion: change of the first radial coefficient, deviation, what it may be instead. */
    AS_IF_DISTORTION("as if the lens's first radial coefficient were off by %s (give or take %s): calibrate the camera "
            + "again%s"),
    /**
     * Positions stretched along one axis: its name, %, {@link CheckPhrase#FARTHER_APART} or closer together, deviation,
     * %, what it may be instead.
     */
    AS_IF_STRETCHED("as if all positions along %s were %s %% %s than stated (give or take %s %%): compare the drawing "
            + "with a length measured in the cell%s"),
    /** All positions scaled: factor, what it may be instead. */
    AS_IF_SCALED("as if all positions were %s times those stated: compare the drawing with a length measured in the "
            + "cell%s"),
    /** Positions in another unit: how many mm it has, what it may be instead. */
    POSITIONS_IN_ANOTHER_UNIT("positions of references seem to be in a unit of %s mm: state position_mm in "
            + "millimetres%s"),
    /** Sizes in another unit: how many mm it has, what it may be instead. */
    SIZES_IN_ANOTHER_UNIT("sizes of markers seem to be in a unit of %s mm: state size_mm in millimetres%s"),
    /** Two references exchanged: their ids, what it may be instead. */
    REFERENCES_EXCHANGED("references %s seem exchanged: each stands where the cell file has the other; exchange their "
            + "ids or their markers%s"),
    /** One reference turned about its normal: its id, degrees counter-clockwise, what it may be instead. */
    REFERENCE_TURNED_ABOUT("reference %s seems turned by %s degrees (counter-clockwise as one looks at it): turn the "
            + "marker, or state its rotation_deg%s"),
    /** All markers turned about their normals: degrees counter-clockwise, what it may be instead. */
    ALL_TURNED_ABOUT("all references seem turned by %s degrees (counter-clockwise as one looks at them): see which way "
            + "up they are, and in which order the detector reports corners (OpenCV draws AprilTags turned by half a "
            + "turn)%s"),
    /** A world axis mirrored: its name, what it may be instead. */
    AXIS_MIRRORED("the %s axis of the world seems to point the other way: change the sign of the references' "
            + "positions along it, or exchange two axes, so that x, y and z are right-handed%s"),
    /** Rotations in radians: what it may be instead. */
    ROTATIONS_IN_RADIANS("rotations of references seem to be in radians: state rotation_deg in degrees%s"),
    /** One reference stands far off: its id, what it may be instead. */
    REFERENCE_ELSEWHERE("reference %s stands nowhere near where the other references put it: check its id and position "
            + "in the cell file%s"),
    /** No pose makes sense of the references, and nothing explains it. */
    REFERENCES_CONTRADICT("the references contradict each other: no camera pose fits them, and no single cause "
            + "explains it; compare ids, positions, rotations and sizes in the cell file with the cell"),
    /** The initial estimate failed: its name. */
    INITIAL_ESTIMATE_FAILED("the %s estimate found no camera pose; pnp was used instead"),
    /** The photo tells nothing of intrinsics that are estimated: their names. */
    INTRINSICS_NOT_LEARNED("not learned: the photo tells next to nothing of %s, and what is said of it is what was "
            + "taken for known beforehand"),
    /** The result leans on the pose prior: its share, %, {@link CheckPhrase#WEAK_PRIOR}. */
    DIRECTION_OPEN("the references leave a direction of the camera pose open: %s %% of what is known there is the weak "
            + "prior %s; add a reference"),
    /**
     * Too few iterations allowed: how many, the parameter's name, its Monte Carlo error, %, what was asked for, %,
     * {@link CheckPhrase#MORE_ITERATIONS}.
     */
    CAP_REACHED("the chains reached their cap of %s iterations before the precision asked for: the standard deviation "
            + "of %s has a Monte Carlo error of %s %% in place of %s %%; %s"),
    /** Tails too heavy: the parameter's name, its Pareto k, largest k at which deviations are as stated. */
    HEAVY_TAILS("the draws of %s have heavy tails (Pareto k %s, up to %s is well): its standard deviation is less "
            + "precise than its stated Monte Carlo error, and more iterations hardly help; more or better placed "
            + "references do"),
    /**
     * A reference stands off: id, by what (each a {@link CheckPhrase#SHIFT}), its stated deviations (each a
     * {@link CheckPhrase#STD_MM}), {@link CheckPhrase#OR_INSTEAD} or nothing.
     */
    REFERENCE_OFF("reference %s seems off by about %s, which its stated precision (%s) does not allow: measure its "
            + "position again%s"),
    /**
     * A reference is turned: id, by what (each a {@link CheckPhrase#TURN}), its stated deviation
     * ({@link CheckPhrase#STD_DEGREES}), {@link CheckPhrase#OR_INSTEAD} or nothing.
     */
    REFERENCE_TURNED("reference %s seems turned by about %s, which its stated precision (%s) does not allow: check how "
            + "it is mounted%s"),
    /**
     * What leaving out the one misplaced reference changes: its id, what moves most ({@link CheckPhrase#CAMERA},
     * {@link CheckPhrase#OBJECT} or {@link CheckPhrase#GRIP}), by how much in x, y, z, mm,
     * {@link CheckPhrase#MORE_THAN_ANY_OTHER} or nothing, {@link CheckPhrase#LARGEST_DEVIATION} or nothing.
     */
    FIGURES_REST_ON_IT("figures rest on reference %s all the same: without it %s moves by (%s, %s, %s) mm%s%s"),
    /** The same of several: their ids, and so on. */
    FIGURES_REST_ON_THEM("figures rest on references %s all the same: without them %s moves by (%s, %s, %s) mm%s%s"),
    /** Nothing can be said of what hangs on the one misplaced reference. */
    NO_POSE_WITHOUT_IT("without it the other references lead to no camera pose"),
    /** Nothing can be said of what hangs on several misplaced references. */
    NO_POSE_WITHOUT_THEM("without them the other references lead to no camera pose");

    private final String english;

    CheckWarning(String english) {
        this.english = english;
    }

    @Override
    public String english() {
        return english;
    }
}
