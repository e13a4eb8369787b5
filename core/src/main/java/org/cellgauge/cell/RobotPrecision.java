package org.cellgauge.cell;

/**
 * How well a robot that touches references knows itself: errors that all its touched points share; immutable.
 *
 * @param base where its base stands in the world: shift along world axes, turn about the world's origin
 * @param toolStdMm deviation of each coordinate of its tool centre point in the tool's frame, mm, not negative
 */
public record RobotPrecision(Placement base, double toolStdMm) {
}
