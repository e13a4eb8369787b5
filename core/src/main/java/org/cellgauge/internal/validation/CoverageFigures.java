package org.cellgauge.internal.validation;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.ToDoubleFunction;
import org.cellgauge.check.Verdict;
import org.cellgauge.internal.statistics.BinomialBand;
import org.cellgauge.internal.statistics.CoverageRegion;

/** What a {@link CoverageStudy} found; immutable. */
public final class CoverageFigures {
    /** Probability with which the count of one honest region lies in its band. */
    public static final double CONFIDENCE = 0.99;
    private static final double OUTLYING = 0.999;

    private final int simulations;
    private final Map<Verdict, Integer> verdicts;
    private final Map<String, Integer> refusals;
    private final Map<String, Integer> warnings;
    private final int falseAlarms;
    private final int noiseMisfits;
    private final int referenceMisfits;
    private final int alarmed;
    private final int markers;
    private final int markersFound;
    private final int photosWithMarkersMissing;
    private final List<Region> regions;
    private final Map<String, Mean> biasZMm;
    private final Corners corners;

    private CoverageFigures(List<CoverageStudy.Outcome> outcomes) {
        simulations = outcomes.size();
        Map<Verdict, Integer> verdictCounts = new TreeMap<>();
        Map<String, Integer> refusalCounts = new TreeMap<>();
        Map<String, Integer> warningCounts = new TreeMap<>();
        Map<String, Region> byName = new LinkedHashMap<>();
        Map<String, List<Double>> errorsZ = new LinkedHashMap<>();
        List<CoverageStudy.CornerStanding> allCorners = new ArrayList<>();
        int accusing = 0;
        int ofNoise = 0;
        int ofReferences = 0;
        int any = 0;
        int all = 0;
        int found = 0;
        int incomplete = 0;
        for (CoverageStudy.Outcome outcome : outcomes) {
            if (outcome.refusal != null) {
                refusalCounts.merge(outcome.refusal, 1, Integer::sum);
            } else if (outcome.verdict != null) {
                verdictCounts.merge(outcome.verdict, 1, Integer::sum);
            }
            outcome.warnings.forEach(w -> warningCounts.merge(w, 1, Integer::sum));
            accusing += outcome.accuses ? 1 : 0;
            ofNoise += outcome.noiseMisfit ? 1 : 0;
            ofReferences += outcome.referencesMisfit ? 1 : 0;
            any += outcome.accuses || outcome.noiseMisfit || outcome.referencesMisfit ? 1 : 0;
            all += outcome.markers;
            found += outcome.markersFound;
            incomplete += outcome.markersFound < outcome.markers ? 1 : 0;
            allCorners.addAll(outcome.corners);
            for (CoverageStudy.Standing s : outcome.standings) {
                for (int k = 0; k < s.regions.size(); k++) {
                    int dimension = s.dimensions.get(k);
                    String region = s.regions.get(k);
                    byName.computeIfAbsent(s.name + " " + region, name -> new Region(s.name, region, dimension))
                            .add(s.shares.get(k), s.squared.get(k), s.severalModes);
                }
                errorsZ.computeIfAbsent(s.name, name -> new ArrayList<>()).add(s.errorZMm);
            }
        }
        verdicts = Collections.unmodifiableMap(verdictCounts);
        refusals = Collections.unmodifiableMap(refusalCounts);
        warnings = Collections.unmodifiableMap(warningCounts);
        falseAlarms = accusing;
        noiseMisfits = ofNoise;
        referenceMisfits = ofReferences;
        alarmed = any;
        markers = all;
        markersFound = found;
        photosWithMarkersMissing = incomplete;
        regions = Collections.unmodifiableList(new ArrayList<>(byName.values()));
        Map<String, Mean> bias = new LinkedHashMap<>();
        errorsZ.forEach((name, values) -> bias.put(name, Mean.of(values, v -> v)));
        biasZMm = Collections.unmodifiableMap(bias);
        corners = new Corners(allCorners);
    }

    static CoverageFigures of(List<CoverageStudy.Outcome> outcomes) {
        return new CoverageFigures(outcomes);
    }

    /** A mean with its standard error; immutable. */
    public static final class Mean {
        private final int count;
        private final double value;
        private final double standardError;

        private Mean(int count, double value, double standardError) {
            this.count = count;
            this.value = value;
            this.standardError = standardError;
        }

