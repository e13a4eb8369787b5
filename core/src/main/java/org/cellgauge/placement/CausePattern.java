package org.cellgauge.placement;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.TreeMap;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.geometry.Lenses;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.laplace.CameraFit;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.internal.pose.ReferenceView;
import org.cellgauge.internal.pose.RigidMarkerNoise;
import org.cellgauge.vision.EdgeShift;

/**
 * How a cause moves the corners of all references: their derivative by its size, at a mode; immutable.
 *
 * <p>A column is that of a size that is worth looking for ({@link #typical}), as a reference's directions are of one
 * stated deviation: whether a layout would show such a size decides how much of the level of false alarms its test
 * gets.
 */
final class CausePattern {
    private static final double SIZE_SHARE = 0.03;
    private static final double EDGE_PX = 1;
    private static final double FOCAL_SHARE = 0.03;
    private static final double PRINCIPAL_POINT_PX = 20;
    /** By how much the corner of the image moves, as a share of its distance from the middle. */
    private static final double BEND_SHARE = 0.02;
    private static final double STRETCH_SHARE = 0.02;
    /** Spread of the places of references below which they are all in one plane across that axis, mm. */
    private static final double NO_SPREAD_MM = 1;

    final Cause cause;
    /** The references concerned; empty for all. */
    final List<Integer> references;
    final int axis;
    /** Stated size of the markers concerned, mm; NaN where it is of no account. */
    final double statedMm;
    /** The size that a column is of, in the unit of the cause. */
    final double typical;
    /** How much of the level it gets where it would show clearly; places of references, which are many, have 1. */
    final double weight;
    /** One column, of {@link Cause#PRINCIPAL_POINT} two: change of each coordinate of the corners, px. */
    final double[][] columnsPx;

    private CausePattern(Cause cause, List<Integer> references, int axis, double statedMm, double typical,
            double weight, double[]... columnsPx) {
        this.cause = cause;
        this.references = references;
        this.axis = axis;
        this.statedMm = statedMm;
        this.typical = typical;
        this.weight = weight;
        this.columnsPx = columnsPx;
    }

    /** The same cause whatever the numbers. */
    boolean isLike(CausePattern other) {
        return cause == other.cause && axis == other.axis
                && (cause != Cause.SIZE_OF_SOME || statedMm == other.statedMm);
    }

    /** The patterns of all causes that move corners at all. */
    static List<CausePattern> of(CameraFit camera, PoseMode mode) {
        ReferenceView view = camera.view;
        int n = view.size();
        CameraState state = mode.state();
        double[] bySize = new double[8 * n];
        double[] byEdge = new double[8 * n];
        double[][] byStretch = new double[3][8 * n];
        double[][] byLens = new double[4][8 * n];
        double[] centroid = view.centroidMm();
        double[] spread = new double[3];
        double[] observed = view.observedPx();
        double[] points = mode.pointsMm();
        RigidMarkerNoise geometry = new RigidMarkerNoise(view, 1).about(mode.placed());
        double[] byPlacement = new double[8 * PlacementScores.COORDINATES];
        LensColumns lens = new LensColumns(camera.lens, state);
        double[] corners = new double[8];
        TreeMap<Double, List<Integer>> bySizes = new TreeMap<>();
        for (int m = 0; m < n; m++) {
            Reference reference = view.references().get(m);
            bySizes.computeIfAbsent(reference.sizeMm(), s -> new ArrayList<>()).add(m);
            double[] centre = reference.worldFromMarker().translationMm();
            double[] of = MarkerGeometry.cornersMm(reference.worldFromMarker(), reference.sizeMm());
            geometry.jacobian(state, m, byPlacement);
            System.arraycopy(observed, 8 * m, corners, 0, 8);
            double[] shift = EdgeShift.ofCorners(corners);
            for (int i = 0; i < 8; i++) {
                byEdge[8 * m + i] = EDGE_PX * shift[i];
                for (int axis = 0; axis < 3; axis++) {
                    double along = byPlacement[PlacementScores.COORDINATES * i + axis];
                    bySize[8 * m + i] += SIZE_SHARE * along * (of[3 * (i / 2) + axis] - centre[axis]);
                    byStretch[axis][8 * m + i] = STRETCH_SHARE * along * (centre[axis] - centroid[axis]);
                }
            }
            for (int axis = 0; axis < 3; axis++) {
                spread[axis] = Math.max(spread[axis], Math.abs(centre[axis] - centroid[axis]));
            }
            for (int k = 0; k < 4; k++) {
                lens.add(points, 12 * m + 3 * k, byLens, 8 * m + 2 * k);
            }
        }
        List<CausePattern> patterns = new ArrayList<>();
        List<Integer> all = Collections.emptyList();
        patterns.add(new CausePattern(Cause.MARKER_SIZE, all, -1,
                bySizes.size() > 1 ? Double.NaN : bySizes.firstKey(), SIZE_SHARE, 0.3,
                bySize));
        if (bySizes.size() > 1) {
            bySizes.forEach((size, markers) -> patterns.add(ofOneSize(view, size, markers, bySize)));
        }
        patterns.add(new CausePattern(Cause.EDGE_SHIFT, all, -1, Double.NaN, EDGE_PX, 0.1, byEdge));
        patterns.add(new CausePattern(Cause.FOCAL_LENGTH, all, -1, Double.NaN, FOCAL_SHARE, 0.1, byLens[0]));
        patterns.add(new CausePattern(Cause.PRINCIPAL_POINT, all, -1, Double.NaN, PRINCIPAL_POINT_PX, 0.05, byLens[1],
                byLens[2]));
        patterns.add(new CausePattern(Cause.DISTORTION, all, -1, Double.NaN, lens.bend, 0.1, byLens[3]));
        for (int axis = 0; axis < 3; axis++) {
            if (spread[axis] > NO_SPREAD_MM) {
                patterns.add(new CausePattern(Cause.STRETCH, all, axis, Double.NaN, STRETCH_SHARE, 0.1,
                        byStretch[axis]));
            }
        }
        return patterns;
    }

