package org.cellgauge.cell;

import org.cellgauge.internal.cell.CellPhrase;
import org.cellgauge.warning.RefusalKind;

/** Why a cell file, a camera file or any text file cannot be used, or an image not with its cell. */
public enum CellRefusal implements RefusalKind {
    // ---- any text file; what it should be is a CellPhrase

    /** A folder: what it should be. */
    IS_FOLDER("this is a folder; name the %s in it"),
    /** Larger than any such file: largest size, KiB, what it should be. */
    TOO_LARGE("larger than %s KiB, which no %s is; check the name of the file"),
    /** It does not exist: what it should be. */
    NO_SUCH_FILE("there is no such file; check the name and the folder of the %s"),
    /** It may not be read. */
    NOT_PERMITTED("no permission to read this file; allow reading it or copy it elsewhere"),
    /** Reading failed: what it should be, what the system says. */
    NOT_READABLE("the %s cannot be read (%s); check the disk or copy the file elsewhere"),
    /** UTF-16: what it should be. */
    UTF_16("this text is stored as UTF-16; save the %s as UTF-8"),
    /** Neither UTF-8 nor UTF-16: what it should be. */
    NO_UTF_8("this is no text in UTF-8; name a %s, and save it as UTF-8 if it is one"),
    /** It holds a null character: what it should be. */
    BINARY("this is a binary file; name a %s instead"),
    /** Nothing stands in it: what it should be. */
    EMPTY("the file is empty; name a filled %s"),

    // ---- YAML

    /** Limits of the reader: what it says, what the file should be. */
    NOT_YAML("not readable as YAML (%s); check that this is a %s"),
    /** A syntax error: what the reader says. */
    YAML_SYNTAX("not valid YAML (%s); check brackets, quotes, colons and indentation near this place"),
    /** A tab that indents. */
    TAB("a tab stands where YAML allows only spaces; indent with spaces"),
    /** A second document. */
    SECOND_DOCUMENT("a second document begins here; delete \"---\" and keep one document"),
    /** Something else stands here: what was expected, what stands there, what to write, a hint or nothing. */
    EXPECTED("expected %s, got %s; write %s%s"),
    /** Zero or negative: what stands there, what to write. */
    NOT_POSITIVE("must be greater than 0, got %s; write %s"),
    /** A share or probability of 1 or more: what stands there, what to write. */
    NOT_BELOW_ONE("must be less than 1, got %s; write %s"),
    /** Below zero where that means nothing: what stands there, what to write. */
    NEGATIVE("must not be negative, got %s; write %s"),
    /** A whole number out of its range: smallest, largest, what stands there, what to write. */
    OUT_OF_RANGE("must be from %s to %s, got %s; write %s"),
    /** A tag of YAML: its name. */
    TAG("the tag %s is not understood; delete it"),
    /** A list or a mapping in place of a key. */
    KEY_NO_WORD("a key must be one word or number; write key: value"),
    /** A merge key of YAML. */
    MERGE_KEY("merge keys are not understood; write the keys out"),
    /** A key twice: line of the first. */
    TWICE("stands twice, first on line %s; keep one of the two"),
    /** A key that means nothing here: which one may be meant, a hint or nothing. */
    UNKNOWN_KEY("unknown key; %s%s"),
    /** A key that must stand here: what to add. */
    MISSING("is missing; add %s"),

    // ---- cell files

