package org.cellgauge.internal.overlay;

/** What a shape of an overlay stands for; a painter maps it to colours. */
public enum Role {
    /** A line of the grid on the world's plane z = 0. */
    WORLD_GRID,
    /** The world's x axis, its arrow head and name. */
    WORLD_AXIS_X,
    /** The world's y axis, its arrow head and name. */
    WORLD_AXIS_Y,
    /** The world's z axis, its arrow head and name. */
    WORLD_AXIS_Z,
    /** Outline of a reference as it was detected. */
    REFERENCE_OUTLINE,
    /** Outline of a reference where the estimated camera pose and its nominal place put it. */
    REFERENCE_EXPECTED,
    /** Outline of a detected marker that the cell file does not name. */
    FOREIGN_OUTLINE,
    /** Outline of an object as it was detected. */
    OBJECT_OUTLINE,
    /** Outline of an object by one of several poses that explain its corners. */
    OBJECT_MODE,
    /** x axis of an object's marker. */
    OBJECT_AXIS_X,
    /** y axis of an object's marker. */
    OBJECT_AXIS_Y,
    /** z axis of an object's marker, out of its face. */
    OBJECT_AXIS_Z,
    /** 95 % ellipse of an object's position, magnified as {@link Overlay#magnification()} says. */
    OBJECT_ELLIPSE,
    /** Line from an object's marker to its gripping point. */
    GRIP_LINE,
    /** Cross at a gripping point. */
    GRIP_POINT,
    /** 95 % ellipse of a gripping point, magnified as {@link Overlay#magnification()} says. */
    GRIP_ELLIPSE,
    /** Line from a label to what it names, where they are apart. */
    LEADER,
    /** Text beside a marker, its panel and its mark. */
    LABEL,
    /** The verdict in words, its panel and its mark. */
    BANNER,
    /** The explanation of what is drawn: its panel and its text. */
    LEGEND
}
