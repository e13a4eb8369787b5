package org.cellgauge.survey;

/**
 * The distance between the centres of two references; immutable.
 *
 * @param from id of one
 * @param to id of the other
 * @param statedMm by their stated places, mm
 * @param mm by the survey, mm
 * @param stdMm its deviation, mm
 */
public record SurveyedDistance(int from, int to, double statedMm, double mm, double stdMm) {
}
