package org.cellgauge.internal.validation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.IntConsumer;
import java.util.regex.Pattern;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.Verdict;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.geometry.Rotations;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.internal.statistics.CoverageRegion;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.EdgeShift;
import org.cellgauge.vision.MarkerObservation;
import org.cellgauge.warning.CheckWarning;
import org.cellgauge.warning.Warning;
import org.jspecify.annotations.Nullable;

/**
 * Simulated cells from wherever they come, seen however they are seen, each checked as a photo would be: how often do
 * stated regions hold the truth, how large are errors against what is stated, and what becomes of the rest?
 *
 * <p>Beside {@link Validation}, which knows one cell and one kind of noise and looks at ranks too, this takes any
 * {@link CellSource} and any {@link DetectionSource}: detectors at work on rendered photos, and layouts that differ
 * from simulation to simulation.
 *
 * <p><b>Regions.</b> A stated 95 % region is the one of highest density of the check's draws ({@code MixtureRegion}):
 * about the mean where a pose has one mode; where camera or object have several, the union of one ellipsoid about each,
 * of sizes that hold 95 % of the draws together. An ellipsoid over two modes would say little of either.
 *
 * <p><b>Squared distances</b> (normalised estimation error squared; Bar-Shalom, Li, Kirubarajan, "Estimation with
 * Applications to Tracking and Navigation", 2001, section 5.4.2) are those from the mean of all draws by their
 * covariance. Over draws of the posterior their expectation is the number of coordinates, with however many modes.
 *
 * <p><b>Corners.</b> Detected minus true corners e of every marker against the covariance S that its observation
 * states: e' S^-1 e / 8 is 1 on average. The outward part of e is what all sides move along their normals, by least
 * squares: {@code -d'e / d'd}, d as of {@link EdgeShift#ofCorners}.
 */
public final class CoverageStudy {
    /** Probability of the regions that are judged. */
    public static final double PROBABILITY = 0.95;
    private static final long STREAM_PHOTO = 111;
    private static final Pattern NUMBERS = Pattern.compile("-?\\d+(\\.\\d+)?((, | and |,)-?\\d+(\\.\\d+)?)*");

    private final CellSource cells;
    private final DetectionSource detections;
    private final CheckSettings check;

    private CoverageStudy(CellSource cells, DetectionSource detections, CheckSettings check) {
        this.cells = cells;
        this.detections = detections;
        this.check = check;
    }

    /** How one part of a cell stands to what was stated of it. */
    static final class Standing {
        final String name;
        /** Names of the regions: position (objects), pose, grip. */
        final List<String> regions = new ArrayList<>();
        final List<Integer> dimensions = new ArrayList<>();
        /** By region: smallest probability whose region holds the truth. */
        final List<Double> shares = new ArrayList<>();
        /** By region: squared distance of the truth from the mean. */
        final List<Double> squared = new ArrayList<>();
        /** Mean minus truth, world z. */
        double errorZMm;
        boolean severalModes;

        Standing(String name) {
            this.name = name;
        }
    }

    /** An unknown noise so far below zero that nothing is added: what the fit alone says is judged. */
    private static final double NO_ADDED_NOISE = -8;

    /** How the corners of one marker stand to what was stated of them. */
    static final class CornerStanding {
        double squaredPx2;
        double outwardPx;
        /** Stated variance of the outward part; NaN where no covariance is stated. */
        double outwardVariancePx2 = Double.NaN;
        /** e' S^-1 e; NaN where no covariance is stated. */
        double squaredStated = Double.NaN;
        /** The same of the corners and covariance as the check takes them; NaN where no covariance is stated. */
        double squaredAsTaken = Double.NaN;
    }

    /** What became of one simulated cell. */
    static final class Outcome {
        @Nullable String refusal;
        @Nullable Verdict verdict;
        boolean accuses;
        boolean noiseMisfit;
        boolean referencesMisfit;
        int markers;
        int markersFound;
        final List<String> warnings = new ArrayList<>();
        final List<Standing> standings = new ArrayList<>();
        final List<CornerStanding> corners = new ArrayList<>();
    }

