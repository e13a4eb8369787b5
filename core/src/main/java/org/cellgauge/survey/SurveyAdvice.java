package org.cellgauge.survey;

import org.cellgauge.warning.Warning;

/**
 * A change that would meet a target which a survey misses, by Laplace's approximation about what it found; immutable.
 *
 * @param change what to do: a {@link org.cellgauge.cell.ChangeKind}, or {@link SurveyWarning#MORE_PHOTOS}
 * @param worstStdMm the largest deviation of any object or gripping point along an axis then, mm
 */
public record SurveyAdvice(Warning change, double worstStdMm) {
}
