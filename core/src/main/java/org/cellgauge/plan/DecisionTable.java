package org.cellgauge.plan;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.RigidTransform;

/**
 * What a cell would reach with its references placed so and so precisely, with so many of them, and with all in one
 * plane or one raised: the decision table of the thesis (Table 8.16), for one cell; immutable.
 *
 * @param rows by precision, all in the plane before one raised
 * @param raisedMm how high the raised one is, mm
 */
public record DecisionTable(List<Row> rows, double raisedMm) {
    /** The fewest references that are tried. */
    public static final int LEAST = 2;
    /** The most. */
    public static final int MOST = 6;
    private static final double[] STD_MM = {0.2, 1, 5, 20};
    /** Corners of the rectangle that the references span, opposite ones first, then the middles of its long sides. */
    private static final double[][] ORDER = {{0, 1}, {1, 0}, {1, 1}, {0, 0}, {0.5, 1}, {0.5, 0}};

    /**
     * One precision and arrangement.
     *
     * @param stdMm standard deviation of the placement of every reference along every axis, mm
     * @param raised whether the last of the first four, or the last of fewer, is raised
     * @param worstStdMm largest deviation of any object and gripping point, mm, with two to six references; infinite
     *     where they do not determine it
     */
    public record Row(double stdMm, boolean raised, List<Double> worstStdMm) {
        /**
         * A row.
         *
         * @param worstStdMm copied
         */
        public Row {
            worstStdMm = List.copyOf(worstStdMm);
        }
    }

    /**
     * The table of a cell.
     *
     * @param layout its camera, objects, and references: of these size, plane, turn of the placement and the rectangle
     *     that they span count
     * @param options what to reckon with
     * @return the table
     */
    public static DecisionTable of(Layout layout, PlanOptions options) {
        List<Row> rows = new ArrayList<>();
        double raisedMm = options.maxHeightMm();
        for (double stdMm : STD_MM) {
            for (int raised = 0; raised < (raisedMm > 0 ? 2 : 1); raised++) {
                List<Double> worst = new ArrayList<>();
                for (int count = LEAST; count <= MOST; count++) {
                    worst.add(CellPlanner.forecast(layout.with(arranged(layout.cell(), stdMm, count,
                            raised == 1 ? raisedMm : 0)), options).worstStdMm());
                }
                rows.add(new Row(stdMm, raised == 1, worst));
            }
        }
        return new DecisionTable(List.copyOf(rows), raisedMm);
    }

    private static Cell arranged(Cell cell, double stdMm, int count, double raisedMm) {
        Reference like = cell.references().get(0);
        RigidTransform worldFromPlane = like.worldFromMarker();
        double[] low = {0, 0};
        double[] high = {0, 0};
        for (Reference r : cell.references()) {
            double[] at = worldFromPlane.inverse().apply(r.worldFromMarker().translationMm());
            for (int i = 0; i < 2; i++) {
                low[i] = Math.min(low[i], at[i]);
                high[i] = Math.max(high[i], at[i]);
            }
        }
        List<Reference> references = new ArrayList<>();
        int raised = Math.min(count, 4) - 1;
        int id = 0;
        for (int k = 0; k < count; k++) {
            while (!cell.family().has(id) || isObject(cell, id)) {
                id++;
            }
            references.add(new Reference(id++, like.sizeMm(), worldFromPlane.compose(RigidTransform.ofEuler(
                    low[0] + ORDER[k][0] * (high[0] - low[0]), low[1] + ORDER[k][1] * (high[1] - low[1]),
                    k == raised ? raisedMm : 0, 0, 0, 0)), new Placement(stdMm, stdMm, stdMm,
                            like.placement().stdRad())));
        }
        return cell.withReferences(references);
    }

    private static boolean isObject(Cell cell, int id) {
        return cell.objects().stream().anyMatch(o -> o.id() == id);
    }
}