    /**
     * Runs a study. The same sources, settings and seed give the same result whatever the number of threads.
     *
     * @param cells where cells come from
     * @param detections how they are seen
     * @param check how each is checked; its seed is that of the whole study, its number of threads does not count
     * @param simulations number of cells, 1 to 1000000
     * @param threads number of cells at a time, at least 1
     * @param progress told the number of finished simulations, in order, on the calling thread
     * @return the figures
     * @throws IllegalArgumentException if a number is out of range
     */
    public static CoverageFigures run(CellSource cells, DetectionSource detections, CheckSettings check,
            int simulations, int threads, IntConsumer progress) {
        requireNumbers(simulations, threads);
        CoverageStudy study = new CoverageStudy(cells, detections, check);
        return CoverageFigures.of(InOrder.run(simulations, threads, study::simulate, progress));
    }

    /**
     * The corners alone: cells are simulated and seen, photo by photo the same as in {@link #run}, but not checked.
     * What remains of the figures are refusals of the detector, its warnings, markers found and their corners.
     *
     * @param cells where cells come from
     * @param detections how they are seen
     * @param seed seed of the whole study
     * @param simulations number of cells, 1 to 1000000
     * @param threads number of cells at a time, at least 1
     * @param progress told the number of finished simulations, in order, on the calling thread
     * @return the figures, without verdicts and regions
     * @throws IllegalArgumentException if a number is out of range
     */
    public static CoverageFigures runCornersOnly(CellSource cells, DetectionSource detections, long seed,
            int simulations, int threads, IntConsumer progress) {
        requireNumbers(simulations, threads);
        return CoverageFigures.of(InOrder.run(simulations, threads, index -> {
            SimulatedCell simulated = cells.cell(seed, index);
            Outcome outcome = new Outcome();
            outcome.markers = simulated.cell().references().size() + simulated.cell().objects().size();
            see(simulated, detections, seed, index, outcome);
            return outcome;
        }, progress));
    }

    private static void requireNumbers(int simulations, int threads) {
        if (simulations < 1 || simulations > 1_000_000) {
            throw new IllegalArgumentException("simulations must be between 1 and 1000000, not " + simulations);
        }
        if (threads < 1) {
            throw new IllegalArgumentException("threads must be at least 1");
        }
    }

    /** What is seen of a cell, its corners counted; null, the reason kept, where the detector refuses it. */
    private static @Nullable Detections see(SimulatedCell simulated, DetectionSource detections, long seed, int index,
            Outcome outcome) {
        try {
            Detections seen = detections.detect(simulated, RandomStreams.of(seed, STREAM_PHOTO, index));
            corners(simulated, seen, outcome);
            addWarnings(outcome, seen.warnings());
            return seen;
        } catch (InputRefusedException e) {
            outcome.refusal = reason(e.refusal().toString());
            return null;
        }
    }

    private Outcome simulate(int index) {
        Outcome outcome = new Outcome();
        SimulatedCell simulated = cells.cell(check.sampling().seed(), index);
        Cell cell = simulated.cell();
        outcome.markers = cell.references().size() + cell.objects().size();
        CheckSettings own = check.toBuilder().threads(1)
                .seed(RandomStreams.of(check.sampling().seed(), Validation.STREAM_CHECK, index).nextLong()).build();
        Detections seen = see(simulated, detections, check.sampling().seed(), index, outcome);
        if (seen == null) {
            return outcome;
        }
        CheckResult result;
        try {
            result = CellCheck.run(cell, seen, own);
        } catch (InputRefusedException e) {
            outcome.refusal = reason(e.refusal().toString());
            return outcome;
        }
        outcome.warnings.clear();
        addWarnings(outcome, result.warnings());
        outcome.verdict = result.verdict();
        outcome.accuses = !result.referenceCheck().misplaced().isEmpty() || !result.referenceCheck().causes().isEmpty()
                || result.warnings().stream().anyMatch(w -> w.kind() == CheckWarning.REFERENCE_LEFT_OUT);
        outcome.noiseMisfit = !result.noiseFit().holds();
        outcome.referencesMisfit = !result.referenceCheck().fitTogether();
        if (result.verdict() != Verdict.NOT_CONVERGED) {
            outcome.standings.add(standing(result, null, simulated));
            for (ObjectMarker object : cell.objects()) {
                if (result.estimate().object(object.id()) != null) {
                    outcome.standings.add(standing(result, object, simulated));
                }
            }
        }
        return outcome;
    }

