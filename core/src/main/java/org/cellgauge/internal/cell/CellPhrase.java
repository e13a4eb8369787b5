package org.cellgauge.internal.cell;

import org.cellgauge.cell.CellRefusal;
import org.cellgauge.warning.RefusalKind;

/** Parts of the sentences of {@link CellRefusal}. */
public enum CellPhrase implements RefusalKind {
    // ---- what a file should be

    /** A cell file. */
    CELL_FILE("cell file"),
    /** A camera file. */
    CAMERA_FILE("camera file"),

    // ---- what was expected, and what stands there

    /** A mapping. */
    MAPPING("a mapping of keys"),
    /** A text. */
    TEXT("a text"),
    /** A number. */
    NUMBER("a number"),
    /** A finite number. */
    FINITE_NUMBER("a finite number"),
    /** A whole number. */
    WHOLE_NUMBER("a whole number"),
    /** Numbers: how many. */
    NUMBERS("%s numbers"),
    /** A list. */
    LIST("a list"),
    /** Nothing. */
    NOTHING("nothing"),
    /** A word as it stands there. */
    WORD("\"%s\""),
    /** A word in quotes. */
    QUOTED("the text \"%s\""),

    // ---- hints

    /** A decimal comma: the number with a point. */
    WITH_POINT(", with a decimal point: %s"),
    /** A unit. */
    WITHOUT_UNIT(", the number alone without its unit"),
    /** Quotes. */
    WITHOUT_QUOTES(", without quotes"),
    /** Decimal commas made several of one. */
    POINT_NOT_COMMA(" (decimal numbers take a point, not a comma)"),
    /** A word like it: the word. */
    DID_YOU_MEAN("did you mean \"%s\"?"),
    /** All that could stand there: words. */
    KNOWN_HERE("known here: %s"),
    /** A power alone: the number. */
    GAMMA_HINT("; for a power write gamma %s"),

    // ---- what to write

    /** The first line. */
    A_CELL_FILE("a cell file, which begins with cellgauge: 1"),
    /** The line of the version: the version. */
    VERSION_LINE("the line cellgauge: %s"),
    /** The version: its number. */
    VERSION("cellgauge: %s, the format of this program"),
    /** The name of a camera file. */
    CAMERA("camera: camera.yaml (a BoofCV calibration file)"),
    /** References. */
    REFERENCES("references:, and below it at least one line such as \"944: {position_mm: [492, 380, 0]}\""),
    /** Objects. */
    OBJECTS("lines such as \"5: {}\" below objects:"),
    /** Angles. */
    ROTATION("[psi, theta, phi] in degrees, from -360 to 360"),
    /** A mapping that may be left out: how to write it. */
    OR_DELETE("%s, or delete it"),
    /** One of two. */
    OBJECT("{} or {grip_mm: [x, y, z]}"),
    /** The target. */
    TARGET_STD("the largest deviation allowed, in mm"),
    /** A tolerance of coordinates. */
    TARGET_TOLERANCE("how far a coordinate may be off, in mm: one number, or [x, y, z]"),
    /** A tolerance of points. */
    TARGET_DISTANCE("how far a point may be off, in mm"),
    /** A tolerance of orientations. */
    TARGET_TURN("how far an object may be turned, in degrees"),
    /** The probability of a tolerance. */
    TARGET_PROBABILITY("the probability of keeping the tolerance, such as 0.95"),
    /** A pose of the camera. */
    CAMERA_POSE("[x, y, z, psi, theta, phi] in mm and degrees"),
    /** How far the camera may be elsewhere. */
    RANGE("how far the camera may be off either way: position_mm: [x, y, z] in mm, turn_deg in degrees, not negative"),
    /** A rectangle. */
    AREA("[x0, y0, x1, y1] in mm, two opposite corners seen from above"),
    /** A wall. */
    WALL("[x0, y0, x1, y1, height] in mm, its ends seen from above and how far it reaches up"),
    /** How far references may be raised. */
    MAX_HEIGHT("how far references may be raised, in mm, 0 for not at all"),
    /** A cost. */
    COST("what the change costs, 0 or more, in minutes of work or any other unit"),
    /** A deviation of prints. */
    SIZE_STD("the deviation of printed sizes in mm, such as 0.1"),
    /** A deviation of prints. */
    FLATNESS_STD("the deviation of corners off their marker's plane in mm, such as 0.2"),
    /** A deviation of prints. */
    PRINT_GAIN_STD("the deviation of how far ink spreads in mm, such as 0.05"),
    /** A reference that is named. */
    REFERENCE_ID("the id of a reference of this cell"),
    /** A length. */
    LENGTH("a length in mm"),
    /** The size of a marker. */
    MARKER_SIZE("the outer edge of the black border in mm"),
    /** The key of the size of a marker. */
    MARKER_SIZE_KEY("size_mm: 47 (outer edge of the black border)"),
    /** Deviations of a position. */
    PLACEMENT_STDS("[x, y, z] in mm, each greater than 0, such as [5, 5, 5]"),
    /** One of them. */
    PLACEMENT_STD("a deviation in mm; for an exactly placed marker a small one such as 0.01"),
    /** A deviation of an orientation. */
    TURN_STD("a deviation in degrees; for an exactly turned marker a small one such as 0.01"),
    /** A deviation of corners. */
    PIXEL_STD("the deviation of a corner in px, such as 0.3, or auto"),