    /** A wall without length or height: what to write. */
    NO_WALL("this wall has no length or no height; write %s"),
    /** A region of what is no object: what stands there. */
    NO_SUCH_OBJECT("%s is no object of this cell; name one below objects:, or delete it"),
    /** A camera file in place of a cell file. */
    IS_CAMERA_FILE("this is a camera file; name a cell file and refer to this one under camera:"),
    /** A detections file in place of a cell file. */
    IS_DETECTIONS_FILE("this is a detections file; name a cell file, and this one as detections"),
    /** The name of the camera file cannot be one: the name, what to write. */
    NO_FILE_NAME("\"%s\" is no file name; write %s"),
    /** The camera file does not exist: its name. */
    NO_CAMERA_FILE("there is no file \"%s\"; write the camera file's path relative to this file, or make one by "
            + "calibrating the camera"),
    /** The camera file cannot be opened: its name, why. */
    CAMERA_FILE_NOT_OPENED("\"%s\": %s"),
    /** The camera file cannot be read as a text: its own refusal. */
    CAMERA_FILE("%s"),
    /** No such family: the name, which one may be meant. */
    NO_FAMILY("there is no marker family \"%s\"; %s"),
    /** A way up that markers have not: the word. */
    NO_ORIENTATION("\"%s\" is no orientation; write opencv where AprilTags are turned as OpenCV draws them, else "
            + "delete this line"),
    /** A marker that is too small: mm. */
    MARKER_TOO_SMALL("a marker of %s mm is too small to be seen; write the outer edge of the black border in mm, not "
            + "in m"),
    /** A length beyond any cell: mm, what to write. */
    TOO_LONG("%s mm is more than a kilometre; write %s"),
    /** A negative deviation: what to write. */
    NEGATIVE_DEVIATION("a deviation is not negative; write %s"),
    /** A deviation of a direction: degrees, largest. */
    DIRECTION_UNKNOWN("a deviation of %s degrees leaves the direction unknown; write at most %s"),
    /** An angle: degrees, what to write. */
    MORE_THAN_A_TURN("an angle of %s degrees is more than a full turn; write %s"),
    /** No reference: what to add. */
    NO_REFERENCE("no reference stands here; add %s"),
    /** A key that may stand here or with each marker stands at neither: the marker's key, its line, what to add. */
    MISSING_AND_NO_OWN("is missing, and %s (line %s) states none of its own; add %s"),
    /** A key that is no id: the key, largest id. */
    NO_ID("\"%s\" is no marker id; write a whole number from 0 to %s without leading zeros"),
    /** An id beyond the family: the family, the id, largest id. */
    ID_NOT_IN_FAMILY("%s has no marker %s; its ids run from 0 to %s"),
    /** A marker that cannot be told from others: id, family. */
    ID_AMBIGUOUS("marker %s of %s looks like another marker or like itself turned; choose another id"),
    /** A marker twice: id, line of the first, its key. */
    MARKER_TWICE("marker %s already stands on line %s as %s; a marker is either a reference or an object, so delete "
            + "one of the two"),
    /** Two references at one place: id and line of one, id of the other, distance, mm. */
    SAME_PLACE("references %s (line %s) and %s would lie on each other, %s mm apart; correct one of the two positions"),
    /** A word that is neither true nor false: the key. */
    NO_YES_OR_NO("%s is true or false; write one of the two"),
    /** A list that is none. */
    NO_LIST("a list stands here; write its entries in [ ] or below each other after \"- \""),
    /** What is no reference: its id. */
    NO_SUCH_REFERENCE("%s is no reference of this cell; name one of its references"),
    /** A reference twice in one list: id. */
    NAMED_TWICE("reference %s is named twice; delete one of the two"),
    /** A reference on two plates: id, the other plate. */
    IN_TWO_GROUPS("reference %s stands in group %s already; a reference is on one plate, so delete one of the two"),
    /** Too few references: how many it takes. */
    TOO_FEW_MEMBERS("needs at least %s references; name more, or delete it"),
    /** A distance between more than two. */
    TWO_ENDS("a distance is between two references; write one entry for each pair"),
    /** No covariance of a survey: of how many references. */
    NO_SURVEY("this is no joint covariance of %s references: it needs six rows and columns for each and must be "
            + "symmetric and positive; survey the cell again"),

    // ---- camera files