    private static void addWarnings(Outcome outcome, List<Warning> warnings) {
        for (Warning warning : warnings) {
            String name = warning.kind().toString().toLowerCase(Locale.ROOT);
            if (!outcome.warnings.contains(name)) {
                outcome.warnings.add(name);
            }
        }
    }

    /** A refusal without the name of the image, the remedy and the numbers, so that like ones can be counted. */
    static String reason(String message) {
        String text = message.replaceFirst("^simulated: ", "");
        int remedy = text.indexOf(';');
        return NUMBERS.matcher(remedy < 0 ? text : text.substring(0, remedy)).replaceAll("#");
    }

    // ---- parts

    private Standing standing(CheckResult result, @Nullable ObjectMarker object, SimulatedCell simulated) {
        RigidTransform truth = object == null ? simulated.truth().worldFromCamera()
                : simulated.truth().worldFromObject(object.id());
        double[] grip = object == null ? null : object.gripMm();
        List<Quantity> quantities = CellPart.coordinatesOf(object);
        double[][] columns = new double[quantities.size()][];
        for (int c = 0; c < columns.length; c++) {
            columns[c] = CellPart.column(result, quantities.get(c));
        }
        double[] values = new double[columns.length];
        System.arraycopy(truth.translationMm(), 0, values, 0, 3);
        double[] turned = new double[9];
        Rotations.multiplyTransposed(truth.rotation(),
                CellPart.referenceRotation(columns, CellPart.rotations(result, object)), turned);
        Rotations.log(turned, values, 3);
        if (grip != null) {
            System.arraycopy(truth.apply(grip), 0, values, 6, 3);
        }
        Standing standing = new Standing(object == null ? "camera" : cells.nameOf(object));
        int[] labels = labels(result, object);
        standing.severalModes = labels != null;
        add(standing, "position", columns, values, 0, 3, labels);
        add(standing, "pose", columns, values, 0, 6, labels);
        if (grip != null) {
            add(standing, "grip", columns, values, 6, 3, labels);
        }
        double meanZ = 0;
        for (double z : columns[2]) {
            meanZ += z / columns[2].length;
        }
        standing.errorZMm = meanZ - values[2];
        return standing;
    }

    private static void add(Standing standing, String name, double[][] columns, double[] truth, int first,
            int dimension, int @Nullable [] labels) {
        double[] own = Arrays.copyOfRange(truth, first, first + dimension);
        standing.regions.add(name);
        standing.dimensions.add(dimension);
        standing.shares.add(new MixtureRegion(columns, first, dimension, labels).shareOf(own));
        double[] mean = new double[dimension];
        double[][] covariance = new double[dimension][dimension];
        int n = columns[first].length;
        for (int c = 0; c < dimension; c++) {
            for (double v : columns[first + c]) {
                mean[c] += v / n;
            }
        }
        for (int c = 0; c < dimension; c++) {
            for (int d = 0; d <= c; d++) {
                double sum = 0;
                for (int i = 0; i < n; i++) {
                    sum += (columns[first + c][i] - mean[c]) * (columns[first + d][i] - mean[d]);
                }
                covariance[c][d] = sum / (n - 1);
                covariance[d][c] = covariance[c][d];
            }
        }
        standing.squared.add(CoverageRegion.of(mean, covariance, PROBABILITY).mahalanobisSquared(own));
    }