    /** The keys of a camera. */
    CAMERA_KEYS("the keys of a BoofCV calibration file: model: pinhole_radial_tangential, %s"),
    /** The cameras of a file: their names. */
    ITS_CAMERAS("it holds %s"),
    /** A file without names. */
    ONE_CAMERA("it holds one camera without a name, so leave the name out"),
    /** The first coefficient of a fisheye's polynomial. */
    COEFFICIENT_OF_ANGLE("the coefficient of the angle itself, mostly 1"),
    /** Another of them. */
    SYMMETRIC("a symmetric coefficient"),
    /** A coefficient of another part. */
    COEFFICIENT("a coefficient, mostly 0"),
    /** An entry of a covariance. */
    VARIANCE("a variance or covariance of two parameters"),
    /** Photos of a calibration. */
    PHOTOS_OF_CALIBRATION("the number of photos that it rests on"),
    /** How the lens was focused at calibration. */
    FOCUS_DISTANCE("the distance in m that the lens was focused at when the camera was calibrated"),
    /** The version of BoofCV's format. */
    BOOFCV_VERSION("version: 0, or calibrate with a BoofCV of that version"),
    /** A tone curve. */
    TONE_CURVE("auto, srgb, linear or gamma G (for instance gamma 2.2, then grey = light^(1/2.2))"),
    /** A focal length. */
    FOCAL_LENGTH("the focal length in px"),
    /** The principal point. */
    PRINCIPAL_POINT("the principal point in px"),
    /** The skew. */
    SKEW("the skew in px, mostly 0"),
    /** The width that is missing. */
    IMAGE_WIDTH("the image width in px"),
    /** The height that is missing. */
    IMAGE_HEIGHT("the image height in px"),
    /** The width. */
    CALIBRATED_WIDTH("the width in px of the images that the camera was calibrated with"),
    /** The height. */
    CALIBRATED_HEIGHT("the height in px of the images that the camera was calibrated with"),
    /** A coefficient. */
    RADIAL("a radial coefficient"),
    /** A coefficient. */
    TANGENTIAL("a tangential coefficient, mostly 0"),

    // ---- sizes of images

    /** A side. */
    WIDTH("width"),
    /** A side. */
    HEIGHT("height"),
    /** Width and height are swapped. */
    IMAGE_TURNED("the image is turned, by hand or by its EXIF orientation; store it as the camera took it"),
    /** Another size of the same shape. */
    IMAGE_SCALED("the image is scaled or binned; take it in the calibrated size, or calibrate the camera in this "
            + "size"),
    /** A photo of another size. */
    PHOTO_SIZE("take the photo at that size or calibrate the camera at this one"),
    /** Frames of another size. */
    CAMERA_OF_THIS_SIZE("give the cell the camera of this image size"),
    /** Another shape. */
    OTHER_SIZE("it is cut, or the camera was in another mode, which may show another part of the world; take it in the "
            + "calibrated size, or calibrate the camera in this size");

    private final String english;

    CellPhrase(String english) {
        this.english = english;
    }

    @Override
    public String english() {
        return english;
    }
}
