package org.cellgauge.survey;

import org.cellgauge.estimate.PoseEstimate;
import org.jspecify.annotations.Nullable;

/**
 * A photo of a survey; immutable.
 *
 * @param name of the photo
 * @param used whether it is part of the result
 * @param camera pose of the camera in the world; null for a photo that is left out
 * @param markers number of the cell's markers that it shows
 * @param chance of a photo that fits the others this badly or worse, if nothing is wrong; NaN where nothing tells
 */
public record SurveyedPhoto(String name, boolean used, @Nullable PoseEstimate camera, int markers, double chance) {
}
