package org.cellgauge.internal.validation;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntConsumer;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.Verdict;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.calibration.CalibrationStudy;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.internal.statistics.RankHistogram;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.Detections;
import org.cellgauge.warning.Refusal;

/**
 * Cells simulated from their stated uncertainties, each checked as a photo would be: how often do the regions that the
 * checks state hold the truth?
 *
 * <p>Each simulation draws a truth from a {@link TruthPrior}, placement errors and corner noise as the cell file states
 * them, runs the whole {@link CellCheck}, and looks where the truth lies among its draws.
 *
 * <p><b>Ranks are exact.</b> Simulation-based calibration (Talts, Betancourt, Simpson, Vehtari, Gelman, "Validating
 * Bayesian inference algorithms with simulation-based calibration", 2018, theorem 1) needs truths from the prior that
 * the posterior is under. A check's prior is flat, and nothing can be drawn from it; but its draws, weighted with the
 * density of the truth's own proper prior, are draws of the posterior under that one. {@value #RANKED_DRAWS} draws are
 * picked anew by these weights, independently, which also does away with the chains' autocorrelation; the truth's rank
 * among them is uniform if likelihood, frozen covariances, sampler and object poses are right together. What is left of
 * error is that of the picked-from draws: they must be many (their effective share is reported).
 *
 * <p>Where intrinsics are unknown, true ones come from the check's own prior of them, and ranks of objects are no
 * longer exact: in a check the corners of objects say nothing of the intrinsics, while a full posterior would listen to
 * them.
 *
 * <p>Where the camera of every cell is calibrated anew, from simulated photos of a board, the true camera is that of
 * the cell file, and the check gets what the calibration found and leaves open. Its posterior then stands for a prior
 * of the intrinsics, so that ranks are right to first order only; coverage is what is counted.
 *
 * <p><b>Coverage is what a user gets.</b> It is counted for regions as the check states them, under its flat prior,
 * unweighted. Flat posteriors of a location cover exactly at every fixed truth; poses are close to locations where
 * uncertainties are small, and coverage is right to first order there (Welch and Peers, "On formulae for confidence
 * points based on integrals of weighted likelihoods", 1963). Where it is off while ranks are uniform, the flat prior is
 * what matters, not a fault of the computation. With truths at one point (no spread) ranks are unweighted and only
 * approximately uniform for the same reason: coverage is then purely frequentist.
 *
 * <p>A check needs fewer draws here than for a result. Truth and draws are exchangeable whatever their number, so the
 * share of draws nearer to the mean than the truth is uniform to 1/n, n effective draws; and an error of 5 % in the
 * size of a region averages out over the simulations to first order.
 */
public final class Validation {
    /** Draws among which a truth is ranked. */
    public static final int RANKED_DRAWS = 99;
    /** Probability with which all counts of one level lie in their bands if all claims are honest. */
    public static final double CONFIDENCE = 0.99;
    /** Ranks of each bin that the chi-square approximation asks for. */
    private static final int RANKS_PER_BIN = 5;
    private static final int[] BINS = {20, 10, 5, 4, 2};

    static final long STREAM_TRUTH = 101;
    static final long STREAM_PLACEMENT = 102;
    static final long STREAM_NOISE = 103;
    static final long STREAM_CHECK = 104;
    static final long STREAM_RANKS = 105;
    static final long STREAM_CALIBRATION = 106;
    /** Deviation of a corner's coordinate in the photos of a calibration, px. */
    public static final double CALIBRATION_STD_PX = 0.2;

    private final TruthPrior prior;
    private final ValidationSettings settings;
    private final List<CellPart> parts;

    private Validation(TruthPrior prior, ValidationSettings settings) {
        this.prior = prior;
        this.settings = settings;
        IntrinsicsPrior unknown = IntrinsicsPrior.stated(prior.cell(), settings.check().model());
        parts = CellPart.of(prior.cell(), unknown.has(PinholeCamera.FX) && unknown.has(PinholeCamera.FY));
    }

    /** What became of one simulated cell. */
    private static final class Outcome {
        boolean refused;
        boolean notConverged;
        boolean ambiguous;
        boolean falseAlarm;
        boolean noiseMisfit;
        boolean referencesMisfit;
        List<CellPart.Standing> standings = new ArrayList<>();
    }

    /**
     * Runs a validation. The same prior, settings and seed give the same result whatever the number of threads.
     *
     * @param prior the cell and where its true poses come from
     * @param settings how many cells, and how each is checked
     * @param progress told the number of finished simulations, in order, on the calling thread
     * @return the result
     * @throws InputRefusedException if true poses spread so wide that markers are out of sight
     */
    public static ValidationResult run(TruthPrior prior, ValidationSettings settings, IntConsumer progress) {
        return new Validation(prior, settings).run(progress);
    }

    private ValidationResult run(IntConsumer progress) {
        List<Outcome> outcomes = InOrder.run(settings.simulations(), settings.threads(), this::simulate, progress);
        return summary(outcomes);
    }