        static <T> Mean of(List<T> items, ToDoubleFunction<T> of) {
            int n = 0;
            double mean = 0;
            double squares = 0;
            for (T item : items) {
                double v = of.applyAsDouble(item);
                if (!Double.isNaN(v)) {
                    n++;
                    double d = v - mean;
                    mean += d / n;
                    squares += d * (v - mean);
                }
            }
            return new Mean(n, n == 0 ? Double.NaN : mean, n < 2 ? Double.NaN : Math.sqrt(squares / (n - 1.0) / n));
        }

        /**
         * How many values it is of.
         *
         * @return not negative
         */
        public int count() {
            return count;
        }

        /**
         * The mean.
         *
         * @return NaN of no values
         */
        public double value() {
            return value;
        }

        /**
         * Its standard error, from the scatter of the values.
         *
         * @return NaN of fewer than two values
         */
        public double standardError() {
            return standardError;
        }
    }

    /** How one kind of stated region held the truth. */
    public static final class Region {
        private final String part;
        private final String name;
        private final int dimension;
        private final List<Double> squared = new ArrayList<>();
        private int held;
        private int severalModes;
        private int heldOfSeveralModes;

        private Region(String part, String name, int dimension) {
            this.part = part;
            this.name = name;
            this.dimension = dimension;
        }

        private void add(double share, double squaredDistance, boolean ofSeveralModes) {
            boolean holds = share <= CoverageStudy.PROBABILITY;
            held += holds ? 1 : 0;
            severalModes += ofSeveralModes ? 1 : 0;
            heldOfSeveralModes += ofSeveralModes && holds ? 1 : 0;
            // between two modes there is no mean to be away from, and one truth in the lesser decides over hundreds
            squared.add(ofSeveralModes ? Double.NaN : squaredDistance);
        }

        /**
         * What it is of.
         *
         * @return {@code camera} or what the source calls the object
         */
        public String part() {
            return part;
        }

        /**
         * Which of its quantities.
         *
         * @return {@code position}, {@code pose} or {@code grip}
         */
        public String name() {
            return name;
        }

        /**
         * Number of coordinates.
         *
         * @return 3 (mm) or 6 (position in mm, rotation vector in rad, world axes)
         */
        public int dimension() {
            return dimension;
        }

        /**
         * Number of regions that were stated.
         *
         * @return at least 1
         */
        public int trials() {
            return squared.size();
        }

        /**
         * How many 95 % regions held the truth.
         *
         * @return count
         */
        public int held() {
            return held;
        }

        /**
         * Regions over more than one mode of camera or object.
         *
         * @return count, among {@link #trials()}
         */
        public int severalModes() {
            return severalModes;
        }

        /**
         * How many of these held the truth.
         *
         * @return count, among {@link #held()}
         */
        public int heldOfSeveralModes() {
            return heldOfSeveralModes;
        }

        /**
         * Counts that an honest 95 % gives with probability {@value CoverageFigures#CONFIDENCE}.
         *
         * @return the band
         */
        public BinomialBand band() {
            return BinomialBand.of(trials(), CoverageStudy.PROBABILITY, CONFIDENCE);
        }

        /**
         * Mean squared distance of the truth (NEES), of regions about one mode: it is the photo that tells of how many,
         * so an honest mean is the dimension among them, too.
         *
         * @return honest: {@link #dimension()}
         */
        public Mean squaredDistance() {
            return Mean.of(squared, v -> v);
        }
    }

    /** How detected corners stand to the true ones, over all markers found in all photos; immutable. */
    public static final class Corners {
        private final int markers;
        private final double rmsPx;
        private final Mean outwardPx;
        private final Mean outwardInStds;
        private final Mean squaredStated;
        private final Mean squaredAsTaken;
        private final double outlying;

        private Corners(List<CoverageStudy.CornerStanding> all) {
            markers = all.size();
            rmsPx = Math.sqrt(Mean.of(all, c -> c.squaredPx2 / 8).value());
            outwardPx = Mean.of(all, c -> c.outwardPx);
            outwardInStds = Mean.of(all, c -> c.outwardPx / Math.sqrt(c.outwardVariancePx2));
            squaredStated = Mean.of(all, c -> c.squaredStated / 8);
            squaredAsTaken = Mean.of(all, c -> c.squaredAsTaken / 8);
            double limit = CoverageRegion.chiSquareQuantile(OUTLYING, 8);
            outlying = Mean.of(all, c -> Double.isNaN(c.squaredStated) ? Double.NaN : c.squaredStated > limit ? 1 : 0)
                    .value();
        }

