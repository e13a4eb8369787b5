package org.cellgauge.plan;

import java.util.List;

/**
 * What a photo of a layout would tell: deviations of every object and gripping point; immutable.
 *
 * @param rows in the order of the cell, the gripping point of an object after its own
 * @param references ids of the references that would be seen from everywhere the camera may stand
 * @param unseen ids of objects that would not be seen somewhere, of which nothing is known then
 */
public record Forecast(List<Row> rows, List<Integer> references, List<Integer> unseen) {
    /** What could be asked of {@link Row#axis}. */
    public static final int AXES = 3;

    /**
     * A forecast.
     *
     * @param rows copied
     * @param references copied
     * @param unseen copied
     */
    public Forecast {
        rows = List.copyOf(rows);
        references = List.copyOf(references);
        unseen = List.copyOf(unseen);
    }

    /**
     * One object's position or gripping point, where it is worst.
     *
     * @param object id
     * @param grip whether it is the gripping point
     * @param xStdMm standard deviation along world x, mm; infinite where references do not determine the camera pose
     * @param yStdMm along y
     * @param zStdMm along z
     * @param ownStdMm the largest of what the object's own corners leave along an axis, however well the camera's pose
     *     is known, mm
     * @param turnStdDeg largest standard deviation of the object's turn about a world axis, degrees; NaN of a gripping
     *     point
     * @param ratio how much it takes of what is asked of it: 1 where its target is just met; mm where there is no
     *     target for any object, 0 where there is none for this one
     * @param ownRatio how much its own corners alone take
     * @param probability the least probability of keeping one of its tolerances; NaN where it has none
     * @param xyCorrelation correlation of its errors along x and y where it takes most of what is asked
     */
    public record Row(int object, boolean grip, double xStdMm, double yStdMm, double zStdMm, double ownStdMm,
            double turnStdDeg, double ratio, double ownRatio, double probability, double xyCorrelation) {
        /**
         * Deviation along an axis.
         *
         * @param axis 0, 1 or 2 for x, y, z
         * @return mm
         */
        public double axis(int axis) {
            return axis == 0 ? xStdMm : axis == 1 ? yStdMm : zStdMm;
        }

        /**
         * The largest deviation along an axis.
         *
         * @return mm
         */
        public double worstStdMm() {
            return Math.max(xStdMm, Math.max(yStdMm, zStdMm));
        }
    }

    /**
     * The largest deviation of any object and gripping point along any axis: what a target is held against.
     *
     * @return mm; infinite where an object is not seen; 0 without objects
     */
    public double worstStdMm() {
        double worst = unseen.isEmpty() ? 0 : Double.POSITIVE_INFINITY;
        for (Row row : rows) {
            worst = Math.max(worst, row.worstStdMm());
        }
        return worst;
    }

    /**
     * How much of what is asked is taken by the point that takes most.
     *
     * @return at most 1 where the target is met; in mm where there is no target; infinite where an object is not seen
     */
    public double ratio() {
        return rows.stream().mapToDouble(Row::ratio).reduce(unseen.isEmpty() ? 0 : Double.POSITIVE_INFINITY,
                Math::max);
    }

    /**
     * How much objects' own corners take of what is asked, whatever references do.
     *
     * @return as {@link #ratio()}
     */
    public double boundRatio() {
        return rows.stream().mapToDouble(Row::ownRatio).reduce(unseen.isEmpty() ? 0 : Double.POSITIVE_INFINITY,
                Math::max);
    }

    /**
     * What no reference can improve on: the largest deviation that the objects' own corners leave.
     *
     * @return mm; infinite where an object is not seen
     */
    public double boundStdMm() {
        double worst = unseen.isEmpty() ? 0 : Double.POSITIVE_INFINITY;
        for (Row row : rows) {
            worst = Math.max(worst, row.ownStdMm());
        }
        return worst;
    }
}
