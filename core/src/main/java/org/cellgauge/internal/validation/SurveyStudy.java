package org.cellgauge.internal.validation;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CellEstimate;
import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.estimate.PointEstimate;
import org.cellgauge.estimate.PoseEstimate;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.Rotations;
import org.cellgauge.internal.sampling.OwnThreads;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.internal.statistics.CoverageRegion;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.survey.Survey;
import org.cellgauge.survey.SurveyResult;
import org.cellgauge.survey.SurveyWarning;
import org.cellgauge.survey.SurveyedObject;
import org.cellgauge.survey.SurveyedReference;
import org.cellgauge.vision.Detections;
import org.jspecify.annotations.Nullable;

/**
 * Are stated regions of surveys right? Cells built anew, each surveyed from several photos: how often 95 % regions of
 * objects, gripping points and references hold the truth, and those of objects in a later photo that is checked with
 * the surveyed cell.
 */
public final class SurveyStudy {
    private static final double PROBABILITY = 0.95;
    private static final int POSE = 6;
    private static final int POINT = 3;
    private static final long STREAM_LATER = 22;

    /** What regions are of. */
    public enum Part {
        /** Poses of objects. */
        OBJECTS("objects", POSE),
        /** Gripping points. */
        GRIPS("gripping points", POINT),
        /** Poses of references. */
        REFERENCES("references", POSE),
        /** Positions of objects in a later photo: one photo alone may leave an object two turns. */
        LATER_OBJECTS("positions in a later photo", POINT);

        private final String words;
        private final int dimension;

        Part(String words, int dimension) {
            this.words = words;
            this.dimension = dimension;
        }

        @Override
        public String toString() {
            return words;
        }
    }

    /**
     * Figures of one part.
     *
     * @param part what regions are of
     * @param regions how many there are
     * @param held how many hold the truth
     * @param meanSquare mean of the squared error in units of what is stated (NEES), which should be {@code dimension}
     * @param dimension 6 of poses, 3 of points
     */
    public record Figures(Part part, int regions, int held, double meanSquare, int dimension) {
    }

    /**
     * Figures of a study.
     *
     * @param figures by part; parts without regions are left out
     * @param cells cells surveyed
     * @param refused surveys and later checks that gave no figures
     * @param falseAlarms surveys in which a reference was called misplaced, or a photo called one that does not fit
     */
    public record Result(List<Figures> figures, int cells, int refused, int falseAlarms) {
    }

    private SurveyStudy() {
    }

    /**
     * Runs a study with corners drawn.
     *
     * @param cell the cell, built anew each time as precisely as it says
     * @param settings how it is surveyed
     * @param photos number of photos of each cell
     * @param cells number of cells
     * @param seed seed of all that is drawn
     * @param threads cells at once; figures do not depend on it
     * @param sampled whether regions are of draws; else of Laplace's approximation
     * @return the figures
     */
    public static Result of(Cell cell, CheckSettings settings, int photos, int cells, long seed, int threads,
            boolean sampled) {
        return of(cell, settings, photos, cells, seed, threads, sampled, null);
    }

    /**
     * Runs a study.
     *
     * @param cell the cell, built anew each time as precisely as it says
     * @param settings how it is surveyed
     * @param photos number of photos of each cell
     * @param cells number of cells
     * @param seed seed of all that is drawn
     * @param threads cells at once; figures do not depend on it
     * @param sampled whether regions are of draws; else of Laplace's approximation
     * @param source what photos are seen by, called by several threads at once; null where corners are drawn
     * @return the figures
     */
    public static Result of(Cell cell, CheckSettings settings, int photos, int cells, long seed, int threads,
            boolean sampled, @Nullable DetectionSource source) {
        Tally[] tallies = new Tally[cells];
        OwnThreads.forEach(cells, threads, c -> tallies[c] = one(cell, settings, photos, seed, c, sampled, source));
        Tally sum = new Tally();
        for (Tally t : tallies) {
            sum.add(t);
        }
        return sum.result(cells);
    }

