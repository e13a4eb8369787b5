package org.cellgauge.check;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
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
 * <p>For each reference and each world axis the score test of a shift along the axis, and of a turn about it, added to the
 * linearised model (a mean-shift outlier test: Cook and Weisberg, "Residuals and Influence in Regression", 1982, section
 * 2.2; in photogrammetry data snooping, Baarda 1968). Under the model each statistic is standard normal. The level is
 * shared over all tests (Bonferroni), so that a cell as stated raises a warning less than once in a hundred times, and
 * most of it goes to the shifts that this cell would show (weights fixed by the layout alone keep the level: Genovese,
 * Roeder and Wasserman, "False discovery control with p-value weighting", Biometrika 2006). One axis at a time finds more
 * than three at once: the axis of sight, hardly determined, would raise the limit of the other two. The reference with the
 * largest statistic is left out, the pose fitted again, and the rest tested anew.
 *
 * <p>What the camera pose can absorb cannot be noticed: three references in a plane determine it with next to nothing to
 * spare.
 */
final class MisplacedReferences {
    /** False alarms per cell. */
    static final double LEVEL = 0.007;
    /** Share of the level for shifts that the cell would show; the others, and all turns, share the rest. */
    private static final double SEEN_SHARE = 0.85;
    /** A shift of one stated deviation is seen where it moves its statistic by this much; 1 if nothing absorbed it. */
    private static final double SEEN = 0.5;
    /** Share of a coordinate's information below which what is left of it is rounding. */
    private static final double ABSORBED = 1e-9;

    private MisplacedReferences() {
    }

    /** A reference found to be off. */
    static final class Finding {
        final Reference reference;
        final boolean turned;
        final int axis;
        final double offset;
        final double statistic;

        Finding(Reference reference, boolean turned, int axis, double offset, double statistic) {
            this.reference = reference;
            this.turned = turned;
            this.axis = axis;
            this.offset = offset;
            this.statistic = statistic;
        }

        String warning() {
            Placement placement = reference.placement();
            String axisName = "xyz".substring(axis, axis + 1);
            if (turned) {
                return String.format(Locale.ROOT, "reference %d seems turned by about %.1f degrees about %s, which its "
                        + "stated precision (%.2f degrees) does not allow: check how it is mounted", reference.id(),
                        Math.toDegrees(offset), axisName, Math.toDegrees(placement.stdRad()));
            }
            return String.format(Locale.ROOT, "reference %d seems off by about %.1f mm along %s, which its stated "
                    + "precision (%.1f mm) does not allow: measure its position again", reference.id(), offset, axisName,
                    placement.stdMm(axis));
        }
    }

    /** The score test of one coordinate of one reference's placement. */
    private static final class Test {
        final Reference reference;
        final int coordinate;
        final double score;
        final double information;

        Test(Reference reference, int coordinate, double score, double information) {
            this.reference = reference;
            this.coordinate = coordinate;
            this.score = score;
            this.information = information;
        }

        boolean isSeenShift() {
            return coordinate < 3 && reference.placement().stdMm(coordinate) * Math.sqrt(information) > SEEN;
        }

        double statistic() {
            return Math.abs(score) / Math.sqrt(information);
        }

        Finding finding() {
            return new Finding(reference, coordinate >= 3, coordinate % 3, score / information, statistic());
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
            Finding worst = worst(view, mode);
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

    private static Finding worst(ReferenceView view, PoseMode mode) {
        List<Test> tests = tests(view, mode);
        int seen = 0;
        for (Test test : tests) {
            seen += test.isSeenShift() ? 1 : 0;
        }
        double limitOfSeen = limit(SEEN_SHARE * LEVEL / seen);
        double limitOfRest = limit((seen == 0 ? 1 : 1 - SEEN_SHARE) * LEVEL / (tests.size() - seen));
        Test worst = null;
        for (Test test : tests) {
            if (test.statistic() > (test.isSeenShift() ? limitOfSeen : limitOfRest)
                    && (worst == null || test.statistic() > worst.statistic())) {
                worst = test;
            }
        }
        return worst == null ? null : worst.finding();
    }

    /** Size that a standard normal value exceeds with the given probability; of either sign. */
    private static double limit(double probability) {
        return probability < 1 ? Math.sqrt(CoverageRegion.chiSquareQuantile(1 - probability, 1)) : 0;
    }

    private static List<Test> tests(ReferenceView view, PoseMode mode) {
        List<Test> tests = new ArrayList<>();
        RigidMarkerNoise geometry = new RigidMarkerNoise(view, 1);
        CameraState state = mode.state();
        double[] whitening = mode.whitening();
        double[] byPlacement = new double[48];
        for (int m = 0; m < view.size(); m++) {
            geometry.jacobian(state, m, byPlacement);
            double[] residual = mode.whitenedResiduals(m);
            double[] spare = mode.redundancy(m);
            for (int c = 0; c < 6; c++) {
                double[] d = new double[8];
                for (int i = 0; i < 8; i++) {
                    for (int k = 0; k <= i; k++) {
                        d[i] += whitening[64 * m + 8 * i + k] * byPlacement[6 * k + c];
                    }
                }
                double score = 0;
                double information = 0;
                double whole = 0;
                for (int i = 0; i < 8; i++) {
                    whole += d[i] * d[i];
                    // residuals are projected minus observed: a marker that is off by +s is predicted at -s
                    score -= d[i] * residual[i];
                    for (int k = 0; k < 8; k++) {
                        information += d[i] * spare[8 * i + k] * d[k];
                    }
                }
                // a direction that the pose absorbs entirely has nothing left to test
                if (information > ABSORBED * whole) {
                    tests.add(new Test(view.references().get(m), c, score, information));
                }
            }
        }
        return tests;
    }
}