        /**
         * Number of markers.
         *
         * @return not negative
         */
        public int markers() {
            return markers;
        }

        /**
         * Root mean square of the errors of all coordinates.
         *
         * @return px
         */
        public double rmsPx() {
            return rmsPx;
        }

        /**
         * Mean of what the sides of a marker have moved outwards.
         *
         * @return px, negative where markers look smaller than they are
         */
        public Mean outwardPx() {
            return outwardPx;
        }

        /**
         * The same in stated deviations, marker by marker.
         *
         * @return NaN where no covariance is stated
         */
        public Mean outwardInStds() {
            return outwardInStds;
        }

        /**
         * Mean of e' S^-1 e / 8, S the stated covariance of the marker's corners.
         *
         * @return honest: 1; NaN where no covariance is stated
         */
        public Mean squaredStated() {
            return squaredStated;
        }

        /**
         * The same of corners and covariance as a check takes them: corrected for the shift that inner edges show, with
         * what is left open of it in the covariance.
         *
         * @return NaN where none is stated
         */
        public Mean squaredAsTaken() {
            return squaredAsTaken;
        }

        /**
         * Share of the markers whose e' S^-1 e lies beyond the 99.9 % quantile of chi-square.
         *
         * @return honest: 0.001; NaN where no covariance is stated
         */
        public double outlyingShare() {
            return outlying;
        }
    }

    /**
     * Number of simulated cells.
     *
     * @return at least 1
     */
    public int simulations() {
        return simulations;
    }

    /**
     * How often each verdict was given.
     *
     * @return unmodifiable, verdicts that were given
     */
    public Map<Verdict, Integer> verdicts() {
        return verdicts;
    }

    /**
     * How often one verdict was given.
     *
     * @param verdict which
     * @return count
     */
    public int count(Verdict verdict) {
        return verdicts.getOrDefault(verdict, 0);
    }

    /**
     * Why photos were refused, numbers as #.
     *
     * @return unmodifiable, photos by reason
     */
    public Map<String, Integer> refusals() {
        return refusals;
    }

    /**
     * Photos that were refused.
     *
     * @return count
     */
    public int refused() {
        int sum = 0;
        for (int count : refusals.values()) {
            sum += count;
        }
        return sum;
    }

    /**
     * Photos by kind of warning.
     *
     * @return unmodifiable, by the kind's name in lower case
     */
    public Map<String, Integer> warnings() {
        return warnings;
    }

    /**
     * Photos that accuse a reference of being misplaced, leave one out or name a cause, although all is as stated.
     *
     * @return count
     */
    public int falseAlarms() {
        return falseAlarms;
    }

    /**
     * Photos whose corners do not fit the stated noise, be it because of one marker or of all
     * ({@link org.cellgauge.placement.NoiseFit}).
     *
     * @return count; honest: at most 2 in 1000 where a noise is stated, none where it is not
     */
    public int noiseMisfits() {
        return noiseMisfits;
    }

    /**
     * Photos whose references together do not fit as stated, but for those that are accused.
     *
     * @return count; honest: at most 1 in 1000
     */
    public int referenceMisfits() {
        return referenceMisfits;
    }

    /**
     * Photos with an alarm of any kind: a reference accused or left out, corners that do not fit the stated noise,
     * references that together do not fit.
     *
     * @return count; honest: at most 1 in 100
     */
    public int alarmed() {
        return alarmed;
    }

    /**
     * Markers of all cells together.
     *
     * @return count
     */
    public int markers() {
        return markers;
    }

    /**
     * Those of them that were found.
     *
     * @return count
     */
    public int markersFound() {
        return markersFound;
    }

    /**
     * Photos in which a marker of the cell was not found.
     *
     * @return count
     */
    public int photosWithMarkersMissing() {
        return photosWithMarkersMissing;
    }

    /**
     * Regions of the camera, then of the objects.
     *
     * @return unmodifiable; empty if no check stated any
     */
    public List<Region> regions() {
        return regions;
    }

    /**
     * Stated mean minus truth in world z.
     *
     * @return unmodifiable, mm, by part
     */
    public Map<String, Mean> biasZMm() {
        return biasZMm;
    }

    /**
     * The corners.
     *
     * @return their figures
     */
    public Corners corners() {
        return corners;
    }
}