    /** A cell file in place of a camera file. */
    IS_CELL_FILE("this is a cell file; name a camera file here"),
    /** An unknown camera model: its name, those that can be used, that of a fisheye. */
    CAMERA_MODEL("the camera model \"%s\" cannot be used; calibrate with the model %s, a fisheye with %s"),
    /** No tone curve: the words, what to write, smallest gamma, largest, {@link CellPhrase#GAMMA_HINT} or nothing. */
    NO_TONE_CURVE("\"%s\" is no tone curve; write %s, G from %s to %s%s"),
    /** Nothing that is a camera: whose files can be read. */
    NO_CAMERA("no camera stands here; name a calibration file of %s"),
    /** Several cameras and no choice: their names, the first of them. */
    SEVERAL_CAMERAS("this file holds several cameras (%s); choose one by its name, for instance %s"),
    /** A camera that the file has not: its name, {@link CellPhrase#ITS_CAMERAS} or {@link CellPhrase#ONE_CAMERA}. */
    NO_SUCH_CAMERA("there is no camera \"%s\" in this file; %s"),
    /** XML that OpenCV does not write. */
    NO_OPENCV_XML("this is not XML as OpenCV writes it; write the file anew with OpenCV's FileStorage, as XML or YAML"),
    /** What is no camera matrix. */
    NO_CAMERA_MATRIX("this is no camera matrix; write its nine numbers fx, 0, cx, 0, fy, cy, 0, 0, 1 row by row"),
    /** A lens of another program that cannot be used: its name, those that can. */
    LENS_OF_ANOTHER("the lens model \"%s\" cannot be used; calibrate with %s"),
    /** A lens whose coefficients go from the image to the direction: its name. */
    LENS_OTHER_WAY_ROUND("the coefficients of \"%s\" lead from the image to the direction, and cannot be turned round; "
            + "calibrate the camera, or use its undistorted image with coefficients of 0"),
    /** As many coefficients as no lens has: how many it takes, how many there are. */
    COEFFICIENTS("expected %s coefficients, got %s; calibrate with a model of as many"),
    /** A tilt of the sensor: rad. */
    TILTED_SENSOR("a sensor that is tilted by %s rad against its lens cannot be used; calibrate without the tilted "
            + "model (in OpenCV without CALIB_TILTED_MODEL)"),
    /** A camera with skew for a program that has none: the program, the skew, px. */
    NO_SKEW_THERE("%s takes no skew, and this camera has one of %s px; calibrate it without"),
    /** A camera with a thin prism for a program that has none: the program. */
    NO_PRISM_THERE("%s has no thin prism, and this camera's lens has one; calibrate it without, or write another form"),
    /** Coefficients of a lens that its model has not: the model to write. */
    DISTORTION_CONTRADICTS_MODEL("lens distortion contradicts model: pinhole; write model: %s or delete this block"),
    /** Too many radial coefficients: how many. */
    TOO_MANY_COEFFICIENTS("expected at most 3 coefficients, got %s; calibrate with 2 or 3 radial coefficients"),
    /** A calibration's parameter that the lens has not, or that stands twice: its name, those of the lens. */
    CALIBRATED_PARAMETER("\"%s\" is no parameter of this lens or stands twice; its parameters are %s"),
    /** What is no covariance: how many parameters it is of. */
    NO_COVARIANCE("this is no covariance of %s parameters: it needs a row and a column for each, must be symmetric and "
            + "positive definite; leave out what is known exactly, or calibrate again"),
    /** The asymmetric part of a fisheye. */
    ASYMMETRIC_LENS("the asymmetric part of this lens model cannot be used; calibrate with the symmetric coefficients "
            + "alone"),
    /** The coefficients of a fisheye's polynomial: how many at most, how many there are, how many at most. */
    SYMMETRIC_COEFFICIENTS("expected 1 to %s coefficients, got %s; calibrate with at most %s symmetric coefficients"),
    /** A polynomial that turns back within the image: degrees off the axis, the pixel there. */
    FISHEYE_TURNS_BACK("with these coefficients the lens shows nothing more than %s degrees off its axis, at pixel "
            + "(%s, %s), so they cannot be right; calibrate again with the target also near the image's borders, or "
            + "with fewer coefficients"),
    /** A focal length that no lens has: px, width and height of the image, px. */
    FOCAL_LENGTH("a focal length of %s px does not go with an image of %s x %s px; write it in px (not in mm), or "
            + "calibrate again"),
    /** Two focal lengths: fx, fy, px. */
    FOCAL_LENGTHS_DIFFER("fx %s and fy %s contradict each other; they are nearly equal for real cameras, check both"),
    /** A principal point far outside: px, {@link CellPhrase#WIDTH} or {@link CellPhrase#HEIGHT}, px. */
    PRINCIPAL_POINT_OUTSIDE("the principal point %s px lies far outside of the image, whose %s is %s px; check both"),
    /** A principal point of an image as wide as this one is high: cx, cy, width and height it fits, px. */
    PRINCIPAL_POINT_TURNED("the principal point (%s, %s) is the middle of an image of %s x %s px: the camera was "
            + "calibrated upright and is used across, or the other way round; calibrate it as it is used"),
    /** A principal point that was left at (0, 0). */
    PRINCIPAL_POINT_ZERO("the principal point (0, 0) is the image's corner; write the calibrated point, which is near "
            + "the image's middle"),
    /** A skew that no camera has: px. */
    SKEW("a skew of %s px is no camera's; write the calibrated value, mostly 0"),
    /** Two directions at one pixel: u, v. */
    DISTORTION_FOLDS("this lens distortion folds the image over near pixel (%s, %s), so the coefficients cannot be "
            + "right; calibrate again with the target also near the image's borders, or with fewer coefficients"),

    // ---- images

    /** An image of another size than calibrated: its width and height, those calibrated, px, what to do. */
    IMAGE_SIZE("the image is %s x %s px, but the camera is calibrated for %s x %s px; %s");

    private final String english;

    CellRefusal(String english) {
        this.english = english;
    }

    @Override
    public String code() {
        return "cell-" + RefusalKind.super.code();
    }

    @Override
    public String english() {
        return english;
    }
}
