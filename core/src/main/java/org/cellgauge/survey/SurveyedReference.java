package org.cellgauge.survey;

import org.cellgauge.cell.Reference;
import org.cellgauge.estimate.PoseEstimate;

/**
 * A reference and where it stands; immutable.
 *
 * @param stated as the cell file has it
 * @param pose where it stands in the world, with the covariance that photos and all that is stated leave
 * @param photos how many photos show it
 * @param offMm distance from where it is stated to stand, mm
 * @param chance of an error as large in units of what is stated, if it was placed as stated; NaN where photos tell
 *     nothing of it
 * @param misplaced whether it does not stand as stated; its place is taken from photos alone then
 */
public record SurveyedReference(Reference stated, PoseEstimate pose, int photos, double offMm, double chance,
        boolean misplaced) {
}