    private static Tally one(Cell cell, CheckSettings settings, int photos, long seed, int index, boolean sampled,
            @Nullable DetectionSource source) {
        Tally tally = new Tally();
        SimulatedSurvey drawn = SimulatedSurvey.of(cell, settings, photos, seed, index);
        SimulatedSurvey truth = source == null ? drawn : drawn.seenBy(source, seed, index);
        try {
            Survey survey = Survey.of(cell, truth.photos(), settings);
            SurveyResult result = sampled ? survey.sampled() : survey.estimate();
            for (SurveyedObject o : result.objects()) {
                RigidTransform pose = pose(truth.objects().get(o.marker().id()));
                tally.pose(Part.OBJECTS, pose, o.pose());
                tally.grip(pose, o.marker().gripMm(), o.grip());
            }
            for (SurveyedReference r : result.references()) {
                tally.pose(Part.REFERENCES, pose(truth.references().get(r.stated().id())), r.pose());
            }
            tally.falseAlarms += result.references().stream().anyMatch(SurveyedReference::misplaced)
                    || result.warnings().stream().anyMatch(w -> w.kind() == SurveyWarning.PHOTO_DOES_NOT_FIT) ? 1 : 0;
            RandomGenerator random = RandomStreams.of(seed, STREAM_LATER, index);
            Detections photo = source == null ? truth.later(random) : truth.later(source, random);
            CellEstimate later = CellCheck.quickLook(result.surveyedCell(), photo, settings, null).update().estimate();
            for (ObjectEstimate o : later.objects()) {
                tally.position(pose(truth.objects().get(o.id())), o.pose());
            }
        } catch (InputRefusedException e) {
            tally.refused++;
        }
        return tally;
    }

    private static RigidTransform pose(@Nullable RigidTransform pose) {
        if (pose == null) {
            throw new IllegalStateException("every marker has a true pose");
        }
        return pose;
    }

    /** Of regions of one kind: how many, how many hold the truth, and the squared distances of the truth. */
    private static final class Count {
        private int regions;
        private int held;
        private double squares;
    }

    /** Counts of regions. */
    private static final class Tally {
        private final Map<Part, Count> counts = new LinkedHashMap<>();
        private int refused;
        private int falseAlarms;

        void pose(Part part, RigidTransform truth, PoseEstimate stated) {
            double[] error = new double[POSE];
            double[] t = truth.translationMm();
            double[] s = stated.meanTransform().translationMm();
            double[] r = new double[9];
            Rotations.multiplyTransposed(truth.rotation(), stated.meanTransform().rotation(), r);
            Rotations.log(r, error, 3);
            for (int i = 0; i < 3; i++) {
                error[i] = t[i] - s[i];
            }
            add(part, error, stated.tangentCovariance());
        }

        void position(RigidTransform truth, PoseEstimate stated) {
            double[] error = truth.translationMm();
            for (int i = 0; i < POINT; i++) {
                error[i] -= stated.meanTransform().translationMm()[i];
            }
            add(Part.LATER_OBJECTS, error, stated.positionCovarianceMm2());
        }

        void grip(RigidTransform truth, double @Nullable [] gripMm,
                @Nullable PointEstimate stated) {
            if (gripMm == null || stated == null) {
                return;
            }
            double[] error = truth.apply(gripMm);
            for (int i = 0; i < POINT; i++) {
                error[i] -= stated.meanMm()[i];
            }
            add(Part.GRIPS, error, stated.covarianceMm2());
        }

        private void add(Part part, double[] error, double[][] covariance) {
            CoverageRegion region = CoverageRegion.of(new double[error.length], covariance, PROBABILITY);
            Count count = counts.computeIfAbsent(part, p -> new Count());
            count.regions++;
            count.held += region.contains(error) ? 1 : 0;
            count.squares += region.mahalanobisSquared(error);
        }

        void add(Tally other) {
            other.counts.forEach((part, more) -> {
                Count count = counts.computeIfAbsent(part, p -> new Count());
                count.regions += more.regions;
                count.held += more.held;
                count.squares += more.squares;
            });
            refused += other.refused;
            falseAlarms += other.falseAlarms;
        }

        Result result(int cells) {
            List<Figures> out = new ArrayList<>();
            for (Part part : Part.values()) {
                Count count = counts.get(part);
                if (count != null) {
                    out.add(new Figures(part, count.regions, count.held, count.squares / count.regions,
                            part.dimension));
                }
            }
            return new Result(List.copyOf(out), cells, refused, falseAlarms);
        }
    }
}
