package org.cellgauge.check;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.Cholesky;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.pose.CameraModeFinder;
import org.cellgauge.pose.CameraState;
import org.cellgauge.pose.PoseMode;
import org.cellgauge.pose.ReferenceView;
import org.cellgauge.pose.RigidMarkerNoise;
import org.cellgauge.statistics.CoverageRegion;

/**
 * Notices references that stand farther off than their stated precision allows.
 *
 * <p>For each reference the score test of a shift of its position, and of a turn about its centre, added to the linearised
 * model (a mean-shift outlier test: Cook and Weisberg, "Residuals and Influence in Regression", 1982, section 2.2, with
 * several coordinates at once; in photogrammetry data snooping, Baarda 1968). Under the model each statistic is chi-square
 * with 3 degrees of freedom; the level is shared over all references and both tests, so that a cell as stated raises a
 * warning less than once in a hundred times. The reference with the largest statistic is left out, the pose fitted
 * again, and the rest tested anew.
 *
 * <p>What the camera pose can absorb cannot be noticed: three references in a plane determine it with next to nothing to
 * spare.
 */
final class MisplacedReferences {
    /** False alarms per cell. */
    static final double LEVEL = 0.008;

    private MisplacedReferences() {
    }

    /** A reference found to be off. */
    static final class Finding {
        final Reference reference;
        final boolean turned;
        final double[] offset;
        final double statistic;

        Finding(Reference reference, boolean turned, double[] offset, double statistic) {
            this.reference = reference;
            this.turned = turned;
            this.offset = offset;
            this.statistic = statistic;
        }

        String warning() {
            Placement placement = reference.placement();
            if (turned) {
                double angle = Math.sqrt(offset[0] * offset[0] + offset[1] * offset[1] + offset[2] * offset[2]);
                return String.format(Locale.ROOT, "reference %d seems turned by about %.1f degrees, which its stated "
                        + "precision (%.2f degrees) does not allow: check how it is mounted", reference.id(),
                        Math.toDegrees(angle), Math.toDegrees(placement.stdRad()));
            }
            return String.format(Locale.ROOT, "reference %d seems off by about (%.1f, %.1f, %.1f) mm, which its stated "
                    + "precision (%.1f, %.1f, %.1f mm) does not allow: measure its position again", reference.id(),
                    offset[0], offset[1], offset[2], placement.stdMm(0), placement.stdMm(1), placement.stdMm(2));
        }
    }

    static List<String> warnings(CameraTarget target) {
        List<String> texts = new ArrayList<>();
        for (Finding finding : findings(target)) {
            texts.add(finding.warning());
        }
        return texts;
    }

    /** References that are off, the worst first; each after the ones before it were left out. */
    static List<Finding> findings(CameraTarget target) {
        List<Finding> found = new ArrayList<>();
        ReferenceView view = target.view;
        PoseMode mode = target.modes.get(0);
        while (view.size() >= 3) {
            Finding worst = worst(view, mode, target.view.size());
            if (worst == null) {
                break;
            }
            found.add(worst);
            List<Integer> kept = new ArrayList<>();
            for (int m = 0; m < view.size(); m++) {
                if (view.references().get(m) != worst.reference) {
                    kept.add(m);
                }
            }
            RigidTransform start = view.worldFromCamera(mode.state().cameraFromSet());
            view = view.only(kept);
            List<PoseMode> modes = target.finder(view).modes(start);
            if (modes.isEmpty()) {
                break;
            }
            mode = modes.get(0);
        }
        return found;
    }

    private static Finding worst(ReferenceView view, PoseMode mode, int tested) {
        double limit = CoverageRegion.chiSquareQuantile(1 - LEVEL / (2.0 * tested), 3);
        Finding worst = null;
        RigidMarkerNoise geometry = new RigidMarkerNoise(view, 1);
        CameraState state = mode.state();
        double[] byPlacement = new double[48];
        for (int m = 0; m < view.size(); m++) {
            geometry.jacobian(state, m, byPlacement);
            double[] whitening = mode.whitening();
            double[] white = new double[64];
            System.arraycopy(whitening, 64 * m, white, 0, 64);
            double[] residual = mode.whitenedResiduals(m);
            double[] spare = mode.redundancy(m);
            for (int test = 0; test < 2; test++) {
                double[][] d = new double[8][3];
                for (int i = 0; i < 8; i++) {
                    for (int c = 0; c < 3; c++) {
                        for (int k = 0; k <= i; k++) {
                            d[i][c] += white[8 * i + k] * byPlacement[6 * k + 3 * test + c];
                        }
                    }
                }
                Finding finding = test(view.references().get(m), test == 1, d, residual, spare);
                if (finding != null && finding.statistic > limit
                        && (worst == null || finding.statistic > worst.statistic)) {
                    worst = finding;
                }
            }
        }
        return worst;
    }

    private static Finding test(Reference reference, boolean turned, double[][] d, double[] residual, double[] spare) {
        double[] score = new double[3];
        double[] variance = new double[9];
        for (int a = 0; a < 3; a++) {
            for (int i = 0; i < 8; i++) {
                // residuals are projected minus observed: a marker that is off by +s is predicted at -s
                score[a] -= d[i][a] * residual[i];
                for (int k = 0; k < 8; k++) {
                    for (int b = 0; b < 3; b++) {
                        variance[3 * a + b] += d[i][a] * spare[8 * i + k] * d[k][b];
                    }
                }
            }
        }
        double[] factor = variance.clone();
        // a direction that the pose absorbs entirely has no variance left and cannot be tested
        if (!Cholesky.factor(factor, 3)) {
            return null;
        }
        double[] offset = score.clone();
        Cholesky.solveLower(factor, 3, offset);
        double statistic = offset[0] * offset[0] + offset[1] * offset[1] + offset[2] * offset[2];
        Cholesky.solveUpper(factor, 3, offset);
        return new Finding(reference, turned, offset, statistic);
    }
}
