package org.cellgauge.internal.pose;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.EigenDecomposition;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.JointPlacement;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.PlacementGroup;
import org.cellgauge.cell.Reference;
import org.cellgauge.cell.SurveyedPlacement;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;

/**
 * What errors of placement references have in common, as unit-normal unknowns: {@code error = F nu + own}, the own
 * errors being independent of each other; immutable. Of plates it is exact: six unknowns each. Of a survey's joint
 * covariance F has its largest principal components (I. T. Jolliffe, "Principal component analysis", 2nd ed. 2002,
 * section 2.1; turns count by how far they move a corner), and what those leave is taken as independent.
 */
public final class CommonPlacement {
    private static final int ERRORS = SurveyedPlacement.ERRORS;
    /** Share of the variance that components may leave, and most of them. */
    private static final double LEFT = 0.01;
    private static final int MOST_COMPONENTS = 12;
    private static final double LEAST_STD = 1e-6;

    private final int unknowns;
    private final List<Reference> references;
    /** By reference: 6 x unknowns, row by row. */
    private final Map<Integer, double[]> factors;

    private CommonPlacement(int unknowns, List<Reference> references, Map<Integer, double[]> factors) {
        this.unknowns = unknowns;
        this.references = Collections.unmodifiableList(references);
        this.factors = factors;
    }

    /**
     * What the references of a cell have in common.
     *
     * @param cell the cell
     * @return no unknowns where nothing is stated of them together
     */
    public static CommonPlacement of(Cell cell) {
        JointPlacement joint = cell.joint();
        return joint.surveyed() != null ? surveyed(cell, joint.surveyed()) : grouped(cell, joint.groups());
    }

    private static CommonPlacement grouped(Cell cell, List<PlacementGroup> groups) {
        int k = ERRORS * groups.size();
        Map<Integer, double[]> factors = new HashMap<>();
        for (int g = 0; g < groups.size(); g++) {
            PlacementGroup group = groups.get(g);
            List<Reference> members = new ArrayList<>();
            cell.references().forEach(r -> {
                if (group.members().contains(r.id())) {
                    members.add(r);
                }
            });
            double[] centre = new double[3];
            for (Reference r : members) {
                for (int i = 0; i < 3; i++) {
                    centre[i] += r.worldFromMarker().translationMm()[i] / members.size();
                }
            }
            Placement placement = group.placement();
            for (Reference r : members) {
                double[] d = r.worldFromMarker().translationMm();
                for (int i = 0; i < 3; i++) {
                    d[i] -= centre[i];
                }
                double[] f = new double[ERRORS * k];
                double turn = placement.stdRad();
                for (int i = 0; i < 3; i++) {
                    f[i * k + ERRORS * g + i] = placement.stdMm(i);
                    f[(3 + i) * k + ERRORS * g + 3 + i] = turn;
                    // w x d
                    int next = (i + 1) % 3;
                    int last = (i + 2) % 3;
                    f[i * k + ERRORS * g + 3 + next] = turn * d[last];
                    f[i * k + ERRORS * g + 3 + last] = -turn * d[next];
                }
                factors.put(r.id(), f);
            }
        }
        return new CommonPlacement(k, cell.references(), factors);
    }