    private static CausePattern ofOneSize(ReferenceView view, double sizeMm, List<Integer> markers, double[] bySize) {
        double[] column = new double[bySize.length];
        List<Integer> ids = new ArrayList<>();
        for (int m : markers) {
            System.arraycopy(bySize, 8 * m, column, 8 * m, 8);
            ids.add(view.references().get(m).id());
        }
        return new CausePattern(Cause.SIZE_OF_SOME, ids, -1, sizeMm, SIZE_SHARE, 0.1, column);
    }

    /**
     * What this cause comes to in a direction of its columns, of so many times its typical size. Shares are taken for
     * logarithms, as nothing is smaller by more than all of it.
     */
    Explanation explanation(double[] direction, double times, double timesStd, double evidence) {
        double[] size = new double[direction.length];
        for (int c = 0; c < size.length; c++) {
            size[c] = times * direction[c] * typical;
            if (CauseSearch.isShare(cause)) {
                size[c] = Math.expm1(size[c]);
            }
        }
        return Explanation.ofSize(cause, references, axis, size, timesStd * typical, statedMm, evidence);
    }

    /** Columns of what is unknown of a lens: focal length, principal point in x and y, first radial coefficient. */
    private static final class LensColumns {
        final double bend;
        private final CameraState state;
        private final int parameters;
        private final double[] uv = new double[2];
        private final double[] byPoint = new double[6];
        private final double[] byParameters;

        LensColumns(PinholeCamera camera, CameraState state) {
            this.state = state;
            parameters = camera.lens().parameterCount();
            byParameters = new double[2 * parameters];
            double corner = Math.hypot(camera.widthPx(), camera.heightPx()) / 2 / camera.get(PinholeCamera.FX);
            bend = BEND_SHARE / (corner * corner);
        }

        void add(double[] points, int at, double[][] columns, int row) {
            double[] r = state.rotation;
            double[] c = new double[3];
            for (int i = 0; i < 3; i++) {
                c[i] = r[3 * i] * points[at] + r[3 * i + 1] * points[at + 1] + r[3 * i + 2] * points[at + 2]
                        + state.offset[i];
            }
            if (!state.lens.projectWithDerivatives(state.intrinsics, c[0], c[1], c[2], uv, byPoint, byParameters)) {
                return;
            }
            for (int i = 0; i < 2; i++) {
                int from = parameters * i;
                columns[0][row + i] = FOCAL_SHARE * (byParameters[from + PinholeCamera.FX]
                        * state.intrinsics[PinholeCamera.FX]
                        + byParameters[from + PinholeCamera.FY] * state.intrinsics[PinholeCamera.FY]);
                columns[1][row + i] = PRINCIPAL_POINT_PX * byParameters[from + PinholeCamera.CX];
                columns[2][row + i] = PRINCIPAL_POINT_PX * byParameters[from + PinholeCamera.CY];
                columns[3][row + i] = bend * byParameters[from + Lenses.FIRST_RADIAL];
            }
        }
    }
}
