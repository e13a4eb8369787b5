package org.cellgauge.internal.validation;

import java.util.List;
import java.util.Map;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.internal.sampling.OwnThreads;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.survey.Drift;
import org.cellgauge.survey.Epoch;
import org.cellgauge.survey.Survey;

/**
 * Is what a survey says of movement right? Cells built anew, each surveyed twice, with nothing moved in between or one
 * reference: how often anything that stands is called moved, and how often the one that moved is named.
 */
public final class DriftStudy {
    private static final long STREAM_DIRECTION = 24;
    private static final int FREEDOM = 6;

    /**
     * Figures of a study.
     *
     * @param pairs pairs of surveys compared
     * @param refused pairs that gave no figure
     * @param falseAlarms pairs in which something was called moved that had not, by all photos or by a single one
     * @param named pairs in which what had moved was called so
     * @param meanChiSquare of the bodies that stood, by all photos together; six where what is stated is right
     * @param meanPhotoChiSquare the same by single photos
     */
    public record Result(int pairs, int refused, int falseAlarms, int named, double meanChiSquare,
            double meanPhotoChiSquare) {
    }

    private DriftStudy() {
    }

    /**
     * Runs a study. Every other pair is of a camera that stands.
     *
     * @param cell the cell, built anew each time as precisely as it says
     * @param settings how it is surveyed
     * @param photos number of photos of each survey
     * @param pairs number of cells
     * @param movedMm how far one reference is moved, in any direction; 0 for none
     * @param seed seed of all that is drawn
     * @param threads cells at once; figures do not depend on it
     * @return the figures
     */
    public static Result of(Cell cell, CheckSettings settings, int photos, int pairs, double movedMm, long seed,
            int threads) {
        double[][] tallies = new double[pairs][];
        OwnThreads.forEach(pairs, threads, p -> tallies[p] = one(cell, settings, photos, movedMm, seed, p));
        double[] sum = new double[7];
        for (double[] t : tallies) {
            for (int i = 0; i < sum.length; i++) {
                sum[i] += t[i];
            }
        }
        return new Result(pairs, (int) sum[0], (int) sum[1], (int) sum[2], sum[3] / sum[4], sum[5] / sum[6]);
    }

    /** Refused, false alarm, named, then chi-square and number of bodies by all photos and by single ones. */
    private static double[] one(Cell cell, CheckSettings settings, int photos, double movedMm, long seed, int index) {
        double[] tally = new double[7];
        SimulatedSurvey truth = SimulatedSurvey.of(cell, settings, photos, seed, index);
        RandomGenerator random = RandomStreams.of(seed, STREAM_DIRECTION, index);
        int moved = cell.references().get(random.nextInt(cell.references().size())).id();
        double[] shift = direction(random, movedMm);
        boolean stands = index % 2 == 0;
        SimulatedSurvey later = truth.again(photos, random.nextLong(), stands,
                movedMm > 0 ? Map.of(moved, shift) : Map.of(), new double[3]);
        Drift drift;
        try {
            Epoch before = Survey.of(cell, truth.photos(), settings).estimate().epoch();
            drift = Survey.of(cell, later.photos(), settings).against(before, stands);
        } catch (InputRefusedException e) {
            tally[0] = 1;
            return tally;
        }
        add(drift.bodies(), movedMm > 0 ? moved : 0, tally, 3);
        for (Drift.OfPhoto p : drift.photos()) {
            add(p.bodies(), movedMm > 0 ? moved : 0, tally, 5);
        }
        return tally;
    }

    private static void add(List<Drift.Displacement> bodies, int movedId, double[] tally, int at) {
        for (Drift.Displacement d : bodies) {
            boolean camera = d.body().kind() == Epoch.Kind.CAMERA;
            if (movedId != 0 && !camera && d.body().id() == movedId) {
                tally[2] = d.moved() ? 1 : tally[2];
                continue;
            }
            tally[1] = d.moved() ? 1 : tally[1];
            // that of the camera by all photos is the largest of several
            if (!(camera && at == 3)) {
                tally[at] += d.chiSquare();
                tally[at + 1]++;
            }
        }
    }

    private static double[] direction(RandomGenerator random, double length) {
        double[] d = {random.nextGaussian(), random.nextGaussian(), random.nextGaussian()};
        double norm = Math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        return new double[] {length * d[0] / norm, length * d[1] / norm, length * d[2] / norm};
    }

    /**
     * What the mean of a chi-square should be.
     *
     * @return its degrees of freedom
     */
    public static int freedom() {
        return FREEDOM;
    }
}
