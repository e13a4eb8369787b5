package org.cellgauge.survey;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.JointPlacement;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
import org.cellgauge.cell.SurveyedPlacement;
import org.cellgauge.warning.Warning;
import org.jspecify.annotations.Nullable;

/**
 * What many photos of one cell say; immutable.
 *
 * @param cell as it is stated
 * @param photos all that were given, in their order
 * @param references all of the cell, in its order
 * @param objects those that stand still and were seen, in the order of the cell
 * @param measurements all of the cell, in its order
 * @param placement joint covariance of all references about their poses here: shifts and turns in world axes
 * @param epoch where everything is by Laplace's approximation, for later surveys to be held against
 * @param advice what would meet the target where it is missed, cheapest first; empty where it is met, and where nothing
 *     that is tried does
 * @param run how draws came about; null where figures are those of Laplace's approximation
 * @param warnings what users should know
 */
public record SurveyResult(Cell cell, List<SurveyedPhoto> photos, List<SurveyedReference> references,
        List<SurveyedObject> objects, List<SurveyedMeasurement> measurements, SurveyedPlacement placement,
        Epoch epoch, List<SurveyAdvice> advice, @Nullable SurveyRun run, List<Warning> warnings) {
    private static final int ERRORS = SurveyedPlacement.ERRORS;

    /** Copies the lists. */
    public SurveyResult {
        photos = List.copyOf(photos);
        references = List.copyOf(references);
        objects = List.copyOf(objects);
        measurements = List.copyOf(measurements);
        advice = List.copyOf(advice);
        warnings = List.copyOf(warnings);
    }

    /**
     * Number of photos that the result rests on.
     *
     * @return at least 1
     */
    public int used() {
        return (int) photos.stream().filter(SurveyedPhoto::used).count();
    }

    /**
     * The cell with its references where they were found, and how well that is known of all of them together.
     *
     * @return a cell for checks of later photos
     */
    public Cell surveyedCell() {
        List<Reference> found = new ArrayList<>();
        for (SurveyedReference r : references) {
            double[] std = r.pose().std();
            double[][] tangent = r.pose().tangentCovariance();
            double turn = Math.sqrt((tangent[3][3] + tangent[4][4] + tangent[5][5]) / 3);
            found.add(new Reference(r.stated().id(), r.stated().sizeMm(), r.pose().meanTransform(),
                    new Placement(std[0], std[1], std[2], turn)));
        }
        return cell.withReferences(found)
                .withJointPlacement(new JointPlacement(List.of(), List.of(), null, placement));
    }

    /**
     * The distance between two references.
     *
     * @param from id of one
     * @param to id of another
     * @return with its deviation, in which what both have in common is no part
     * @throws IllegalArgumentException if the cell has no such references, or they are the same
     */
    public SurveyedDistance distance(int from, int to) {
        int a = placement.ids().indexOf(from);
        int b = placement.ids().indexOf(to);
        if (a < 0 || b < 0 || a == b) {
            throw new IllegalArgumentException("no two references: " + from + ", " + to);
        }
        double[] p = references.get(a).pose().meanTransform().translationMm();
        double[] q = references.get(b).pose().meanTransform().translationMm();
        double[] d = {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
        double mm = Math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        double[] s = references.get(a).stated().worldFromMarker().translationMm();
        double[] t = references.get(b).stated().worldFromMarker().translationMm();
        double stated = Math.sqrt((t[0] - s[0]) * (t[0] - s[0]) + (t[1] - s[1]) * (t[1] - s[1])
                + (t[2] - s[2]) * (t[2] - s[2]));
        double[] covariance = placement.covariance();
        int n = ERRORS * placement.ids().size();
        double variance = 0;
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                int ai = ERRORS * a + i;
                int aj = ERRORS * a + j;
                int bi = ERRORS * b + i;
                int bj = ERRORS * b + j;
                variance += d[i] * d[j] / (mm * mm) * (covariance[ai * n + aj] - covariance[ai * n + bj]
                        - covariance[bi * n + aj] + covariance[bi * n + bj]);
            }
        }
        return new SurveyedDistance(from, to, stated, mm, Math.sqrt(Math.max(0, variance)));
    }
}
