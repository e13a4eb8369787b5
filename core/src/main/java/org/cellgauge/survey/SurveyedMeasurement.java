package org.cellgauge.survey;

import org.cellgauge.cell.Measurement;

/**
 * A measurement and how it agrees with everything else; immutable.
 *
 * @param measurement as the cell file has it
 * @param deviations how far it is off what all else says, in standard deviations of that difference; of several
 *     numbers the root of the sum of squares
 * @param chance of as large a difference if nothing is wrong; NaN where nothing else tells
 */
public record SurveyedMeasurement(Measurement measurement, double deviations, double chance) {
}
