package org.cellgauge.internal.pose;

import java.util.List;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.ejml.interfaces.decomposition.EigenDecomposition_F64;

/** The plane that points are nearest to, in least squares. */
final class NearestPlane {
    /** Deviations of placement that a set of references must be higher than, not to count as flat. */
    private static final double HEIGHT_STDS = 3;
    /** Share of its size that a set of references must be higher than, not to count as flat. */
    private static final double HEIGHT_SHARE = 0.01;

    private NearestPlane() {
    }

    /**
     * Rotation that turns the plane into z = const.
     *
     * @param points x, y, z of each
     * @return rotation alone
     */
    static RigidTransform planeFromPoints(double[] points) {
        double[] mean = new double[3];
        int n = points.length / 3;
        for (int k = 0; k < points.length; k++) {
            mean[k % 3] += points[k] / n;
        }
        DMatrixRMaj scatter = new DMatrixRMaj(3, 3);
        for (int k = 0; k < points.length; k += 3) {
            for (int i = 0; i < 3; i++) {
                for (int j = 0; j < 3; j++) {
                    scatter.add(i, j, (points[k + i] - mean[i]) * (points[k + j] - mean[j]));
                }
            }
        }
        EigenDecomposition_F64<DMatrixRMaj> eigen = DecompositionFactory_DDRM.eig(3, true, true);
        eigen.decompose(scatter);
        int least = 0;
        int most = 0;
        for (int i = 1; i < 3; i++) {
            least = eigen.getEigenvalue(i).getReal() < eigen.getEigenvalue(least).getReal() ? i : least;
            most = eigen.getEigenvalue(i).getReal() >= eigen.getEigenvalue(most).getReal() ? i : most;
        }
        DMatrixRMaj x = eigen.getEigenVector(most);
        DMatrixRMaj z = eigen.getEigenVector(least);
        double[] rows = {x.get(0), x.get(1), x.get(2),
            z.get(1) * x.get(2) - z.get(2) * x.get(1), z.get(2) * x.get(0) - z.get(0) * x.get(2),
            z.get(0) * x.get(1) - z.get(1) * x.get(0), z.get(0), z.get(1), z.get(2)};
        return RigidTransform.of(rows, new double[3]);
    }

    /**
     * Whether references lie in one plane as far as can be told: their corners stand off it by no more than a few
     * deviations of their placement, or by a hundredth of their extent.
     *
     * @param references with a known place
     * @return true also for a single one
     */
    static boolean holds(List<Reference> references) {
        double[] points = new double[12 * references.size()];
        double std = 0;
        for (int m = 0; m < references.size(); m++) {
            Reference reference = references.get(m);
            System.arraycopy(MarkerGeometry.cornersMm(reference.worldFromMarker(), reference.sizeMm()), 0, points,
                    12 * m, 12);
            for (int i = 0; i < 3; i++) {
                std = Math.max(std, reference.placement().stdMm(i));
            }
        }
        RigidTransform planeFromWorld = planeFromPoints(points);
        double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (int k = 0; k < points.length; k += 3) {
            double[] at = planeFromWorld.apply(new double[] {points[k], points[k + 1], points[k + 2]});
            for (int i = 0; i < 3; i++) {
                low[i] = Math.min(low[i], at[i]);
                high[i] = Math.max(high[i], at[i]);
            }
        }
        double extent = Math.hypot(high[0] - low[0], high[1] - low[1]);
        return high[2] - low[2] <= Math.max(HEIGHT_STDS * std, HEIGHT_SHARE * extent);
    }
}