    private static CommonPlacement surveyed(Cell cell, SurveyedPlacement surveyed) {
        int n = ERRORS * surveyed.ids().size();
        double[] covariance = surveyed.covariance();
        double[] scale = new double[n];
        for (int m = 0; m < surveyed.ids().size(); m++) {
            double arm = 1;
            for (Reference r : cell.references()) {
                arm = r.id() == surveyed.ids().get(m) ? r.sizeMm() / 2 : arm;
            }
            for (int i = 0; i < ERRORS; i++) {
                scale[ERRORS * m + i] = i < 3 ? 1 : arm;
            }
        }
        double[][] scaled = new double[n][n];
        double trace = 0;
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                scaled[i][j] = 0.5 * (covariance[i * n + j] + covariance[j * n + i]) * scale[i] * scale[j];
            }
            trace += scaled[i][i];
        }
        EigenDecomposition eigen = new EigenDecomposition(new Array2DRowRealMatrix(scaled, false));
        int k = 0;
        double left = trace;
        while (k < Math.min(n, MOST_COMPONENTS) && left > LEFT * trace) {
            left -= eigen.getRealEigenvalue(k++);
        }
        Map<Integer, double[]> factors = new HashMap<>();
        Map<Integer, Placement> own = new HashMap<>();
        for (int m = 0; m < surveyed.ids().size(); m++) {
            double[] f = new double[ERRORS * k];
            double[] std = new double[ERRORS];
            for (int i = 0; i < ERRORS; i++) {
                int row = ERRORS * m + i;
                double rest = covariance[row * (n + 1)];
                for (int c = 0; c < k; c++) {
                    f[i * k + c] = Math.sqrt(Math.max(0, eigen.getRealEigenvalue(c)))
                            * eigen.getEigenvector(c).getEntry(row) / scale[row];
                    rest -= f[i * k + c] * f[i * k + c];
                }
                std[i] = Math.max(LEAST_STD, Math.sqrt(Math.max(0, rest)));
            }
            factors.put(surveyed.ids().get(m), f);
            own.put(surveyed.ids().get(m), new Placement(std[0], std[1], std[2],
                    Math.sqrt((std[3] * std[3] + std[4] * std[4] + std[5] * std[5]) / 3)));
        }
        List<Reference> references = new ArrayList<>();
        for (Reference r : cell.references()) {
            references.add(new Reference(r.id(), r.sizeMm(), r.worldFromMarker(),
                    own.getOrDefault(r.id(), r.placement())));
        }
        return new CommonPlacement(k, references, factors);
    }

    /**
     * The references with the part of their placement that is their own.
     *
     * @return unmodifiable, in the order of the cell
     */
    public List<Reference> references() {
        return references;
    }

    /**
     * Errors of corners with what references have in common among them.
     *
     * @param errors errors of a photo's corners
     * @param camera the camera
     * @param worldFromCamera about where it stands
     * @return the errors with as many shared unknowns more; the same where there are none
     */
    public CornerErrors addedTo(CornerErrors errors, PinholeCamera camera, RigidTransform worldFromCamera) {
        if (unknowns == 0) {
            return errors;
        }
        Map<Integer, double[]> columns = new HashMap<>();
        RigidTransform cameraFromWorld = worldFromCamera.inverse();
        double[] uv = new double[2];
        double[] byPoint = new double[6];
        double[] r = cameraFromWorld.rotation();
        for (Reference reference : references) {
            double[] factor = factors.get(reference.id());
            if (factor == null || !errors.has(reference.id())) {
                continue;
            }
            double[] out = new double[8 * unknowns];
            double[] points = MarkerGeometry.cornersMm(reference.worldFromMarker(), reference.sizeMm());
            double[] centre = reference.worldFromMarker().translationMm();
            for (int p = 0; p < 4; p++) {
                double[] at = cameraFromWorld.apply(points[3 * p], points[3 * p + 1], points[3 * p + 2]);
                if (!camera.lens().projectWithDerivatives(camera.intrinsics(), at[0], at[1], at[2], uv, byPoint,
                        null)) {
                    continue;
                }
                double x = points[3 * p] - centre[0];
                double y = points[3 * p + 1] - centre[1];
                double z = points[3 * p + 2] - centre[2];
                for (int i = 0; i < 2; i++) {
                    double[] w = new double[3];
                    for (int c = 0; c < 3; c++) {
                        w[c] = byPoint[3 * i] * r[c] + byPoint[3 * i + 1] * r[3 + c] + byPoint[3 * i + 2] * r[6 + c];
                    }
                    double[] row = {w[0], w[1], w[2], y * w[2] - z * w[1], z * w[0] - x * w[2], x * w[1] - y * w[0]};
                    for (int c = 0; c < unknowns; c++) {
                        for (int e = 0; e < ERRORS; e++) {
                            out[(2 * p + i) * unknowns + c] += row[e] * factor[e * unknowns + c];
                        }
                    }
                }
            }
            columns.put(reference.id(), out);
        }
        return errors.withCommonPlacement(columns, unknowns);
    }

    /**
     * Whether anything is in common.
     *
     * @return false where every reference is placed independently of the others
     */
    public boolean isAny() {
        return unknowns > 0;
    }
}
