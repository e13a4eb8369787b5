package org.cellgauge.vision;

import org.cellgauge.internal.warning.CheckPhrase;
import org.cellgauge.warning.WarningKind;

/** What a detector has to say of the markers of an image. Places are the centres of markers, px. */
public enum DetectionWarning implements WarningKind {
    /** Cells are of no marker of the cell: id as it was read at first, u, v. */
    CELLS_DO_NOT_MATCH("what looks like marker %s at (%s, %s) px is left out: its cells do not match; if it is that "
            + "marker, use a larger one, a closer camera, a sharper image or more light"),
    /** A marker without a checksum whose edges cannot be fitted: id, u, v. */
    EDGES_NOT_MEASURED("what looks like marker %s at (%s, %s) px is left out: its edges cannot be measured; if it is "
            + "that marker, use a larger one, a closer camera, a sharper image or more light"),
    /** No pose of a square explains the corners: id, u, v, what they miss it by, px, the limit, px. */
    NOT_SQUARE("marker %s at (%s, %s) px is left out: its corners miss those of a square by %s px (limit %s); look for "
            + "something that covers or bends it, or for another pattern taken for it"),
    /** One id at several places: id, how many, the places as {@link CheckPhrase#PLACE}. */
    SEEN_TWICE("marker %s is seen at %s places, %s px, and is left out; an id may stand only once in view: remove or "
            + "cover the others"),
    /** The edges cannot be fitted, and the corners are those of the first look: id. */
    COARSE_CORNERS("marker %s: its edges are too blurred, short or covered to be measured finely; its corners are "
            + "coarse"),
    /** Light is cut off above: share of the pixels beside markers' edges that are at the brightest value, percent. */
    WHITES_CLIPPED("whites are clipped: %s %% of the pixels beside the markers' edges are at the brightest value, "
            + "where light is not measured; expose less"),
    /** Light is cut off above at one marker alone: id, share of the pixels beside one of its sides, percent. */
    GLARE("marker %s glares: %s %% of the pixels beside one of its sides are at the brightest value, and of the other "
            + "markers they are not; tilt the camera, or turn the lamp that it mirrors away"),
    /** Light is cut off below: share of the pixels beside markers' edges that are at the darkest value, percent. */
    BLACKS_CRUSHED("blacks are crushed: %s %% of the pixels beside the markers' edges are at the darkest value, "
            + "where light is not measured; expose more, or lower the contrast in the camera"),
    /** An unsharp mask was at work: overshoot in percent of the step from black to white. */
    SHARPENED("the photo is sharpened: grey values overshoot by %s %% of the step at the markers' edges; switch "
            + "sharpening off in the camera"),
    /** Grey values went through a strongly compressed file. */
    IN_BLOCKS("the photo is compressed so much that the blocks of its JPEG file show, which moves edges; save it at a "
            + "higher quality"),
    /** Cells run into each other: id, blur (standard deviation), px, side of a cell, px. */
    TOO_BLURRED("marker %s is left out: a blur of %s px is too much for cells of %s px; focus, hold still or come "
            + "nearer"),
    /** Noise and steps of grey are large against the markers' contrast: grey value of white. */
    TOO_DARK("the markers' white is only %s of 255, so that noise and steps of grey weigh heavily; give more light or "
            + "expose longer"),
    /** Noise and steps of grey are large against the contrast of a pale print: grey values of black and of white. */
    FAINT("the markers are faint: their black is %s and their white %s of 255, so that noise and steps of grey weigh "
            + "heavily; print them darker, or take away what dulls them"),
    /** The margin is not seen white: id, by how much the code's white is brighter, percent. */
    MARGIN_TOO_THIN("marker %s: its white margin is too thin to be measured (the white of its code is %s %% brighter), "
            + "so that where its sides lie is in doubt; print it with a margin of a fifth of its side"),
    /** A shadow or a reflection lies on a marker: id, change of the light on its white, percent. */
    LIGHT_UNEVEN("marker %s: the light on its white changes by %s %% from one side to another; light it evenly, "
            + "without shadows and reflections"),
    /** Markers of the cell, white and black exchanged: ids. */
    INVERTED("printed white on black: marker %s; print black markers on white paper"),
    /** Markers of the cell as a mirror shows them: ids. */
    MIRRORED("mirrored: marker %s; switch the mirror image of the camera off, or print them the right way round"),
    /** Markers of the cell's family that the cell does not name: ids. */
    OTHER_IDS("in view, but not in the cell file: marker %s; check the ids of the cell file"),
    /** Markers of another family: how many, the family, ids, the cell's family. */
    OTHER_FAMILY("in view are %s markers of the family %s (%s), and the cell file says %s; write the family that is "
            + "printed"),
    /** Nothing can be seen: grey value that 99 % of the pixels do not exceed. */
    NEARLY_BLACK("the image is nearly black: 99 %% of it is at most %s of 255; give more light or expose longer"),
    /** Nothing can be seen: grey value that 99 % of the pixels exceed. */
    NEARLY_WHITE("the image is nearly white: 99 %% of it is at least %s of 255; give less light or expose less"),
    /** Nothing is sharp: blur (standard deviation) of the sharpest edges, px. */
    BLURRED("the image is blurred: even its sharpest edges are smeared by %s px; focus, hold still");

    private final String english;

    DetectionWarning(String english) {
        this.english = english;
    }

    @Override
    public String english() {
        return english;
    }
}