    /** Which of the modes of camera and object together each draw is near; null where there is but one. */
    static int @Nullable [] labels(CheckResult result, @Nullable ObjectMarker object) {
        int[] labels = null;
        for (Quantity which : object == null ? List.of(Quantity.CAMERA_MODE)
                : List.of(Quantity.CAMERA_MODE, Quantity.objectMode(object.id()))) {
            if (!result.layout().quantities().contains(which)) {
                continue;
            }
            double[] modes = CellPart.column(result, which);
            int count = 0;
            for (double mode : modes) {
                count = Math.max(count, (int) mode + 1);
            }
            if (labels == null) {
                labels = new int[modes.length];
            }
            for (int i = 0; i < labels.length; i++) {
                labels[i] = labels[i] * count + (int) modes[i];
            }
        }
        return labels;
    }

    // ---- corners

    static void corners(SimulatedCell simulated, Detections seen, Outcome outcome) {
        List<Integer> ids = new ArrayList<>();
        simulated.cell().references().forEach(r -> ids.add(r.id()));
        simulated.cell().objects().forEach(o -> ids.add(o.id()));
        CornerErrors taken = CornerErrors.of(simulated.cell(), seen);
        for (int id : ids) {
            MarkerObservation observation = seen.find(id);
            if (observation == null) {
                continue;
            }
            outcome.markersFound++;
            double[] truth = simulated.cornersPx(id);
            if (truth != null) {
                outcome.corners.add(cornerStanding(observation, truth, taken));
            }
        }
    }

    /**
     * How one marker's corners stand to the truth: as the detector states them, and as a check takes them, corrected
     * for the shift that inner edges show, with what is left open of it in the covariance.
     */
    static CornerStanding cornerStanding(MarkerObservation observation, double[] truthPx, CornerErrors taken) {
        double[] error = observation.cornersPx();
        double[] takenError = taken.cornersPx(observation.id());
        double[] inward = EdgeShift.ofCorners(truthPx);
        CornerStanding standing = new CornerStanding();
        double length = 0;
        double along = 0;
        for (int i = 0; i < 8; i++) {
            error[i] -= truthPx[i];
            takenError[i] -= truthPx[i];
            standing.squaredPx2 += takenError[i] * takenError[i];
            length += inward[i] * inward[i];
            along += inward[i] * takenError[i];
        }
        standing.outwardPx = -along / length;
        double[] covariance = observation.covariancePx2();
        if (covariance == null) {
            return standing;
        }
        double[] ofTaken = new double[64];
        taken.covariance(observation.id(), NO_ADDED_NOISE, ofTaken);
        double[] columns = taken.columns(observation.id());
        int q = columns.length / 8;
        double variance = 0;
        for (int i = 0; i < 8; i++) {
            for (int j = 0; j < 8; j++) {
                for (int k = 0; k < q; k++) {
                    ofTaken[8 * i + j] += columns[i * q + k] * columns[j * q + k];
                }
                variance += inward[i] * ofTaken[8 * i + j] * inward[j];
            }
        }
        standing.outwardVariancePx2 = variance / (length * length);
        standing.squaredStated = squared(covariance, error);
        standing.squaredAsTaken = squared(ofTaken, takenError);
        return standing;
    }

    private static double squared(double[] covariance, double[] error) {
        double[] factor = covariance.clone();
        if (!Cholesky.factor(factor, 8)) {
            return Double.POSITIVE_INFINITY;
        }
        double[] whitened = error.clone();
        Cholesky.solveLower(factor, 8, whitened);
        double sum = 0;
        for (double v : whitened) {
            sum += v * v;
        }
        return sum;
    }
}