    private Outcome simulate(int index) {
        Cell cell = prior.cell();
        long seed = settings.check().sampling().seed();
        CellTruth truth = prior.draw(RandomStreams.of(seed, STREAM_TRUTH, index));
        Detections detections = SimulatedPhoto.of(cell, truth, settings.pixelStdPx(),
                RandomStreams.of(seed, STREAM_PLACEMENT, index), RandomStreams.of(seed, STREAM_NOISE, index));
        CheckSettings own = settings.check().toBuilder().threads(1)
                .seed(RandomStreams.of(seed, STREAM_CHECK, index).nextLong()).build();
        Outcome outcome = new Outcome();
        CheckResult result;
        try {
            if (detections == null) {
                throw new InputRefusedException(
                        Refusal.of(ValidationRefusal.REFERENCE_BEHIND_CAMERA));
            }
            Cell known = settings.calibrationPhotos() == 0 ? cell : CalibrationStudy.calibrated(cell,
                    settings.calibrationPhotos(), CALIBRATION_STD_PX,
                    RandomStreams.of(seed, STREAM_CALIBRATION, index).nextLong());
            result = CellCheck.run(known, detections, own);
        } catch (InputRefusedException e) {
            outcome.refused = true;
            return outcome;
        }
        outcome.falseAlarm = !result.referenceCheck().misplaced().isEmpty()
                || !result.referenceCheck().causes().isEmpty();
        outcome.noiseMisfit = !result.noiseFit().holds();
        outcome.referencesMisfit = !result.referenceCheck().fitTogether();
        outcome.notConverged = result.verdict() == Verdict.NOT_CONVERGED;
        if (outcome.notConverged) {
            return outcome;
        }
        outcome.ambiguous = result.verdict() == Verdict.AMBIGUOUS;
        CellPart.CameraDraws camera = new CellPart.CameraDraws(result, prior);
        for (int p = 0; p < parts.size(); p++) {
            outcome.standings.add(parts.get(p).standing(result, camera, truth, prior, RANKED_DRAWS,
                    RandomStreams.of(seed, STREAM_RANKS, index, p)));
        }
        return outcome;
    }

    private ValidationResult summary(List<Outcome> outcomes) {
        List<Outcome> stated = new ArrayList<>();
        int notConverged = 0;
        int refused = 0;
        int ambiguous = 0;
        int falseAlarms = 0;
        int noiseMisfits = 0;
        int referenceMisfits = 0;
        for (Outcome o : outcomes) {
            notConverged += o.notConverged ? 1 : 0;
            refused += o.refused ? 1 : 0;
            ambiguous += o.ambiguous ? 1 : 0;
            falseAlarms += o.falseAlarm ? 1 : 0;
            noiseMisfits += o.noiseMisfit ? 1 : 0;
            referenceMisfits += o.referencesMisfit ? 1 : 0;
            if (!o.notConverged && !o.refused) {
                stated.add(o);
            }
        }
        int regionCount = 0;
        for (CellPart part : parts) {
            regionCount += part.regionNames.size();
        }
        double confidence = 1 - (1 - CONFIDENCE) / regionCount;
        int bins = bins(stated.size());
        double weightShare = stated.isEmpty() ? Double.NaN : 1;
        List<RegionCoverage> regions = new ArrayList<>();
        List<RankedQuantity> quantities = new ArrayList<>();
        for (int p = 0; p < parts.size(); p++) {
            CellPart part = parts.get(p);
            for (int k = 0; k < part.regionNames.size(); k++) {
                double[] shares = new double[stated.size()];
                double[] distances = new double[stated.size()];
                for (int i = 0; i < shares.length; i++) {
                    shares[i] = stated.get(i).standings.get(p).drawShare[k];
                    distances[i] = stated.get(i).standings.get(p).squaredDistance[k];
                }
                regions.add(new RegionCoverage(part.regionNames.get(k), part.regionDimensions.get(k), shares, distances,
                        confidence));
            }
            List<String> names = new ArrayList<>();
            part.coordinates.forEach(q -> names.add(q.coordinate()));
            names.addAll(part.derived);
            for (int q = 0; q < names.size(); q++) {
                RankHistogram ranks = new RankHistogram(RANKED_DRAWS, bins);
                double sum = 0;
                double squares = 0;
                boolean coordinate = q < part.coordinates.size();
                for (Outcome o : stated) {
                    CellPart.Standing standing = o.standings.get(p);
                    ranks.add(standing.ranks[q]);
                    weightShare = Math.min(weightShare, standing.weightShare);
                    if (coordinate) {
                        sum += standing.standardisedError[q];
                        squares += standing.standardisedError[q] * standing.standardisedError[q];
                    }
                }
                int n = stated.size();
                quantities.add(new RankedQuantity(part.name, names.get(q), ranks, coordinate ? sum / n : Double.NaN,
                        coordinate ? Math.sqrt(squares / n) : Double.NaN));
            }
        }
        return new ValidationResult(outcomes.size(), notConverged, refused, ambiguous, falseAlarms, noiseMisfits,
                referenceMisfits, weightShare, regions, quantities);
    }

    /** As many bins as leave enough ranks in each. */
    private static int bins(int ranks) {
        for (int bins : BINS) {
            if (ranks >= RANKS_PER_BIN * bins) {
                return bins;
            }
        }
        return BINS[BINS.length - 1];
    }
}
